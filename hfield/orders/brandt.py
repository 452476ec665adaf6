"""Brandt matrices over any base, from neighbours, Hecke relations or elements of given norm."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from functools import reduce
from itertools import product as pairs
from operator import mul
from typing import TYPE_CHECKING

from flint import fmpz_mat, fmpz_poly, nmod_mat

from hfield.core.progress import track
from hfield.core.sparse_rows import SparseRows
from hfield.errors import TooLargeError, shorten
from hfield.orders.base_values import BaseIdeal, Prime
from hfield.orders.classes import Classes
from hfield.orders.ideals_of_norm import (
    MAX_LISTED_IDEALS,
    is_maximal_or_eichler,
    local_generator,
    number_maximal,
    of_prime_power_norm,
    two_sided_prime,
)
from hfield.orders.invariants import eichler_symbol, good_primes
from hfield.orders.lattice_values import (
    add,
    add_rows,
    discriminant,
    inverse,
    product,
    times_ideal,
)
from hfield.orders.short_elements import rows_of_norm

if TYPE_CHECKING:
    import numpy as np

Matrix = list[list[int]]
MAX_NORM = 10**5
"""The largest norm of ideals that are counted by their elements."""
MODULUS = 2**31 - 1
"""A prime of half a word, larger than every entry that is computed modulo it."""
MAX_MATRIX_BYTES = 2 * 10**9
"""Brandt matrices that take more memory are not filled."""
ENTRY_BYTES = 16
"""An entry is a word in the matrix, and one in the list that is returned."""
MAX_UNSPLIT = 60
"""The polynomial of a matrix of so many rows takes less time than to see which classes are exchanged."""


def matrix_bytes(classes: int) -> int:
    """Return the approximate memory of a Brandt matrix with this number of classes, in bytes."""
    return ENTRY_BYTES * classes**2


def expect_matrix_fits(classes: int) -> None:
    """Raise :class:`TooLargeError` for a Brandt matrix that takes too much memory."""
    if matrix_bytes(classes) > MAX_MATRIX_BYTES:
        raise TooLargeError(
            f"the Brandt matrix of {classes} classes has {classes**2} entries and would take about "
            f"{matrix_bytes(classes) / 1e9:.1f} GB, and at most {MAX_MATRIX_BYTES / 1e9:.0f} GB are filled: "
            "C.neighbour_counts(P) has the entries that are not 0, row by row, for a prime P; "
            "from the shell, hfield brandt --format edges, with a prime, writes them"
        )


def brandt_matrix(classes: Classes, norm: BaseIdeal) -> fmpz_mat:
    """Return the Brandt matrix of an integral ideal: (i, j) counts the ideals of this norm in I_i in class j.

    Invertible ideals with this relative norm are counted. Raises :class:`TooLargeError`.
    """
    expect_matrix_fits(len(classes))
    factors = classes.ambient.base.factorisation(norm)
    if not factors:
        return identity(classes)
    return reduce(mul, (prime_power(classes, P, e) for P, e in factors))


def brandt_lists(classes: Classes, norm: BaseIdeal) -> Matrix:
    """Return the Brandt matrix as lists of ints, from listed neighbours without a matrix if they
    are known.
    """
    expect_matrix_fits(len(classes))
    factors = classes.ambient.base.factorisation(norm)
    if [e for _, e in factors] != [1] or not _is_listed(classes, factors[0][0]):
        return dense(brandt_matrix(classes, norm))
    table = [[0] * len(classes) for _ in range(len(classes))]
    for line, row in zip(table, classes.neighbours(factors[0][0]), strict=True):
        for j, times in row.items():
            line[j] = times
    return table


def identity(classes: Classes) -> fmpz_mat:
    """Return the Brandt matrix of 1."""
    size = range(len(classes))
    return fmpz_mat([[int(i == j) for j in size] for i in size])


def prime_power(classes: Classes, P: Prime, e: int) -> fmpz_mat:
    """Return the Brandt matrix of Pᵉ. Raises :class:`TooLargeError`.

    Away from the discriminant it is computed with the classes of P·I (Voight, section 41.3). If the algebra
    ramifies at P and the order is maximal there, it is a power. For other orders not of level P, either the
    ideals of norm Pᵉ are listed, if they are few, or elements are counted.
    """
    expect_matrix_fits(len(classes))
    base, ambient = classes.ambient.base, classes.ambient
    exponent, ramified = base.valuation(discriminant(classes.order), P), P in ambient.ramified
    if not exponent:
        central = of_permutation(classes.multiplied(base.prime_ideal(P))) if e > 1 else 1
        return of_power(of_prime(classes, P), central * base.absolute_norm(base.prime_ideal(P)), e)
    if e == 1 or (exponent == 1 and ramified):
        return of_rows(classes.neighbours(P)) ** e
    if exponent == 1:
        return _at_level(classes, P, e)
    if not ramified and _is_short(classes, P, e):
        return _by_listing(classes, P, e)
    return by_elements(classes, base.prime_ideal(P) ** e)


def of_prime(classes: Classes, P: Prime) -> fmpz_mat:
    """Return the Brandt matrix of a prime that does not divide the discriminant."""
    return _by_commuting(classes, P) or of_rows(classes.neighbours(P))


def of_rows(rows: Sequence[Mapping[int, int]]) -> fmpz_mat:
    """Return the matrix whose rows are given as dictionaries from classes to counts."""
    expect_matrix_fits(len(rows))
    found = fmpz_mat(len(rows), len(rows))
    for i, row in enumerate(rows):
        for j, times in row.items():
            found[i, j] = times
    return found


def of_permutation(moved: Sequence[int]) -> fmpz_mat:
    """Return the matrix of a permutation of the classes."""
    return of_rows([Counter([n]) for n in moved])


def of_power(step: fmpz_mat, weight: fmpz_mat | int, e: int) -> fmpz_mat:
    """Return T(Pᵉ), e ≥ 1, by T(Pᵏ⁺¹) = T(P)·T(Pᵏ) − T(Pᵏ⁻¹)·weight (Voight, 41.2)."""
    if e == 1:
        return step
    before, current = step**0, step
    for _ in range(e - 1):
        before, current = current, step * current - before * weight
    return current


def _at_level(classes: Classes, P: Prime, e: int) -> fmpz_mat:
    """Return the Brandt matrix of Pᵉ for an order that is Eichler of level P at P.

    The ideals of norm P are the radical W, and ideals whose sum with W is one of the two maximal ideals. Let
    U and V be the Brandt matrices of these two kinds. The Brandt matrix of Pᵉ is Dₑ + W·Dₑ₋₁ with Dₑ = Uᵉ +
    Vᵉ + central·Dₑ₋₂, where Dₑ counts the ideals of diagonal matrices (the affine Weyl group of GL₂).
    """
    radical, ideals = two_sided_prime(classes.order, P), classes.at_prime(P).ideals
    sums = [add(ideal, radical) for ideal in ideals]
    first = next(lattice for lattice in sums if lattice != radical)
    kinds = [0 if radical == M else 1 if first == M else 2 for M in sums]
    rows: list[list[Counter[int]]] = [[], [], []]
    for n in track(range(len(classes)), len(classes), "rows"):
        found = classes.classes_inside(n, P)
        for kind, some in enumerate(rows):
            some.append(Counter(c for c, k in zip(found, kinds, strict=True) if k == kind))
    W, U, V = map(of_rows, rows)
    central = of_permutation(classes.multiplied(classes.ambient.base.prime_ideal(P)))
    diagonal = [U * 0, U**0]
    for k in range(1, e + 1):
        diagonal.append(U**k + V**k + central * diagonal[-2])
    return diagonal[-1] + W * diagonal[-2]


def _is_short(classes: Classes, P: Prime, e: int) -> bool:
    """Return whether listing the ideals of norm Pᵉ is faster than comparing all pairs of classes."""
    if eichler_symbol(classes.order, P) != 1:
        return False
    base, h = classes.ambient.base, len(classes)
    number = number_maximal(base.absolute_norm(base.prime_ideal(P)), e)
    # to count elements takes as long as to look up some five classes
    return number**2 <= MAX_LISTED_IDEALS and number**2 + 6 * h * number <= 5 * h * h


def _by_listing(classes: Classes, P: Prime, e: int) -> fmpz_mat:
    """Return the Brandt matrix of Pᵉ by listing the ideals of this norm in the order and moving them."""
    order, ambient = classes.order, classes.ambient
    ideal = ambient.base.prime_ideal(P) ** e
    found, rows = of_prime_power_norm(order, P, e), []
    for n in track(range(len(classes)), len(classes), "rows"):
        lattice = classes.lattice(n)
        moved = ambient.times(local_generator(lattice, P), "left")
        below = times_ideal(lattice, ideal)
        inside = (add_rows(below, K.rows * moved) for K in found)
        rows.append(Counter(map(classes.class_of, inside)))
    return of_rows(rows)


def by_elements(classes: Classes, norm: BaseIdeal) -> fmpz_mat:
    """Return the Brandt matrix of an ideal for any order, by counting x modulo units with x·I_j inside I_i.

    N(x) generates norm·N(I_i)/N(I_j). Among all x·u with u a unit of the base, exactly one of ±x has as its
    norm one of the totally positive generators modulo squares of units. Raises :class:`TooLargeError`.
    """
    base, keys = classes.ambient.base, classes.keys
    if base.absolute_norm(norm) > MAX_NORM:
        raise TooLargeError(
            f"there are too many ideals of norm {shorten(norm)} in an order neither maximal nor of "
            "level P at its primes: there they are counted by their elements"
        )
    ideals = enumerate(keys.narrow.ideals)
    generators = {
        (m, n): next(iter(base.generators(norm * a / b, base.real_places)), None)
        for (m, a), (n, b) in pairs(ideals, repeat=2)
    }
    size = range(len(classes))
    lattices = list(map(classes.lattice, size))
    inverses = list(map(inverse, lattices))
    table = [[0] * len(classes) for _ in size]
    for i in track(size, len(classes), "rows"):
        for j in size:
            I, J = classes.norms[i], classes.norms[j]
            generator = generators[I.number, J.number]
            if generator is not None:
                between = product(lattices[i], inverses[j])
                values = (generator * u * I.element / J.element for u in keys.units)
                found = sum(1 for x in values for _ in rows_of_norm(between, x))
                table[i][j] = found // classes.units[j]
    return fmpz_mat(table)


def _is_listed(classes: Classes, P: Prime) -> bool:
    """Return whether the neighbours at a prime are known, or few enough that listing them is fastest."""
    base, h = classes.ambient.base, len(classes)
    number = base.absolute_norm(base.prime_ideal(P)) + 1
    return classes.has_rows(P) or number < 12 + h * h // 40_000 or number >= MODULUS


def _by_commuting(classes: Classes, P: Prime) -> fmpz_mat | None:
    """Return the Brandt matrix of a prime from one of its rows, or None if that row does not determine it.

    B(P) commutes with T = B(Q), where Q is the least prime away from the discriminant. If K has the rows v,
    vT, vT², …, then K·B(P) has the rows w, wT, wT², … for w = v·B(P). So B(P) is determined if K is
    invertible modulo a prime larger than N(P) + 1, which bounds the entries. The vector v is the unit vector
    of one class.
    """
    base, h = classes.ambient.base, len(classes)
    if _is_listed(classes, P):
        return None
    Q = next(good_primes(classes.order))
    if Q == P:
        return None
    import numpy as np

    entries = sorted(
        (j, i, t) for i, row in enumerate(classes.neighbours(Q)) for j, t in row.items()
    )
    columns, rows, times = np.array(entries).T
    starts = np.flatnonzero(np.diff(columns, prepend=-1))  # each class is a neighbour of some

    def orbit(v: np.ndarray, kept: list[int]) -> nmod_mat:
        found = []
        for _ in kept:
            found.append(v[kept])
            v = np.add.reduceat(v[rows] * times, starts) % MODULUS
        return nmod_mat(len(kept), len(kept), np.concatenate(found).tolist(), MODULUS)

    # a matrix that commutes with the exchange of classes maps even vectors to even ones and odd to
    # odd
    swap = np.array(_involution(classes, base.prime_ideal(P)))
    n = next((n for n in range(h // 2, h) if swap[n] != n), h // 2)
    v, w = np.zeros(h, dtype=np.int64), np.zeros(h, dtype=np.int64)
    v[n] = 1
    for j, t in classes.neighbours_of(n, P).items():
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
        # B[i, j] ± B[swapped i, j]; a single term if the swap fixes i
        part = np.array([int(x) for x in found.entries()]).reshape(len(kept), len(kept))
        whole = np.zeros((len(kept), h), dtype=np.int64)
        whole[:, kept] = part
        whole[:, swap[kept]] = sign * part
        matrix[kept] += whole
        matrix[swap[kept]] += sign * whole
    matrix = np.where(matrix % 2, matrix + MODULUS, matrix) // 2 % MODULUS
    return fmpz_mat(h, h, matrix.ravel().tolist())


def _involution(classes: Classes, norm: BaseIdeal) -> list[int]:
    """Return an involution of the classes that commutes with the Brandt matrix of an ideal.

    It is multiplication by the two-sided prime ideal at a prime that does not divide the norm, or the
    identity.
    """
    base, h = classes.ambient.base, range(len(classes))
    off = {P for P, _ in base.factorisation(norm)}
    for Q, e in base.factorisation(discriminant(classes.order)):
        if Q not in off and is_maximal_or_eichler(classes.order, Q, e):
            swap = classes.exchanged(Q)
            if all(swap[swap[i]] == i for i in h):
                return swap
    return list(h)


def hecke_polynomial(classes: Classes, norm: BaseIdeal) -> list[int]:
    """Return the characteristic polynomial of the Brandt matrix, low degree first.

    If a two-sided prime ideal exchanges classes, the polynomial is a product of two factors, one for each
    Atkin–Lehner sign. Raises :class:`TooLargeError`.
    """
    expect_matrix_fits(len(classes))
    h = range(len(classes))
    swap = _involution(classes, norm) if len(h) > MAX_UNSPLIT else list(h)
    if all(swap[i] == i for i in h):
        found = brandt_matrix(classes, norm).charpoly()
        return [int(c) for c in fmpz_poly(found).coeffs()]
    rows = brandt_rows(classes, norm)
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


def brandt_rows(classes: Classes, norm: BaseIdeal) -> SparseRows:
    """Return the nonzero entries of a Brandt matrix, row by row; for a prime they are few."""
    factors = classes.ambient.base.factorisation(norm)
    if len(factors) == 1 and factors[0][1] == 1:
        return classes.neighbours(factors[0][0])
    return sparse(brandt_matrix(classes, norm))


def sparse(matrix: fmpz_mat) -> SparseRows:
    """Return the nonzero entries of a matrix, row by row."""
    rows, size = SparseRows(), range(matrix.ncols())
    for i in range(matrix.nrows()):
        rows.append({j: c for j in size if (c := int(matrix[i, j]))})
    return rows


def dense(matrix: fmpz_mat) -> Matrix:
    """Return a matrix as lists of ints, without a second copy as flint integers."""
    size = range(matrix.ncols())
    return [[int(matrix[i, j]) for j in size] for i in range(matrix.nrows())]
