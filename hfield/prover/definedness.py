"""Decide whether the structure constants of an algebra are defined for some values.

A constant such as ``1/a`` or ``1/2`` is defined if the divisor is a unit of the ring. A statement is only
about values of the letters for which the constants are defined; if there are none, it has no content.
"""

from dataclasses import replace

from hfield.errors import HFieldError, TooLargeError, UndecidedError
from hfield.prover.counterexamples.candidates import prime_search, ring_search
from hfield.prover.evaluation.all_cases import counterexample
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.evaluation.searcher import Searcher
from hfield.prover.polynomials.expansion import Expanded, Symbolic
from hfield.prover.polynomials.vanishing import vanishes_as_function
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Sort
from hfield.prover.statements.trees import TRUE

MAX_PLACES_TRIED = 200
MODULI = range(2, 14)


def algebra_exists(problem: Problem) -> bool | None:
    """Return whether the structure constants are defined for some values of the letters.

    Over all fields at once: in some field. None if this is not known.
    """
    if not problem.setting.divides:
        return True
    letters = tuple(name for name in problem.setting.letters if name in problem.letters)
    about_letters = problem.for_formula(TRUE, letters)
    statement = replace(
        about_letters.statement,
        unknowns=tuple((name, Sort.SCALAR) for name in letters),
        divides=True,
    )
    try:
        return _exists(problem.with_statement(statement))
    except (UndecidedError, TooLargeError):
        return None


def _exists(problem: Problem) -> bool | None:
    field = problem.field
    if field is None:
        return _generically(problem)
    if not problem.statement.unknowns:
        return Searcher(problem, RingScalars(field), True).test({})
    if (
        field.is_field
        and prime_search(problem, field.characteristic, MAX_PLACES_TRIED, True) is not None
    ):
        return True
    if ring_search(problem, MAX_PLACES_TRIED, True) is not None:
        return True
    if field.order is not None:
        found, _ = counterexample(problem.within(5.0), None, True)
        return found is not None
    if field.is_field:
        return _generically(problem)
    return False if _fails_modulo(problem) else None


def _generically(problem: Problem) -> bool:
    """Decide over an infinite field, or all fields, whether no divisor is 0 as a polynomial."""
    world = Symbolic(problem)
    if problem.field is None:
        return all(c != 0 for c in world.conditions)
    x = Expanded(world.context, world.variables, world.unknowns, ())
    return not any(vanishes_as_function(c, x, problem.field) for c in world.conditions)


def _fails_modulo(problem: Problem) -> bool:
    """Return whether, modulo some number, the divisors are never all units."""
    for n in MODULI:
        residues = problem.ring.modulo(n)
        if residues is None:
            continue
        try:
            found, _ = counterexample(problem.over(residues), None, True)
        except HFieldError:
            continue
        if found is None:
            return True
    return False
