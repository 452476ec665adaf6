"""Lattices of rank 4 in an algebra over ℚ: four integer rows over a denominator, and their Hermite form."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import gcd

from hfield.certificates.orders.algebra import Algebra, Row, Rows, longest, times
from hfield.certificates.rejection import reject
from hfield.certificates.scalars.rationals import over_one_denominator
from hfield.certificates.work import charge

Key = tuple[int, Rows]


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


def reduced(den: int, rows: Rows) -> Key:
    """Return a Hermite form over its least denominator."""
    charge(den.bit_length() * sum(row[n].bit_length() for n, row in enumerate(rows)) // 30_000)
    g = gcd(den, *(x for row in rows for x in row))
    return den // g, tuple(tuple(x // g for x in row) for row in rows)


def transposed(rows: Rows) -> Rows:
    """Return the columns."""
    return tuple(zip(*rows, strict=True))


def hermite(rows: Iterable[Sequence[int]]) -> Rows:
    """Return the Hermite form of what the rows span over ℤ. Raises :class:`Rejected` below the full rank."""
    rest = [list(row) for row in rows]
    size = len(rest[0])
    found: list[list[int]] = []
    first = longest(rest)
    for c in range(size):
        bits = (c + 1) * first  # what has been combined is longer
        cost = 1 + bits // 4_000  # where a quotient is short, as most are
        charge(len(rest) * (bits * bits // 150_000))
        pool = [row for row in rest if row[c]]
        rest = [row for row in rest if not row[c]]
        if not pool:
            reject(f"these rows span a lattice of rank below {size}")
        while len(pool) > 1:
            charge(cost * len(pool))
            pivot = min(pool, key=lambda row: abs(row[c]))
            others, pool = [row for row in pool if row is not pivot], [pivot]
            for row in others:
                q = row[c] // pivot[c]
                for n in range(c, size):
                    row[n] -= q * pivot[n]
                (pool if row[c] else rest).append(row)
        (pivot,) = pool
        found.append([-x for x in pivot] if pivot[c] < 0 else pivot)
    charge(first**2 // 2_000)
    for c in range(1, size):
        for upper in found[:c]:
            q = upper[c] // found[c][c]
            for n in range(c, size):
                upper[n] -= q * found[c][n]
    return tuple(map(tuple, found))


def inverse(rows: Rows) -> tuple[Rows, int]:
    """Return ``(m, d)``, m/d being the inverse of a matrix. Raises :class:`Rejected` where there is none."""
    charge(60 + longest(rows) ** 2 // 450)
    m = [[*row, *(int(r == c) for c in range(4))] for r, row in enumerate(rows)]
    before = 1
    for c in range(4):  # without fractions (Bareiss): all divisions by ``before`` leave no rest
        pivot = next((r for r in range(c, 4) if m[r][c]), None)
        if pivot is None:
            reject("these rows span a lattice of rank below 4")
        if pivot != c:
            m[c], m[pivot] = m[pivot], [-x for x in m[c]]
        top = m[c]
        for r in range(4):
            if r != c:
                f = m[r][c]
                m[r] = [(top[c] * x - f * y) // before for x, y in zip(m[r], top, strict=True)]
        before = top[c]
    return tuple(tuple(row[4:]) for row in m), before


def rational_rows(values: Sequence[Sequence[Fraction]]) -> tuple[int, Rows]:
    """Return rational rows as integer rows over their least denominator."""
    entries, den = over_one_denominator([x for row in values for x in row])
    width = len(values[0])
    return den, tuple(tuple(entries[n : n + width]) for n in range(0, len(entries), width))
