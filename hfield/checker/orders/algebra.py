"""The algebra i² = a + t·i, j² = b over ℚ, a number field or GF(q)(t), on rows of integers.

A row holds the coordinates of w, x, y and z in an integral basis of the field, for w + x·i + y·j + z·k: four
integers over ℚ, four times the degree over a number field, and four polynomials over GF(q)(t).
"""

from collections.abc import Sequence
from functools import cache
from typing import Any

from hfield.checker.budget import spend
from hfield.checker.evaluate import products
from hfield.checker.number_fields.integers import RingOfIntegers, coefficients
from hfield.checker.number_fields.matrices import (
    Row,
    Rows,
    lcm,
    longest,
    normal,
    ratio,
    times,
    unit,
)
from hfield.checker.rejection import reject
from hfield.checker.statement import Setting

MAX_DEGREE = 6


class Algebra:
    """Products, conjugates, traces and pairings of rows; each result is multiplied by ``scale``.

    The caller spends the work, by the ``bits`` of the lattice that contains the rows.
    """

    def __init__(self, setting: Setting, integers: RingOfIntegers) -> None:
        ring = setting.field
        assert ring is not None
        self.integers, self.ring = integers, ring
        self.n, self.size = integers.n, 4 * integers.n
        if self.n > MAX_DEGREE or setting.letters:
            reject(
                f"lattices are checked over fields of degree up to {MAX_DEGREE}, with numbers for constants"
            )
        a, t, b = (ring.value(tree, "a structure constant") for tree in setting.constants)
        entries = [self._coordinates(x) for x in (a, t, b, ring.mul(a, b), ring.mul(t, b))]
        bits = sum(den.bit_length() + longest([row]) for den, row in entries[:3])
        spend((1_000 + bits * bits // 2_500) * self.n**3)
        self.scale = lcm(*(den for den, _ in entries))
        one = _multiple(integers.one, self.scale)
        a, t, b, ab, tb = (_multiple(row, self.scale // den) for den, row in entries)
        self.products = products(one, a, t, b, ab, tb, lambda row: _multiple(row, -1))
        """For each pair of 1, i, j, k, the indices of the coordinates in their product and their values."""
        four = _multiple(a, 4 * self.scale)
        self.signs = tuple(map(sum, zip(integers.mul(t, t), four, strict=True))), b
        """Positive multiples of t² + 4a and b: where both are negative the algebra is definite."""
        self.trace_of_i = t
        zero, two = (0,) * self.n, _multiple(one, 2)
        self.pairings: list[list[Row]] = [
            [two, t, zero, zero],
            [t, _multiple(a, -2), zero, zero],
            [zero, zero, _multiple(b, -2), _multiple(tb, -1)],
            [zero, zero, _multiple(tb, -1), _multiple(ab, 2)],
        ]
        """The numbers tr(x·conj(y)), from N = n(w, x) − b·n(y, z), n(u, v) = u² + t·uv − a·v²."""
        self._tabulate()
        self.bits = longest([*(row for form in self.forms for row in form), *self._left])
        size = integers.norm(integers.mul(*self.signs))
        if not size:
            reject("the algebra is degenerate: (t² + 4a)·b is 0")
        self.volume = ratio(normal(size), self.scale ** (3 * self.n))
        """The norm of (t² + 4a)·b down to ℚ, without its sign; over functions (t² + 4a)·b, made monic."""
        self.norms_of_basis = tuple(
            row[0] for row in (one, *(_multiple(x, -1) for x in (a, b)), ab)
        )

    def _coordinates(self, x: Any) -> tuple[int, Row]:
        return self.integers.coordinates(coefficients(self.ring, x))

    def _tabulate(self) -> None:
        """Make the matrices over ℤ: of the products, of tr(x·conj(y)) place by place, of conj and tr."""
        n, size = self.n, self.size
        left = [[0] * size**2 for _ in range(size)]
        right = [[0] * size**2 for _ in range(size)]
        forms = [[[0] * size for _ in range(size)] for _ in range(n)]
        on_basis = cache(self._on_basis)
        for u in range(4):
            for v in range(4):
                for place, c in self.products[u][v]:
                    for k, m, row in on_basis(c):
                        x, y, at = u * n + k, v * n + m, place * n
                        left[x][y * size + at : y * size + at + n] = row
                        right[y][x * size + at : x * size + at + n] = row
                for k, m, row in on_basis(self.pairings[u][v]):
                    for form, c in zip(forms, row, strict=True):
                        form[u * n + k][v * n + m] = c
        self._left, self._right = tuple(map(tuple, left)), tuple(map(tuple, right))
        self.forms: list[Rows] = [tuple(map(tuple, form)) for form in forms]
        """The matrices of tr(x·conj(y)), one for each place in the integral basis."""
        signs = [1 if m < n else -1 for m in range(size)]
        bar: list[list[int]] = [[*unit(size, m, self.scale * s)] for m, s in enumerate(signs)]
        of_i = self.integers.matrix(self.trace_of_i)
        for k, trace in enumerate(of_i, n):
            bar[k][:n] = trace
        self._bar = tuple(map(tuple, bar))
        twice = [unit(n, m, 2 * self.scale) for m in range(n)]
        self._trace: Rows = (*twice, *of_i, *[(0,) * n] * (2 * n))

    def _on_basis(self, c: Row) -> list[tuple[int, int, Row]]:
        """Return the places of each two elements of the integral basis, and their product with a number."""
        if not any(c):
            return []
        by = self.integers.matrix(c)
        table = (times(rows, by) for rows in self.integers.table)
        return [(k, m, row) for k, rows in enumerate(table) for m, row in enumerate(rows)]

    def left(self, x: Sequence[int]) -> Rows:
        """Return the matrix that maps a row y to x·y."""
        return self._parted(times([x], self._left)[0])

    def right(self, y: Sequence[int]) -> Rows:
        """Return the matrix that takes a row x to x·y."""
        return self._parted(times([y], self._right)[0])

    def _parted(self, row: Row) -> Rows:
        size = self.size
        return tuple([row[m : m + size] for m in range(0, size * size, size)])

    def conjugate(self, x: Sequence[int]) -> Row:
        """Return the conjugate of a row."""
        return times([x], self._bar)[0]

    def trace(self, x: Sequence[int]) -> Row:
        """Return the trace of a row, in the integral basis."""
        return times([x], self._trace)[0]

    def norm(self, x: Sequence[Any]) -> Any:
        """Return the norm of a row, in degree 1; it is not the half of a trace where 2 = 0."""
        squares = sum(c * y * y for c, y in zip(self.norms_of_basis, x, strict=True))
        return squares + self.trace_of_i[0] * x[0] * x[1] + self.pairings[2][3][0] * x[2] * x[3]

    def pairing(self, x: Sequence[int], y: Sequence[int]) -> Row:
        """Return tr(x·conj(y)), in the integral basis."""
        images = (times([x], form)[0] for form in self.forms)
        return tuple(sum(c * d for c, d in zip(image, y, strict=True)) for image in images)

    def blockwise(self, x: Sequence[int], matrix: Sequence[Sequence[int]]) -> Row:
        """Return a row of which each of the four numbers is multiplied by a matrix."""
        n = self.n
        blocks = times([x[m : m + n] for m in range(0, self.size, n)], matrix)
        return tuple(c for block in blocks for c in block)

    def number(self, x: Sequence[int]) -> Row:
        """Return an integer of the field as a row."""
        return (*x, *(0,) * (3 * self.n))


def _multiple(row: Sequence[int], c: int) -> Row:
    return tuple(c * x for x in row)
