"""Kernels and solutions of linear systems over a base ring."""

from hfield.errors import NotInvertibleError
from hfield.fields.base.ring import E, Ring
from hfield.fields.linear_algebra.syzygies import Row, relations
from hfield.fields.linear_algebra.vectors import dot


def kernel(ring: Ring[E], rows: list[Row[E]], width: int) -> list[Row[E]]:
    """Return a basis of ``{v : rows·v = 0}``, v of ``width`` entries; generators if the kernel need not be
    free.

    Over a field, by elimination. Over other rings, elimination continues as long as some pivot is a unit, or
    is the only entry of its row and not a zero divisor. The rest is left to :func:`relations`. Raises
    :class:`UndecidedError` if that finds no generators.
    """
    rows = [list(r) for r in rows]
    pivots: dict[int, Row[E]] = {}
    while True:
        rows = [r for r in rows if not all(ring.is_zero(x) for x in r)]
        step = _unit_pivot(ring, rows) or _lonely_pivot(ring, rows)
        if step is None:
            break
        row, column = step
        for other in [*rows, *pivots.values()]:
            if other is not row and not ring.is_zero(other[column]):
                factor = other[column]
                other[:] = [x - factor * y for x, y in zip(other, row, strict=True)]
        rows = [r for r in rows if r is not row]
        pivots[column] = row
    free = [n for n in range(width) if n not in pivots]
    if rows:
        tails = relations(ring, [[row[n] for n in free] for row in rows], len(free))
    else:
        tails = [[ring.one if m == n else ring.zero for m in free] for n in free]
    basis = []
    for tail in tails:
        v = [ring.zero] * width
        for n, x in zip(free, tail, strict=True):
            v[n] = x
        for column, row in pivots.items():
            v[column] = ring.zero - dot([row[n] for n in free], tail)
        basis.append(v)
    return basis


def _unit_pivot(ring: Ring[E], rows: list[Row[E]]) -> tuple[Row[E], int] | None:
    """Scale some row so that it contains a 1, and return it with the column of the 1."""
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


def _lonely_pivot(ring: Ring[E], rows: list[Row[E]]) -> tuple[Row[E], int] | None:
    """Replace an equation ``(0 … x … 0)``, x not a zero divisor, by the equivalent ``(0 … 1 … 0)``."""
    for row in rows:
        support = [i for i, x in enumerate(row) if not ring.is_zero(x)]
        if len(support) == 1 and ring.annihilator(row[support[0]]) is None:
            row[support[0]] = ring.one
            return row, support[0]
    return None


def apply(matrix: list[Row], v: Row) -> Row:
    """Return matrix·v."""
    return [dot(row, v) for row in matrix]
