"""Places whose residues are the integers modulo a number, or the elements of a finite field.

Over ℚ and ℚ(√d) an odd n need not be a prime. If a Jacobi symbol (D/n) is −1, some prime p divides n an odd
number of times and D is not a square modulo p. The valuation is that of such a p; elements that are integral
at n are integral at p. Some elements that are integral at p may be treated as not integral, which can only
cause a rejection.
"""

from fractions import Fraction
from math import gcd

from hfield.checker.budget import spend, spend_inverse, spend_products
from hfield.checker.rejection import an_integer, reject, shown
from hfield.checker.scalars.finite import Finite, Residues
from hfield.checker.scalars.place import E, Place, R

MAX_BITS = 3_300
GF2 = Residues(2, True, "GF(2)")


def two_or_odd(value: object) -> int:
    """Read 2 or an odd number greater than 2."""
    n = an_integer(value, "a place", 2)
    if n.bit_length() > MAX_BITS or (n != 2 and n % 2 == 0):
        reject(f"{shown(n)} is not a place, or too large: expected 2 or an odd number")
    return n


def jacobi(a: int, n: int) -> int:
    """Return the Jacobi symbol (a/n) for an odd n > 0, by the law of reciprocity."""
    spend(10 + n.bit_length() ** 2 // 100)
    a, sign = a % n, 1
    while a:
        while a % 2 == 0:
            a //= 2
            if n % 8 in (3, 5):
                sign = -sign
        if a % 4 == n % 4 == 3:
            sign = -sign
        a, n = n % a, a
    return sign if n == 1 else 0


def modulo(x: Fraction, n: int) -> int | None:
    """Return the class of a rational number, or None if its denominator is not prime to n."""
    spend_products([n], [x.numerator, x.denominator])
    if gcd(x.denominator, n) > 1:
        return None
    spend_inverse(n)
    return x.numerator * pow(x.denominator, -1, n) % n


class ModuloNumber(Place[E, int]):
    """A place whose residues are the integers modulo n."""

    n: int

    def is_unit(self, residue: int) -> bool:
        """Return whether x is prime to n."""
        return gcd(residue, self.n) == 1

    def is_irreducible(self, trace: int, norm: int) -> bool:
        """Return whether the discriminant is not a square; modulo 2 only X² + X + 1 is irreducible."""
        if self.n == 2:
            return GF2.is_irreducible(trace, norm)
        return jacobi(trace * trace - 4 * norm, self.n) == -1


class OverFiniteField(Place[E, R]):
    """A place whose residues are the elements of a finite field."""

    residues: Finite[R]

    def is_unit(self, residue: R) -> bool:
        """Return whether the residue is nonzero."""
        return not self.residues.is_zero(residue)

    def is_irreducible(self, trace: R, norm: R) -> bool:
        """Return whether X² − trace·X + norm is irreducible over the residue field."""
        return self.residues.is_irreducible(trace, norm)
