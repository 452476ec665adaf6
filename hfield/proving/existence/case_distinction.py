"""Proving that something exists case by case, and refuting it where no case applies."""

from collections.abc import Iterator
from dataclasses import replace
from time import monotonic
from typing import Any

from hfield.errors import TooLargeError
from hfield.proving.counterexamples.candidates import Searcher, prime_search, ring_search
from hfield.proving.decision import FIELD, FIELDS, PROVED, REFUTED, Decision
from hfield.proving.evaluation.compiled import World
from hfield.proving.evaluation.interpretation import PrimeInterpretation, RingInterpretation
from hfield.proving.existence.isolation import isolated, isolated_alone
from hfield.proving.existence.linear_systems import Case, linear_cases
from hfield.proving.existence.terms import Decide, about, alone, by_terms, combined
from hfield.proving.statements.language import Statement
from hfield.proving.statements.printing import to_text
from hfield.proving.statements.setting import Setting
from hfield.proving.statements.trees import substitute
from hfield.rings import ring
from hfield.syntax import Logic, Node, parse

MAX_ISOLATED = 40
PLACES = 300


def by_isolating(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision | None:
    """Prove by terms that solve an equation in which what is sought stands once."""
    found = isolated(statement)
    if not any(found.values()):
        return None
    texts = [found[name] or ["0"] for name in statement.exists]
    return by_terms(statement, setting, deadline, decide_one, combined(texts, MAX_ISOLATED))


def by_linear_algebra(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> tuple[Decision | None, Decision | None]:
    """Decide by linear algebra: a proof, or a refuted ``cover`` whose witness is a place to look at."""
    try:
        soon = monotonic() + (deadline - monotonic()) / 3
        cases, exact = linear_cases(statement, setting, soon)
    except TooLargeError:
        cases, exact = [], False
    cases = [*_isolated_cases(statement), *cases]
    if not cases and not exact:
        return None, None
    terms = [tuple(text for _, text in case.terms) for case in cases]
    found = by_terms(statement, setting, deadline, decide_one, terms)
    if found is not None:
        return found, None
    try:
        chosen, cover = _covered(statement, setting, cases, deadline, decide_one)
        if cover.verdict == REFUTED:
            return None, cover
        if cover.verdict != PROVED:
            return None, None
        proofs = [_proof(statement, setting, case, deadline, decide_one) for case in chosen]
    except TooLargeError:
        return None, None
    return _put_together(setting, chosen, cover, proofs), None


def _isolated_cases(statement: Statement) -> Iterator[Case]:
    """Run through cases in which one of several names is solved for: where that serves."""
    for terms in isolated_alone(statement):
        own = tuple((name, terms[name]) for name in statement.exists)
        node = substitute(statement.conclusion, {name: parse(text) for name, text in own})
        yield Case(to_text(node), own)


def _covered(
    statement: Statement,
    setting: Setting,
    cases: list[Case],
    deadline: float,
    decide_one: Decide,
) -> tuple[list[Case], Decision]:
    """Return cases with the decision that one of them always applies.

    Where a place refutes that and another case applies there, it joins them; where none does, that is
    a place where nothing exists.
    """
    chosen = _few(statement, setting, cases, deadline)
    while True:
        cover = decide_one(_covering(statement, setting, chosen), setting, deadline)
        if cover.verdict != REFUTED or cover.witness is None:
            return chosen, cover
        field = setting.field or ring(cover.witness["F"][0])
        place = {
            name: tuple(map(field, texts)) if len(texts) == 4 else field(texts[0])
            for name, texts in cover.witness.items()
            if name != "F"
        }
        world = RingInterpretation(field)
        found = [
            case
            for case in cases
            if case not in chosen
            and Searcher(
                _given(statement, setting, parse(case.when), False),
                setting.constants,
                world,
                deadline,
                True,
            ).test(place)
        ]
        if not found:
            return chosen, cover
        chosen = [*chosen, min(found, key=lambda case: case.when.count("=="))]


def _few(statement: Statement, setting: Setting, cases: list[Case], deadline: float) -> list[Case]:
    """Return some of the cases, one of which applies at every place that was looked at.

    The fewer there are, the easier it is to prove that they cover everything. Where none applies all are
    returned: then that is a place where nothing exists.
    """
    field, constants = setting.field, setting.constants
    worlds: list[World] = [
        PrimeInterpretation(p) for p in ((0, 2, 3) if field is None else (field.characteristic,))
    ]
    if field is not None:
        worlds.append(RingInterpretation(field))
    applies = {case: _given(statement, setting, parse(case.when), False) for case in cases}
    chosen: list[Case] = []
    for world in worlds:
        while len(chosen) < len(cases):
            left = _given(statement, setting, _covering_node(chosen))
            if isinstance(world, PrimeInterpretation):
                place = prime_search(left, constants, world.p, PLACES, deadline)
            else:
                place = ring_search(left, constants, world.ring, PLACES, deadline)
            if place is None:
                break
            found = [
                case
                for case in cases
                if case not in chosen
                and Searcher(applies[case], constants, world, deadline, True).test(place)
            ]
            if not found:
                return cases
            chosen.append(min(found, key=lambda case: case.when.count("==")))
    return chosen or cases[:1]


def _covering(statement: Statement, setting: Setting, cases: list[Case]) -> Statement:
    """Return the statement that one of the cases always applies."""
    return _given(statement, setting, _covering_node(cases))


def _covering_node(cases: list[Case]) -> Node:
    node = parse(cases[0].when if cases else "0 == 1")
    for case in cases[1:]:
        node = Logic("or", node, parse(case.when))
    return node


def _given(
    statement: Statement, setting: Setting, node: Node, hypotheses: bool = True
) -> Statement:
    """Return the hypotheses ⇒ node, for all values of what is given; or node alone."""
    for h in reversed(statement.hypotheses) if hypotheses else ():
        node = Logic("=>", h, node)
    free = tuple(name for name, _ in statement.unknowns if name not in statement.exists)
    return replace(alone(statement, node, setting, free), compares_unequal=True)


def _proof(
    statement: Statement, setting: Setting, case: Case, deadline: float, decide_one: Decide
) -> Decision:
    terms = {name: parse(text) for name, text in case.terms}
    inside = _given(statement, setting, substitute(statement.conclusion, terms))
    node = Logic("=>", parse(case.when), inside.node)
    free = tuple(name for name, _ in inside.unknowns)
    made = about(statement, node, free, setting.field)
    return decide_one(replace(made, compares_unequal=True), setting, deadline)


def _put_together(
    setting: Setting, cases: list[Case], cover: Decision, proofs: list[Decision]
) -> Decision | None:
    """Return the proof by cases, None where a case is not proved."""
    if any(proof.verdict != PROVED for proof in proofs):
        return None
    evidence: dict[str, Any] = {
        "kind": "cases",
        "cases": [
            {"when": case.when, "terms": dict(case.terms), "proof": proof.evidence}
            for case, proof in zip(cases, proofs, strict=True)
        ],
        "cover": cover.evidence,
    }
    steps = [
        f"where {case.when} take " + ", ".join(f"{name} = {term}" for name, term in case.terms)
        for case in cases
    ]
    assumes = tuple(dict.fromkeys(a for d in (cover, *proofs) for a in d.assumes))
    return Decision(
        PROVED,
        "witness",
        steps=(*steps, "one of these cases always applies"),
        scope=FIELDS if setting.field is None else FIELD,
        assumes=assumes,
        evidence=evidence,
    )
