"""Propositions and how they combine: statements of the language, and logic between closed ones."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from hfield.certificates.glossary import (
    NO_MEANING,
    NOT_APPLICABLE,
    PROVED,
    REFUTED,
    THE_PANEL,
    UNDECIDED,
    VACUOUS,
    WITNESS,
)
from hfield.errors import NotationError
from hfield.ledger.carried import carried
from hfield.ledger.claim import PANEL, UNIVERSAL, Proposition
from hfield.proving.decide import decide
from hfield.proving.decision import Decision
from hfield.proving.statements.printing import to_text
from hfield.rings import ring
from hfield.rings.base import Ring
from hfield.syntax import Node

TRUE = ("proved", "vacuous")


def written(node: Node | str) -> str:
    """Return a tree as text, and a text as it is."""
    return node if isinstance(node, str) else to_text(node)


@dataclass(frozen=True)
class Statement:
    """A statement of the language, for all values of its unknowns; ``given`` are hypotheses.

    ``words`` say it to people, where the formula is too long to read. ``algebra`` is H if None.
    """

    formula: str
    given: tuple[str, ...] = ()
    words: str = ""
    algebra: str | None = None

    @classmethod
    def of(
        cls, formula: Node | str, given: Sequence[Node | str] = (), words: str = ""
    ) -> Statement:
        """Return the statement that a tree says, under hypotheses that are trees or texts."""
        return cls(written(formula), tuple(map(written, given)), words)

    @property
    def text(self) -> str:
        """The words, or the statement with its hypotheses in front."""
        return self.words or " => ".join((*self.given, self.formula))

    @property
    def statement(self) -> str:
        """The same, as the prover puts the hypotheses in front."""
        parts = (*self.given, self.formula)
        return " => ".join(f"({part})" for part in parts) if self.given else self.formula

    def decide(self, field: Ring | None) -> Decision:
        """Decide it by the prover; what holds over every commutative ring holds over the field.

        Where the field has no such constants as the statement names, it means nothing there.
        """
        if field is not None and self.algebra is None:
            general = carried(self.formula, self.given, field)
            if general is not None:
                return general
        try:
            return decide(self.formula, field, self.given, self.algebra)
        except NotationError as error:
            return Decision(NOT_APPLICABLE, NO_MEANING, steps=(str(error),))


@dataclass(frozen=True)
class Every:
    """All of several propositions: refuted by the first that is refuted."""

    parts: tuple[Proposition, ...]
    words: str = ""

    @property
    def text(self) -> str:
        """The parts, joined."""
        return self.words or " and ".join(part.text for part in self.parts)

    @property
    def statement(self) -> str:
        """The parts, in the vocabulary of certificates."""
        return f"every{{{'; '.join(part.statement for part in self.parts)}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide every part; what stops the proof decides the whole."""
        steps: list[str] = []
        methods: list[str] = []
        proofs: list[dict[str, Any]] = []
        assumes: dict[str, None] = {}
        for n, part in enumerate(self.parts):
            decision = part.decide(field)
            if decision.verdict not in TRUE:
                evidence = {"kind": "part", "part": n, "evidence": decision.evidence}
                return replace(
                    decision, steps=(*steps, part.text, *decision.steps), evidence=evidence
                )
            proofs.append(judged(decision))
            steps += [part.text, *(f"  {step}" for step in decision.steps)]
            methods += [m for m in [decision.method] if m not in methods]
            assumes |= dict.fromkeys(decision.assumes)
        empty = all(proof["verdict"] == "vacuous" for proof in proofs)
        return Decision(
            VACUOUS if empty else PROVED,
            "; ".join(methods),
            steps=tuple(steps),
            assumes=tuple(assumes),
            evidence={"kind": "parts", "parts": proofs},
        )


def judged(decision: Decision) -> dict[str, object]:
    """Return the evidence for a part of a proposition with its verdict."""
    return {"verdict": decision.verdict, "evidence": decision.evidence}


@dataclass(frozen=True)
class Implication:
    """``hypothesis ⇒ conclusion`` between propositions about the field alone.

    Over all fields at once it is proved by ``everywhere``; without that, a field of the panel is
    looked for that refutes it.
    """

    hypothesis: Proposition
    conclusion: Proposition
    everywhere: Proposition | None = None

    @property
    def text(self) -> str:
        """The two sides in words."""
        return f"if {self.hypothesis.text}, then {self.conclusion.text}"

    @property
    def statement(self) -> str:
        """The two sides, in the vocabulary of certificates."""
        return f"implies{{{self.hypothesis.statement}; {self.conclusion.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide both sides over ``field``; vacuous where the hypothesis is refuted."""
        if field is None:
            return by_lemmas(self.everywhere) if self.everywhere else search_panel(self)
        first = self.hypothesis.decide(field)
        if first.verdict == "refuted":
            steps = (f"The hypothesis fails over {field}:", *first.steps)
            evidence: dict[str, Any] = {"kind": "hypothesis", "evidence": first.evidence}
            return replace(first, verdict="vacuous", steps=steps, evidence=evidence)
        if first.verdict not in TRUE:
            return first
        second = self.conclusion.decide(field)
        evidence = {"kind": "conclusion", "evidence": second.evidence}
        if second.verdict == "refuted":
            evidence = {"kind": "both", "left": judged(first), "right": judged(second)}
        return replace(second, steps=(*first.steps, *second.steps), evidence=evidence)


