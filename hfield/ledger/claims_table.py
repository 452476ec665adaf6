"""Lay out the table of claims and fields for a terminal, with a symbol for each verdict."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from hfield.ledger.claim import Claim, Row
from hfield.ledger.columns import head, panel_order
from hfield.prover.decision import NOT_APPLICABLE, PROVED, REFUTED, UNDECIDED, VACUOUS, VERDICTS

MARKS = {PROVED: "✓", REFUTED: "✗", VACUOUS: "∅", UNDECIDED: "?", NOT_APPLICABLE: "·"}
ASCII_MARKS = {PROVED: "+", REFUTED: "x", VACUOUS: "o", UNDECIDED: "?", NOT_APPLICABLE: "."}
LATEX_MARKS = {
    PROVED: r"\checkmark",
    REFUTED: r"\times",
    VACUOUS: r"\varnothing",
    UNDECIDED: "?",
    NOT_APPLICABLE: r"\cdot",
}
_COLOURS = {PROVED: "32", REFUTED: "31", VACUOUS: "36", UNDECIDED: "33", NOT_APPLICABLE: "2"}
_LEAST_NAME = 12


@dataclass(frozen=True)
class TerminalStyle:
    """The style of a terminal: width, unicode, colours."""

    width: int = 100
    ascii_only: bool = False
    colour: bool = False

    def mark(self, verdict: str) -> str:
        """Return the one-character symbol of a verdict."""
        mark = (ASCII_MARKS if self.ascii_only else MARKS)[verdict]
        return self.paint(mark, _COLOURS[verdict])

    def paint(self, text: str, code: str) -> str:
        """Colour a text by an ANSI code, if colours are enabled."""
        return f"\x1b[{code}m{text}\x1b[0m" if self.colour else text

    def bold(self, text: str) -> str:
        """Set a text in bold, if colours are enabled."""
        return self.paint(text, "1")

    @property
    def rule(self) -> str:
        """The character of horizontal rules."""
        return "-" if self.ascii_only else "─"

    def legend(self, verdicts: Sequence[str] = VERDICTS) -> str:
        """Return the meaning of the symbols, wrapped to the width of the terminal."""
        lines, used = "", 0
        for v in verdicts:
            word, needed = v.replace("-", " "), len(v) + 2
            gap = "" if not lines else "   " if used + 3 + needed <= self.width else "\n"
            lines += f"{gap}{self.mark(v)} {word}"
            used = needed + (used + 3 if gap == "   " else 0)
        return lines


def columns_of(rows: Sequence[Row]) -> list[str]:
    """Return the fields of the rows: those of the panel in its order, then the others."""
    return sorted(dict.fromkeys(row.field for row in rows), key=panel_order)


def marked(
    rows: Sequence[Row], marks: Mapping[str, str]
) -> tuple[list[str], list[tuple[Claim, list[str]]]]:
    """Return the fields, and each claim with its symbols as printed, empty where it was not decided."""
    fields = columns_of(rows)
    found = {(row.claim.id, row.field): marks[row.as_printed.verdict] for row in rows}
    claims = {row.claim.id: row.claim for row in rows}.values()
    return fields, [(c, [found.get((c.id, field), "") for field in fields]) for c in claims]


def matrix(rows: Sequence[Row], style: TerminalStyle) -> str:
    """Lay out the verdicts as printed: one line per claim, one column per field.

    Headings are written in full if they fit, else shortened; if there are too many columns they are divided
    into blocks. A claim that is not about a field gets a separate column only if necessary; usually the
    caller leaves such rows to the summary.
    """
    fields, lines = marked(rows, {v: style.mark(v) for v in VERDICTS})
    ids = max(len(claim.id) for claim, _ in lines)
    names = max(len(claim.name) for claim, _ in lines)
    width = style.width - ids - 3
    short = [head(field, style.ascii_only) for field in fields]
    for heads, gap, label in ((fields, 2, names), (short, 2, names), (short, 1, names)):
        if label + sum(len(h) + gap for h in heads) <= width:
            break
    else:
        left = width - sum(len(h) + 1 for h in short)
        heads, gap, label = short, 1, min(names, max(left, _LEAST_NAME))
    blocks = _blocks(heads, width - label, gap)
    return "\n\n".join(_block(lines, heads, b, (ids, label, gap), style.rule) for b in blocks)


def _blocks(heads: Sequence[str], width: int, gap: int) -> list[range]:
    blocks, start, used = [], 0, 0
    for n, text in enumerate(heads):
        if n > start and used + len(text) + gap > width:
            blocks.append(range(start, n))
            start, used = n, 0
        used += len(text) + gap
    return [*blocks, range(start, len(heads))]


def _block(
    claims: Sequence[tuple[Claim, Sequence[str]]],
    heads: Sequence[str],
    block: range,
    widths: tuple[int, int, int],
    rule: str,
) -> str:
    ids, label, gap = widths
    space = " " * gap
    lines = [" " * (ids + label + 3) + "".join(f"{space}{heads[n]}" for n in block)]
    lines.append(rule * len(lines[0]))
    for claim, marks in claims:
        name = claim.name if len(claim.name) <= label else claim.name[: label - 1] + "…"
        cells = ""
        for n in block:
            left = (len(heads[n]) - 1) // 2
            right = len(heads[n]) - 1 - left
            cells += space + " " * left + (marks[n] or " ") + " " * right
        lines.append(f"{claim.id:<{ids}}  {name:<{label}} {cells}".rstrip())
    return "\n".join(lines)


def tally(rows: Sequence[Row]) -> Counter[str]:
    """Count the rows by verdict, as printed."""
    return Counter(row.as_printed.verdict for row in rows)
