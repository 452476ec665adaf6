"""Statements that something exists, and hypotheses that nothing satisfies."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import chain
from time import monotonic
from typing import Any

from hfield.errors import HFieldError, TooLargeError
from hfield.proving.counterexamples.candidates import (
    Assignment,
    Searcher,
    by_weight,
    small_scalars,
    witness_texts,
)
from hfield.proving.counterexamples.refuting import lifted
from hfield.proving.decision import FIELD, PROVED, REFUTED, UNDECIDED, VACUOUS, Decision
from hfield.proving.evaluation.interpretation import RingInterpretation, bind
from hfield.proving.existence.case_distinction import by_isolating, by_linear_algebra
from hfield.proving.existence.closed_equations import closed_solutions
from hfield.proving.existence.isolation import isolated
from hfield.proving.existence.linear_systems import linear_cases
from hfield.proving.existence.quaternion_roots import by_quaternion_roots
from hfield.proving.existence.real_roots import by_roots
from hfield.proving.existence.terms import (
    Decide,
    about,
    alone,
    by_terms,
    constants_in,
    matrix,
    true_place,
)
from hfield.proving.existence.unsolvable import unsolvable_at
from hfield.proving.methods import all_fields, one_ring
from hfield.proving.polynomials.vanishing import constant
from hfield.proving.statements.definedness import algebra_exists
from hfield.proving.statements.language import Sort, Statement
from hfield.proving.statements.printing import to_text
from hfield.proving.statements.setting import Setting, divides, put_letters
from hfield.proving.statements.trees import quaternion_node, substitute, walk
from hfield.rings import ring
from hfield.syntax import Compare, Logic, Name, Negate, Node, Not, Number, parse

FEW = 400
MAX_PLACES = 2_000
MOST_LOOKED = 40  # of infinitely many


def vacuous(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision | None:
    """Return the decision "vacuous" if the hypotheses are proved unsatisfiable, else None."""
    node = statement.hypotheses[0]
    for h in statement.hypotheses[1:]:
        node = Logic("and", node, h)
    if true_place(about(statement, node), setting, FEW, deadline) is not None:
        return None
    never = alone(statement, Not(node), setting)
    decision = decide_one(never, setting, deadline)
    if decision.verdict != PROVED:
        return None
    evidence = {"kind": "unsatisfiable", "proof": decision.evidence}
    steps = (*decision.steps, "so the hypotheses are never all true")
    return replace(decision, verdict=VACUOUS, steps=steps, evidence=evidence)


def decide(statement: Statement, setting: Setting, deadline: float, decide_one: Decide) -> Decision:
    """Decide "for all the other unknowns there exist …"."""
    if setting.field is None:
        return _everywhere(statement, setting, deadline)
    if not setting.field.is_exact:
        tried = (
            f"{setting.field.name} is inexact, so nothing is proved there to exist, or not to",
        )
        return Decision(UNDECIDED, "floats", tried=tried)
    if any(name not in statement.exists for name, _ in statement.unknowns):
        return _for_all_exists(statement, setting, deadline, decide_one)
    return _exists(statement, setting, deadline, decide_one, statement)


def _exists(
    statement: Statement,
    setting: Setting,
    deadline: float,
    decide_one: Decide,
    sought: Statement | None = None,
) -> Decision:
    """Decide over one field, with nothing given: a witness, or a proof that there is none.

    ``sought`` is the statement with its quantifier, where it is one of its own.
    """
    node, field = matrix(statement), setting.field
    assert field is not None
    found = true_place(about(statement, node), setting, FEW, deadline)
    if found is not None:
        return _witnessed(setting, found)
    decision = _solved(statement, setting, deadline)
    if decision is not None:
        return decision
    solutions = closed_solutions(about(statement, node), setting)
    test = Searcher(
        about(statement, node), setting.constants, RingInterpretation(field), deadline, True
    ).test
    for place in solutions.places:
        if test(place):
            return _witnessed(setting, place)
    if sought is not None:
        decision = by_roots(sought, setting, deadline) or by_quaternion_roots(sought, setting)
        if decision is not None:
            return decision
    decision = decide_one(about(statement, Not(node)), setting, deadline)
    if decision.verdict == REFUTED:
        evidence = {**(decision.evidence or {}), "kind": "witness"}
        return replace(
            decision,
            verdict=PROVED,
            method="witness",
            scope=FIELD,
            evidence=evidence,
            steps=(f"true for {_shown(decision.witness or {})}",),
        )
    if decision.verdict == PROVED:
        evidence = {"kind": "none exists", "proof": decision.evidence}
        steps = (*decision.steps, "so there is none")
        return replace(decision, verdict=REFUTED, scope=None, evidence=evidence, steps=steps)
    if solutions.none:
        steps = (f"solving the equations over {field.name} shows that there is none",)
        return Decision(REFUTED, "linear algebra", steps=steps)
    return decision


def _solved(statement: Statement, setting: Setting, deadline: float) -> Decision | None:
    """Find a witness where what is sought is the solution of linear equations."""
    field = setting.field
    assert field is not None
    if not field.is_exact:
        return None
    names = tuple(name for name, _ in statement.unknowns)
    sought = replace(about(statement, matrix(statement)), exists=names)
    sought = replace(sought, hypotheses=(), conclusion=sought.node)
    try:
        cases, _ = linear_cases(sought, setting, deadline)
    except TooLargeError:
        return None
    world = RingInterpretation(field)
    fixed = {text: constant(field, text) for text in statement.constants}
    seeker = Searcher(about(statement, matrix(statement)), setting.constants, world, deadline, True)
    for case in cases:
        bind(world, setting.constants, fixed)
        values = {name: world.term(parse(text)) for name, text in case.terms}
        if not all(defined for _, defined in values.values()):
            continue
        sorts = statement.sorts
        found = {
            name: x if sorts[name] is Sort.SCALAR else world.embed(x)
            for name, (x, _) in values.items()
        }
        if seeker.test(found):
            return _witnessed(setting, found)
    return None


def _witnessed(setting: Setting, found: Any) -> Decision:
    field = setting.field
    assert field is not None
    witness = witness_texts(field, lifted(field, found))
    return Decision(
        PROVED,
        "witness",
        witness=witness,
        steps=(f"true for {_shown(witness)}",),
        scope=FIELD,
        evidence={"kind": "witness", "field": field.name, "values": witness},
    )


def _shown(witness: Any) -> str:
    return ", ".join(f"{name} = ({', '.join(v)})" for name, v in witness.items())


def _everywhere(statement: Statement, setting: Setting, deadline: float) -> Decision:
    """Decide over all fields: terms that serve everywhere, or a field where there is none."""
    decision, place = _by_algebra(statement, setting, deadline, all_fields.decide)
    if decision is not None:
        return decision
    if place is not None:
        there = replace(setting, field=ring(place["F"][0]))
        one = _refuted_at(statement, there, place, deadline)
        if one is not None:
            return all_fields.elsewhere(one, place["F"][0])
    for there in all_fields.fields_tried(statement, setting, deadline):
        left = deadline - monotonic()
        if left <= 0:
            break
        one = decide(statement, there, monotonic() + max(0.2 * left, 0.1), one_ring.decide)
        if one.verdict == REFUTED:
            assert there.field is not None
            return all_fields.elsewhere(one, there.field.name)
    tried = ("terms in the unknowns", f"each of {', '.join(all_fields.FIELDS_TRIED)}")
    return Decision(UNDECIDED, "none", tried=tried)


def _by_algebra(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> tuple[Decision | None, Mapping[str, list[str]] | None]:
    """Prove by terms and cases, or return a place where linear algebra finds that there is none."""
    decision = by_isolating(statement, setting, deadline, decide_one)
    if decision is not None:
        return decision, None
    soon = monotonic() + (deadline - monotonic()) / 3
    decision = by_terms(statement, setting, soon, decide_one)
    if decision is not None:
        return decision, None
    if setting.field is not None and not setting.field.is_field:
        return None, None
    decision, cover = by_linear_algebra(statement, setting, deadline, decide_one)
    return decision, None if cover is None else cover.witness


def _for_all_exists(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision:
    decision, place = _by_algebra(statement, setting, deadline, decide_one)
    if decision is not None:
        return decision
    if place is not None:
        decision = _refuted_at(statement, setting, place, deadline)
        if decision is not None:
            return decision
    decision = by_roots(statement, setting, deadline) or by_quaternion_roots(statement, setting)
    if decision is not None:
        return decision
    found = _at_zero(statement, setting, deadline, decide_one)
    if found is not None:
        decision = by_terms(statement, setting, deadline, decide_one, [found])
        if decision is not None:
            return decision
    return _by_places(statement, setting, deadline, decide_one)


def _at_zero(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> tuple[str, ...] | None:
    """Return what exists when all that is given is 0 (letters −1): it may serve everywhere."""
    free = [name for name, _ in statement.unknowns if name not in statement.exists]
    values = {name: Number(0) for name in free}
    there = put_letters(setting, {name: Negate(Number(1)) for name in setting.letters})
    if not algebra_exists(statement, there, deadline):
        return None
    node = substitute(matrix(statement), values)
    one = _exists(
        about(statement, node, statement.exists, setting.field), there, deadline, decide_one
    )
    if one.verdict != PROVED or one.witness is None:
        return None
    return tuple(to_text(quaternion_node(one.witness[name])) for name in statement.exists)


def _by_places(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision:
    """Refute at one place of the given unknowns, or prove at all of them over a finite field."""
    field = setting.field
    assert field is not None
    free = [(name, sort) for name, sort in statement.unknowns if name not in statement.exists]
    width = sum(1 if sort is Sort.SCALAR else 4 for _, sort in free)
    finite = field.order is not None and field.order**width <= MAX_PLACES
    scalars: list[Any] = list(field.elements()) if finite else list(small_scalars(field))[:5]
    places = by_weight(free, scalars, len(scalars) * width if finite else 4)
    if not finite:
        places = chain(_around_solution(statement, setting, free, deadline, decide_one), places)
    meant = _meant(statement, setting, free, deadline)
    none_at = None if finite else unsolvable_at(statement, setting, deadline)
    count = looked = 0
    for place in places:
        if monotonic() > deadline or looked >= (MAX_PLACES if finite else MOST_LOOKED):
            break
        count += 1
        if count > MAX_PLACES:
            break
        if not meant(place) or (none_at is not None and not none_at(place)):
            continue
        looked += 1
        instance, there = _instance(statement, setting, witness_texts(field, place))
        try:
            one = _exists(instance, there, deadline, decide_one)
        except HFieldError:
            return Decision(UNDECIDED, "none", tried=("values of the unknowns one by one",))
        if one.verdict == REFUTED:
            return _none_there(one, witness_texts(field, place))
        if finite and one.verdict != PROVED:
            return one
    if finite and monotonic() <= deadline:
        steps = (f"there is one for each of the {count} values of what is given",)
        counted: dict[str, Any] = {"kind": "exhaustion", "cases": count}
        return Decision(PROVED, "exhaustion", steps=steps, scope=FIELD, evidence=counted)
    tried = ["terms in the unknowns", f"{looked} places"]
    if monotonic() > deadline:
        tried.append("the time was over")
    return Decision(UNDECIDED, "none", tried=tuple(tried))


def _around_solution(
    statement: Statement,
    setting: Setting,
    free: list[tuple[str, Sort]],
    deadline: float,
    decide_one: Decide,
) -> Iterator[Assignment]:
    """Run through places near those that are found by solving: the hypotheses, or where a term fails."""
    field = setting.field
    if field is None:
        return
    terms = [texts for texts in isolated(statement).values() if texts]
    failing = []
    if len(terms) == len(statement.exists) == 1:
        node = substitute(matrix(statement), {statement.exists[0]: parse(terms[0][0])})
        failing.append(node)
    if statement.hypotheses:
        node = statement.hypotheses[0]
        for h in statement.hypotheses[1:]:
            node = Logic("and", node, h)
        failing.append(Not(node))
    small = list(small_scalars(field))[:5]
    for node in failing:
        solved = about(statement, node, tuple(name for name, _ in free), field)
        witness = decide_one(solved, setting, monotonic() + (deadline - monotonic()) / 4).witness
        if witness is None:
            continue
        found: Assignment = {
            name: tuple(map(field, texts)) if len(texts) == 4 else field(texts[0])
            for name, texts in witness.items()
        }
        used = {n.name for n in walk(node) if isinstance(n, Name)} | set(setting.letters)
        others = [(name, sort) for name, sort in free if name not in used]
        for place in by_weight(others, small, 3):
            yield {name: place.get(name, found[name]) for name, _ in free}
        for own in free:
            for place in by_weight([own], small, 2):
                yield {**found, **place}


def _meant(
    statement: Statement, setting: Setting, free: list[tuple[str, Sort]], deadline: float
) -> Callable[[Assignment], bool]:
    """Return what tells whether the algebra exists at a place and the hypotheses are true there."""
    field = setting.field
    assert field is not None
    node: Node = Compare("==", Number(0), Number(0))
    for h in statement.hypotheses:
        node = Logic("and", node, h)
    given = about(statement, node, tuple(name for name, _ in free))
    return Searcher(given, setting.constants, RingInterpretation(field), deadline, True).test


def _instance(
    statement: Statement, setting: Setting, place: Mapping[str, list[str]]
) -> tuple[Statement, Setting]:
    """Put values in for what is given: into the statement, and for letters into the algebra."""
    field = setting.field
    given = [name for name, _ in statement.unknowns if name not in statement.exists]
    values = {name: quaternion_node(place[name]) for name in given}
    node = substitute(matrix(statement), values)
    instance = about(statement, node, statement.exists, field)
    there = put_letters(setting, values)
    new = (c for text in there.constants for c in constants_in(parse(text), field))
    constants = tuple(dict.fromkeys((*instance.constants, *new)))
    divided = instance.divides or divides(there)
    return replace(instance, divides=divided, constants=constants), there


def _refuted_at(
    statement: Statement, setting: Setting, place: Mapping[str, list[str]], deadline: float
) -> Decision | None:
    """Refute at a place where linear algebra says that there is none, if that is proved too."""
    instance, there = _instance(statement, setting, place)
    try:
        if not algebra_exists(instance, there, deadline):
            return None
        one = _exists(instance, there, deadline, one_ring.decide)
    except HFieldError:
        return None
    if one.verdict != REFUTED:
        return None
    return _none_there(one, {name: list(v) for name, v in place.items() if name != "F"})


def _none_there(one: Decision, place: dict[str, list[str]]) -> Decision:
    evidence = {"kind": "place", "values": place, "proof": one.evidence}
    steps = (f"at {_shown(place)} there is none", *one.steps)
    return replace(one, witness=place, steps=steps, evidence=evidence)
