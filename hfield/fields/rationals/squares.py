"""Integers as sums of two and three squares, found by search (Rabin and Shallit, 1986)."""

from fractions import Fraction
from math import isqrt
from typing import Protocol, Self, TypeVar

import flint

from hfield.core.primality import is_probable_prime
from hfield.core.product import Scalar


class RationalMultiples(Scalar, Protocol):
    """An element of a field that contains ℚ."""

    def __add__(self, other: Self | int | Fraction, /) -> Self:
        """Return self + other."""

    def __sub__(self, other: Self | int | Fraction, /) -> Self:
        """Return self − other."""

    def __mul__(self, other: Self | int | Fraction, /) -> Self:
        """Return self·other."""


S = TypeVar("S", bound=RationalMultiples)

MAX_SEARCHED_SQUARES = 10**6  # below this, two squares are searched one by one


def three_squares(n: int) -> tuple[int, int, int] | None:
    """Return a ≥ b ≥ c ≥ 0 with a² + b² + c² = n, or None, which occurs for n = 4ᵏ(8m + 7)."""
    if n == 0:
        return 0, 0, 0
    if n % 4 == 0:
        parts = three_squares(n // 4)
        return None if parts is None else (2 * parts[0], 2 * parts[1], 2 * parts[2])
    if n % 8 == 7:
        return None
    for a in range(isqrt(n), -1, -1):
        pair = two_squares(n - a * a)
        if pair is not None:
            x, y, z = sorted((a, *pair), reverse=True)
            return x, y, z
    raise AssertionError("every n not of the form 4^k(8m+7) is a sum of three squares (Legendre)")


def minus_one(m: int, w: S) -> tuple[S, ...]:
    """Return squares that add up to −1, given w with w² = −m, m > 1: two of them, or four if m ≡ 7 mod 8.

    With m = a² + b² + c² the formula is ((wb + ac)² + (wc − ab)²)/(b² + c²)² = −1. If m is not a sum of three
    squares, it is a sum of four squares, each of which is divided by w².
    """
    parts = three_squares(m)
    if parts is None:  # then m − 1 is one
        return tuple(w * Fraction(-n, m) for n in (*(three_squares(m - 1) or ()), 1))
    a, b, c = parts
    scale = Fraction(1, b * b + c * c) if b or c else Fraction(1)
    return (w * b + a * c) * scale, (w * c - a * b) * scale


def two_squares(n: int) -> tuple[int, int] | None:
    """Return b, c with b² + c² = n; None if there are none, or if n is large and not twice a prime."""
    if n < MAX_SEARCHED_SQUARES:
        for b in range(isqrt(n), isqrt(n // 2) - 1, -1):
            c = isqrt(n - b * b)
            if b * b + c * c == n:
                return b, c
        return None
    if n % 2 == 0:
        half = two_squares(n // 2)
        return None if half is None else (half[0] + half[1], abs(half[0] - half[1]))
    if n % 4 != 1 or not is_probable_prime(n):
        return None
    b, c = n, int(flint.fmpz(n - 1).sqrtmod(n))  # Cornacchia: run Euclid down to √n
    while c * c > n:
        b, c = c, b % c
    b = isqrt(n - c * c)
    return (c, b) if b * b + c * c == n else None
