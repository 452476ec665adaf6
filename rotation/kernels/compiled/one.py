"""The kernel for one rotation of all points: as fast as memory is read and written."""

from typing import Any

from rotation.kernels.compiled.compiling import SOURCES, inlined, kernel
from rotation.kernels.compiled.ranges import not_finite
from rotation.kernels.compiled.rows import point_apart, point_together
from rotation.kernels.compiled.sweep import sweep


@inlined
def turned(parameters: Any, rows: Any, point: Any) -> Any:
    """Rotate eight points, or one, by the matrix of nine entries, in the precision of the points."""
    a, b, c, d, e, f, g, h, k = rows
    x, y, z = point
    poison = not_finite(x, y, z)
    return (
        a * x + (b * y + (c * z + poison)),
        d * x + (e * y + (f * z + poison)),
        g * x + (h * y + (k * z + poison)),
    ), True


@kernel
def one(
    counter: Any, outer: Any, inner: Any, table: Any, p: Any, rows: Any, sources: int = SOURCES
) -> Any:
    """Rotate all points by one matrix, given as a tuple of nine numbers of the points' type."""
    operands = table[0], table[0], table[0], table[1]
    kinds = p, p, p
    return sweep(
        turned,
        turned,
        rows,
        point_apart,
        point_together,
        counter,
        outer,
        inner,
        operands,
        (0, 0),
        kinds,
    )
