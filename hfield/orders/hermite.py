"""Lattices of full rank in ℚᵐ as integer matrices over a denominator: the Hermite form, and what follows.

A lattice is ``(den, rows)``: the rows of a row Hermite normal form over the least denominator. It is
unique, so two lattices are equal exactly when these are (Cohen, *A Course in Computational Algebraic
Number Theory*, section 2.4.2).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction

from flint import fmpq, fmpq_mat, fmpz, fmpz_mat

Rows = tuple[tuple[int, ...], ...]


def hermite(den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat] | None:
    """Return the canonical form of what the rows of an integer matrix, over ``den``, generate.

    None when the rank is below the number of columns.
    """
    n, size = matrix.nrows(), matrix.ncols()
    if n < size:
        return None
    h = matrix.hnf()
    columns = range(size)
    top = h.entries() if n == size else [h[i, j] for i in columns for j in columns]
    if not all(top[:: size + 1]):
        return None
    g = fmpz(den)
    for x in top:
        if g == 1:
            return den, h if n == size else fmpz_mat(size, size, top)
        if x:
            g = g.gcd(x)
    return den // int(g), fmpz_mat(size, size, [x // g for x in top])


def integral(vectors: Iterable[Sequence[Fraction]]) -> tuple[int, list[list[int]]]:
    """Return rational vectors as integer rows over their least common denominator."""
    rows = [list(v) for v in vectors]
    den = math.lcm(*(x.denominator for row in rows for x in row))
    return den, [[x.numerator * (den // x.denominator) for x in row] for row in rows]


def rational(rows: fmpq_mat) -> tuple[int, fmpz_mat]:
    """Return a rational matrix as an integer matrix over a denominator."""
    whole, den = rows.numer_denom()
    return int(den), whole


def volume(matrix: fmpz_mat) -> fmpz:
    """Return the determinant of a triangular matrix, the product of the diagonal, as flint's integer."""
    found = matrix[0, 0]
    for n in range(1, matrix.ncols()):
        found *= matrix[n, n]
    return found


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
    if n == 1:
        return rows
    return (rows * fmpq(1, n)).numer_denom()[0]


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
    size = len(rest)
    for n in range(size):
        if not rest[n]:
            continue
        c, r = divmod(rest[n], matrix[n, n])
        if r:
            return False
        if c:
            for m in range(n + 1, size):
                rest[m] -= c * matrix[n, m]
    return True


def tuples(matrix: fmpz_mat) -> Rows:
    """Return the rows of a matrix as tuples of ints."""
    numbers = map(int, matrix.entries())
    return tuple(zip(*[numbers] * matrix.ncols(), strict=True))


def stacked(*matrices: fmpz_mat) -> fmpz_mat:
    """Return the rows of several matrices, one below the other."""
    if len(matrices) == 1:
        return matrices[0]
    entries, size = matrices[0].entries(), matrices[0].ncols()
    for m in matrices[1:]:
        entries += m.entries()
    return fmpz_mat(len(entries) // size, size, entries)


def joined(d: int, m: fmpz_mat, e: int, n: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return the rows of two matrices over a common denominator."""
    den = math.lcm(d, e)
    if d != e:
        m, n = m * (den // d), n * (den // e)
    return den, stacked(m, n)


def span(den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return the Hermite form of what the rows of an integer matrix, over ``den``, span, of any rank."""
    h, size = matrix.hnf(), matrix.ncols()
    entries = h.entries()
    rank = max((n // size + 1 for n, x in enumerate(entries) if x), default=0)
    entries = entries[: size * rank]
    g = math.gcd(den, *(int(x) for x in entries))
    return den // g, fmpz_mat(rank, size, [x // g for x in entries])
