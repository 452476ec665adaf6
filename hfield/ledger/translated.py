"""The texts of a ledger in another language.

Beside a ledger ``sheet.toml`` there may be a file ``sheet.pl.toml`` with a table for each claim and a table
of phrases, ``"over {F} it is false" = "nad {F} jest to fałsz"``. The content of braces is a formula, which is
kept, or a phrase. A text that matches no phrase stays untranslated; nothing is guessed. ``names`` lists words
that occur in formulas.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from pathlib import Path

from hfield.errors import NotationError
from hfield.ledger.claim import Claim
from hfield.ledger.document import LedgerError
from hfield.prover.statements.printing import to_unicode
from hfield.prover.steps import Step
from hfield.syntax import parse

Source = tuple[str, str]
"""A package and a file in it; or nothing and a path."""

SIGNS = frozenset(
    {"sqrt", "norm", "conj", "inv", "trace", "comm", "scalar", "vector", "mod", "Vec"}
    | {"det", "dim", "cos", "sin", "arctg", "tan", "diag", "max", "min"}
)
_WORD = re.compile(r"\b(?:is|it|in|of|to|so|as|by|if|on|or|at|an|no|be)\b|[A-Za-z]{3,}")
_NAME = re.compile(
    "[eijk]+|[a-z]+[A-Z][A-Za-z]*"
)  # products of the basis, names as programs have them
_SLOT = re.compile(r"\{(\w+)\}")
_DECIMAL = re.compile(r"-?\d+\.\d+(?:e-?\d+)?")
_DEEPEST = 6  # phrases within phrases
DECIMAL_COMMA = frozenset({"pl"})
"""The languages that write 0,5 for 0.5."""


@dataclass(frozen=True)
class TranslatedClaim:
    """The texts of a claim in another language; ``holds`` and ``corrected`` are for propositions in words."""

    name: str
    statement: str
    note: str = ""
    holds: str = ""
    corrected: str = ""


class Translation:
    """Translations: texts of claims by id, whole texts by the English text, and phrases with slots.

    Raises :class:`LedgerError` for a document of texts that cannot be read.
    """

    def __init__(self, claims: Iterable[Claim], language: str, more: Sequence[Source] = ()) -> None:
        self._language, listed = language, list(claims)
        sources = dict.fromkeys((*(claim.source for claim in listed), *more))
        documents = [_document(source, language) for source in sources]
        self._names = SIGNS.union(*(d.names for d in documents))
        self._by_claim = {
            key: TranslatedClaim(**data) for d in documents for key, data in d.claims.items()
        }
        self._whole = dict(pair for claim in listed for pair in self._pairs(claim))
        self._phrases: list[tuple[re.Pattern[str], str]] = []
        for document in documents:
            for text, said in document.phrases.items():
                if _SLOT.search(text):
                    self._phrases.append((_pattern(text), said))
                else:
                    self._whole[text] = said
        self._said: dict[str, str | None] = {}

    def for_claim(self, claim: Claim) -> TranslatedClaim | None:
        """Return the translated text of a claim, or None."""
        return self._by_claim.get(claim.id)

    def printed(self, claim: Claim) -> str:
        """Return the printed text, quoted or in the ledger's words."""
        return self._whole.get(claim.printed, claim.printed)

    def _pairs(self, claim: Claim) -> Iterator[tuple[str, str]]:
        translated_claim = self.for_claim(claim)
        if translated_claim is None:
            return
        yield claim.statement, translated_claim.statement
        pairs = [(claim.note, translated_claim.note)]
        for proposition, said in (
            (claim.as_printed, translated_claim.holds),
            (claim.corrected, translated_claim.corrected),
        ):
            pairs += [] if proposition is None else [(proposition.text, said)]
        yield from ((text, said) for text, said in pairs if text and said)

    def say(self, text: str, depth: int = _DEEPEST) -> str | None:
        """Translate a text, leaving formulas unchanged; None if a part has no translation."""
        if depth < _DEEPEST:
            return self._say(text, depth)
        if isinstance(text, Step):
            return text.said(self._language, self.say)
        text = " ".join(text.split())
        if text not in self._said:
            self._said[text] = self._say(text, depth)
        return self._said[text]

    def _say(self, text: str, depth: int) -> str | None:
        if text in self._whole:
            return self._whole[text]
        if _DECIMAL.fullmatch(text) and self._language in DECIMAL_COMMA:
            return text.replace(".", ",")
        if is_formula(text, self._names):
            return _in_signs(text)
        for pattern, said in self._phrases if depth else ():
            if found := pattern.fullmatch(text):
                parts = {key: self.say(part, depth - 1) for key, part in found.groupdict().items()}
                if None not in parts.values():
                    return _SLOT.sub(lambda slot, parts=parts: parts[slot[1]], said)  # type: ignore[misc]
        return None


