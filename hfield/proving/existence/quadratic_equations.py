"""A quadratic equation q² + s·q = c for one quaternion, solved by what the field knows of conics."""

from typing import Any

from hfield import structure
from hfield.errors import HFieldError
from hfield.product import Coordinates
from hfield.proving.evaluation.scalars import RingScalars
from hfield.proving.evaluation.searcher import Searcher
from hfield.proving.polynomials.expansion import Expanded, Quotient, Symbolic
from hfield.proving.polynomials.vanishing import Monomial, coefficients
from hfield.proving.problem import Problem
from hfield.proving.statements.language import Sort
from hfield.proving.statements.trees import conjuncts
from hfield.rings.base import Ring
from hfield.syntax import Compare, Name

ONE: Monomial = (0, 0, 0, 0)
SQUARE: Monomial = (2, 0, 0, 0)

Quadratic = tuple[Any, Coordinates]  # s/2 and c, for q² + s·q = c


def quaternion_roots(problem: Problem) -> list[Coordinates] | None:
    """Return some roots of an equation among those that are said, and one if there are any.

    None where there is no such equation, or where the field does not decide it. The statement has no
    quantifier and one unknown, a quaternion.
    """
    field, statement = problem.ring, problem.statement
    if not (field.is_field and field.is_exact):
        return None
    if [sort for _, sort in statement.unknowns] != [Sort.QUATERNION]:
        return None
    equations = [n for n in conjuncts(statement.node) if isinstance(n, Compare) and n.op == "=="]
    try:
        found = next(filter(None, (_read(problem, node) for node in equations)), None)
        if found is None:
            return None
        shift, c = found
        constants = Searcher(problem, RingScalars(field)).evaluator.constants
        square = (c[0] + shift * shift, *c[1:])  # (q + s/2)² = c + s²/4
        roots = structure.square_roots(field, constants, square)
    except HFieldError:
        return None
    every = [*roots.isolated, *([roots.quadric] if roots.quadric is not None else [])]
    return [(w - shift, x, y, z) for w, x, y, z in every]


def _read(problem: Problem, node: Compare) -> Quadratic | None:
    """Return s/2 and c if the equation says q² + s·q = c, up to a factor."""
    field, world = problem.ring, Symbolic(problem)
    x = Expanded(world.context, world.variables, world.unknowns, ())
    name = Name(problem.statement.unknowns[0][0])

    def expanded(tree: Any) -> list[dict[Monomial, Any]] | None:
        value, conditions = world.term(tree)
        if any(set(coefficients(c, x, field)) != {ONE} for c in conditions):
            return None
        return [_divided(f, x, field) for f in world.embed(value)]

    rest, square = expanded(node.left - node.right), expanded(name * name)
    if rest is None or square is None or SQUARE not in rest[0]:
        return None
    scale = field.inverse(rest[0][SQUARE])
    monic = [{m: scale * v for m, v in f.items()} for f in rest]
    left = [_minus(f, g, field) for f, g in zip(monic, square, strict=True)]
    units = [tuple(int(m == n) for m in range(4)) for n in range(4)]
    s = left[0].pop(units[0], field.zero)
    for f, unit in zip(left[1:], units[1:], strict=True):
        if not field.equal(f.pop(unit, field.zero), s):
            return None
    if any(set(f) - {ONE} for f in left) or (field.characteristic == 2 and not field.is_zero(s)):
        return None
    half = s if field.is_zero(s) else field.divide(s, field(2))
    w, i, j, k = (field.zero - f.get(ONE, field.zero) for f in left)
    return half, (w, i, j, k)


def _divided(value: Any, x: Expanded, field: Ring) -> dict[Monomial, Any]:
    """Return the coefficients of a polynomial, or of a fraction whose denominator is a number."""
    if not isinstance(value, Quotient):
        return dict(coefficients(value, x, field))
    below = field.inverse(coefficients(value.bottom, x, field)[ONE])
    return {m: below * c for m, c in coefficients(value.top, x, field).items()}


def _minus(f: dict[Monomial, Any], g: dict[Monomial, Any], field: Ring) -> dict[Monomial, Any]:
    out = dict(f)
    for m, c in g.items():
        out[m] = out.get(m, field.zero) - c
    return {m: c for m, c in out.items() if not field.is_zero(c)}
