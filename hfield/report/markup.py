"""Small parts of the page: formulas, field names, verdicts with their symbols."""

from __future__ import annotations

import re
from html import escape

from hfield.errors import NotationError
from hfield.ledger.claim import NO_FIELD, UNIVERSAL
from hfield.ledger.claims_table import MARKS
from hfield.prover.statements.mathml import to_mathml
from hfield.prover.statements.trees import conjuncts
from hfield.syntax import parse

_LETTERS = {"QQ": "ℚ", "ZZ": "ℤ", "RR": "ℝ", "CC": "ℂ"}
_INDEX = re.compile(r"(?<![^\W_])([^\W\d_])_([a-zA-Z0-9Δπ]{1,3})(?![a-zA-Z0-9_])")  # e_i, R_zyx
_INDICES = re.compile(r"(?<=[\w}])_\{([^{}]*)\}")  # a_{n+1}
_POWER = re.compile(r"\^\{?((?<=\{)[^{}]*(?=\})|(?<=\^)(?:-?\d+|[^\W\d_]|⊥))\}?")
Words = dict[str, str]


def formula(text: str) -> str:
    """Typeset a statement as formulas, one line for each operand of ``and``; nothing for prose.

    >>> formula("the top has 2002 points")
    ''
    """
    try:
        parts = conjuncts(parse(text))
    except NotationError:
        return ""
    lines = [f"<p>{to_mathml(part)}</p>" for part in parts]
    return f'<div class="formula">{"".join(lines)}</div>'


def field_html(name: str) -> str:
    """Typeset a column name: ``GF(9)`` as F with index 9, ``QQ(sqrt(2))`` as ℚ(√2)."""
    if name in (UNIVERSAL, NO_FIELD):
        return "∀" if name == UNIVERSAL else "–"
    return prose(name)


def prose(text: str) -> str:
    """Typeset a text, with field names, indices and powers in it as mathematics: ``p = i over QQ``, ``e_i``.

    >>> prose("{e_{i_1}}_{i=1}^k, R_zyx and rotation_axis")
    '{e<sub>i<sub>1</sub></sub>}<sub>i=1</sub><sup>k</sup>, R<sub>zyx</sub> and rotation_axis'
    """
    text = escape(text)
    text = re.sub(r"\bGF\((\d+)\^(\d+)\)", r"F<sub>\1<sup>\2</sup></sub>", text)
    text = re.sub(r"\bGF\((\d+)\)", r"F<sub>\1</sub>", text)
    text = re.sub(r"\bsqrt\((-?\w+)\)", lambda found: "√" + found[1].replace("-", "−"), text)
    text = text.replace("(I)", "(i)")
    text = _INDEX.sub(r"\1<sub>\2</sub>", text)
    for signs, tag in ((_INDICES, "sub"), (_POWER, "sup")):
        while (after := signs.sub(rf"<{tag}>\1</{tag}>", text)) != text:
            text = after
    return re.sub(r"\b(QQ|ZZ|RR|CC)(?!\w)", lambda found: _LETTERS[found[0]], text)


def field_text(name: str) -> str:
    """Return a column name without tags, for lists of options: ``F9``."""
    return re.sub("<[^>]*>", "", field_html(name))


def verdict_html(verdict: str, words: Words) -> str:
    """Typeset a verdict as its symbol and its word, in its colour."""
    mark = f'<b aria-hidden="true">{MARKS[verdict]}</b>'
    return f'<span class="verdict {verdict}">{mark} {words[verdict]}</span>'


def anchor(claim: str) -> str:
    """Return the id of a claim's place on the page."""
    return "claim-" + re.sub(r"[^\w.-]", "_", claim)


def table(head: list[str], rows: list[list[str]], caption: str, css: str = "") -> str:
    """Lay out a table whose first column names the rows; cells are HTML."""
    top = "".join(f'<th scope="col">{cell}</th>' for cell in head)
    body = "".join(
        f'<tr><th scope="row">{first}</th>' + "".join(f"<td>{cell}</td>" for cell in rest) + "</tr>"
        for first, *rest in rows
    )
    kind = f' class="{css}"' if css else ""
    return (
        f"<table{kind}><caption>{caption}</caption><thead><tr>{top}</tr></thead>"
        f"<tbody>{body}</tbody></table>"
    )
