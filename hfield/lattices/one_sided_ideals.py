"""One-sided ideals as lattices: how they are given, their side, their orders, whether they are invertible."""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING, Self

from flint import fmpz_mat

from hfield.algebra.quaternion import Parent
from hfield.errors import LatticeError, shorten
from hfield.lattices import hermite
from hfield.lattices.checked_arguments import element_row, listed
from hfield.lattices.lattice import Lattice

if TYPE_CHECKING:
    from hfield.lattices.order import Order


class OneSidedIdeal(Lattice):
    """A lattice with a side and an order that acts on it there."""

    def __init__(
        self,
        algebra: Parent,
        den: int,
        matrix: fmpz_mat,
        side: str = "left",
        order: Order | None = None,
    ) -> None:
        super().__init__(algebra, den, matrix)
        self.side = side
        self._order = order

    @classmethod
    def generated(cls, order: Order, generators: Iterable[object], side: str) -> Self:
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
    def of(cls, lattice: Lattice, side: str, order: Order | None = None) -> Self:
        """Return a lattice as an ideal of its left or right order, which may be known."""
        return cls(lattice.algebra, lattice._den, lattice._matrix, side, order)

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, (type(self), self.algebra, *self.hnf, self.side, self._order)

    @classmethod
    def like(cls, lattice: Lattice, order: Order, side: str) -> Self:
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


def _restore(
    kind: type[OneSidedIdeal],
    algebra: Parent,
    den: int,
    rows: hermite.Rows,
    side: str,
    order: Order | None,
) -> OneSidedIdeal:
    """Rebuild a pickled ideal."""
    return kind(algebra, den, fmpz_mat([list(row) for row in rows]), side, order)
