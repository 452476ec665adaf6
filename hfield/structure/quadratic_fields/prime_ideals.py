"""The prime ideals of a quadratic field ℚ(√d), each with its residue field, for :mod:`minimise`.

ω is (1 + √d)/2 where d ≡ 1 mod 4 and √d elsewhere, so that 1 and ω are a basis of the integers. Modulo
a prime ideal P above p, ω is a root r of its minimal polynomial, or generates GF(p²).
"""

from fractions import Fraction
from typing import Any

from hfield.factorisation import remove
from hfield.rings import GF
from hfield.rings.functions import FunctionField
from hfield.rings.quadratic import QuadraticField
from hfield.structure.function_fields.residue_field import ResidueField
from hfield.structure.rationals.prime_numbers import PrimePlace
from hfield.structure.rationals.whole_numbers import fraction, sqrt_mod


def omega(field: QuadraticField) -> Any:
    """Return ω."""
    return (field.gen + 1) * Fraction(1, 2) if field.d % 4 == 1 else field.gen


def coordinates(field: QuadraticField, x: Any) -> tuple[Fraction, Fraction]:
    """Return rationals (u, v) with x = u + v·ω."""
    s, t = fraction(x.terms.get(1, 0)), fraction(x.terms.get(field.d, 0))
    return (s - t, 2 * t) if field.d % 4 == 1 else (s, t)


def conjugate(field: QuadraticField, x: Any) -> Any:
    """Return x with −√d in the place of √d."""
    return field(2 * x.terms.get(1, 0)) - x


def norm(field: QuadraticField, x: Any) -> Fraction:
    """Return the norm of x down to ℚ."""
    return fraction((x * conjugate(field, x)).terms.get(1, 0))


def primes_above(field: QuadraticField, p: int) -> "tuple[PrimeIdeal, ...]":
    """Return the one or two prime ideals above a prime number."""
    trace, constant = _minimal(field)
    if p == 2:
        roots = {r for r in (0, 1) if (r * r - trace * r - constant) % 2 == 0}
    else:
        square = field.d % p
        if square and pow(square, (p - 1) // 2, p) != 1:
            roots = set()
        else:
            root, half = sqrt_mod(square, p), (p + 1) // 2
            shift, step = (half, half) if trace else (0, 1)
            roots = {(shift + s * step * root) % p for s in (1, -1)}
    if not roots:
        return (Inert(field, p),)
    return tuple(DegreeOne(field, p, r, 3 - len(roots)) for r in sorted(roots))


def _minimal(field: QuadraticField) -> tuple[int, int]:
    """Return (t, n) with ω² = t·ω + n."""
    return (1, (field.d - 1) // 4) if field.d % 4 == 1 else (0, field.d)


class DegreeOne(PrimePlace):
    """A prime ideal with residue field ℤ/p: ω goes to r. ``index`` is 2 where p ramifies, else 1.

    ``uniformiser`` and ``inverse_uniformiser`` have valuation 1 and −1 here, and the second is integral at
    all other primes; they are no inverses. ``other`` is integral, and a unit here, but not at the conjugate.
    """

    def __init__(self, field: QuadraticField, p: int, root: int, index: int) -> None:
        super().__init__(p)
        self.number_field, self.prime, self.root, self.index = field, p, root, index
        pi = omega(field) - root
        if remove(int(norm(field, pi)), p)[0] > 1:
            pi = pi + p
        self.other = field.one if index == 2 else conjugate(field, pi)
        self.uniformiser = pi
        self.inverse_uniformiser = conjugate(field, pi) * Fraction(1, p)

    def lift(self, x: int) -> Any:
        """Return a residue as a number of the field."""
        return self.number_field(x)

    def valuation(self, x: Any) -> int:
        """Return the order of a nonzero number at this prime."""
        p = self.modulus
        k = content(self.number_field, x, p)
        y = x * Fraction(p) ** -k
        if self.reduce(y):
            return self.index * k
        return self.index * k + remove(norm(self.number_field, y).numerator, p)[0]

    def reduce(self, x: Any) -> int:
        """Return the class of a number without p in its denominator."""
        u, v = coordinates(self.number_field, x)
        return (super().reduce(u) + super().reduce(v) * self.root) % self.modulus


class Inert(ResidueField):
    """A prime number p that stays prime, with residue field GF(p²)."""

    def __init__(self, field: QuadraticField, p: int) -> None:
        functions = FunctionField(GF(p), "t")
        t, (trace, constant) = functions.gen, _minimal(field)
        super().__init__(functions, (t * t - functions(trace) * t - functions(constant)).num)
        self.number_field, self.prime = field, p
        self.other = field.one

    @property
    def uniformiser(self) -> Any:
        """p."""
        return self.number_field(self.prime)

    @property
    def inverse_uniformiser(self) -> Any:
        """1/p."""
        return self.number_field(Fraction(1, self.prime))

    def lift(self, x: Any) -> Any:
        """Return a residue as a number of the field."""
        return self.number_field(int(x[0])) + omega(self.number_field) * int(x[1])

    def valuation(self, x: Any) -> int:
        """Return the order of a nonzero number at this prime."""
        return content(self.number_field, x, self.prime)

    def reduce(self, x: Any) -> Any:
        """Return the class of a number without p in its denominator."""
        u, v = (self.scalar(self.base(y)) for y in coordinates(self.number_field, x))
        return u + v * self.field.gen.num


def content(field: QuadraticField, x: Any, p: int) -> int:
    """Return the greatest k for which x/pᵏ has no p in the denominator, x ≠ 0."""
    return min(
        remove(y.numerator, p)[0] - remove(y.denominator, p)[0] for y in coordinates(field, x) if y
    )


PrimeIdeal = DegreeOne | Inert
