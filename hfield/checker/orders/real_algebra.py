"""The algebra at a real place: elements are rows of four numbers of an ordered ring (over ℚ, integers)."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import gcd

from hfield.checker.budget import spend
from hfield.checker.number_fields.matrices import Row, longest, times
from hfield.checker.number_fields.real_numbers import Real, RealNumber, RealPlace, RealRow
from hfield.checker.orders.algebra import Algebra


@dataclass(frozen=True)
class RealElement:
    """A row of real numbers over an integral denominator."""

    den: int
    row: RealRow


class RealAlgebra:
    """Products, conjugates and pairings of such rows, all of them multiplied by ``scale``."""

    def __init__(self, algebra: Algebra, place: RealPlace | None = None) -> None:
        """Build the tables; over ℚ there is one place, which need not be given."""
        self.algebra, self.scale, self._place = algebra, algebra.scale, place
        left: list[list[RealNumber]] = [[0] * 16 for _ in range(4)]
        for u, products in enumerate(algebra.products):
            for v, terms in enumerate(products):
                for k, c in terms:
                    left[u][4 * v + k] = self._constant(c)
        self._left = left
        self.form = tuple(tuple(map(self._constant, row)) for row in algebra.pairings)
        """The matrix of tr(x·conj(y))."""
        s, t = self.scale, self._constant(algebra.trace_of_i)
        self._bar = ((s, 0, 0, 0), (t, -s, 0, 0), (0, 0, -s, 0), (0, 0, 0, -s))
        self.bits = longest([*self.form, *left])

    def _number(self, row: Row) -> RealNumber:
        """Return an integer of the field as a real number."""
        return row[0] if self._place is None else Real(self._place, row)

    def _constant(self, row: Row) -> RealNumber:
        """Return an integer of the field; over ℚ as a Python integer, by which multiplication is fast."""
        one = self.algebra.integers.one
        k = next(k for k, c in enumerate(one) if c)
        c = row[k] // one[k]
        return c if tuple(c * x for x in one) == row else self._number(row)

    def element(self, den: int, row: Sequence[int]) -> RealElement:
        """Return an element from coordinates over ℤ, in lowest terms."""
        common, n = gcd(den, *row), self.algebra.n
        own = [c // common for c in row]
        numbers = (self._number(tuple(own[k : k + n])) for k in range(0, 4 * n, n))
        return RealElement(den // common, tuple(numbers))

    def coordinates(self, x: RealRow) -> Row:
        """Return the coordinates of a row over ℤ."""
        one = self.algebra.integers.one
        parts = (c.row if isinstance(c, Real) else tuple(c * e for e in one) for c in x)
        return tuple(c for part in parts for c in part)

    def primitive(self, den: int, x: RealRow) -> RealElement:
        """Return an element in lowest terms."""
        return self.element(den, self.coordinates(x))

    def times(self, x: RealRow, y: RealRow) -> RealRow:
        """Return x·y."""
        (row,) = times([x], self._left)
        return times([y], (row[:4], row[4:8], row[8:12], row[12:]))[0]

    def conjugate(self, x: RealRow) -> RealRow:
        """Return the conjugate."""
        return times([x], self._bar)[0]

    def pairing(self, x: RealRow, y: RealRow) -> RealNumber:
        """Return tr(x·conj(y))."""
        (row,) = times([x], self.form)
        return sum(a * b for a, b in zip(row, y, strict=True))

    def product(self, g: RealElement, h: RealElement) -> RealElement:
        """Return a product of elements, in lowest terms."""
        row = self.times(g.row, h.row)
        spend(50 + longest([row]) ** 2 // 10_000)
        return self.primitive(g.den * h.den * self.scale, row)
