"""Canonical names written from data; allowed names of variables; the notation of polynomials.

The checker does not read names of rings. It builds a ring from data and writes the name, so that distinct
rings have distinct names; docs/reference/certificates.md lists the kinds.
"""

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction

from hfield.checker.glossary import BASIS, WORDS
from hfield.checker.rejection import (
    MAX_DIGITS,
    a_list,
    a_text,
    an_integer,
    an_object,
    reject,
    shown,
)
from hfield.checker.scalars.ring import AnyRing, Kind

MAX_VARIABLES = 64


def variables(value: object, base: AnyRing) -> tuple[str, ...]:
    """Read the names of variables, which must be distinct and have no other meaning."""
    found = [a_text(x, "a variable", 100) for x in a_list(value, "variables", 1)]
    for name in found:
        if not re.fullmatch("[a-zA-Z][a-zA-Z0-9_]*", name) or name in WORDS or name in BASIS:
            reject(f"{shown(name)!r} cannot name a variable")
        if base.constant(("name", name)) is not None:
            reject(f"{shown(name)!r} already means an element of {base.name}")
    if len(set(found)) < len(found) or len(found) > MAX_VARIABLES:
        reject("a variable comes twice, or there are too many")
    return tuple(found)


def a_rational(value: object, what: str) -> Fraction:
    """Read a rational number: an integer, or a text such as ``-1/2`` in lowest terms."""
    if not isinstance(value, str):
        return Fraction(an_integer(value, what))
    top, _, below = value.partition("/")
    if re.fullmatch("-?[0-9]+/[0-9]+", value) and max(len(top), len(below)) <= MAX_DIGITS:
        found = Fraction(int(top), int(below) or 1)
        if found.denominator > 1 and str(found) == value:
            return found
    reject(
        f"{what} must be an integer or a text such as '-1/2' in lowest terms, found {shown(value)!r}"
    )


def blackboard(name: str) -> str:
    """Write the name of a ring as it appears within words."""
    return {"QQ": "ℚ", "ZZ": "ℤ"}.get(name, name)


def plain(data: Mapping[str, object], keys: str) -> Mapping[str, object]:
    """Return the data of a ring, which must have exactly these keys besides its kind."""
    return an_object(data, f"kind {keys}", "the data of a ring")


def only(ring: AnyRing) -> Kind:
    """Return the reader for a kind with a single ring."""

    def read(data: Mapping[str, object], _: object) -> AnyRing:
        plain(data, "")
        return ring

    return read


def polynomial_text(coefficients: Sequence[object], name: str, falling: bool = True) -> str:
    """Write Σ cₙ·nameⁿ, highest power first if ``falling``; the coefficients are low degree first.

    A coefficient is a number, or a text, which is parenthesised if it is a sum.
    """
    terms = [_term(str(c), name, n) for n, c in enumerate(coefficients) if str(c) != "0"]
    out = ""
    for term in reversed(terms) if falling else terms:
        out += term if not out or term.startswith("-") else f"+{term}"
    return out or "0"


def _term(coefficient: str, name: str, n: int) -> str:
    if n == 0:
        return coefficient
    power = name if n == 1 else f"{name}^{n}"
    if coefficient in ("1", "-1"):
        return coefficient[:-1] + power
    sign = "+" in coefficient or "-" in coefficient[1:]
    return f"({coefficient})*{power}" if sign else f"{coefficient}*{power}"
