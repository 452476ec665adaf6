"""Write the report as a LaTeX paper: the table, the claims, the errata."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

from hfield.latex import document, words
from hfield.ledger.claim import Row, by_claim
from hfield.ledger.paper import explanation, marks, slips
from hfield.ledger.report import totals
from hfield.prover.decision import NOT_APPLICABLE, REFUTED, VERDICTS
from hfield.report.page_texts import LANGUAGES


def paper(rows: Sequence[Row], language: str = "en", ledger: str | None = None) -> str:
    """Return the report as a document for pdflatex; unlike the page, it shows one field per claim.

    Each claim is shown over a field over which it is refuted, or else the first field over which it is
    decided.
    """
    from hfield import __version__

    said = LANGUAGES[language]
    title = said["thesis"] if ledger is None else f"{ledger}: {said['title']}"
    parts = [words(said["made_by"].format(version=__version__)), words(said["about"])]
    parts += [rf"\section*{{{words(said['matrix'])}}}", marks(rows), words(totals(rows))]
    parts.append(rf"\section*{{{words(said['claims'])}}}")
    for section, claims in groupby(by_claim(rows), key=lambda own: own[0].claim.section):
        parts.append(rf"\subsection*{{{words(said['section'])} {words(section)}}}")
        parts += [explanation(_telling(own)) for own in claims]
    parts += [rf"\section*{{{words(said['errata'])}}}", slips(rows) or words(said["no_errata"])]
    return document("\n\n".join(parts), title)


def _telling(rows: Sequence[Row]) -> Row:
    """Return the most informative row: the first that is refuted, else the first that is decided."""
    order = (REFUTED, *(v for v in VERDICTS if v not in (REFUTED, NOT_APPLICABLE)), NOT_APPLICABLE)
    return min(rows, key=lambda row: order.index(row.as_printed.verdict))
