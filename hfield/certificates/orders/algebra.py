"""The algebra i² = a + t·i, j² = b over ℚ, on rows of four integers over a denominator."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from hfield.certificates.evaluate import Evaluator, RingScalars
from hfield.certificates.language import walk
from hfield.certificates.number_fields.matrices import Row, Rows, longest, times
from hfield.certificates.rejection import reject
from hfield.certificates.statement import Setting
from hfield.certificates.work import charge


class Algebra:
    """Products, conjugates and norms of integer rows; all of them come ``scale`` times too large.

    Who calls them pays, by the ``bits`` of the lattice that the rows are from.
    """

    def __init__(self, setting: Setting) -> None:
        ring = setting.field
        if ring is None or ring.name != "QQ" or setting.letters:
            reject("lattices are checked in an algebra over QQ alone, with numbers for constants")
        self._tabulate(setting, lambda x: (Fraction(x).denominator, Fraction(x).numerator))

    def _tabulate(self, setting: Setting, parts: Callable[[Any], tuple[int, Any]]) -> None:
        """Make the tables; ``parts`` returns the denominator and the numerator of a constant."""
        ring = setting.field
        assert ring is not None
        nodes = [node for tree in setting.constants for node in walk(tree)]
        known = {node: ring.constant(node) for node in nodes if node[0] in ("name", "call")}
        evaluator = Evaluator(RingScalars(ring), setting.constants, known)
        if evaluator.conditions:
            reject("the structure constants are not defined")
        a, t, b = evaluator.constants
        entries = [parts(x) for x in (a, t, b, ring.mul(a, b), ring.mul(t, b))]
        bits = sum(n.bit_length() for entry in entries[:3] for n in entry)
        charge(1_000 + bits * bits // 2_500)
        self.scale = s = lcm(*(den for den, _ in entries))
        a, t, b, ab, tb = (x * (s // den) for den, x in entries)
        self._table = [[[0] * 4 for _ in range(4)] for _ in range(4)]
        for m, products in enumerate(evaluator.table):
            for n, terms in enumerate(products):
                for place, c in terms:
                    den, x = parts(c)
                    self._table[m][n][place] = x * (s // den)
        self.form: Rows = (
            (2 * s, t, 0, 0),
            (t, -2 * a, 0, 0),
            (0, 0, -2 * b, -tb),
            (0, 0, -tb, 2 * ab),
        )
        """The matrix of tr(x·conj(y)), from N = n(w, x) − b·n(y, z), n(u, v) = u² + t·uv − a·v²."""
        self._bar: Rows = ((s, 0, 0, 0), (t, -s, 0, 0), (0, 0, -s, 0), (0, 0, 0, -s))
        self.bits = longest([*self.form, *(row for rows in self._table for row in rows)])
        if not (t * t + 4 * s * a) * b:
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

    def primitive(self, row: Row, den: int = 0) -> tuple[int, Row]:
        """Divide a row, and a denominator, by the positive integers that divide all of it."""
        common = gcd(den, *row)
        return den // common, tuple(x // common for x in row)
