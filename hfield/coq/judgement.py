"""A certificate about a statement of the language as a theorem of Coq, proved by its evidence.

The theorem is read from the statement, the algebra and the field alone. The evidence becomes data
for computations that Coq has proved to be right (evidence.v, soundness.v): where it does not show the
statement, Coq rejects the proof.
"""

from collections.abc import Mapping
from typing import Any

from hfield.certificates.glossary import PROVED, REFUTED, VACUOUS
from hfield.coq.base_rings import FIELDS, BaseRing, base_ring_of
from hfield.coq.existence import by_cases, by_terms, none_exists
from hfield.coq.sentences import Proved, Sentence
from hfield.coq.terms import NotCoveredError
from hfield.coq.universal import conjunction, exhausted, implied, multilinear
from hfield.coq.witnesses import counterexample, example
from hfield.evidence import Kind
from hfield.proving.statements.language import Statement, read_statement
from hfield.proving.statements.printing import to_text
from hfield.proving.statements.setting import Setting
from hfield.proving.statements.trees import walk
from hfield.rings import QQ, ZZ
from hfield.syntax import Name, Node, Not

FEW = 4_096  # cases


class Judgement:
    """Turns the evidence for one statement into a proof."""

    def __init__(self, name: str, text: str, setting: Setting) -> None:
        self.name, self.setting = name, setting
        self.statement = self.read(text, setting)

    def read(self, text: str, setting: Setting) -> Statement:
        """Read a statement as the field and the algebra make its names mean."""
        return read_statement(text, setting.field, (), setting.letters, setting.constants)

    def about(self, node: Node, setting: Setting | None = None) -> "Judgement":
        """Return the same for another statement."""
        out = object.__new__(Judgement)
        out.name, out.setting = self.name, setting or self.setting
        out.statement = self.read(to_text(node), out.setting)
        return out

    # --- verdicts --------------------------------------------------------------------------------

    def proved(self, evidence: Mapping[str, Any]) -> Proved:
        """Prove the statement."""
        match evidence.get("kind"), bool(self.statement.exists):
            case Kind.EXHAUSTION, _:
                return exhausted(self)
            case Kind.WITNESS, True:
                return example(self, evidence)
            case Kind.TERMS, True:
                return by_terms(self, evidence)
            case Kind.CASES, True:
                return by_cases(self, evidence)
            case Kind.IDENTITY, False:
                return exhausted(self) if self._is_of_fractions else implied(self, [])
            case Kind.IMPLICATION, False:
                return implied(self, evidence["items"], evidence["facts"])
            case Kind.MULTILINEAR, False:
                return multilinear(self, evidence)
            case Kind.FRACTIONS, False if self._is_over_integers(evidence):
                return self.proved(evidence["proof"])
            case kind, exists:
                what = " for something that exists" if exists else ""
                raise NotCoveredError(f"evidence of the kind {kind!r}{what}")

    def _is_over_integers(self, evidence: Mapping[str, Any]) -> bool:
        """Whether it is a proof over ℚ of what is said of ℤ."""
        return self.setting.field == ZZ and evidence["ring"] == QQ.data

    @property
    def _is_of_fractions(self) -> bool:
        """Whether fractions over a finite field may be equal as functions only; Coq tries all cases then."""
        field, statement = self.setting.field, self.statement
        if field is None or field.order is None or not (statement.divides or self.setting.divides):
            return False
        width = sum(sort.width for _, sort in statement.unknowns)
        return bool(field.is_field and field.order**width <= FEW)

    def refuted(self, evidence: Mapping[str, Any]) -> Proved:
        """Prove the opposite of the statement."""
        kind = evidence.get("kind")
        if kind == Kind.WITNESS and not self.statement.exists:
            return counterexample(self, evidence)
        if kind in (Kind.NONE_EXISTS, Kind.PLACE) and self.statement.exists:
            return none_exists(self, evidence)
        raise NotCoveredError(f"evidence of the kind {kind!r} against a statement")

    def vacuous(self, evidence: Mapping[str, Any]) -> Proved:
        """Prove that the hypotheses never hold together."""
        kind = evidence.get("kind")
        if kind != Kind.UNSATISFIABLE or not self.statement.hypotheses:
            raise NotCoveredError(f"evidence of the kind {kind!r}")
        return self.about(Not(conjunction(self.statement.hypotheses))).proved(evidence["proof"])

    def true_vacuously(self, evidence: Mapping[str, Any]) -> Proved:
        """Prove the statement itself from hypotheses that never hold together."""
        never, lemma = self.vacuous(evidence), f"{self.name}_never"
        sentence = self.sentence
        if sentence.found or not never.text.startswith(sentence.room.opening):
            raise NotCoveredError("what follows from hypotheses that never hold")
        names = [f"h{n}" for n in range(len(sentence.hypotheses))]
        lines = [sentence.intros, f"intros {' '.join(names)}.", "exfalso."]
        unknowns = {n for h in self.statement.hypotheses for n in _names(h)}
        kept = [n for n, _ in sentence.order if n in unknowns]
        call = f"{lemma} {sentence.room.names} {' '.join(kept)}".strip()
        lines.append(f"pose proof ({call}) as never; tauto.")
        return Proved(sentence.text, tuple(lines), (never.lemma(lemma),))

    @property
    def sentence(self) -> Sentence:
        """The statement as a proposition, over the field or over every field."""
        field = self.setting.field
        return Sentence(
            self.statement, self.setting, FIELDS if field is None else base_ring_of(field)
        )

    def by(self, verdict: str, evidence: Mapping[str, Any]) -> Proved:
        """Prove what a verdict says."""
        by = {PROVED: self.proved, REFUTED: self.refuted, VACUOUS: self.vacuous}
        return by[verdict](evidence)

    @property
    def given(self) -> list[str]:
        """The names of the unknowns that the statement is for all values of."""
        return [n for n, _ in self.statement.given]

    def one_ring(self) -> tuple[BaseRing, Sentence]:
        """Return the ring of the certificate, and the statement there."""
        if self.setting.field is None:
            raise NotCoveredError("something computed over all fields at once")
        room = base_ring_of(self.setting.field)
        return room, Sentence(self.statement, self.setting, room)


def _names(node: Node) -> set[str]:
    return {n.name for n in walk(node) if isinstance(n, Name)}
