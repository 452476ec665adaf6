"""Write a report as one HTML file with its style and script.

It begins with a summary by section and the claims × fields matrix, which the page can filter.

Then come the claims: the statement, and how it was decided over each field, with steps and certificates.

Then come the errata: the printed text, where and why it fails, the smallest witness, the correction.

Finally the certificates of all decisions: one line of JSON each, compressed together.
"""

from __future__ import annotations

import json
import zlib
from base64 import b64encode
from collections.abc import Callable, Iterable, Sequence
from html import escape
from importlib.resources import files
from itertools import groupby

from hfield.ledger.certificate import certificate
from hfield.ledger.claim import Claim, Row, by_claim
from hfield.ledger.claims_table import MARKS, columns_of, marked, tally
from hfield.ledger.errata import Erratum, errata
from hfield.ledger.run import contradictions
from hfield.ledger.wording import witness_text
from hfield.prover.decision import NOT_APPLICABLE, REFUTED, UNDECIDED, VERDICTS, Decision
from hfield.report.chapters import Chapter
from hfield.report.markup import Words, anchor, field_html, field_text, table, verdict_html
from hfield.report.page_texts import Language, counted, term


def page(
    rows: Sequence[Row],
    certificates: Certificates,
    language: str = "en",
    chapters: Sequence[Chapter] = (),
    ledger: str | None = None,
) -> str:
    """Return the report as one HTML page in ``language``, ``en`` or ``pl``.

    ``ledger`` is the name of a user's own ledger; without it the rows are those of the thesis.
    """
    from hfield import __version__

    words = Language(language, rows)
    title = words["thesis"] if ledger is None else f"{ledger}: {words['title']}"
    places = ["summary", "matrix", "claims", "errata"]
    links = [(f"#{key}", words[key]) for key in places]
    links += [(f"#chapter-{n}", chapter.title) for n, chapter in enumerate(chapters)]
    parts = {
        "language": language,
        "title": escape(title),
        "subtitle": "" if ledger else f"<p>{escape(words['thesis_of'])}</p>",
        "made_by": escape(words["made_by"].format(version=__version__)),
        "links": "".join(f'<li><a href="{to}">{escape(text)}</a></li>' for to, text in links),
        "in_short": _summary(rows, len(certificates), words),
        "filters": _filters(rows, words),
        "table": _matrix(rows, words),
        "all": claims_html(rows, certificates, words),
        "slips": errata_html(rows, words),
        "more": "\n".join(_chapter(n, chapter) for n, chapter in enumerate(chapters)),
        "get_all_text": words["get_all"].format(n=len(certificates)),
        "hidden": "" if len(certificates) else "hidden",
        "pack": certificates.packed(),
        "style": _file("page.css"),
        "script": _file("page.js"),
        **{f"w_{key}": escape(text) for key, text in words.items()},
    }
    text = _file("page.html")
    for name, part in parts.items():
        text = text.replace(f"{{{{{name}}}}}", part)
    return text


def _chapter(number: int, chapter: Chapter) -> str:
    name = f"chapter-{number}"
    return (
        f'<section id="{name}" aria-labelledby="{name}-title"><h2 id="{name}-title">'
        f"{escape(chapter.title)}</h2>{chapter.body}</section>"
    )


def _file(name: str) -> str:
    return (files(__package__) / name).read_text(encoding="utf-8").rstrip()


def _summary(rows: Sequence[Row], certificates: int, words: Words) -> str:
    """Typeset the numbers of claims and decisions by section and verdict, and the unexpected decisions."""
    claims = list(dict.fromkeys(row.claim for row in rows))
    counts, language = tally(rows), words["lang"]
    figures = [
        (len(claims), counted("claims", len(claims), language), ""),
        (len(rows), counted("decisions", len(rows), language), ""),
        *((counts[v], words[v], v) for v in VERDICTS if counts[v]),
        (certificates, counted("certificates", certificates, language), ""),
    ]
    tiles = "".join(
        f'<li class="{css}"><b>{_thousands(n)}</b> {label}</li>' for n, label, css in figures
    )
    sections = list(dict.fromkeys(claim.section for claim in claims))
    lines = [_counted(escape(s), [row for row in rows if row.claim.section == s]) for s in sections]
    if len(lines) > 1:
        lines.append(_counted(words["total"], rows))
    head = [words["section"], words["of_claims"], *(verdict_html(v, words) for v in VERDICTS)]
    parts = [f'<ul class="tiles">{tiles}</ul>', f"<p>{words['about']}</p>"]
    caption = f'<span class="vh">{words["summary"]}</span>'
    parts.append(f'<div class="scroll">{table(head, lines, caption, "counts")}</div>')
    undecided = [
        f"{escape(row.claim.id)}: {field_html(row.field)}"
        for row in rows
        if row.as_printed.verdict == UNDECIDED
    ]
    clashes = [escape(text) for text in contradictions(rows)]
    for key, texts in (("undecided_rows", undecided), ("contradictions", clashes)):
        if texts:
            parts.append(f"<p><b>{words[key]}</b>: {'; '.join(texts)}</p>")
    beyond = [f'<a href="#{anchor(c.id)}">{escape(c.id)}</a>' for c in claims if not c.checkable]
    if beyond:
        parts.append(f'<p class="beyond">{words["beyond"]}: {", ".join(beyond)}.</p>')
    return "\n".join(parts)


