"""The kernel for points with their own quaternions, of any length."""

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
from rotation.kernels.compiled.ranges import repair, safe, turned


@inlined
def loop(
    points: Any, quaternions: Any, out: Any, step: Any, q_step: Any, m: Any, p: Any, t: Any
) -> Any:
    """Rotate ``m`` points; return whether some quaternion needs repair."""
    unsafe = False
    for i in range(m):
        w = np.float64(at(quaternions, q_step, i, 0, t))
        a = np.float64(at(quaternions, q_step, i, 1, t))
        b = np.float64(at(quaternions, q_step, i, 2, t))
        c = np.float64(at(quaternions, q_step, i, 3, t))
        x = np.float64(at(points, step, i, 0, p))
        y = np.float64(at(points, step, i, 1, p))
        z = np.float64(at(points, step, i, 2, p))
        unsafe |= not safe((w * w + a * a) + (b * b + c * c))
        x, y, z = turned(w, a, b, c, x, y, z)
        put(out, step, i, 0, type(p)(x))
        put(out, step, i, 1, type(p)(y))
        put(out, step, i, 2, type(p)(z))
    return unsafe


@kernel
def quaternions(
    counter: Any, outer: Any, inner: Any, table: Any, p: Any, t: Any, sources: int = SOURCES
) -> Any:
    """Rotate points by quaternions (operand 1); return whether one is zero."""
    points, turns, result = table[0], table[1], table[2]
    in_place = points[0] == result[0]
    together = packed(points) and packed(result) and turns[1] == 1 and turns[3] == 4
    together = together and not in_place
    direct = together or result[3] == 1
    my_points, my_turns, my_result = new(3, p), new(4, t), new(3, p)
    zero = False
    total = blocks(outer, inner)
    while True:
        first = take(counter, TAKE)
        if first >= total:
            return zero
        for block in range(first, min(first + TAKE, total)):
            o, start, m = span(block, inner)
            v, q, r = view(points, o, start), view(turns, o, start), view(result, o, start)
            if together:
                unsafe = loop(
                    near(points, o, start),
                    near(turns, o, start),
                    near(result, o, start),
                    3,
                    4,
                    m,
                    p,
                    t,
                )
            else:
                if in_place or points[3] != 1:
                    v = fetch(points, o, start, m, my_points, p)
                if turns[3] != 1:
                    q = fetch(turns, o, start, m, my_turns, t)
                if not direct:
                    r = scratch(my_result)
                unsafe = loop(v, q, r, 1, 1, m, p, t)
            if unsafe:
                if not in_place:
                    v = fetch(points, o, start, m, my_points, p)
                q = fetch(turns, o, start, m, my_turns, t)
                zero |= repair(q, 4, m, t)
                loop(v, q, scratch(my_result), 1, 1, m, p, t)
            if unsafe or not direct:
                deliver(result, o, start, m, my_result, p)
