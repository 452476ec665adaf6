"""Existence by linear algebra: where what is sought is linear, for any values of what is given.

The equations are a linear system whose coefficients are polynomials in the unknowns that are given.
Gauss and Jordan's elimination runs over it, with a case distinction at each pivot that may be 0. Each way
through ends in a case: a solution written as terms in what is given, and where it is one. Where all
equations are linear the cases are exact: something exists where one of them holds, and nowhere else.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from math import gcd
from time import monotonic
from typing import Any

from hfield.errors import TooLargeError
from hfield.proving.polynomials.expansion import coordinate_names, polynomial_world
from hfield.proving.polynomials.normal_form import Formula, Literal, branches
from hfield.proving.polynomials.recognition import polynomial_text
from hfield.proving.polynomials.vanishing import factored
from hfield.proving.statements.language import Sort, Statement
from hfield.proving.statements.setting import Setting

MAX_CASES = 64
MAX_BRANCHES = 8
MAX_TERMS = 200  # of a coefficient
MAX_WAYS = 300


@dataclass(frozen=True)
class Case:
    """Where ``when`` holds, the ``terms`` are what is said to exist."""

    when: str
    terms: tuple[tuple[str, str], ...]


Row = tuple[Any, ...]  # the coefficients of what is sought, and last the constant


@dataclass(frozen=True)
class _Way:
    """A way through the elimination: ``nonzero`` factors are not 0, the ``zero`` ones are."""

    rows: tuple[Row, ...]
    pivots: tuple[tuple[int, int], ...] = ()  # row, column
    nonzero: tuple[Any, ...] = ()
    zero: tuple[Any, ...] = ()


def linear_cases(
    statement: Statement, setting: Setting, deadline: float
) -> tuple[list[Case], bool]:
    """Return the cases in which what is said to exist can be written down, and whether they are all.

    Raises :class:`TooLargeError`.
    """
    system = System(statement, setting, deadline)
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


def _equations(formula: Formula) -> list[Any]:
    """Return the polynomials that are 0 where the formula is true, as far as that shows."""
    if formula.literal is not None:
        return list(formula.literal.polynomials) if formula.literal.zero else []
    return [f for part in formula.parts for f in _equations(part)] if formula.op == "and" else []


class System:
    """The polynomials of a statement, split into those sought and those given."""

    def __init__(self, statement: Statement, setting: Setting, deadline: float) -> None:
        self.statement, self.deadline = statement, deadline
        world, self.variables, _ = polynomial_world(statement, setting.constants)
        self.context, self.formula = world.context, world.truth(statement.conclusion)
        self.one = self.context.constant(1)
        names = [
            c
            for name, sort in statement.unknowns
            if name in statement.exists
            for c in coordinate_names(name, sort)
        ]
        self.bound = [self.variables.index(name) for name in names]
        self.p = None if setting.field is None else setting.field.characteristic
        self.known = [f for h in statement.hypotheses for f in _equations(world.truth(h))]
        self.ways = 0

    def rows(self, branch: Sequence[Literal]) -> list[Row] | None:
        """Return the equations of a conjunction of literals, None if one is not linear."""
        found = [self.row(f) for literal in branch if literal.zero for f in literal.polynomials]
        rows = [row for row in found if row is not None]
        return rows if len(rows) == len(found) else None

    def cases(self, rows: list[Row], unequal: list[tuple[Any, ...]]) -> Iterator[Case]:
        """Run through the cases of equations, where some tuples must not be 0."""
        for way in self.eliminate(self.start(rows)):
            for numerators, below in self.solutions(way, len(unequal)):
                case = self.case(rows, numerators, below, unequal)
                if case is not None:
                    yield case

    def start(self, rows: Sequence[Row]) -> _Way:
        """Return the system before the elimination, the equations among the hypotheses used."""
        way = _Way(tuple(map(self.primitive, rows)))
        for f in self.known:
            factors = self.factors(f) if f != 0 else []
            if len(factors) == 1:
                (g,) = factors
                way = replace(way, rows=self.without(way.rows, g), zero=(*way.zero, g))
        return way

    def row(self, f: Any) -> Row | None:
        """Return the equation f = 0 as a row, None if it is not linear in what is sought."""
        parts: list[dict[tuple[int, ...], int]] = [{} for _ in range(len(self.bound) + 1)]
        for exponents, c in f.terms():
            m = list(map(int, exponents))
            own = [k for k, n in enumerate(self.bound) if m[n]]
            if len(own) > 1 or (own and m[self.bound[own[0]]] > 1):
                return None
            if own:
                m[self.bound[own[0]]] = 0
            parts[own[0] if own else -1][tuple(m)] = int(c)
        return tuple(self.context.from_dict(part) for part in parts)

    # --- polynomials -----------------------------------------------------------------------------

    def is_zero(self, f: Any) -> bool:
        """Tell whether a polynomial is 0 over all fields that are meant."""
        return bool(f == 0 or (self.p and int(f.content()) % self.p == 0))

    def is_unit(self, f: Any) -> bool:
        """Tell whether a polynomial is a number that is not 0 in any field that is meant."""
        return bool(f != 0 and f.is_constant() and self.is_nonzero_number(int(f.content())))

    def is_nonzero_number(self, n: int) -> bool:
        """Tell whether a number is not 0 in any field that is meant."""
        if self.p is None or n == 0:
            return abs(n) == 1
        return self.p == 0 or n % self.p != 0

    def primitive(self, row: Row, nonzero: Sequence[Any] = ()) -> Row:
        """Divide a row by common factors that are not 0."""
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

    def factors(self, f: Any) -> list[Any]:
        """Return the factors of f that are not known to be units."""
        number, powers = factored(f)
        out = [g for g, _ in powers]
        n = abs(number)
        return out if self.is_nonzero_number(n) else [self.context.constant(n), *out]

    # --- elimination -----------------------------------------------------------------------------

    def eliminate(self, way: _Way) -> Iterator[_Way]:
        """Run through the ways to eliminate."""
        self.ways += 1
        if self.ways > MAX_WAYS or monotonic() > self.deadline:
            raise TooLargeError("the linear algebra takes too many cases")
        found = self.pivot(way)
        if found is None:
            yield way
            return
        r, c = found
        unknown = [f for f in self.factors(way.rows[r][c]) if f not in way.nonzero]
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

    def pivot(self, way: _Way) -> tuple[int, int] | None:
        """Return the place of the simplest coefficient that may be a pivot."""
        best, place = None, None
        rows, columns = {r for r, _ in way.pivots}, {c for _, c in way.pivots}
        for r, row in enumerate(way.rows):
            if r in rows:
                continue
            for c, f in enumerate(row[:-1]):
                if c in columns or self.is_zero(f) or any(f % z == 0 for z in way.zero):
                    continue
                size = (not self.is_unit(f), not f.is_constant(), len(f), f.total_degree())
                if best is None or size < best:
                    best, place = size, (r, c)
        return place

    def step(self, rows: Sequence[Row], r: int, c: int, nonzero: Sequence[Any]) -> tuple[Row, ...]:
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
                row = self.primitive(row, nonzero)
            out.append(row)
        return tuple(out)

    def without(self, rows: Sequence[Row], f: Any) -> tuple[Row, ...]:
        """Use f = 0: where it expresses a variable by others, that variable goes."""
        gens = self.context.gens()
        for n, v in enumerate(gens):
            if f.degrees()[n] != 1:
                continue
            slope = f.derivative(n)
            if slope in (1, -1):
                instead = (f - slope * v) * -slope
                values = [instead if m == n else g for m, g in enumerate(gens)]
                return tuple(tuple(x.compose(*values) for x in row) for row in rows)
        return tuple(rows)

    def solutions(self, way: _Way, unequal: int) -> Iterator[tuple[list[Any], Any]]:
        """Run through solutions as numerators with a common denominator.

        What no pivot determines is 0; where something must not be 0, other small numbers are tried.
        """
        free = [c for c in range(len(self.bound)) if c not in {c for _, c in way.pivots}]
        choices: list[dict[int, int]] = [{}]
        if unequal:
            choices += [{c: n} for n in range(1, unequal + 1) for c in free]
        if unequal > 1:
            choices.append({c: n for n, c in enumerate(free, 1)})
        below = self.one
        for r, c in way.pivots:
            d = way.rows[r][c]
            below = below * (d / below.gcd(d))
        for choice in choices:
            values = [
                self.context.constant(choice.get(c, 0)) * below for c in range(len(self.bound))
            ]
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

    # --- cases -----------------------------------------------------------------------------------

    def case(
        self, rows: Sequence[Row], values: list[Any], below: Any, unequal: list[tuple[Any, ...]]
    ) -> Case | None:
        """Return a solution as a case, None where its condition is never true."""
        when = [] if self.is_unit(below) else [f"{self.text(below)} != 0"]
        for row in rows:
            rest = row[-1] * below
            for a, x in zip(row, values, strict=False):
                rest = rest + a * x
            if self.is_zero(rest):
                continue
            if self.is_nonzero_with(rest, below):
                return None
            when.append(f"{self.text(self.radical(rest))} == 0")
        for polynomials in unequal:
            put = [self.put(f, values, below) for f in polynomials]
            if any(self.is_nonzero_with(f, below) for f in put if not self.is_zero(f)):
                continue
            some = [f"{self.text(self.radical(f))} != 0" for f in put if not self.is_zero(f)]
            if not some:
                return None
            when.append(some[0] if len(some) == 1 else f"({' or '.join(some)})")
        return Case(" and ".join(dict.fromkeys(when)) or "0 == 0", tuple(self.terms(values, below)))

    def is_nonzero_with(self, f: Any, below: Any) -> bool:
        """Tell whether f is certainly not 0 where ``below`` is not."""
        return all(below % g == 0 for g in self.factors(f))

    def radical(self, f: Any) -> Any:
        """Return a polynomial with the same zeros that is squarefree."""
        out = self.one
        for g in self.factors(f):
            out = out * g
        return out

    def put(self, f: Any, values: list[Any], below: Any) -> Any:
        """Put the solution into f; the result is a numerator over a power of ``below``."""
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
                raise TooLargeError("a solution put in grows too large")
        return total

    def terms(self, values: list[Any], below: Any) -> Iterator[tuple[str, str]]:
        """Write the solution as terms."""
        rest = iter(values)
        for name, sort in self.statement.unknowns:
            if name in self.statement.exists:
                width = 1 if sort is Sort.SCALAR else 4
                yield name, self.term(list(islice(rest, width)), below)

    def term(self, numerators: list[Any], below: Any) -> str:
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
            if not self.is_zero(f):
                text = self.text(f)
                parts.append(text if not unit else unit if text == "1" else f"({text})*{unit}")
        top = " + ".join(parts) or "0"
        if below == 1 or top == "0":
            return top
        bottom = self.text(below)
        return "/".join(x if x.isalnum() else f"({x})" for x in (top, bottom))

    def text(self, f: Any) -> str:
        """Write a polynomial in the language."""
        return polynomial_text(f, self.variables)
