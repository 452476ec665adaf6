"""Find values at which a statement fails, by search or by solving equations.

Conditions are solved by trying small values and propagating: variables get values one after another, and when
a condition has only one variable left, its value follows (from a linear equation, a square root, or a few
candidates). This finds values that a search of small points misses, for hypotheses such as ``3*p == inv(q)``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, count, islice
from typing import TYPE_CHECKING

from flint import fmpq

from hfield.core.product import Scalar
from hfield.errors import HFieldError, TooLargeError, UndecidedError
from hfield.fields.base.powers import power
from hfield.fields.base.ring import Ring
from hfield.fields.base.roots import rational_roots
from hfield.prover.counterexamples.candidates import (
    nonzero_first,
    prime_search,
    ring_search,
    small_scalars,
)
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.evaluation.searcher import Assignment, Searcher, assigned, lifted
from hfield.prover.polynomials.expansion import Expanded
from hfield.prover.polynomials.normal_form import PolynomialClause
from hfield.prover.polynomials.starting_relations import quaternions_of
from hfield.prover.polynomials.vanishing import Monomial, coefficients
from hfield.prover.problem import Problem

if TYPE_CHECKING:
    import flint


PLACES_BEFORE, PLACES_BETWEEN, PLACES_AFTER = 120, 400, 20_000
"""How many places are tried before, between and after attempts at proofs."""
MAX_AXES = 8
FIRST_ATTEMPT_SECONDS = 0.5  # seconds for the first attempt at a proof, and for solving one clause


def quick_search(problem: Problem) -> Assignment | None:
    """Try a few points of the prime field; a witness there holds over every extension."""
    found = prime_search(problem, problem.ring.characteristic, PLACES_BEFORE)
    return None if found is None else lifted(problem.ring, found)


def search_counterexample(problem: Problem, limit: int) -> Assignment | None:
    """Search for a counterexample, first among numbers, then among elements of the ring."""
    field = problem.ring
    if field.is_field:
        found = prime_search(problem, field.characteristic, limit)
        if found is not None:
            return lifted(field, found)
    return ring_search(problem, limit)


def solve_clauses(
    problem: Problem, x: Expanded, left: Sequence[PolynomialClause]
) -> Assignment | None:
    """Search for a counterexample by solving the hypotheses, and test it on the statement."""
    test = Searcher(problem, RingScalars(problem.ring)).test
    quaternions = quaternions_of(problem)
    for clause in left:
        for narrower in (*narrowed(clause, quaternions), clause, *on_axes(clause)):
            try:
                found = solve(problem.within(FIRST_ATTEMPT_SECONDS), x, narrower)
            except HFieldError:  # such as a root that is known to some digits only
                continue
            if found is not None and test(found):
                return found
    return None


def on_axes(clause: PolynomialClause) -> Iterator[PolynomialClause]:
    """Yield clauses in which all but one of the variables of the conditions are 0."""
    gens = clause.zeros[0].context().gens() if clause.zeros else ()
    used = [g for n, g in enumerate(gens) if any(z.degrees()[n] for z in clause.zeros)]
    for own in used[:MAX_AXES] if len(used) > 1 else ():
        yield PolynomialClause((*clause.zeros, *(g for g in used if g != own)), clause.goals)


def narrowed(
    clause: PolynomialClause,
    quaternions: Sequence[tuple[tuple[flint.fmpz_mpoly, ...], flint.fmpz_mpoly]],
) -> Iterator[PolynomialClause]:
    """Yield clauses with more conditions; counterexamples to them are counterexamples to the clause.

    A norm is replaced by the condition that its quaternion is 0, and a quadratic polynomial that is never
    negative by the condition that its gradient is 0. These conditions are linear; small points may all miss
    them, as for ``norm(p + 7)``.
    """
    for q, norm in quaternions:
        if norm in clause.zeros or -norm in clause.zeros:
            others = [z for z in clause.zeros if z not in (norm, -norm)]
            yield PolynomialClause((*others, *(u for u in q if u != 0)), clause.goals)
    bent = [z for z in clause.zeros if z.total_degree() == 2]
    if bent:
        slopes = [z.derivative(n) for z in bent for n in range(z.context().nvars())]
        yield PolynomialClause((*clause.zeros, *(f for f in slopes if f != 0)), clause.goals)


MAX_NODES = 1_500
MAX_TERMS = 400
BRANCHES = 5

Polynomial = dict[Monomial, Scalar]


def solve(problem: Problem, x: Expanded, clause: PolynomialClause) -> Assignment | None:
    """Return values at which the clause fails: its zeros vanish, but not all polynomials of any goal.

    For letters, 0 is tried last.
    """
    field = problem.ring
    zeros = [dict(coefficients(z, x, field)) for z in clause.zeros]
    goals = [[dict(coefficients(g, x, field)) for g in goal] for goal in clause.goals]
    if any(len(f) > MAX_TERMS for f in (*zeros, *(f for goal in goals for f in goal))):
        return None
    solver = _Solver(problem, x)
    solver.eliminate(zeros, goals)
    values = solver.run(zeros, goals, {})
    if values is None:
        return None
    return assigned(problem.statement, (values[n] for n in range(x.unknowns)))


class _Solver:
    def __init__(self, problem: Problem, x: Expanded) -> None:
        self.problem, self.field, self.unknowns = problem, problem.ring, x.unknowns
        self.letters = {n for n, name in enumerate(x.variables) if name in problem.letters}
        self.nodes = 0
        self.eliminated: list[tuple[int, Polynomial]] = []  # variable, its value

    def eliminate(self, zeros: list[Polynomial], goals: list[list[Polynomial]]) -> None:
        """Eliminate variables in place by conditions ``c·v + rest = 0``, as long as polynomials
        stay small.
        """
        while True:
            found = next((hit for z in zeros for hit in self.expressions(z)), None)
            if found is None:
                return
            n, expression = found
            try:
                conditions = [f for z in zeros if (f := self.compose(z, n, expression))]
                wanted = [[self.compose(g, n, expression) for g in goal] for goal in goals]
            except TooLargeError:
                return
            zeros[:], goals[:] = conditions, wanted
            self.eliminated.append((n, expression))

    def expressions(self, z: Polynomial) -> Iterator[tuple[int, Polynomial]]:
        """Yield the variables that a condition expresses by the other variables."""
        field = self.field
        for m, c in z.items():
            if sum(m) == 1:
                n = m.index(1)
                if all(not other[n] for other in z if other != m):
                    factor = field.zero - field.inverse(c)
                    yield n, {other: d * factor for other, d in z.items() if other != m}

    def compose(self, f: Polynomial, n: int, g: Polynomial) -> Polynomial:
        """Substitute the polynomial g for variable n. Raises TooLargeError."""
        field = self.field
        out: Polynomial = {}
        for m, c in f.items():
            terms = {(*m[:n], 0, *m[n + 1 :]): c}
            for _ in range(m[n]):
                if len(terms) * len(g) > MAX_TERMS:
                    raise TooLargeError("an elimination grows too large")
                terms = self.product(terms, g)
            for monomial, d in terms.items():
                out[monomial] = out[monomial] + d if monomial in out else d
        return {m: c for m, c in out.items() if not field.is_zero(c)}

    def product(self, f: Polynomial, g: Polynomial) -> Polynomial:
        """Return f·g."""
        out: Polynomial = {}
        for m, c in f.items():
            for k, d in g.items():
                monomial = tuple(a + b for a, b in zip(m, k, strict=True))
                out[monomial] = out[monomial] + c * d if monomial in out else c * d
        return out

    def run(
        self, zeros: list[Polynomial], goals: list[list[Polynomial]], values: dict[int, Scalar]
    ) -> dict[int, Scalar] | None:
        """Extend ``values`` to a solution, or return None."""
        self.nodes += 1
        if self.nodes > MAX_NODES or self.problem.is_late:
            return None
        zeros = [z for z in zeros if z]
        if any(len(z) == 1 and not any(next(iter(z))) for z in zeros) or any(
            not any(goal) for goal in goals
        ):
            return None
        if not zeros:
            return self.finish(goals, values)
        n, candidates = self.next(zeros)
        for value in candidates:
            found = self.run(
                [_put(z, n, value, self.field) for z in zeros],
                [[_put(g, n, value, self.field) for g in goal] for goal in goals],
                {**values, n: value},
            )
            if found is not None or self.nodes > MAX_NODES:
                return found
        return None

    def next(self, zeros: Sequence[Polynomial]) -> tuple[int, Iterator[Scalar]]:
        """Return the next variable and the values to try: a determined variable, or one in the most
        conditions.
        """
        weights: dict[int, list[int]] = {}
        for z in zeros:
            variables = _variables(z)
            if len(variables) == 1:
                return variables[0], self.roots(z, variables[0])
            for n in variables:
                highest = max(m[n] for m in z)
                entry = weights.setdefault(n, [0, 0])
                entry[0], entry[1] = max(entry[0], highest), entry[1] + 1
        tangled = max(weights, key=lambda n: (weights[n], -n))
        values = small_scalars(self.field)[:BRANCHES]
        return tangled, iter(nonzero_first(values) if tangled in self.letters else values)

    def roots(self, z: Polynomial, n: int) -> Iterator[Scalar]:
        """Yield zeros of a polynomial in one variable, all of them up to degree 2."""
        field, degree = self.field, max(m[n] for m in z)
        c = [field.zero] * (degree + 1)
        for m, value in z.items():
            c[m[n]] = c[m[n]] + value
        if degree == 1:
            yield field.divide(field.zero - c[0], c[1])
            return
        if degree == 2 and field.characteristic != 2:
            try:
                root = field.sqrt(c[1] * c[1] - field(4) * c[0] * c[2])
            except HFieldError:
                root = None
            if root is not None:
                half = field.inverse(c[2] + c[2])
                yield (field.zero - c[1] + root) * half
                yield (field.zero - c[1] - root) * half
                return
        yield from _roots(field, c)
        for value in small_scalars(field):
            total = field.zero
            for coefficient in reversed(c):
                total = total * value + coefficient
            if field.is_zero(total):
                yield value

    def finish(
        self, goals: list[list[Polynomial]], values: dict[int, Scalar]
    ) -> dict[int, Scalar] | None:
        """Choose the remaining variables so that in no goal all polynomials vanish."""
        chosen = values.keys() | {n for n, _ in self.eliminated}
        free = [n for n in range(self.unknowns) if n not in chosen]
        left = [next(f for f in goal if f) for goal in goals]
        found = nonzero_values(left, free, self.letters, self.field)
        if found is None:
            return None
        out = values | found
        for n, expression in reversed(self.eliminated):
            out[n] = self.value(expression, out)
        return out

    def value(self, f: Polynomial, values: Mapping[int, Scalar]) -> Scalar:
        """Evaluate f."""
        total: Scalar = self.field.zero
        for m, c in f.items():
            for n, e in enumerate(m):
                if e:
                    c = c * power(self.field.one, values[n], e)
            total = total + c
        return total


def _roots(field: Ring, coefficients: Sequence[Scalar]) -> list[Scalar]:
    """Return the roots in the field, or rational ones, as far as they are known."""
    try:
        return field.roots(coefficients)
    except UndecidedError:
        if field.characteristic:
            return []
    try:
        rational = [fmpq(*map(int, field.text(c).split("/"))) for c in coefficients]
        return list(map(field, rational_roots(rational)))
    except (ValueError, TypeError, UndecidedError):
        return []


def _variables(f: Polynomial) -> list[int]:
    return [n for n, used in enumerate(map(any, zip(*f, strict=True))) if used]


MAX_VALUES = 1_000


def nonzero_place(
    problem: Problem, x: Expanded, polynomials: Sequence[flint.fmpz_mpoly]
) -> Assignment | None:
    """Return values of the unknowns at which none of the polynomials is 0.

    Over an infinite field such values exist for any nonzero polynomials; over a finite field for a single
    polynomial that is not 0 as a function. For letters, 0 is tried last.
    """
    field = problem.ring
    left = [dict(coefficients(p, x, field, field.order)) for p in polynomials]
    if not all(left):
        return None
    letters = {n for n, name in enumerate(x.variables) if name in problem.letters}
    values = nonzero_values(left, range(x.unknowns), letters, field)
    return None if values is None else assigned(problem.statement, values.values())


def nonzero_values(
    polynomials: list[Polynomial], variables: Iterable[int], letters: set[int], field: Ring
) -> dict[int, Scalar] | None:
    """Choose values of the variables, one by one, at which no polynomial becomes 0; for letters, 0 is tried
    last.
    """
    values: dict[int, Scalar] = {}
    for n in variables:
        for value in values_of(field, n in letters):
            tried = [_put(f, n, value, field) for f in polynomials]
            if all(tried):
                polynomials, values[n] = tried, value
                break
        else:
            return None
    return values


def _put(f: Polynomial, n: int, value: Scalar, field: Ring) -> Polynomial:
    """Substitute a value for variable n."""
    out: Polynomial = {}
    for m, c in f.items():
        if m[n]:
            c = c * power(field.one, value, m[n])
            m = (*m[:n], 0, *m[n + 1 :])
        out[m] = out[m] + c if m in out else c
    return {m: c for m, c in out.items() if not field.is_zero(c)}


def values_of(field: Ring, nonzero: bool = False) -> Iterator[Scalar]:
    """Yield distinct elements of a field, small ones first: all of them, or a thousand.

    With ``nonzero``, 0 comes last.
    """
    values = islice(_values(field), MAX_VALUES)
    return chain(islice(values, 1, None), [field.zero]) if nonzero else values


def _values(field: Ring) -> Iterator[Scalar]:
    if field.order is not None:
        yield from field.elements()
        return
    yield from small_scalars(field)
    try:
        g = field.gen if field.characteristic else field(3)
    except HFieldError:
        return
    x = g * g if field.characteristic else g
    for _ in count():
        yield x
        x = x * g if field.characteristic else x + field.one
