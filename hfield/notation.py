"""Read algebras from text, and write coordinates as plain text, unicode and LaTeX.

An algebra is one text: ``(a,b|F)`` for ``i² = a, j² = b``; ``[a,b|F)`` for the Artin–Schreier form ``i² = a +
i``; ``[a,b,t|F)`` for ``i² = a + t·i``; ``H(F)`` for ``(-1,-1|F)``; ``6`` for the algebra over ℚ with reduced
discriminant 6. The notations of other systems are also read (``other_systems``).
"""

import re
from collections.abc import Sequence

from hfield.core.factorisation import factorise
from hfield.core.product import Constants, Scalar
from hfield.errors import CoercionError, NotationError, NotInvertibleError, RingError, shorten
from hfield.fields.base.ring import Ring
from hfield.fields.base.variables import names_in
from hfield.fields.names import ring
from hfield.syntax.brackets import outside, split
from hfield.syntax.other_systems import read

BASIS = ("e", "i", "j", "k")
_EXPECTED = "expected (a,b|F), [a,b|F), [a,b,t|F) or H(F), such as '(-1,-3|QQ)', or a discriminant such as 6"


_HAMILTON = re.compile(r"^(?:ℍ|\\mathbb\s*\{?H\}?)")
_FRACTION = re.compile(r"(?:\\left)?\(\s*\\frac\{(.*)\}\{(.*)\}\s*(?:\\right)?\)", re.DOTALL)
UNNAMED = "F"
"""The field in a text such as ``(a,b|F)``, which stands for every field."""


def split_algebra(text: str) -> tuple[str, str, str, str]:
    """Split an algebra's text into the texts of ``a, t, b`` and of the ring.

    ``ℍ`` without a field is Hamilton's algebra over ℝ. Raises :class:`NotationError` if the text does not
    have one of the five forms, and :class:`RingError` for a number that is not a discriminant.
    """
    s = read(text) or text.strip().replace("–", "-")
    if _HAMILTON.fullmatch(s):
        s = "H(RR)"
    s = _HAMILTON.sub("H", s)
    if m := _FRACTION.fullmatch(s):
        s = f"({m[1]}|{m[2]})"
    if s == "H":
        raise NotationError(
            f"{text.strip()} needs its field: write H(QQ), or H(RR) for Hamilton's quaternions over the reals"
        )
    if s.isascii() and s.isdecimal():
        a, b = constants_of_discriminant(s)
        return str(a), "0", str(b), "QQ"
    if m := re.fullmatch(r"H\((.+)\)", s, re.DOTALL):
        return "-1", "0", "-1", m[1].strip()
    m = re.fullmatch(r"([(\[])(.*)\|(.*)\)", s, re.DOTALL)
    if m is None:
        raise NotationError(f"{shorten(text)!r} is not an algebra: {_EXPECTED}")
    constants, field = [part.strip() for part in split(m[2], ",")], m[3].strip()
    if m[1] == "(" and len(constants) == 2:
        return constants[0], "0", constants[1], field
    if m[1] == "[" and len(constants) == 2:
        return constants[0], "1", constants[1], field
    if m[1] == "[" and len(constants) == 3:
        return constants[0], constants[2], constants[1], field
    count = f"{len(constants)} structure constant{'s' * (len(constants) != 1)}"
    raise NotationError(f"{shorten(text)!r} has {count}, which commas separate: {_EXPECTED}")


def constants_of_discriminant(discriminant: int | str) -> tuple[Scalar, Scalar]:
    """Return constants a and b of the algebra over ℚ with this reduced discriminant.

    Raises :class:`RingError` unless the discriminant is a product of distinct primes.
    """
    from hfield.fields.quadratic_forms.global_field import known_field
    from hfield.fields.rationals.ring import QQ, ZZ

    n = int(ZZ(discriminant))
    primes = factorise(n) if n > 0 else {2: n}
    if primes and max(primes.values()) != 1:
        raise RingError(
            f"{shorten(n)} is not the discriminant of an algebra over QQ: expected a product of "
            "different primes, or an algebra such as '(-1,-11|QQ)'"
        )
    a, b = known_field(QQ).with_ramification(list(primes), len(primes) % 2 == 1)
    return a, b


def parse_algebra(text: str) -> tuple[Ring, Constants]:
    """Read an algebra: its ring and its structure constants. Raises :class:`NotationError`."""
    a, t, b, field = split_algebra(text)
    if field == UNNAMED:
        raise NotationError(
            f"{shorten(text)}: F stands for every field, in statements; here name the field: "
            "(-1,-3|QQ), or (a,b|QQ(a,b)) for constants that are variables"
        )
    F = ring(field)
    try:
        return F, Constants(F(a), F(t), F(b))
    except (CoercionError, NotInvertibleError) as error:
        raise NotationError(f"in {shorten(text)!r}: {error}") from error


