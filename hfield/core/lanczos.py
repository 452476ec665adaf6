"""Rational eigenvalues of large sparse self-adjoint matrices, by Lanczos' recurrence modulo a prime.

Let T be an n × n matrix over a field, self-adjoint for a diagonal form, and v a vector. Define q₀ = v, qⱼ₊₁ =
T·qⱼ − αⱼ·qⱼ − γⱼ·qⱼ₋₁, each orthogonal to those before. If ⟨qⱼ, qⱼ⟩ ≠ 0 until q_m = 0, then the form is
regular on the span K of the qⱼ. So the space is K ⊕ K^⊥, and both parts are stable under T. On K eigenspaces
have dimension 1, and the eigenvalues are the roots of a polynomial that the recurrence gives; K^⊥ has
dimension n − m. Therefore **the sum of the dimensions of the eigenspaces of T is at most n − m plus the
number of roots** in K. This is a proof over the integers modulo a prime and hence over ℚ, because the
arithmetic is exact and the argument does not depend on the random choice of v. If verified independent
eigenvectors over ℤ reach the bound, there are no others.

An eigenvector for the root a is Σ pⱼ(a)/⟨qⱼ, qⱼ⟩·qⱼ with the polynomials pⱼ of the recurrence, pⱼ(T)·v = qⱼ.
(C. Lanczos, 1950; W. Eberly and E. Kaltofen, "On randomized Lanczos algorithms", 1997.)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

PRIME = 2**31 - 1
"""A prime modulo which numbers are reduced by a shift, and whose products are words."""
BITS = 31
MAX_LIFTED = 2**15 - 1
"""The largest numerator and denominator that are read off a residue; twice its square is below the prime."""
MAX_DENOMINATORS = 40


class BreakdownError(ArithmeticError):
    """A vector of the recurrence is isotropic, so another start vector is needed."""


@dataclass(frozen=True)
class SparseOperator:
    """An integer matrix that is self-adjoint for a diagonal form, as rows padded with zeros to length k.

    ``columns`` and ``entries`` have the shape (k, n), and ``weights`` (n,); several entries of a row may be
    in the same column. Row sums of absolute values are below 2³¹.
    """

    columns: np.ndarray
    entries: np.ndarray
    weights: np.ndarray

    @property
    def size(self) -> int:
        """The number of rows."""
        return len(self.weights)

    def is_self_adjoint(self) -> bool:
        """Return whether weights times entries form a symmetric matrix, exactly."""
        rows = np.broadcast_to(np.arange(self.size), self.columns.shape)
        values = self.entries * self.weights
        here = _summed(rows * self.size + self.columns, values)
        there = _summed(self.columns * self.size + rows, values)
        return all(map(np.array_equal, here, there))

    def times(self, vector: np.ndarray) -> np.ndarray:
        """Return the matrix times a column of integers; values times row sums must fit into words."""
        found: np.ndarray = self.entries[0] * vector[self.columns[0]]
        for columns, entries in zip(self.columns[1:], self.entries[1:], strict=True):
            found += entries * vector[columns]
        return found


def _summed(keys: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the ascending keys whose values have a nonzero sum, and these sums."""
    order = np.argsort(keys, axis=None, kind="stable")
    keys, values = keys.ravel()[order], values.ravel()[order]
    starts = np.flatnonzero(np.diff(keys, prepend=-1))
    sums = np.add.reduceat(values, starts)
    return keys[starts][sums != 0], sums[sums != 0]


@dataclass(frozen=True)
class Recurrence:
    """The numbers α, γ, ⟨q, q⟩ of m vectors, modulo the prime."""

    alphas: list[int]
    gammas: list[int]
    squares: list[int]

    def __len__(self) -> int:
        return len(self.alphas)

    def polynomials(self, a: int) -> list[int]:
        """Return p₀(a), …, p_m(a); a is an eigenvalue if and only if the last is 0."""
        values, before = [1], 0
        for alpha, gamma in zip(self.alphas, self.gammas, strict=True):
            value = values[-1]
            values.append(((a - alpha) * value - gamma * before) % PRIME)
            before = value
        return values


def _half_reduced(x: np.ndarray) -> np.ndarray:
    """Return numbers below 2³³ congruent to numbers in 0, …, 2⁶³ − 1."""
    return (x & PRIME) + (x >> BITS)


def _reduced(x: np.ndarray) -> np.ndarray:
    """Return numbers in 0, …, 2⁶³ − 1 modulo the prime."""
    found = _half_reduced(_half_reduced(x))
    found[found >= PRIME] -= PRIME
    return found


