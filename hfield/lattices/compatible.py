"""Products I·J of a right and a left ideal of one order, by linear algebra modulo the norm of J.

Where J is locally principal, ``J = O·α + O·n`` for n = N(J) and any α in J with N(α)/n prime to n,
and so ``I·J = I·α + I·n`` (Voight, *Quaternion Algebras*, section 16.3). In coordinates over I that
is the row space of one 4 × 4 matrix modulo n: where it is free of rank 2 its echelon form is a basis,
and no Hermite form of sixteen rows is needed.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from flint import fmpz, fmpz_mat

from hfield.lattices import hermite

if TYPE_CHECKING:
    from hfield.lattices.ideal import Ideal


def product(first: Ideal, second: Ideal) -> tuple[int, Any] | None:
    """Return ``first·second`` in Hermite form, or None where this way does not do.

    ``first`` is a right ideal and ``second`` a left ideal of the same order.
    """
    r = first._regular
    n, fraction = divmod(int(second._content[0]), r.scale * second._den**2)
    if fraction or n == 1 or not second._invertible:
        return None
    if not hermite.contains(second._den, second._matrix, 1, (n, 0, 0, 0)):  # it is not integral
        return None
    alpha = _generator(second, n)
    if alpha is None:
        return None
    image = first._matrix * r.right_matrix(alpha)
    scale, modulus = fmpz(r.scale * second._den), fmpz(n)
    triangle = first._matrix.entries()
    entries = image.entries()
    rows = (
        _coordinates([x // scale for x in entries[m : m + 4]], triangle, modulus)
        for m in (0, 4, 8, 12)
    )
    steps = _echelon(rows, modulus)
    if steps is None:
        return None
    return hermite.hermite(first._den, fmpz_mat(steps) * first._matrix)


def _coordinates(row: list[Any], triangle: list[Any], n: Any) -> list[Any]:
    """Return integer coordinates with respect to the rows of a triangular matrix, modulo n."""
    found = []
    for m in range(4):
        c = row[m] // triangle[5 * m]
        found.append(c % n)
        if c:
            for k in range(m + 1, 4):
                row[k] -= c * triangle[4 * m + k]
    return found


def _generator(ideal: Ideal, n: int) -> tuple[int, ...] | None:
    """Return a row α of the ideal with N(α)/n prime to n; with another the two pivots would not be units."""
    content, entries = ideal._content
    for m in range(4):
        if math.gcd(int(entries[5 * m]) // (2 * int(content)), n) == 1:
            return tuple(int(ideal._matrix[m, k]) for k in range(4))
    return None


def _echelon(rows: Iterator[list[Any]], n: Any) -> list[list[Any]] | None:
    """Return two of the rows, reduced, with n·ℤ⁴ as a triangular basis of index n².

    The product lies above and has this index, so the other rows add nothing. None where a pivot is no unit.
    """
    basis = [[n * (i == j) for j in range(4)] for i in range(4)]
    done = -1
    for found in rows:
        row = found
        if done >= 0 and (f := row[done]):
            row = [(x - f * y) % n for x, y in zip(row, basis[done], strict=True)]
        column = next((m for m in range(4) if row[m]), None)
        if column is None:
            continue
        if row[column].gcd(n) != 1:
            return None
        inverse = pow(row[column], -1, n)  # flint's integers invert ten times faster
        basis[column] = [x * inverse % n for x in row]
        if done >= 0:
            return basis
        done = column
    return None
