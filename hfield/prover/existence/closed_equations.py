"""Solve equations without given values: linear equations, and equations in one unknown.

Linear equations over a Euclidean ring are solved by the Hermite normal form, over ℤ/n with multiples of n
added. Equations in one unknown are solved by the ring's root finding. q² + s·q = c, for a quaternion q, is
solved by square roots, which the field finds by conics.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from hfield.algebra import structure
from hfield.core.product import Coordinates, Scalar
from hfield.errors import HFieldError, TooLargeError, UndecidedError
from hfield.fields.base.ring import Ring
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.evaluation.searcher import Assignment, Searcher, assigned
from hfield.prover.polynomials.expansion import Expanded, PolynomialFraction, Symbolic, Term
from hfield.prover.polynomials.normal_form import branches
from hfield.prover.polynomials.vanishing import Monomial, coefficients
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Sort
from hfield.prover.statements.trees import conjuncts
from hfield.syntax import Compare, Name
from hfield.syntax.tree import Node

MAX_BRANCHES = 16
MAX_SIZE = 40  # of the rows and of the columns of a linear system

Polynomial = dict[Monomial, Scalar]


@dataclass(frozen=True)
class SolutionPlaces:
    """Some ``places`` (values) at which equations hold; ``none`` is True if they hold nowhere."""

    places: tuple[Assignment, ...] = ()
    none: bool = False


def closed_solutions(problem: Problem) -> SolutionPlaces:
    """Solve the equations of a quantifier-free statement for all its unknowns, over one ring."""
    field = problem.ring
    roots = quaternion_roots(problem)
    if roots is not None:
        ((name, _),) = problem.statement.unknowns
        return SolutionPlaces(tuple({name: root} for root in roots), none=not roots)
    try:
        world = Symbolic(problem)
        ways = list(branches(world.truth(problem.statement.node)))
    except TooLargeError:
        return SolutionPlaces()
    if len(ways) > MAX_BRANCHES or world.conditions:
        return SolutionPlaces()
    x = Expanded(world.context, world.variables, world.unknowns, ())
    places, none = list[Assignment](), True
    for way in ways:
        zeros = [f for part in way if part.zero for f in part.polynomials]
        try:
            found = _solved([dict(coefficients(f, x, field)) for f in zeros], world.unknowns, field)
        except UndecidedError:
            none = False
            continue
        none = none and not found
        places.extend(assigned(problem.statement, values) for values in found)
    return SolutionPlaces(tuple(places), none)


def _solved(equations: list[Polynomial], unknowns: int, field: Ring) -> list[list[Scalar]]:
    """Return several solutions, at least one if there are any. Raises :class:`UndecidedError`."""
    equations = [f for f in equations if f]
    used = {n for f in equations for m in f for n, e in enumerate(m) if e}
    if all(sum(m) <= 1 for f in equations for m in f):
        solution = _linear(equations, sorted(used), field)
        found = [] if solution is None else [dict(zip(sorted(used), solution, strict=True))]
    elif len(used) == 1:
        (n,) = used
        found = [{n: root} for root in _common_roots(equations, n, field)]
    else:
        raise UndecidedError("equations of higher degree in several unknowns are not solved here")
    return [[values.get(n, field.zero) for n in range(unknowns)] for values in found]


def _common_roots(equations: list[Polynomial], n: int, field: Ring) -> Iterator[Scalar]:
    """Yield the values of one unknown at which all equations hold."""
    dense = []
    for f in equations:
        c = [field.zero] * (max(m[n] for m in f) + 1)
        for m, value in f.items():
            c[m[n]] = value
        dense.append(c)
    first, *others = sorted(dense, key=len)
    for root in field.roots(first):
        if all(field.is_zero(_value(c, root, field)) for c in others):
            yield root


def _value(c: Sequence[Scalar], x: Scalar, field: Ring) -> Scalar:
    total: Scalar = field.zero
    for a in reversed(c):
        total = total * x + a
    return total


def _linear(equations: list[Polynomial], used: list[int], field: Ring) -> list[Scalar] | None:
    """Return a solution of linear equations for the unknowns ``used``, or None if there is none."""
    if max(len(equations), len(used)) > MAX_SIZE:
        raise UndecidedError("the linear equations are too many")
    rows = []
    for f in equations:
        by_unknown = {next((n for n, e in enumerate(m) if e), None): c for m, c in f.items()}
        rows.append([by_unknown.get(n, field.zero) for n in (*used, None)])
    over = field.residues_of
    if over is None:
        return _hermite(rows, field)
    base, modulus = over
    lifted = [
        [
            *(base(field.lift(a)) for a in row[:-1]),
            *(modulus if m == n else base.zero for m in range(len(rows))),
            base(field.lift(row[-1])),
        ]
        for n, row in enumerate(rows)
    ]
    solution = _hermite(lifted, base)
    return None if solution is None else [field(x) for x in solution[: len(used)]]


def _hermite(rows: list[list[Scalar]], ring: Ring) -> list[Scalar] | None:
    """Solve A·x + b = 0 over a Euclidean ring; each row of A ends with its entry of b.

    Columns are combined until A is lower triangular; then each unknown is obtained by a division, which may
    fail.
    """
    width = len(rows[0]) - 1 if rows else 0
    columns = [[row[n] for row in rows] for n in range(width)]
    steps = [[ring.one if m == n else ring.zero for m in range(width)] for n in range(width)]
    rest = [row[-1] for row in rows]
    solution = [ring.zero] * width
    at = 0
    for r in range(len(rows)):
        for other in range(at + 1, width):
            while not ring.is_zero(columns[other][r]):
                q, _ = ring.euclid(columns[at][r], columns[other][r])
                for table in (columns, steps):
                    reduced = [x - q * y for x, y in zip(table[at], table[other], strict=True)]
                    table[at], table[other] = table[other], reduced
        if at < width and not ring.is_zero(columns[at][r]):
            factor, left = ring.euclid(ring.zero - rest[r], columns[at][r])
            if not ring.is_zero(left):
                return None
            rest = [x + factor * y for x, y in zip(rest, columns[at], strict=True)]
            solution = [x + factor * y for x, y in zip(solution, steps[at], strict=True)]
            at += 1
        elif not ring.is_zero(rest[r]):
            return None
    return solution


ONE: Monomial = (0, 0, 0, 0)
SQUARE: Monomial = (2, 0, 0, 0)

Quadratic = tuple[Scalar, Coordinates]  # s/2 and c, for q² + s·q = c


def quaternion_roots(problem: Problem) -> list[Coordinates] | None:
    """Return some quaternion roots of an equation, at least one if there are any.

    None if there is no such equation, or the field does not decide it. The statement must be quantifier-free
    with a single quaternion as unknown.
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
    """Return s/2 and c if the equation is q² + s·q = c, up to a factor."""
    field, world = problem.ring, Symbolic(problem)
    x = Expanded(world.context, world.variables, world.unknowns, ())
    name = Name(problem.statement.unknowns[0][0])

    def expanded(tree: Node) -> list[Polynomial] | None:
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


def _divided(value: Term, x: Expanded, field: Ring) -> Polynomial:
    """Return the coefficients of a polynomial, or of a fraction with a number as denominator."""
    if not isinstance(value, PolynomialFraction):
        return dict(coefficients(value, x, field))
    below = field.inverse(coefficients(value.bottom, x, field)[ONE])
    return {m: below * c for m, c in coefficients(value.top, x, field).items()}


def _minus(f: Polynomial, g: Polynomial, field: Ring) -> Polynomial:
    out = dict(f)
    for m, c in g.items():
        out[m] = out.get(m, field.zero) - c
    return {m: c for m, c in out.items() if not field.is_zero(c)}
