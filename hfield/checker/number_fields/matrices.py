"""Matrices of integers: products, Hermite forms, inverses and determinants.

Integers may also be polynomials over a finite field (:mod:`hfield.checker.scalars.finite_field_polynomials`).

Most rows have four entries. A special case for these takes half the time.
"""

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from operator import mul
from typing import Protocol, Self, TypeVar, overload

from hfield.checker.budget import Number, spend, spend_products
from hfield.checker.rejection import reject
from hfield.checker.scalars.finite_field_polynomials import FiniteFieldPolynomial, RationalFunction
from hfield.checker.scalars.rationals import over_one_denominator

N = TypeVar("N", int, FiniteFieldPolynomial)
"""The numbers over which lattices are: integers, or polynomials."""
RowOf = tuple[N, ...]
RowsOf = tuple[RowOf[N], ...]
KeyOf = tuple[N, RowsOf[N]]
"""A Hermite form over its least denominator."""
Row = RowOf[int]
Rows = RowsOf[int]
Key = KeyOf[int]


class Entry(Protocol):
    """A number that can stand in a matrix: an integer, a polynomial, or a real number of a number field."""

    def __add__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self | int, /) -> Self: ...


N_co = TypeVar("N_co", int, FiniteFieldPolynomial, covariant=True)


class Quotient(Protocol[N_co]):
    """A fraction of integers or of polynomials in lowest terms."""

    @property
    def numerator(self) -> N_co:
        """The numerator."""

    @property
    def denominator(self) -> N_co:
        """The denominator, positive or monic."""

    def __mul__(self, other: Self, /) -> Self: ...


M = TypeVar("M", bound=Entry)
T = TypeVar("T")


def gcd(first: N, *others: N) -> N:
    """Return the greatest common divisor: positive for integers, monic for polynomials."""
    return math.gcd(first, *others) if isinstance(first, int) else first.gcd(*others)


