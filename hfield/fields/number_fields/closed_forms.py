"""Find sympy numbers as elements of number fields, by their minimal polynomials and their values."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

import flint

from hfield.errors import CoercionError, shorten
from hfield.fields.base.balls import precision
from hfield.fields.base.coercion import fmpq
from hfield.fields.number_fields.sums import roots_in

if TYPE_CHECKING:
    import sympy

    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ring import NumberField

MAX_OPERATIONS = 200  # of an expression whose minimal polynomial is computed
MAX_BITS = 2**14


def element_of(field: NumberField, x: sympy.Expr) -> FieldElement:
    """Return the element of the field whose value is the number x. Raises :class:`CoercionError`."""
    x = x.expand(func=True)  # the golden ratio
    value = _minimal_polynomial(x)
    if value is None:
        raise field.refuse(x, "expected an algebraic number")
    found = roots_in(field, value) if field.degree % value.degree() == 0 else []
    bits = 64
    while len(found) > 1 and bits <= MAX_BITS:
        ball = _ball(x, bits)
        found = [y for y in found if field.value_near(y, bits).overlaps(ball)]
        bits *= 2
    ball = _ball(x, 64)
    if len(found) != 1 or not field.value_near(found[0], 64).overlaps(ball):
        raise CoercionError(
            f"{shorten(x)} is not an element of {shorten(field.name)}; CC has all algebraic numbers"
        )
    return found[0]


def _minimal_polynomial(x: sympy.Expr) -> flint.fmpq_poly | None:
    """Return the monic minimal polynomial of a number over ℚ; None if it is not recognised as algebraic."""
    import sympy

    if x.has(sympy.Float) or x.count_ops() > MAX_OPERATIONS:
        return None
    try:
        polynomial = sympy.minimal_polynomial(x, polys=True)
    except (NotImplementedError, sympy.polys.polyerrors.NotAlgebraic):
        return None
    coefficients = [Fraction(int(c.p), int(c.q)) for c in polynomial.all_coeffs()]
    found = flint.fmpq_poly([fmpq(c) for c in reversed(coefficients)])
    return found / found.leading_coefficient()


def _ball(x: sympy.Expr, bits: int) -> flint.acb:
    """Return a complex ball around a sympy number, computed with ``bits`` bits."""
    from hfield.fields.algebraic.evaluate import evaluate, is_known

    with precision(bits + 16):
        if is_known(x):
            return evaluate(x)
        real, imaginary = x.evalf(bits * 3 // 10 + 10).as_real_imag()
        error = flint.arb(0, 2.0**-bits)
        return flint.acb(flint.arb(str(real)) + error, flint.arb(str(imaginary)) + error)