def _counted(label: str, rows: Sequence[Row]) -> list[str]:
    counts = tally(rows)
    numbers = [len({row.claim.id for row in rows}), *(counts[v] for v in VERDICTS)]
    return [label, *(_thousands(n) if n else '<span class="zero">0</span>' for n in numbers)]


def _thousands(n: int) -> str:
    return f"{n:,}".replace(",", "\u202f")


def _filters(rows: Sequence[Row], words: Words) -> str:
    """Write the filter controls, which a script makes visible."""
    sections = [(s, s) for s in dict.fromkeys(row.claim.section for row in rows)]
    fields = [(f, field_text(f) + _meaning(f, words)) for f in columns_of(rows)]
    verdicts = [(v, f"{MARKS[v]} {words[v]}") for v in VERDICTS]
    choices = [
        _select("section", words["section"], words["all_sections"], sections),
        _select("field", words["field"], words["all_fields"], fields),
        _select("verdict", words["verdict"], words["all_verdicts"], verdicts),
    ]
    return (
        f'<form id="filter" role="search" aria-label="{words["filter"]}" hidden>{"".join(choices)}'
        f'<label>{words["search"]}<input id="search" type="search"></label>'
        f'<button type="reset">{words["reset"]}</button>'
        f'<output id="shown" data-text="{words["shown"]}"></output></form>'
    )


def _meaning(field: str, words: Words) -> str:
    return f" ({words[field]})" if field in words else ""


def _select(name: str, label: str, every: str, options: Sequence[tuple[str, str]]) -> str:
    listed = "".join(f'<option value="{escape(v)}">{escape(text)}</option>' for v, text in options)
    return f'<label>{label}<select id="{name}"><option value="">{every}</option>{listed}</select></label>'


def _matrix(rows: Sequence[Row], words: Language) -> str:
    """Typeset the matrix: one line per claim, one column per field; each cell has a symbol, and a word for
    screen readers.
    """
    fields, claims = marked(rows, {verdict: verdict for verdict in VERDICTS})
    top = "".join(
        f'<th scope="col" data-f="{escape(f)}">{field_html(f)}'
        + (f'<span class="vh">{_meaning(f, words)}</span>' if f in words else "")
        + "</th>"
        for f in fields
    )
    bodies = ""
    for section, own in groupby(claims, key=lambda line: line[0].section):
        bodies += (
            f'<tbody data-s="{escape(section)}"><tr class="group"><th scope="rowgroup"'
            f' colspan="{len(fields) + 1}">{words["section"]} {escape(section)}</th></tr>'
        )
        for claim, verdicts in own:
            cells = "".join(_cell(verdict, words) for verdict in verdicts)
            bodies += f"{_line(claim, words)}{cells}</tr>"
        bodies += "</tbody>"
    legend = " ".join(verdict_html(v, words) for v in VERDICTS)
    return (
        f'<p class="legend">{legend}</p><div class="scroll tall" tabindex="0" role="group"'
        f' aria-labelledby="matrix-caption"><table class="matrix"><caption id="matrix-caption" class="vh">'
        f'{words["matrix"]}</caption><thead><tr><th scope="col">{words["claim"]}</th>{top}</tr></thead>'
        f"{bodies}</table></div>"
    )


def _line(claim: Claim, words: Language) -> str:
    return (
        f'<tr data-id="{anchor(claim.id)}"><th scope="row"><a href="#{anchor(claim.id)}">'
        f"{escape(claim.id)} <span>{words.name(claim)}</span></a></th>"
    )


def _cell(verdict: str, words: Words) -> str:
    if not verdict:
        return "<td></td>"
    return f'<td class="{verdict}"><i>{MARKS[verdict]}</i><b>{words[verdict]}</b></td>'


MAX_STEPS, MAX_LETTERS = 8, 300  # of a proof on the page; certificates have it whole
Alike = tuple[str, str, str, str]


