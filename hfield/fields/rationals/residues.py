"""The residue field ℤ/p of ℚ, with the same names as ``ResidueField``."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.core.factorisation import remove

if TYPE_CHECKING:
    from hfield.core.product import Scalar
    from hfield.fields.base.flint_types import Rational


class PrimeResidues:
    """The residue field ℤ/p of a place; its elements are ints modulo p."""

    zero, one = 0, 1
    index = 1  # the valuation of p

    def __init__(self, p: int) -> None:
        self.below = self.modulus = self.order = p
        self.even = p == 2

    def over_prime_field(self) -> list[int]:
        """Return a basis of the residue field over the field with p elements."""
        return [self.one]

    def residue(self, x: Rational) -> int:
        """Return the class of a rational number whose denominator p does not divide."""
        return int(x.numerator) * self.inverse(int(x.denominator)) % self.modulus

    def random(self, rng: Random) -> int:
        """Return a random residue."""
        return rng.randrange(self.modulus)

    def multiply(self, x: int, y: int) -> int:
        """Return x·y."""
        return x * y % self.modulus

    def inverse(self, x: int) -> int:
        """Return 1/x for x ≠ 0."""
        return pow(x, -1, self.modulus)

    def sqrt(self, x: int) -> int | None:
        """Return a square root of x, or None if there is none."""
        x %= self.modulus
        if x and not self.even and flint.fmpz(x).jacobi(self.modulus) != 1:
            return None
        return x if x < 2 else int(flint.fmpz(x).sqrtmod(self.modulus))

    def quadratic_root(self, a: int, b: int, c: int) -> tuple[int, int] | None:
        """Return ``(x, y)`` ≠ (0, 0) with ``a·x² + b·xy + c·y² = 0`` modulo p, or None."""
        p = self.modulus
        a, b, c = a % p, b % p, c % p
        if self.even:
            points = ((1, 0), (0, 1), (1, 1))
            return next(
                (v for v in points if (a * v[0] + b * v[0] * v[1] + c * v[1]) % 2 == 0), None
            )
        if a == 0:
            return 1, 0
        h = b * self.inverse(2) % p
        root = self.sqrt(h * h - a * c)
        return None if root is None else ((root - h) % p, a)


class PrimePlace(PrimeResidues):
    """The place of ℚ at a prime p.

    Rational numbers are created by ``number(over, under)``, such as Fractions or flint's.
    """

    reduce = PrimeResidues.residue

    def __init__(self, p: int, number: Callable[..., Scalar] = Fraction) -> None:
        super().__init__(p)
        self._number = number
        self.uniformiser, self.inverse_uniformiser = number(p), number(1, p)

    def lift(self, x: int) -> Scalar:
        """Return a residue as a rational number."""
        return self._number(x)

    def valuation(self, x: Rational) -> int:
        """Return the valuation of a nonzero rational number at p."""
        over, under = int(x.numerator), int(x.denominator)
        return remove(over, self.modulus)[0] - remove(under, self.modulus)[0]

    def truncated(self, x: flint.fmpq, n: int) -> Fraction:
        """Return the least number ≥ 0 that agrees with x up to pⁿ, with a power of p as denominator."""
        return truncated(x, self.modulus, n)


def truncated(x: Rational, p: int, n: int) -> Fraction:
    """Return the least rational number ≥ 0 that agrees with x up to pⁿ, with a power of p as denominator."""
    k, below = remove(int(x.denominator), p)
    if n + k <= 0:
        return Fraction(0)
    modulus = p ** (n + k)
    return Fraction(int(x.numerator) * pow(below, -1, modulus) % modulus, p**k)
