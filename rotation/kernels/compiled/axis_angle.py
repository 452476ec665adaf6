"""The kernel for points with their own axes and angles."""

import math
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
from rotation.kernels.compiled.ranges import not_finite, repair, safe
from rotation.kernels.compiled.sincos import reachable, sincos


@inlined
def loop(
    points: Any, axes: Any, angles: Any, out: Any, step: Any, m: Any, p: Any, t: Any, careful: Any
) -> Any:
    """Rotate ``m`` points; return whether some row needs repair or a careful sine.

    v + (|a| sin θ (a × v) + (1 − cos θ) a × (a × v)) / |a|²: of the cheap forms tried it has the
    smallest error, below 4·2⁻⁵²·|v|, since |a|² is divided by but once.
    """
    unsafe = False
    for i in range(m):
        angle = np.float64(at(angles, 1, i, 0, t))
        a = np.float64(at(axes, step, i, 0, t))
        b = np.float64(at(axes, step, i, 1, t))
        c = np.float64(at(axes, step, i, 2, t))
        x = np.float64(at(points, step, i, 0, p))
        y = np.float64(at(points, step, i, 1, p))
        z = np.float64(at(points, step, i, 2, p))
        square = a * a + b * b + c * c
        unsafe |= not (reachable(angle) and safe(square))
        sine, cosine = sincos(angle, careful)
        w, versine = math.sqrt(square) * sine, 1.0 - cosine
        part = 1.0 / square
        poison = not_finite(x, y, z)
        fx = b * z - c * y
        fy = c * x - a * z
        fz = a * y - b * x
        px = x + part * (w * fx + (versine * (b * fz - c * fy) + poison))
        py = y + part * (w * fy + (versine * (c * fx - a * fz) + poison))
        pz = z + part * (w * fz + (versine * (a * fy - b * fx) + poison))
        put(out, step, i, 0, type(p)(px))
        put(out, step, i, 1, type(p)(py))
        put(out, step, i, 2, type(p)(pz))
    return unsafe


@kernel
def axis_angle(
    counter: Any, outer: Any, inner: Any, table: Any, p: Any, t: Any, sources: int = SOURCES
) -> Any:
    """Rotate points about axes (operand 1) by angles (operand 2); return whether an axis is zero."""
    points, axes, angles, result = table[0], table[1], table[2], table[3]
    in_place = points[0] == result[0]
    triples = packed(points) and packed(axes) and angles[3] == 1 and packed(result) and not in_place
    direct = triples or result[3] == 1
    my_points, my_axes, my_angles, my_result = new(3, p), new(3, t), new(1, t), new(3, p)
    zero = False
    total = blocks(outer, inner)
    while True:
        first = take(counter, TAKE)
        if first >= total:
            return zero
        for block in range(first, min(first + TAKE, total)):
            o, start, m = span(block, inner)
            v, u = view(points, o, start), view(axes, o, start)
            s, r = view(angles, o, start), view(result, o, start)
            if triples:
                unsafe = loop(
                    near(points, o, start),
                    near(axes, o, start),
                    s,
                    near(result, o, start),
                    3,
                    m,
                    p,
                    t,
                    False,
                )
            else:
                if in_place or points[3] != 1:
                    v = fetch(points, o, start, m, my_points, p)
                if axes[3] != 1:
                    u = fetch(axes, o, start, m, my_axes, t)
                if angles[3] != 1:
                    s = fetch(angles, o, start, m, my_angles, t)
                if not direct:
                    r = scratch(my_result)
                unsafe = loop(v, u, s, r, 1, m, p, t, False)
            if unsafe:
                if not in_place:
                    v = fetch(points, o, start, m, my_points, p)
                u = fetch(axes, o, start, m, my_axes, t)
                s = fetch(angles, o, start, m, my_angles, t)
                zero |= repair(u, 3, m, t)
                loop(v, u, s, scratch(my_result), 1, m, p, t, True)
            if unsafe or not direct:
                deliver(result, o, start, m, my_result, p)
