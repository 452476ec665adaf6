"""Brandt matrices: by ideals of prime power norm, the relations of the Hecke algebra, or theta series."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Any

from flint import fmpz_mat, fmpz_poly, nmod_mat

from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime, primes
from hfield.core.progress import track
from hfield.orders.ideals_of_norm import MAX_LISTED_IDEALS, number_maximal
from hfield.orders.invariants import eichler_symbol

if TYPE_CHECKING:
    from hfield.orders.classes import Classes

Matrix = list[list[int]]


def brandt_matrix(classes: Classes, n: int) -> Matrix:
    """Return the Brandt matrix of n.

    At a prime it is made by neighbours; ``B(pᵏ⁺¹) = B(p)·B(pᵏ) − p·B(pᵏ⁻¹)`` off the discriminant (Voight,
    41.2), without the last term where the algebra ramifies. At a prime of the level all ideals of norm pᵉ are
    listed where they are few, and theta series answer otherwise, and for orders of any other kind.
    """
    factors = []
    for p, e in factorise(n).items():
        if classes.ring.level % p == 0:
            if _few(classes, p, e):
                factors.append(_matrix(classes.power_neighbours(p, e)))
            else:
                factors.append(fmpz_mat(by_theta_series(classes, p**e)))
        else:
            factors.append(_prime_power(classes, p, e))
    if not factors:
        factors.append(_identity(classes))
    product = factors[0]
    for factor in factors[1:]:
        product = product * factor
    return [[int(x) for x in row] for row in product.tolist()]


def _few(classes: Classes, p: int, e: int) -> bool:
    """Tell whether it is quicker to list the ideals of norm pᵉ than to look between all pairs of classes."""
    if eichler_symbol(classes.ring, p) != 1:
        return False
    h, number = len(classes), number_maximal(p, e)
    # a theta series takes as long as some five intersections or classes looked up
    return number**2 <= MAX_LISTED_IDEALS and number**2 + 6 * h * number <= 5 * h * h


def _identity(classes: Classes) -> fmpz_mat:
    h = range(len(classes))
    return fmpz_mat([[int(i == j) for j in h] for i in h])


def _matrix(rows: list[Counter[int]]) -> fmpz_mat:
    return fmpz_mat([[row[j] for j in range(len(rows))] for row in rows])


MODULUS = 2**31 - 1
"""A prime of half a word, larger than every entry that is computed modulo it."""


def _by_commuting(classes: Classes, p: int) -> fmpz_mat | None:
    """Return the Brandt matrix of a prime from one row of it, or None where that row is not enough.

    B(p) commutes with T = B(q), q the least prime off the discriminant. So if v, vT, vT², … are the
    rows of K, those of K·B(p) are w, wT, wT², … for w = v·B(p); with K invertible modulo
    a prime above p + 1, which bounds the entries, B(p) is known. v stands for one class.
    """
    discriminant, h = classes.ring.discriminant, len(classes)
    if (
        p in classes.rows
        or discriminant % p == 0
        or p + 1 < 12 + h * h // 40_000
        or p + 1 >= MODULUS
    ):
        return None  # where there are few neighbours listing them is quicker
    q = next(q for q in primes() if discriminant % q)
    if q == p:
        return None
    import numpy as np

    entries = sorted(
        (j, i, t) for i, row in enumerate(classes.neighbours(q)) for j, t in row.items()
    )
    columns, rows, times = np.array(entries).T
    starts = np.flatnonzero(np.diff(columns, prepend=-1))  # each class is a neighbour of some

    def orbit(v: Any, kept: list[int]) -> nmod_mat:
        found = []
        for _ in kept:
            found.append(v[kept])
            v = np.add.reduceat(v[rows] * times, starts) % MODULUS
        return nmod_mat(len(kept), len(kept), np.concatenate(found).tolist(), MODULUS)

    # what commutes with the exchange of classes maps even and odd vectors to such
    swap = np.array(_exchanged(classes))
    n = next((n for n in range(h // 2, h) if swap[n] != n), h // 2)
    v, w = np.zeros(h, dtype=np.int64), np.zeros(h, dtype=np.int64)
    v[n] = 1
    for j, t in classes.neighbours_of(n, p).items():
        w[j] = t
    matrix = np.zeros((h, h), dtype=np.int64)
    for sign in (1, -1):
        kept = [i for i in range(h) if (i <= swap[i] if sign > 0 else i < swap[i])]
        if not kept:
            continue
        both = ((x + sign * x[swap]) % MODULUS for x in (v, w))
        known, wanted = (orbit(x, kept) for x in both)
        try:
            found = known.solve(wanted)
        except ZeroDivisionError:  # v lies in a part that T leaves to itself
            return None
        # B[i, j] ± B[swapped i, j]; once, where i is not swapped
        part = np.array([int(x) for x in found.entries()]).reshape(len(kept), len(kept))
        whole = np.zeros((len(kept), h), dtype=np.int64)
        whole[:, kept] = part
        whole[:, swap[kept]] = sign * part
        matrix[kept] += whole
        matrix[swap[kept]] += sign * whole
    matrix = np.where(matrix % 2, matrix + MODULUS, matrix) // 2 % MODULUS
    return fmpz_mat(h, h, matrix.ravel().tolist())


def _exchanged(classes: Classes) -> list[int]:
    """Return an involution of the classes with which Brandt matrices off the discriminant commute."""
    h, swap = range(len(classes)), classes.exchanged
    return swap if all(swap[swap[i]] == i for i in h) else list(h)


def hecke_polynomial(classes: Classes, n: int) -> list[int]:
    """Return the characteristic polynomial of the Brandt matrix, low degree first.

    Classes that a two-sided prime ideal exchanges make it a product of two (the signs of Atkin and Lehner).
    """
    h = range(len(classes))
    swap = _exchanged(classes) if len(h) > FEW and classes.ring.discriminant % n else list(h)
    if all(swap[i] == i for i in h):
        found = fmpz_mat(classes.brandt_matrix(n)).charpoly()
        return [int(c) for c in fmpz_poly(found).coeffs()]
    sparse = is_prime(n)
    rows = (
        classes.neighbours(n)
        if sparse
        else [Counter(dict(enumerate(row))) for row in classes.brandt_matrix(n)]
    )
    found = fmpz_poly([1])
    for sign in (1, -1):
        kept = [i for i in h if (i <= swap[i] if sign > 0 else i < swap[i])]
        place = {i: k for k, i in enumerate(kept)}
        table = [[0] * len(kept) for _ in kept]
        for line, i in zip(table, kept, strict=True):
            for j, times in rows[i].items():
                first = min(j, swap[j])
                if first in place:
                    line[place[first]] += times if first == j else sign * times
        found *= fmpz_mat(table).charpoly()
    return [int(c) for c in found.coeffs()]


FEW = 60
"""The polynomial of a matrix of so many rows takes less time than to see which classes are exchanged."""


def _prime_power(classes: Classes, p: int, e: int) -> fmpz_mat:
    step = _by_commuting(classes, p) or _matrix(classes.neighbours(p))
    return of_power(step, p if classes.ring.discriminant % p else 0, e)


def of_power(step: fmpz_mat, weight: fmpz_mat | int, e: int) -> fmpz_mat:
    """Return T(pᵉ) of T(pᵏ⁺¹) = T(p)·T(pᵏ) − T(pᵏ⁻¹)·weight, e at least 1 (Voight, 41.2)."""
    before, current = step**0, step
    for _ in range(e - 1):
        before, current = current, step * current - before * weight
    return current


def by_theta_series(classes: Classes, n: int) -> Matrix:
    """Return the Brandt matrix by counting vectors of norm n between all pairs of classes."""
    units = classes.unit_counts
    h = range(len(classes))
    rows = track(h, len(h), "rows")
    return [[classes.theta_series(i, j, n)[n] // units[j] for j in h] for i in rows]


def number_of_ideals(classes: Classes, n: int) -> int:
    """Return how many integral right ideals of norm n, prime to the level, an Eichler order has."""
    found = 1
    for p, e in factorise(n).items():
        found *= sum(p**k for k in range(e + 1)) if classes.ring.ambient.discriminant % p else 1
    return found
