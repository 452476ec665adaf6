"""One language of the page: its own words, and what claims and decisions say in it."""

from __future__ import annotations

from collections.abc import Sequence

from hfield.errors import shorten
from hfield.ledger.claim import Claim, Row
from hfield.ledger.translated import Told, Translation
from hfield.report.markup import formula, prose
from hfield.report.words import LANGUAGES

OURS = (
    ("hfield.report", "reasons.toml"),
)  # what the prover says, and the claims that Python decides


class Language(dict[str, str]):
    """The page's words; what is written in English and has no translation is marked as English."""

    def __init__(self, name: str, rows: Sequence[Row]) -> None:
        super().__init__(LANGUAGES[name])
        claims = dict.fromkeys(row.claim for row in rows)
        self._translation = None if name == "en" else Translation(claims, name, OURS)

    def told(self, claim: Claim) -> Told | None:
        """Return what a claim says in this language, or None where it is known in English only."""
        if self._translation is None:
            return Told(claim.name, claim.statement, claim.note)
        return self._translation.told(claim)

    def printed(self, claim: Claim) -> str:
        """Set what the thesis prints, in Polish, which is its language."""
        text = self._translation.printed(claim) if self._translation else claim.printed
        return f'<p lang="pl">{prose(text)}</p>'

    def say(self, text: str) -> str | None:
        """Return a text in this language, or None where it is known in English only."""
        return text if self._translation is None else self._translation.say(text)

    def html(self, text: str, tag: str = "span", most: int | None = None) -> str:
        """Set a text in this language, cut after ``most`` letters; what stays English is marked."""
        said = self.say(text)
        shown = text if said is None else said
        body = prose(shown if most is None else shorten(shown, most))
        if said is None:
            return f'<{tag} lang="en">{body}</{tag}>'
        return body if tag == "span" else f"<{tag}>{body}</{tag}>"

    def statement(self, text: str) -> str:
        """Set what is decided: formulas, or a sentence."""
        return formula(text) or self.html(text, "p")

    def name(self, claim: Claim) -> str:
        """Set the name of a claim."""
        told = self.told(claim)
        return prose(told.name) if told else f'<span lang="en">{prose(claim.name)}</span>'
