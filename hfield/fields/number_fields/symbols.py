"""Hilbert symbols over number fields: tame ones by residues, dyadic ones by defects, real ones by signs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import Any

import flint

from hfield.errors import RingError
from hfield.factorisation import NORM_BITS, factorise
from hfield.fields.number_fields.dyadic_symbol import DyadicPrime
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.integers import integral_generator
from hfield.fields.number_fields.places import Place, RealPlace
from hfield.fields.number_fields.prime_ideals import PrimeIdeal, primes_above
from hfield.fields.number_fields.ring import NumberField


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


def _tame(prime: PrimeIdeal, a: FieldElement, b: FieldElement) -> int:
    """Return the symbol above an odd prime: whether (−1)^(v(a)v(b))·u(a)^v(b)·u(b)^v(a) is a square there."""
    (v, u), (w, t) = prime.unit_part(a), prime.unit_part(b)
    if not v % 2:
        if not w % 2:
            return 1
        return _residue_symbol(prime, u)
    if not w % 2:
        return _residue_symbol(prime, t)
    minus = -1 if prime.norm % 4 == 3 else 1
    return minus * _residue_symbol(prime, u) * _residue_symbol(prime, t)


def _residue_symbol(prime: PrimeIdeal, u: FieldElement) -> int:
    """Return 1 if a unit is a square modulo the prime, else −1."""
    residue = prime.residue_of(u)
    if prime.f == 1:
        return int(flint.fmpz(int(residue[0])).jacobi(prime.p))
    # the norm down to GF(p) is a square exactly if the residue is
    norm = int(prime.residue.resultant(residue)) if prime.p < 2**63 else _norm(prime, residue)
    return int(flint.fmpz(norm).jacobi(prime.p))


def _norm(prime: PrimeIdeal, residue: Any) -> int:
    """Return the norm of a residue down to GF(p), as a power."""
    exponent = (prime.norm - 1) // (prime.p - 1)
    return int(residue.pow_mod(exponent, prime.residue)[0])


def candidates(field: NumberField, x: FieldElement) -> set[int]:
    """Return the primes below all prime ideals at which x has a valuation other than 0, and maybe others.

    Raises :class:`UnfactoredError`.
    """
    return {p for n in norms(field, x) for p in factorise(n, sieved=NORM_BITS)}


def norms(field: NumberField, x: FieldElement) -> tuple[int, int, int]:
    """Return integers whose primes are the candidates: a norm, what x is divided by, and what divides it."""
    scale, _ = integral_generator(field)
    terms = [c / flint.fmpq(scale) ** k for k, c in enumerate(x.poly.coeffs())]
    below = math.lcm(*(int(c.q) for c in terms))
    above = math.gcd(*(int((c * below).p) for c in terms))
    return int((x * flint.fmpq(below, above)).norm().p), below, above


def finite_ramified(a: FieldElement, b: FieldElement, primes: set[int]) -> Iterator[PrimeIdeal]:
    """Run through the prime ideals above the given primes with a symbol of −1."""
    for p in sorted(primes):
        for place in primes_above(a.field, p):
            if hilbert_symbol_number_field(a, b, place) < 0:
                yield place


def ramified_places_number_field(a: FieldElement, b: FieldElement) -> tuple[Place, ...]:
    """Return the places where ``(a, b | K)`` does not split: prime ideals ascending, then real places.

    The norms of a and b are factored. Raises :class:`UnfactoredError`.
    """
    field = a.field
    primes = {2} | candidates(field, a) | candidates(field, b)
    real = [v for v in field.real_places() if v.sign(a) < 0 and v.sign(b) < 0]
    return (*finite_ramified(a, b, primes), *real)
