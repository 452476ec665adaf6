"""The residue field ℤ/p of ℚ, with the same names as ``ResidueField``."""

from fractions import Fraction

import flint

from hfield.factorisation import remove
from hfield.structure.rationals.whole_numbers import sqrt_mod


class PrimePlace:
    """The place of ℚ at a prime p; elements of the residue field are ints modulo p."""

    zero, one = 0, 1

    def __init__(self, p: int) -> None:
        self.modulus = p
        self.even = p == 2
        self.uniformiser, self.inverse_uniformiser = Fraction(p), Fraction(1, p)

    def lift(self, x: int) -> Fraction:
        """Return a residue as a rational number."""
        return Fraction(x)

    def valuation(self, x: Fraction) -> int:
        """Return the order of a nonzero rational number at p."""
        return remove(x.numerator, self.modulus)[0] - remove(x.denominator, self.modulus)[0]

    def reduce(self, x: Fraction) -> int:
        """Return the class of a rational number whose denominator p does not divide."""
        return x.numerator * self.inverse(x.denominator) % self.modulus

    def multiply(self, x: int, y: int) -> int:
        """Return x·y."""
        return x * y % self.modulus

    def inverse(self, x: int) -> int:
        """Return 1/x for x ≠ 0."""
        return pow(x, -1, self.modulus)

    def sqrt(self, x: int) -> int | None:
        """Return a square root of x, or None when there is none."""
        x %= self.modulus
        if x and not self.even and flint.fmpz(x).jacobi(self.modulus) != 1:
            return None
        return sqrt_mod(x, self.modulus) if x else 0

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
