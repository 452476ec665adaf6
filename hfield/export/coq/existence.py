"""Coq proofs of existence statements: by terms, by cases, or by values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

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
    value_in,
)
from hfield.export.coq.certificate_data import EvidenceData
from hfield.export.coq.cofactors import MismatchError
from hfield.export.coq.sentences import COMPUTED, Proved, Sentence, computed
from hfield.export.coq.terms import NotCoveredError, Terms
from hfield.fields.names import ring_of_data
from hfield.prover.existence.witness_terms import put_in
from hfield.prover.statements.language import Sort, Statement
from hfield.prover.statements.trees import implication, substitute
from hfield.syntax import Binary, Logic, Name, Node, Not, parse

if TYPE_CHECKING:
    from hfield.export.coq.judgement import Judgement


def by_terms(j: Judgement, evidence: EvidenceData) -> Proved:
    """Prove existence by terms that work for all values of the given unknowns."""
    lemma = f"{j.name}_instance"
    trees = _trees(j, evidence["terms"])
    instance, known = _instance(j, trees, [], evidence["proof"])
    base_ring = RINGS if instance.text.startswith(RINGS.opening) else _base_ring(j, instance)
    sentence = Sentence(j.statement, j.setting, base_ring)
    names = sentence.names
    lines = [
        sentence.intros,
        *([f"intros {' '.join(names)}."] if names else []),
        f"pose proof ({_call(lemma, instance, base_ring, known)} {' '.join(names)}) as known.",
        *_there(j, sentence, trees),
    ]
    return Proved(sentence.text, tuple(lines), (instance.lemma(lemma),))


def _base_ring(j: Judgement, proved: Proved) -> BaseRing:
    """Return the base ring of a proof: the field of the certificate, or all fields."""
    field = j.setting.field
    if field is None:
        return FIELDS
    base_ring = base_ring_of(field)
    large = of_characteristic(base_ring.characteristic)
    return large if proved.text.startswith(large.opening) else base_ring


def _trees(j: Judgement, terms: Mapping[str, str]) -> dict[str, Node]:
    """Return the terms for the witnesses; scalars become quaternions if quaternions are sought."""
    if set(terms) != set(j.statement.exists):
        raise MismatchError("the terms are not those of what exists")
    trees = {name: parse(text) for name, text in terms.items()}
    own = Terms(j.statement.given, [], j.setting.constants)
    for name, sort in j.statement.unknowns:
        if name in trees and (own.term(trees[name]).is_scalar) != (sort is Sort.SCALAR):
            if sort is Sort.SCALAR:
                raise MismatchError(f"the term for {name} is not a scalar")
            trees[name] = Binary("*", trees[name], Name("e"))
    return trees


def _there(j: Judgement, sentence: Sentence, trees: Mapping[str, Node]) -> list[str]:
    """Return the tactics that give the witnesses of an existence statement."""
    terms = Terms(sentence.given, [], j.setting.constants)
    named = [terms.term(trees[n]).inner for n, _ in sentence.terms.ordered if n in trees]
    return [*(f"exists {text}." for text in named), "first [exact known | tauto]."]


def _instance(
    j: Judgement, trees: Mapping[str, Node], more: Sequence[Node], proof: EvidenceData
) -> tuple[Proved, Judgement]:
    """Prove the statement with terms substituted, under the hypotheses ``more``."""
    served = put_in(j.statement.conclusion, trees)
    whole = implication([*more, *j.statement.hypotheses], served)
    other = j.for_formula(whole)
    if not {n for n, _ in other.statement.unknowns} <= set(j.given):
        raise MismatchError("the terms are about other unknowns than those given")
    return other.proved(proof), other


def by_cases(j: Judgement, evidence: EvidenceData) -> Proved:
    """Prove existence by terms in each of several cases, one of which always applies."""
    cases = evidence["cases"]
    conditions = [parse(case["when"]) for case in cases]
    one_of = conditions[-1]
    for condition in reversed(conditions[:-1]):
        one_of = Logic("or", condition, one_of)
    covered = j.for_formula(implication(j.statement.hypotheses, one_of))
    if not {n for n, _ in covered.statement.unknowns} <= set(j.given):
        raise MismatchError("the cases are about other unknowns than those given")
    cover = covered.proved(evidence["cover"])
    before = [cover.lemma(f"{j.name}_cover")]
    base_ring = _base_ring(j, cover)
    sentence = Sentence(j.statement, j.setting, base_ring)
    names = sentence.names
    defined, rest = names[: len(sentence.defined)], names[len(sentence.defined) :]
    pattern = "w"
    for _ in conditions[:-1]:
        pattern = f"[w | {pattern}]"
    call = _call(f"{j.name}_cover", cover, base_ring, covered)
    lines = [sentence.intros, *([f"intros {' '.join(names)}."] if names else [])]
    lines.append(f"destruct ({call} {' '.join(names)}) as {pattern}.")
    for n, (case, condition) in enumerate(zip(cases, conditions, strict=True), 1):
        trees = _trees(j, case["terms"])
        instance, known = _instance(j, trees, [condition], case["proof"])
        lemma = f"{j.name}_case_{n}"
        before.append(instance.lemma(lemma))
        call = _call(lemma, instance, base_ring, known)
        lines.append(f"- pose proof ({call} {' '.join([*defined, 'w', *rest])}) as known.")
        lines += [f"  {line}" for line in _there(j, sentence, trees)]
    return Proved(sentence.text, tuple(lines), tuple(before))


def none_exists(j: Judgement, evidence: EvidenceData) -> Proved:
    """Refute existence: for some values of the given unknowns there is no witness."""
    field, statement = j.setting.field, j.statement
    if field is None:
        field = ring_of_data(evidence["ring"])
    if j.setting.letters:
        raise NotCoveredError("that nothing exists, in an algebra with letters")
    here = replace(j.setting, field=field)
    base_ring = base_ring_of(field)
    sentence = Sentence(j.read(statement.text, here), here, base_ring)
    if sentence.defined:
        raise NotCoveredError("that nothing exists, where structure constants divide")
    proof = evidence["proof"]
    matrix = implication(statement.hypotheses, statement.conclusion)
    arguments = []
    if evidence["kind"] == Kind.PLACE:
        values = {name: _tree(texts) for name, texts in evidence["values"].items()}
        if set(values) != set(j.given):
            raise MismatchError("the point does not assign the given unknowns")
        matrix = substitute(matrix, values)
        own = Terms([], [], here.constants)
        for name, sort in sentence.order:
            x = own.term(values[name])
            if x.conditions:
                raise NotCoveredError("a place with fractions")
            arguments.append((own.embed(x) if sort is Sort.QUATERNION else x).inner)
        if proof["kind"] != Kind.NONE_EXISTS:
            raise MismatchError("a place refutes by evidence of the kind 'none exists'")
        proof = proof["proof"]
    elif j.given:
        raise MismatchError("nothing is said about the unknowns that are given")
    other = j.for_formula(Not(matrix), here)
    never = other.proved(proof)
    if not never.text.startswith(other.sentence.body):
        raise NotCoveredError("that nothing exists, in a field that Coq does not compute in")
    lemma = f"{j.name}_never"
    order = [n for n, _ in other.sentence.order]
    zeros = ["(embed 0)" if s is Sort.QUATERNION else "0" for _, s in other.sentence.order]
    names = sentence.names
    found = [n for n, _ in sentence.terms.ordered if n in statement.exists]
    pattern = "c"
    for name in reversed(found):
        pattern = f"[{name} {pattern}]"
    lines, start = in_one_field(base_ring) if j.setting.field is None else (["intro F."], "F")
    lines.append(f"pose proof ({' '.join([start, *arguments])}) as G.")
    if names:
        lines.append(f"apply ({' '.join([lemma, *zeros])}); intros {' '.join(names)}; exfalso.")
    lines.append(f"destruct ({' '.join(['G', *names])}) as {pattern}.")
    lines.append(f"apply ({' '.join([lemma, *order])}); intros; exact c.")
    whole = _whole_text(j, sentence)
    return Proved(f"~ ({whole})", tuple(lines), (never.lemma(lemma),))


def _whole_text(j: Judgement, sentence: Sentence) -> str:
    if j.setting.field is not None:
        return sentence.body
    return Sentence(j.statement, j.setting, FIELDS).text


def _call(lemma: str, proved: Proved, base_ring: BaseRing, judgement: Judgement) -> str:
    """Return a lemma applied to the ring and the unknowns of a proof in the base ring."""
    names = base_ring.names
    if proved.text.startswith(RINGS.opening) and base_ring is not RINGS:
        names = "R operations (F_R (proj1 laws))"
    own = [n for n, _ in judgement.sentence.order]
    return " ".join(x for x in (lemma, names, *own) if x)


def _tree(texts: Sequence[str]) -> Node:
    """Return the tree of c0*e + c1*i + c2*j + c3*k, or of a scalar."""
    if len(texts) == 1:
        return parse(texts[0])
    parts = [Binary("*", parse(c), Name(u)) for c, u in zip(texts, "eijk", strict=True)]
    return Binary("+", Binary("+", parts[0], parts[1]), Binary("+", parts[2], parts[3]))


def _values(
    j: Judgement,
    base_ring: BaseRing,
    values: Mapping[str, Sequence[str]],
    sentence: Sentence,
    unknowns: Sequence[tuple[str, Sort]],
) -> tuple[str, str]:
    if set(values) != {n for n, _ in unknowns}:
        raise MismatchError("the witness is not one for these unknowns")
    quaternions, scalars = [], []
    for name, sort in sentence.terms.ordered:
        if (name, sort) not in unknowns:
            continue
        found = [value_in(base_ring, text) for text in values[name]]
        if len(found) != (4 if sort is Sort.QUATERNION else 1):
            raise MismatchError(f"{name} has {len(found)} coordinates")
        if sort is Sort.QUATERNION:
            quaternions.append(f"Quaternion {' '.join(found)}")
        else:
            scalars += found
    return f"[{'; '.join(quaternions)}]", f"[{'; '.join(scalars)}]"


def counterexample(j: Judgement, evidence: EvidenceData) -> Proved:
    """Refute a statement by values in its ring, or a statement over all fields by values in one field."""
    field = ring_of_data(evidence["ring"])
    if j.setting.field is not None and j.setting.field != field:
        raise MismatchError("the witness is from another field")
    base_ring = base_ring_of(field)
    here = replace(j.setting, field=field)
    statement = j.read(j.statement.text, here)
    _check_listed(statement, base_ring)
    sentence = Sentence(statement, here, base_ring)
    values = _values(j, base_ring, evidence["values"], sentence, sentence.order)
    call = f"({sentence.data})\n  {values[0]} {values[1]}"
    judge = _named(base_ring, "residues_fail", "rationals_fail", "integers_fail", call)
    if j.setting.field is not None:
        return Proved(f"~ ({sentence.body})", (f"refine ({judge}).", f"all: {COMPUTED}"))
    if not base_ring.is_field:
        raise MismatchError(f"{field.name} is not a field")
    everywhere = Sentence(j.statement, j.setting, FIELDS)
    if base_ring.characteristic > MAX_PRIME:
        raise NotCoveredError(f"a counterexample in GF(p) with p above {MAX_PRIME}")
    start, there = in_one_field(base_ring)
    lines = [*start, f"unshelve refine ({judge} ({there})).", f"all: {COMPUTED}"]
    return Proved(f"~ ({everywhere.text})", tuple(lines))


def in_one_field(base_ring: BaseRing) -> tuple[list[str], str]:
    """Return the first tactics of a refutation over all fields, and the arguments that select this field."""
    p = base_ring.characteristic
    if not p:
        return ["intro F."], "F Qc _ _ rational_field"
    prime = f"assert (prime : is_prime {p} = true) by ({COMPUTED[:-1]})."
    return ["intro F.", prime], f"F (GF {p}) _ _ (GF_field {p} prime)"


def example(j: Judgement, evidence: EvidenceData) -> Proved:
    """Prove existence by values, without given unknowns."""
    base_ring, sentence = j.one_ring()
    _check_listed(j.statement, base_ring)
    values = _values(j, base_ring, evidence["values"], sentence, sentence.found)
    call = f"({sentence.data})\n  {values[0]} {values[1]}"
    judge = _named(base_ring, "residues_example", "rationals_example", "integers_example", call)
    return computed(sentence, judge)


def _named(base_ring: BaseRing, residues: str, rationals: str, integers: str, call: str) -> str:
    if base_ring is RATIONALS:
        return f"{rationals} {call} _"
    if base_ring is INTEGERS:
        return f"{integers} {call} _"
    return f"{residues} {base_ring.characteristic} {call} _ _"


def _check_listed(statement: Statement, base_ring: BaseRing) -> None:
    if base_ring.characteristic > MAX_MODULUS and statement.divides:
        raise NotCoveredError(f"division modulo a number above {MAX_MODULUS}")
