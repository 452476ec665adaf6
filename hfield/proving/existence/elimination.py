"""Gauss and Jordan's elimination with polynomials, a case distinction at each pivot that may be 0."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from hfield.errors import TooLargeError
from hfield.proving.clock import Clock
from hfield.proving.polynomials.vanishing import factored

if TYPE_CHECKING:
    import flint


Row = tuple[Any, ...]  # the coefficients of what is sought, and last the constant


class Coefficients:
    """The polynomials over ``context``, over the fields of characteristic p, or over all (p is None)."""

    def __init__(self, context: flint.fmpz_mpoly_ctx, p: int | None) -> None:
        self.context, self.p = context, p
        self.one = context.constant(1)

    def is_zero(self, f: flint.fmpz_mpoly) -> bool:
        """Tell whether a polynomial is 0 over all fields that are meant."""
        return bool(f == 0 or (self.p and int(f.content()) % self.p == 0))

    def is_unit(self, f: flint.fmpz_mpoly) -> bool:
        """Tell whether a polynomial is a number that is not 0 in any field that is meant."""
        return bool(f != 0 and f.is_constant() and self.is_nonzero_number(int(f.content())))

    def is_nonzero_number(self, n: int) -> bool:
        """Tell whether a number is not 0 in any field that is meant."""
        if self.p is None or n == 0:
            return abs(n) == 1
        return self.p == 0 or n % self.p != 0

    def primitive(self, row: Row, nonzero: Sequence[flint.fmpz_mpoly] = ()) -> Row:
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

    def factors(self, f: flint.fmpz_mpoly) -> list[flint.fmpz_mpoly]:
        """Return the factors of f that are not known to be units."""
        number, powers = factored(f)
        out = [g for g, _ in powers]
        n = abs(number)
        return out if self.is_nonzero_number(n) else [self.context.constant(n), *out]

    def radical(self, f: flint.fmpz_mpoly) -> flint.fmpz_mpoly:
        """Return a polynomial with the same zeros that is squarefree."""
        out = self.one
        for g in self.factors(f):
            out = out * g
        return out


MAX_TERMS = 200  # of a coefficient
MAX_WAYS = 300


@dataclass(frozen=True)
class Way:
    """A way through the elimination: ``nonzero`` factors are not 0, the ``zero`` ones are."""

    rows: tuple[Row, ...]
    pivots: tuple[tuple[int, int], ...] = ()  # row, column
    nonzero: tuple[Any, ...] = ()
    zero: tuple[Any, ...] = ()


class Elimination:
    """Runs through the ways to solve linear equations for ``width`` unknowns."""

    def __init__(self, coefficients: Coefficients, width: int, clock: Clock) -> None:
        self.of, self.width, self.clock, self.ways = coefficients, width, clock, 0

    def start(self, rows: Sequence[Row], known: Sequence[flint.fmpz_mpoly]) -> Way:
        """Return the system before the elimination, some polynomials that are 0 used."""
        way = Way(tuple(map(self.of.primitive, rows)))
        for f in known:
            factors = self.of.factors(f) if f != 0 else []
            if len(factors) == 1:
                (g,) = factors
                way = replace(way, rows=self.without(way.rows, g), zero=(*way.zero, g))
        return way

    def eliminate(self, way: Way) -> Iterator[Way]:
        """Run through the ways to eliminate."""
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

    def pivot(self, way: Way) -> tuple[int, int] | None:
        """Return the place of the simplest coefficient that may be a pivot."""
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
        """Use f = 0: where it expresses a variable by others, that variable goes."""
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

    def solutions(self, way: Way, unequal: int) -> Iterator[tuple[list[Any], Any]]:
        """Run through solutions as numerators with a common denominator.

        What no pivot determines is 0; where something must not be 0, other small numbers are tried.
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
