"""Deciding a statement without quantifiers over one exact field; over a finite ring by all cases."""

from collections.abc import Sequence

from hfield.certificates.glossary import EXHAUSTION, IDENTITY
from hfield.errors import TooLargeError, UndecidedError
from hfield.evidence import Evidence, Kind
from hfield.proving.counterexamples.refuting import (
    FEW,
    MANY,
    SHORT,
    look,
    look_quickly,
    nonzero_place,
    solve_clauses,
)
from hfield.proving.decision import FIELD, PROVED, Decision, undecided
from hfield.proving.evaluation.all_cases import counterexample
from hfield.proving.methods.decisions import identity, implied, refuted, scope_of_identity
from hfield.proving.methods.implications import prove_clauses
from hfield.proving.polynomials.expansion import Expanded, expand
from hfield.proving.polynomials.field_rules import unused_norm
from hfield.proving.polynomials.normal_form import Clause
from hfield.proving.polynomials.vanishing import is_nonzero_constant, vanishes, vanishes_as_function
from hfield.proving.problem import Problem
from hfield.proving.steps import say
from hfield.rings.base import Ring


def decide(problem: Problem) -> Decision:
    """Decide over the field that is named."""
    field = problem.ring
    try:
        x = expand(problem)
    except TooLargeError as error:
        return _unexpanded(problem, str(error))
    left = [c for c in x.clauses if not is_trivial(c, x, field)]
    if not left:
        return identity(problem.statement, x, field, scope_of_identity(problem.statement, x))
    if any(_is_hopeless(c, x, field) for c in left):
        return _refuted_identity(problem, x, left)
    found = look_quickly(problem)
    if found is not None:
        return refuted(problem, found, x)
    p = field.characteristic
    proof = prove_clauses(problem.within(SHORT), p)
    if proof is None:
        found = look(problem, FEW)
        if found is None:
            found = solve_clauses(problem, x, left)
        if found is not None:
            return refuted(problem, found, x)
        # all cases of a finite field, where it comes to them, need time as well
        proof = prove_clauses(problem if field.order is None else problem.share(1 / 2), p)
    if proof is not None:
        return implied(proof, problem)
    if field.order is not None:
        return exhaust(problem, x)
    found = look(problem, MANY)
    if found is not None:
        return refuted(problem, found, x)
    return undecided(*_tried(problem))


def is_trivial(clause: Clause, x: Expanded, field: Ring) -> bool:
    """Tell whether a clause holds because a goal is identically 0, or a hypothesis a nonzero number."""
    if any(all(vanishes_as_function(p, x, field) for p in goal) for goal in clause.goals):
        return True
    return any(is_nonzero_constant(z, x, field) for z in clause.zeros)


def _is_hopeless(clause: Clause, x: Expanded, field: Ring) -> bool:
    """Tell whether a clause that is not trivial certainly fails somewhere: it has no hypotheses."""
    if any(not vanishes(z, x, field) for z in clause.zeros):
        return False
    return len(clause.goals) <= 1 or field.order is None


def _refuted_identity(problem: Problem, x: Expanded, left: Sequence[Clause]) -> Decision:
    """Refute where some clause is an identity that does not hold."""
    field = problem.ring
    found = look(problem, FEW)
    for c in left if found is None else ():
        if _is_hopeless(c, x, field):
            goals = [next(p for p in g if not vanishes_as_function(p, x, field)) for g in c.goals]
            found = nonzero_place(problem, x, goals)
            if found is not None:
                break
    if found is None:
        return undecided("the identity fails, but no place was found", method=IDENTITY)
    return refuted(problem, found, x)


def _tried(problem: Problem) -> tuple[str, ...]:
    tried = [f"{MANY} small places over {problem.ring.name}", "ideal membership of the conclusion"]
    why = unused_norm(problem.setting)
    if why is not None:
        tried.append(why)
    if problem.is_late:
        tried.append("the time was over")
    return tuple(tried)


def _unexpanded(problem: Problem, why: str) -> Decision:
    """Do what can be done without polynomials: look for a counterexample, or try all cases."""
    found = look(problem, FEW)
    if found is not None:
        return refuted(problem, found)
    if problem.ring.order is not None:
        return exhaust(problem, None)
    return undecided(why, f"{FEW} small places")


def exhaust(problem: Problem, x: Expanded | None) -> Decision:
    """Decide over a finite ring by all cases; when they are too many, look at small places.

    Clauses tell what matters where "defined" is "not 0": over a field, or where nothing divides.
    """
    divides = problem.statement.divides or problem.setting.divides
    used = None if x is None or (divides and not problem.ring.is_field) else used_variables(x)
    try:
        found, cases = counterexample(problem, used)
    except (TooLargeError, UndecidedError) as error:
        found = look(problem, MANY)
        if found is not None:
            return refuted(problem, found)
        return undecided(str(error), f"{MANY} small places")
    if found is not None:
        return refuted(problem, found)
    steps = (say("each-case" if cases > 1 else "only-case", n=cases, R=problem.ring.name),)
    evidence = Evidence(Kind.EXHAUSTION, cases=cases)
    return Decision(PROVED, EXHAUSTION, steps=steps, scope=FIELD, evidence=evidence)


def used_variables(x: Expanded) -> frozenset[str]:
    """Return the coordinates that the clauses depend on."""
    polynomials = [p for c in x.clauses for p in (*c.zeros, *(g for goal in c.goals for g in goal))]
    degrees: list[int] = [0] * len(x.variables)
    for p in polynomials:
        degrees = [a + int(b) for a, b in zip(degrees, p.degrees(), strict=True)]
    return frozenset(name for name, d in zip(x.variables, degrees, strict=True) if d)
