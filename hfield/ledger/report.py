"""The report of ``hfield verify`` for a terminal: headline table, summary of the rest, errata."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import replace

from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Row
from hfield.ledger.claims_table import TerminalStyle, matrix, tally
from hfield.ledger.columns import head
from hfield.ledger.errata import Erratum, errata
from hfield.ledger.run import as_expected, contradictions
from hfield.ledger.wording import witness_text
from hfield.presenting import aligned, hanging
from hfield.prover.decision import NOT_APPLICABLE, UNDECIDED, VERDICTS

_LABEL = 11  # width of the labels in the errata
_WIDTH = 100


def report(
    rows: Sequence[Row], style: TerminalStyle, *, chosen: bool = False, everything: bool = False
) -> str:
    """Write the report: a table of all given claims if ``chosen``, else of the headline claims;
    ``everything`` adds every row.
    """
    shown = [row for row in rows if chosen or everything or row.claim.headline]
    rest = [] if chosen or everything else [row for row in rows if not row.claim.headline]
    parts = []
    if shown:
        title = "The claims" if chosen or everything else "Headline claims"
        parts += [style.bold(f"{title}, as printed"), matrix(shown, style), _legend(shown, style)]
    if rest:
        parts += [style.bold("The other claims, rows by verdict as printed"), summary(rest, style)]
    if everything:
        parts += [style.bold("Every row"), "\n".join(_line(row, style) for row in rows)]
    sections = {
        "Contradictions": "\n".join(_wrap("!", text, style, 2) for text in contradictions(rows)),
        "Undecided": "\n".join(_wrap("?", text, style, 2) for text in _undecided(rows)),
        "Errata": "\n\n".join(erratum_text(erratum, style) for erratum in errata(rows)),
    }
    for title, text in sections.items():
        parts += [style.bold(title), text] if text else []
    return "\n\n".join([*parts, totals(rows, style.width), conclusion(rows, style.width)])


def _legend(rows: Sequence[Row], style: TerminalStyle) -> str:
    """Return the meaning of the symbols, and of the two columns that are not fields."""
    fields = {row.field for row in rows}
    lines = [style.legend()]
    if UNIVERSAL in fields:
        lines.append(f"{head(UNIVERSAL, style.ascii_only)} is every commutative ring at once")
    if NO_FIELD in fields:
        lines.append(f"{NO_FIELD} is for claims about no field in particular")
    return "\n".join(lines)


def summary(rows: Sequence[Row], style: TerminalStyle) -> str:
    """Count claims and rows by section and verdict, with totals; a narrow table has symbols as headings."""
    sections = list(dict.fromkeys(row.claim.section for row in rows))
    words = ["section", "claims", *(v.replace("-", " ") for v in VERDICTS)]
    if sum(len(word) + 2 for word in words) > style.width:
        words[2:] = [replace(style, colour=False).mark(v) for v in VERDICTS]
    grid = [words]
    for section in sections:
        grid.append([section, *_counts([row for row in rows if row.claim.section == section])])
    if len(sections) > 1:
        grid.append(["total", *_counts(rows)])
    return "\n".join(aligned(grid, "<" + ">" * (len(words) - 1), "  "))


def _counts(rows: Sequence[Row]) -> list[str]:
    counts = tally(rows)
    return [str(len({row.claim.id for row in rows})), *(str(counts[v]) for v in VERDICTS)]


def totals(rows: Sequence[Row], width: int = _WIDTH) -> str:
    """Return lines of the given width with the number of rows of each verdict."""
    counts = tally(rows)
    claims = {row.claim.id: row.claim for row in rows}
    beyond = [claim.id for claim in claims.values() if not claim.checkable]
    text = (
        f"{_plural(len(claims), 'claim')}, {_plural(len(rows), 'row')}: "
        + ", ".join(f"{counts[v]} {v.replace('-', ' ')}" for v in VERDICTS if counts[v])
        + "."
    )
    text = textwrap.fill(text, width, subsequent_indent="  ")
    if beyond:
        named = (
            f"{_plural(len(beyond), 'claim')} can be checked by no program "
            f"(history, opinion, announcement): {', '.join(beyond)}."
        )
        text += "\n" + textwrap.fill(named, width, subsequent_indent="  ", break_on_hyphens=False)
    return text


def conclusion(rows: Sequence[Row], width: int = _WIDTH) -> str:
    """Return whether all verdicts are as expected, and list the others."""
    if as_expected(rows):
        text = (
            "All is as expected: every row has a verdict, none contradicts another, "
            "every correction holds."
        )
    else:
        decisions = [d for row in rows for d in (row.as_printed, row.as_corrected) if d is not None]
        undecided = sum(decision.verdict == UNDECIDED for decision in decisions)
        text = (
            f"Not as expected: {_plural(undecided, 'decision')} without a verdict, "
            f"{_plural(len(contradictions(rows)), 'contradiction')}."
        )
    return textwrap.fill(text, width, subsequent_indent="  ")


def _plural(n: int, noun: str) -> str:
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"


def erratum_text(erratum: Erratum, style: TerminalStyle) -> str:
    """Write one erratum: the printed text, where it fails, why, the witness, the correction."""
    claim = erratum.claim
    lines = [style.bold(f"{claim.id}  {claim.name}") + f"  ({claim.kind})"]
    return "\n".join(lines + [_wrap(label, text, style) for label, text in erratum.lines])


def _undecided(rows: Sequence[Row]) -> list[str]:
    """Return what was tried for undecided rows, grouped by claim."""
    fields: dict[tuple[str, str, str], list[str]] = {}
    for row in rows:
        for what, decision in (("printed", row.as_printed), ("corrected", row.as_corrected)):
            if decision is not None and decision.verdict == UNDECIDED:
                tried = "; ".join(decision.tried) or decision.method
                fields.setdefault((row.claim.id, what, tried), []).append(row.field)
    return [
        f"{name} as {what}, over {', '.join(where)}. Tried: {tried}"
        for (name, what, tried), where in fields.items()
    ]


def _line(row: Row, style: TerminalStyle) -> str:
    decision = row.as_printed
    text = f"{row.claim.id:<10} {row.field:<12} {style.mark(decision.verdict)} {decision.verdict}"
    if decision.verdict != NOT_APPLICABLE:
        text += f" by {decision.method}"
    witness = witness_text(decision.witness, row.field)
    if witness:
        text += f"; {witness}"
    if row.as_corrected is not None:
        text += f"; corrected: {row.as_corrected.verdict} by {row.as_corrected.method}"
    return text


def _wrap(label: str, text: str, style: TerminalStyle, width: int = _LABEL) -> str:
    return "\n".join(hanging(f"  {label:<{width}}", text, style.width))
