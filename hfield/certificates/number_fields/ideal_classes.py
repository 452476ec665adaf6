"""``ideal-classes{O; h}``: the right ideal classes of an order over ℤ_K in a totally definite algebra.

As over ℤ: with an ideal I go the lattices x⁻¹·I, for the x in I with the least Tr(N(x)/ν), where ν generates
the norm of I and is totally positive. The narrow class number of K has to be 1, so that there is such a ν,
but for squares of units, which do not matter (docs/trust.md).
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from math import lcm, prod
from typing import Any

from hfield.certificates.finding import Finding
from hfield.certificates.glossary import BY_MASS, FIELD, MASS_OVER_FIELDS, SIEGEL
from hfield.certificates.language import split
from hfield.certificates.number_fields.classes import SUnits, coefficients, field_of
from hfield.certificates.number_fields.integers import (
    Factors,
    Prime,
    determinant,
    integer_row,
    unit,
)
from hfield.certificates.number_fields.modular import echelon, remainder
from hfield.certificates.number_fields.zeta import zeta_minus_one
from hfield.certificates.orders.algebra import Rows
from hfield.certificates.orders.enumeration import short_vectors
from hfield.certificates.orders.lattice import Key, hermite, reduced
from hfield.certificates.orders.local_types import factored
from hfield.certificates.rejection import a_list, an_integer, an_object, reject
from hfield.certificates.scalars.matrices import inverse_matrix
from hfield.certificates.scalars.rationals import root
from hfield.certificates.statement import Setting
from hfield.certificates.work import charge

Row = tuple[int, ...]
MOST = 4
"""The largest degree of the field."""


def ideal_classes(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> Finding:
    """The order has so many classes of locally principal right ideals."""
    if verdict != "proved":
        reject(f"a set of classes does not show that this is {verdict}")
    data = an_object(evidence, "kind units fundamental primes classes", "the evidence")
    if data["kind"] != "ideal-classes":
        reject("what shows a number of classes is evidence of the kind 'ideal-classes'")
    base = _Base(setting, data)
    order = _Lattice(base, *base.read_rows(parts[0]))
    classes = a_list(data["classes"], "classes", 1)
    if len(classes) != int(parts[1]):
        reject(f"{len(classes)} classes are given, which is not the number that is stated")
    _need_order(order)
    seen: dict[Key, int] = {}
    total = Fraction(0)
    for number, value in enumerate(classes):
        entry = an_object(value, "den rows norm", "an ideal")
        rows = [integer_row(x, base.size) for x in a_list(entry["rows"], "rows")]
        if len(rows) != base.size:
            reject(f"a lattice has {base.size} rows")
        ideal = _Lattice(base, an_integer(entry["den"], "a denominator", 1), tuple(rows))
        keys, units = _keys(order, ideal, base.units.given(entry["norm"]))
        for key in keys:
            if seen.setdefault(key, number) != number:
                reject(f"the ideals {seen[key]} and {number} are in one class")
        total += Fraction(1, units)
    if total != _mass(order):
        reject("these classes do not have the mass of all classes")
    return Finding(FIELD, BY_MASS).citing(*base.units.cites, SIEGEL, MASS_OVER_FIELDS)


class _Base:
    """The algebra in coordinates: those of w, x, y, z in the integral basis, for w + x·i + y·j + z·k."""

    def __init__(self, setting: Setting, data: Any) -> None:
        ring, field = setting.field, field_of(setting)
        assert ring is not None
        if field.degree > MOST or setting.letters:
            reject(
                f"ideal classes are checked over fields of degree up to {MOST}, with numbers for constants"
            )
        self.ring, self.field, self.n, self.size = ring, field, field.degree, 4 * field.degree
        self.units = SUnits(field, data["units"])
        self.integers = self.units.integers
        self.factors = Factors(self.integers, data["primes"])
        given = [self.units.given(x) for x in a_list(data["fundamental"], "fundamental units")]
        self.units.need_fundamental(given)
        if self.units.places.complex or prod(self.units.invariants) > 1:
            reject("this is checked over totally real fields of class number 1")
        signs = [[int(s == -1) for s in field.signs(x)] for x in [self.number(-1), *given]]
        if len(echelon(signs, 2)) < self.n:
            reject("this is checked over fields of narrow class number 1: units of all signs")
        self._multiply(setting)

    def number(self, c: int) -> Any:
        return self.field.number(c)

    def _multiply(self, setting: Setting) -> None:
        """Make the tables of products, and of tr(x·conj(y)), of the basis over ℤ, each times a number."""
        ring, n, size = self.ring, self.n, self.size
        a, t, b = (ring.value(tree, "a structure constant") for tree in setting.constants)
        one, minus = ring.one, ring.neg(ring.one)
        ab, tb = ring.mul(a, b), ring.mul(t, b)
        lines = {(0, m): [(m, one)] for m in range(4)} | {(m, 0): [(m, one)] for m in range(4)}
        lines |= {
            (1, 1): [(0, a), (1, t)], (1, 2): [(3, one)], (1, 3): [(2, a), (3, t)],
            (2, 1): [(2, t), (3, minus)], (2, 2): [(0, b)], (2, 3): [(0, tb), (1, ring.neg(b))],
            (3, 1): [(2, ring.neg(a))], (3, 2): [(1, b)], (3, 3): [(0, ring.neg(ab))],
        }  # fmt: skip
        products = [[[Fraction(0)] * size for _ in range(size)] for _ in range(size)]
        for (u, v), terms in lines.items():
            for place, c in terms:
                by = self.scalar(coefficients(ring, c))
                for k in range(n):
                    for m in range(n):
                        row = self.integers.table[k][m]
                        for p in range(n):
                            products[u * n + k][v * n + m][place * n + p] += sum(
                                row[q] * by[q][p] for q in range(n)
                            )
        self.scale = lcm(*(c.denominator for rows in products for row in rows for c in row))
        self.table: list[list[Row]] = [
            [tuple(int(c * self.scale) for c in row) for row in rows] for rows in products
        ]
        trace = self.scalar(coefficients(ring, t))
        bar = [
            [Fraction(int(a == b) * (1 if a < n else -1)) for b in range(size)] for a in range(size)
        ]
        for k in range(n):
            for p in range(n):
                bar[n + k][p] = trace[k][p]
        self._bar_den = lcm(*(c.denominator for row in bar for c in row))
        self._bar = [[int(c * self._bar_den) for c in row] for row in bar]

    def scalar(self, c: Sequence[Fraction]) -> list[list[Fraction]]:
        """Return the matrix of the multiplication by a number of the field, on coordinates."""
        den, row = self.integers.coordinates(c)
        return [[Fraction(x, den) for x in line] for line in self.integers.matrix(row)]

    def read_rows(self, text: str) -> tuple[int, Rows]:
        """Read a basis over ℤ: elements between bars, four numbers of the field each between commas."""
        found = []
        for entry in split(text, "|"):
            values = split(entry, ",")
            if len(values) != 4:
                reject("an element is written as four numbers")
            row: list[Fraction] = []
            for value in values:
                den, own = self.integers.coordinates(
                    coefficients(self.ring, self.ring.read(value.strip()))
                )
                row += [Fraction(c, den) for c in own]
            found.append(row)
        if len(found) != self.size:
            reject(f"an order is written as {self.size} elements, a basis over the integers")
        den = lcm(*(c.denominator for row in found for c in row))
        return den, tuple(tuple(int(c * den) for c in row) for row in found)

    def left(self, x: Sequence[int]) -> list[list[int]]:
        """Return the matrix that takes a row y to x·y, ``scale`` times too large."""
        charge(self.size**3 // 4)
        return [
            [
                sum(c * rows[m][p] for c, rows in zip(x, self.table, strict=True) if c)
                for p in range(self.size)
            ]
            for m in range(self.size)
        ]

    def conjugate(self, x: Sequence[int]) -> Row:
        """Return the conjugate, times the denominator of the trace of i."""
        return _times([x], self._bar)[0]

    @property
    def conjugate_scale(self) -> int:
        """By how much conjugates are too large."""
        return self._bar_den

    @cached_property
    def form(self) -> list[list[list[int]]]:
        """tr(x·conj(y)) of the basis, place by place in the integral one, ``scale·conjugate_scale`` times."""
        bars = [self.conjugate(unit(self.size, m)) for m in range(self.size)]
        lefts = [self.left(unit(self.size, m)) for m in range(self.size)]
        half = [[_times([bar], left)[0][: self.n] for bar in bars] for left in lefts]
        return [
            [[half[a][b][k] + half[b][a][k] for b in range(self.size)] for a in range(self.size)]
            for k in range(self.n)
        ]

    @cached_property
    def traces(self) -> list[list[int]]:
        """The traces tr(x·conj(1)) of the basis, place by place, times the same as :attr:`form`."""
        one = self.integers.one
        return [[sum(map(int.__mul__, line, one)) for line in form] for form in self.form]


class _Lattice:
    """Integer rows over a denominator, a basis over ℤ."""

    def __init__(self, base: _Base, den: int, rows: Rows) -> None:
        self.base, self.den, self.rows = base, den, rows
        charge(base.size**3)
        self.key: Key = reduced(den, hermite(rows))

    @cached_property
    def gram(self) -> list[list[list[int]]]:
        """tr(x·conj(y)) of the rows, place by place in the integral basis, ``unit`` times too large."""
        charge(self.base.n * self.base.size**3)
        return [
            _times(_times(self.rows, form), list(zip(*self.rows, strict=True)))  # type: ignore[misc]
            for form in self.base.form
        ]

    @property
    def unit(self) -> int:
        """By how much :attr:`gram` is too large."""
        return self.base.scale * self.base.conjugate_scale * self.den * self.den

    @property
    def volume(self) -> Fraction:
        """The determinant of the rows, without its sign."""
        den, rows = self.key
        return Fraction(prod(row[n] for n, row in enumerate(rows)), den**self.base.size)

    def holds(self, den: int, rows: Sequence[Sequence[int]]) -> bool:
        """Tell whether rows over a denominator lie in the lattice."""
        own, h = self.key
        charge(len(rows) * self.base.size**2 // 4)
        for row in rows:
            rest = [x * own for x in row]
            if any(x % den for x in rest):
                return False
            rest = [x // den for x in rest]
            for n, pivot in enumerate(h):
                c, r = divmod(rest[n], pivot[n])
                if r:
                    return False
                if c:
                    rest = [x - c * y for x, y in zip(rest, pivot, strict=True)]
        return True

    def times_lies_in_itself(self, order: "_Lattice") -> bool:
        """Tell whether L·O lies in L."""
        den = self.den * order.den * self.base.scale
        return all(self.holds(den, _times(order.rows, self.base.left(x))) for x in self.rows)


def _times(rows: Sequence[Sequence[int]], matrix: Sequence[Sequence[int]]) -> list[Row]:
    columns = list(zip(*matrix, strict=True))
    charge(len(rows) * len(columns) * len(matrix) // 8)
    return [tuple(sum(map(int.__mul__, row, column)) for column in columns) for row in rows]


def _need_order(order: _Lattice) -> None:
    base = order.base
    if not order.holds(1, [unit(base.size, k) for k in range(base.n)]):
        reject("this is no order: an integer of the field is not in it")
    if not order.times_lies_in_itself(order):
        reject("this is no order: a product of two rows is not in it")


def _keys(order: _Lattice, ideal: _Lattice, nu: Any) -> tuple[set[Key], int]:
    """Return the x⁻¹·I, and the index of the units of the field in those of the left order of I."""
    base = order.base
    if not ideal.times_lies_in_itself(order):
        reject("a lattice is no right ideal of the order")
    if any(s != 1 for s in base.field.signs(nu)):
        reject("the norm of an ideal is given by a totally positive number")
    inverse = base.field.inverse(nu)
    assert inverse is not None, "a number with signs is not 0"
    _need_norm(order, ideal, inverse)
    weights = [sum(row[m] for m, row in enumerate(base.scalar(w))) for w in _traced(base, inverse)]
    den = lcm(*(w.denominator for w in weights))
    whole = [int(w * den) for w in weights]
    size = range(base.size)
    gram = tuple(
        tuple(sum(w * g[a][b] for w, g in zip(whole, ideal.gram, strict=True)) for b in size)
        for a in size
    )
    bound = min(gram[a][a] for a in size)
    found: list[Row] = []
    for x, value in short_vectors(gram, bound):
        if value < bound:
            found, bound = [], value
        if value == bound:
            found.append(x)
    counts: dict[tuple[Key, Row], int] = {}
    for x in found:
        norm = tuple(
            _times([_times([x], g)[0]], [[c] for c in x])[0][0] for g in ideal.gram
        )  # 2·N(x)·unit
        key = _divided(ideal, _times([x], ideal.rows)[0], norm)
        counts[key, norm] = counts.get((key, norm), 0) + 1
    return {key for key, _ in counts}, next(iter(counts.values()))


def _traced(base: _Base, c: Any) -> list[Any]:
    """Return the products of a number with the integral basis."""
    return [base.field.mul(tuple(w), c) for w in base.integers.rows]


def _need_norm(order: _Lattice, ideal: _Lattice, inverse: Any) -> None:
    """Reject unless ν generates the ideal of norms, and the ideal is locally principal."""
    base = order.base
    by = base.scalar(inverse)
    values = []
    for a in range(base.size):
        for b in range(a, base.size):
            row = [g[a][b] for g in ideal.gram]
            half = 2 if a == b else 1
            values.append(
                [
                    sum((c * by[q][p] for q, c in enumerate(row)), Fraction(0))
                    / (half * ideal.unit)
                    for p in range(base.n)
                ]
            )
    if any(c.denominator != 1 for row in values for c in row):
        reject("the norm of an element is no multiple of the norm of its ideal")
    span = [
        base.integers.mul(unit(base.n, k), tuple(map(int, row)))
        for row in values
        for k in range(base.n)
    ]
    form = hermite([row for row in span if any(row)])
    if any(row[n] != 1 for n, row in enumerate(form)):
        reject("the norm of an ideal is smaller")
    size = abs(determinant_of(base.scalar(inverse)))
    if ideal.volume * size**2 != order.volume:
        reject("an ideal is not locally principal: its index is not the square of its norm")


def determinant_of(rows: list[list[Fraction]]) -> Fraction:
    """Return the determinant of rational rows."""
    den = lcm(*(c.denominator for row in rows for c in row))
    return Fraction(determinant([[int(c * den) for c in row] for row in rows]), den ** len(rows))


def _divided(ideal: _Lattice, x: Row, size: Row) -> Key:
    """Return x⁻¹·I = N(x)⁻¹·conj(x)·I; size is 2·N(x) in the integral basis, ``unit`` times too large."""
    base = ideal.base
    matrix = [[Fraction(c, 2 * ideal.unit) for c in line] for line in base.integers.matrix(size)]
    inverse = inverse_matrix(matrix)
    if inverse is None:
        reject("an element of norm 0 is not divided by")
    den = lcm(*(c.denominator for row in inverse for c in row))
    block = [[int(c * den) for c in row] for row in inverse]
    rows = _times(ideal.rows, base.left(base.conjugate(x)))
    n = base.n
    divided = [
        tuple(c for k in range(4) for c in _times([row[k * n : (k + 1) * n]], block)[0])
        for row in rows
    ]
    whole = base.scale * base.conjugate_scale * ideal.den * ideal.den * den
    charge(base.size**3)
    return reduced(whole, hermite(divided))


def _mass(order: _Lattice) -> Fraction:
    """Return the mass of all classes, by ζ_K(−1) and Eichler symbols; both formulas are cited."""
    base = order.base
    d = abs(base.integers.discriminant)
    traces = [base.integers.trace(unit(base.n, k)) for k in range(base.n)]
    form = [
        [
            sum(t * g[a][b] for t, g in zip(traces, order.gram, strict=True))
            for b in range(base.size)
        ]
        for a in range(base.size)
    ]
    square = Fraction(abs(determinant(form)), order.unit**base.size * d**4)
    size = root(square)
    if size is None or size.denominator != 1 or not size:
        reject("this order has no integral discriminant")
    found: Fraction = abs(zeta_minus_one(base.integers, base.factors)) / 2 ** (base.n - 1) * size
    for p in factored(size.numerator):
        if p not in base.factors.above:
            reject(f"the prime ideals above {p} are missing")
        for k in base.factors.above[p]:
            P = base.factors.primes[k]
            if _divides(order, P):
                symbol = _eichler_symbol(order, P)
                found *= 1 - Fraction(1, P.norm**2) if symbol == 0 else 1 + Fraction(symbol, P.norm)
    return found


def _entry(order: _Lattice, a: int, b: int) -> Row:
    """Return tr(x·conj(y)) of two rows of an order, an integer of the field."""
    return tuple(g[a][b] // order.unit for g in order.gram)


def _divides(order: _Lattice, P: Prime) -> bool:
    """Tell whether a prime divides the discriminant: the trace form is degenerate there."""
    size = range(order.base.size)
    rows = [[c for b in size for c in remainder(_entry(order, a, b), P.span, P.p)] for a in size]
    return len(echelon(rows, P.p)) < 4 * P.degree


def _eichler_symbol(order: _Lattice, P: Prime) -> int:
    """Return the Eichler symbol: that of the polynomial of some basis element with two roots, or 0."""
    base, p, q = order.base, P.p, P.norm
    integers = base.integers
    den = base.scale * base.conjugate_scale * order.den
    for a, row in enumerate(order.rows):
        trace = tuple(
            sum(c * t for c, t in zip(row, traces, strict=True)) // den for traces in base.traces
        )
        norm = tuple(c // 2 for c in _entry(order, a, a))

        def power(x: Row, e: int) -> list[int]:
            return remainder(integers.power_modulo(x, e, p), P.span, p)

        one_row = remainder(integers.one, P.span, p)
        if p > 2:
            square = integers.mul(trace, trace)
            delta = tuple(s - 4 * c for s, c in zip(square, norm, strict=True))
            found = power(delta, (q - 1) // 2)
            if any(found):
                return 1 if found == one_row else -1
        elif any(remainder(trace, P.span, p)):
            below = integers.power_modulo(trace, 2 * (q - 2) if q > 2 else 1, p)
            term = integers.mul(norm, below)
            total = [0] * base.n
            for e in range(P.degree):
                total = [
                    s + c for s, c in zip(total, integers.power_modulo(term, 2**e, p), strict=True)
                ]
            return -1 if any(remainder(total, P.span, p)) else 1
    return 0


FORMS = {"ideal-classes": "[^;]+;[1-9][0-9]{0,4}"}
CHECKS = {"ideal-classes": ideal_classes}
