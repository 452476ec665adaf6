"""Lattices of rank 4 as integer matrices over a denominator: the Hermite form, and what follows from it.

A lattice is ``(den, rows)``: the rows of a row Hermite normal form over the least denominator. It is
unique, so two lattices are equal exactly when these are (Cohen, *A Course in Computational Algebraic
Number Theory*, section 2.4.2).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction

from flint import fmpz, fmpz_mat

Rows = tuple[tuple[int, int, int, int], ...]


def hermite(den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat] | None:
    """Return the canonical form of what the rows of an integer matrix, over ``den``, generate.

    None when the rank is below 4.
    """
    n = matrix.nrows()
    if n < 4:
        return None
    h = matrix.hnf()
    top = h.entries() if n == 4 else [h[i, j] for i in range(4) for j in range(4)]
    if not (top[0] and top[5] and top[10] and top[15]):
        return None
    g = fmpz(den)
    for x in top:
        if g == 1:
            return den, h if n == 4 else fmpz_mat(4, 4, top)
        if x:
            g = g.gcd(x)
    return den // int(g), fmpz_mat(4, 4, [x // g for x in top])


def integral(vectors: Iterable[Sequence[Fraction]]) -> tuple[int, list[list[int]]]:
    """Return rational vectors as integer rows over their least common denominator."""
    rows = [list(v) for v in vectors]
    den = math.lcm(*(x.denominator for row in rows for x in row))
    return den, [[x.numerator * (den // x.denominator) for x in row] for row in rows]


def volume(matrix: fmpz_mat) -> fmpz:
    """Return the determinant of a triangular matrix, the product of the diagonal, as flint's integer."""
    return matrix[0, 0] * matrix[1, 1] * matrix[2, 2] * matrix[3, 3]


def determinant(matrix: fmpz_mat) -> int:
    """Return the determinant of a triangular matrix."""
    return int(volume(matrix))


def inverse(matrix: fmpz_mat) -> tuple[fmpz_mat, int]:
    """Return ``(m, d)`` with m/d the inverse of an integer matrix."""
    m, d = matrix.inv().numer_denom()
    return m, int(d)


def combination(x: Sequence[int], rows: fmpz_mat) -> tuple[int, ...]:
    """Return a combination of the rows of a matrix."""
    return tuple(int(c) for c in (fmpz_mat([list(x)]) * rows).entries())


def divided(rows: fmpz_mat, n: int) -> fmpz_mat:
    """Return an integer matrix divided by an integer that divides all entries."""
    return rows if n == 1 else fmpz_mat(rows.nrows(), 4, [x // n for x in rows.entries()])


def in_coordinates(matrix: fmpz_mat, other: fmpz_mat) -> tuple[fmpz_mat, int]:
    """Return ``(m, d)``: the rows of ``other`` are those of m/d times the regular ``matrix``."""
    inv, d = inverse(matrix)
    return other * inv, d


def contains(den: int, matrix: fmpz_mat, row_den: int, row: Sequence[int]) -> bool:
    """Tell whether ``row/row_den`` is an integer combination of the rows of ``matrix/den``."""
    rest = []
    for x in row:
        q, r = divmod(x * den, row_den) if x else (0, 0)
        if r:
            return False
        rest.append(q)
    for n in range(4):
        if not rest[n]:
            continue
        c, r = divmod(rest[n], matrix[n, n])
        if r:
            return False
        if c:
            for m in range(n + 1, 4):
                rest[m] -= c * matrix[n, m]
    return True


def tuples(matrix: fmpz_mat) -> Rows:
    """Return the rows of a matrix with four columns as tuples of ints."""
    e = [int(x) for x in matrix.entries()]
    return tuple((e[n], e[n + 1], e[n + 2], e[n + 3]) for n in range(0, len(e), 4))


def span(den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return the Hermite form of what the rows of an integer matrix, over ``den``, span, of any rank."""
    h = matrix.hnf()
    entries = h.entries()
    rank = max((n // 4 + 1 for n, x in enumerate(entries) if x), default=0)
    entries = entries[: 4 * rank]
    g = math.gcd(den, *(int(x) for x in entries))
    return den // g, fmpz_mat(rank, 4, [x // g for x in entries])
