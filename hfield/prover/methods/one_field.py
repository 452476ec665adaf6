"""Decide a quantifier-free statement over one exact field or finite ring."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from hfield.checker.glossary import EXHAUSTION, IDENTITY
from hfield.errors import HFieldError
from hfield.evidence import Evidence, Kind
from hfield.fields.base.ring import Ring
from hfield.prover.attempts import Attempts, Method
from hfield.prover.counterexamples.search import (
    FIRST_ATTEMPT_SECONDS,
    PLACES_AFTER,
    PLACES_BETWEEN,
    nonzero_place,
    quick_search,
    search_counterexample,
    solve_clauses,
)
from hfield.prover.decision import FIELD, PROVED, Decision, undecided
from hfield.prover.evaluation.all_cases import counterexample
from hfield.prover.methods.decisions import (
    identity,
    implied,
    refuted,
    refuted_at,
    scope_of_identity,
)
from hfield.prover.methods.implications import prove_clauses
from hfield.prover.polynomials.expansion import Expanded, expand
from hfield.prover.polynomials.field_rules import unused_norm
from hfield.prover.polynomials.normal_form import PolynomialClause
from hfield.prover.polynomials.vanishing import (
    is_nonzero_constant,
    known,
    vanishes,
    vanishes_as_function,
)
from hfield.prover.problem import Problem
from hfield.prover.steps import say

if TYPE_CHECKING:
    import flint


def decide(problem: Problem) -> Decision:
    """Decide over the named field, by the first method that answers."""
    attempts = Attempts()
    x = attempts.answer(expand, problem)
    if x is None:
        return attempts.decide(_by_values(problem), f"{PLACES_BETWEEN} small places")
    field = problem.ring
    left = [c for c in x.clauses if not is_trivial(c, x, field)]
    if not left:
        return identity(problem.statement, x, field, scope_of_identity(problem.statement, x))
    if any(_is_hopeless(c, x, field) for c in left):
        decision = attempts.first(_refuting_an_identity(problem, x, left))
        why = "the identity fails, but no place was found"
        open_question = undecided(*attempts.refusals, why, method=IDENTITY)
        return open_question if decision is None else decision
    decision = attempts.first(_by_clauses(problem, x, left))
    if decision is None:
        return undecided(*attempts.refusals, *_tried(problem))
    return decision


def _by_values(problem: Problem) -> Iterator[Method]:
    """Yield the methods without polynomials: a counterexample, or all cases."""
    yield lambda: refuted_at(problem, search_counterexample(problem, PLACES_BETWEEN))
    if problem.ring.order is not None:
        yield lambda: exhaust(problem, None)


def _by_clauses(
    problem: Problem, x: Expanded, left: Sequence[PolynomialClause]
) -> Iterator[Method]:
    """Yield the methods for the clauses ``left``: quick ones, then slow ones."""
    finite = problem.ring.order is not None
    yield lambda: refuted_at(problem, quick_search(problem), x)
    yield lambda: _implied(problem.within(FIRST_ATTEMPT_SECONDS), problem)
    yield lambda: refuted_at(problem, search_counterexample(problem, PLACES_BETWEEN), x)
    yield lambda: refuted_at(problem, solve_clauses(problem, x, left), x)
    # if all cases of a finite field have to be tried, they need time as well
    yield lambda: _implied(problem.share(1 / 2) if finite else problem, problem)
    if finite:
        yield lambda: exhaust(problem, x)
    else:
        yield lambda: refuted_at(problem, search_counterexample(problem, PLACES_AFTER), x)


def _refuting_an_identity(
    problem: Problem, x: Expanded, left: Sequence[PolynomialClause]
) -> Iterator[Method]:
    """Yield the methods for a clause that is a false identity."""
    field = problem.ring
    yield lambda: refuted_at(problem, search_counterexample(problem, PLACES_BETWEEN), x)
    for c in left:
        if _is_hopeless(c, x, field):
            goals = [next(p for p in g if not_everywhere_zero(p, x, field)) for g in c.goals]
            yield partial(_refuted_where_nonzero, problem, x, goals)


def _refuted_where_nonzero(
    problem: Problem, x: Expanded, goals: Sequence[flint.fmpz_mpoly]
) -> Decision | None:
    """Refute at a point where none of several polynomials is 0."""
    return refuted_at(problem, nonzero_place(problem, x, goals), x)


def _implied(limited: Problem, problem: Problem) -> Decision | None:
    """Prove a problem by proving its clauses, within the time limit of ``limited``."""
    proof = prove_clauses(limited, problem.ring.characteristic)
    return None if proof is None else implied(proof, problem)


def is_trivial(clause: PolynomialClause, x: Expanded, field: Ring) -> bool:
    """Return whether a clause holds trivially: a goal is identically 0, or a hypothesis a nonzero number."""
    if any(all(known(vanishes_as_function, p, x, field) for p in goal) for goal in clause.goals):
        return True
    return any(known(is_nonzero_constant, z, x, field) for z in clause.zeros)


def not_everywhere_zero(p: flint.fmpz_mpoly, x: Expanded, field: Ring) -> bool:
    """Return whether a polynomial is known to be nonzero at some point."""
    return known(vanishes_as_function, p, x, field) is False


def _is_hopeless(clause: PolynomialClause, x: Expanded, field: Ring) -> bool:
    """Return whether a clause is known to fail: it has no hypotheses, and no goal is 0."""
    if not all(known(vanishes, z, x, field) for z in clause.zeros):
        return False
    if not all(any(not_everywhere_zero(p, x, field) for p in goal) for goal in clause.goals):
        return False
    return len(clause.goals) <= 1 or field.order is None


def _tried(problem: Problem) -> tuple[str, ...]:
    tried = [
        f"{PLACES_AFTER} small places over {problem.ring.name}",
        "ideal membership of the conclusion",
    ]
    why = unused_norm(problem.setting)
    if why is not None:
        tried.append(why)
    if problem.is_late:
        tried.append("the time was over")
    return tuple(tried)


def exhaust(problem: Problem, x: Expanded | None) -> Decision:
    """Decide over a finite ring by trying all cases, or small points if there are too many.

    The clauses determine which coordinates matter, if "defined" means "not 0": over a field, or without
    division.
    """
    divides = problem.statement.divides or problem.setting.divides
    used = None if x is None or (divides and not problem.ring.is_field) else used_variables(x)
    try:
        found, cases = counterexample(problem, used)
    except HFieldError as error:
        found, cases = search_counterexample(problem, PLACES_AFTER), 0
        if found is None:
            return undecided(str(error), f"{PLACES_AFTER} small places")
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
