"""The page as text: template, style and script of our own put into one file that asks for nothing else.

At its head the summary by section, and the claims × fields matrix that the page filters.
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from importlib.resources import files
from itertools import groupby

from hfield.ledger.claim import Claim, Row
from hfield.ledger.matrix import MARKS, columns_of, marked, tally
from hfield.ledger.run import contradictions
from hfield.proving.decision import UNDECIDED, VERDICTS
from hfield.report.chapters import Chapter
from hfield.report.claims import claims_html, errata_html
from hfield.report.markup import Words, anchor, field_html, field_text, table, verdict_html
from hfield.report.packed_certificates import Certificates
from hfield.report.words import Language


def page(
    rows: Sequence[Row],
    certificates: Certificates,
    language: str = "en",
    chapters: Sequence[Chapter] = (),
    ledger: str | None = None,
) -> str:
    """Return the report as one HTML page in ``language``, ``en`` or ``pl``.

    ``ledger`` is the name of a ledger of one's own; without it the rows are the thesis's.
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
    """Set how many claims and decisions there are, by section and verdict, and what is amiss."""
    claims = list(dict.fromkeys(row.claim for row in rows))
    counts = tally(rows)
    figures = [
        (len(claims), words["of_claims"], ""),
        (len(rows), words["rows"], ""),
        *((counts[v], words[v], v) for v in VERDICTS if counts[v]),
        (certificates, words["certificates"], ""),
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
    """Set the controls; a script shows them, as they do nothing without it."""
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
    """Set the matrix: a line a claim, a column a field; a cell has its mark, and its word for readers."""
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
