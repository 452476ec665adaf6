"""Prime ideals of quadratic number fields with residue fields, for conics, evidence and completions.

They compute with pairs of rational numbers, whereas prime ideals of other number fields use polynomials.
Elements known to some digits are written by them; ω is as in :mod:`.places`.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING

from hfield.core.factorisation import remove
from hfield.fields.finite.names import GF
from hfield.fields.function_fields.residues import ResidueField
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.number_fields.quadratic.places import (
    QuadraticPrime,
    integer_coordinates,
    minimal_of_omega,
)
from hfield.fields.rationals.residues import PrimeResidues, truncated

if TYPE_CHECKING:
    import flint

    from hfield.fields.base.flint_types import Polynomial
    from hfield.fields.number_fields.elements import FieldElement


class DegreeOne(PrimeResidues):
    """A prime ideal with residue field ℤ/p, in which ω becomes ``root``. ``index`` is 2 if p ramifies, else
    1.

    ``uniformiser`` has valuation 1 here and ``inverse_uniformiser`` −1; the second is integral at all other
    primes. They are not inverse to each other.
    """

    def __init__(self, place: QuadraticPrime) -> None:
        super().__init__(place.p)
        self.place, self.number_field, self.index = place, place.field, place.e
        self.root, p = place.root_of_omega, place.p
        F = place.field
        pi = F.integral_basis()[1] - self.root
        if remove(int(F.norm(pi)), p)[0] > 1:
            pi = pi + p
        self._shift, _ = integer_coordinates(place.d, pi)
        self.uniformiser, conjugate = pi, F(F.trace(pi)) - pi
        self.inverse_uniformiser = conjugate * Fraction(1, p)

    def lift(self, x: int) -> FieldElement:
        """Return a residue as a number of the field."""
        return self.number_field(x)

    def valuation(self, x: FieldElement) -> int:
        """Return the valuation of a nonzero number at this prime."""
        return self.place.valuation(x)

    def reduce(self, x: FieldElement) -> int:
        """Return the class of a number that is integral here."""
        u, v = integer_coordinates(self.place.d, x)
        if u.denominator % self.modulus and v.denominator % self.modulus:
            return (self.residue(u) + self.residue(v) * self.root) % self.modulus
        return int(self.near(u, v, 1))

    def truncated(self, x: FieldElement, n: int) -> FieldElement:
        """Return x truncated at the n-th power of the ideal: a rational number, or u + v·π if p ramifies."""
        u, v = integer_coordinates(self.place.d, x)
        if self.index == 1:
            return self.number_field(self.near(u, v, n))
        odd = truncated(v, self.modulus, n // 2)
        return self.uniformiser * odd + truncated(u - v * self._shift, self.modulus, (n + 1) // 2)

    def near(self, u: Fraction, v: Fraction, n: int) -> Fraction:
        """Return the least rational number ≥ 0 that agrees with u + v·ω up to pⁿ, at a prime that splits."""
        trace, constant = minimal_of_omega(self.place.d)
        r, modulus = self.root, self.modulus
        target = self.modulus ** max(n + remove(v.denominator, self.modulus)[0], 1)
        while modulus < target:  # Newton's steps to the root of the minimal polynomial of ω
            modulus *= modulus
            r = (r - (r * r - trace * r - constant) * pow(2 * r - trace, -1, modulus)) % modulus
        return truncated(u + v * r, self.modulus, n)


class Inert(ResidueField):
    """A prime number p that is inert, with residue field GF(p²)."""

    index = 1

    def __init__(self, place: QuadraticPrime) -> None:
        p, (trace, constant) = place.p, minimal_of_omega(place.d)
        functions = FunctionField(GF(p), "t")
        t = functions.gen
        super().__init__(functions, (t * t - functions(trace) * t - functions(constant)).num)
        self.place, self.below, self.omega = place, p, place.field.integral_basis()[1]
        self._p, self._inverse = place.field(p), place.field(Fraction(1, p))

    @property
    def uniformiser(self) -> FieldElement:
        """p."""
        return self._p

    @property
    def inverse_uniformiser(self) -> FieldElement:
        """1/p."""
        return self._inverse

    def lift(self, x: flint.nmod_poly) -> FieldElement:
        """Return a residue as a number of the field."""
        return self.place.field(int(x[0])) + self.omega * int(x[1])

    def valuation(self, x: FieldElement) -> int:
        """Return the valuation of a nonzero number at this prime."""
        return self.place.valuation(x)

    def truncated(self, x: FieldElement, n: int) -> FieldElement:
        """Return u + v·ω with the least u, v ≥ 0 that agrees with x up to pⁿ."""
        u, v = (truncated(c, self.below, n) for c in integer_coordinates(self.place.d, x))
        return self.omega * v + u

    def reduce(self, x: FieldElement) -> Polynomial:
        """Return the class of a number whose denominator p does not divide."""
        u, v = (self.scalar(self.base(y)) for y in integer_coordinates(self.place.d, x))
        return u + v * self.field.gen.num


@lru_cache(maxsize=256)
def prime_at(place: QuadraticPrime) -> DegreeOne | Inert:
    """Return the prime ideal of a finite place."""
    return Inert(place) if place.f == 2 else DegreeOne(place)
