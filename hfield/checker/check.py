"""``check``: verify one certificate and return what it establishes.

The target is derived from ``statement``, ``algebra`` and ``field``; the evidence must prove it.
docs/reference/certificates.md describes the format.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from hfield.checker.budget import Budget, bounded
from hfield.checker.evidence import prove
from hfield.checker.first_schema import current
from hfield.checker.glossary import CERTIFIED, FIELD, KEYS, REFUTED, SCHEMA, THEOREMS
from hfield.checker.json_text import read_json
from hfield.checker.language import Meaning
from hfield.checker.rejection import (
    Rejected,
    a_text,
    an_object,
    keyed,
    one_line,
    reject,
    shown,
    texts,
)
from hfield.checker.scalars.fields import read_ring
from hfield.checker.statement import SCALARS, UNKNOWNS, Setting, read_any_setting
from hfield.checker.vocabulary.logic import establish_any, meaning

MAX_ASSUMES = 20


@dataclass(frozen=True)
class Established:
    """The claim that a certificate establishes; ``scope`` is ``commutative rings``, ``fields`` or ``field``.

    ``words`` describe the field, ``rings`` the rings that the statement names. ``assumes`` lists what is
    cited: the general ``theorems``, and other ``assumptions``. ``vacuous`` lists the parts of an ``every{…}``
    that hold because their hypotheses are never true. ``left_out`` lists what the words of the statement say
    beyond the verdict, and what was not checked.
    """

    statement: str
    algebra: str
    field: str | None
    words: str | None
    verdict: str
    scope: str
    assumes: tuple[str, ...]
    vacuous: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    rings: tuple[str, ...] = ()

    @property
    def theorems(self) -> tuple[str, ...]:
        """The cited theorems that are on the list."""
        return tuple(text for text in self.assumes if text in THEOREMS)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """The cited assumptions that are not on the list of theorems."""
        return tuple(text for text in self.assumes if text not in THEOREMS)

    @property
    def where(self) -> str:
        """The scope of the verdict, in words."""
        if self.field is not None:
            return f"over {one_line(self.field)}"
        if self.scope == FIELD:
            return "as a statement on all fields" if self.verdict == REFUTED else "as it stands"
        return f"over all {self.scope}"

    def lines(self) -> list[str]:
        """Return all results as lines, one item per line, none shortened."""
        return [
            f"{self.verdict} {self.where}",
            f"statement: {one_line(self.statement)}",
            f"field: {one_line(f'{self.field}, {self.words}' if self.field else 'all')}",
            f"algebra: {one_line(self.algebra)}",
            *(f"names the ring: {one_line(text)}" for text in self.rings),
            *(f"vacuous part: {one_line(part)}" for part in self.vacuous),
            *(f"left out: {one_line(text)}" for text in self.left_out),
            *(f"cites the theorem: {one_line(text)}" for text in self.theorems),
            *(f"assumes, unproved: {one_line(text)}" for text in self.assumptions),
        ]

    def __str__(self) -> str:
        return "\n".join(self.lines())


@dataclass(frozen=True)
class ExpectedClaim:
    """The claim that a certificate must establish. ``field`` None means all fields; ``any_field`` accepts any
    field.

    Statements are compared as trees, algebras by their constants; ``statements`` are alternatives. ``field``
    is a canonical name or the data of a ring. In the statements no unknown may have the name of an element of
    the field. But if the field is given and the statement is not a ``claim`` (which has no field), the
    field's generators take precedence over scalar unknowns.
    """

    statements: tuple[str, ...]
    field: str | Mapping[str, object] | None = None
    algebra: str | None = None
    any_field: bool = False
    claim: bool = False

    def readable(self) -> "ExpectedClaim":
        """Return the claim. Raises :class:`Rejected` for a statement that cannot be read."""
        for statement in self.statements:
            meaning(statement)
        return self

    def check(self, statement: str, setting: Setting) -> None:
        """Reject a certificate about another claim."""
        said, ring = meaning(statement), setting.field
        if not any(said == meaning(s) for s in self.statements):
            reject(f"this is about another statement: {shown(statement, 120)}")
        here = None if ring is None else ring.name
        wanted = read_ring(self.field).name if isinstance(self.field, Mapping) else self.field
        if not self.any_field and here != wanted:
            reject(f"this is about {here or 'all fields'}, not about {wanted or 'all fields'}")
        letters = set(UNKNOWNS) - set("" if self.claim or self.any_field else SCALARS)
        for name in sorted(_unknowns(said) & letters):
            if ring is not None and ring.constant(("name", name)) is not None:
                reject(f"{name} is an unknown of the statement, and an element of {shown(here)}")
        expected_algebra = self.algebra or f"(-1,-1|{here or 'F'})"
        if not same_algebra(read_any_setting(expected_algebra, ring), setting):
            reject(f"this is about the algebra {shown(setting.algebra)}")


def _unknowns(tree: Meaning) -> set[str]:
    """Return the letters in a tree that are unknowns if no field is given."""
    if len(tree) == 2 and tree[0] == "name" and isinstance(tree[1], str):
        return {tree[1]} & set(UNKNOWNS)
    return {name for part in tree if isinstance(part, tuple) for name in _unknowns(part)}


def same_algebra(one: Setting, other: Setting) -> bool:
    """Return whether the structure constants are equal wherever those of either algebra are defined.

    Tables are equal if names, products and unit are written in the same way.
    """
    if one.table is not None or other.table is not None:
        return one.table == other.table
    if one.constants == other.constants:
        return True
    if set(one.letters) != set(other.letters):
        return False
    try:
        for setting in (one, other):
            for u, v in zip(one.constants, other.constants, strict=True):
                prove(("==", u, v), setting, {"kind": "identity"})
    except Rejected:
        return False
    return True


def check_text(
    text: str, expected: ExpectedClaim | None = None, budget: Budget | None = None
) -> Established:
    """Check a certificate from its JSON text within a budget of work. Raises :class:`Rejected`."""
    budget = budget or Budget()
    with bounded(budget):
        data = read_json(text)
    return check(data, expected, budget)


def check(
    data: object, expected: ExpectedClaim | None = None, budget: Budget | None = None
) -> Established:
    """Check a certificate from JSON data. Raises :class:`Rejected`, and nothing else.

    ``budget`` limits the work; the default ``Budget(10)`` is ten million units of at most one microsecond and
    100 bytes each. Afterwards its ``spent`` is the work done.

    >>> from hfield import prove
    >>> check(prove("p + q == q + p").certificate).verdict
    'proved'
    """
    try:
        with bounded(budget):
            return _check(data, expected)
    except RecursionError:
        reject("the certificate nests too deeply")
    except MemoryError:
        reject("the certificate needs too much memory")
    except ArithmeticError as error:
        reject(f"the certificate cannot be evaluated: {shown(str(error))}")


def _check(data: object, expected: ExpectedClaim | None) -> Established:
    data = keyed(current(data), "a certificate")
    if data.get("schema") != SCHEMA:
        reject(f"the schema must be {SCHEMA!r}")
    c = an_object(data, " ".join(KEYS), "a certificate")
    statement, algebra = a_text(c["statement"], "statement"), a_text(c["algebra"], "algebra")
    ring = None if c["ring"] is None else read_ring(c["ring"])
    field = None if ring is None else ring.name
    if c["field"] != field:
        reject(
            f"the data say {shown(field or 'all fields', 120)}, and not {shown(c['field'], 120)!r}"
        )
    if c["verdict"] not in CERTIFIED:
        reject(f"the verdict must be one of {', '.join(CERTIFIED)}")
    if not statement.strip():
        reject("the statement is empty")
    setting = read_any_setting(algebra, ring)
    if expected is not None:
        expected.check(statement, setting)
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
        statement,
        algebra,
        field,
        None if ring is None else ring.words,
        c["verdict"],
        found.scope,
        tuple(assumes),
        found.vacuous,
        found.left_out,
        tuple(f"{x.name}, {x.words}" for x in found.rings),
    )


__all__ = ["Budget", "Established", "ExpectedClaim", "Rejected", "check", "check_text", "meaning"]
