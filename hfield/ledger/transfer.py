"""Transfer a proof over every commutative ring to one field."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

from hfield.errors import HFieldError
from hfield.fields.base.ring import Ring
from hfield.prover.clock import Clock
from hfield.prover.counterexamples.candidates import true_place
from hfield.prover.decide import decide
from hfield.prover.decision import COMMUTATIVE_RINGS, PROVED, Decision
from hfield.prover.evaluation.evaluator import Evaluator
from hfield.prover.evaluation.scalars import PrimeScalars
from hfield.prover.evaluation.searcher import Assignment
from hfield.prover.problem import Problem
from hfield.prover.statements.language import generators, read_statement
from hfield.prover.statements.setting import read_setting
from hfield.prover.statements.trees import conjunction

PLACES, SECONDS = 400, 5.0


def from_general_proof(formula: str, given: tuple[str, ...], field: Ring) -> Decision | None:
    """Decide over a field by a proof over every commutative ring; None if there is none.

    The hypotheses are shown to be satisfiable over the field, because otherwise the verdict could be
    "vacuous".
    """
    if not (field.is_exact and field.is_field):
        return None
    general = _general(formula, given)
    if general is None or generators(field) & set(general.problem.statement.sorts):
        return None
    return general.decision if general.is_satisfiable(field.characteristic) else None


@dataclass(frozen=True)
class _General:
    """A statement that is proved over every commutative ring, together with its reading there."""

    problem: Problem
    decision: Decision

    @cached_property
    def place(self) -> Assignment | None:
        """Small integers that satisfy the hypotheses, or None if none were found."""
        hypotheses = self.problem.statement.hypotheses
        if not hypotheses:
            return {}
        problem = replace(self.problem, clock=Clock.of(SECONDS))
        return true_place(problem.for_formula(conjunction(hypotheses)), PLACES)

    def is_satisfiable(self, characteristic: int) -> bool:
        """Return whether these integers satisfy the hypotheses also modulo the characteristic."""
        if self.place is None:
            return False
        statement, trees = self.problem.statement, self.problem.setting.trees
        world = Evaluator(PrimeScalars(characteristic), trees, statement.sorts)
        world.bind(self.place)
        return all(map(world.truth, statement.hypotheses))


@lru_cache(maxsize=8192)
def _general(formula: str, given: tuple[str, ...]) -> _General | None:
    """Prove a statement over every commutative ring; None if that fails, or if it mentions fields."""
    setting = read_setting()
    try:
        statement = read_statement(formula, None, given, setting.letters, setting.constants)
    except HFieldError:  # it speaks of constants of a field
        return None
    if statement.exists or statement.divides or statement.compares_unequal:
        return None
    decision = decide(formula, None, given)
    if decision.verdict != PROVED or decision.scope != COMMUTATIVE_RINGS:
        return None
    return _General(Problem(statement, setting), decision)