def claims_html(rows: Sequence[Row], certificates: Certificates, words: Language) -> str:
    """Typeset all claims by section."""
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
    """Write a list of labels and descriptions."""
    return (
        "<dl>"
        + "".join(f"<div><dt>{label}</dt><dd>{body}</dd></div>" for label, body in facts)
        + "</dl>"
    )


def _decisions(rows: Sequence[Row], certificates: Certificates, words: Language) -> str:
    """Write the decisions on a claim as a collapsible table, with equal decisions on one line."""
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
    body = "".join(_row_of_claim(group, len(used), certificates, words) for group in groups)
    return (
        f'<details><summary><span class="vh">{words["decisions"]}: </span>{title}</summary>'
        f'<div class="scroll"><table class="decisions"><caption class="vh">{words["decisions"]}</caption>'
        f"<thead><tr>{top}</tr></thead><tbody>{body}</tbody></table></div></details>"
    )


def _alike(row: Row) -> Alike:
    decision, corrected = row.as_printed, row.as_corrected
    after = "" if corrected is None else f"{corrected.verdict} {corrected.method}"
    return decision.verdict, decision.method, witness_text(decision.witness, row.field), after


def _row_of_claim(
    rows: Sequence[Row], width: int, certificates: Certificates, words: Language
) -> str:
    first = rows[0]
    verdict, method, witness, _ = _alike(first)
    fields = " ".join(_field(row, certificates.number(row)) for row in rows)
    cells = [
        fields,
        term(method, words),
        words.html(witness, most=MAX_LETTERS),
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
    reasons = _reasons(first.as_printed, words)
    return line + (
        f'<tr class="steps"><td colspan="{width}">{reasons}</td></tr>' if reasons else ""
    )


def _field(row: Row, number: int | None, which: str = "") -> str:
    """Write a field, as a button if there is a certificate to save."""
    shown = field_html(row.field)
    if number is None:
        return f'<span class="field">{shown}</span>'
    return f'<button type="button" data-c="{number}" data-f="{field_text(row.field)}{which}">{shown}</button>'


def _reasons(decision: Decision, words: Language) -> str:
    """Write the steps of a decision, its citations and the methods tried, one per line."""
    steps = [words.html(step.strip(), "li", MAX_LETTERS) for step in decision.steps]
    if len(steps) > MAX_STEPS:
        more = words["more_steps"].format(n=len(steps) - MAX_STEPS + 1)
        steps = [*steps[: MAX_STEPS - 1], f"<li>{more}</li>"]
    out = f"<ol>{''.join(steps)}</ol>" if steps else ""
    for key, texts in (("assumes", decision.assumes), ("tried", decision.tried)):
        out += "".join(f"<p><i>{words[key]}</i> {words.html(text)}</p>" for text in texts)
    return out


def errata_html(rows: Sequence[Row], words: Language) -> str:
    """Typeset all errata as a numbered list."""
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
        reasons = (
            f"{verdict_html(v, words)} {_all_fields([r for r in rest if r.as_printed.verdict == v])}"
            for v in verdicts
        )
        facts.append((words["elsewhere"], "; ".join(reasons)))
    if claim.note:
        facts.append((words["note"], words.html(claim.note, "p")))
    if erratum.witness:
        facts.append((words["counterexample"], words.html(erratum.witness)))
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


Key = tuple[str, str, bool]
"""A claim's id, a field, and whether it is the correction that is certified."""


class Certificates:
    """Certificates by index in the compressed block, from 0."""

    def __init__(
        self, rows: Sequence[Row], progress: Callable[[int, int, str], None] | None = None
    ) -> None:
        self._numbers: dict[Key, int] = {}
        self._lines: list[str] = []
        for done, row in enumerate(rows):
            if progress:
                progress(done, len(rows), "certificates")
            claim = row.claim
            pairs = ((claim.as_printed, row.as_printed), (claim.corrected, row.as_corrected))
            for corrected, (proposition, decision) in enumerate(pairs):
                data = certificate(proposition, decision, row.field)
                if data is not None:
                    self._numbers[claim.id, row.field, bool(corrected)] = len(self._lines)
                    self._lines.append(json.dumps(data, ensure_ascii=False, separators=(",", ":")))

    def __len__(self) -> int:
        return len(self._lines)

    def number(self, row: Row, corrected: bool = False) -> int | None:
        """Return the index of the certificate of a row or of its correction, or None if there is none."""
        return self._numbers.get((row.claim.id, row.field, corrected))

    def packed(self) -> str:
        """Return the lines, joined, deflated (RFC 1950) and encoded in base64."""
        return b64encode(zlib.compress("\n".join(self._lines).encode(), 9)).decode()
