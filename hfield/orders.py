"""Orders over ℤ in quaternion algebras over ℚ, with quaternions as elements."""

from __future__ import annotations

from typing import Any

from hfield.errors import CoercionError
from hfield.quaternion import Parent, Quaternion
from hfield.structure import hurwitz, orders


class Order:
    """The integer combinations of ``basis``, a subring: ``q in O`` asks for membership."""

    def __init__(self, algebra: Parent, found: orders.Order) -> None:
        self.algebra, self._found = algebra, found
        self.basis: tuple[Quaternion, ...] = tuple(algebra(*q) for q in found.basis)

    def __contains__(self, q: Any) -> bool:
        return self.algebra(q).coordinates in self._found

    def coordinates(self, q: Any) -> tuple[Any, ...]:
        """Return the rational coordinates of q with respect to the basis."""
        F = self.algebra.ring
        return tuple(F(x) for x in self._found.coordinates(self.algebra(q).coordinates))

    def discriminant(self) -> int:
        """Return the reduced discriminant; for a maximal order it is that of the algebra."""
        return self._found.discriminant

    def is_maximal(self) -> bool:
        """Tell whether no larger order contains this one: whether its discriminant is that small."""
        return self.discriminant() == orders.maximal_order(self.algebra.constants).discriminant

    def units(self) -> tuple[Quaternion, ...]:
        """Return all units of an order in a definite algebra.

        Raises :class:`NotFiniteError` for an indefinite algebra, whose orders have infinitely many.
        """
        return tuple(self.algebra(*q) for q in self._found.units())

    def __eq__(self, other: object) -> bool:
        """Tell whether both are the same lattice in the same algebra."""
        return (
            isinstance(other, Order)
            and self.algebra == other.algebra
            and all(q in other for q in self.basis)
            and all(q in self for q in other.basis)
        )

    def __hash__(self) -> int:
        return hash((self.algebra, self.discriminant()))

    def __repr__(self) -> str:
        return f"ℤ⟨{', '.join(map(str, self.basis))}⟩ in {self.algebra}"


class HurwitzOrder(Order):
    """The Hurwitz order of (−1,−1|ℚ), in which one divides with remainder, on both sides."""

    def quo_rem(self, a: Any, b: Any, side: str = "right") -> tuple[Quaternion, Quaternion]:
        """Return ``(q, r)`` with ``a = q·b + r`` (``side="left"``: ``a = b·q + r``), N(r) ≤ N(b)/2.

        Raises :class:`CoercionError` for an element outside the order or another side, and
        :class:`NotInvertibleError` for b = 0.
        """
        self._check_side(side)
        q, r = hurwitz.divide(self._coordinates(a), self._coordinates(b), side)
        return self.algebra(*q), self.algebra(*r)

    def gcd(self, a: Any, b: Any, side: str = "right") -> Quaternion:
        """Return a greatest common right (left) divisor of a and b, unique up to a unit.

        Raises as :meth:`quo_rem` does.
        """
        self._check_side(side)
        return self.algebra(*hurwitz.gcd(self._coordinates(a), self._coordinates(b), side))

    def _coordinates(self, q: Any) -> Any:
        return self.algebra(q).coordinates

    @staticmethod
    def _check_side(side: str) -> None:
        if side not in ("left", "right"):
            raise CoercionError(f"the side {side!r} does not exist: expected 'left' or 'right'")
