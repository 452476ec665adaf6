"""The page's own words, and what the ledger calls kinds of claims and ways of proof, in each language."""

from __future__ import annotations

import json
import re
from html import escape
from pkgutil import get_data

from hfield.report.markup import Words

_TABLE = json.loads(get_data("hfield.report", "words.json") or "{}")
ENGLISH: Words = {key: said["en"] for key, said in _TABLE["words"].items()}
POLISH: Words = {key: said["pl"] for key, said in _TABLE["words"].items()}
LANGUAGES = {"en": ENGLISH, "pl": POLISH}
_TERMS: Words = _TABLE["terms"]
_NUMBERED = re.compile(r"(\D+) (\d[\d.]*)( proof)?")


def term(text: str, words: Words) -> str:
    """Set the kind of a claim or a way of proof; what has no translation stays and is marked as English.

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
    """Return the translation, or nothing."""
    if found := _NUMBERED.fullmatch(text):
        what, number, proof = found.groups()
        name = _TERMS.get(what, "")
        return name and f"{name} {number}" + (", dowód" if proof else "")
    return _TERMS.get(text, "")
