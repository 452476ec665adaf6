"""The errata as a chapter: the print, where and why it fails, the smallest witness, the correction."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from hfield.ledger.claim import Row
from hfield.ledger.errata import Erratum, errata
from hfield.proving.decision import REFUTED
from hfield.report.claims import description
from hfield.report.markup import anchor, field_html, verdict_html
from hfield.report.words import Language, term


def errata_html(rows: Sequence[Row], words: Language) -> str:
    """Set every erratum, numbered."""
    found = errata(rows)
    if not found:
        return f"<p>{words['no_errata']}</p>"
    return f'<ol class="errata">{"".join(_erratum(one, words) for one in found)}</ol>'


def _erratum(erratum: Erratum, words: Language) -> str:
    claim = erratum.claim
    facts = []
    if claim.printed not in ("", "—"):
        facts.append((words["printed"], words.printed(claim)))
    else:
        facts.append((words["statement"], words.html(claim.statement, "p")))
    facts.append((words["refuted_over"], _fields(erratum.refuted)))
    rest = [row for row in erratum.rows if row.as_printed.verdict != REFUTED]
    if rest:
        verdicts = dict.fromkeys(row.as_printed.verdict for row in rest)
        told = (
            f"{verdict_html(v, words)} {_fields([r for r in rest if r.as_printed.verdict == v])}"
            for v in verdicts
        )
        facts.append((words["elsewhere"], "; ".join(told)))
    if claim.note:
        facts.append((words["note"], words.html(claim.note, "p")))
    if erratum.witness:
        facts.append((words["witness"], words.html(erratum.witness)))
    if erratum.failures:
        facts.append((words["there"], "".join(words.html(text, "p") for text in erratum.failures)))
    if claim.corrected is not None:
        after = {
            row.as_corrected.verdict: None
            for row in erratum.refuted
            if row.as_corrected is not None
        }
        marks = " ".join(verdict_html(verdict, words) for verdict in after)
        facts.append((words["corrected"], f"{words.statement(claim.corrected.text)}{marks}"))
    return (
        f'<li><h3><a href="#{anchor(claim.id)}">{escape(claim.id)}</a> {words.name(claim)}'
        f" <small>{term(claim.kind, words)}</small></h3>{description(facts)}</li>"
    )


def _fields(rows: Sequence[Row]) -> str:
    return ", ".join(field_html(row.field) for row in rows)
