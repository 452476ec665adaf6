"""The algebra i² = a + t·i, j² = b over ℚ, a number field or GF(q)(t), on integer rows.

A row has the coordinates of w, x, y and z in an integral basis of the field, for w + x·i + y·j + z·k. These
are four integers over ℚ, four times the degree over a number field, and four polynomials over GF(q)(t).
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from fractions import Fraction
from functools import cache, cached_property
from typing import Generic

from hfield.checker.budget import spend
from hfield.checker.evaluate import products
from hfield.checker.number_fields.ideals import Integers
from hfield.checker.number_fields.integers import RingOfIntegers, coefficients
from hfield.checker.number_fields.matrices import (
    N,
    Quotient,
    RowOf,
    RowsOf,
    lcm,
    longest,
    normal,
    ratio,
    times,
)
from hfield.checker.orders.polynomial_integers import PolynomialIntegers
from hfield.checker.rejection import reject
from hfield.checker.scalars.finite_field_polynomials import FiniteFieldPolynomial, RationalFunction
from hfield.checker.scalars.place import E
from hfield.checker.scalars.ring import AnyRing, Ring
from hfield.checker.statement import Setting

MAX_DEGREE = 6


class AlgebraOf(ABC, Generic[N]):
    """Products, conjugates, traces and pairings of rows; each result is multiplied by ``scale``.

    The caller spends the work, according to the ``bits`` of the lattice that contains the rows.
    """

    def __init__(self, setting: Setting, integers: Integers[N]) -> None:
        assert setting.field is not None
        self.integers: Integers[N] = integers
        self.ring: AnyRing = setting.field
        self.n: int = integers.n
        self.size: int = 4 * self.n
        if self.n > MAX_DEGREE or setting.letters:
            reject(
                f"lattices are checked over fields of degree up to {MAX_DEGREE}, with numbers for constants"
            )
        entries = self._entries(setting)
        bits = sum(den.bit_length() + longest([row]) for den, row in entries[:3])
        spend((1_000 + bits * bits // 2_500) * self.n**3)
        self.scale: N = lcm(*(den for den, _ in entries))
        one = _multiple(integers.one, self.scale)
        a, t, b, ab, tb = (_multiple(row, self.scale // den) for den, row in entries)
        self.products: list[list[list[tuple[int, RowOf[N]]]]] = products(
            one, a, t, b, ab, tb, lambda row: _multiple(row, -1)
        )
        """For each pair of 1, i, j, k, the indices of the coordinates in their product and their values."""
        four = _multiple(a, 4 * self.scale)
        square = integers.mul(t, t)
        self.signs: tuple[RowOf[N], RowOf[N]] = (
            tuple(x + y for x, y in zip(square, four, strict=True)),
            b,
        )
        """Positive multiples of t² + 4a and b: where both are negative the algebra is definite."""
        self.trace_of_i: RowOf[N] = t
        zero, two = (integers.zero,) * self.n, _multiple(one, 2)
        self.pairings: list[list[RowOf[N]]] = [
            [two, t, zero, zero],
            [t, _multiple(a, -2), zero, zero],
            [zero, zero, _multiple(b, -2), _multiple(tb, -1)],
            [zero, zero, _multiple(tb, -1), _multiple(ab, 2)],
        ]
        """The numbers tr(x·conj(y)), from N = n(w, x) − b·n(y, z), n(u, v) = u² + t·uv − a·v²."""
        self._tabulate()
        self.bits: int = longest([*(row for form in self.forms for row in form), *self._left])
        size = integers.norm(integers.mul(*self.signs))
        if not size:
            reject("the algebra is degenerate: (t² + 4a)·b is 0")
        self.volume: Quotient[N] = ratio(normal(size), self.scale ** (3 * self.n))
        """The norm of (t² + 4a)·b down to ℚ, without its sign; over functions (t² + 4a)·b, made monic."""
        rows = (one, _multiple(a, -1), _multiple(b, -1), ab)
        self.norms_of_basis: RowOf[N] = tuple(row[0] for row in rows)

    @abstractmethod
    def _entries(self, setting: Setting) -> list[tuple[N, RowOf[N]]]:
        """Return a, t, b, ab and tb, as rows of integers over denominators."""

    @cached_property
    def basis(self) -> list[RowOf[N]]:
        """The integral basis as rows."""
        zero, one, n = self.integers.zero, self.integers.zero + 1, self.n
        return [self.number([one if k == m else zero for m in range(n)]) for k in range(n)]

    def _tabulate(self) -> None:
        """Compute the matrices over ℤ of the products, of each coordinate of tr(x·conj(y)), of conj
        and tr.
        """
        n, size = self.n, self.size
        zero, one = self.integers.zero, self.integers.zero + 1
        left = [[zero] * size**2 for _ in range(size)]
        right = [[zero] * size**2 for _ in range(size)]
        forms = [[[zero] * size for _ in range(size)] for _ in range(n)]
        on_basis = cache(self._on_basis)
        for u in range(4):
            for v in range(4):
                for place, number in self.products[u][v]:
                    for k, m, row in on_basis(number):
                        x, y, at = u * n + k, v * n + m, place * n
                        left[x][y * size + at : y * size + at + n] = row
                        right[y][x * size + at : x * size + at + n] = row
                for k, m, row in on_basis(self.pairings[u][v]):
                    for form, c in zip(forms, row, strict=True):
                        form[u * n + k][v * n + m] = c
        self._left: RowsOf[N] = tuple(map(tuple, left))
        self._right: RowsOf[N] = tuple(map(tuple, right))
        self.forms: list[RowsOf[N]] = [tuple(map(tuple, form)) for form in forms]
        """The matrices of tr(x·conj(y)), one for each place in the integral basis."""
        bar = [[zero] * size for _ in range(size)]
        for m in range(size):
            bar[m][m] = self.scale * (1 if m < n else -1)
        of_i = self.integers.matrix(self.trace_of_i)
        for k, trace in enumerate(of_i, n):
            bar[k][:n] = trace
        self._bar: RowsOf[N] = tuple(map(tuple, bar))
        two = one * 2 * self.scale
        twice = [tuple(two if k == m else zero for k in range(n)) for m in range(n)]
        self._trace: RowsOf[N] = tuple(twice + of_i + [(zero,) * n] * (2 * n))

    def _on_basis(self, c: RowOf[N]) -> list[tuple[int, int, RowOf[N]]]:
        """Return the positions of each pair of elements of the integral basis, and their product with a
        number.
        """
        if not any(c):
            return []
        by = self.integers.matrix(c)
        table = (times(rows, by) for rows in self.integers.table)
        return [(k, m, row) for k, rows in enumerate(table) for m, row in enumerate(rows)]

    def left(self, x: Sequence[N]) -> RowsOf[N]:
        """Return the matrix that maps a row y to x·y."""
        return self._parted(times([x], self._left)[0])

    def right(self, y: Sequence[N]) -> RowsOf[N]:
        """Return the matrix that maps a row x to x·y."""
        return self._parted(times([y], self._right)[0])

    def _parted(self, row: RowOf[N]) -> RowsOf[N]:
        size = self.size
        return tuple([row[m : m + size] for m in range(0, size * size, size)])

    def conjugate(self, x: Sequence[N]) -> RowOf[N]:
        """Return the conjugate of a row."""
        return times([x], self._bar)[0]

    def trace(self, x: Sequence[N]) -> RowOf[N]:
        """Return the trace of a row, in the integral basis."""
        return times([x], self._trace)[0]

    def pairing(self, x: Sequence[N], y: Sequence[N]) -> RowOf[N]:
        """Return tr(x·conj(y)), in the integral basis."""
        images = (times([x], form)[0] for form in self.forms)
        zero = self.integers.zero
        return tuple(sum((c * d for c, d in zip(image, y, strict=True)), zero) for image in images)

    def blockwise(self, x: Sequence[N], matrix: Sequence[Sequence[N]]) -> RowOf[N]:
        """Return a row with each of its four numbers multiplied by a matrix."""
        n = self.n
        blocks = times([x[m : m + n] for m in range(0, self.size, n)], matrix)
        return tuple(c for block in blocks for c in block)

    def number(self, x: Sequence[N]) -> RowOf[N]:
        """Return an integer of the field as a row."""
        return tuple(x) + (self.integers.zero,) * (3 * self.n)


class Algebra(AlgebraOf[int]):
    """An algebra over ℚ or a number field."""

    integers: RingOfIntegers
    volume: Fraction

    def _entries(self, setting: Setting) -> list[tuple[int, RowOf[int]]]:
        ring, integers = self.ring, self.integers
        return [integers.coordinates(coefficients(ring, x)) for x in _structure(ring, setting)]


class PolynomialAlgebra(AlgebraOf[FiniteFieldPolynomial]):
    """An algebra over GF(q)(t)."""

    integers: PolynomialIntegers
    volume: RationalFunction

    def _entries(
        self, setting: Setting
    ) -> list[tuple[FiniteFieldPolynomial, RowOf[FiniteFieldPolynomial]]]:
        integers = self.integers
        return [integers.coordinates([x]) for x in _structure(integers.functions, setting)]

    def norm(self, x: Sequence[FiniteFieldPolynomial]) -> FiniteFieldPolynomial:
        """Return the norm of a row; it is not the half of a trace where 2 = 0."""
        squares = (c * y * y for c, y in zip(self.norms_of_basis, x, strict=True))
        mixed = self.trace_of_i[0] * x[0] * x[1] + self.pairings[2][3][0] * x[2] * x[3]
        return sum(squares, self.integers.zero) + mixed


def _structure(ring: Ring[E], setting: Setting) -> list[E]:
    """Return a, t, b, ab and tb."""
    a, t, b = (ring.value(tree, "a structure constant") for tree in setting.constants)
    return [a, t, b, ring.mul(a, b), ring.mul(t, b)]


def _multiple(row: Sequence[N], c: N | int) -> RowOf[N]:
    return tuple(c * x for x in row)
