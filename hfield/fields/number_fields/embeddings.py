"""The complex embeddings of a number field, signs, and square roots in the field."""

from __future__ import annotations

from functools import lru_cache
from itertools import islice
from typing import TYPE_CHECKING

import flint

from hfield.core.primality import primes
from hfield.errors import UndecidedError
from hfield.fields.base.balls import precision
from hfield.fields.base.isolated_roots import START, IsolatedRoots

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ring import NumberField

MAX_BITS = 1 << 20
REJECTING_PRIMES = 12


class ComplexEmbeddings(IsolatedRoots):
    """The complex embeddings of a field: roots of its polynomial, and values of elements there."""

    def value(self, poly: flint.fmpq_poly, index: int, bits: int) -> flint.acb:
        """Return a ball around the value of a polynomial at a root."""
        root = self.at(bits)[index]
        with precision(bits):
            return flint.acb_poly(poly)(root)

    def sign(self, poly: flint.fmpq_poly, index: int) -> int:
        """Return the sign at a real root of a polynomial that does not vanish there."""
        bits = START
        while bits <= MAX_BITS:
            value = self.value(poly, index, bits).real
            if value > 0:
                return 1
            if value < 0:
                return -1
            bits *= 2
        raise UndecidedError(f"a sign was not decided with {MAX_BITS} bits")

    def close(self, poly: flint.fmpq_poly, index: int, digits: int) -> flint.acb:
        """Return a ball around the value with ``digits`` correct decimal digits."""
        wanted = int(digits * 3.33) + 2
        bits = max(START, wanted + 32)
        while bits <= MAX_BITS:
            value = self.value(poly, index, bits)
            if poly == 0 or value.rel_accuracy_bits() >= wanted:
                return value
            bits *= 2
        raise UndecidedError(f"{digits} digits were not reached with {MAX_BITS} bits")


def square_root(field: NumberField, x: FieldElement) -> FieldElement | None:
    """Return y with y² = x, or None.

    If x generates the field and m is its minimal polynomial, x is a square exactly if m(t²) is reducible; a
    factor A(t²) + t·B(t²) of it gives the root −A(x)/B(x). Multiplying by a square makes any x a generator.
    Norms and residues modulo a few primes exclude most non-squares beforehand.
    """
    if not x:
        return x
    if not _is_square(x.norm()) or not all(_square_at(x, *test) for test in _tests(field)):
        return None
    for shift in range(200):
        factor = field.one if shift == 0 else field.gen + shift
        y = x * factor * factor
        minimal = field.multiplication(y).charpoly()
        if minimal.gcd(minimal.derivative()).degree() == 0:
            root = _root_of_generator(field, y, minimal)
            return None if root is None else root * factor.inverse()
    raise UndecidedError(f"no multiple of {x} by a square was found that generates {field.name}")


def _root_of_generator(
    field: NumberField, x: FieldElement, minimal: flint.fmpq_poly
) -> FieldElement | None:
    doubled: list[flint.fmpq | int] = []
    for c in minimal.coeffs():
        doubled += [c, 0]
    factors = flint.fmpq_poly(doubled[:-1]).factor()[1]
    if len(factors) < 2:
        return None
    g = factors[0][0].coeffs()
    even, odd = field.zero, field.zero
    for c in reversed(g[0::2]):
        even = even * x + c
    for c in reversed(g[1::2]):
        odd = odd * x + c
    root: FieldElement = -even * odd.inverse()
    assert root * root == x, "the factor of m(t²) gives a root"
    return root


def _is_square(x: flint.fmpq) -> bool:
    return bool(x > 0 and x.p.is_square() and x.q.is_square())


@lru_cache(maxsize=256)
def _tests(field: NumberField) -> list[tuple[int, flint.nmod_poly]]:
    """Return a few odd primes, each with an irreducible factor modulo it of the field's polynomial."""
    whole = field.polynomial.numer()
    bad = int(whole.discriminant()) * int(whole.leading_coefficient())
    good = (p for p in primes() if p > 2 and bad % p)
    out: list[tuple[int, flint.nmod_poly]] = []
    for p in islice(good, REJECTING_PRIMES):
        modulus = flint.nmod_poly([int(c) % p for c in whole.coeffs()], p)
        factors = [g for g, _ in modulus.factor()[1]]
        out.append((p, min(factors, key=lambda g: g.degree())))
    return out


def _square_at(x: FieldElement, p: int, g: flint.nmod_poly) -> bool:
    """Return whether x may be a square, from its residue in GF(p)[s]/g."""
    den = int(x.poly.denom()) % p
    if not den:
        return True
    residue = flint.nmod_poly([int(c) * den % p for c in x.poly.numer().coeffs()], p) % g
    if residue == 0:
        return True
    return bool(residue.pow_mod((p ** g.degree() - 1) // 2, g) == 1)
