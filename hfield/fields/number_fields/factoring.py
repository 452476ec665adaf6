"""Irreducible factors of polynomials over number fields (B. Trager, Proc. SYMSAC 1976)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count
from typing import TYPE_CHECKING

import flint

from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.sums import remainder, times
from hfield.rings.factoring import monic

if TYPE_CHECKING:
    from hfield.fields.number_fields.ring import NumberField

Coefficients = list[FieldElement]


def irreducible_factors(
    field: NumberField, coefficients: Sequence[FieldElement]
) -> list[Coefficients]:
    """Return the monic irreducible factors of a polynomial that is not 0, each once.

    f(x − c·s) has a norm to ℚ[x] without multiple factors for some c, s the generator; each irreducible
    factor of the norm has one of f(x − c·s) in common with it.
    """
    f = monic(field, coefficients)
    if len(f) == 1:
        return []
    derivative = [x * n for n, x in enumerate(f)][1:]
    f = _quotient(f, common_divisor(field, f, derivative))
    for c in count():
        moved = _substituted(field, f, field.gen * -c)
        norm = _norm(field, moved)
        if norm.gcd(norm.derivative()).degree() == 0:
            break
    shared = (
        common_divisor(field, moved, [field(x) for x in g.coeffs()]) for g, _ in norm.factor()[1]
    )
    return [monic(field, _substituted(field, g, field.gen * c)) for g in shared]


def common_divisor(field: NumberField, f: Coefficients, g: Coefficients) -> Coefficients:
    """Return the monic greatest common divisor of two polynomials, of which the first is not 0."""
    g = _without_zeros(g)
    while g:
        f, g = g, remainder(f, g)
    return monic(field, f)


def _without_zeros(f: Coefficients) -> Coefficients:
    f = list(f)
    while f and not f[-1]:
        f.pop()
    return f


def _quotient(f: Coefficients, g: Coefficients) -> Coefficients:
    """Return f/g for a monic g that divides f."""
    rest, out = list(f), list[FieldElement]()
    while len(rest) >= len(g):
        out.append(rest[-1])
        for k, x in enumerate(g):
            at = len(rest) - len(g) + k
            rest[at] = rest[at] - out[-1] * x
        rest.pop()
    return out[::-1]


def _substituted(field: NumberField, f: Coefficients, shift: FieldElement) -> Coefficients:
    """Return f(x + shift)."""
    line, out = [shift, field.one], [field.zero]
    for c in reversed(f):
        out = times(out, line)
        out[0] = out[0] + c
    return out


def _norm(field: NumberField, f: Coefficients) -> flint.fmpq_poly:
    """Return the product of the conjugates of f: a resultant, computed as a polynomial in two variables."""
    ring = flint.fmpq_mpoly_ctx.get(("s", "x"))
    terms = {(m, n): q for n, c in enumerate(f) for m, q in enumerate(c.poly.coeffs()) if q}
    modulus = {(m, 0): q for m, q in enumerate(field.polynomial.coeffs()) if q}
    product = ring.from_dict(modulus).resultant(ring.from_dict(terms), "s").to_dict()
    size = max(n for _, n in product) + 1
    return flint.fmpq_poly([product.get((0, n), 0) for n in range(size)])
