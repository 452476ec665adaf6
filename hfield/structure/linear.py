"""Linear algebra over a base ring, as far as bases of kernels go."""

import math
from typing import Any

from hfield.errors import NotInvertibleError, UndecidedError
from hfield.rings.base import Ring

Row = list[Any]


def kernel(ring: Ring, rows: list[Row], width: int) -> list[Row]:
    """Return a basis of ``{v : rows·v = 0}``, of ``width`` columns, by elimination.

    Over a field always; over other rings as long as every pivot can be a unit, or stands alone in
    its row and is no zero divisor. Over ZZ the rest is done by integer reduction, so the basis
    is saturated. Raises :class:`UndecidedError` where the kernel need not be free.
    """
    rows = [list(r) for r in rows]
    pivots: dict[int, Row] = {}
    while True:
        rows = [r for r in rows if not all(ring.is_zero(x) for x in r)]
        if not rows:
            break
        step = _unit_pivot(ring, rows) or _lonely_pivot(ring, rows)
        if step is None:
            if ring.name == "ZZ":
                return _integer_kernel(ring, [*rows, *pivots.values()], width)
            raise UndecidedError(
                f"over {ring.name} this kernel has no basis that elimination with units could find; "
                "ask over the field of fractions, or over a residue field"
            )
        row, column = step
        for other in [*rows, *pivots.values()]:
            if other is not row and not ring.is_zero(other[column]):
                factor = other[column]
                other[:] = [x - factor * y for x, y in zip(other, row, strict=True)]
        rows = [r for r in rows if r is not row]
        pivots[column] = row
    basis = []
    for free in range(width):
        if free not in pivots:
            v = [ring.zero] * width
            v[free] = ring.one
            for column, row in pivots.items():
                v[column] = ring.zero - row[free]
            basis.append(v)
    return basis


def _unit_pivot(ring: Ring, rows: list[Row]) -> tuple[Row, int] | None:
    """Scale some row so that it has a 1, and return it with the column of the 1."""
    for row in rows:
        for column, x in enumerate(row):
            if not ring.is_zero(x):
                try:
                    inverse = ring.inverse(x)
                except NotInvertibleError:
                    continue
                row[:] = [inverse * y for y in row]
                return row, column
    return None


def _lonely_pivot(ring: Ring, rows: list[Row]) -> tuple[Row, int] | None:
    """Turn ``(0 … x … 0)``, x no zero divisor, into ``(0 … 1 … 0)``: both say the same."""
    for row in rows:
        support = [i for i, x in enumerate(row) if not ring.is_zero(x)]
        if len(support) == 1 and ring.annihilator(row[support[0]]) is None:
            row[support[0]] = ring.one
            return row, support[0]
    return None


def _integer_kernel(ring: Ring, rows: list[Row], width: int) -> list[Row]:
    """Return a saturated basis of the kernel of an integer matrix, by unimodular column steps."""
    columns = [
        [int(r[i]) for r in rows] + [int(i == j) for j in range(width)] for i in range(width)
    ]
    height = len(rows)
    for h in range(height):
        live = [v for v in columns if v[h] and not any(v[:h])]
        while len(live) > 1:
            live.sort(key=lambda v: abs(v[h]))
            for v in live[1:]:
                factor = v[h] // live[0][h]
                v[:] = [x - factor * y for x, y in zip(v, live[0], strict=True)]
            live = [v for v in live if v[h]]
    basis = [v[height:] for v in columns if not any(v[:height])]
    for v in basis:
        lead = next(x for x in v if x)
        divisor = math.copysign(math.gcd(*v), lead)
        v[:] = [x // int(divisor) for x in v]
    return [[ring(x) for x in v] for v in basis]


def apply(matrix: list[Row], v: Row) -> Row:
    """Return matrix·v."""
    return [
        sum((x * y for x, y in zip(row[1:], v[1:], strict=True)), row[0] * v[0]) for row in matrix
    ]
