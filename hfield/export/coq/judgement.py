"""Turn a certificate of a statement of the language into a Coq theorem.

The theorem is determined by the statement, the algebra and the field alone. The evidence becomes data for
computations that Coq has proved correct (evidence.v, soundness.v). If it does not prove the statement, Coq
rejects the proof.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

from hfield.checker.glossary import PROVED, REFUTED, VACUOUS
from hfield.errors import TooLargeError
from hfield.evidence import Kind
from hfield.export.coq.base_rings import (
    FIELDS,
    INTEGERS,
    MAX_MODULUS,
    MAX_PRIME,
    RATIONALS,
    RINGS,
    BaseRing,
    base_ring_of,
    of_characteristic,
)
from hfield.export.coq.certificate_data import EvidenceData, FactData, ItemData
from hfield.export.coq.cofactors import MismatchError
from hfield.export.coq.consequences import Directly, Items, facts_used, has_cases, is_positive
from hfield.export.coq.existence import by_cases, by_terms, counterexample, example, none_exists
from hfield.export.coq.formulas import Junction
from hfield.export.coq.sentences import Proved, Sentence, computed
from hfield.export.coq.terms import NotCoveredError
from hfield.fields import QQ, ZZ
from hfield.prover.polynomials.vanishing import prime_factors
from hfield.prover.statements.language import Sort, Statement, read_statement
from hfield.prover.statements.printing import to_text
from hfield.prover.statements.setting import Setting
from hfield.prover.statements.trees import conjunction, substitute, walk
from hfield.syntax import Binary, Compare, Name, Node, Not, parse

MAX_COQ_CASES = 4_096  # cases


class Judgement:
    """Turns the evidence for one statement into a proof."""

    def __init__(self, name: str, text: str, setting: Setting) -> None:
        self.name, self.setting = name, setting
        self.statement = self.read(text, setting)

    def read(self, text: str, setting: Setting) -> Statement:
        """Parse a statement, with names for constants of the field and letters for unknowns of the
        algebra.
        """
        return read_statement(text, setting.field, (), setting.letters, setting.constants)

    def for_formula(self, node: Node, setting: Setting | None = None) -> Judgement:
        """Return the same problem for another statement."""
        out = object.__new__(Judgement)
        out.name, out.setting = self.name, setting or self.setting
        out.statement = self.read(to_text(node), out.setting)
        return out

    # --- verdicts --------------------------------------------------------------------------------

    def proved(self, evidence: EvidenceData) -> Proved:
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
            case Kind.FRACTIONS, False if self.setting.field == ZZ and evidence["ring"] == QQ.data:
                return self.proved(evidence["proof"])
            case kind, exists:
                what = " for something that exists" if exists else ""
                raise NotCoveredError(f"evidence of the kind {kind!r}{what}")

    @property
    def _is_of_fractions(self) -> bool:
        """Whether equality of fractions over a finite field may hold only as functions; then Coq tries all
        cases.
        """
        field, statement = self.setting.field, self.statement
        if field is None or field.order is None or not (statement.divides or self.setting.divides):
            return False
        width = sum(sort.width for _, sort in statement.unknowns)
        return bool(field.is_field and field.order**width <= MAX_COQ_CASES)

    def refuted(self, evidence: EvidenceData) -> Proved:
        """Prove the opposite of the statement."""
        kind = evidence.get("kind")
        if kind == Kind.WITNESS and not self.statement.exists:
            return counterexample(self, evidence)
        if kind in (Kind.NONE_EXISTS, Kind.PLACE) and self.statement.exists:
            return none_exists(self, evidence)
        raise NotCoveredError(f"evidence of the kind {kind!r} against a statement")

    def vacuous(self, evidence: EvidenceData) -> Proved:
        """Prove that the hypotheses never hold together."""
        kind = evidence.get("kind")
        if kind != Kind.UNSATISFIABLE or not self.statement.hypotheses:
            raise NotCoveredError(f"evidence of the kind {kind!r}")
        return self.for_formula(Not(conjunction(self.statement.hypotheses))).proved(
            evidence["proof"]
        )

    def true_vacuously(self, evidence: EvidenceData) -> Proved:
        """Prove the statement itself from hypotheses that never hold together."""
        never, lemma = self.vacuous(evidence), f"{self.name}_never"
        sentence = self.sentence
        if sentence.found or not never.text.startswith(sentence.base_ring.opening):
            raise NotCoveredError("what follows from hypotheses that never hold")
        names = sentence.names
        lines = [sentence.intros, f"intros {' '.join(names)}.", "exfalso."]
        nodes = (n for h in self.statement.hypotheses for n in walk(h))
        unknowns = {n.name for n in nodes if isinstance(n, Name)}
        kept = [n for n, _ in sentence.order if n in unknowns]
        call = f"{lemma} {sentence.base_ring.names} {' '.join(kept)}".strip()
        lines.append(f"pose proof ({call}) as never; tauto.")
        return Proved(sentence.text, tuple(lines), (never.lemma(lemma),))

    @property
    def sentence(self) -> Sentence:
        """The statement as a proposition, over the field or over every field."""
        field = self.setting.field
        return Sentence(
            self.statement, self.setting, FIELDS if field is None else base_ring_of(field)
        )

    def by(self, verdict: str, evidence: EvidenceData) -> Proved:
        """Prove a verdict."""
        if self.statement.ordered is not None:
            raise NotCoveredError("moduli and comparisons over ordered fields")
        by = {PROVED: self.proved, REFUTED: self.refuted, VACUOUS: self.vacuous}
        return by[verdict](evidence)

    @property
    def given(self) -> list[str]:
        """The universally quantified unknowns."""
        return [n for n, _ in self.statement.given]

    def one_ring(self) -> tuple[BaseRing, Sentence]:
        """Return the ring of the certificate, and the statement over it."""
        if self.setting.field is None:
            raise NotCoveredError("something computed over all fields at once")
        base_ring = base_ring_of(self.setting.field)
        return base_ring, Sentence(self.statement, self.setting, base_ring)


MAX_CASES = 300_000
MAX_WORDS = 64  # of a list of tuples of basis vectors


def implied(j: Judgement, items: Sequence[ItemData], facts: Sequence[FactData] = ()) -> Proved:
    """Prove a statement from its items of evidence; an identity needs none."""
    field = j.setting.field
    base_ring = FIELDS if field is None else base_ring_of(field)
    _check_facts(j, facts_used(items), facts, base_ring)
    if field is None:
        return _everywhere(j, items)
    p = base_ring.characteristic
    if base_ring.is_field and p > MAX_PRIME:
        base_ring = of_characteristic(p)
    sentence = Sentence(j.statement, j.setting, base_ring)
    read = Items(sentence.terms, items)
    if any(i.characteristic not in (0, p) for i in read.items):
        raise MismatchError("an item is about another characteristic")
    divides = j.statement.divides or bool(sentence.defined)
    if not base_ring.is_field and divides:
        raise NotCoveredError(f"division over {field.name}, except by all cases")
    evidence = read.hints(sentence.formulas, read.items, p if p <= MAX_PRIME else 0)
    if base_ring is RATIONALS:
        evidence = replace(evidence, numbers=_divisors(j.setting))
        return computed(sentence, f"over_rationals\n  ({evidence})%text\n  {sentence.data} _")
    if base_ring is INTEGERS:
        if _directly(j, sentence, read):
            judge = f"over_the_integers_directly\n  ({evidence})%text\n  {sentence.data} _"
        else:
            judge = f"integers\n  ({evidence})%text\n  {sentence.data} _ _"
        return computed(sentence, judge)
    if not base_ring.is_field:
        if not is_positive(sentence.conclusion) or not all(map(has_cases, sentence.hypotheses)):
            raise NotCoveredError(f"'not' or '!=' over {field.name}, except by all cases")
        return computed(sentence, f"residue_ring {p}\n  ({evidence})%text\n  {sentence.data} _")
    if base_ring.is_one_ring:
        width = len(sentence.terms.numerators.atoms) if evidence.vanishing else 0
        return computed(
            sentence, f"prime_field {p} {width}\n  ({evidence})%text\n  {sentence.data} _ _ _"
        )
    return computed(
        sentence, f"characteristic_fields {p}\n  ({evidence})%text\n  {sentence.data} _"
    )


def _check_facts(
    j: Judgement, used: set[str], facts: Sequence[FactData], base_ring: BaseRing
) -> None:
    """Raise NotCoveredError for facts that Coq cannot prove, MismatchError for wrong ones."""
    for form in used & {"norm", "squares"}:
        fact = next((f for f in facts if f["form"] == form), None)
        if fact is None:
            raise MismatchError(f"a step uses the fact {form!r}, which is not there")
        if "algebra" in fact:
            raise NotCoveredError("the norm form of another algebra than the statement's")
        known = base_ring in (RATIONALS, INTEGERS)
        if known and (form == "squares" or _is_definite(j.setting)):
            continue
        by = fact["by"]
        if base_ring is FIELDS or by == "ordering" or (form == "norm" and not known):
            raise MismatchError(f"the fact {form!r} by {by!r} does not hold there")
        raise NotCoveredError(f"the fact {form!r} by {by!r} over {base_ring.type}")


def _directly(j: Judgement, sentence: Sentence, read: Items) -> bool:
    """Return whether the items prove the statement without division."""
    usable = [i for i in read.items if not i.characteristic and i.denominators <= {1, -1}]
    goal = sentence.conclusion
    for h in reversed(sentence.hypotheses):
        goal = Junction("=>", h, goal)
    return Directly(usable).derives([], goal)


def _everywhere(j: Judgement, items: Sequence[ItemData]) -> Proved:
    general = not (j.statement.divides or j.statement.compares_unequal)
    if general:
        sentence = Sentence(j.statement, j.setting, RINGS)
        read = Items(sentence.terms, items)
        if not sentence.defined and _directly(j, sentence, read):
            usable = [i for i in read.items if i.is_direct and i.denominators <= {1, -1}]
            usable = [i for i in usable if not i.characteristic]
            evidence = read.hints(sentence.formulas, usable, 0)
            judge = f"commutative_rings\n  ({evidence})%text\n  {sentence.data} _"
            return computed(sentence, judge)
    sentence = Sentence(j.statement, j.setting, FIELDS)
    read = Items(sentence.terms, items)
    general_items = [i for i in read.items if not i.characteristic]
    divided = {abs(d) for i in general_items for d in i.denominators}
    if 0 in divided:
        raise MismatchError("a denominator is 0")
    primes = {i.characteristic for i in read.items} - {0}
    for d in divided:
        primes |= set(_primes(d))
    special = []
    for p in sorted(primes):
        own = [
            i
            for i in read.items
            if i.characteristic == p
            or (not i.characteristic and all(d % p for d in i.denominators))
        ]
        special.append(f"({p}%Z, ({read.hints(sentence.formulas, own, 0)})%text)")
    evidence = read.hints(sentence.formulas, general_items, 0)
    listed = "[" + ";\n   ".join(special) + "]"
    return computed(sentence, f"fields\n  ({evidence})%text\n  {listed}\n  {sentence.data} _ _")


def exhausted(j: Judgement) -> Proved:
    """Prove a statement over a finite ring by checking all cases."""
    base_ring, sentence = j.one_ring()
    n = base_ring.characteristic
    width = sum(4 if s is Sort.QUATERNION else 1 for _, s in j.statement.unknowns)
    if not n or n > MAX_MODULUS or n**width > MAX_CASES:
        raise NotCoveredError(f"exhaustion of more than {MAX_CASES} cases")
    return computed(sentence, f"residues_all_cases {n} {sentence.data} _ _")


def multilinear(j: Judgement, evidence: EvidenceData) -> Proved:
    """Prove an equation by expanding it, and that the list of its values at basis vectors is right."""
    whole = implied(j, [])
    names = [n for n, s in j.statement.unknowns if s is Sort.QUATERNION]
    tree = j.statement.conclusion
    words = dict(evidence["tuples"])
    if (
        not isinstance(tree, Compare)
        or evidence["unknowns"] != names
        or set(words) != set(map("".join, product("eijk", repeat=len(names))))
        or len(words) != len(evidence["tuples"])
    ):
        raise MismatchError("the list of tuples is not one for the statement")
    if len(words) > MAX_WORDS:
        raise NotCoveredError(f"a list of more than {MAX_WORDS} tuples of basis vectors")
    parts: list[Node] = []
    for word, value in words.items():
        put = {n: Name(x) for n, x in zip(names, word, strict=True)}
        shown = " + ".join(f"({int(c)})*{u}" for c, u in zip(value, "eijk", strict=True))
        for side in (tree.left, tree.right):
            parts.append(Compare("==", substitute(side, put), parse(shown)))
    values = j.for_formula(conjunction(parts)).proved({"kind": Kind.IDENTITY.value})
    tuples = f"{j.name}_tuples"
    return replace(whole, before=(values.lemma(tuples), *whole.before))


def _divisors(setting: Setting) -> tuple[int, ...]:
    """Return the numbers by which the structure constants are divided."""
    found: set[int] = set()

    def visit(node: Node) -> None:
        if isinstance(node, Binary):
            visit(node.left)
            visit(node.right)
            if node.op == "/" and hasattr(node.right, "value"):
                found.add(int(node.right.value))

    for text in setting.constants:
        visit(parse(text))
    return tuple(sorted(found - {0, 1}))


def _is_definite(setting: Setting) -> bool:
    """Return whether t*t + 4*a and b are negative rationals."""
    try:
        a, t, b = (Fraction(text) for text in setting.constants)
    except ValueError:
        return False
    return t * t + 4 * a < 0 and b < 0


def _primes(n: int) -> list[int]:
    primes = prime_factors(n)
    if primes is None:
        raise TooLargeError("a denominator is too large to factor")
    return primes
