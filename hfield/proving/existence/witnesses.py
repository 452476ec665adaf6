"""Something exists, or nothing does, where nothing is given: a witness, or a proof that there is none."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from hfield.certificates.glossary import LINEAR_ALGEBRA, WITNESS
from hfield.errors import TooLargeError
from hfield.evidence import Evidence, Kind
from hfield.proving.counterexamples.candidates import true_place, witness_texts
from hfield.proving.decision import FIELD, PROVED, REFUTED, Decision
from hfield.proving.evaluation.scalars import RingScalars
from hfield.proving.evaluation.searcher import Assignment, Searcher, lifted
from hfield.proving.existence.closed_equations import closed_solutions
from hfield.proving.existence.linear_systems import linear_cases
from hfield.proving.existence.roots_by_theorem import by_roots
from hfield.proving.methods import universal
from hfield.proving.problem import Problem
from hfield.proving.statements.language import Sort
from hfield.proving.steps import say
from hfield.syntax import Not, parse

FEW = 400


def decide_closed(problem: Problem) -> Decision:
    """Decide over one ring whether there are values for all unknowns that make the statement true."""
    somewhere = problem.about(problem.matrix)
    found = true_place(somewhere, FEW)
    if found is None:
        found = _solved(somewhere)
    if found is not None:
        return _witnessed(problem, found)
    solutions = closed_solutions(somewhere)
    test = Searcher(somewhere, RingScalars(problem.ring), True).test
    for place in solutions.places:
        if test(place):
            return _witnessed(problem, place)
    if problem.statement.exists:
        decision = by_roots(problem)
        if decision is not None:
            return decision
    decision = _by_contrary(problem)
    if decision.verdict not in (PROVED, REFUTED) and solutions.none:
        steps = (say("none-solving", R=problem.ring.name),)
        return Decision(REFUTED, LINEAR_ALGEBRA, steps=steps)
    return decision


def _by_contrary(problem: Problem) -> Decision:
    """Decide whether the statement is false everywhere."""
    decision = universal.decide(problem.about(Not(problem.matrix)))
    if decision.verdict == REFUTED:
        return replace(
            decision,
            verdict=PROVED,
            method=WITNESS,
            scope=FIELD,
            steps=(say("true-for", values=shown(decision.witness or {})),),
        )
    if decision.verdict == PROVED:
        evidence = Evidence(Kind.NONE_EXISTS, proof=decision.evidence)
        steps = (*decision.steps, say("none"))
        return replace(decision, verdict=REFUTED, scope=None, evidence=evidence, steps=steps)
    return decision


def _solved(problem: Problem) -> Assignment | None:
    """Find values that solve linear equations, by elimination."""
    statement = problem.statement
    if not problem.ring.is_exact:
        return None
    names = tuple(name for name, _ in statement.unknowns)
    sought = replace(statement, exists=names, hypotheses=(), conclusion=statement.node)
    try:
        cases, _ = linear_cases(problem.stating(sought))
    except TooLargeError:
        return None
    seeker = Searcher(problem, RingScalars(problem.ring), True)
    world = seeker.evaluator
    for case in cases:
        values = {name: world.term(parse(text)) for name, text in case.terms}
        if not all(defined for _, defined in values.values()):
            continue
        sorts = statement.sorts
        found = {
            name: x if sorts[name] is Sort.SCALAR else world.embed(x)
            for name, (x, _) in values.items()
        }
        if seeker.test(found):
            return found
    return None


def _witnessed(problem: Problem, found: Assignment) -> Decision:
    witness = witness_texts(problem.ring, lifted(problem.ring, found))
    return Decision(
        PROVED,
        WITNESS,
        witness=witness,
        steps=(say("true-for", values=shown(witness)),),
        scope=FIELD,
        evidence=Evidence(Kind.WITNESS, ring=problem.ring.data, values=witness),
    )


def shown(witness: Mapping[str, Sequence[str]]) -> str:
    """Write the values of a witness in a line."""
    return ", ".join(f"{name} = ({', '.join(v)})" for name, v in witness.items())
