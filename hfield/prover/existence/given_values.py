"""Decide statements "for all … there is …" by trying values of the given unknowns.

If the equations for the existential unknowns are linear, elimination for one choice of given values is quick,
so many choices are tried. Other modules prove what is found.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain

from hfield.checker.glossary import EXHAUSTION
from hfield.core.product import Scalar
from hfield.errors import HFieldError, TooLargeError
from hfield.evidence import Evidence, Kind, is_complete
from hfield.fields.base.ring import Ring
from hfield.prover.counterexamples.candidates import by_weight, shown, small_scalars, witness_texts
from hfield.prover.decision import FIELD, PROVED, REFUTED, Decision, undecided
from hfield.prover.definedness import algebra_exists
from hfield.prover.evaluation.scalars import RingScalars, constant
from hfield.prover.evaluation.searcher import Assignment, Searcher, read_back
from hfield.prover.existence.isolation import isolated
from hfield.prover.existence.linear_systems import Row, System
from hfield.prover.existence.witnesses import decide_closed
from hfield.prover.methods import universal
from hfield.prover.polynomials.normal_form import branches
from hfield.prover.polynomials.vanishing import known, value_at
from hfield.prover.problem import Problem, constants_in
from hfield.prover.statements.printing import to_text
from hfield.prover.statements.setting import put_letters
from hfield.prover.statements.trees import conjunction, quaternion_node, substitute, walk
from hfield.prover.steps import say
from hfield.syntax import Name, Negate, Not, Number, parse

MAX_PLACES = 2_000
MAX_LOOKED = 40  # of infinitely many
ELEMENTS_TRIED = 5  # elements of an infinite field


def by_places(problem: Problem) -> Decision:
    """Refute at one point of the given unknowns, or over a finite field prove at all points."""
    field, free = problem.ring, problem.statement.given
    width = sum(sort.width for _, sort in free)
    finite = field.order is not None and field.order**width <= MAX_PLACES
    if finite:
        elements = list(field.elements())
        places = by_weight(free, elements, len(elements) * width)
        none_at = None
    else:
        places = chain(_found_by_solving(problem), by_weight(free, _small(field), 4))
        none_at = unsolvable_at(problem)
    meant = _meant(problem)
    count = looked = 0
    unproved = None  # refuted, but without evidence: another place may have some
    for place in places:
        if problem.is_late or looked >= (MAX_PLACES if finite else MAX_LOOKED):
            break
        count += 1
        if count > MAX_PLACES:
            break
        if not meant(place) or (none_at is not None and known(none_at, place) is False):
            continue
        looked += 1
        values = witness_texts(field, place)
        try:
            one = decide_closed(_instance(problem, values))
        except HFieldError:
            return undecided("values of the unknowns one by one")
        if one.verdict == REFUTED:
            refuted = _none_there(one, values)
            if is_complete(one.evidence):
                return refuted
            unproved = unproved or refuted
        elif finite and one.verdict != PROVED:
            return one
    if unproved is not None:
        return unproved
    if finite and not problem.is_late:
        steps = (say("one-each" if count > 1 else "one-only", n=count),)
        counted = Evidence(Kind.EXHAUSTION, cases=count)
        return Decision(PROVED, EXHAUSTION, steps=steps, scope=FIELD, evidence=counted)
    tried = ["terms in the unknowns", f"{looked} places"]
    if problem.is_late:
        tried.append("the time was over")
    return undecided(*tried)


def refuted_at(problem: Problem, place: Mapping[str, Sequence[str]]) -> Decision | None:
    """Refute at a point where linear algebra shows that there is no witness."""
    values = {name: list(v) for name, v in place.items() if name != "F"}
    instance = _instance(problem, values)
    try:
        if not algebra_exists(instance):
            return None
        one = decide_closed(instance)
    except HFieldError:
        return None
    return _none_there(one, values) if one.verdict == REFUTED else None


def at_zero(problem: Problem) -> tuple[str, ...] | None:
    """Return witnesses for given values 0 (letters −1); they may work for all values."""
    setting = problem.setting
    there = put_letters(setting, {name: Negate(Number(1)) for name in setting.letters})
    zeros = {name: Number(0) for name, _ in problem.statement.given}
    exists = problem.statement.exists
    instance = replace(
        problem.for_formula(substitute(problem.matrix, zeros), exists), setting=there
    )
    if not algebra_exists(replace(problem, setting=there)):
        return None
    one = decide_closed(instance)
    if one.verdict != PROVED or one.witness is None:
        return None
    return tuple(to_text(quaternion_node(one.witness[name])) for name in exists)


def _small(field: Ring) -> list[Scalar]:
    return list(small_scalars(field))[:ELEMENTS_TRIED]


def _found_by_solving(problem: Problem) -> Iterator[Assignment]:
    """Yield points near solutions of the hypotheses, or near points where a term is undefined."""
    field, statement, free = problem.ring, problem.statement, problem.statement.given
    terms = [texts for texts in isolated(statement).values() if texts]
    failing = []
    if len(terms) == len(statement.exists) == 1:
        chosen = {statement.exists[0]: parse(terms[0][0])}
        failing.append(substitute(problem.matrix, chosen))
    if statement.hypotheses:
        failing.append(Not(conjunction(statement.hypotheses)))
    names = tuple(name for name, _ in free)
    for node in failing:
        witness = universal.decide(problem.for_formula(node, names).share(1 / 4)).witness
        if witness is None:
            continue
        found = read_back(field, witness)
        used = {n.name for n in walk(node) if isinstance(n, Name)} | set(problem.setting.letters)
        others = [(name, sort) for name, sort in free if name not in used]
        for place in by_weight(others, _small(field), 3):
            yield {name: place.get(name, found[name]) for name in names}
        for own in free:
            for place in by_weight([own], _small(field), 2):
                yield {**found, **place}


def _meant(problem: Problem) -> Callable[[Assignment], bool]:
    """Return a function that tests whether at a point the algebra exists and the hypotheses hold."""
    names = tuple(name for name, _ in problem.statement.given)
    meant = problem.for_formula(conjunction(problem.statement.hypotheses), names)
    return Searcher(meant, RingScalars(problem.ring), True).test


def _instance(problem: Problem, place: Mapping[str, Sequence[str]]) -> Problem:
    """Substitute values for the given unknowns in the statement, and for letters in the algebra."""
    values = {name: quaternion_node(place[name]) for name, _ in problem.statement.given}
    instance = problem.for_formula(substitute(problem.matrix, values), problem.statement.exists)
    there = put_letters(problem.setting, values)
    new = (c for tree in there.trees for c in constants_in(tree, problem.ring))
    statement = replace(
        instance.statement,
        divides=instance.statement.divides or there.divides,
        constants=tuple(dict.fromkeys((*instance.statement.constants, *new))),
    )
    return replace(instance, statement=statement, setting=there)


def _none_there(one: Decision, place: dict[str, list[str]]) -> Decision:
    evidence = Evidence(Kind.PLACE, values=place, proof=one.evidence)
    at = (say("none-at", values=shown(place)),) if place else ()
    return replace(one, witness=place, steps=(*at, *one.steps), evidence=evidence)


MAX_TERMS = 2_000


def unsolvable_at(problem: Problem) -> Callable[[Assignment], bool] | None:
    """Return the reason why there is no witness at a point, or None if the statement is not linear."""
    field, statement = problem.field, problem.statement
    if field is None or not field.is_field:
        return None
    try:
        system = System(problem)
        found = [system.rows(branch) for branch in branches(system.formula)]
    except TooLargeError:
        return None
    ways = [rows for rows in found if rows is not None]
    if len(ways) < len(found) or sum(len(f) for w in ways for r in w for f in r) > MAX_TERMS:
        return None
    fixed = {text: constant(field, text) for text in statement.constants}

    def none_at(place: Assignment) -> bool:
        values = dict(fixed)
        for name, _ in statement.unknowns:
            x = place.get(name)
            if x is not None:
                if isinstance(x, tuple):
                    values |= {f"{name}[{n}]": c for n, c in enumerate(x)}
                else:
                    values[name] = x
        return not any(_is_solvable(rows, system.variables, values, field) for rows in ways)

    return none_at


def _is_solvable(
    rows: Sequence[Row], variables: Sequence[str], values: Mapping[str, Scalar], field: Ring
) -> bool:
    """Return whether linear equations have a solution, by elimination."""
    place = {n: values[name] for n, name in enumerate(variables) if name in values}
    left = [[value_at(f, place, field) for f in row] for row in rows]
    width = len(left[0]) - 1 if left else 0
    for column in range(width):
        pivot = next((row for row in left if not field.is_zero(row[column])), None)
        if pivot is None:
            continue
        left.remove(pivot)
        factor = field.inverse(pivot[column])
        left = [
            [x - row[column] * factor * y for x, y in zip(row, pivot, strict=True)] for row in left
        ]
    return all(field.is_zero(row[-1]) for row in left)
