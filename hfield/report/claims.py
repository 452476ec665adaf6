"""The claims one by one: what is said, how it was decided over each field, with steps and certificates.

The errata among them again: the print, where and why it fails, the smallest witness, the correction.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from itertools import groupby

from hfield.ledger.claim import Row, by_claim
from hfield.ledger.errata import Erratum, errata
from hfield.ledger.matrix import tally
from hfield.ledger.wording import witness_text
from hfield.proving.decision import NOT_APPLICABLE, REFUTED, VERDICTS, Decision
from hfield.report.markup import anchor, field_html, field_text, verdict_html
from hfield.report.packed_certificates import Certificates
from hfield.report.words import Language, term

MOST_STEPS, MOST_LETTERS = 8, 300  # of a proof on the page; certificates have it whole
Alike = tuple[str, str, str, str]


def claims_html(rows: Sequence[Row], certificates: Certificates, words: Language) -> str:
    """Set all claims, by section."""
    sections = groupby(by_claim(rows), key=lambda own: own[0].claim.section)
    return "\n".join(_section(name, own, certificates, words) for name, own in sections)


def _section(
    name: str, claims: Iterable[Sequence[Row]], certificates: Certificates, words: Language
) -> str:
    title = f'<section class="of-section"><h3>{words["section"]} {escape(name)}</h3>'
    articles = (_article(own, certificates, words) for own in claims)
    return "\n".join([title, *articles, "</section>"])


def _article(rows: Sequence[Row], certificates: Certificates, words: Language) -> str:
    claim = rows[0].claim
    name = anchor(claim.id)
    refuted = any(row.as_printed.verdict == REFUTED for row in rows)
    facts = [(words["statement"], words.html(claim.statement, "p"))]
    if claim.printed not in ("", "—", claim.statement):
        facts.append((words["printed"], words.printed(claim)))
    if claim.as_printed is not None:
        facts.append((words["read_as"], words.statement(claim.as_printed.text)))
    if claim.note:
        facts.append((words["note"], words.html(claim.note, "p")))
    if refuted and claim.corrected is not None:
        facts.append((words["corrected"], words.statement(claim.corrected.text)))
    return (
        f'<article class="claim" id="{name}" aria-labelledby="{name}-name">'
        f'<h4 id="{name}-name"><a href="#{name}">{escape(claim.id)}</a> {words.name(claim)}'
        f" <small>{term(claim.kind, words)}</small></h4>"
        f"{description(facts)}{_decisions(rows, certificates, words)}</article>"
    )


def description(facts: Sequence[tuple[str, str]]) -> str:
    """Set labels with what stands beside them."""
    return (
        "<dl>"
        + "".join(f"<div><dt>{label}</dt><dd>{body}</dd></div>" for label, body in facts)
        + "</dl>"
    )


def _decisions(rows: Sequence[Row], certificates: Certificates, words: Language) -> str:
    """Set the decisions of a claim in a table, those that are alike in one line; closed at first."""
    alike: dict[Alike, list[Row]] = {}
    for row in rows:
        alike.setdefault(_alike(row), []).append(row)
    if all(row.as_printed.verdict == NOT_APPLICABLE for row in rows):
        return f'<p class="none">{verdict_html(NOT_APPLICABLE, words)}</p>'
    groups = sorted(alike.values(), key=lambda group: VERDICTS.index(group[0].as_printed.verdict))
    counts = tally(rows)
    title = " ".join(
        f"{verdict_html(v, words)}<span> × {counts[v]}</span>" for v in VERDICTS if counts[v]
    )
    head = ("verdict", "over", "method", "witness", "corrected")
    used = head if any(row.as_corrected is not None for row in rows) else head[:-1]
    top = "".join(f'<th scope="col">{words[key].lower()}</th>' for key in used)
    body = "".join(_line(group, len(used), certificates, words) for group in groups)
    return (
        f'<details><summary><span class="vh">{words["decisions"]}: </span>{title}</summary>'
        f'<div class="scroll"><table class="decisions"><caption class="vh">{words["decisions"]}</caption>'
        f"<thead><tr>{top}</tr></thead><tbody>{body}</tbody></table></div></details>"
    )


def _alike(row: Row) -> Alike:
    decision, corrected = row.as_printed, row.as_corrected
    after = "" if corrected is None else f"{corrected.verdict} {corrected.method}"
    return decision.verdict, decision.method, witness_text(decision.witness, row.field), after


def _line(rows: Sequence[Row], width: int, certificates: Certificates, words: Language) -> str:
    first = rows[0]
    verdict, method, witness, _ = _alike(first)
    fields = " ".join(_field(row, certificates.number(row)) for row in rows)
    cells = [
        fields,
        term(method, words),
        words.html(witness, most=MOST_LETTERS),
    ]
    if width > 4:
        after = first.as_corrected
        cells.append(
            ""
            if after is None
            else f"{verdict_html(after.verdict, words)} "
            + " ".join(_field(row, certificates.number(row, True), "corrected") for row in rows)
        )
    line = f'<tr><th scope="row">{verdict_html(verdict, words)}</th>'
    line += "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"
    told = _reasons(first.as_printed, words)
    return line + (f'<tr class="steps"><td colspan="{width}">{told}</td></tr>' if told else "")


def _field(row: Row, number: int | None, which: str = "") -> str:
    """Set a field, as a button where there is a certificate to save."""
    shown = field_html(row.field)
    if number is None:
        return f'<span class="field">{shown}</span>'
    return f'<button type="button" data-c="{number}" data-f="{field_text(row.field)}{which}">{shown}</button>'


def _reasons(decision: Decision, words: Language) -> str:
    """Set the steps of a decision, what it cites and what was tried, as lines."""
    steps = [words.html(step.strip(), "li", MOST_LETTERS) for step in decision.steps]
    if len(steps) > MOST_STEPS:
        more = words["more_steps"].format(n=len(steps) - MOST_STEPS + 1)
        steps = [*steps[: MOST_STEPS - 1], f"<li>{more}</li>"]
    out = f"<ol>{''.join(steps)}</ol>" if steps else ""
    for key, texts in (("assumes", decision.assumes), ("tried", decision.tried)):
        out += "".join(f"<p><i>{words[key]}</i> {words.html(text)}</p>" for text in texts)
    return out


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
    facts.append((words["refuted_over"], _all_fields(erratum.refuted)))
    rest = [row for row in erratum.rows if row.as_printed.verdict != REFUTED]
    if rest:
        verdicts = dict.fromkeys(row.as_printed.verdict for row in rest)
        told = (
            f"{verdict_html(v, words)} {_all_fields([r for r in rest if r.as_printed.verdict == v])}"
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


def _all_fields(rows: Sequence[Row]) -> str:
    return ", ".join(field_html(row.field) for row in rows)
