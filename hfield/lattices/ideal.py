"""One-sided ideals of orders: what they are, their arithmetic, and when two are equivalent."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from functools import cached_property

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, shorten
from hfield.hints import IDEAL
from hfield.lattices import (
    certificates,
    compatible_products,
    equivalence,
    hermite,
    klpt,
    small_ideals,
)
from hfield.lattices.answers import Answer
from hfield.lattices.as_json import rows_json
from hfield.lattices.certificates import Certified, Claim
from hfield.lattices.checked_arguments import prime as checked_prime
from hfield.lattices.lattice import Lattice
from hfield.lattices.one_sided_ideals import OneSidedIdeal

OTHER = {"left": "right", "right": "left", "two-sided": "two-sided"}


class Ideal(Certified, OneSidedIdeal):
    """A lattice with ``O·I = I`` for the order O (``side="left"``), or ``I·O = I``, or both.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    >>> I = O.left_ideal([3, "1 + j"])
    >>> I.norm(), I.left_order() == O
    (3, True)
    >>> I * I.inverse() == O
    True
    """

    elsewhere = IDEAL

    # --- arithmetic ------------------------------------------------------------------------------

    def _product(self, other: Lattice) -> Lattice:
        if isinstance(other, Ideal) and (self.side, other.side) == ("right", "left"):
            order = self.order
            if order is other.order or order == other.order:
                found = compatible_products.product(self, other)
                if found is not None:
                    return Lattice(self.algebra, *found)
        return super()._product(other)

    def conjugate(self) -> Ideal:
        """Return the ideal of the conjugates, on the other side."""
        return Ideal.of(super().conjugate(), OTHER[self.side], self._order)

    def inverse(self) -> Ideal:
        """Return ``conj(I)/N(I)``. Raises :class:`LatticeError` unless I is locally principal."""
        return Ideal.of(super().inverse(), OTHER[self.side], self._order)

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
        m = hermite.multiple(self.order._den, self.order._matrix, self._den, self._matrix)
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

    @cached_property
    def claim(self) -> Claim:
        """What there is to certify, as a statement with its evidence."""
        return certificates.of_ideal(self)

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
        return equivalence.equivalence(self, self._joint(other))

    def is_equivalent(self, other: Ideal) -> bool:
        """Tell whether ``J = I·c`` (or ``c·I``) for some c. Raises as :meth:`equivalence` does."""
        return bool(self.equivalence(other))

    def is_principal(self) -> Answer:
        """Return an answer with a generator as ``element``: I = O·c for a left ideal, c·O for a right one."""
        return equivalence.equivalence(Ideal.of(self.order, self.side, self.order), self)

    def equivalent_of_prime_norm(self, avoid: Iterable[int] = ()) -> tuple[Ideal, Quaternion]:
        """Return (J, c) with J equivalent to I of the least prime norm that is not in ``avoid``.

        J = I·c for a left ideal, c·I for a right one, with c = conj(x)/N(I) for a short x in I
        (Kohel, Lauter, Petit and Tignol, 2014).
        """
        c = small_ideals.to_prime_norm(self, frozenset(avoid))
        found = self * c if self.side != "right" else self.__rmul__(c)
        return Ideal.of(found, self.side, self.order), c

    def equivalent_of_power_norm(self, prime: int, seed: int = 0) -> tuple[Ideal, Quaternion, int]:
        """Return (J, c, e), J = I·c of norm primeᵉ, for a left ideal of a p-extremal order: KLPT.

        Raises :class:`LatticeError` for another order, and :class:`UndecidedError`.
        """
        c, e = klpt.to_power_norm(self, checked_prime(prime), seed)
        return Ideal.of(self * c, "left", self.order), c, e


def _is_number(x: object) -> bool:
    return not isinstance(x, (Lattice, Quaternion, tuple, list, str))
