"""Which field of rational functions a text means: in one variable or several, over ℚ or a finite field."""

from hfield.errors import RingError, shorten
from hfield.fields.function_fields.ring import FunctionField
from hfield.rings.base import Ring, shared
from hfield.rings.finite import ExtensionField, FiniteField


def build(base: Ring, variables: tuple[str, ...]) -> Ring:
    """Return the field of rational functions. Raises :class:`RingError` for what is not offered."""
    if not isinstance(base, FiniteField) and base.name != "QQ":
        shown = shorten(f"{base}({','.join(variables)})")
        example = "QQ(x) or GF(4)(t)" if len(variables) == 1 else "QQ(x,y) or GF(4)(s,t)"
        raise RingError(
            f"{shown}: rational functions are over QQ or a finite field, as in {example}"
        )
    if len(variables) == 1:
        return shared(FunctionField, base, variables[0])
    if isinstance(base, ExtensionField):
        from hfield.fields.function_fields.extensions import over_extended_constants

        return over_extended_constants(base, variables)
    from hfield.fields.several_variables.ring import RationalFunctions
    from hfield.rings.polynomials import build as build_polynomials

    return shared(RationalFunctions, build_polynomials(base, variables))
