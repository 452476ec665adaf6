"""Statements about one ring or all rings of a kind, as propositions of Coq and as data."""

from collections.abc import Sequence
from dataclasses import dataclass

from hfield.export.coq.base_rings import BaseRing
from hfield.export.coq.formulas import Formula, Formulas, grouped
from hfield.export.coq.terms import NotCoveredError, Terms
from hfield.prover.statements.language import Sort, Statement
from hfield.prover.statements.setting import Setting

IN_RINGS = "rings.v"
COMPUTED = "vm_cast_no_check (@eq_refl bool true)."


@dataclass(frozen=True)
class Proved:
    """A proposition with its proof and the lemmas that must precede it."""

    text: str
    proof: tuple[str, ...]
    before: tuple[str, ...] = ()
    place: str = ""  # the section of the file that must contain it

    def lemma(self, name: str, word: str = "Lemma") -> str:
        """Return the proof as a named lemma."""
        lines = "\n".join(f"  {line}" for line in self.proof)
        whole = f"{word} {name} :\n  {self.text}.\nProof.\n{lines}\nQed."
        return "\n".join([*self.before, whole])


class Sentence:
    """A statement over one base ring, as text and as data."""

    def __init__(self, statement: Statement, setting: Setting, base_ring: BaseRing) -> None:
        if statement.constants:
            raise NotCoveredError(f"{statement.constants[0]!r} names a constant of the field")
        self.statement, self.setting, self.base_ring = statement, setting, base_ring
        sorts = statement.unknowns
        self.given = list(statement.given)
        self.found = [(n, s) for n, s in sorts if n in statement.exists]
        self.terms = Terms(self.given, self.found, setting.constants)
        formulas = Formulas(self.terms, base_ring.type, base_ring.is_field)
        self.defined = [formulas.defined(d) for d in self.terms.defined]
        self.hypotheses = [*self.defined, *(formulas.of(h) for h in statement.hypotheses)]
        self.conclusion = formulas.of(statement.conclusion)

    @property
    def order(self) -> list[tuple[str, Sort]]:
        """The given unknowns in the order in which they are quantified."""
        return [x for x in self.terms.ordered if x in self.given]

    @property
    def names(self) -> list[str]:
        """The names of the hypotheses."""
        return [f"h{n}" for n in range(len(self.hypotheses))]

    @property
    def body(self) -> str:
        """The statement about the base ring, without its quantifier over rings."""
        shown = self.conclusion.text
        if self.found:
            order = [x for x in self.terms.ordered if x in self.found]
            shown = f"exists {_binders(order, self.base_ring)}, {shown}"
        body = " ->\n  ".join([*(grouped(h) for h in self.hypotheses), shown])
        return f"forall {_binders(self.order, self.base_ring)},\n  {body}" if self.given else body

    @property
    def text(self) -> str:
        """The whole proposition."""
        return f"{self.base_ring.opening}{self.body}"

    @property
    def data(self) -> str:
        """The statement as data."""
        constants = " ".join(part.argument for part in self.terms.parts)
        given, found = _count(self.given), _count(self.found)
        hypotheses = "; ".join(h.data for h in self.hypotheses)
        return f"(Statement {constants} {given} [{hypotheses}]\n    {found}\n    ({self.conclusion.data}))"

    @property
    def formulas(self) -> list[Formula]:
        """Hypotheses and conclusion."""
        return [*self.hypotheses, self.conclusion]

    @property
    def intros(self) -> str:
        """The tactic that introduces the ring and the unknowns."""
        names = f"{self.base_ring.names} {' '.join(n for n, _ in self.order)}".strip()
        return f"intros {names}." if names else "idtac."

    @property
    def arguments(self) -> str:
        """The names of the ring and the unknowns, as arguments."""
        return f"{self.base_ring.names} {' '.join(n for n, _ in self.order)}".strip()


def _count(unknowns: Sequence[tuple[str, Sort]]) -> str:
    quaternions = sum(s is Sort.QUATERNION for _, s in unknowns)
    return f"{quaternions} {len(unknowns) - quaternions}"


def _binders(order: Sequence[tuple[str, Sort]], base_ring: BaseRing) -> str:
    groups = []
    kind = base_ring.type if " " not in base_ring.type else f"({base_ring.type})"
    for sort, shown in ((Sort.QUATERNION, f"quaternion {kind}"), (Sort.SCALAR, base_ring.type)):
        names = [n for n, s in order if s is sort]
        if names:
            groups.append(f"({' '.join(names)} : {shown})")
    return " ".join(groups)


def computed(sentence: Sentence, judge: str) -> Proved:
    """Prove a sentence by a computation of Coq."""
    return Proved(sentence.text, (f"refine ({judge}).", f"all: {COMPUTED}"))
