"""Lattices of full rank as matrices over a denominator: the Hermite form and operations based on it.

Entries are integers, or polynomials over a finite field (:mod:`hfield.orders.domains`).

A lattice is a pair ``(den, rows)``: the row Hermite normal form over the least denominator. This pair is
unique, so two lattices are equal if and only if their pairs are equal (Cohen, *A Course in Computational
Algebraic Number Theory*, section 2.4.2).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import lru_cache

from flint import fmpq_mat, fmpz, fmpz_mat

from hfield.orders.domains import domain_of

Rows = tuple[tuple[int, ...], ...]
MAX_MULTIPLIED_ROWS = 128
"""Matrices with up to so many rows together are stacked by products with matrices of zeros and ones."""


def hermite(den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat] | None:
    """Return the canonical form of the lattice spanned by the rows of an integer matrix over ``den``.

    Return None if the rank is below the number of columns.
    """
    size = matrix.ncols()
    if matrix.nrows() < size:
        return None
    found = matrix.hnf()
    if not found[size - 1, size - 1]:  # of full rank, the pivots are on the diagonal
        return None
    return reduced(den, first_rows(found, size))


def reduced(den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return an integer matrix over ``den``, reduced to the least denominator."""
    found: tuple[int, fmpz_mat] = domain_of(matrix).lowest_terms(den, matrix)
    return found


def first_rows(matrix: fmpz_mat, number: int) -> fmpz_mat:
    """Return the first rows of a matrix."""
    rows = matrix.nrows()
    if rows == number:
        return matrix
    if isinstance(matrix, fmpz_mat):
        return _injection(rows, 0, number).transpose() * matrix
    size = matrix.ncols()
    return domain_of(matrix).matrix(number, size, matrix.entries()[: number * size])


@lru_cache(maxsize=256)
def _injection(rows: int, start: int, number: int) -> fmpz_mat:
    """Return the matrix that embeds rows at ``start`` among rows of zeros."""
    return fmpz_mat([[int(m == start + n) for n in range(number)] for m in range(rows)])


def integral(vectors: Iterable[Sequence[Fraction]]) -> tuple[int, list[list[int]]]:
    """Return rational vectors as integer rows over their least common denominator."""
    rows = [list(v) for v in vectors]
    den = math.lcm(*(x.denominator for row in rows for x in row))
    return den, [[x.numerator * (den // x.denominator) for x in row] for row in rows]


def rational(rows: fmpq_mat) -> tuple[int, fmpz_mat]:
    """Return a rational matrix as an integer matrix over a denominator."""
    whole, den = rows.numer_denom()
    return domain_of(whole).integer(den), whole


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
    return m, domain_of(matrix).integer(d)


def combination(x: Sequence[int], rows: fmpz_mat) -> tuple[int, ...]:
    """Return a combination of the rows of a matrix."""
    domain = domain_of(rows)
    return tuple(map(domain.integer, (domain.matrix([list(x)]) * rows).entries()))


def divided(rows: fmpz_mat, n: int) -> fmpz_mat:
    """Return a matrix divided by a number that divides all entries."""
    return domain_of(rows).divided(rows, n)


def in_coordinates(matrix: fmpz_mat, other: fmpz_mat) -> tuple[fmpz_mat, int]:
    """Return ``(m, d)`` such that ``other`` is m/d times the regular ``matrix``."""
    inv, d = inverse(matrix)
    return other * inv, d


def contains(den: int, matrix: fmpz_mat, row_den: int, row: Sequence[int]) -> bool:
    """Return whether ``row/row_den`` is an integer combination of the rows of ``matrix/den``."""
    rest = []
    for x in row:
        q, r = divmod(x * den, row_den) if x else (x, x)
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
    """Return the rows of a matrix as tuples of ints, or of polynomials."""
    numbers = map(domain_of(matrix).integer, matrix.entries())
    return tuple(zip(*[numbers] * matrix.ncols(), strict=True))


def stacked(*matrices: fmpz_mat) -> fmpz_mat:
    """Return the rows of several matrices, one below the other."""
    if len(matrices) == 1:
        return matrices[0]
    rows = sum(m.nrows() for m in matrices)
    if rows > MAX_MULTIPLIED_ROWS or not isinstance(matrices[0], fmpz_mat):
        entries = [x for m in matrices for x in m.entries()]
        return domain_of(matrices[0]).matrix(rows, matrices[0].ncols(), entries)
    # quicker than to copy the entries, which are objects of Python
    found, start = _injection(rows, 0, matrices[0].nrows()) * matrices[0], matrices[0].nrows()
    for m in matrices[1:]:
        found += _injection(rows, start, m.nrows()) * m
        start += m.nrows()
    return found


def joined(d: int, m: fmpz_mat, e: int, n: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return the rows of two matrices over a common denominator."""
    den = domain_of(m).lcm(d, e)
    if d != e:
        m, n = m * (den // d), n * (den // e)
    return den, stacked(m, n)


def span(den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return the Hermite form of the lattice spanned by the rows of an integer matrix over ``den``, of any
    rank.
    """
    found = matrix.hnf()
    return reduced(den, first_rows(found, found.rank()))
