"""Finite abelian groups given by relations, as products of cyclic groups (Smith's normal form)."""

from __future__ import annotations

import math
from collections.abc import Sequence

import flint


class AbelianGroup:
    """ℤᵏ modulo the rows of a matrix of full rank, as a product of cyclic groups."""

    def __init__(self, rows: Sequence[Sequence[int]], k: int) -> None:
        self.k = k
        diagonal, self._into, self._outof = _smith([list(map(int, r)) for r in rows], k)
        self._at = [i for i, d in enumerate(diagonal) if d != 1]
        self.invariants = tuple(diagonal[i] for i in self._at)
        self.order = math.prod(self.invariants)

    def coordinates(self, vector: Sequence[int]) -> tuple[int, ...]:
        """Return the coordinates of a vector in the cyclic factors."""
        out = [sum(vector[j] * self._into[j][i] for j in range(self.k)) for i in self._at]
        return tuple(c % d for c, d in zip(out, self.invariants, strict=True))

    @property
    def generators(self) -> list[list[int]]:
        """One vector for each cyclic factor."""
        return [self._outof[i] for i in self._at]


def _smith(m: list[list[int]], k: int) -> tuple[list[int], list[list[int]], list[list[int]]]:
    """Return d, V and V⁻¹ with U·M·V diagonal and d₁ | d₂ | …, where M has k columns and rank k."""
    v = [[int(i == j) for j in range(k)] for i in range(k)]
    w = [[int(i == j) for j in range(k)] for i in range(k)]
    m = [list(map(int, row)) for row in flint.fmpz_mat(m).hnf().tolist()[:k]] if k else []

    def columns(i: int, j: int, q: int) -> None:
        """Subtract q times column i from column j."""
        for row in (*m, *v):
            row[j] -= q * row[i]
        w[i] = [a + q * b for a, b in zip(w[i], w[j], strict=True)]

    def swap(i: int, j: int) -> None:
        for row in (*m, *v):
            row[i], row[j] = row[j], row[i]
        w[i], w[j] = w[j], w[i]

    for t in range(k):
        while True:
            _, r, c = min((abs(m[r][c]), r, c) for r in range(t, k) for c in range(t, k) if m[r][c])
            m[t], m[r] = m[r], m[t]
            if c != t:
                swap(t, c)
            for r in range(t + 1, k):
                q = m[r][t] // m[t][t]
                m[r] = [a - q * b for a, b in zip(m[r], m[t], strict=True)]
            for c in range(t + 1, k):
                columns(t, c, m[t][c] // m[t][t])
            if any(m[r][t] for r in range(t + 1, k)) or any(m[t][t + 1 :]):
                continue
            bad = next(
                (r for r in range(t + 1, k) if any(x % m[t][t] for x in m[r][t + 1 :])), None
            )
            if bad is None:
                break
            m[t] = [a + b for a, b in zip(m[t], m[bad], strict=True)]
    return [abs(m[t][t]) for t in range(k)], v, w