class _Steps:
    """The successive vectors of the recurrence."""

    def __init__(self, operator: SparseOperator, start: np.ndarray) -> None:
        self.operator, self.vector = operator, start
        self._before = np.zeros_like(start)
        sums = np.abs(operator.entries).sum(axis=0)
        self._offset = int(sums.max(initial=0)) * PRIME  # so that no sum is negative

    def image(self) -> np.ndarray:
        """Return the operator times the vector, modulo the prime."""
        return _reduced(self.operator.times(self.vector) + self._offset)

    def step(self, image: np.ndarray, alpha: int, gamma: int) -> None:
        """Compute the next vector."""
        found = _half_reduced(self.vector * (-alpha % PRIME))
        found += _half_reduced(self._before * (-gamma % PRIME))
        found += image
        self._before, self.vector = self.vector, _reduced(found)


def recurrence(operator: SparseOperator, start: np.ndarray) -> Recurrence:
    """Return the numbers of the recurrence from a vector modulo the prime. Raises :class:`BreakdownError`."""
    steps, weights = _Steps(operator, start), operator.weights
    alphas, gammas, squares = list[int](), list[int](), list[int]()
    while steps.vector.any():
        weighted = _reduced(steps.vector * weights)
        square = int(_half_reduced(weighted * steps.vector).sum()) % PRIME
        if not square:
            raise BreakdownError("a vector of the recurrence is isotropic")
        image = steps.image()
        alpha = int(_half_reduced(weighted * image).sum()) * pow(square, -1, PRIME) % PRIME
        gamma = square * pow(squares[-1], -1, PRIME) % PRIME if squares else 0
        alphas.append(alpha)
        gammas.append(gamma)
        squares.append(square)
        steps.step(image, alpha, gamma)
    return Recurrence(alphas, gammas, squares)


def eigenvectors(
    operator: SparseOperator, start: np.ndarray, found: Recurrence, values: Sequence[int]
) -> list[np.ndarray]:
    """Return an eigenvector modulo the prime for each of some roots of a recurrence."""
    if not values:
        return []
    inverses = [pow(square, -1, PRIME) for square in found.squares]
    factors = [
        [p * inverse % PRIME for p, inverse in zip(found.polynomials(a), inverses, strict=False)]
        for a in values
    ]
    sums = [np.zeros_like(start) for _ in values]
    steps = _Steps(operator, start)
    for n, (alpha, gamma) in enumerate(zip(found.alphas, found.gammas, strict=True)):
        for total, row in zip(sums, factors, strict=True):
            total += _half_reduced(steps.vector * row[n])
        if n + 1 < len(found):
            steps.step(steps.image(), alpha, gamma)
    return [total % PRIME for total in sums]


def echelon(vectors: Sequence[np.ndarray]) -> tuple[list[np.ndarray], list[int]]:
    """Return the reduced echelon basis, modulo the prime, of the span of vectors, and its pivots."""
    basis, pivots = list[np.ndarray](), list[int]()
    for vector in vectors:
        rest = vector
        for row, pivot in zip(basis, pivots, strict=True):
            rest = (rest - row * rest[pivot]) % PRIME
        if not rest.any():
            continue
        pivot = int((rest != 0).argmax())
        rest = rest * pow(int(rest[pivot]), -1, PRIME) % PRIME
        basis = [(row - rest * row[pivot]) % PRIME for row in basis]
        basis.append(rest)
        pivots.append(pivot)
    return basis, pivots


def lifted(operator: SparseOperator, vector: np.ndarray, a: int) -> np.ndarray | None:
    """Return an integer multiple v of a vector with T·v = a·v, verified over the integers; or None.

    One coordinate of the vector is 1. Coordinates are fractions with numerators and denominators up to
    MAX_LIFTED; the result is None if one is not.
    """
    for _ in range(MAX_DENOMINATORS):
        numbers = np.where(vector > PRIME // 2, vector - PRIME, vector)
        large = np.flatnonzero(np.abs(numbers) > MAX_LIFTED)
        if not large.size:
            found = numbers // max(int(np.gcd.reduce(numbers)), 1)
            return found if np.array_equal(operator.times(found), a * found) else None
        denominator = _denominator(int(vector[large[0]]))
        if denominator is None:
            return None
        vector = vector * denominator % PRIME
    return None


def _denominator(residue: int) -> int | None:
    """Return the denominator of the small fraction with a residue, or None (P. Wang, 1981)."""
    r, s, t, u = PRIME, residue, 0, 1
    while s > MAX_LIFTED:
        q = r // s
        r, s, t, u = s, r - q * s, u, t - q * u
    return abs(u) if 0 < abs(u) <= MAX_LIFTED else None
