"""How an algebra makes lattices and orders, over ℤ or the integers of a number field."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from hfield.factorisation import Factors, known_primes
from hfield.quaternion import Parent
from hfield.rings.base import WithIntegers

if TYPE_CHECKING:
    from hfield.lattices.hurwitz_order import HurwitzOrder
    from hfield.lattices.lattice import Lattice
    from hfield.lattices.order import Order


class OrderMakers(Parent):
    """The part of an algebra's methods that are about lattices and orders; the room is imported on use."""

    def lattice(self, elements: Iterable[object]) -> Lattice:
        """Return the lattice that elements (or 4-tuples of rationals) span over ℤ, in an algebra over ℚ.

        Raises :class:`LatticeError` when its rank is below 4, :class:`RingError` over another field.
        """
        from hfield.lattices.lattice import Lattice

        return Lattice.spanned(self, elements)

    def order(self, elements: Iterable[object]) -> Order:
        """Return the order that elements generate as a ring.

        Raises :class:`LatticeError` when they generate a ring of lower rank, or one that is no lattice.
        """
        from hfield.lattices.order import Order

        return Order.generated(self, elements)

    def order_from_basis(self, elements: Iterable[object]) -> Order:
        """Return the order with a basis of four elements.

        Raises :class:`LatticeError` unless they span a ring with 1.
        """
        from hfield.lattices.order import Order

        return Order.from_basis(self, elements)

    def maximal_order(self, factors: Factors | None = None) -> Any:
        """Return a maximal order, of an algebra that is not degenerate: always the same.

        Over ℚ it is an :class:`hfield.Order`. Over another number field it is one over the integers of the
        field, with ``basis`` over ℤ, ``pseudo_basis()`` and ``discriminant()``: an ``IntegersOrder``.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()
        >>> O.discriminant(), len(O.basis)
        ((), 8)
        """
        from hfield.lattices.named_orders import maximal_order
        from hfield.lattices.over_integers import maximal_order_over_integers

        with known_primes(factors):
            F = self.ring
            over_z = isinstance(F, WithIntegers) and F.degree == 1
            if F.arithmetic and not F.characteristic and not over_z:
                return maximal_order_over_integers(self)
            return maximal_order(self)

    def eichler_order(self, level: int, factors: Factors | None = None) -> Order:
        """Return an Eichler order of the given level, the same for the same algebra and level.

        Raises :class:`LatticeError` for a level that is not prime to the discriminant.
        """
        from hfield.lattices.named_orders import eichler_order

        with known_primes(factors):
            return eichler_order(self, level)

    def extremal_order(self) -> Order:
        """Return a p-extremal maximal order, from which KLPT starts, for a prime discriminant p.

        Raises :class:`LatticeError` for an indefinite algebra, or a composite discriminant.
        """
        from hfield.lattices.extremal_orders import extremal_order

        return extremal_order(self)

    def lipschitz_order(self) -> Order:
        """Return the order ``ℤ⟨e, i, j, k⟩``, for integer constants over ℚ."""
        from hfield.lattices.named_orders import lipschitz_order

        return lipschitz_order(self)

    def hurwitz_order(self) -> HurwitzOrder:
        """Return ``ℤ⟨e, i, j, (e+i+j+k)/2⟩`` in (−1,−1|ℚ). Raises :class:`CoercionError` elsewhere."""
        from hfield.lattices.named_orders import hurwitz_order

        return hurwitz_order(self)

    def class_number(self, level: int = 1) -> int:
        """Return the number of ideal classes of an Eichler order, by Eichler's formula without enumeration.

        In an indefinite algebra it is 1, by strong approximation. Raises :class:`LatticeError` for a
        level that is not prime to the discriminant.
        """
        from hfield.lattices.named_orders import class_number

        return class_number(self, level)