def is_formula(text: str, names: frozenset[str] = SIGNS) -> bool:
    """Return whether a text has no words, but only letters, products of the basis, names, or a statement's
    syntax.

    >>> is_formula("q = 1 + ijk"), is_formula("p == 0 or q == 0"), is_formula("q is 0")
    (True, True, False)
    """
    if all(word in names or _NAME.fullmatch(word) for word in _WORD.findall(text)):
        return True
    if not re.search("==|!=", text):
        return False
    try:
        parse(text)
    except NotationError:
        return False
    return True


def _in_signs(text: str) -> str:
    """Write a statement of the language without its English words; leave any other formula unchanged."""
    if not re.search(r"\b(and|or|not|exists)\b", text):
        return text
    text = to_unicode(parse(text))
    for word, sign in (("and", "∧"), ("or", "∨"), ("not", "¬"), ("exists", "∃")):
        text = re.sub(rf"\b{word}\b", sign, text)
    return text


def _pattern(text: str) -> re.Pattern[str]:
    """Return a pattern with lazy slots; a repeated slot must match the same text."""
    seen: set[str] = set()
    out = ""
    for n, part in enumerate(_SLOT.split(text)):
        if n % 2 == 0:
            out += re.escape(part)
        else:
            out += f"(?P={part})" if part in seen else f"(?P<{part}>.+?)"
            seen.add(part)
    return re.compile(out, re.DOTALL)


@dataclass(frozen=True)
class _LedgerTexts:
    """The texts beside a ledger: of claims by their ids, phrases, and words of formulas."""

    claims: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    phrases: Mapping[str, str] = field(default_factory=dict)
    names: Sequence[str] = ()


@cache
def _document(source: Source, language: str) -> _LedgerTexts:
    """Read the texts beside a ledger; nothing if there are none."""
    package, ledger = source
    name = f"{ledger.removesuffix('.toml')}.{language}.toml"
    path = files(package) / name if package else Path(name)
    if not ledger or not path.is_file():
        return _LedgerTexts()
    try:
        found = tomllib.loads(path.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError, OSError) as error:
        raise LedgerError(f"{name} cannot be read: {error}") from None
    return _checked(found, name)


def _checked(document: Mapping[str, object], name: str) -> _LedgerTexts:
    """Return claims, phrases and names of a document. Raises :class:`LedgerError` for anything else."""
    kinds: dict[str, type] = {"claims": dict, "phrases": dict, "names": list}
    for key, value in document.items():
        if not isinstance(value, kinds.get(key, ())):
            raise LedgerError(
                f"{name}: {key!r} is not a table of claims or phrases, nor a list of names"
            )
    claims, phrases = document.get("claims", {}), document.get("phrases", {})
    names = document.get("names", [])
    assert isinstance(claims, dict)
    assert isinstance(phrases, dict)
    assert isinstance(names, list)
    for key, texts in claims.items():
        keys = set(texts) if isinstance(texts, dict) else {"?"}
        if not {"name", "statement"} <= keys <= set(TranslatedClaim.__dataclass_fields__):
            known = ", ".join(TranslatedClaim.__dataclass_fields__)
            raise LedgerError(
                f"{name}, claim {key!r}: expected name and statement; there are {known}"
            )
        _check_texts(texts, f"{name}, claim {key!r}")
    _check_texts(phrases, f"{name}, phrases")
    _check_texts({f"names, entry {n}": x for n, x in enumerate(names, 1)}, name)
    for text, said in phrases.items():
        if not set(_SLOT.findall(said)) <= set(_SLOT.findall(text)):
            raise LedgerError(f"{name}, phrase {text!r}: {said!r} has another slot")
    return _LedgerTexts(claims, phrases, names)


def _check_texts(texts: Mapping[str, object], where: str) -> None:
    for key, value in texts.items():
        if not isinstance(value, str):
            raise LedgerError(f"{where}, key {key!r}: expected a text in quotes")
