"""Values of what is given at which linear equations for what is sought have no solution.

Gauss's elimination at one place after the other is quick, so that many can be looked at; what is found is
proved elsewhere.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from hfield.errors import TooLargeError
from hfield.product import Scalar
from hfield.proving.evaluation.scalars import constant
from hfield.proving.evaluation.searcher import Assignment
from hfield.proving.existence.elimination import Row
from hfield.proving.existence.linear_systems import System
from hfield.proving.polynomials.normal_form import branches
from hfield.proving.polynomials.vanishing import value_at
from hfield.proving.problem import Problem
from hfield.proving.statements.language import Sort
from hfield.rings.base import Ring

if TYPE_CHECKING:
    pass


MAX_TERMS = 2_000


def unsolvable_at(problem: Problem) -> Callable[[Assignment], bool] | None:
    """Return what tells that nothing exists at a place, None where the statement is not linear."""
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
        for name, sort in statement.unknowns:
            x = place.get(name)
            if x is not None:
                own = {name: x} if sort is Sort.SCALAR else {f"{name}[{n}]": x[n] for n in range(4)}
                values.update(own)
        return not any(_is_solvable(rows, system.variables, values, field) for rows in ways)

    return none_at


def _is_solvable(
    rows: Sequence[Row], variables: Sequence[str], values: Mapping[str, Scalar], field: Ring
) -> bool:
    """Tell whether linear equations have a solution, by elimination."""
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
