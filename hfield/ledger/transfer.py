"""From every commutative ring to one field: what is proved for all of them need not be proved again."""

from __future__ import annotations

from functools import lru_cache

from hfield.errors import HFieldError
from hfield.proving.clock import Clock
from hfield.proving.counterexamples.candidates import true_place
from hfield.proving.decide import decide
from hfield.proving.decision import COMMUTATIVE_RINGS, PROVED, Decision
from hfield.proving.evaluation.evaluator import Evaluator
from hfield.proving.evaluation.scalars import PrimeScalars
from hfield.proving.evaluation.searcher import Assignment
from hfield.proving.problem import Problem
from hfield.proving.statements.language import Statement, generators, read_statement
from hfield.proving.statements.setting import read_setting
from hfield.proving.statements.trees import conjunction
from hfield.rings.base import Ring

PLACES, SECONDS = 400, 5.0


def carried(formula: str, given: tuple[str, ...], field: Ring) -> Decision | None:
    """Decide over a field by a proof over every commutative ring; None where there is none.

    The hypotheses are seen to be satisfiable there, or else the verdict could be "vacuous".
    """
    if not (field.is_exact and field.is_field):
        return None
    found = _general(formula, given)
    if found is None:
        return None
    decision, statement = found
    if generators(field) & set(statement.sorts):
        return None
    return decision if _satisfiable(formula, given, field.characteristic) else None


@lru_cache(maxsize=8192)
def _general(formula: str, given: tuple[str, ...]) -> tuple[Decision, Statement] | None:
    """Return the proof over every commutative ring, with the statement as it is read there."""
    setting = read_setting(None, None)
    try:
        statement = read_statement(formula, None, given, setting.letters, setting.constants)
    except HFieldError:  # it speaks of constants of a field
        return None
    if statement.exists or statement.divides or statement.compares_unequal:
        return None  # it speaks of fields
    decision = decide(formula, None, given)
    if decision.verdict != PROVED or decision.scope != COMMUTATIVE_RINGS:
        return None
    return decision, statement


@lru_cache(maxsize=8192)
def _satisfiable(formula: str, given: tuple[str, ...], characteristic: int) -> bool:
    """Tell whether integers were found that satisfy the hypotheses, modulo the characteristic."""
    place = _place(formula, given)
    setting, found = read_setting(None, None), _general(formula, given)
    if place is None or found is None:
        return False
    world = Evaluator(PrimeScalars(characteristic), setting.trees, found[1].sorts)
    world.bind(place)
    return all(world.truth(h) for h in found[1].hypotheses)


@lru_cache(maxsize=8192)
def _place(formula: str, given: tuple[str, ...]) -> Assignment | None:
    """Look for small integers that satisfy the hypotheses of a statement proved in general."""
    found = _general(formula, given)
    if found is None:
        return None
    _, statement = found
    if not statement.hypotheses:
        return {}
    problem = Problem(statement, read_setting(None, None), Clock.of(SECONDS))
    return true_place(problem.about(conjunction(statement.hypotheses)), PLACES)
