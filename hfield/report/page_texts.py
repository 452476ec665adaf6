"""Headings, labels and phrases of the page of a report, in each language."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from html import escape
from pkgutil import get_data

from hfield.errors import shorten
from hfield.ledger.claim import Claim, Row
from hfield.ledger.translated import TranslatedClaim, Translation
from hfield.report.markup import Words, formula, prose

_TABLE = json.loads(get_data("hfield.report", "page_texts.json") or "{}")
ENGLISH: Words = {key: said["en"] for key, said in _TABLE["words"].items()}
POLISH: Words = {key: said["pl"] for key, said in _TABLE["words"].items()}
LANGUAGES = {"en": ENGLISH, "pl": POLISH}
_TERMS: Words = _TABLE["terms"]
_COUNTED: dict[str, dict[str, list[str]]] = _TABLE["counted"]
_NUMBERED = re.compile(r"(\D+) (\d[\d.]*)( proof)?")


def term(text: str, words: Words) -> str:
    """Write the kind of a claim or a method of proof; untranslated text is marked as English.

    >>> term("lemma 3 proof", POLISH), term("identity; implication", POLISH)
    ('lemat 3, dowód', 'tożsamość; implikacja')
    """
    if words["lang"] == "en":
        return escape(text)
    said = [_polish(part) for part in text.split("; ")]
    if all(said):
        return escape("; ".join(said))
    return f'<span lang="en">{escape(text)}</span>'


def _polish(text: str) -> str:
    """Return the Polish translation, or nothing."""
    if found := _NUMBERED.fullmatch(text):
        what, number, proof = found.groups()
        name = _TERMS.get(what, "")
        return name and f"{name} {number}" + (", dowód" if proof else "")
    return _TERMS.get(text, "")


def counted(noun: str, n: int, language: str) -> str:
    """Return a noun in the form that it has after the number n.

    Polish has three forms: after 1, after numbers that end in 2, 3 or 4 but not in 12, 13 or 14, and
    after all others.

    >>> [counted("claims", n, "pl") for n in (1, 22, 12)]
    ['stwierdzenie', 'stwierdzenia', 'stwierdzeń']
    """
    forms = _COUNTED[noun][language]
    if n == 1:
        return forms[0]
    few = n % 10 in (2, 3, 4) and n % 100 not in (12, 13, 14)
    return forms[1] if few else forms[-1]


OURS = (
    ("hfield.report", "reasons.toml"),
)  # the prover's texts, and the claims that are decided in Python


class Language(dict[str, str]):
    """The words of the page in one language; untranslated text is marked as English."""

    def __init__(self, name: str, rows: Sequence[Row]) -> None:
        super().__init__(LANGUAGES[name])
        claims = dict.fromkeys(row.claim for row in rows)
        self._translation = None if name == "en" else Translation(claims, name, OURS)

    def for_claim(self, claim: Claim) -> TranslatedClaim | None:
        """Return the text of a claim in this language, or None if it exists only in English."""
        if self._translation is None:
            return TranslatedClaim(claim.name, claim.statement, claim.note)
        return self._translation.for_claim(claim)

    def printed(self, claim: Claim) -> str:
        """Write the text of the thesis, which is in Polish."""
        text = self._translation.printed(claim) if self._translation else claim.quotation
        return f'<p lang="pl">{prose(text)}</p>'

    def say(self, text: str) -> str | None:
        """Return a text in this language, or None if it exists only in English."""
        return text if self._translation is None else self._translation.say(text)

    def html(self, text: str, tag: str = "span", most: int | None = None) -> str:
        """Write a text in this language, cut after ``most`` characters; untranslated text is marked as
        English.
        """
        said = self.say(text)
        shown = text if said is None else said
        body = prose(shown if most is None else shorten(shown, most))
        if said is None:
            return f'<{tag} lang="en">{body}</{tag}>'
        return body if tag == "span" else f"<{tag}>{body}</{tag}>"

    def statement(self, text: str) -> str:
        """Write the decided statement: formulas, or a sentence."""
        return formula(text) or self.html(text, "p")

    def name(self, claim: Claim) -> str:
        """Typeset the name of a claim."""
        translated = self.for_claim(claim)
        return (
            prose(translated.name) if translated else f'<span lang="en">{prose(claim.name)}</span>'
        )
