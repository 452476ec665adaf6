"""Lattices of rank 4 in an algebra over ℚ: four integer rows over a denominator, and their Hermite form."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import gcd

from hfield.certificates.number_fields.matrices import (
    Key,
    Row,
    Rows,
    hermite,
    inverse,
    longest,
    reduced,
    times,
    transposed,
)
from hfield.certificates.orders.algebra import Algebra
from hfield.certificates.work import charge


@dataclass(frozen=True)
class Lattice:
    """The integer combinations of four independent ``rows`` over ``den``; any basis."""

    algebra: Algebra
    den: int
    rows: Rows

    @cached_property
    def bits(self) -> int:
        """How long the numbers are, with those of the algebra."""
        return longest([(self.den,), *self.rows]) + self.algebra.bits

    @cached_property
    def key(self) -> Key:
        """The least denominator and the Hermite form: equal exactly for equal lattices."""
        return reduced(self.den, hermite(self.rows))

    @cached_property
    def gram(self) -> Rows:
        """The matrix of tr(x·conj(y)) on the rows, :attr:`unit` times too large."""
        charge(20 + self.bits**2 // 8_000)
        half = times(self.rows, self.algebra.form)
        return tuple(times(half, transposed(self.rows)))

    @property
    def unit(self) -> int:
        """By how much :attr:`gram` is too large."""
        return self.algebra.scale * self.den * self.den

    @cached_property
    def volume(self) -> Fraction:
        """The determinant of the rows, without its sign."""
        h = hermite(self.rows)
        charge(self.bits**2 // 10_000)
        return Fraction(h[0][0] * h[1][1] * h[2][2] * h[3][3], self.den**4)

    @cached_property
    def norm(self) -> Fraction:
        """The greatest rational number of which all norms of elements are multiples."""
        g = self.gram
        charge(self.bits**2 // 10_000)
        content = gcd(*(g[m][n] * (2 if m < n else 1) for m in range(4) for n in range(m, 4)))
        return Fraction(content, 2 * self.unit)

    def holds(self, den: int, rows: Iterable[Sequence[int]]) -> bool:
        """Tell whether all of the rows over ``den`` lie in the lattice."""
        own, h = self.key
        for row in rows:
            rest = [x * own for x in row]
            if any(x % den for x in rest):
                return False
            rest = [x // den for x in rest]
            for n in range(4):
                c, r = divmod(rest[n], h[n][n])
                if r:
                    return False
                for m in range(n, 4):
                    rest[m] -= c * h[n][m]
        return True

    def times(self, x: "Element", side: str) -> "Lattice":
        """Return L·x for the ``right`` side, x·L for the left."""
        charge(50 + (self.bits + longest([x.row])) ** 2 // 30_000)
        multiply = self.algebra.right if side == "right" else self.algebra.left
        rows = tuple(times(self.rows, multiply(x.row)))
        return Lattice(self.algebra, self.den * x.den * self.algebra.scale, rows)

    def products_lie_in(self, other: "Lattice", inside: "Lattice") -> bool:
        """Tell whether all products of an element of this lattice and one of the other lie in a third."""
        charge(200 + (self.bits + other.bits + inside.bits) ** 2 // 2_500)
        den = self.den * other.den * self.algebra.scale
        return all(
            inside.holds(den, times(self.rows, self.algebra.right(row))) for row in other.rows
        )

    def into(self, other: "Lattice", side: str) -> "Lattice":
        """Return {x: L·x ⊆ M} for the ``left`` side, {x: x·L ⊆ M} for the right, M being ``other``."""
        charge(200 + (self.bits + 4 * other.bits) ** 2 // 2_500)
        # x is in it exactly where x·c is an integer for the columns c of these matrices
        multiply = self.algebra.left if side == "left" else self.algebra.right
        back, det = inverse(other.rows)
        columns: list[Row] = []
        for row in self.rows:
            columns += transposed(tuple(times(multiply(row), back)))
        h = hermite(columns)
        found, d = inverse(transposed(h))
        top = self.den * self.algebra.scale * abs(det)
        g = gcd(other.den * abs(d), top)
        up, down = top // g, other.den * abs(d) // g
        return Lattice(self.algebra, down, tuple(tuple(x * up for x in row) for row in found))


@dataclass(frozen=True)
class Element:
    """A row over a denominator."""

    den: int
    row: Row

    def norm(self, algebra: Algebra) -> Fraction:
        """Return the norm."""
        (value,) = times([self.row], algebra.form)
        total = sum(x * y for x, y in zip(value, self.row, strict=True))
        return Fraction(total, 2 * algebra.scale * self.den * self.den)
