"""What the ledger calls kinds of claims and ways of proof, in the language of the page."""

from __future__ import annotations

import re
from html import escape

from hfield.report.markup import Words

_POLISH = {
    "algebra": "rachunek w algebrze",
    "all choices of roots": "każdy wybór pierwiastków",
    "anisotropic norm": "norma anizotropowa",
    "announcement": "zapowiedź",
    "assumption": "założenie",
    "basis tuples": "układy elementów bazy",
    "choice of roots": "wybór pierwiastków",
    "claim": "stwierdzenie",
    "closed field": "ciało domknięte",
    "computation": "obliczenie",
    "convention": "umowa",
    "corollary": "wniosek",
    "count": "zliczanie",
    "counterexample": "kontrprzykład",
    "data": "dane",
    "definition": "definicja",
    "determinant": "wyznacznik",
    "example": "przykład",
    "exhaustion": "sprawdzenie wszystkich przypadków",
    "fact": "fakt",
    "formula": "wzór",
    "function": "funkcja",
    "identity": "tożsamość",
    "implication": "implikacja",
    "implied converse": "domyślne odwrócenie",
    "lemma": "lemat",
    "level": "poziom ciała",
    "linear algebra": "algebra liniowa",
    "matrix": "macierz",
    "no meaning here": "tu bez znaczenia",
    "no order": "brak porządku",
    "not checkable": "nie do sprawdzenia",
    "notation": "zapis",
    "number": "liczba",
    "ordering": "porządek",
    "presentation": "generatory i relacje",
    "proof": "dowód",
    "proof formula": "wzór z dowodu",
    "remark": "uwaga",
    "Smith form": "postać Smitha",
    "spec": "opis działania",
    "sum of squares": "suma kwadratów",
    "term": "termin",
    "terminology": "terminologia",
    "theorem": "twierdzenie",
    "thm": "twierdzenie",
    "title": "tytuł",
    "unique roots": "jedyność pierwiastków",
    "witness": "świadek",
    "zero norm": "norma zero",
}
_NUMBERED = re.compile(r"(\D+) (\d[\d.]*)( proof)?")


def term(text: str, words: Words) -> str:
    """Set the kind of a claim or a way of proof; what has no translation stays and is marked as English.

    >>> from hfield.report.words import POLISH
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
        name = _POLISH.get(what, "")
        return name and f"{name} {number}" + (", dowód" if proof else "")
    return _POLISH.get(text, "")
