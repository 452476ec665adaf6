"""Quadratic forms over ℚ: orthogonal bases."""

import itertools
from fractions import Fraction

Vector = list[Fraction]


def _unit(size: int, index: int) -> Vector:
    return [Fraction(int(i == index)) for i in range(size)]


def diagonalise(gram: list[list[Fraction]]) -> tuple[list[Fraction], list[Vector]]:
    """Return the diagonal of a nondegenerate symmetric matrix and the rows of an orthogonal basis."""
    n = len(gram)

    def pair(u: Vector, v: Vector) -> Fraction:
        return sum((u[i] * gram[i][j] * v[j] for i in range(n) for j in range(n)), Fraction(0))

    rest = [_unit(n, i) for i in range(n)]
    values: list[Fraction] = []
    basis: list[Vector] = []
    while rest:
        for i, j in itertools.combinations(range(len(rest)), 2):
            if not any(pair(u, u) for u in rest):
                rest[i] = [x + y for x, y in zip(rest[i], rest[j], strict=True)]
        v = next(u for u in rest if pair(u, u))
        size = pair(v, v)
        rest.remove(v)
        rest = [[x - pair(u, v) / size * y for x, y in zip(u, v, strict=True)] for u in rest]
        values.append(size)
        basis.append(v)
    return values, basis
