"""A claim of a ledger: its text, the propositions that decide it, and its row."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar, Protocol

from hfield.checker.glossary import NOT_APPLICABLE, NOT_CHECKABLE
from hfield.fields.base.ring import Ring
from hfield.prover.decision import PROVED, REFUTED, Decision

UNIVERSAL = "universal"
NO_FIELD = "-"
PANEL = (
    *("QQ", "RR", "CC", "GF(2)", "GF(3)", "GF(4)", "GF(5)", "GF(7)", "GF(8)", "GF(9)", "GF(13)"),
    *("QQ(sqrt(2))", "QQ(I)", "QQ(sqrt(-7))", "QQ(x)", "GF(2)(t)", UNIVERSAL),
)


class Proposition(Protocol):
    """A proposition over each field; ``text`` in words, ``statement`` in formal terms."""

    @property
    def text(self) -> str:
        """The proposition in words or formulas."""

    @property
    def statement(self) -> str:
        """The proposition in the notation of certificates (docs/reference/certificates.md)."""

    def decide(self, field: Ring | None) -> Decision:
        """Decide the proposition over ``field``; None means every commutative ring (or every field, if it
        needs one).
        """


class TemplateProposition:
    """A proposition written by templates, with its parts named in braces."""

    in_words: ClassVar[str] = "{proposition.text}"
    in_certificates: ClassVar[str]

    @property
    def text(self) -> str:
        """The proposition in words."""
        return self.in_words.format_map(vars(self))

    @property
    def statement(self) -> str:
        """The statement in the vocabulary of certificates."""
        return self.in_certificates.format_map(vars(self))


@dataclass(frozen=True)
class Claim:
    """One row of the ledger.

    ``as_printed`` is None for a claim that no program can check, and then ``note`` says why; otherwise
    ``note`` says how the print was read, or why it fails. ``spoilt`` is a variant with one sign, index or
    hypothesis changed, whose verdicts must differ. ``corrected`` is the true statement for a refuted one.
    ``section`` is the section of the thesis; by default it is taken from the id. ``fields`` are the columns
    in which the claim has a row, ``("-",)`` for a claim that is not about a field. ``source`` is the document
    that contains it: a package and a file in it, or an empty package and a path. ``language`` is the language
    of the quotation ``printed``, if it is not English.
    """

    id: str
    name: str
    kind: str
    statement: str
    printed: str
    as_printed: Proposition | None = None
    spoilt: Proposition | None = None
    corrected: Proposition | None = None
    note: str = ""
    headline: bool = False
    section: str = ""
    fields: tuple[str, ...] = PANEL
    source: tuple[str, str] = ("", "")
    language: str = ""

    def __post_init__(self) -> None:
        if not self.section:
            object.__setattr__(self, "section", self.id[1:].split("-")[0])

    @property
    def quotation(self) -> str:
        """The printed text; if it is not in English, in quotation marks with its language."""
        return f"“{self.printed}” ({self.language})" if self.language else self.printed

    @property
    def fieldless(self) -> bool:
        """Whether the claim is not about a field."""
        return self.fields == (NO_FIELD,)

    @property
    def checkable(self) -> bool:
        """Whether a program can decide the claim."""
        return self.as_printed is not None


@dataclass(frozen=True)
class Row:
    """A claim decided over one field, as printed and, if that is refuted, as corrected."""

    claim: Claim
    field: str
    as_printed: Decision
    as_corrected: Decision | None

    def to_json(self, certificate: str | None = None) -> dict[str, object]:
        """Return the row in the schema ``hfield-verify/1``; ``certificate`` is the name of a file."""
        return {
            "id": self.claim.id,
            "field": self.field,
            "as_printed": self.as_printed.verdict,
            "as_corrected": None if self.as_corrected is None else self.as_corrected.verdict,
            "method": self.as_printed.method,
            "witness": self.as_printed.witness,
            "correction": self.correction,
            "certificate": certificate,
        }

    @property
    def correction(self) -> str | None:
        """The corrected statement, if the printed one is refuted."""
        refuted = self.as_printed.verdict == "refuted"
        return self.claim.corrected.text if refuted and self.claim.corrected else None

    @property
    def settled(self) -> bool:
        """Whether there is a verdict, and a refuted claim has a correction that is not refuted."""
        if self.as_printed.verdict == "undecided":
            return False
        return self.as_corrected is None or self.as_corrected.verdict not in (
            "undecided",
            "refuted",
        )


def by_claim(rows: Iterable[Row]) -> list[list[Row]]:
    """Return the rows grouped by claim, with claims in the order of first occurrence."""
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(row.claim.id, []).append(row)
    return list(found.values())


def decide(claim: Claim, field: str) -> Row:
    """Decide ``claim`` over the named field; if the printed claim is refuted, decide the correction as well.

    ``field`` is the text of any field, ``"universal"``, or ``"-"`` for a claim that is not about a field.
    """
    from hfield.fields.names import ring

    if claim.as_printed is None:
        return Row(claim, field, Decision(NOT_APPLICABLE, NOT_CHECKABLE, steps=(claim.note,)), None)
    base = None if field in (UNIVERSAL, NO_FIELD) else ring(field)
    printed = claim.as_printed.decide(base)
    if printed.verdict != "refuted" or claim.corrected is None:
        return Row(claim, field, printed, None)
    return Row(claim, field, printed, claim.corrected.decide(base))


@dataclass(frozen=True)
class ComputedResult:
    """The result of a computation: whether the proposition holds, and the lines that show it.

    ``witness`` contains values at which it fails, if there are any.
    """

    holds: bool
    steps: tuple[str, ...]
    witness: Mapping[str, list[str]] | None = None


@dataclass(frozen=True)
class Computed:
    """A proposition that is not about a field, decided by ``compute``, which runs on each call.

    It has no certificate; running it again checks it.
    """

    text: str
    compute: Callable[[], ComputedResult]
    method: str = "computation"

    @property
    def statement(self) -> str:
        """The proposition in words; there is no certificate for it."""
        return self.text

    def decide(self, field: Ring | None) -> Decision:
        """Compute the result; ``field`` is ignored."""
        found = self.compute()
        verdict = PROVED if found.holds else REFUTED
        witness = None if found.holds else dict(found.witness or {})
        return Decision(verdict, self.method, witness=witness, steps=found.steps)
