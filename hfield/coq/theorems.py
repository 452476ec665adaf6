"""One proved statement as a theorem: its proposition, and a proof that Coq can follow."""

from collections.abc import Mapping
from dataclasses import dataclass
from time import monotonic

from hfield.coq.facts import Facts, NoProofError
from hfield.coq.formulas import Equation, Formula, Junction, formula_of, grouped, nonzero
from hfield.coq.proofs import Lines, Proof, block
from hfield.coq.terms import Term, Terms
from hfield.errors import TooLargeError
from hfield.proving.decision import Decision
from hfield.proving.statements.language import Sort, Statement
from hfield.proving.statements.setting import Setting
from hfield.syntax import Node, parse

RINGS, FIELDS, ASSOCIATIVE = "commutative rings", "fields", "associative rings"
TIME = 20.0  # seconds for finding one proof
MAX_PROOF = 100_000
EQUATIONS = "Proof. equations. Qed."


@dataclass(frozen=True)
class Theorem:
    """A theorem of Coq with its proof; ``room`` says over which rings it is stated."""

    name: str
    room: str
    comment: str
    text: str
    proof: str
    before: str = ""

    def __str__(self) -> str:
        head = f"(* {self.comment} *)\n" + (f"{self.before}\n" if self.before else "")
        return f"{head}Theorem {self.name} :\n  {self.text}.\n{self.proof}"


def theorem(
    name: str, comment: str, statement: Statement, setting: Setting, decision: Decision
) -> Theorem:
    """Write a statement that was proved for all fields as a theorem, over rings where it can be.

    Raises :class:`NoProofError` when no proof is found that Coq could follow, and
    :class:`TooLargeError` for what is too large to unfold.
    """
    witnesses = _witnesses(statement, decision)
    deadline = monotonic() + TIME
    general = not (statement.divides or statement.compares_unequal)
    for room in (RINGS, FIELDS) if general else (FIELDS,):
        try:
            text, proof = _theorem(statement, setting, witnesses, room, deadline)
        except RecursionError:
            raise TooLargeError("the statement nests too deeply for its proof") from None
        except NoProofError:
            if room == FIELDS:
                raise
        else:
            return Theorem(name, room, comment, text, proof)
    raise AssertionError(name)


def proposition(statement: Statement, setting: Setting) -> str:
    """Return what a statement says in Coq's notation, whether it is true or not."""
    return _read(statement, setting).text


@dataclass(frozen=True)
class _Read:
    """A statement translated; ``given`` and ``sought`` are the unknowns before and after "exists"."""

    terms: Terms
    hypotheses: list[Formula]
    conclusion: Formula
    given: Mapping[str, Sort]
    sought: Mapping[str, Sort]

    @property
    def text(self) -> str:
        shown = self.conclusion.text
        if self.sought:
            shown = f"exists {_binders(self.sought)}, {shown}"
        body = " ->\n  ".join([*(grouped(h) for h in self.hypotheses), shown])
        return f"forall {_binders(self.given)},\n  {body}" if self.given else body


def _read(statement: Statement, setting: Setting) -> _Read:
    terms = Terms(statement, setting.constants)
    order = sorted(statement.unknowns, key=lambda unknown: unknown[1] is Sort.SCALAR)
    return _Read(
        terms,
        [formula_of(terms, h) for h in statement.hypotheses],
        formula_of(terms, statement.conclusion),
        {n: s for n, s in order if n not in statement.exists},
        {n: s for n, s in order if n in statement.exists},
    )


def _theorem(
    statement: Statement,
    setting: Setting,
    witnesses: Mapping[str, Node],
    room: str,
    deadline: float,
) -> tuple[str, str]:
    read = _read(statement, setting)
    terms, text = read.terms, read.text
    if not read.sought and _is_identity(read.conclusion):
        return text, EQUATIONS
    proof = Proof(terms, room == FIELDS, deadline)
    found = {name: _instance(terms, witnesses[name], sort) for name, sort in read.sought.items()}

    def finish(facts: Facts) -> Lines:
        for name, x in found.items():
            terms.names[name] = Term(x.inner, x.value, x.size)
        shown = [f"exists {x.inner}." for x in found.values()]
        goal = formula_of(terms, statement.conclusion)
        return [*shown, *proof.prove(goal, facts)]

    def defined(facts: Facts, left: list[Formula]) -> Lines:
        """Prove that what exists is defined, before it is named."""
        if not left:
            return finish(facts)
        name = proof.fresh()
        lines = proof.assume(name, left[0], facts, lambda known: defined(known, left[1:]))
        return [f"assert ({name} : {left[0].text}).", *block(proof.prove(left[0], facts)), *lines]

    def rest(facts: Facts, left: list[Formula]) -> Lines:
        if not left:
            return defined(facts, [nonzero(terms, c) for x in found.values() for c in x.conditions])
        name = proof.fresh()
        lines = proof.assume(name, left[0], facts, lambda known: rest(known, left[1:]))
        return [f"intro {name}.", *lines]

    introduced = [f"intros {' '.join(read.given)}."] if read.given else []
    lines = [*introduced, *rest(Facts(), read.hypotheses)]
    if sum(map(len, lines)) > MAX_PROOF:
        raise TooLargeError(f"the proof is longer than {MAX_PROOF} characters")
    return text, "\n".join(["Proof.", *(f"  {line}" for line in lines), "Qed."])


def _instance(terms: Terms, node: Node, sort: Sort) -> Term:
    """Return the term that is said to exist, in its sort."""
    x = terms.term(node)
    return terms.embed(x) if sort is Sort.QUATERNION else x


def _witnesses(statement: Statement, decision: Decision) -> dict[str, Node]:
    """Return the terms that were found for what is said to exist."""
    if not statement.exists:
        return {}
    evidence = decision.evidence or {}
    if evidence.get("kind") != "terms":
        raise NoProofError("what exists was not given by terms that serve over every field")
    return {name: parse(text) for name, text in evidence["terms"].items()}


def _is_identity(formula: Formula) -> bool:
    """Tell whether this joins equations whose sides are equal as polynomials."""
    if isinstance(formula, Equation):
        return bool(formula.left.value == formula.right.value)
    if isinstance(formula, Junction) and formula.op == "and":
        return _is_identity(formula.left) and _is_identity(formula.right)
    return False


def _binders(unknowns: Mapping[str, Sort]) -> str:
    groups = []
    for sort, kind in ((Sort.QUATERNION, "quaternion R"), (Sort.SCALAR, "R")):
        names = [n for n, s in unknowns.items() if s is sort]
        if names:
            groups.append(f"({' '.join(names)} : {kind})")
    return " ".join(groups)
