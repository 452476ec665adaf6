"""Propositions that choose their own rings: one ring, some, the panel, or all."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from hfield.checker.glossary import (
    NO_MEANING,
    NOT_APPLICABLE,
    PROVED,
    REFUTED,
    THE_PANEL,
    UNDECIDED,
    WITNESS,
)
from hfield.evidence import Evidence, Kind
from hfield.fields.base.ring import Ring
from hfield.fields.names import ring
from hfield.ledger.claim import PANEL, UNIVERSAL, Proposition, TemplateProposition
from hfield.prover.decision import Decision
from hfield.prover.steps import Step, say

TRUE = ("proved", "vacuous")


@dataclass(frozen=True)
class Negation(TemplateProposition):
    """The claim that ``proposition`` fails over some field: proved by fields of the panel over which it
    fails.
    """

    proposition: Proposition

    in_words = "not in every field: {proposition.text}"
    in_certificates = "not-everywhere{{{proposition.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide the proposition over each field of the panel (or over the given one) and show the
        results.
        """
        names = [field.name] if field else [name for name in PANEL if name != UNIVERSAL]
        found = {name: self.proposition.decide(ring(name)) for name in names}
        steps = [_found(name, decision) for name, decision in found.items()]
        fails = {name: d for name, d in found.items() if d.verdict == "refuted"}
        if fails:
            name, first = next(iter(fails.items()))
            witness = {"F": [name], **(first.witness or {})}
            evidence = Evidence(Kind.OVER, ring=ring(name).data, evidence=first.evidence)
            return Decision(PROVED, WITNESS, witness=witness, steps=tuple(steps), evidence=evidence)
        # that it holds in each field of the panel proves nothing about other fields
        general = found if field else {UNIVERSAL: self.proposition.decide(None)}
        settled = all(d.verdict in TRUE for d in general.values())
        return Decision(REFUTED if settled else UNDECIDED, THE_PANEL, steps=tuple(steps))


@dataclass(frozen=True)
class InField(TemplateProposition):
    """A proposition about one named ring, whatever the column; for claims that are not about a field.

    A witness names that ring under the key ``F``.
    """

    field: str
    proposition: Proposition

    in_certificates = "over{{{field}; {proposition.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide the proposition over the named ring; ``field`` is ignored."""
        decision = self.proposition.decide(ring(self.field))
        if decision.verdict != "refuted":
            return decision
        return replace(decision, witness={"F": [self.field], **(decision.witness or {})})


@dataclass(frozen=True)
class OnlyOver(TemplateProposition):
    """A proposition that has a meaning only over some fields; ``fits`` are their names."""

    proposition: Proposition
    fits: tuple[str, ...]
    reason: str
    assumes: tuple[str, ...] = ()

    in_certificates = "angles{{{proposition.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide the proposition over the rings over which it has a meaning."""
        if field is None or field.name not in self.fits:
            return Decision(NOT_APPLICABLE, NO_MEANING, steps=(self.reason,))
        decision = self.proposition.decide(field)
        return replace(decision, assumes=(*decision.assumes, *self.assumes))


def _found(name: str, decision: Decision) -> Step:
    """Return the result over one field in words: the verdict, where it fails, and the last step."""
    line = say(decision.verdict, text=name)
    if decision.witness:
        line = say("at", verdict=line, values=witness_text(decision.witness))
    return say("because", verdict=line, reason=decision.steps[-1]) if decision.steps else line


def by_lemmas(everywhere: Proposition) -> Decision:
    """Decide over all fields by lemmas, whose proofs become the evidence."""
    decision = everywhere.decide(None)
    if decision.verdict != "proved" or decision.evidence is None:
        return decision
    parts = decision.evidence["parts"] if decision.evidence.kind is Kind.PARTS else []
    assert isinstance(parts, list)
    proofs = [part["evidence"] for part in parts]
    return replace(decision, evidence=Evidence(Kind.LEMMAS, proofs=proofs))


def search_panel(proposition: Proposition) -> Decision:
    """Refute a proposition about all fields by a field of the panel, or leave it undecided."""
    for name in PANEL:
        if name == UNIVERSAL:
            continue
        decision = proposition.decide(ring(name))
        if decision.verdict == "refuted":
            witness = {"F": [name], **(decision.witness or {})}
            steps = (say("fails-over", F=name), *decision.steps)
            evidence = Evidence(Kind.OVER, ring=ring(name).data, evidence=decision.evidence)
            return replace(decision, witness=witness, steps=steps, evidence=evidence)
    return Decision(UNDECIDED, THE_PANEL, tried=("a counterexample in each field of the panel",))


def witness_text(witness: Mapping[str, list[str]] | None) -> str:
    """Write a witness on one line, such as ``p = (0,1,0,0), q = (0,0,1,0)``."""
    parts = []
    for name, values in (witness or {}).items():
        shown = values[0] if len(values) == 1 else f"({','.join(values)})"
        parts.append(f"{name} = {shown}")
    return ", ".join(parts)
