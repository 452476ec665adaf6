"""Rings with additional variables: polynomials over a ring, or rational functions over a field of
functions.
"""

from __future__ import annotations

from hfield.errors import RingError
from hfield.fields.base.ring import Ring, shared
from hfield.fields.base.variables import variables
from hfield.fields.circles.names import build as build_circles
from hfield.fields.circles.real import RealCircles
from hfield.fields.circles.ring import CircleFunctions, CirclesOverNumberField
from hfield.fields.function_fields.over_number_fields import OverNumberField
from hfield.fields.function_fields.quotients import FractionField
from hfield.fields.function_fields.rational_functions import rational_functions
from hfield.fields.polynomial_rings import PolynomialRing
from hfield.fields.polynomial_rings import build as build_polynomials
from hfield.fields.rationals.ring import QQ


def adjoin_variables(base: Ring, names: tuple[str, ...]) -> Ring:
    """Return the polynomials over a ring in additional variables; over a field of functions, the field with
    additional variables.

    Raises :class:`RingError` for names that have another meaning, and over rings that have no polynomials
    here.
    """
    variables(f"{base}[{','.join(names)}]", ",".join(names), base, adjoined=False)
    if isinstance(base, CircleFunctions):
        return build_circles(base.base, base.angles, (*base.plain, *names))
    if isinstance(base, PolynomialRing):
        return build_polynomials(base.base, (*base.variables, *names))
    if isinstance(base, FractionField):
        return rational_functions(base.base, (*base.variables, *names))
    if isinstance(base, RealCircles):
        return build_circles(base.constants, base.base.angles, (*base.base.plain, *names))
    if isinstance(base, CirclesOverNumberField):
        return build_circles(base.constants, base.base.angles, (*base.base.plain, *names))
    if isinstance(base, OverNumberField):
        return shared(OverNumberField, adjoin_variables(base.base, names), base.constants)
    try:
        return polynomials(base, names)
    except RingError as error:
        raise RingError(f"unknowns over {base} need polynomials over it: {error}") from None


def polynomials(base: Ring, names: tuple[str, ...]) -> Ring:
    """Return the polynomials over ℤ, ℚ, GF(p) or a number field. Raises :class:`RingError`."""
    if hasattr(base, "modulus_over_rationals"):
        return shared(OverNumberField, build_polynomials(QQ, names), base)
    return build_polynomials(base, names)
