"""Sums of terms as text, in the three styles; the rings read ``plain`` back."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import flint

from hfield.syntax.brackets import outside

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.flint_types import Rational


SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")

_DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")

Factor = tuple[str, int]


def sum_text(terms: Iterable[tuple[str, Sequence[Factor]]], style: str) -> str:
    """Write ``Σ coefficient · Π nameⁿ`` without spaces. The caller omits terms with coefficient ``0``.

    A coefficient is the text of a number or a sum; sums are parenthesised if necessary.
    """
    out = ""
    for coefficient, factors in terms:
        term = _term(coefficient, factors, style)
        minus = "−" if style == "unicode" else "-"
        out += term if not out or term.startswith(minus) else f"+{term}"
    return out or "0"


def _term(coefficient: str, factors: Sequence[Factor], style: str) -> str:
    times = {"plain": "*", "unicode": "·"}.get(style, "")
    minus = "−" if style == "unicode" else "-"
    body = times.join(power_text(name, n, style) for name, n in factors if n)
    if not body:
        return coefficient
    if coefficient == "1":
        return body
    if coefficient == f"{minus}1":
        return f"{minus}{body}"
    if is_sum(coefficient):
        coefficient = parentheses(coefficient, style)
    return f"{coefficient}{times or (' ' if style == 'latex' and body[0].isdigit() else '')}{body}"


def power_text(name: str, n: int, style: str) -> str:
    """Write ``nameⁿ``."""
    if n == 1:
        return name
    if style == "unicode":
        return name + str(n).translate(SUPERSCRIPTS)
    return f"{name}^{{{n}}}" if style == "latex" else f"{name}^{n}"


def blackboard(name: str) -> str:
    """Return the name of a ring with ℚ and ℤ in blackboard bold."""
    return re.sub(r"\bQQ", "ℚ", re.sub(r"\bZZ", "ℤ", name))


def number_text(x: Rational | sympy.Rational, style: str = "plain") -> str:
    """Write a rational number."""
    numerator, denominator = int(x.numerator), int(x.denominator)
    minus = "−" if style == "unicode" else "-"
    sign = minus if numerator < 0 else ""
    # Python refuses to write integers of more than 4300 digits; flint does not.
    digits = flint.fmpz(abs(numerator)).str()
    if denominator == 1:
        return f"{sign}{digits}"
    below = flint.fmpz(denominator).str()
    if style == "latex":
        return rf"{sign}\frac{{{digits}}}{{{below}}}"
    return f"{sign}{digits}/{below}"


def rational_json(x: Rational) -> int | str:
    """Return a rational number as JSON data: an int, or a text such as ``-1/2``."""
    return int(x.numerator) if x.denominator == 1 else number_text(x)


def is_sum(text: str) -> bool:
    """Return whether a text has a plus or minus outside all parentheses, not counting a leading sign."""
    return any(n and char in "+-−" and text[n - 1] != "^" for n, char in outside(text))


def parentheses(text: str, style: str) -> str:
    """Parenthesise a text."""
    return rf"\left({text}\right)" if style == "latex" else f"({text})"


def quotient_text(numerator: str, denominator: str, style: str) -> str:
    """Write a fraction of two sums; a denominator ``1`` is omitted."""
    if denominator == "1":
        return numerator
    if style == "latex":
        return rf"\frac{{{numerator}}}{{{denominator}}}"
    top = parentheses(numerator, style) if is_sum(numerator) or "/" in numerator else numerator
    simple = re.fullmatch(r"[^\W\d_][\w^]*|(?:cos|sin)\([\w/]*\)(?:\^\d+)?", denominator)
    bottom = denominator if simple or denominator.isdigit() else parentheses(denominator, style)
    return f"{top}/{bottom}"


def from_unicode(text: str) -> str:
    """Rewrite superscripts and roots for the grammar: ``x²`` as ``x^2``, ``√2`` as ``sqrt(2)``."""
    text = re.sub("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", lambda m: f"^({m[0].translate(_DIGITS)})", text)
    text = re.sub(r"√\s*([-−]?\d+|[^\W\d]\w*)", r"sqrt(\1)", text)
    return re.sub(r"√\s*\(", "sqrt(", text).replace("π", "pi")
