"""The report of ``hfield verify`` as Markdown: one table, with the errata below."""

from __future__ import annotations

from collections.abc import Sequence

from hfield.ledger.claim import Row
from hfield.ledger.claims_table import MARKS, marked
from hfield.ledger.columns import head
from hfield.ledger.errata import Erratum, errata
from hfield.ledger.report import conclusion, totals
from hfield.ledger.run import contradictions
from hfield.ledger.wording import witness_text


def markdown(rows: Sequence[Row], *, everything: bool = False) -> str:
    """Write the rows as a table of symbols, the errata, and with ``everything`` each row."""
    fields, lines = marked(rows, MARKS)
    grid = [["claim", "", *map(head, fields)]]
    grid += [[claim.id, claim.name, *marks] for claim, marks in lines]
    legend = ", ".join(f"{mark} {verdict}" for verdict, mark in MARKS.items())
    parts = ["## Claims, as printed", table(grid), legend]
    parts += _list("## Contradictions", [f"- {text}" for text in contradictions(rows)])
    parts += _list("## Errata", [_erratum(erratum) for erratum in errata(rows)])
    if everything:
        parts += ["## Every row", table([_HEADS, *(_cells(row) for row in rows)])]
    return "\n\n".join([*parts, totals(rows), conclusion(rows)])


_HEADS = ["claim", "field", "as printed", "method", "witness", "as corrected"]


def _cells(row: Row) -> list[str]:
    decision, corrected = row.as_printed, row.as_corrected
    witness = witness_text(decision.witness, row.field)
    return [
        *(row.claim.id, row.field, decision.verdict, decision.method, witness),
        "" if corrected is None else corrected.verdict,
    ]


def _list(title: str, items: Sequence[str]) -> list[str]:
    return [title, "\n\n".join(items)] if items else []


def _erratum(erratum: Erratum) -> str:
    claim = erratum.claim
    lines = [f"- {label}{': ' if label else ''}{_escape(text)}" for label, text in erratum.lines]
    return "\n".join([f"### {claim.id} {claim.name}", "", *lines])


def table(grid: Sequence[Sequence[str]]) -> str:
    """Write a table; its first line is the header."""
    lines = ["| " + " | ".join(_escape(cell) for cell in line) + " |" for line in grid]
    return "\n".join([lines[0], "|" + "---|" * len(grid[0]), *lines[1:]])


def _escape(text: str) -> str:
    """Escape a text for Markdown."""
    for mark in "\\|*_`[]<>":
        text = text.replace(mark, f"\\{mark}")
    return text
