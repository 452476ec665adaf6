"""Ledgers as TOML documents ``hfield-ledger/1``: that of the thesis, and a user's own."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import NamedTuple, NoReturn

from hfield.errors import HFieldError, NotationError, shorten
from hfield.fields.names import ring
from hfield.ledger.claim import NO_FIELD, PANEL, UNIVERSAL, Claim, Proposition
from hfield.ledger.columns import split_columns
from hfield.ledger.propositions import Assertion, Every
from hfield.prover.statements.setting import read_setting
from hfield.syntax import plain

SCHEMA = "hfield-ledger/1"
NAMING = (
    "id",
    "name",
    "section",
    "kind",
    "statement",
)  # made of `holds` and the number of the table
TEXTS = (*NAMING, "printed", "language", "note", "algebra", "holds_words", "corrected_words")
STATEMENTS = ("holds", "corrected", "spoilt", "given")
LISTS = (*STATEMENTS, "fields")
FLAGS = ("headline",)
MAX_BYTES = 4_000_000


class LedgerError(HFieldError, ValueError):
    """A ledger cannot be read; the message names the file, the line or the claim, and the key.

    >>> issubclass(LedgerError, ValueError)
    True
    """


@dataclass(frozen=True)
class Propositions:
    """The propositions of a claim that are not statements of the language and are decided in Python."""

    as_printed: Proposition | None = None
    spoilt: Proposition | None = None
    corrected: Proposition | None = None


def read_ledger(path: str | Path) -> tuple[Claim, ...]:
    """Read a user's ledger from a file, and check that every statement can be read over some field.

    Raises :class:`LedgerError` for a file that is missing or not TOML, an unknown key, a value of the wrong
    kind, an unreadable statement, a field that does not exist, or a repeated id.
    """
    try:
        content = Path(path).read_bytes()
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise LedgerError(f"cannot read {shorten(str(path))!r}: {reason}") from error
    if len(content) > MAX_BYTES:
        raise LedgerError(f"{path} is larger than {MAX_BYTES} bytes")
    try:
        text = content.decode("utf-8-sig")  # editors may put a mark in front
    except UnicodeDecodeError as error:
        raise LedgerError(f"{path} is not UTF-8 text (byte {error.start + 1})") from None
    return _Document(text, str(path), ("", str(path))).claims({}, verify=True)


def read_title(path: str | Path) -> str:
    """Return the title of a readable ledger, as given at its top, or the name of its file."""
    text = Path(path).read_text(encoding="utf-8-sig")
    return _Document(text, str(path)).title or Path(path).stem


def read_ledgers(paths: Sequence[str | Path]) -> tuple[Claim, ...]:
    """Read several ledgers as one. Raises :class:`LedgerError`, also for a repeated id."""
    found: dict[str, str | Path] = {}
    out: list[Claim] = []
    for path in paths:
        for claim in read_ledger(path):
            if claim.id in found:
                raise LedgerError(
                    f"{path}, claim {shorten(claim.id)!r}, key 'id': it is in {found[claim.id]} too"
                )
            found[claim.id] = path
            out.append(claim)
    return tuple(out)


def load(
    package: str, file: str, computed: Mapping[str, Propositions] | None = None
) -> tuple[Claim, ...]:
    """Load a ledger of a package; ``computed`` maps ids to propositions decided in Python."""
    text = (files(package) / file).read_text(encoding="utf-8")
    return _Document(text, file, (package, file)).claims(computed or {}, verify=False)


class ClaimTable(NamedTuple):
    """The values of one table by their keys: texts in one line, lists of them, and flags."""

    texts: dict[str, str]
    lists: dict[str, tuple[str, ...]]
    flags: dict[str, bool]


class _Document:
    """One file: its text (for line numbers) and its tables."""

    def __init__(self, text: str, name: str, source: tuple[str, str] = ("", "")) -> None:
        self.text, self.name, self.source = text, name, source
        try:
            data = tomllib.loads(text)
        except (tomllib.TOMLDecodeError, RecursionError) as error:
            raise LedgerError(f"{name} is not TOML: {error}") from None
        for key in data:
            if key not in ("schema", "title", "claims"):
                self.fail(None, key, "there is no such key; a ledger has [[claims]] tables")
        title = data.get("title", "")
        if not isinstance(title, str):
            self.fail(None, "title", f"expected a text, found {type(title).__name__}")
        self.title = " ".join(title.split())
        if data.get("schema", SCHEMA) != SCHEMA:
            self.fail(None, "schema", f"expected {SCHEMA!r}, found {data['schema']!r}")
        self.tables = data.get("claims", [])
        if not isinstance(self.tables, list) or not self.tables:
            self.fail(None, "claims", "expected at least one table [[claims]]")
        self.numbers: dict[str, int] = {}  # which table a claim is, by its id

    def claims(self, computed: Mapping[str, Propositions], verify: bool) -> tuple[Claim, ...]:
        """Return the claims in order; with ``verify`` check that each statement can be read over
        its fields.
        """
        found: dict[str, Claim] = {}
        for number, table in enumerate(self.tables, 1):
            if not isinstance(table, dict):
                self.fail(None, "claims", f"entry {number} is not a table: write [[claims]]")
            data = self._table(table, number)
            claim = self._claim(data, computed.get(data.texts["id"], Propositions()))
            if claim.id in found:
                self.fail(claim.id, "id", "this id comes twice")
            found[claim.id] = claim
            if verify:
                self._verify(claim, data)
        unused = [name for name in computed if name not in found]
        if unused:
            self.fail(None, "claims", f"there is no claim {', '.join(unused)}")
        return tuple(found.values())

    def fail(self, claim: str | None, key: str, why: str) -> NoReturn:
        """Raise :class:`LedgerError` about a key of a claim, with the line number."""
        where = "" if claim is None else f", claim {shorten(claim)!r}"
        line = self._line(claim, key)
        at = "" if line is None else f":{line}"
        raise LedgerError(f"{self.name}{at}{where}, key {shorten(key)!r}: {why}")

    def _line(self, claim: str | None, key: str) -> int | None:
        lines = [line.strip() for line in self.text.splitlines()]
        start, end = 0, len(lines)
        if claim is not None:
            heads = [n for n, line in enumerate(lines) if line.startswith("[[claims]]")]
            own = self.numbers[claim] - 1
            if own >= len(heads):
                return None
            start, end = heads[own], [*heads, end][own + 1]
        for n in range(start, end):
            if re.match(rf"\[*\[?\s*[\"']?{re.escape(key)}[\"']?\s*(=|\])", lines[n]):
                return n + 1
        return start + 1 if claim is not None else None

    def _table(self, table: Mapping[str, object], number: int) -> ClaimTable:
        """Return one table with its values read: texts on one line, lists as tuples, names."""
        raw = table.get("id")
        name = raw if isinstance(raw, str) and raw.strip() else f"number {number}"
        self.numbers[name] = number
        out = ClaimTable({}, {}, {})
        for key, value in table.items():
            if key in FLAGS:
                if not isinstance(value, bool):
                    self.fail(name, key, f"expected true or false, found {shorten(repr(value))}")
                out.flags[key] = value
            elif key in TEXTS:
                out.texts[key] = self._text(name, key, value)
            elif key in LISTS:
                items = value if isinstance(value, list) else [value]
                if not items:
                    self.fail(name, key, "the list is empty; leave the key out")
                read = plain if key in STATEMENTS else str
                out.lists[key] = tuple(read(self._text(name, key, item)) for item in items)
            else:
                known = ", ".join((*TEXTS, *LISTS, *FLAGS))
                self.fail(name, key, f"there is no such key; a claim has {known}")
        for key in NAMING:
            if out.texts.get(key) == "":
                self.fail(name, key, "it is empty; write a text, or leave the key out")
        if "statement" not in out.texts and "holds" not in out.lists:
            self.fail(
                name, "holds", "it is missing; a claim has `holds`, or at least a `statement`"
            )
        id = out.texts.setdefault("id", f"E{number}")
        self.numbers[id] = number
        said = "; ".join(out.lists.get("holds", ()))
        for key, text in (("name", id), ("section", "1"), ("kind", "claim"), ("statement", said)):
            out.texts.setdefault(key, text)
        return out

    def _text(self, name: str, key: str, value: object) -> str:
        if not isinstance(value, str):
            found = shorten(repr(value))
            self.fail(name, key, f"expected a text in quotes, found {found}")
        return " ".join(value.split())

    def _claim(self, data: ClaimTable, computed: Propositions) -> Claim:
        texts = data.texts
        return Claim(
            texts["id"],
            texts["name"],
            texts["kind"],
            texts["statement"],
            texts.get("printed", ""),
            computed.as_printed or self._proposition(data, "holds"),
            computed.spoilt or self._proposition(data, "spoilt"),
            computed.corrected or self._proposition(data, "corrected"),
            texts.get("note", ""),
            data.flags.get("headline", False),
            texts["section"],
            self._fields(data),
            self.source,
            texts.get("language", ""),
        )

    def _proposition(self, data: ClaimTable, key: str) -> Proposition | None:
        texts = data.lists.get(key)
        if texts is None:
            return None
        given, algebra = data.lists.get("given", ()), data.texts.get("algebra")
        parts = [Assertion(text, given, algebra=algebra) for text in texts]
        words = data.texts.get(f"{key}_words", "")
        if len(parts) > 1:
            return Every(tuple(parts), words)
        return Assertion(texts[0], given, words, algebra)

    def _fields(self, data: ClaimTable) -> tuple[str, ...]:
        """Return the columns of the claim: those it names, that of its algebra, or the panel."""
        name, algebra = data.texts["id"], data.texts.get("algebra")
        own = None
        if algebra is not None:
            try:
                inside = read_setting(None, algebra).field
            except HFieldError as error:
                self.fail(name, "algebra", str(error))
            own = None if inside is None else inside.name
        if "fields" not in data.lists:
            return PANEL if own is None else (own,)
        try:
            columns = tuple(split_columns(data.lists["fields"]))
        except HFieldError as error:
            self.fail(name, "fields", str(error))
        if NO_FIELD in columns and columns != (NO_FIELD,):
            self.fail(
                name, "fields", f"{NO_FIELD!r} is for a claim about no field, and stands alone"
            )
        for column in columns:
            if own not in (None, column):
                self.fail(
                    name, "fields", f"the algebra is over {own}, so {column!r} cannot be a column"
                )
        return columns

    def _verify(self, claim: Claim, data: ClaimTable) -> None:
        """Check that each statement can be read in at least one column of the claim."""
        from hfield.prover.statements.language import read_statement

        if claim.as_printed is None and ("corrected" in data.lists or "spoilt" in data.lists):
            self.fail(
                claim.id, "holds", "it is missing, though the claim has a corrected or a spoilt"
            )
        for key in STATEMENTS:
            for text in data.lists.get(key, ()):
                failed: NotationError | None = None
                for column in claim.fields:
                    field = None if column in (UNIVERSAL, NO_FIELD) else ring(column)
                    try:
                        setting = read_setting(field, data.texts.get("algebra"))
                        read_statement(
                            text,
                            setting.field,
                            (),
                            setting.letters,
                            setting.constants,
                            setting.table,
                        )
                        break
                    except NotationError as error:
                        failed = failed or error
                else:
                    self.fail(claim.id, key, str(failed))
