"""Hilbert symbols over number fields: tame symbols by residues, dyadic ones by defects, real ones by signs.

At prime ideals above 2, however ramified, every unit is a square times 1 + γ, where the valuation d of γ is
as large as possible. Either d is odd and below 2e; or d = 2e, and then the root of the unit is unramified; or
the unit is a square (O'Meara, *Introduction to Quadratic Forms*, §63). Two identities reduce every symbol to
these cases: (1 + γ, −γ) = 1, and, because (x, y) = 1 if x + y = 1,

    (1 + γ, 1 + δ) = (1 − γδ, γ(1 + γ)(1 + δ)),

whose first entry is closer to 1 than both. A unit matters only modulo P^(2e+1), so numbers stay small.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property, lru_cache

import flint

from hfield.core.factorisation import NORM_BITS, factorise
from hfield.errors import RingError
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.integers import integral_generator
from hfield.fields.number_fields.places import Place, RealPlace
from hfield.fields.number_fields.prime_ideals import PrimeIdeal, primes_above
from hfield.fields.number_fields.ring import NumberField

DIGITS = 2**6  # 2⁶ lies in P^(2e+1), with a margin for divisions by uniformisers


class DyadicPrime:
    """A prime ideal above 2, with data for the square classes of its completion.

    Up to squares, numbers are written ϖᵛ·u, where ϖ is the inverse of ``P.inverse_uniformiser``.
    """

    def __init__(self, prime: PrimeIdeal) -> None:
        self.prime, self.e = prime, prime.e
        self.one: FieldElement = prime.field.one
        self._inverse = prime.inverse_uniformiser

    def symbol(self, a: FieldElement, b: FieldElement) -> int:
        """Return the Hilbert symbol of two nonzero numbers."""
        (i, u), (j, w) = self._class(a), self._class(b)
        if j:
            if i:  # (a, b) = (a, −ab)
                w = self._cut(-u * w)
            else:
                i, u, w = j, w, u
        return self._unit_symbol(i, u, w)

    def _class(self, x: FieldElement) -> tuple[int, FieldElement]:
        """Return the parity of the valuation of x, and the remaining unit, up to squares."""
        v, unit = self.prime.unit_part(x)
        return v % 2, self._cut(self.prime.integral(unit))

    def _unit_symbol(self, i: int, u: FieldElement, w: FieldElement) -> int:
        """Return the symbol of ϖⁱ·u and w, for units u and w."""
        while True:
            d, gamma = self.defect(w)
            if d > 2 * self.e:
                return 1
            if d == 2 * self.e:
                return -1 if i else 1
            leading = self._cut(gamma * self._powers[d])
            if i:
                i, u = 0, self._cut(-u * leading)
            d, delta = self.defect(u)
            if d >= 2 * self.e:
                return 1
            w, u, i = (
                self._cut(self.one - gamma * delta),
                self._cut(leading * self._cut((self.one + gamma) * (self.one + delta))),
                1,
            )

    def defect(self, u: FieldElement) -> tuple[int, FieldElement]:
        """Return ``(d, γ)`` such that u is 1 + γ up to a square; d, the valuation of γ, is the defect.

        It is 2e + 1 for a square.
        """
        prime = self.prime
        root = self._root(prime.residue_of(u))
        u = self._times_square(u, prime.lift(self._invert(root)))
        while True:
            gamma = u - self.one
            d = self._valuation(gamma)
            if d > 2 * self.e or (d < 2 * self.e and d % 2):
                return d, gamma
            leading = prime.residue_of(self._cut(gamma * self._powers[d]))
            if d == 2 * self.e:
                split = self._has_trace_0(leading * self._invert(self._four) % prime.residue)
                return (d + 1 if split else d), gamma
            u = self._times_square(u, self.one + self._with_leading(d // 2, self._root(leading)))

    def square_class(self, x: FieldElement) -> int:
        """Return the unit part of x modulo squares as e·f + 1 binary digits, a homomorphism.

        They are the exponents of 1 + ω·ϖᵈ, for ω in a basis of the residue field and odd d below 2e, and of a
        unit of defect 2e.
        """
        prime, found = self.prime, 0
        _, u = self._class(x)
        while True:
            d, gamma = self.defect(u)
            if d >= 2 * self.e:
                return found | (d == 2 * self.e) << (self.e * prime.f)
            u = self.one + gamma
            leading = prime.residue_of(self._cut(gamma * self._powers[d]))
            for n, c in enumerate(leading.coeffs()):
                if c:
                    found |= 1 << (d // 2 * prime.f + n)
                    basis = flint.nmod_poly([0] * n + [1], 2)
                    u = self._cut(u * (self.one + self._with_leading(d, basis)))

    @cached_property
    def _powers(self) -> list[FieldElement]:
        """The powers of 1/ϖ, up to the exponent 2e."""
        powers = [self.one]
        for _ in range(2 * self.e):
            powers.append(powers[-1] * self._inverse)
        return powers

    @cached_property
    def _four(self) -> flint.nmod_poly:
        """The residue of 4/ϖ^(2e)."""
        return self.prime.residue_of(self._powers[2 * self.e] * 4)

    def _valuation(self, x: FieldElement) -> int:
        """Return the valuation of an integer, at most 2e + 1."""
        order = self.prime.order
        for k in range(2 * self.e + 1):
            if not x:
                break
            x = x * self._inverse
            if order.content(x) < 0:
                return k
        return 2 * self.e + 1

    def _with_leading(self, k: int, residue: flint.nmod_poly) -> FieldElement:
        """Return an integer x of valuation k for which x/ϖᵏ has the given residue."""
        prime = self.prime
        ratio = prime.residue_of(prime.uniformiser * self._inverse)
        scale = self._invert(ratio.pow_mod(k, prime.residue))
        x: FieldElement = prime.lift(residue * scale % prime.residue)
        for _ in range(k):
            x = self._cut(x * prime.uniformiser)
        return x

    def _times_square(self, u: FieldElement, s: FieldElement) -> FieldElement:
        return self._cut(u * self._cut(s * s))

    def _cut(self, x: FieldElement) -> FieldElement:
        return self.prime.order.truncated(x, DIGITS)

    def _root(self, x: flint.nmod_poly) -> flint.nmod_poly:
        """Return the square root of an element of the residue field, which has 2^f elements."""
        return x.pow_mod(2 ** (self.prime.f - 1), self.prime.residue)

    def _invert(self, x: flint.nmod_poly) -> flint.nmod_poly:
        return x.pow_mod(2**self.prime.f - 2, self.prime.residue)

    def _has_trace_0(self, x: flint.nmod_poly) -> bool:
        """Return whether t² + t = x has a root, that is, whether the trace of x is 0."""
        total = x
        for _ in range(self.prime.f - 1):
            x = x * x % self.prime.residue
            total = total + x
        return bool(total == 0)


def hilbert_symbol_number_field(a: FieldElement, b: FieldElement, place: Place) -> int:
    """Return the Hilbert symbol of two nonzero elements at a place: 1 or −1. Nothing is factored."""
    if not a or not b:
        raise RingError(
            "a Hilbert symbol is defined for nonzero numbers only, and one of these is 0"
        )
    if isinstance(place, PrimeIdeal):
        return _dyadic(place).symbol(a, b) if place.p == 2 else _tame(place, a, b)
    if isinstance(place, RealPlace):
        return -1 if place.sign(a) < 0 and place.sign(b) < 0 else 1
    return 1


@lru_cache(maxsize=256)
def _dyadic(prime: PrimeIdeal) -> DyadicPrime:
    return DyadicPrime(prime)


def square_class(prime: PrimeIdeal, x: FieldElement) -> int:
    """Return the unit part of x modulo squares: one binary digit at an odd prime, e·f + 1 above 2."""
    if prime.p == 2:
        return _dyadic(prime).square_class(x)
    return int(residue_symbol(prime, prime.unit_part(x)[1]) < 0)


def _tame(prime: PrimeIdeal, a: FieldElement, b: FieldElement) -> int:
    """Return the symbol above an odd prime: 1 if (−1)^(v(a)v(b))·u(a)^v(b)·u(b)^v(a) is a square there, else
    −1.
    """
    (v, u), (w, t) = prime.unit_part(a), prime.unit_part(b)
    if not v % 2:
        if not w % 2:
            return 1
        return residue_symbol(prime, u)
    if not w % 2:
        return residue_symbol(prime, t)
    minus = -1 if prime.norm() % 4 == 3 else 1
    return minus * residue_symbol(prime, u) * residue_symbol(prime, t)


def residue_symbol(prime: PrimeIdeal, u: FieldElement) -> int:
    """Return 1 if a unit is a square modulo the prime, else −1."""
    residue = prime.residue_of(u)
    if prime.f == 1:
        return int(flint.fmpz(int(residue[0])).jacobi(prime.p))
    # the norm down to GF(p) is a square exactly if the residue is
    norm = int(prime.residue.resultant(residue)) if prime.p < 2**63 else _norm(prime, residue)
    return int(flint.fmpz(norm).jacobi(prime.p))


def _norm(prime: PrimeIdeal, residue: flint.fmpz_mod_poly) -> int:
    """Return the norm of a residue down to GF(p), as a power."""
    exponent = (prime.norm() - 1) // (prime.p - 1)
    return int(residue.pow_mod(exponent, prime.residue)[0])


def candidates(field: NumberField, x: FieldElement) -> set[int]:
    """Return primes that include all those below prime ideals at which x has nonzero valuation.

    Raises :class:`UnfactoredError`.
    """
    return {p for n in norms(field, x) for p in factorise(n, sieved=NORM_BITS)}


def norms(field: NumberField, x: FieldElement) -> tuple[int, int, int]:
    """Return a norm, a denominator and the content of x; their prime divisors are the candidates."""
    scale, _ = integral_generator(field)
    terms = [c / flint.fmpq(scale) ** k for k, c in enumerate(x.poly.coeffs())]
    below = math.lcm(*(int(c.q) for c in terms))
    above = math.gcd(*(int((c * below).p) for c in terms))
    return int((x * flint.fmpq(below, above)).norm().p), below, above


def finite_ramified(a: FieldElement, b: FieldElement, primes: set[int]) -> Iterator[PrimeIdeal]:
    """Yield the prime ideals above the given primes at which the symbol is −1."""
    for p in sorted(primes):
        for place in primes_above(a.field, p):
            if hilbert_symbol_number_field(a, b, place) < 0:
                yield place


def ramified_places_number_field(a: FieldElement, b: FieldElement) -> tuple[Place, ...]:
    """Return the places at which ``(a, b | K)`` does not split: prime ideals in ascending order, then real
    places.

    The norms of a and b are factored. Raises :class:`UnfactoredError`.
    """
    field = a.field
    primes = {2} | candidates(field, a) | candidates(field, b)
    real = [v for v in field.real_places() if v.sign(a) < 0 and v.sign(b) < 0]
    return (*finite_ramified(a, b, primes), *real)
