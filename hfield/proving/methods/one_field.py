"""Deciding a statement without quantifiers over one exact field."""

from collections.abc import Sequence

from hfield.certificates.glossary import IDENTITY
from hfield.errors import TooLargeError
from hfield.proving.counterexamples.nonzero_place import nonzero_place
from hfield.proving.counterexamples.refuting import (
    FEW,
    MANY,
    SHORT,
    look,
    look_quickly,
    solve_clauses,
)
from hfield.proving.decision import Decision, undecided
from hfield.proving.methods.decisions import identity, implied, refuted, scope_of_identity
from hfield.proving.methods.exhaustion import exhaust
from hfield.proving.methods.implications import prove_clauses
from hfield.proving.polynomials.expansion import Expanded, expand
from hfield.proving.polynomials.field_rules import unused_norm
from hfield.proving.polynomials.normal_form import Clause
from hfield.proving.polynomials.vanishing import is_nonzero_constant, vanishes, vanishes_as_function
from hfield.proving.problem import Problem
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
    if not proof.complete:
        found = look(problem, FEW)
        if found is None:
            found = solve_clauses(problem, x, left)
        if found is not None:
            return refuted(problem, found, x)
        proof = prove_clauses(problem, p)
    if proof.complete:
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
