"""Decide whether a number is a square modulo prime powers, and whether a quadratic order is maximal at p."""

from __future__ import annotations


def is_square_modulo(d: int, p: int, e: int) -> bool:
    """Return whether d is a square modulo pᵉ."""
    v = 0
    while v < e and d % p == 0:
        d, v = d // p, v + 1
    if v == e:
        return True
    if v % 2:
        return False
    return d % 2 ** min(3, e - v) == 1 if p == 2 else pow(d, (p - 1) // 2, p) == 1


def is_maximal_at(d: int, p: int) -> bool:
    """Return whether the quadratic order of discriminant d is maximal at p, that is, p does not divide its
    conductor.
    """
    return d % (p * p) != 0 or d // (p * p) % 4 > 1
