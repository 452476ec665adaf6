"""Which extension F[u]/(f) a text means: f read, made monic, and proved irreducible, or refused in words."""

from __future__ import annotations

from typing import Any

from hfield import syntax
from hfield.errors import CoercionError, HFieldError, RingError, shorten
from hfield.fields.function_fields.extensions import ExtensionElement, SimpleExtension, stripped
from hfield.fields.function_fields.quotients import Quotient
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.several_variables.ring import RationalFunctions
from hfield.rings.base import Ring, shared
from hfield.rings.polynomials import build as build_polynomials
from hfield.rings.printing import blackboard, from_unicode

MAX_DEGREE = 20


def build(base: Ring, variable: str, text: str) -> SimpleExtension:
    """Return F[u]/(f) for the text of an irreducible f. Raises :class:`RingError` for any other."""
    what = f"{base}[{variable}]/({shorten(text)})"
    if not isinstance(base, (FunctionField, RationalFunctions)):
        raise RingError(
            f"{what}: extensions are taken of fields such as QQ(x), GF(3)(t) and QQ(x,y)"
        )
    f = _read(base, variable, text, what)
    if not 2 <= len(f) - 1 <= MAX_DEGREE:
        raise RingError(
            f"{what}: expected a polynomial in {variable} of a degree from 2 to {MAX_DEGREE}"
        )
    scale = base.inverse(f[-1])
    f = [scale * c for c in f]
    _check_irreducible(base, variable, f, what)
    nameless = SimpleExtension("", "", base, variable, f)
    shown = nameless.text(ExtensionElement(nameless, f))  # one coefficient more than an element has
    name = f"{base}[{variable}]/({shown})"
    words = f"the extension of degree {len(f) - 1} of {blackboard(base.name)} by a root of {shown}"
    return shared(SimpleExtension, name, words, base, variable, tuple(f))


def _read(base: Ring, variable: str, text: str, what: str) -> list[Quotient]:
    """Read a polynomial in the variable over F, low degree first."""
    free = SimpleExtension(what, "", base, variable, [base.zero] * (MAX_DEGREE + 1) + [base.one])

    def divided(x: ExtensionElement, y: ExtensionElement) -> ExtensionElement:
        if not all(map(base.is_zero, y.coefficients[1:])):
            raise CoercionError(f"a polynomial in {variable} has no {variable} in a denominator")
        return x * free(base.inverse(y.coefficients[0]))

    def power(x: ExtensionElement, n: int) -> ExtensionElement:
        size = len(stripped(base, x.coefficients)) - 1
        if n < 0 or size * n > MAX_DEGREE:
            raise CoercionError(f"its degree is not from 2 to {MAX_DEGREE}")
        return free.power(x, n)

    reader = syntax.Reader(free, free.names(), {"/": divided, "**": power}, what, base.parse_limit)
    try:
        return stripped(base, reader.read(from_unicode(text)).coefficients)
    except HFieldError as error:
        raise RingError(f"{what} cannot be read: {error}") from error


def _check_irreducible(base: Any, variable: str, f: list[Quotient], what: str) -> None:
    """Raise :class:`RingError` unless f is irreducible over the field of rational functions."""
    if base.characteristic == 0 or (
        isinstance(base.base, Ring) and base.base.order == base.characteristic
    ):
        factors = _factors(base, variable, f)
        if len(factors) == 1 and factors[0][1] == 1:
            return
        parts = "*".join(f"({p})" + (f"^{n}" if n > 1 else "") for p, n in factors)
        raise RingError(f"{what}: the polynomial is reducible, {shorten(parts)} up to a constant")
    if len(f) == 3 and base.characteristic != 2:
        if base.sqrt(f[1] * f[1] - f[0] * 4) is None:
            return
        raise RingError(f"{what}: the polynomial is reducible, for its discriminant is a square")
    raise RingError(
        f"{what}: whether the polynomial is irreducible is not decided over {base}; over GF(p) and QQ it is"
    )


def _factors(base: Any, variable: str, f: list[Quotient]) -> list[tuple[Any, int]]:
    """Return the factors that contain the variable, of f times its denominators, by Gauss's lemma."""
    several = isinstance(base, RationalFunctions)
    names = base.variables if several else (base.gen_name,)
    R = build_polynomials(base.base, (*names, variable))
    below, total = R.one, R.zero
    parts = []
    for c in f:
        top, under = (R(base.text(base.quotient(p, base.one.num))) for p in (c.num, c.den))
        parts.append((top, under))
        below = R.divide(below * under, below.gcd(under))
    for n, (top, under) in enumerate(parts):
        total = total + top * R.divide(below, under) * R.power(R(variable), n)
    return [(p, int(n)) for p, n in total.factor()[1] if int(p.degrees()[-1]) > 0]
