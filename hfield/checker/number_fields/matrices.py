"""Matrices of integers: products, Hermite forms, inverses and determinants.

Integers may also be polynomials over a finite field (:mod:`hfield.checker.orders.polynomial_integers`).

Most rows have four entries. Their products are computed by a special case, which takes half the time.
"""

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from operator import mul
from typing import Any

from hfield.checker.budget import spend, spend_products
from hfield.checker.rejection import reject
from hfield.checker.scalars.rationals import over_one_denominator

Row = tuple[Any, ...]
"""Integers, or real numbers of a number field."""
Rows = tuple[Row, ...]
Key = tuple[int, Rows]
"""A Hermite form over its least denominator."""


def gcd(first: Any, *others: Any) -> Any:
    """Return the greatest common divisor: positive of integers, monic of polynomials."""
    return math.gcd(first, *others) if isinstance(first, int) else first.gcd(*others)


def lcm(first: Any, *others: Any) -> Any:
    """Return the least common multiple of positive integers or of monic polynomials."""
    for x in others:
        first = first * (x // gcd(x, first))
    return first


def ratio(x: Any, y: Any) -> Any:
    """Return x/y, a fraction of integers or of polynomials."""
    return Fraction(x, y) if isinstance(x, int) else x.ratio(y)


def normal(x: Any) -> Any:
    """Return the associate of a number other than 0 that is positive or monic."""
    return abs(x) if isinstance(x, int) else x * x.to_normal


def is_one(x: Any) -> bool:
    """Return whether a positive integer or a monic polynomial is 1."""
    return bool(x == 1) if isinstance(x, int) else x.degree == 0


def longest(rows: Iterable[Sequence[int]]) -> int:
    """Return the bit length of the longest number."""
    return max([n.bit_length() for row in rows for n in row], default=0)


def unit(n: int, k: int, value: int = 1) -> Row:
    """Return a row with one entry that is not 0."""
    return tuple(value * int(k == m) for m in range(n))


def times(rows: Iterable[Sequence[Any]], matrix: Sequence[Sequence[Any]]) -> list[Row]:
    """Return the products of rows with a matrix. The caller spends the work."""
    if len(matrix) != 4:
        return times_any(rows, matrix)
    a, b, c, d = matrix
    return [
        tuple([w * p + x * q + y * r + z * s for p, q, r, s in zip(a, b, c, d, strict=True)])
        for w, x, y, z in rows
    ]


def times_any(rows: Iterable[Sequence[Any]], matrix: Sequence[Sequence[Any]]) -> list[Row]:
    """Return the products of rows with a matrix that has any number of rows."""
    columns = transposed(matrix)
    return [tuple([sum(map(mul, row, column)) for column in columns]) for row in rows]


def transposed(rows: Iterable[Sequence[Any]]) -> Rows:
    """Return the columns."""
    return tuple(zip(*rows, strict=True))


def hermite(rows: Iterable[Sequence[int]]) -> Rows:
    """Return the Hermite form of what the rows span over ℤ. Raises :class:`Rejected` below the full rank."""
    rest = [list(row) for row in rows]
    if not rest:
        reject("no rows span no lattice")
    size = len(rest[0])
    if size == 1:
        g = gcd(*(row[0] for row in rest))
        return ((g,),) if g else reject("these rows span a lattice of rank below 1")
    found: list[list[int]] = []
    first = longest(rest)
    for c in range(size):
        bits = (c + 1) * first  # what has been combined is longer
        cost = 1 + bits // 4_000  # where a quotient is short, as most are
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


def _with_normal_pivot(row: list[Any], c: int) -> list[Any]:
    if isinstance(row[c], int):
        return [-x for x in row] if row[c] < 0 else row
    return [x * row[c].to_normal for x in row]


def reduced(den: int, rows: Rows) -> Key:
    """Return a Hermite form over its least denominator."""
    spend(den.bit_length() * sum(row[n].bit_length() for n, row in enumerate(rows)) // 30_000)
    g = gcd(den, *(x for row in rows for x in row))
    return den // g, tuple(tuple(x // g for x in row) for row in rows)


def inverse(rows: Sequence[Sequence[int]]) -> tuple[Rows, int]:
    """Return ``(m, d)``, m/d being the inverse of a matrix. Raises :class:`Rejected` where there is none."""
    size = len(rows)
    spend(60 * (1 + (size // 4) ** 3) + size**3 * longest(rows) ** 2 // 30_000)
    m = [[*row, *unit(size, r)] for r, row in enumerate(rows)]
    before = 1
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
    return tuple(tuple(row[size:]) for row in m), before


def determinant(rows: Sequence[Sequence[int]]) -> int:
    """Return a determinant, without fractions (Bareiss)."""
    m = [list(row) for row in rows]
    n, sign, before = len(m), 1, 1
    for c in range(n):
        k = next((r for r in range(c, n) if m[r][c]), None)
        if k is None:
            return 0
        if k != c:
            m[c], m[k], sign = m[k], m[c], -sign
        for r in range(c + 1, n):
            f = m[r][c]
            spend_products([m[c][c], f], [*m[r][c:], *m[c][c:]])
            m[r] = [(m[c][c] * x - f * y) // before for x, y in zip(m[r], m[c], strict=True)]
        before = m[c][c]
    return sign * before


def rational_rows(values: Sequence[Sequence[Fraction]]) -> tuple[int, Rows]:
    """Return rational rows as integer rows over their least denominator."""
    entries, den = over_one_denominator([x for row in values for x in row])
    width = len(values[0])
    return den, tuple(tuple(entries[n : n + width]) for n in range(0, len(entries), width))
