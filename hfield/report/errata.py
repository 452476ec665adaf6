"""The errata as a chapter: the print, where and why it fails, the smallest witness, the correction."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from hfield.ledger.claim import Row
from hfield.ledger.errata import Erratum, errata
from hfield.proving.decision import REFUTED
from hfield.report.claims import description
from hfield.report.markup import Words, anchor, field_html, formula, prose, verdict_html
from hfield.report.terms import term


def errata_html(rows: Sequence[Row], words: Words) -> str:
    """Set every erratum, numbered."""
    found = errata(rows)
    if not found:
        return f"<p>{words['no_errata']}</p>"
    return f'<ol class="errata">{"".join(_erratum(one, words) for one in found)}</ol>'


def _erratum(erratum: Erratum, words: Words) -> str:
    claim = erratum.claim
    facts = []
    if claim.printed not in ("", "—"):
        facts.append((words["printed"], f'<p lang="pl">{escape(claim.printed)}</p>'))
    else:
        facts.append((words["statement"], f'<p lang="en">{escape(claim.statement)}</p>'))
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
        facts.append((words["note"], f'<p lang="en">{escape(claim.note)}</p>'))
    if erratum.witness:
        facts.append((words["witness"], prose(erratum.witness)))
    if erratum.failures:
        lines = "".join(f"<p>{prose(text)}</p>" for text in erratum.failures)
        facts.append((words["there"], f'<div lang="en">{lines}</div>'))
    if claim.corrected is not None:
        after = {
            row.as_corrected.verdict: None
            for row in erratum.refuted
            if row.as_corrected is not None
        }
        marks = " ".join(verdict_html(verdict, words) for verdict in after)
        facts.append((words["corrected"], f"{formula(claim.corrected.text)}{marks}"))
    return (
        f'<li><h3><a href="#{anchor(claim.id)}">{escape(claim.id)}</a> <span lang="en">'
        f"{escape(claim.name)}</span> <small>{term(claim.kind, words)}</small></h3>{description(facts)}</li>"
    )


def _fields(rows: Sequence[Row]) -> str:
    return ", ".join(field_html(row.field) for row in rows)
