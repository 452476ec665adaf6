"""Products I·J of a right and a left ideal of one order, by linear algebra modulo the norm of J.

If J is locally principal, ``J = O·α + O·n`` for n = N(J) and any α in J with N(α)/n prime to n. So ``I·J =
I·α + I·n`` (Voight, *Quaternion Algebras*, section 16.3). In coordinates over I this product is the row space
of one 4 × 4 matrix modulo n. If the row space is free of rank 2, its echelon form gives a basis, and no
Hermite form of sixteen rows is needed.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from flint import fmpz, fmpz_mat

from hfield.orders import hermite, lattice_values
from hfield.orders.lattice_values import LatticeValue

PAIRS = list(combinations(range(4), 2))


def product(first: LatticeValue, second: LatticeValue, order: LatticeValue) -> LatticeValue:
    """Return ``first·second`` for a right ideal and a left ideal of an order."""
    return first.ambient.kernels.choose(_by_basis, rank4=_quick)(first, second, order)


def _by_basis(first: LatticeValue, second: LatticeValue, order: LatticeValue) -> LatticeValue:
    return lattice_values.product(first, second)


def _quick(first: LatticeValue, second: LatticeValue, order: LatticeValue) -> LatticeValue:
    return modulo_norm(first, second, order) or lattice_values.product(first, second)


def modulo_norm(
    first: LatticeValue, second: LatticeValue, order: LatticeValue
) -> LatticeValue | None:
    """Return ``first·second`` for a right and a left ideal of an order over ℤ; None if this method fails."""
    r = first.ambient
    n = _index_root(second, order)
    # since 1 is in n⁻¹·J, the index determines that J is O where n is a unit, and O·α elsewhere
    if n is None or not hermite.contains(second.den, second.matrix, 1, (int(n), 0, 0, 0)):
        return None
    alpha = _generator(second, n)
    if alpha is None:
        return None
    image = (first.matrix * r.right_matrix(alpha)).entries()
    scale = fmpz(r.scale * second.den)
    triangle = first.matrix.entries()
    rows = (
        _coordinates([x // scale for x in image[m : m + 4]], triangle, n) for m in (0, 4, 8, 12)
    )
    steps = _echelon(rows, n)
    if steps is None:
        return None
    return lattice_values.hermite_form(
        first.ambient, first.den, fmpz_mat(4, 4, steps) * first.matrix
    )


def _coordinates(row: list[fmpz], triangle: list[fmpz], n: fmpz) -> list[fmpz]:
    """Return integer coordinates with respect to the rows of a triangular matrix, modulo n."""
    found = []
    for m in range(4):
        c = row[m] // triangle[5 * m]
        found.append(c % n)
        if c:
            for k in range(m + 1, 4):
                row[k] -= c * triangle[4 * m + k]
    return found


def _index_root(ideal: LatticeValue, order: LatticeValue) -> fmpz | None:
    """Return n > 1 with [O : J] = n², or None; the norm of J, if J is locally principal."""
    volume = hermite.volume(ideal.matrix) * order.den**4
    index, rest = divmod(volume, hermite.volume(order.matrix) * ideal.den**4)
    n = index.isqrt()
    return n if n > 1 and not rest and n * n == index else None


def _generator(ideal: LatticeValue, n: fmpz) -> tuple[fmpz, ...] | None:
    """Return a row α of the ideal with N(α)/n prime to n; for other α the two pivots would not be units."""
    r, entries = ideal.ambient, ideal.matrix.entries()
    unit = r.scale * ideal.den**2 * n
    for m in (0, 4, 8, 12):
        row = entries[m : m + 4]
        norm, rest = divmod(r.norm_trace(row), unit)
        if not rest and norm.gcd(n) == 1:
            return tuple(row)
    return None


def _echelon(rows: Iterator[list[fmpz]], n: fmpz) -> list[fmpz] | None:
    """Return the entries of a basis of the row space plus n·ℤ⁴, of index n²: two rows, and twice n.

    The lattice contains the product and has this index, so two rows with a minor that is a unit modulo n span
    it. None if there are none.
    """
    before: list[list[fmpz]] = []
    for second in rows:
        for first in before:
            for p, q in PAIRS:
                minor = (first[p] * second[q] - first[q] * second[p]) % n
                if minor and minor.gcd(n) == 1:
                    return _reduced(first, second, p, q, pow(minor, -1, n), n)
        before.append(second)
    return None


def _reduced(first: list[fmpz], second: list[fmpz], p: int, q: int, u: fmpz, n: fmpz) -> list[fmpz]:
    """Make columns p and q of two rows those of the identity matrix; u is the inverse of their minor."""
    a, b, c, d = first[p] * u % n, first[q] * u % n, second[p] * u % n, second[q] * u % n
    found = [0] * 16
    for m in range(4):
        if m in (p, q):
            found[5 * m] = 1
        else:
            x, y = first[m], second[m]
            found[4 * p + m], found[4 * q + m] = (d * x - b * y) % n, (a * y - c * x) % n
            found[5 * m] = n
    return found