def lcm(first: N, *others: N) -> N:
    """Return the least common multiple of positive integers or of monic polynomials."""
    for x in others:
        first = first * (x // gcd(x, first))
    return first


@overload
def ratio(x: int, y: int) -> Fraction: ...
@overload
def ratio(x: FiniteFieldPolynomial, y: FiniteFieldPolynomial) -> RationalFunction: ...
def ratio(x: N, y: N) -> Fraction | RationalFunction:
    """Return x/y, a fraction of integers or of polynomials."""
    return Fraction(x, y) if isinstance(x, int) else x.ratio(y)


def normal(x: N) -> N:
    """Return the associate of a nonzero number that is positive or monic."""
    return abs(x) if isinstance(x, int) else x * x.to_normal


def is_one(x: N) -> bool:
    """Return whether a positive integer or a monic polynomial is 1."""
    return bool(x == 1) if isinstance(x, int) else x.degree == 0


def longest(rows: Iterable[Sequence[Number]]) -> int:
    """Return the bit length of the longest number."""
    return max([n.bit_length() for row in rows for n in row], default=0)


def unit(n: int, k: int, value: int = 1) -> Row:
    """Return a row with one nonzero entry."""
    return tuple(value * int(k == m) for m in range(n))


def times(rows: Iterable[Sequence[M]], matrix: Sequence[Sequence[M]]) -> list[tuple[M, ...]]:
    """Return the products of rows with a matrix. The caller spends the work."""
    if len(matrix) != 4:
        return times_any(rows, matrix)
    a, b, c, d = matrix
    return [
        tuple([w * p + x * q + y * r + z * s for p, q, r, s in zip(a, b, c, d, strict=True)])
        for w, x, y, z in rows
    ]


def times_any(rows: Iterable[Sequence[M]], matrix: Sequence[Sequence[M]]) -> list[tuple[M, ...]]:
    """Return the products of rows with a matrix of any number of rows."""
    columns, zero = transposed(matrix), matrix[0][0] * 0
    return [tuple([sum(map(mul, row, column), zero) for column in columns]) for row in rows]


def transposed(rows: Iterable[Sequence[T]]) -> tuple[tuple[T, ...], ...]:
    """Return the transposed matrix, as rows."""
    return tuple(zip(*rows, strict=True))


def hermite(rows: Iterable[Sequence[N]]) -> RowsOf[N]:
    """Return the Hermite form of the span of rows over ℤ. Raises :class:`Rejected` unless it has
    full rank.
    """
    rest = [list(row) for row in rows]
    if not rest:
        reject("no rows span no lattice")
    size = len(rest[0])
    if size == 1:
        g = gcd(*(row[0] for row in rest))
        return ((g,),) if g else reject("these rows span a lattice of rank below 1")
    found: list[list[N]] = []
    first = longest(rest)
    for c in range(size):
        bits = (c + 1) * first  # products are longer
        cost = 1 + bits // 4_000  # if a quotient is short, as most are
        spend(len(rest) * (bits * bits // 150_000))
        pool = [row for row in rest if row[c]]
        rest = [row for row in rest if not row[c]]
        if not pool:
            reject(f"these rows span a lattice of rank below {size}")
        while len(pool) > 1:
            spend(cost * len(pool))
            pivot = min(pool, key=lambda row: abs(row[c]))
            others, pool = [row for row in pool if row is not pivot], [pivot]
            for row in others:
                q = row[c] // pivot[c]
                for n in range(c, size):
                    row[n] -= q * pivot[n]
                (pool if row[c] else rest).append(row)
        (pivot,) = pool
        found.append(_with_normal_pivot(pivot, c))
    spend(first**2 // 2_000)
    for c in range(1, size):
        for upper in found[:c]:
            q = upper[c] // found[c][c]
            for n in range(c, size):
                upper[n] -= q * found[c][n]
    return tuple(map(tuple, found))


def _with_normal_pivot(row: list[N], c: int) -> list[N]:
    lead = row[c]
    if isinstance(lead, int):
        return [-x for x in row] if lead < 0 else row
    return [x * lead.to_normal for x in row]


def reduced(den: N, rows: RowsOf[N]) -> KeyOf[N]:
    """Return a Hermite form with its least denominator."""
    spend(den.bit_length() * sum(row[n].bit_length() for n, row in enumerate(rows)) // 30_000)
    g = gcd(den, *(x for row in rows for x in row))
    return den // g, tuple(tuple(x // g for x in row) for row in rows)


def inverse(rows: Sequence[Sequence[N]]) -> tuple[RowsOf[N], N]:
    """Return ``(m, d)`` such that m/d is the inverse of a matrix. Raises :class:`Rejected` if there
    is none.
    """
    size = len(rows)
    spend(60 * (1 + (size // 4) ** 3) + size**3 * longest(rows) ** 2 // 30_000)
    zero: N = rows[0][0] * 0
    m: list[list[N]] = []
    for r, row in enumerate(rows):
        m.append(list(row) + [zero] * size)
        m[r][size + r] = zero + 1
    before: N | int = 1
    for c in range(size):  # without fractions (Bareiss): all divisions by ``before`` leave no rest
        pivot = next((r for r in range(c, size) if m[r][c]), None)
        if pivot is None:
            reject(f"these rows span a lattice of rank below {size}")
        if pivot != c:
            m[c], m[pivot] = m[pivot], [-x for x in m[c]]
        top = m[c]
        for r in range(size):
            if r != c:
                f = m[r][c]
                m[r] = [(top[c] * x - f * y) // before for x, y in zip(m[r], top, strict=True)]
        before = top[c]
    return tuple(tuple(row[size:]) for row in m), m[-1][size - 1]


def determinant(rows: Sequence[Sequence[int]]) -> int:
    """Return a determinant."""
    found = _triangular(rows)
    if found is None:
        return 0
    sign, m = found
    return sign * m[-1][-1] if m else sign


def is_singular(rows: Sequence[Sequence[N]]) -> bool:
    """Return whether a determinant is 0."""
    return _triangular(rows) is None


def _triangular(rows: Sequence[Sequence[N]]) -> tuple[int, list[list[N]]] | None:
    """Eliminate without fractions (Bareiss), for the determinant in the last row; None if that is 0.

    Returns the sign of the order of the rows as well.
    """
    m: list[list[N]] = [list(row) for row in rows]
    n, sign = len(m), 1
    before: N | int = 1
    for c in range(n):
        k = next((r for r in range(c, n) if m[r][c]), None)
        if k is None:
            return None
        if k != c:
            m[c], m[k] = m[k], m[c]
            sign = -sign
        for r in range(c + 1, n):
            f = m[r][c]
            spend_products([m[c][c], f], m[r][c:] + m[c][c:])
            m[r] = [(m[c][c] * x - f * y) // before for x, y in zip(m[r], m[c], strict=True)]
        before = m[c][c]
    return sign, m


def diagonal_product(rows: RowsOf[N]) -> N:
    """Return the product of the entries on the diagonal."""
    found = rows[0][0]
    for k in range(1, len(rows)):
        found = found * rows[k][k]
    return found


def rational_rows(values: Sequence[Sequence[Fraction]]) -> tuple[int, Rows]:
    """Return rational rows as integer rows over their least denominator."""
    entries, den = over_one_denominator([x for row in values for x in row])
    width = len(values[0])
    return den, tuple(tuple(entries[n : n + width]) for n in range(0, len(entries), width))
