"""Isometries of the pure quaternions of two isomorphic algebras over ℚ, small ones, by lattice reduction.

Let A₀ and B₀ be the quaternions of trace 0. On A₀ ⊥ −B₀ the difference of the norms is a form of
signature (3, 3) that is hyperbolic at every place, hence there is a lattice L on which it is even and
unimodular, made prime by prime. An isometry of A₀ with B₀ is a totally isotropic subspace of dimension 3,
the graph of it. (In division algebras all such subspaces are graphs, for no other vector of A₀ or B₀ than 0
has norm 0.)

Let M be the definite form with the absolute values of the coefficients. On L the least value of M is at
most γ₆/2 < 1, where γ₆ = (64/3)^(1/6) is Hermite's constant, and no less than that of the form, which is
integral: so a shortest vector v is isotropic. The same holds on v⊥/v, where γ₄/2 < 1, and once more,
γ₂/2 < 1. As in Legendre's lattice for conics (:mod:`.conics`), nothing is searched for far,
and nothing grows.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

import flint

from hfield.fields.base.coercion import fmpq
from hfield.fields.linear_algebra.lattice_reduction import Integers, combination, steps_of_gram
from hfield.fields.rationals.whole_numbers import sqrt_mod

if TYPE_CHECKING:
    import flint


Row = list[Fraction]
MAX_COEFFICIENT = 4


def isometry(source: Sequence[int], target: Sequence[int], primes: Iterable[int]) -> list[Row]:
    """Return the rows of a matrix that takes a diagonal form in three variables to another over ℚ.

    Row n holds the image of the n-th basis vector of the source. The forms have squarefree coefficients, are
    isometric, and have no zero but 0; ``primes`` are those of all coefficients.
    """
    form = [*source, *(-g for g in target)]
    basis, gram = _unimodular(form, sorted({2, *primes}))
    return min(map(_graph, _flags(form, basis, gram)), key=_size)


def _size(rows: list[Row]) -> int:
    """Return the length of the longest number."""
    return max(max(abs(x.numerator), x.denominator) for row in rows for x in row)


# --- the lattice -------------------------------------------------------------------------------


def _unimodular(form: list[int], primes: list[int]) -> tuple[list[Row], Integers]:
    """Return a reduced basis of a maximal lattice that contains ℤ⁶, and the bilinear form on it."""
    n = len(form)
    basis = [[Fraction(int(i == j)) for j in range(n)] for i in range(n)]
    gram = [[2 * form[i] if i == j else 0 for j in range(n)] for i in range(n)]
    for p in primes:
        while (v := _divisible(gram, p)) is not None:
            at = next(i for i, x in enumerate(v) if x)
            inverse = pow(v[at], -1, p)
            v = [(x * inverse + p // 2) % p - p // 2 if p > 2 else x for x in v]
            basis[at] = [x / p for x in combination(v, basis)]
            paired = combination(v, gram)
            value = sum(x * y for x, y in zip(v, paired, strict=True))
            for j in range(n):
                gram[at][j] = gram[j][at] = paired[j] // p
            gram[at][at] = value // (p * p)
        basis, gram = _reduced(form, basis, gram)
    return basis, gram


def _divisible(gram: Integers, p: int) -> list[int] | None:
    """Return coordinates modulo p of a v for which ``v/p`` may be added to the lattice, or None."""
    radical = _kernel(gram, p)
    if p == 2:
        for chosen in itertools.product((0, 1), repeat=len(radical)):
            v = [x % 2 for x in combination(chosen, radical)] if any(chosen) else []
            if v and _pair(gram, v, v) % 8 == 0:
                return v
        return None
    free: list[tuple[list[int], int]] = []  # orthogonal vectors, with their values over p
    for r in radical:
        for u, value in free:
            factor = _pair(gram, r, u) // p * pow(value, -1, p)
            r = [(x - factor * y) % p for x, y in zip(r, u, strict=True)]
        value = _pair(gram, r, r) // p % p
        if value == 0:
            return r
        free.append((r, value))
        if len(free) == 3:
            break
    return _zero([u for u, _ in free], [x for _, x in free], p)


def _zero(vectors: Integers, values: list[int], p: int) -> list[int] | None:
    """Return a zero of ``Σ values[i]·x[i]²`` modulo an odd p, combined from the vectors, or None."""
    if len(values) < 2:
        return None
    f, g = values[:2]
    ends = [(1, 0)] if len(values) == 2 else ((y, 1) for y in range(p))
    for y, z in ends:
        rest = -(g * y * y + (values[2] * z if z else 0)) * pow(f, -1, p) % p
        if rest == 0 or flint.fmpz(rest).jacobi(p) == 1:
            x = sqrt_mod(rest, p) if rest else 0
            return [s % p for s in combination([x, y, z][: len(values)], vectors)]
    return None


def _kernel(gram: Integers, p: int) -> Integers:
    """Return a basis of the kernel of a symmetric matrix modulo p."""
    matrix = flint.nmod_mat if p < 2**63 else None
    n = len(gram)
    if matrix is not None:
        kernel, rank = matrix(flint.fmpz_mat(gram), p).nullspace()
        return [[int(kernel[i, j]) for i in range(n)] for j in range(rank)]
    context = flint.fmpz_mod_ctx(p)
    reduced, rank = flint.fmpz_mod_mat(flint.fmpz_mat(gram), context).rref()
    rows = [[int(reduced[i, j]) for j in range(n)] for i in range(rank)]
    pivots = [next(j for j, x in enumerate(row) if x) for row in rows]
    basis = []
    for free in (j for j in range(n) if j not in pivots):
        v = [int(j == free) for j in range(n)]
        for row, pivot in zip(rows, pivots, strict=True):
            v[pivot] = -row[free] % p
        basis.append(v)
    return basis


# --- isotropic subspaces -----------------------------------------------------------------------


def _flags(form: list[int], basis: list[Row], gram: Integers) -> Iterator[list[Row]]:
    """Run through totally isotropic subspaces, those spanned by short vectors first."""
    for u in itertools.islice(_isotropic(form, basis, gram, []), 3):
        for v in itertools.islice(_isotropic(form, basis, gram, [u]), 2):
            for w in itertools.islice(_isotropic(form, basis, gram, [u, v]), 2):
                yield [combination(x, basis) for x in (u, v, w)]


def _isotropic(
    form: list[int], basis: list[Row], gram: Integers, given: Integers
) -> Iterator[list[int]]:
    """Run through short isotropic vectors orthogonal to those given, none of which they depend on."""
    n = len(basis)
    space = [[int(i == j) for j in range(n)] for i in range(n)]
    if given:
        conditions = [[combination(v, gram)[i] for v in given] + space[i] for i in range(n)]
        hermite = flint.fmpz_mat(conditions).hnf().tolist()
        space = [
            [int(x) for x in row[len(given) :]] for row in hermite if not any(row[: len(given)])
        ]
    vectors = [combination(c, basis) for c in space]
    inner = [[_pair(gram, c, d) for d in space] for c in space]
    steps = _steps(form, vectors)
    space = [combination(c, space) for c in steps]
    inner = [[_pair(inner, c, d) for d in steps] for c in steps]
    majorant = _majorant(form, [combination(c, basis) for c in space])
    for most in range(1, MAX_COEFFICIENT + 1):
        zeros = [
            (_pair(majorant, c, c), c)
            for c in itertools.product(range(-most, most + 1), repeat=len(space))
            if max(map(abs, c)) == most and next(x for x in c if x) > 0 and not _pair(inner, c, c)
        ]
        for _, c in sorted(zeros):
            v = combination(c, space)
            if flint.fmpz_mat([*given, v]).rank() > len(given):
                yield v


def _graph(isotropic: list[Row]) -> list[Row]:
    """Return the matrix of which a space is the graph."""
    left = flint.fmpq_mat([list(map(fmpq, v[:3])) for v in isotropic])
    right = flint.fmpq_mat([list(map(fmpq, v[3:])) for v in isotropic])
    return [[Fraction(int(x.p), int(x.q)) for x in row] for row in left.solve(right).tolist()]


# --- reduction ---------------------------------------------------------------------------------


def _reduced(form: list[int], basis: list[Row], gram: Integers) -> tuple[list[Row], Integers]:
    steps = _steps(form, basis)
    return (
        [combination(c, basis) for c in steps],
        [[_pair(gram, c, d) for d in steps] for c in steps],
    )


def _steps(form: list[int], vectors: list[Row]) -> Integers:
    """Return the transformation to a basis that is reduced for the definite form |f₁|x₁² + …."""
    return steps_of_gram(_majorant(form, vectors))


def _majorant(form: list[int], vectors: list[Row]) -> Integers:
    """Return the Gram matrix of the definite form, times the least integer that makes it integral."""
    rows = flint.fmpq_mat([list(map(fmpq, v)) for v in vectors])
    weighted = flint.fmpq_mat(
        [[abs(f) * fmpq(x) for f, x in zip(form, v, strict=True)] for v in vectors]
    )
    numerators, _ = (rows * weighted.transpose()).numer_denom()
    return [[int(x) for x in row] for row in numerators.tolist()]


def _pair(gram: Integers, u: Sequence[int], v: Sequence[int]) -> int:
    return sum(x * y for x, y in zip(u, combination(v, gram), strict=True))
