"""``check``: one certificate in, what it establishes out. Searches for nothing, trusts nothing.

The target is derived from ``statement``, ``algebra`` and ``field``; the evidence has to show it.
docs/certificates.md describes the format.
"""

from dataclasses import dataclass

from hfield.certificates.glossary import CERTIFIED, FIELD, KEYS, REFUTED, SCHEMA, THEOREMS
from hfield.certificates.json_text import read_json
from hfield.certificates.pin import Pin
from hfield.certificates.rejection import (
    Rejected,
    a_text,
    an_object,
    one_line,
    reject,
    shown,
    texts,
)
from hfield.certificates.statement import read_setting
from hfield.certificates.vocabulary.logic import establish_any, meaning
from hfield.certificates.work import bounded

MAX_ASSUMES = 20


@dataclass(frozen=True)
class Established:
    """What a certificate establishes; ``scope`` is ``commutative rings``, ``fields`` or ``field``.

    ``assumes`` are the general ``theorems`` that it cites, and ``assumptions``: whatever else it takes for
    granted. ``vacuous`` lists the parts of an ``every{…}`` that hold because their hypotheses never do.
    """

    statement: str
    algebra: str
    field: str | None
    verdict: str
    scope: str
    assumes: tuple[str, ...]
    vacuous: tuple[str, ...] = ()

    @property
    def theorems(self) -> tuple[str, ...]:
        """What is cited of the theorems that are listed."""
        return tuple(text for text in self.assumes if text in THEOREMS)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """What is cited and is no theorem that is listed."""
        return tuple(text for text in self.assumes if text not in THEOREMS)

    @property
    def where(self) -> str:
        """How far the verdict reaches, in words."""
        if self.field is not None:
            return f"over {one_line(self.field)}"
        if self.scope == FIELD:
            return "as a statement on all fields" if self.verdict == REFUTED else "as it stands"
        return f"over all {self.scope}"

    def lines(self) -> list[str]:
        """Return everything in lines, each of one thing, none cut."""
        return [
            f"{self.verdict} {self.where}",
            f"statement: {one_line(self.statement)}",
            f"field: {one_line(self.field or 'all')}",
            f"algebra: {one_line(self.algebra)}",
            *(f"vacuous part: {one_line(part)}" for part in self.vacuous),
            *(f"cites the theorem: {one_line(text)}" for text in self.theorems),
            *(f"assumes, unproved: {one_line(text)}" for text in self.assumptions),
        ]

    def __str__(self) -> str:
        return "\n".join(self.lines())


def check_text(text: str, pin: Pin | None = None) -> Established:
    """Check a certificate from its JSON text. Raises :class:`Rejected`."""
    return check(read_json(text), pin)


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
    c = an_object(data, " ".join(KEYS), "a certificate")
    if c["schema"] != SCHEMA:
        reject(f"the schema must be {SCHEMA!r}")
    statement, algebra = a_text(c["statement"], "statement"), a_text(c["algebra"], "algebra")
    field = None if c["field"] is None else a_text(c["field"], "field")
    if c["verdict"] not in CERTIFIED:
        reject(f"the verdict must be one of {', '.join(CERTIFIED)}")
    if not statement.strip():
        reject("the statement is empty")
    setting = read_setting(algebra, field)
    if pin is not None:
        pin.check(statement, algebra, field)
    found = establish_any(statement, setting, c["verdict"], c["evidence"])
    if c["method"] != found.method:
        reject(f"the method {shown(c['method'])!r} is not that of the evidence: {found.method}")
    assumes = texts(c["assumes"], "assumes")
    if (
        len(assumes) > MAX_ASSUMES
        or set(assumes) != set(found.cites)
        or len(set(assumes)) < len(assumes)
    ):
        reject(
            "'assumes' does not list exactly what the evidence cites: "
            + ("; ".join(found.cites) or "nothing")
        )
    return Established(
        statement, algebra, field, c["verdict"], found.scope, tuple(assumes), found.vacuous
    )


__all__ = ["Established", "Pin", "Rejected", "check", "check_text", "meaning"]
