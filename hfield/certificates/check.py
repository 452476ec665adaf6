"""``check``: one certificate in, what it establishes out. Searches for nothing, trusts nothing.

The target is derived from ``statement``, ``algebra`` and ``field``; the evidence has to show it.
docs/certificates.md describes the format.
"""

import json
import re
from dataclasses import dataclass
from typing import Any, NoReturn

from hfield.certificates.rejection import (
    MAX_DIGITS,
    Rejected,
    a_text,
    an_object,
    reject,
    shown,
    texts,
)
from hfield.certificates.scalars.fields import read_field
from hfield.certificates.statement import read_setting
from hfield.certificates.vocabulary.logic import establish_any, meaning
from hfield.certificates.work import bounded

SCHEMA = "hfield-cert/1"
KEYS = "schema statement algebra field verdict method assumes evidence"
VERDICTS = ("proved", "refuted", "vacuous")
METHODS = {
    *("identity", "implication", "counterexample", "exhaustion", "witness", "multilinear"),
    *("presentation", "algebra", "linear algebra", "Smith form", "basis tuples", "determinant"),
    *("count", "anisotropic norm", "zero norm", "level", "sum of squares", "ordering"),
    *("closed field", "all choices of roots", "unique roots", "choice of roots"),
    "floats, exact on small integers",
}
MAX_BYTES = 8_000_000
MAX_NESTING = 120
MAX_ASSUMES = 20


@dataclass(frozen=True)
class Established:
    """What a certificate establishes; ``scope`` is ``commutative rings``, ``fields`` or ``field``."""

    statement: str
    algebra: str
    field: str | None
    verdict: str
    scope: str
    assumes: tuple[str, ...]

    def __str__(self) -> str:
        where = f"over {self.field}"
        if self.scope == "field" and self.field is None:
            where = "as it stands"
        elif self.field is None and self.verdict == "proved":
            where = f"over all {self.scope}"
        elif self.field is None:
            where = "over all fields at once"
        given = f", given that {'; '.join(self.assumes)}" if self.assumes else ""
        return f"{self.verdict} {where}, in {self.algebra}: {shown(self.statement, 200)}{given}"


@dataclass(frozen=True)
class Pin:
    """What a certificate has to be about. ``field`` None is all fields; ``any_field`` any at all.

    Statements are compared as trees, algebras as constants; ``statements`` are alternatives.
    """

    statements: tuple[str, ...]
    field: str | None = None
    algebra: str | None = None
    any_field: bool = False

    def readable(self) -> "Pin":
        """Return the pin itself. Raises :class:`Rejected` for a statement that cannot be read."""
        for statement in self.statements:
            meaning(statement)
        return self


def check_text(text: str, pin: Pin | None = None) -> Established:
    """Check a certificate from its JSON text. Raises :class:`Rejected`."""
    if len(text) > MAX_BYTES:
        reject(f"the file has more than {MAX_BYTES} characters")
    _check_nesting(text)
    try:
        data = json.loads(
            text,
            object_pairs_hook=_object,
            parse_float=_float,
            parse_int=_int,
            parse_constant=_float,
        )
    except ValueError as error:
        reject(f"this is no JSON: {shown(str(error))}")
    return check(data, pin)


def check(data: object, pin: Pin | None = None) -> Established:
    """Check a certificate from JSON data. Raises :class:`Rejected`, and nothing else."""
    try:
        with bounded():
            return _check(data, pin)
    except RecursionError:
        reject("the certificate nests too deeply")
    except MemoryError:
        reject("the certificate needs too much memory")
    except ArithmeticError as error:
        reject(f"the certificate cannot be evaluated: {shown(str(error))}")


def _check(data: object, pin: Pin | None) -> Established:
    c = an_object(data, KEYS, "a certificate")
    if c["schema"] != SCHEMA:
        reject(f"the schema must be {SCHEMA!r}")
    statement, algebra = a_text(c["statement"], "statement"), a_text(c["algebra"], "algebra")
    field = None if c["field"] is None else a_text(c["field"], "field")
    if c["verdict"] not in VERDICTS:
        reject(f"the verdict must be one of {', '.join(VERDICTS)}")
    if not statement.strip():
        reject("the statement is empty")
    setting = read_setting(algebra, field)
    if pin is not None:
        check_pin(pin, statement, algebra, field)
    for method in a_text(c["method"], "method", 400).split("; "):
        if method not in METHODS:
            reject(f"there is no method {shown(method)!r}")
    scope, cites = establish_any(statement, setting, c["verdict"], c["evidence"])
    assumes = texts(c["assumes"], "assumes")
    if len(assumes) > MAX_ASSUMES or set(assumes) != set(cites) or len(set(assumes)) < len(assumes):
        reject(
            "'assumes' does not list exactly what the evidence cites: "
            + ("; ".join(cites) or "nothing")
        )
    return Established(statement, algebra, field, c["verdict"], scope, tuple(assumes))


def cited(data: dict[str, Any]) -> list[str]:
    """Return what the evidence of a certificate cites, whatever ``assumes`` says.

    Raises :class:`Rejected` when the evidence does not show the verdict.
    """
    with bounded():
        setting = read_setting(data["algebra"], data["field"])
        found = establish_any(data["statement"], setting, data["verdict"], data["evidence"])
    return list(found[1])


def check_pin(pin: Pin, statement: str, algebra: str, field: str | None) -> None:
    """Reject a certificate about anything else than the pin says."""
    if not any(meaning(statement) == meaning(s) for s in pin.statements):
        reject(f"this is about another statement: {shown(statement, 120)}")
    if not pin.any_field:
        here = None if field is None else read_field(field).name
        wanted = None if pin.field is None else read_field(pin.field).name
        if here != wanted:
            reject(f"this is about {here or 'all fields'}, not about {wanted or 'all fields'}")
    wanted_algebra = pin.algebra or f"(-1,-1|{'F' if field is None else field})"
    if read_setting(wanted_algebra, field).constants != read_setting(algebra, field).constants:
        reject(f"this is about the algebra {shown(algebra)}")


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    out = dict(pairs)
    if len(out) < len(pairs):
        reject("an object has the same key twice")
    return out


def _float(text: str) -> NoReturn:
    reject(f"the number {shown(text)} is no integer")


def _int(text: str) -> int:
    if len(text) > MAX_DIGITS + 1:
        reject(f"a number has more than {MAX_DIGITS} digits")
    return int(text)


def _check_nesting(text: str) -> None:
    depth = 0
    for mark in re.finditer(r'"(?:[^"\\]|\\.)*"|[\[\]{}]', text):
        char = mark[0]
        depth += (char in "[{") - (char in "]}")
        if depth > MAX_NESTING:
            reject(f"the file nests deeper than {MAX_NESTING} levels")


__all__ = ["Established", "Pin", "Rejected", "check", "check_text", "meaning"]
