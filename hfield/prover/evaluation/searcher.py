"""Evaluate a statement at many points."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice
from typing import Any, TypeVar

from hfield.core.product import Scalar
from hfield.errors import UndecidedError
from hfield.fields.base.ring import Ring
from hfield.prover.evaluation.evaluator import Evaluator
from hfield.prover.evaluation.scalars import PrimeScalars, RingScalars, constant
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Sort, Statement
from hfield.prover.statements.trees import walk
from hfield.syntax import Name

E = TypeVar("E", bound=Scalar)
Assignment = dict[str, Scalar | tuple[Scalar, ...]]  # unknown → a scalar or a tuple of four


def lifted(field: Ring[E], found: Mapping[str, object]) -> dict[str, E | tuple[E, ...]]:
    """Convert numbers, or texts of coordinates, to elements of the field."""
    return {
        name: tuple(map(field, x)) if isinstance(x, tuple) else field(x)
        for name, x in found.items()
    }


def read_back(field: Ring, witness: Mapping[str, Sequence[str]]) -> Assignment:
    """Return the values of a witness as elements of the field; the entry "F", the field's name, is
    ignored.
    """
    values = {name: texts for name, texts in witness.items() if name != "F"}
    return lifted(field, {n: tuple(x) if len(x) == 4 else x[0] for n, x in values.items()})


def assigned(statement: Statement, scalars: Iterable[Scalar]) -> Assignment:
    """Assign values to the unknowns, four coordinates to each quaternion."""
    rest = iter(scalars)
    return {
        name: next(rest) if sort is Sort.SCALAR else tuple(islice(rest, 4))
        for name, sort in statement.unknowns
    }


class Searcher:
    """Evaluates the statement of a problem at many points; ``wanted`` is the truth value searched for."""

    def __init__(
        self, problem: Problem, scalars: PrimeScalars | RingScalars, wanted: bool = False
    ) -> None:
        self.problem, self.wanted = problem, wanted
        fixed: Assignment = {}
        if isinstance(scalars, RingScalars):
            own = problem.statement.constants
            fixed = {text: constant(scalars.ring, text) for text in own}
        trees, sorts = problem.setting.trees, problem.statement.sorts
        self.evaluator: Evaluator[Any, bool, bool] = Evaluator(scalars, trees, sorts, fixed)
        self.holds = self.evaluator.function(problem.matrix)
        self.moving = bool(problem.letters)  # the structure constants, with the place
        self.exists = self.moving or bool(self.evaluator.bind({}))
        names = (node.name for node in walk(problem.matrix) if isinstance(node, Name))
        self.is_constant = not self.moving and sorts.keys().isdisjoint(names)

    def decide(self, assignment: Assignment) -> bool:
        """Return whether at an assignment the algebra exists and the statement has the wanted truth value.

        Raises :class:`UndecidedError` if this is not known, because a local field knows only some digits, or
        a user-defined ring may not know which elements are units.
        """
        exists = self.evaluator.bind(assignment) if self.moving else self.exists
        return bool(exists) and self.holds(assignment) is self.wanted

    def test(self, assignment: Assignment) -> bool:
        """Return whether :meth:`decide` is known to return True."""
        try:
            return self.decide(assignment)
        except UndecidedError:
            return False

    def first(self, assignments: Iterator[Assignment]) -> Assignment | None:
        """Return the first assignment with the wanted truth value that is found before the deadline."""
        if self.is_constant:
            assignments = islice(assignments, 1)
        for assignment in assignments:
            if self.problem.is_late:
                return None
            if self.test(assignment):
                return assignment
        return None
