"""Prove existence by linear algebra, for all given values.

The equations are a linear system whose coefficients are polynomials in the given unknowns. Gauss–Jordan
elimination distinguishes two cases at each pivot that may be 0. Each branch ends in a case: a solution as
terms in the given unknowns, with the condition under which it is a solution. If all equations are linear the
cases are exact: a witness exists if and only if one of the conditions holds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from math import gcd
from typing import TYPE_CHECKING, TypeAlias

from hfield.errors import TooLargeError
from hfield.prover.clock import Clock
from hfield.prover.polynomials.expansion import Symbolic, coordinate_names
from hfield.prover.polynomials.normal_form import Formula, Literal, branches
from hfield.prover.polynomials.recognition import polynomial_text
from hfield.prover.polynomials.vanishing import collected, factored
from hfield.prover.problem import Problem

if TYPE_CHECKING:
    import flint


MAX_CASES = 64
MAX_BRANCHES = 8


@dataclass(frozen=True)
class Case:
    """A case: if ``when`` holds, the ``terms`` are witnesses."""

    when: str
    terms: tuple[tuple[str, str], ...]


def linear_cases(problem: Problem) -> tuple[list[Case], bool]:
    """Return the cases with a formula for the existential unknowns, and whether these are all cases.

    Raises :class:`TooLargeError`.
    """
    system = System(problem)
    out: dict[Case, None] = {}
    ways = list(islice(branches(system.formula), MAX_BRANCHES + 1))
    exact = len(ways) <= MAX_BRANCHES
    for branch in ways[:MAX_BRANCHES]:
        rows = system.rows(branch)
        if rows is None:
            exact = False
            continue
        for case in system.cases(rows, [x.polynomials for x in branch if not x.zero]):
            out.setdefault(case)
            if len(out) >= MAX_CASES:
                return list(out), False
    return list(out), exact


def _equations(formula: Formula) -> list[flint.fmpz_mpoly]:
    """Return polynomials that are 0 if the formula is true, as far as its form shows."""
    if formula.literal is not None:
        return list(formula.literal.polynomials) if formula.literal.zero else []
    return [f for part in formula.parts for f in _equations(part)] if formula.op == "and" else []


class System:
    """The polynomials of a statement, with sought and given variables separated."""

    def __init__(self, problem: Problem) -> None:
        statement = self.statement = problem.statement
        world = Symbolic(problem)
        self.variables, self.context = world.variables, world.context
        self.formula = world.truth(statement.conclusion)
        p = None if problem.field is None else problem.field.characteristic
        self.of = FieldCoefficients(self.context, p)
        names = [
            c
            for name, sort in statement.unknowns
            if name in statement.exists
            for c in coordinate_names(name, sort)
        ]
        self.bound = [self.variables.index(name) for name in names]
        self.elimination = Elimination(self.of, len(names), problem.clock)
        self.known = [f for h in statement.hypotheses for f in _equations(world.truth(h))]

    def rows(self, branch: Sequence[Literal]) -> list[Row] | None:
        """Return the equations of a conjunction of literals, or None if one is not linear."""
        found = [self.row(f) for literal in branch if literal.zero for f in literal.polynomials]
        rows = [row for row in found if row is not None]
        return rows if len(rows) == len(found) else None

    def cases(self, rows: list[Row], unequal: list[tuple[flint.fmpz_mpoly, ...]]) -> Iterator[Case]:
        """Yield the cases of equations in which some tuples must not be 0."""
        steps = self.elimination
        for way in steps.eliminate(steps.start(rows, self.known)):
            for numerators, below in steps.solutions(way, len(unequal)):
                case = self.case(rows, numerators, below, unequal)
                if case is not None:
                    yield case

    def row(self, f: flint.fmpz_mpoly) -> Row | None:
        """Return the equation f = 0 as a row, or None if it is not linear in the sought unknowns."""
        row = [self.context.constant(0)] * (len(self.bound) + 1)
        for m, c in collected(f, self.bound).items():
            if sum(m) > 1:
                return None
            row[next((k for k, n in enumerate(self.bound) if m[n]), -1)] = c
        return tuple(row)

    # --- cases -----------------------------------------------------------------------------------

    def case(
        self,
        rows: Sequence[Row],
        values: list[flint.fmpz_mpoly],
        below: flint.fmpz_mpoly,
        unequal: list[tuple[flint.fmpz_mpoly, ...]],
    ) -> Case | None:
        """Return a solution as a case of a proof, or None if its condition is never true."""
        when = [] if self.of.is_unit(below) else [f"{self.text(below)} != 0"]
        for row in rows:
            rest = row[-1] * below
            for a, x in zip(row, values, strict=False):
                rest = rest + a * x
            if self.of.is_zero(rest):
                continue
            if self.is_nonzero_with(rest, below):
                return None
            when.append(f"{self.text(self.of.radical(rest))} == 0")
        for polynomials in unequal:
            put = [self.put(f, values, below) for f in polynomials]
            if any(self.is_nonzero_with(f, below) for f in put if not self.of.is_zero(f)):
                continue
            some = [f"{self.text(self.of.radical(f))} != 0" for f in put if not self.of.is_zero(f)]
            if not some:
                return None
            when.append(some[0] if len(some) == 1 else f"({' or '.join(some)})")
        return Case(" and ".join(dict.fromkeys(when)) or "0 == 0", tuple(self.terms(values, below)))

    def is_nonzero_with(self, f: flint.fmpz_mpoly, below: flint.fmpz_mpoly) -> bool:
        """Return whether f is known to be nonzero if ``below`` is nonzero."""
        return all(below % g == 0 for g in self.of.factors(f))

    def put(
        self, f: flint.fmpz_mpoly, values: list[flint.fmpz_mpoly], below: flint.fmpz_mpoly
    ) -> flint.fmpz_mpoly:
        """Substitute the solution in f; return the numerator over a power of ``below``."""
        degree = max((sum(int(m[n]) for n in self.bound) for m, _ in f.terms()), default=0)
        total = self.context.constant(0)
        for exponents, c in f.terms():
            m, own = list(map(int, exponents)), 0
            term = self.context.constant(int(c))
            for x, n in zip(values, self.bound, strict=True):
                term = term * x ** m[n]
                own, m[n] = own + m[n], 0
            total += term * below ** (degree - own) * self.context.from_dict({tuple(m): 1})
            if len(total) > MAX_TERMS:
                raise TooLargeError("a substituted solution grows too large")
        return total

    def terms(
        self, values: list[flint.fmpz_mpoly], below: flint.fmpz_mpoly
    ) -> Iterator[tuple[str, str]]:
        """Write the solution as terms."""
        rest = iter(values)
        for name, sort in self.statement.unknowns:
            if name in self.statement.exists:
                yield name, self.term(list(islice(rest, sort.width)), below)

    def term(self, numerators: list[flint.fmpz_mpoly], below: flint.fmpz_mpoly) -> str:
        """Write a scalar, or a quaternion, with its denominator."""
        common = below
        for f in numerators:
            common = common.gcd(f)
        n = gcd(*(int(f.content()) for f in (below, *numerators) if f != 0))
        if below.leading_coefficient() < 0:
            n = -n
        common = common * (n // int(common.content()))
        numerators, below = [f / common for f in numerators], below / common
        parts = []
        for f, unit in zip(numerators, ("", "i", "j", "k"), strict=False):
            if not self.of.is_zero(f):
                text = self.text(f)
                parts.append(text if not unit else unit if text == "1" else f"({text})*{unit}")
        top = " + ".join(parts) or "0"
        if below == 1 or top == "0":
            return top
        bottom = self.text(below)
        return "/".join(x if x.isalnum() else f"({x})" for x in (top, bottom))

    def text(self, f: flint.fmpz_mpoly) -> str:
        """Write a polynomial in the language."""
        return polynomial_text(f, self.variables)


Row: TypeAlias = (
    "tuple[flint.fmpz_mpoly, ...]"  # the coefficients of the unknowns, followed by the constant
)


class FieldCoefficients:
    """Polynomials over ``context``, over the fields of characteristic p, or over all fields if p is None."""

    def __init__(self, context: flint.fmpz_mpoly_ctx, p: int | None) -> None:
        self.context, self.p = context, p
        self.one = context.constant(1)

    def is_zero(self, f: flint.fmpz_mpoly) -> bool:
        """Return whether a polynomial is 0 over all fields of the problem."""
        return bool(f == 0 or (self.p and int(f.content()) % self.p == 0))

    def is_unit(self, f: flint.fmpz_mpoly) -> bool:
        """Return whether a polynomial is a number that is nonzero in all fields of the problem."""
        return bool(f != 0 and f.is_constant() and self.is_nonzero_number(int(f.content())))

    def is_nonzero_number(self, n: int) -> bool:
        """Return whether a number is nonzero in all fields of the problem."""
        if self.p is None or n == 0:
            return abs(n) == 1
        return self.p == 0 or n % self.p != 0

    def primitive(self, row: Row, nonzero: Sequence[flint.fmpz_mpoly] = ()) -> Row:
        """Divide a row by common factors that are known to be nonzero."""
        common = self.context.constant(0)
        for f in row:
            common = common.gcd(f)
        if common == 0:
            return row
        n = int(common.content())
        divisor = self.context.constant(n if self.is_nonzero_number(n) else 1)
        for f in nonzero:
            while common % f == 0 and not common.is_constant():
                common, divisor = common / f, divisor * f
        return tuple(f / divisor for f in row)

    def factors(self, f: flint.fmpz_mpoly) -> list[flint.fmpz_mpoly]:
        """Return the factors of f that are not known to be units."""
        number, powers = factored(f)
        out = [g for g, _ in powers]
        n = abs(number)
        return out if self.is_nonzero_number(n) else [self.context.constant(n), *out]

    def radical(self, f: flint.fmpz_mpoly) -> flint.fmpz_mpoly:
        """Return a squarefree polynomial with the same zeros."""
        out = self.one
        for g in self.factors(f):
            out = out * g
        return out


MAX_TERMS = 200  # of a coefficient
MAX_WAYS = 300


@dataclass(frozen=True)
class EliminationBranch:
    """A branch of the elimination: the factors ``nonzero`` are not 0, the factors ``zero`` are 0."""

    rows: tuple[Row, ...]
    pivots: tuple[tuple[int, int], ...] = ()  # row, column
    nonzero: tuple[flint.fmpz_mpoly, ...] = ()
    zero: tuple[flint.fmpz_mpoly, ...] = ()


class Elimination:
    """Enumerates the branches of solving linear equations for ``width`` unknowns."""

    def __init__(self, coefficients: FieldCoefficients, width: int, clock: Clock) -> None:
        self.of, self.width, self.clock, self.ways = coefficients, width, clock, 0

    def start(self, rows: Sequence[Row], known: Sequence[flint.fmpz_mpoly]) -> EliminationBranch:
        """Return the system before the elimination, reduced by polynomials that are known to be 0."""
        way = EliminationBranch(tuple(map(self.of.primitive, rows)))
        for f in known:
            factors = self.of.factors(f) if f != 0 else []
            if len(factors) == 1:
                (g,) = factors
                way = replace(way, rows=self.without(way.rows, g), zero=(*way.zero, g))
        return way

    def eliminate(self, way: EliminationBranch) -> Iterator[EliminationBranch]:
        """Yield the branches of the elimination."""
        self.ways += 1
        if self.ways > MAX_WAYS or self.clock.is_late:
            raise TooLargeError("the linear algebra takes too many cases")
        found = self.pivot(way)
        if found is None:
            yield way
            return
        r, c = found
        unknown = [f for f in self.of.factors(way.rows[r][c]) if f not in way.nonzero]
        nonzero = (*way.nonzero, *unknown)
        yield from self.eliminate(
            replace(
                way,
                rows=self.step(way.rows, r, c, nonzero),
                pivots=(*way.pivots, (r, c)),
                nonzero=nonzero,
            )
        )
        for n, f in enumerate(unknown):
            rows = self.without(way.rows, f)
            if all(rows[r][c] != 0 for r, c in way.pivots):
                yield from self.eliminate(
                    replace(
                        way,
                        rows=rows,
                        nonzero=(*way.nonzero, *unknown[:n]),
                        zero=(*way.zero, f),
                    )
                )

    def pivot(self, way: EliminationBranch) -> tuple[int, int] | None:
        """Return the position of the simplest coefficient that may be a pivot."""
        best, place = None, None
        rows, columns = {r for r, _ in way.pivots}, {c for _, c in way.pivots}
        for r, row in enumerate(way.rows):
            if r in rows:
                continue
            for c, f in enumerate(row[:-1]):
                if c in columns or self.of.is_zero(f) or any(f % z == 0 for z in way.zero):
                    continue
                size = (not self.of.is_unit(f), not f.is_constant(), len(f), f.total_degree())
                if best is None or size < best:
                    best, place = size, (r, c)
        return place

    def step(
        self, rows: Sequence[Row], r: int, c: int, nonzero: Sequence[flint.fmpz_mpoly]
    ) -> tuple[Row, ...]:
        """Clear column c by row r in all other rows."""
        own, out = rows[r], []
        for n, row in enumerate(rows):
            a, d = row[c], own[c]
            if n != r and a != 0:
                g = a.gcd(d)
                a, d = a / g, d / g
                row = tuple(d * x - a * y for x, y in zip(row, own, strict=True))
                if max(map(len, row)) > MAX_TERMS:
                    raise TooLargeError("the coefficients of the linear algebra grow too large")
                row = self.of.primitive(row, nonzero)
            out.append(row)
        return tuple(out)

    def without(self, rows: Sequence[Row], f: flint.fmpz_mpoly) -> tuple[Row, ...]:
        """Use f = 0 to eliminate a variable, if f = 0 expresses a variable by others."""
        gens = self.of.context.gens()
        for n, v in enumerate(gens):
            if f.degrees()[n] != 1:
                continue
            slope = f.derivative(n)
            if slope in (1, -1):
                instead = (f - slope * v) * -slope
                values = [instead if m == n else g for m, g in enumerate(gens)]
                return tuple(tuple(x.compose(*values) for x in row) for row in rows)
        return tuple(rows)

    def solutions(
        self, way: EliminationBranch, unequal: int
    ) -> Iterator[tuple[list[flint.fmpz_mpoly], flint.fmpz_mpoly]]:
        """Yield solutions as numerators with a common denominator.

        Unknowns that no pivot determines are 0; if something must be nonzero, other small numbers are tried.
        """
        free = [c for c in range(self.width) if c not in {c for _, c in way.pivots}]
        choices: list[dict[int, int]] = [{}]
        if unequal:
            choices += [{c: n} for n in range(1, unequal + 1) for c in free]
        if unequal > 1:
            choices.append({c: n for n, c in enumerate(free, 1)})
        below = self.of.one
        for r, c in way.pivots:
            d = way.rows[r][c]
            below = below * (d / below.gcd(d))
        for choice in choices:
            values = [self.of.context.constant(choice.get(c, 0)) * below for c in range(self.width)]
            for r, c in way.pivots:
                row = way.rows[r]
                total = row[-1]
                for n, k in choice.items():
                    total = total + k * row[n]
                values[c] = -total * (below / row[c])
            common = below
            for f in values:
                common = common.gcd(f)
            if below / common == -1:
                common = -common
            yield [f / common for f in values], below / common
