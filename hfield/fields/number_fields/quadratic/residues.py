"""The prime ideals of a quadratic field ℚ(√d), each with its residue field, for :mod:`minimal_conics`.

ω is (1 + √d)/2 where d ≡ 1 mod 4 and √d elsewhere, so that 1 and ω are a basis of the integers. Modulo
a prime ideal P above p, ω is a root r of its minimal polynomial, or generates GF(p²).
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from hfield.factorisation import remove
from hfield.fields.function_fields.residues import ResidueField
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.rationals.residues import PrimePlace, truncated
from hfield.rings.field_specs import GF

if TYPE_CHECKING:
    import flint

    from hfield.fields.number_fields.quadratic.places import QuadraticPlace
    from hfield.fields.number_fields.quadratic.ring import QuadraticField
    from hfield.rings.closed_fields.surds import Surd
    from hfield.rings.flint_types import Polynomial


def omega(field: QuadraticField) -> Surd:
    """Return ω."""
    return (field.gen + 1) * Fraction(1, 2) if field.d % 4 == 1 else field.gen


def coordinates(field: QuadraticField, x: Surd) -> tuple[Fraction, Fraction]:
    """Return rationals (u, v) with x = u + v·ω."""
    s, t = _coefficient(x, 1), _coefficient(x, field.d)
    return (s - t, 2 * t) if field.d % 4 == 1 else (s, t)


def conjugate(field: QuadraticField, x: Surd) -> Surd:
    """Return x with −√d in the place of √d."""
    return field(2 * x.terms.get(1, 0)) - x


def norm(field: QuadraticField, x: Surd) -> Fraction:
    """Return the norm of x down to ℚ."""
    return _coefficient(x * conjugate(field, x), 1)


def _coefficient(x: Surd, n: int) -> Fraction:
    """Return the coefficient of √n."""
    c = x.terms.get(n)
    return Fraction(0) if c is None else Fraction(int(c.p), int(c.q))


def primes_above(field: QuadraticField, p: int) -> tuple[PrimeIdeal, ...]:
    """Return the one or two prime ideals above a prime number."""
    trace, constant = _minimal(field)
    if p == 2:
        roots = {r for r in (0, 1) if (r * r - trace * r - constant) % 2 == 0}
    else:
        root, half = PrimePlace(p).sqrt(field.d), (p + 1) // 2
        shift, step = (half, half) if trace else (0, 1)
        roots = set() if root is None else {(shift + s * step * root) % p for s in (1, -1)}
    if not roots:
        return (Inert(field, p),)
    return tuple(DegreeOne(field, p, r, 3 - len(roots)) for r in sorted(roots))


def _minimal(field: QuadraticField) -> tuple[int, int]:
    """Return (t, n) with ω² = t·ω + n."""
    return (1, (field.d - 1) // 4) if field.d % 4 == 1 else (0, field.d)


def prime_at(field: QuadraticField, place: QuadraticPlace) -> PrimeIdeal:
    """Return the prime ideal that a finite place is."""
    above = primes_above(field, place.prime)
    if place.root is None:
        return above[0]
    root = place.root if field.d % 4 != 1 else (place.root + 1) * (place.prime + 1) // 2
    root = (place.root + 1) // 2 if place.prime == 2 else root
    return next(P for P in above if isinstance(P, DegreeOne) and P.root == root % place.prime)


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

    def lift(self, x: int) -> Surd:
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
        """Return the class of a number that is integral here."""
        u, v = coordinates(self.number_field, x)
        if u.denominator % self.modulus and v.denominator % self.modulus:
            return (super().reduce(u) + super().reduce(v) * self.root) % self.modulus
        return int(self._rational(u, v, 1))

    def truncated(self, x: Any, n: int) -> Any:
        """Return what x is up to the n-th power of the ideal: rational, or u + v·π where p ramifies."""
        field = self.number_field
        u, v = coordinates(field, x)
        if self.index == 1:
            return field(self._rational(u, v, n))
        shift, _ = coordinates(field, omega(field) - self.uniformiser)
        odd = truncated(v, self.modulus, n // 2)
        return self.uniformiser * odd + truncated(u + v * shift, self.modulus, (n + 1) // 2)

    def _rational(self, u: Fraction, v: Fraction, n: int) -> Fraction:
        """Return the least rational number ≥ 0 that is u + v·ω up to pⁿ, at a prime that splits."""
        trace, constant = _minimal(self.number_field)
        r, modulus = self.root, self.modulus
        target = self.modulus ** max(n + remove(v.denominator, self.modulus)[0], 1)
        while modulus < target:  # Newton's steps to the root of the minimal polynomial of ω
            modulus *= modulus
            r = (r - (r * r - trace * r - constant) * pow(2 * r - trace, -1, modulus)) % modulus
        return truncated(u + v * r, self.modulus, n)


class Inert(ResidueField):
    """A prime number p that stays prime, with residue field GF(p²)."""

    def __init__(self, field: QuadraticField, p: int) -> None:
        functions = FunctionField(GF(p), "t")
        t, (trace, constant) = functions.gen, _minimal(field)
        super().__init__(functions, (t * t - functions(trace) * t - functions(constant)).num)
        self.number_field, self.prime = field, p
        self.other = field.one
        self.index, self.below = 1, p

    @property
    def uniformiser(self) -> Surd:
        """p."""
        return self.number_field(self.prime)

    @property
    def inverse_uniformiser(self) -> Surd:
        """1/p."""
        return self.number_field(Fraction(1, self.prime))

    def lift(self, x: flint.nmod_poly) -> Surd:
        """Return a residue as a number of the field."""
        return self.number_field(int(x[0])) + omega(self.number_field) * int(x[1])

    def valuation(self, x: Surd) -> int:
        """Return the order of a nonzero number at this prime."""
        return content(self.number_field, x, self.prime)

    def truncated(self, x: Surd, n: int) -> Surd:
        """Return u + v·ω with the least u, v ≥ 0 that is x up to pⁿ."""
        u, v = (truncated(c, self.prime, n) for c in coordinates(self.number_field, x))
        return omega(self.number_field) * v + u

    def reduce(self, x: Surd) -> Polynomial:
        """Return the class of a number without p in its denominator."""
        u, v = (self.scalar(self.base(y)) for y in coordinates(self.number_field, x))
        return u + v * self.field.gen.num


def content(field: QuadraticField, x: Surd, p: int) -> int:
    """Return the greatest k for which x/pᵏ has no p in the denominator, x ≠ 0."""
    return min(
        remove(y.numerator, p)[0] - remove(y.denominator, p)[0] for y in coordinates(field, x) if y
    )


PrimeIdeal = DegreeOne | Inert