@dataclass(frozen=True)
class Equivalence:
    """``left ⇔ right`` between propositions about the field alone; as :class:`Implication`."""

    left: Proposition
    right: Proposition
    everywhere: Proposition | None = None

    @property
    def text(self) -> str:
        """The two sides in words."""
        return f"{self.left.text} if and only if {self.right.text}"

    @property
    def statement(self) -> str:
        """The two sides, in the vocabulary of certificates."""
        return f"iff{{{self.left.statement}; {self.right.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide both sides over ``field`` and compare."""
        if field is None:
            return by_lemmas(self.everywhere) if self.everywhere else search_panel(self)
        sides = (self.left.decide(field), self.right.decide(field))
        unsettled = [d for d in sides if d.verdict not in ("proved", "refuted")]
        if unsettled:
            return unsettled[0]
        a, b = sides
        steps = (
            f"{self.left.text}: {a.verdict}",
            *(f"  {s}" for s in a.steps),
            f"{self.right.text}: {b.verdict}",
            *(f"  {s}" for s in b.steps),
        )
        verdict = "proved" if a.verdict == b.verdict else "refuted"
        method = a.method if a.method == b.method else f"{a.method}; {b.method}"
        witness = (a.witness or b.witness) if verdict == "refuted" else None
        evidence = {"kind": "both", "left": judged(a), "right": judged(b)}
        return Decision(verdict, method, witness=witness, steps=steps, evidence=evidence)


@dataclass(frozen=True)
class Negation:
    """``proposition`` does not hold in every field: proved by the fields of the panel in which it fails."""

    proposition: Proposition

    @property
    def text(self) -> str:
        """The denial in words."""
        return f"not in every field: {self.proposition.text}"

    @property
    def statement(self) -> str:
        """The denial, in the vocabulary of certificates."""
        return f"not-everywhere{{{self.proposition.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Go through the panel (or look at the one field given) and show what was found in each."""
        names = [field.name] if field else [name for name in PANEL if name != UNIVERSAL]
        found = {name: self.proposition.decide(ring(name)) for name in names}
        steps = [
            f"{name}: {d.verdict}"
            + (f", {witness_text(d.witness)}" if d.witness else "")
            + (f" — {d.steps[-1]}" if d.steps else "")
            for name, d in found.items()
        ]
        fails = {name: d for name, d in found.items() if d.verdict == "refuted"}
        if fails:
            name, first = next(iter(fails.items()))
            witness = {"F": [name], **(first.witness or {})}
            evidence = {"kind": "over", "field": name, "evidence": first.evidence}
            return Decision(PROVED, WITNESS, witness=witness, steps=tuple(steps), evidence=evidence)
        settled = all(d.verdict in TRUE for d in found.values())
        return Decision(REFUTED if settled else UNDECIDED, THE_PANEL, steps=tuple(steps))


@dataclass(frozen=True)
class Over:
    """A proposition about one ring, the one named, whatever the column: what claims of no field are.

    A witness names that ring under the key ``F``.
    """

    field: str
    proposition: Proposition

    @property
    def text(self) -> str:
        """The proposition itself."""
        return self.proposition.text

    @property
    def statement(self) -> str:
        """The proposition with its field, in the vocabulary of certificates."""
        return f"over{{{self.field}; {self.proposition.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide it over the ring named; ``field`` does not matter."""
        decision = self.proposition.decide(ring(self.field))
        if decision.verdict != "refuted":
            return decision
        return replace(decision, witness={"F": [self.field], **(decision.witness or {})})


@dataclass(frozen=True)
class Only:
    """A proposition that has a meaning over some fields only; ``fits`` are their names."""

    proposition: Proposition
    fits: tuple[str, ...]
    reason: str
    assumes: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """The proposition itself."""
        return self.proposition.text

    @property
    def statement(self) -> str:
        """The proposition, marked as one about angles."""
        return f"angles{{{self.proposition.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide it where it means something."""
        if field is None or field.name not in self.fits:
            return Decision(NOT_APPLICABLE, NO_MEANING, steps=(self.reason,))
        decision = self.proposition.decide(field)
        return replace(decision, assumes=(*decision.assumes, *self.assumes))


def by_lemmas(everywhere: Proposition) -> Decision:
    """Decide over all fields by what shows it there; the lemmas' proofs become the evidence."""
    decision = everywhere.decide(None)
    if decision.verdict != "proved" or decision.evidence is None:
        return decision
    proofs = [part["evidence"] for part in decision.evidence.get("parts", ())]
    return replace(decision, evidence={"kind": "lemmas", "proofs": proofs})


def search_panel(proposition: Proposition) -> Decision:
    """Refute a proposition about all fields by a field of the panel, or leave it undecided."""
    for name in PANEL:
        if name == UNIVERSAL:
            continue
        decision = proposition.decide(ring(name))
        if decision.verdict == "refuted":
            witness: dict[str, Any] = {"F": [name], **(decision.witness or {})}
            steps = (f"It fails over {name}:", *decision.steps)
            evidence = {"kind": "over", "field": name, "evidence": decision.evidence}
            return replace(decision, witness=witness, steps=steps, evidence=evidence)
    return Decision(UNDECIDED, THE_PANEL, tried=("a counterexample in each field of the panel",))


def witness_text(witness: Mapping[str, list[str]] | None) -> str:
    """Write a witness in one line, such as ``p = (0,1,0,0), q = (0,0,1,0)``."""
    parts = []
    for name, values in (witness or {}).items():
        shown = values[0] if len(values) == 1 else f"({','.join(values)})"
        parts.append(f"{name} = {shown}")
    return ", ".join(parts)
