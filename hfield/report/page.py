"""The page as text: template, style and script of our own put into one file that asks for nothing else."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from importlib.resources import files

from hfield.ledger.claim import Row
from hfield.report.chapters import Chapter
from hfield.report.claims import claims_html
from hfield.report.errata import errata_html
from hfield.report.matrix import filters_html, matrix_html, summary_html
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
        "in_short": summary_html(rows, len(certificates), words),
        "filters": filters_html(rows, words),
        "table": matrix_html(rows, words),
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