def generic(text: str) -> str:
    """Return ``(a,b|F)`` as ``(a,b|QQ(a,b))``, the algebra with variables for constants; other texts
    unchanged.

    >>> generic("(a,b|F)"), generic("(-1,-1|F)")
    ('(a,b|QQ(a,b))', '(-1,-1|F)')
    """
    a, t, b, field = split_algebra(text)
    letters = sorted(names_in(f"{a} {t} {b}"))
    if field != UNNAMED or not letters:
        return text
    head, _, _ = text.rpartition("|")
    return f"{head}|QQ({','.join(letters)}))"


def algebra_text(F: Ring, c: Constants) -> str:
    """Write an algebra in the notation that :func:`parse_algebra` reads."""
    constants = constants_text(F, c)
    bracket = "(" if F.key(c.t) == F.key(F(0)) else "["
    return f"{bracket}{','.join(constants)}|{F.name})"


def constants_text(F: Ring, c: Constants, style: str = "plain") -> list[str]:
    """Write the constants in an algebra's symbol: a and b, and t unless it is 0 or 1."""
    zero, one, minus_one = (F.key(F(n)) for n in (0, 1, -1))  # keys: with O() little is decided
    # In characteristic 2 −1 is 1, and only Hamilton's algebra is written with it there.
    keys = Constants(*map(F.key, c))
    hamilton = keys == (minus_one, zero, minus_one)
    signed = hamilton or F.characteristic != 2
    found = [
        "-1" if signed and key == minus_one else F.text(x, style)
        for x, key in ((c.a, keys.a), (c.b, keys.b))
    ]
    return found if keys.t in (zero, one) else [*found, F.text(c.t, style)]


def element_text(F: Ring, q: Sequence[Scalar], style: str = "plain", unit: str = "") -> str:
    """Write q as a combination of the basis.

    ``unit`` is the text for e: empty, so that 2·e is ``2``; or ``"e"``, as in Table 1.1. With ``"e"``, −1 is
    written as −1 in a finite field too.
    """
    return combination_text(F, q, (unit, *BASIS[1:]), style)


def combination_text(
    F: Ring, coordinates: Sequence[Scalar], letters: Sequence[str], style: str = "plain"
) -> str:
    """Write a linear combination of ``letters``, one letter for each coordinate; the first letter may be
    empty.
    """
    times = "*" if style == "plain" else ""
    minus = "−" if style == "unicode" else "-"
    zero, one, minus_one = (F.key(F(n)) for n in (0, 1, -1))
    terms = []
    for x, letter in zip(coordinates, letters, strict=True):
        key = F.key(x)
        if key == zero:
            continue
        text = F.text(x, style)
        if letter and key == one:
            terms.append(letter)
        elif letter and (text in ("-1", "−1") or (letters[0] and key == minus_one)):
            terms.append(f"{minus}{letter}")
        elif not letter:
            terms.append(text)
        else:
            factor = _factor(text, style)
            joined = factor[-1:].isalpha() or re.search(r"(?:cos|sin)\([^()]*\)$", factor)
            dot = "·" if style == "unicode" and joined else times
            terms.append(f"{factor}{dot}{letter}")
    out = terms[0] if terms else "0"
    for term in terms[1:]:
        negative = term.startswith(("-", "−"))
        out += f" {minus} {term[1:]}" if negative and _is_atom(term[1:]) else f" + {term}"
    return out


def _is_atom(text: str) -> bool:
    """Return whether a leading minus sign may be moved out of the term: it has no sum outside parentheses."""
    return not any(char in "+-−" for _, char in outside(text))


def _factor(text: str, style: str) -> str:
    body = text[1:] if text.startswith(("-", "−")) else text
    divided = any(char == "/" for _, char in outside(body))
    if _is_atom(body) and (style == "latex" or not divided or body.replace("/", "").isdigit()):
        return text
    return rf"\left({text}\right)" if style == "latex" else f"({text})"


def table_text(headers: Sequence[str], rows: Sequence[Sequence[str]], style: str = "plain") -> str:
    """Lay out a multiplication table whose first column and row are ``headers``."""
    if style == "latex":
        body = " \\\\\n".join(
            " & ".join((head, *cells)) for head, cells in zip(headers, rows, strict=True)
        )
        return (
            "\\begin{array}{c|" + "c" * len(headers) + "}\n"
            "\\times & " + " & ".join(headers) + " \\\\ \\hline\n" + body + "\n\\end{array}"
        )
    cross, bar, dash, corner = ("×", "│", "─", "┼") if style == "unicode" else ("*", "|", "-", "+")
    grid = [[cross, *headers], *([h, *cells] for h, cells in zip(headers, rows, strict=True))]
    widths = [max(len(row[n]) for row in grid) for n in range(len(grid[0]))]
    lines = [
        f" {row[0]:>{widths[0]}} {bar} "
        + "  ".join(f"{cell:>{w}}" for cell, w in zip(row[1:], widths[1:], strict=True))
        for row in grid
    ]
    rule = dash * (widths[0] + 2) + corner + dash * (len(lines[0]) - widths[0] - 3)
    return "\n".join([lines[0], rule, *lines[1:]])
