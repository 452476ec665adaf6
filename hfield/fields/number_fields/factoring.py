"""Irreducible factors of polynomials over number fields (B. Trager, Proc. SYMSAC 1976)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count
from typing import TYPE_CHECKING

import flint

from hfield.fields.base.roots import common_divisor, divided, monic, substituted
from hfield.fields.number_fields.elements import FieldElement

if TYPE_CHECKING:
    from hfield.fields.number_fields.ring import NumberField

Coefficients = list[FieldElement]


def irreducible_factors(
    field: NumberField, coefficients: Sequence[FieldElement]
) -> list[Coefficients]:
    """Return the distinct monic irreducible factors of a nonzero polynomial.

    For some c the norm of f(x − c·s) to ℚ[x], s the generator, has no multiple factors. Each irreducible
    factor of the norm then has one irreducible factor of f(x − c·s) in common with it.
    """
    f = monic(field, coefficients)
    if len(f) == 1:
        return []
    derivative = [x * n for n, x in enumerate(f)][1:]
    f = divided(field, f, common_divisor(field, f, derivative))[0]
    for c in count():
        moved = substituted(field, f, field.gen * -c)
        norm = _norm(field, moved)
        if norm.gcd(norm.derivative()).degree() == 0:
            break
    shared = (
        common_divisor(field, moved, [field(x) for x in g.coeffs()]) for g, _ in norm.factor()[1]
    )
    return [monic(field, substituted(field, g, field.gen * c)) for g in shared]


def _norm(field: NumberField, f: Coefficients) -> flint.fmpq_poly:
    """Return the product of the conjugates of f, a resultant, computed as a polynomial in two variables."""
    ring = flint.fmpq_mpoly_ctx.get(("s", "x"))
    terms = {(m, n): q for n, c in enumerate(f) for m, q in enumerate(c.poly.coeffs()) if q}
    modulus = {(m, 0): q for m, q in enumerate(field.polynomial.coeffs()) if q}
    product = ring.from_dict(modulus).resultant(ring.from_dict(terms), "s").to_dict()
    size = max(n for _, n in product) + 1
    return flint.fmpq_poly([product.get((0, n), 0) for n in range(size)])
