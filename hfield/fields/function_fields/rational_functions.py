"""Fields of rational functions by their constants and variables."""

from __future__ import annotations

from hfield.errors import RingError, shorten
from hfield.fields.base.ring import Ring, shared
from hfield.fields.finite.ring import ExtensionField, FiniteField, PrimeField
from hfield.fields.function_fields.extensions import SimpleExtension
from hfield.fields.function_fields.over_number_fields import OverNumberField
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.polynomial_rings import build as build_polynomials
from hfield.fields.rationals.ring import QQ
from hfield.fields.several_variables.ring import RationalFunctions, listed


def rational_functions(base: Ring, names: tuple[str, ...]) -> Ring:
    """Return the field of rational functions. Raises :class:`RingError` for other constants."""
    if hasattr(base, "modulus_over_rationals"):
        return shared(OverNumberField, rational_functions(QQ, names), base)
    if not isinstance(base, FiniteField) and base != QQ:
        shown = shorten(f"{base}({','.join(names)})")
        example = "QQ(x) or GF(4)(t)" if len(names) == 1 else "QQ(x,y) or GF(4)(s,t)"
        raise RingError(
            f"{shown}: rational functions are over QQ or a finite field, as in {example}"
        )
    if len(names) == 1:
        return shared(FunctionField, base, names[0])
    if isinstance(base, ExtensionField):
        return over_extended_constants(base, names)
    return shared(RationalFunctions, build_polynomials(base, names))


def over_extended_constants(
    constants: ExtensionField, variables: tuple[str, ...]
) -> SimpleExtension:
    """Return GF(pⁿ)(s, t, …) as the extension of GF(p)(s, t, …) by the generator of GF(pⁿ)."""
    polynomials = build_polynomials(shared(PrimeField, constants.characteristic), variables)
    base = shared(RationalFunctions, polynomials)
    name = f"{constants.name}({','.join(variables)})"
    words = f"rational functions in {listed(variables)} over {constants.name}"
    modulus = tuple(base(c) for c in constants.coefficients)
    return shared(SimpleExtension, name, words, base, constants.gen_name, modulus)
