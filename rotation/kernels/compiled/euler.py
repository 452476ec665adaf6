"""The kernel for points with their own Euler angles: three plane rotations about any axes."""

from typing import Any

import numpy as np

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
from rotation.kernels.compiled.ranges import not_finite
from rotation.kernels.compiled.sincos import reachable, sincos


@inlined
def turn(x: Any, y: Any, z: Any, axis: Any, angle: Any, careful: Any) -> Any:
    """Rotate a point about a coordinate axis. The choice is one for the whole loop, so it blends."""
    s, c = sincos(angle, careful)
    u = y if axis == 0 else (z if axis == 1 else x)
    v = z if axis == 0 else (x if axis == 1 else y)
    u, v = c * u - s * v, s * u + c * v
    return (
        x if axis == 0 else (v if axis == 1 else u),
        u if axis == 0 else (y if axis == 1 else v),
        v if axis == 0 else (u if axis == 1 else z),
    )


@inlined
def loop(
    points: Any,
    angles: Any,
    out: Any,
    step: Any,
    m: Any,
    p: Any,
    t: Any,
    axes: Any,
    backward: Any,
    careful: Any,
) -> Any:
    """Rotate ``m`` points; return whether some angle needs a careful sine."""
    first, second, third = axes
    unsafe = False
    for i in range(m):
        e = np.float64(at(angles, step, i, 0, t))
        f = np.float64(at(angles, step, i, 1, t))
        g = np.float64(at(angles, step, i, 2, t))
        unsafe |= not (reachable(e) and reachable(f) and reachable(g))
        x = np.float64(at(points, step, i, 0, p))
        y = np.float64(at(points, step, i, 1, p))
        z = np.float64(at(points, step, i, 2, p))
        poison = not_finite(x, y, z)
        if careful:  # an angle that is not finite is never reachable
            poison += not_finite(e, f, g)
        x, y, z = turn(x, y, z, first, g if backward else e, careful)
        x, y, z = turn(x, y, z, second, f, careful)
        x, y, z = turn(x, y, z, third, e if backward else g, careful)
        put(out, step, i, 0, type(p)(x + poison))
        put(out, step, i, 1, type(p)(y + poison))
        put(out, step, i, 2, type(p)(z + poison))
    return unsafe


@kernel
def euler(
    counter: Any,
    outer: Any,
    inner: Any,
    table: Any,
    p: Any,
    t: Any,
    axes: Any,
    backward: Any,
    sources: int = SOURCES,
) -> Any:
    """Rotate points about three coordinate axes, in that order, by the angles (operand 1).

    The first axis takes the last of the angles if ``backward``, else the first.
    """
    points, angles, result = table[0], table[1], table[2]
    in_place = points[0] == result[0]
    triples = packed(points) and packed(angles) and packed(result) and not in_place
    direct = triples or result[3] == 1
    my_points, my_angles, my_result = new(3, p), new(3, t), new(3, p)
    total = blocks(outer, inner)
    while True:
        first = take(counter, TAKE)
        if first >= total:
            return False
        for block in range(first, min(first + TAKE, total)):
            o, start, m = span(block, inner)
            v, s, r = view(points, o, start), view(angles, o, start), view(result, o, start)
            if triples:
                unsafe = loop(
                    near(points, o, start),
                    near(angles, o, start),
                    near(result, o, start),
                    3,
                    m,
                    p,
                    t,
                    axes,
                    backward,
                    False,
                )
            else:
                if in_place or points[3] != 1:
                    v = fetch(points, o, start, m, my_points, p)
                if angles[3] != 1:
                    s = fetch(angles, o, start, m, my_angles, t)
                if not direct:
                    r = scratch(my_result)
                unsafe = loop(v, s, r, 1, m, p, t, axes, backward, False)
            if unsafe:
                if not in_place:
                    v = fetch(points, o, start, m, my_points, p)
                s = fetch(angles, o, start, m, my_angles, t)
                loop(v, s, scratch(my_result), 1, m, p, t, axes, backward, True)
            if unsafe or not direct:
                deliver(result, o, start, m, my_result, p)
