"""Matrices of fractions, inverted by elimination."""

from fractions import Fraction

from hfield.checker.budget import spend
from hfield.checker.scalars.rationals import QQ


def inverse_matrix(rows: list[list[Fraction]]) -> list[list[Fraction]] | None:
    """Return the inverse of a square matrix; None if there is none."""
    n = len(rows)
    spend(n**2)
    both = [[*row, *(Fraction(i == k) for i in range(n))] for k, row in enumerate(rows)]
    for k in range(n):
        pivot = next((r for r in range(k, n) if both[r][k]), None)
        if pivot is None:
            return None
        both[k], both[pivot] = both[pivot], both[k]
        below = 1 / both[k][k]
        both[k] = [QQ.mul(c, below) for c in both[k]]
        for r in range(n):
            if r != k and both[r][k]:
                c = -both[r][k]
                both[r] = [QQ.add(a, QQ.mul(c, b)) for a, b in zip(both[r], both[k], strict=True)]
    return [row[n:] for row in both]
