"""Places where a statement fails: looked for, solved for, or all tried."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from hfield.errors import UndecidedError
from hfield.proving.counterexamples.candidates import prime_search, ring_search
from hfield.proving.counterexamples.solving import solve
from hfield.proving.evaluation.scalars import RingScalars
from hfield.proving.evaluation.searcher import Assignment, Searcher, lifted
from hfield.proving.polynomials.expansion import Expanded
from hfield.proving.polynomials.normal_form import Clause
from hfield.proving.polynomials.starting_relations import quaternions_of
from hfield.proving.problem import Problem

if TYPE_CHECKING:
    import flint


QUICK, FEW, MANY = 120, 400, 20_000  # places looked at before, between and after proofs
MAX_AXES = 8
SHORT = 0.5  # seconds for the first attempt at a proof, and for solving one clause


def look_quickly(problem: Problem) -> Assignment | None:
    """Look at a few places of the prime field: a witness there serves every extension."""
    found = prime_search(problem, problem.ring.characteristic, QUICK)
    return None if found is None else lifted(problem.ring, found)


def look(problem: Problem, limit: int) -> Assignment | None:
    """Look for a counterexample: among numbers first, then among elements of the ring."""
    field = problem.ring
    if field.is_field:
        found = prime_search(problem, field.characteristic, limit)
        if found is not None:
            return lifted(field, found)
    return ring_search(problem, limit)


def solve_clauses(problem: Problem, x: Expanded, left: Sequence[Clause]) -> Assignment | None:
    """Look for a counterexample by solving the hypotheses, and test it in the statement itself."""
    test = Searcher(problem, RingScalars(problem.ring)).test
    quaternions = quaternions_of(problem)
    for clause in left:
        for narrower in (*narrowed(clause, quaternions), clause, *on_axes(clause)):
            try:
                found = solve(problem.within(SHORT), x, narrower)
            except UndecidedError:  # a root that is known to some digits only
                continue
            if found is not None and test(found):
                return found
    return None


def on_axes(clause: Clause) -> Iterator[Clause]:
    """Run through clauses in which all variables of the conditions but one are 0."""
    gens = clause.zeros[0].context().gens() if clause.zeros else ()
    used = [g for n, g in enumerate(gens) if any(z.degrees()[n] for z in clause.zeros)]
    for own in used[:MAX_AXES] if len(used) > 1 else ():
        yield Clause((*clause.zeros, *(g for g in used if g != own)), clause.goals)


def narrowed(
    clause: Clause, quaternions: Sequence[tuple[tuple[flint.fmpz_mpoly, ...], flint.fmpz_mpoly]]
) -> Iterator[Clause]:
    """Run through clauses with more conditions, at whose places the clause fails too.

    A norm is 0 where its quaternion is, and a quadratic polynomial that is never negative where its
    gradient is: those are linear conditions, which small places may all miss, as in ``norm(p + 7)``.
    """
    for q, norm in quaternions:
        if norm in clause.zeros or -norm in clause.zeros:
            others = [z for z in clause.zeros if z not in (norm, -norm)]
            yield Clause((*others, *(u for u in q if u != 0)), clause.goals)
    bent = [z for z in clause.zeros if z.total_degree() == 2]
    if bent:
        slopes = [z.derivative(n) for z in bent for n in range(z.context().nvars())]
        yield Clause((*clause.zeros, *(f for f in slopes if f != 0)), clause.goals)
