"""Lattices in a quaternion algebra over a number field K, of full rank over its integers, and ideals of K.

They are rows over ℤ: coordinates of w, x, y, z in the integral basis, for w + x·i + y·j + z·k.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from math import lcm, prod
from typing import Any

from hfield.certificates.language import split
from hfield.certificates.number_fields.classes import coefficients, field_of
from hfield.certificates.number_fields.enumeration import short_vectors
from hfield.certificates.number_fields.ideals import ideal, index
from hfield.certificates.number_fields.integers import Integers, integer_row
from hfield.certificates.number_fields.matrices import (
    Key,
    Rows,
    determinant,
    hermite,
    rational_rows,
    reduced,
    times,
    unit,
)
from hfield.certificates.rejection import a_list, an_integer, an_object, reject
from hfield.certificates.scalars.matrices import inverse_matrix
from hfield.certificates.scalars.names import a_rational
from hfield.certificates.scalars.rationals import root
from hfield.certificates.statement import Setting
from hfield.certificates.work import charge

Row = tuple[int, ...]
MOST = 6
"""The largest degree of the field."""


class Frame:
    """The algebra in coordinates, over ℤ."""

    def __init__(self, setting: Setting, integers: Integers) -> None:
        ring, field = setting.field, integers.field
        assert ring is not None
        if field.degree > MOST or setting.letters:
            reject(
                f"lattices are checked over fields of degree up to {MOST}, with numbers for constants"
            )
        self.ring, self.field, self.integers = ring, field, integers
        self.n, self.size = field.degree, 4 * field.degree
        self._multiply(setting)

    def _multiply(self, setting: Setting) -> None:
        """Make the tables of products, and of tr(x·conj(y)), of the basis over ℤ, each times a number."""
        ring, n, size = self.ring, self.n, self.size
        charge(15 * size**3)
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
        self.scale, whole = rational_rows([row for rows in products for row in rows])
        self.table = [whole[m : m + size] for m in range(0, size**2, size)]
        trace = self.scalar(coefficients(ring, t))
        bar = [
            [Fraction(int(a == b) * (1 if a < n else -1)) for b in range(size)] for a in range(size)
        ]
        for k in range(n):
            for p in range(n):
                bar[n + k][p] = trace[k][p]
        self._bar_den, self._bar = rational_rows(bar)

    def scalar(self, c: Sequence[Fraction]) -> list[list[Fraction]]:
        """Return the matrix of the multiplication by a number of the field, on coordinates."""
        den, row = self.integers.coordinates(c)
        return [[Fraction(x, den) for x in line] for line in self.integers.matrix(row)]

    def lattice(self, text: str) -> "Lattice":
        """Read a lattice of a statement."""
        return Lattice(self, *self.read_rows(text))

    def order(self, text: str) -> "Lattice":
        """Read a lattice that is an order."""
        found = self.lattice(text)
        if not found.holds(1, [unit(self.size, k) for k in range(self.n)]):
            reject("this is no order: an integer of the field is not in it")
        if not found.products_lie_in(found, found):
            reject("this is no order: a product of two rows is not in it")
        return found

    def given(self, value: object, what: str = "an ideal") -> "Lattice":
        """Read a lattice of the evidence."""
        entry = an_object(value, "den rows", what)
        rows = [integer_row(x, self.size) for x in a_list(entry["rows"], "rows")]
        if len(rows) != self.size:
            reject(f"a lattice has {self.size} rows")
        return Lattice(self, an_integer(entry["den"], "a denominator", 1), tuple(rows))

    def read_rows(self, text: str) -> tuple[int, Rows]:
        """Read a basis over ℤ: elements between bars, four numbers of the field each between commas."""
        found = self.elements(text)
        if len(found) != self.size:
            reject(f"a lattice is written as {self.size} elements, a basis over the integers")
        return rational_rows(found)

    def elements(self, text: str) -> list[list[Fraction]]:
        """Read elements between bars."""
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
        return found

    def element(self, value: object) -> tuple[int, Row]:
        """Read an element of the evidence, which is not 0."""
        entry = an_object(value, "den row", "an element")
        den, row = (
            an_integer(entry["den"], "a denominator", 1),
            integer_row(entry["row"], self.size),
        )
        if not any(row):
            reject("an element is 0")
        return den, row

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

    def right(self, x: Sequence[int]) -> list[list[int]]:
        """Return the matrix that takes a row y to y·x, ``scale`` times too large."""
        charge(self.size**3 // 4)
        return [
            [sum(c * row[p] for c, row in zip(x, rows, strict=True) if c) for p in range(self.size)]
            for rows in self.table
        ]

    def conjugate(self, x: Sequence[int]) -> Row:
        """Return the conjugate, times the denominator of the trace of i."""
        return times([x], self._bar)[0]

    @property
    def conjugate_scale(self) -> int:
        """By how much conjugates are too large."""
        return self._bar_den

    @cached_property
    def form(self) -> list[list[list[int]]]:
        """tr(x·conj(y)) of the basis, place by place in the integral one, ``scale·conjugate_scale`` times."""
        bars = [self.conjugate(unit(self.size, m)) for m in range(self.size)]
        lefts = [self.left(unit(self.size, m)) for m in range(self.size)]
        half = [[times([bar], left)[0][: self.n] for bar in bars] for left in lefts]
        return [
            [[half[a][b][k] + half[b][a][k] for b in range(self.size)] for a in range(self.size)]
            for k in range(self.n)
        ]

    @cached_property
    def traces(self) -> list[list[int]]:
        """The traces tr(x·conj(1)) of the basis, place by place, times the same as :attr:`form`."""
        one = self.integers.one
        return [[sum(map(int.__mul__, line, one)) for line in form] for form in self.form]


def a_frame(setting: Setting, basis: object) -> Frame:
    """Read an integral basis of the field."""
    field = field_of(setting)
    rows = [
        [a_rational(c, "a coefficient") for c in a_list(x, "an element")]
        for x in a_list(basis, "the integral basis")
    ]
    if [len(row) for row in rows] != [field.degree] * field.degree:
        reject(f"an integral basis has {field.degree} elements, of as many coefficients")
    return Frame(setting, Integers(field, rows))


class Lattice:
    """Integer rows over a denominator, a basis over ℤ."""

    def __init__(self, base: Frame, den: int, rows: Rows) -> None:
        self.base, self.den, self.rows = base, den, rows
        charge(base.size**3)
        self.key: Key = reduced(den, hermite(rows))

    @cached_property
    def gram(self) -> list[list[list[int]]]:
        """tr(x·conj(y)) of the rows, place by place in the integral basis, ``unit`` times too large."""
        charge(self.base.n * self.base.size**3)
        return [
            times(times(self.rows, form), list(zip(*self.rows, strict=True)))  # type: ignore[misc]
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

    def products_lie_in(self, other: "Lattice", inside: "Lattice") -> bool:
        """Tell whether the products of an element of this lattice and one of the other lie in a third."""
        den = self.den * other.den * self.base.scale
        return all(inside.holds(den, times(other.rows, self.base.left(x))) for x in self.rows)

    def times(self, den: int, x: Row, side: str) -> "Lattice":
        """Return L·x/den for the ``right`` side, x·L/den for the left."""
        by = self.base.right(x) if side == "right" else self.base.left(x)
        return Lattice(self.base, self.den * den * self.base.scale, tuple(times(self.rows, by)))

    @cached_property
    def discriminant(self) -> int:
        """The norm down to ℚ of the reduced discriminant of an order."""
        base = self.base
        weights = [Fraction(base.integers.trace(unit(base.n, k))) for k in range(base.n)]
        d = abs(base.integers.discriminant)
        size = root(Fraction(abs(determinant(self.form(weights))), self.unit**base.size * d**4))
        if size is None or size.denominator != 1 or not size:
            reject("this order has no integral discriminant")
        return size.numerator

    def into(self, other: "Lattice") -> "Lattice":
        """Return {x: L·x ⊆ M}, M being ``other``."""
        base = self.base
        charge(base.size**4 // 4)
        back = inverse_matrix([[Fraction(c) for c in row] for row in other.rows])
        assert back is not None, "a lattice has full rank"
        bottom, whole = rational_rows(back)
        columns: list[Sequence[int]] = []
        for row in self.rows:  # row·x lies in M where x goes to integers
            columns += zip(*times(base.left(row), whole), strict=True)
        dual = inverse_matrix([[Fraction(c) for c in row] for row in hermite(columns)])
        assert dual is not None, "Hermite forms have full rank"
        factor = Fraction(self.den * base.scale * bottom, other.den)
        found = [[c * factor for c in column] for column in zip(*dual, strict=True)]
        return Lattice(base, *rational_rows(found))

    @cached_property
    def norm(self) -> Key:
        """The ideal that the reduced norms generate, by those of sums and their differences."""
        base, unit_, size = self.base, self.unit, range(self.base.size)
        charge(base.n**3 * base.size**2)
        values = [
            [g[a][b] * (2 if a < b else 1) for g in self.gram]
            for a in size
            for b in range(a, base.size)
        ]
        return ideal(base.integers, 2 * unit_, values)

    def form(self, weights: Sequence[Fraction]) -> Rows:
        """Return the matrix of a combination of the forms of :attr:`gram`, without denominators."""
        den = lcm(*(w.denominator for w in weights))
        whole, size = [int(w * den) for w in weights], range(self.base.size)
        charge(self.base.n * self.base.size**2)
        return tuple(
            tuple(sum(w * g[a][b] for w, g in zip(whole, self.gram, strict=True)) for b in size)
            for a in size
        )

    def norm_of(self, x: Row) -> Row:
        """Return the norm of an element, by coordinates in the rows; 2·``unit`` times too large."""
        charge(self.base.n * self.base.size**2)
        return tuple(
            sum(c * sum(map(int.__mul__, x, line)) for c, line in zip(x, g, strict=True))
            for g in self.gram
        )


def need_locally_principal(lattice: Lattice, order: Lattice, side: str) -> None:
    """Reject unless a lattice is an ideal of the order on this side, its index the square of its norm."""
    first, second = (order, lattice) if side == "left" else (lattice, order)
    if not first.products_lie_in(second, lattice):
        reject(f"a lattice is no {side} ideal of the order")
    if lattice.volume != order.volume * index(lattice.norm) ** 2:
        reject("an ideal is not locally principal: its index is not the square of its norm")


def traces(base: Frame, c: Any) -> list[Fraction]:
    """Return Tr(c·w) for the integral basis."""
    return [
        sum((row[m] for m, row in enumerate(base.scalar(base.field.mul(tuple(w), c)))), Fraction(0))
        for w in base.integers.rows
    ]


def of_norm(lattice: Lattice, inverse: Any) -> Iterator[Row]:
    """Yield, by coordinates in the rows, one of ±x for each x of norm ν, totally positive; 1/ν is given.

    Tr(N(x)/ν) is then the degree of the field.
    """
    base, weights = lattice.base, traces(lattice.base, inverse)
    den, part = base.integers.coordinates(inverse)
    one = tuple(c * den * 2 * lattice.unit for c in base.integers.one)
    bound = 2 * lattice.unit * base.n * lcm(*(w.denominator for w in weights))
    for x, value in short_vectors(lattice.form(weights), bound):
        if value == bound and base.integers.mul(lattice.norm_of(x), part) == one:
            yield x


def need_definite(lattice: Lattice) -> None:
    """Reject unless the norm is totally definite, over a totally real field: Tr(N(x)) is positive."""
    any(short_vectors(lattice.form(traces(lattice.base, lattice.base.field.one)), 0))


def need_same(first: Lattice, second: Lattice) -> None:
    """Reject unless two lattices are the same."""
    if first.key != second.key:
        reject("the basis that is given is one of another lattice")
