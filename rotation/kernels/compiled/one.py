"""The kernel for one rotation of all points: as fast as memory is read and written."""

from typing import Any

from rotation.kernels.compiled.access import (
    TAKE,
    at,
    blocks,
    deliver,
    fetch,
    near,
    new,
    packed,
    put,
    scratch,
    span,
    take,
    view,
)
from rotation.kernels.compiled.compiling import SOURCES, inlined, kernel


@inlined
def loop(points: Any, out: Any, step: Any, m: Any, p: Any, rows: Any) -> Any:
    """Rotate ``m`` points by the matrix of nine entries, in the precision of the points."""
    a, b, c, d, e, f, g, h, k = rows
    for i in range(m):
        x = at(points, step, i, 0, p)
        y = at(points, step, i, 1, p)
        z = at(points, step, i, 2, p)
        poison = x * p + (y * p + z * p)  # p is 0: NaN if a coordinate is not finite
        put(out, step, i, 0, a * x + (b * y + (c * z + poison)))
        put(out, step, i, 1, d * x + (e * y + (f * z + poison)))
        put(out, step, i, 2, g * x + (h * y + (k * z + poison)))


@kernel
def one(
    counter: Any, outer: Any, inner: Any, table: Any, p: Any, rows: Any, sources: int = SOURCES
) -> Any:
    """Rotate all points by one matrix, given as a tuple of nine numbers of the points' type."""
    points, result = table[0], table[1]
    in_place = points[0] == result[0]
    triples = packed(points) and packed(result) and not in_place
    direct = triples or result[3] == 1
    my_points, my_result = new(3, p), new(3, p)
    total = blocks(outer, inner)
    while True:
        first = take(counter, TAKE)
        if first >= total:
            return False
        for block in range(first, min(first + TAKE, total)):
            o, start, m = span(block, inner)
            if triples:
                loop(near(points, o, start), near(result, o, start), 3, m, p, rows)
                continue
            v, r = view(points, o, start), view(result, o, start)
            if in_place or points[3] != 1:
                v = fetch(points, o, start, m, my_points, p)
            if not direct:
                r = scratch(my_result)
            loop(v, r, 1, m, p, rows)
            if not direct:
                deliver(result, o, start, m, my_result, p)
