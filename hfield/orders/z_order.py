"""Orders over ℤ as values, lattices that are rings: discriminant, level, Eichler symbols, ternary lattice."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property

from hfield.orders import hermite
from hfield.orders.lattice_values import LatticeValue, discriminant


class ZOrder(LatticeValue):
    """A lattice that is a ring with 1. Coordinates are with respect to its basis."""

    @cached_property
    def discriminant(self) -> int:
        """The reduced discriminant; for a maximal order it is that of the algebra."""
        found: Fraction = discriminant(self)
        return int(found)

    @property
    def level(self) -> int:
        """The index in a maximal order: the reduced discriminant over that of the algebra."""
        return self.discriminant // int(self.ambient.discriminant)

    @cached_property
    def gram(self) -> hermite.Rows:
        """The matrix of ``tr(x·conj(y))`` on the basis; the norm of an order is 1."""
        return hermite.tuples(self.even)

    @cached_property
    def _traces(self) -> tuple[int, ...]:
        r = self.ambient
        column = (self.matrix * r.trace_form).entries()[::4]
        return tuple(int(x) // (r.scale * self.den) for x in column)

    def trace_and_norm(self, x: Sequence[int]) -> tuple[int, int]:
        """Return the trace and the norm of an element with these coordinates."""
        gram = self.gram
        norm = sum(x[m] * x[n] * gram[m][n] for m in range(4) for n in range(4)) // 2
        return sum(a * b for a, b in zip(x, self._traces, strict=True)), norm

    def row(self, x: Sequence[int]) -> tuple[int, ...]:
        """Return the row, over the denominator of the order, of an element with these coordinates."""
        return hermite.combination(x, self.matrix)
