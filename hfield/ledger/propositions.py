"""Propositions and their combinations: statements of the language, logic between closed ones, relations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from hfield.checker.glossary import NO_MEANING, NOT_APPLICABLE, PROVED, VACUOUS
from hfield.errors import NotationError
from hfield.evidence import Evidence, Kind
from hfield.fields.base.ring import Ring
from hfield.ledger.claim import Proposition, TemplateProposition
from hfield.ledger.scopes import TRUE, by_lemmas, search_panel
from hfield.ledger.transfer import from_general_proof
from hfield.prover.decide import decide
from hfield.prover.decision import Decision
from hfield.prover.methods.presentations import decide_presentation, presentation_text
from hfield.prover.statements.printing import to_text
from hfield.prover.steps import indented, say
from hfield.syntax import Node


def written(node: Node | str) -> str:
    """Return a tree as text; return a text unchanged."""
    return node if isinstance(node, str) else to_text(node)


@dataclass(frozen=True)
class Assertion:
    """A statement of the language, for all values of its unknowns; ``given`` are hypotheses.

    ``words`` describe it in prose, if the formula is too long to read. ``algebra`` is H if None.
    """

    formula: str
    given: tuple[str, ...] = ()
    words: str = ""
    algebra: str | None = None

    @classmethod
    def of(
        cls, formula: Node | str, given: Sequence[Node | str] = (), words: str = ""
    ) -> Assertion:
        """Return the statement of a tree, under hypotheses that are trees or texts."""
        return cls(written(formula), tuple(map(written, given)), words)

    @property
    def text(self) -> str:
        """The words, or the statement with its hypotheses in front."""
        return self.words or " => ".join((*self.given, self.formula))

    @property
    def statement(self) -> str:
        """The statement with its hypotheses in front."""
        parts = (*self.given, self.formula)
        return " => ".join(f"({part})" for part in parts) if self.given else self.formula

    def decide(self, field: Ring | None) -> Decision:
        """Decide the statement with the prover; a proof over every commutative ring also holds over the
        field.

        If the field lacks constants that the statement names, the statement has no meaning over it.
        """
        if field is not None and self.algebra is None:
            general = from_general_proof(self.formula, self.given, field)
            if general is not None:
                return general
        try:
            return decide(self.formula, field, self.given, self.algebra)
        except NotationError as error:
            return Decision(NOT_APPLICABLE, NO_MEANING, steps=(str(error),))


@dataclass(frozen=True)
class Every:
    """The conjunction of several propositions; refuted by the first one that is refuted."""

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
        """Decide every part; the first part that is not proved determines the result."""
        steps: list[str] = []
        methods: list[str] = []
        decisions: list[Decision] = []
        for n, part in enumerate(self.parts):
            decision = part.decide(field)
            if decision.verdict not in TRUE:
                evidence = Evidence(Kind.PART, part=n, evidence=decision.evidence)
                return replace(
                    decision, steps=(*steps, part.text, *decision.steps), evidence=evidence
                )
            decisions.append(decision)
            steps += [part.text, *map(indented, decision.steps)]
            methods += [m for m in [decision.method] if m not in methods]
        empty = all(decision.verdict == "vacuous" for decision in decisions)
        return Decision(
            VACUOUS if empty else PROVED,
            "; ".join(methods),
            steps=tuple(steps),
            assumes=cited(*decisions),
            evidence=Evidence(Kind.PARTS, parts=[decided(d) for d in decisions]),
        )


def decided(decision: Decision) -> dict[str, object]:
    """Return the evidence for a part of a proposition with its verdict."""
    return {"verdict": decision.verdict, "evidence": decision.evidence}


def cited(*decisions: Decision) -> tuple[str, ...]:
    """Return the theorems that several decisions assume, without repetitions."""
    return tuple(dict.fromkeys(text for decision in decisions for text in decision.assumes))


@dataclass(frozen=True)
class Implication(TemplateProposition):
    """``hypothesis ⇒ conclusion`` between propositions about the field alone.

    Over all fields at once it is proved by ``everywhere``; if that is missing, a field of the panel that
    refutes it is searched for.
    """

    hypothesis: Proposition
    conclusion: Proposition
    everywhere: Proposition | None = None

    in_words = "if {hypothesis.text}, then {conclusion.text}"
    in_certificates = "implies{{{hypothesis.statement}; {conclusion.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide both sides over ``field``; vacuous if the hypothesis is refuted."""
        if field is None:
            return by_lemmas(self.everywhere) if self.everywhere else search_panel(self)
        first = self.hypothesis.decide(field)
        if first.verdict == "refuted":
            steps = (say("hypothesis-fails", F=field), *first.steps)
            evidence = Evidence(Kind.HYPOTHESIS, evidence=first.evidence)
            return replace(first, verdict="vacuous", steps=steps, evidence=evidence)
        if first.verdict not in TRUE:
            return first
        second = self.conclusion.decide(field)
        evidence = Evidence(Kind.CONCLUSION, evidence=second.evidence)
        if second.verdict == "refuted":
            evidence = Evidence(Kind.BOTH, left=decided(first), right=decided(second))
            second = replace(second, assumes=cited(first, second))
        return replace(second, steps=(*first.steps, *second.steps), evidence=evidence)


@dataclass(frozen=True)
class Equivalence(TemplateProposition):
    """``left ⇔ right`` between propositions about the field alone; see :class:`Implication`."""

    left: Proposition
    right: Proposition
    everywhere: Proposition | None = None

    in_words = "{left.text} if and only if {right.text}"
    in_certificates = "iff{{{left.statement}; {right.statement}}}"

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
            say(a.verdict, text=self.left.text),
            *map(indented, a.steps),
            say(b.verdict, text=self.right.text),
            *map(indented, b.steps),
        )
        verdict = "proved" if a.verdict == b.verdict else "refuted"
        method = a.method if a.method == b.method else f"{a.method}; {b.method}"
        witness = (a.witness or b.witness) if verdict == "refuted" else None
        evidence = Evidence(Kind.BOTH, left=decided(a), right=decided(b))
        return Decision(
            verdict, method, witness=witness, steps=steps, assumes=cited(a, b), evidence=evidence
        )


RELATIONS = ("i*i == -e", "j*j == -e", "k*k == -e", "i*j*k == -e")


@dataclass(frozen=True)
class Presented:
    """The claim that each of ``goals`` holds in every associative algebra that satisfies the relations.

    With ``identity``, e is the identity of the algebra; otherwise it is a letter like the others.
    """

    goals: tuple[str, ...]
    identity: bool = True

    @property
    def text(self) -> str:
        """The relations and the goals in usual notation."""
        unit = "with identity e" if self.identity else "with basis (e,i,j,k)"
        goals = ", ".join(self.goals).replace("*", "").replace("==", "=").replace("-", "−")
        return f"in an associative algebra {unit}, i² = j² = k² = ijk = −e ⇒ {goals}"

    @property
    def statement(self) -> str:
        """The statement in the notation of certificates."""
        return presentation_text(RELATIONS, self.goals, self.identity)

    def decide(self, field: Ring | None) -> Decision:
        """Rewrite each goal by the relations in ℤ⟨e,i,j,k⟩, or find an algebra in which one fails."""
        return decide_presentation(RELATIONS, self.goals, field=field, identity=self.identity)
