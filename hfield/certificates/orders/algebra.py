"""The algebra i² = a + t·i, j² = b over ℚ, on rows of four integers over a denominator."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import lcm

from hfield.certificates.evaluate import Evaluator, RingScalars
from hfield.certificates.rejection import reject
from hfield.certificates.statement import Setting
from hfield.certificates.work import charge

Row = tuple[int, ...]
Rows = tuple[Row, ...]


class Algebra:
    """Products, conjugates and norms of integer rows; all of them come ``scale`` times too large.

    Who calls them pays, by the ``bits`` of the lattice that the rows are from.
    """

    def __init__(self, setting: Setting) -> None:
        ring = setting.field
        if ring is None or ring.name != "QQ" or setting.letters:
            reject("lattices are checked in an algebra over QQ alone, with numbers for constants")
        evaluator = Evaluator(RingScalars(ring), setting.constants, {})
        if evaluator.conditions:
            reject("the structure constants are not defined")
        a, t, b = map(Fraction, evaluator.constants)
        bits = sum(n.bit_length() for x in (a, t, b) for n in (x.numerator, x.denominator))
        charge(1_000 + bits * bits // 2_500)
        self.scale = s = lcm(*(x.denominator for x in (a, t, b, a * b, t * b)))
        table = [[[Fraction(0)] * 4 for _ in range(4)] for _ in range(4)]
        for m, products in enumerate(evaluator.table):
            for n, terms in enumerate(products):
                for place, c in terms:
                    table[m][n][place] += c
        self._table = [[_whole(row, s) for row in rows] for rows in table]
        form: list[list[int | Fraction]] = [
            [2, t, 0, 0],
            [t, -2 * a, 0, 0],
            [0, 0, -2 * b, -t * b],
            [0, 0, -t * b, 2 * a * b],
        ]
        self.form: Rows = tuple(_whole(row, s) for row in form)
        """The matrix of tr(x·conj(y)), from N = n(w, x) − b·n(y, z), n(u, v) = u² + t·uv − a·v²."""
        bar: list[list[int | Fraction]] = [
            [1, 0, 0, 0],
            [t, -1, 0, 0],
            [0, 0, -1, 0],
            [0, 0, 0, -1],
        ]
        self._bar: Rows = tuple(_whole(row, s) for row in bar)
        self.bits = longest([*self.form, *(row for rows in self._table for row in rows)])
        if not (t * t + 4 * a) * b:
            reject("the algebra is degenerate: (t² + 4a)·b is 0")

    def left(self, x: Sequence[int]) -> Rows:
        """Return the matrix that takes a row y to x·y."""
        return tuple(
            tuple(sum(u * self._table[m][n][p] for m, u in enumerate(x)) for p in range(4))
            for n in range(4)
        )

    def right(self, y: Sequence[int]) -> Rows:
        """Return the matrix that takes a row x to x·y."""
        return tuple(
            tuple(sum(v * self._table[m][n][p] for n, v in enumerate(y)) for p in range(4))
            for m in range(4)
        )

    def conjugate(self, x: Sequence[int]) -> Row:
        """Return the conjugate of a row."""
        return times([x], self._bar)[0]


def longest(rows: Iterable[Sequence[int]]) -> int:
    """Return how many bits the longest number has."""
    return max([n.bit_length() for row in rows for n in row], default=0)


def _whole(row: Iterable[int | Fraction], s: int) -> Row:
    return tuple(int(x * s) for x in row)


def times(rows: Iterable[Sequence[int]], matrix: Rows) -> list[Row]:
    """Return the products of rows of length 4 with a matrix."""
    (a, b, c, d) = matrix
    return [
        tuple(w * p + x * q + y * r + z * s for p, q, r, s in zip(a, b, c, d, strict=True))
        for w, x, y, z in rows
    ]
