"""Orders over ℤ in quaternion algebras over ℚ: the lattices that are rings."""

from __future__ import annotations

import random
from collections.abc import Iterable
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, overload

from flint import fmpz_mat

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import LatticeError, shorten
from hfield.hints import ORDER
from hfield.lattices import (
    certificates,
    class_number,
    hermite,
    isomorphic_orders,
    maximal_orders,
    norm_equations,
    quadratic_orders,
    subideals,
    two_sided_ideals,
)
from hfield.lattices.as_json import rows_json
from hfield.lattices.certificates import Certified, Claim
from hfield.lattices.checked_arguments import checked_side, integer, listed, positive, prime
from hfield.lattices.classes import ClassSet
from hfield.lattices.generated_orders import check_ring, generated
from hfield.lattices.lattice import Lattice
from hfield.lattices.order_invariants import OrderInvariants

if TYPE_CHECKING:
    from hfield.lattices.answers import Answer
    from hfield.lattices.ideal import Ideal
    from hfield.lattices.quadratic_orders import Embeddings

UNIT_GROUPS = {2: "C2", 4: "C4", 6: "C6", 8: "Q8", 12: "Dic3", 24: "SL(2,3)"}
"""Which group the units are, by their number, in a definite algebra over ℚ (Voight, section 11.5)."""


