"""One-sided ideals of orders: what they are, their arithmetic, and when two are equivalent."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from flint import fmpz_mat

from hfield.errors import LatticeError, shorten
from hfield.lattices import compatible, hermite
from hfield.lattices.answers import Answer, rows_json
from hfield.lattices.lattice import Lattice, element_row, listed
from hfield.lattices.order import Order
from hfield.lattices.order import prime as checked_prime
from hfield.quaternion import Parent, Quaternion

if TYPE_CHECKING:
    import flint

    from hfield.lattices.certified import Claim

OTHER = {"left": "right", "right": "left", "two-sided": "two-sided"}


class Ideal(Lattice):
    """A lattice with ``O·I = I`` for the order O (``side="left"``), or ``I·O = I``, or both.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    >>> I = O.left_ideal([3, "1 + j"])
    >>> I.norm(), I.left_order() == O
    (3, True)
    >>> I * I.inverse() == O
    True
    """

    def __init__(
        self,
        algebra: Parent,
        den: int,
        matrix: flint.fmpz_mat,
        side: str = "left",
        order: Order | None = None,
    ) -> None:
        super().__init__(algebra, den, matrix)
        self.side = side
        self._order = order

    @classmethod
    def generated(cls, order: Order, generators: Iterable[object], side: str) -> Ideal:
        """Return the ideal of an order that elements generate on a side.

        Raises :class:`LatticeError` when its rank is below 4.
        """
        given = listed(generators)
        vectors = [element_row(order.algebra, x) for x in given]
        if not vectors:
            raise LatticeError("an ideal has at least one generator, and none was given")
        den = math.lcm(*(d for d, _ in vectors))
        r = order._regular
        rows = fmpz_mat([[x * (den // d) for x in row] for d, row in vectors])
        scale = r.scale * order._den * den
        factors = (order._matrix, rows) if side == "left" else (rows, order._matrix)
        products = r.products(*factors)
        if side == "two-sided":
            d, products = hermite.span(scale, products)
            products = r.products(order._matrix, products)
            scale = d * order._den * r.scale
        found = hermite.hermite(scale, products)
        if found is None:
            shown = ", ".join(shorten(x, 30) for x in given[:4])
            raise LatticeError(
                f"the {side} ideal of {shown} has a rank below 4: all its generators have norm 0 on one "
                "line, or are 0"
            )
        return cls(order.algebra, *found, side, order)

    @classmethod
    def of(cls, lattice: Lattice, side: str, order: Order | None = None) -> Ideal:
        """Return a lattice as an ideal of its left or right order, which may be known."""
        return cls(lattice.algebra, lattice._den, lattice._matrix, side, order)

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, (self.algebra, *self.hnf, self.side, self._order)

    @classmethod
    def like(cls, lattice: Lattice, order: Order, side: str) -> Ideal:
        """Return a lattice as an ideal of an order. Raises :class:`LatticeError` where it is none."""
        products = lattice._product(order) if side == "right" else order._product(lattice)
        if products != lattice:
            raise LatticeError(f"{shorten(lattice)} is no {side} ideal of {shorten(order)}")
        return cls.of(lattice, side, order)

    # --- its orders ------------------------------------------------------------------------------

    @property
    def order(self) -> Order:
        """The order of which this is an ideal."""
        if self._order is None:
            self._order = self.colon_order(self.side)
        return self._order

    def colon_order(self, side: str) -> Order:
        """Return the left or the right order, as for any lattice."""
        return self._order_of("right" if side == "right" else "left")

    def left_order(self) -> Order:
        """Return ``{x : x·I ⊆ I}``; for an invertible left ideal it is :attr:`order`."""
        return self._known_order("left")

    def right_order(self) -> Order:
        """Return ``{x : I·x ⊆ I}``; for an invertible right ideal it is :attr:`order`."""
        return self._known_order("right")

    def _known_order(self, side: str) -> Order:
        known = self.side in (side, "two-sided") and self.is_invertible()
        return self.order if known else self._order_of(side)

    def is_invertible(self) -> bool:
        """Tell whether the ideal is locally principal."""
        return self._invertible

    @cached_property
    def _invertible(self) -> bool:
        return self.order._fits(self)

    def is_integral(self) -> bool:
        """Tell whether the ideal lies in its order."""
        return self._integral

    @cached_property
    def _integral(self) -> bool:
        return self <= self.order

    def is_two_sided(self) -> bool:
        """Tell whether the left and the right order are the same."""
        return self.side == "two-sided" or self.left_order() == self.right_order()

    # --- arithmetic ------------------------------------------------------------------------------

    def _product(self, other: Lattice) -> Lattice:
        if isinstance(other, Ideal) and (self.side, other.side) == ("right", "left"):
            order = self.order
            if order is other.order or order == other.order:
                found = compatible.product(self, other)
                if found is not None:
                    return Lattice(self.algebra, *found)
        return super()._product(other)

    def conjugate(self) -> Ideal:
        """Return the ideal of the conjugates, on the other side."""
        return Ideal.of(super().conjugate(), OTHER[self.side], self._order)

    def inverse(self) -> Ideal:
        """Return ``conj(I)/N(I)``. Raises :class:`LatticeError` unless I is locally principal."""
        if not self.is_invertible():
            raise LatticeError(f"{shorten(self)} is not invertible: it is not locally principal")
        return self.conjugate()._scaled(1 / self._norm)

    def _scaled(self, x: Fraction) -> Ideal:
        return Ideal.of(super()._scaled(x), self.side, self._order)

    def __mul__(self, other: object) -> Lattice:
        found = super().__mul__(other)
        if isinstance(other, Ideal) and self.side == "right" and other.side == "right":
            return Ideal.of(found, "right", other._order)
        if self.side == "right" and not _is_number(other):
            return Ideal.of(found, "right")
        return Ideal.of(found, "left" if self.side != "right" else "right", self._order)

    def __rmul__(self, other: object) -> Lattice:
        found = super().__rmul__(other)
        known = self._order if self.side == "right" or _is_number(other) else None
        return Ideal.of(found, "right" if self.side == "right" else "left", known)

    def primitive_part(self) -> tuple[Ideal, int]:
        """Return (J, m) with I = m·J and m the largest integer for which J is integral.

        Raises :class:`LatticeError` unless the ideal is integral.
        """
        order = self.order
        rows, d = hermite.in_coordinates(order._matrix, self._matrix)
        content = math.gcd(*(int(x) for x in rows.entries()))
        m = Fraction(content * order._den, d * self._den)
        if m.denominator != 1:
            raise LatticeError("only an integral ideal has a primitive part, and this one is none")
        return self._scaled(1 / m), m.numerator

    def pushforward(self, other: Ideal) -> Ideal:
        """Return ``I⁻¹·(I ∩ J)`` for J = other: a left ideal of the right order of I, of norm N(J).

        Both are left ideals of one order, of coprime norms, else :class:`LatticeError` (Leroux, 2022).
        """
        self._joint(other)
        self._coprime(other)
        found = self.inverse()._product(self & other)
        return Ideal.of(found, "left", self.right_order())

    def pullback(self, other: Ideal) -> Ideal:
        """Return ``I·J + N(J)·O``, for J a left ideal of the right order of I: what I pushes forward to J."""
        if self.side == "right" or other.side == "right" or other.order != self.right_order():
            raise LatticeError(
                "the pullback along a left ideal I is asked of a left ideal of the right order of I"
            )
        self._coprime(other)
        order = self.order
        found = self._product(other) + Lattice.__mul__(order, other.norm())
        return Ideal.of(found, "left", order)

    def _coprime(self, other: Ideal) -> None:
        n, m = self._norm, other._norm
        if n.denominator != 1 or m.denominator != 1 or math.gcd(n.numerator, m.numerator) != 1:
            raise LatticeError(f"the norms {n} and {m} are not coprime integers")

    def _joint(self, other: object) -> Ideal:
        """Return ``other`` if it is an ideal on the same side of the same order."""
        if isinstance(other, Lattice) and not isinstance(other, Ideal):
            other = Ideal.like(self._same(other, "compare"), self.order, self.side)
        if not isinstance(other, Ideal):
            raise LatticeError(f"{shorten(repr(other))} is not an ideal")
        self._same(other, "compare")
        if "left" in (self.side, other.side) and "right" in (self.side, other.side):
            raise LatticeError(
                "one is a left ideal and the other a right ideal; conjugate one first"
            )
        if other.order != self.order:
            raise LatticeError(
                "these are ideals of different orders: two ideals are compared over one order"
            )
        return other

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate ``hfield-cert/1`` as JSON data, one that the checker accepts, or None.

        There is none for an ideal that is not invertible; ``claim.why_no_certificate`` tells.
        """
        return self.claim.certificate

    @cached_property
    def claim(self) -> Claim:
        """What there is to certify, as a statement with its evidence."""
        from hfield.lattices import certified

        return certified.of_ideal(self)

    @property
    def evidence(self) -> dict[str, object]:
        """What a program needs to check the ideal: its rows, those of its order, and its norm."""
        return {
            "kind": "ideal",
            "algebra": str(self.algebra),
            "side": self.side,
            **rows_json(self),
            "order": rows_json(self.order),
            "norm": str(self._norm),
        }

    # --- classes ---------------------------------------------------------------------------------

    def equivalence(self, other: Ideal) -> Answer:
        """Return an answer with ``element`` c such that J = I·c for left ideals, J = c·I for right ones.

        Where there is none it is false, and ``reason`` says what was exhausted. In an indefinite
        algebra a theorem may decide, and the element be missing. Raises :class:`LatticeError` for an
        ideal of another order, and :class:`UndecidedError`.
        """
        from hfield.lattices.equivalence import equivalence

        return equivalence(self, self._joint(other))

    def is_equivalent(self, other: Ideal) -> bool:
        """Tell whether ``J = I·c`` (or ``c·I``) for some c. Raises as :meth:`equivalence` does."""
        return bool(self.equivalence(other))

    def is_principal(self) -> Answer:
        """Return an answer with a generator as ``element``: I = O·c for a left ideal, c·O for a right one."""
        from hfield.lattices.equivalence import equivalence

        order = self.order
        return equivalence(Ideal(order.algebra, order._den, order._matrix, self.side, order), self)

    def equivalent_of_prime_norm(self, avoid: Iterable[int] = ()) -> tuple[Ideal, Quaternion]:
        """Return (J, c) with J equivalent to I of the least prime norm that is not in ``avoid``.

        J = I·c for a left ideal, c·I for a right one, with c = conj(x)/N(I) for a short x in I
        (Kohel, Lauter, Petit and Tignol, 2014).
        """
        from hfield.lattices.small import equivalent_of_prime_norm

        return equivalent_of_prime_norm(self, frozenset(avoid))

    def equivalent_of_power_norm(self, prime: int, seed: int = 0) -> tuple[Ideal, Quaternion, int]:
        """Return (J, c, e), J = I·c of norm primeᵉ, for a left ideal of a p-extremal order: KLPT.

        Raises :class:`LatticeError` for another order, and :class:`UndecidedError`.
        """
        from hfield.lattices.klpt import equivalent_of_power_norm

        return equivalent_of_power_norm(self, checked_prime(prime), seed)


def _restore(
    algebra: Parent, den: int, rows: hermite.Rows, side: str, order: Order | None
) -> Ideal:
    """Rebuild a pickled ideal."""
    return Ideal(algebra, den, fmpz_mat([list(row) for row in rows]), side, order)


def _is_number(x: object) -> bool:
    return not isinstance(x, (Lattice, Quaternion, tuple, list, str))
