"""Which number field a text means: ``QQ[s]/(s^3-2)``, and spellings such as ``QQ(zeta5)``, ``QQ(zeta7)+``."""

from __future__ import annotations

import re

import flint

from hfield import syntax
from hfield.errors import HFieldError, RingError, shorten
from hfield.rings.base import Ring
from hfield.rings.number_field import NumberField
from hfield.rings.printing import from_unicode, number_text, sum_text

MAX_DEGREE = 64
MAX_CONDUCTOR = 1000

_QUOTIENT = re.compile(r"QQ?\[([^\[\],]*)\]/\((.*)\)")
_REAL = re.compile(r"QQ?\(zeta_?(\d+|\(\d+\))\)\+")
_SPELLED = re.compile(r"QQ?\(((?:(?:sqrt|cbrt|root)\(|zeta[_(]?\d|I[,)]).*)\)")


def build(s: str) -> Ring | None:
    """Return the number field that a text without spaces names; None for a text of another kind.

    Raises :class:`RingError`.
    """
    if m := _QUOTIENT.fullmatch(s):
        from hfield.rings.variables import variables

        (name,) = variables(f"QQ[{shorten(m[1])}]", m[1])
        return NumberField(m[2], name)
    if m := _REAL.fullmatch(s):
        from hfield.rings.number_field_spelled import real_cyclotomic

        return real_cyclotomic(int(m[1].strip("()")))
    if (m := _SPELLED.fullmatch(s)) and _is_balanced(m[1]) and not _is_quadratic(m[1]):
        from hfield.rings.number_field_spelled import adjoined

        return adjoined(s, m[1])
    return None


def _is_quadratic(text: str) -> bool:
    """Tell whether a text is one square root, whose field is a quadratic one."""
    m = re.fullmatch(r"sqrt\((.*)\)", text)
    return text == "I" or (m is not None and _is_balanced(m[1]))


def _is_balanced(text: str) -> bool:
    """Tell whether no bracket is closed in a text that was not opened in it."""
    depth = 0
    for char in text:
        depth += (char == "(") - (char == ")")
        if depth < 0:
            return False
    return depth == 0


def power_sum(coefficients: list[flint.fmpq], name: str, style: str = "plain") -> str:
    """Write a polynomial with rational coefficients, given low degree first, highest first."""
    terms = [(number_text(c, style), [(name, n)]) for n, c in enumerate(coefficients) if c != 0]
    return sum_text(reversed(terms), style)


def irreducible(polynomial: flint.fmpq_poly | str, name: str) -> flint.fmpq_poly:
    """Return an irreducible polynomial over ℚ, made monic, from its text or as flint's.

    Raises :class:`RingError`.
    """
    f = _read(polynomial, name) if isinstance(polynomial, str) else flint.fmpq_poly(polynomial)
    shown = shorten(power_sum(f.coeffs(), name))
    what = f"QQ[{name}]/({shown})"
    if f.degree() < 1:
        raise RingError(
            f"{what}: {shown} is constant; expected an irreducible polynomial, as in QQ[s]/(s^3-2)"
        )
    if f.degree() == 1:
        raise RingError(f"{what}: the polynomial has degree 1, so this is QQ itself: write QQ")
    if f.degree() > MAX_DEGREE:
        raise RingError(f"{what}: the degree is {f.degree()}; at most {MAX_DEGREE} is taken")
    factors = f.factor()[1]
    if len(factors) > 1 or factors[0][1] > 1:
        parts = "*".join(
            f"({power_sum((g / g.leading_coefficient()).coeffs(), name)})"
            + (f"^{e}" if e > 1 else "")
            for g, e in factors
        )
        raise RingError(
            f"{what}: the polynomial is reducible, {shorten(parts)} up to a constant, so it makes no field; "
            "take one of its factors"
        )
    return f / f.leading_coefficient()


def _read(text: str, name: str) -> flint.fmpq_poly:
    """Read a polynomial in the variable of that name, or, if there is but one name in it, in that."""
    found = set(re.findall(r"[^\W\d_]\w*", from_unicode(text)))
    variable = found.pop() if len(found) == 1 else name
    functions = {"/": _quotient, "**": _power}
    number = lambda c: flint.fmpq_poly([flint.fmpq(c.numerator, c.denominator)])  # noqa: E731
    names = {variable: flint.fmpq_poly([0, 1])}
    reader = syntax.Reader(number, names, functions, f"polynomials in {variable}", 10_000)
    try:
        return reader.read(from_unicode(text))
    except HFieldError as error:
        raise RingError(
            f"the polynomial {shorten(text)!r} of a number field cannot be read: {error}"
        ) from error


def _quotient(x: flint.fmpq_poly, y: flint.fmpq_poly) -> flint.fmpq_poly:
    if y.degree() != 0:
        raise RingError(f"{y} is no number other than 0, so nothing is divided by it here")
    return x / y[0]


def _power(x: flint.fmpq_poly, n: int) -> flint.fmpq_poly:
    if n < 0:
        raise RingError("a polynomial has no terms of negative degree")
    return x**n