class Order(OrderInvariants, Certified, Lattice):
    """A lattice that is a ring with 1: ``q in O`` asks for membership.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    >>> O.discriminant(), O.is_maximal(), O.unit_count()
    (11, True, 4)
    """

    elsewhere = ORDER

    @classmethod
    def generated(cls, algebra: Parent, elements: Iterable[object]) -> Order:
        """Return the ring that elements generate.

        Raises :class:`LatticeError` when it has a rank below 4, or is no lattice, because it contains
        elements that are not integral.
        """
        return cls(algebra, *generated(algebra, elements))

    @classmethod
    def from_basis(cls, algebra: Parent, elements: Iterable[object]) -> Order:
        """Return the order with the given ℤ-basis.

        Raises :class:`LatticeError` unless they are four that span a ring with 1; the message names
        the product that is missing.
        """
        basis = listed(elements)
        if len(basis) != 4:
            raise LatticeError(
                f"a basis of an order has four elements, and {len(basis)} were given"
            )
        return cls.from_lattice(Lattice.spanned(algebra, basis))

    @classmethod
    def from_lattice(cls, lattice: Lattice) -> Order:
        """Return a lattice as an order. Raises :class:`LatticeError` unless it is a ring with 1."""
        check_ring(lattice)
        return cls._ring(lattice)

    @classmethod
    def _ring(cls, lattice: Lattice) -> Order:
        """Return a lattice that is known to be a ring with 1 as an order."""
        return cls(lattice.algebra, lattice._den, lattice._matrix)

    @overload
    def __and__(self, other: Order) -> Order: ...
    @overload
    def __and__(self, other: object) -> Lattice: ...
    def __and__(self, other: object) -> Lattice:
        """Return the intersection with a lattice; that with another order is an order."""
        found = super().__and__(other)
        return Order._ring(found) if isinstance(other, Order) else found

    @cached_property
    def claim(self) -> Claim:
        """What there is to certify, as a statement with its evidence."""
        return certificates.of_order(self)

    @property
    def evidence(self) -> dict[str, object]:
        """What a program needs to check the order: its rows, closed under products, and its discriminant."""
        return {
            "kind": "order",
            "algebra": str(self.algebra),
            **rows_json(self),
            "discriminant": self._discriminant,
            "discriminant_of_algebra": self._regular.discriminant,
        }

    # --- larger and smaller orders ---------------------------------------------------------------

    def maximal_overorder(self) -> Order:
        """Return a maximal order that contains this one, always the same."""
        return maximal_orders.overorder(self)

    def gorenstein_closure(self) -> Order:
        """Return the Gorenstein order G with O = ℤ + f·G, f the conductor (Voight, section 24.2)."""
        f = self.conductor()
        den, rows, gram = self._ternary
        # ℤ + 2G has the trace-0 part of ℤ + 2O, divided by f
        found = [[2 * f * den, 0, 0, 0]]
        for n, row in enumerate(hermite.tuples(rows)):
            odd = gram[n][n] // 2 // f**2 % 2
            found.append([row[0] + odd * f * den, *row[1:]])
        return Order.from_lattice(self._make(2 * f * den, fmpz_mat(found)))

    # --- units -------------------------------------------------------------------------------------

    def units(self) -> tuple[Quaternion, ...]:
        """Return all units of an order in a definite algebra.

        Raises :class:`NotFiniteError` for an indefinite algebra, whose orders have infinitely many.
        """
        self._definite("units()")
        return self.elements_of_norm(1)

    def unit_count(self) -> int:
        """Return how many units there are; at most 24. Raises as :meth:`units` does."""
        self._definite("unit_count()")
        return 2 * sum(1 for _, m in self._short(1))

    def unit_group(self) -> str:
        """Return the name of the group of units: ``C2 C4 C6 Q8 Dic3`` or ``SL(2,3)``.

        Of an indefinite algebra, ``"infinite"``: a finitely presented group that is not written down.
        """
        return UNIT_GROUPS[self.unit_count()] if self._regular.definite else "infinite"

    # --- ideals ------------------------------------------------------------------------------------

    def left_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the left ideal ``O·gens``. Raises :class:`LatticeError` when its rank is below 4."""
        from hfield.lattices.ideal import Ideal

        return Ideal.generated(self, generators, "left")

    def right_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the right ideal ``gens·O``. Raises :class:`LatticeError` when its rank is below 4."""
        from hfield.lattices.ideal import Ideal

        return Ideal.generated(self, generators, "right")

    def two_sided_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the ideal ``O·gens·O``. Raises :class:`LatticeError` for a rank below 4."""
        from hfield.lattices.ideal import Ideal

        return Ideal.generated(self, generators, "two-sided")

    def _ideal(self, lattice: Lattice, side: str) -> Ideal:
        """Return a lattice that is known to be an ideal of this order."""
        from hfield.lattices.ideal import Ideal

        return Ideal.of(lattice, side, self)

    def _right_ideal(self, ideal: object) -> Ideal:
        """Return a right ideal of this order, perhaps given as a lattice. Raises :class:`LatticeError`."""
        from hfield.lattices.ideal import Ideal

        if isinstance(ideal, Lattice) and not isinstance(ideal, Ideal):
            return Ideal.like(ideal, self, "right")
        if not isinstance(ideal, Ideal) or ideal.side == "left" or ideal.order != self:
            raise LatticeError(f"{shorten(repr(ideal))} is not a right ideal of {shorten(self)}")
        return ideal

    def two_sided_prime(self, p: int) -> Ideal:
        """Return the two-sided ideal at a prime that generates, with the numbers, all those there.

        Its square is pᵉ·O, the part of the discriminant at p; it is p·O where p does not divide that.
        Raises :class:`LatticeError` where the order is neither maximal nor Eichler at p.
        """
        return self._ideal(two_sided_ideals.two_sided_prime(self, prime(p)), "two-sided")

    def ideals_of_norm(self, n: int, side: str = "left") -> list[Ideal]:
        """Return all invertible integral ideals of norm n on a side: p + 1 where p is off the discriminant.

        Raises :class:`LatticeError`, and :class:`TooLargeError` for more than 10⁵.
        """
        norm, side = positive(n, "norm"), checked_side(side)
        found = [self._ideal(J, "right") for J in subideals.ideals_of_norm(self, norm)]
        return found if side == "right" else [J.conjugate() for J in found]

    def random_ideal(self, n: int, side: str = "left", seed: int | None = None) -> Ideal:
        """Return a random ideal of norm n, prime to the discriminant, which no integer divides.

        The same for the same seed. Raises :class:`LatticeError`.
        """
        norm, side = positive(n, "norm"), checked_side(side)
        found = self._ideal(subideals.random_ideal(self, norm, random.Random(seed)), "left")
        return found if side == "left" else found.conjugate()

    def connecting_ideal(self, other: Order) -> Ideal:
        """Return the primitive integral ideal with this left order and the right order ``other``.

        Raises :class:`LatticeError` unless both are Eichler orders of one level.
        """
        return self._ideal(
            isomorphic_orders.connecting_ideal(self, self._order_like(other)), "left"
        )

    def isomorphism(self, other: Order) -> Answer:
        """Return an answer with an ``element`` x, x·O·x⁻¹ being the other order, or the ``reason`` why none.

        Decided for all orders of definite algebras, and for ℤ + f·Eichler orders of indefinite ones, where
        the element may be missing. Raises :class:`UndecidedError`.
        """
        return isomorphic_orders.isomorphism(self, self._order_like(other))

    def _order_like(self, other: object) -> Order:
        """Return an order of the same algebra, perhaps given as a lattice, ``x * O * x.inverse()``."""
        found = self._same(other, "compare")
        return found if isinstance(found, Order) else Order.from_lattice(found)

    def is_isomorphic(self, other: Order) -> bool:
        """Tell whether two orders are isomorphic. Raises as :meth:`isomorphism` does."""
        return bool(self.isomorphism(other))

    # --- elements ----------------------------------------------------------------------------------

    def represent_integer(self, n: int, seed: int | None = None) -> Quaternion | None:
        """Return an element of norm n, or None where there is none; n may have hundreds of digits.

        Raises :class:`IndefiniteError`, and :class:`UndecidedError` for a large n in an order without small
        quadratic orders.
        """
        return norm_equations.represent_integer(self, positive(n, "norm"), seed)

    def embeddings(self, discriminant: int) -> Embeddings:
        """Return the optimal embeddings of the quadratic order of a negative discriminant.

        Raises :class:`LatticeError` for what is no such discriminant, :class:`IndefiniteError`.
        """
        return quadratic_orders.embeddings(self, integer(discriminant, "discriminant"))

    # --- classes -----------------------------------------------------------------------------------

    def class_set(self) -> ClassSet:
        """Return the right ideal classes, enumerated and checked by the mass, in a definite algebra.

        Raises :class:`IndefiniteError`; there the number of classes is 1 for an Eichler order.
        """
        return ClassSet(self)

    def mass(self) -> Fraction:
        """Return ``Σ 1/[O_L(I)^× : ±1]`` over the right ideal classes, by a formula."""
        return class_number.mass(self)
