"""The kernel for points with their own Euler angles: three plane rotations about any axes."""

import math
from typing import Any

from rotation.kernels.compiled.compiling import SOURCES, inlined, kernel
from rotation.kernels.compiled.ranges import measured, not_finite
from rotation.kernels.compiled.rows import apart, triples
from rotation.kernels.compiled.sincos import reachable, sincos
from rotation.kernels.compiled.sweep import sweep


@inlined
def turn(point: Any, axis: Any, s: Any, c: Any) -> Any:
    """Rotate about a coordinate axis, the same for all points."""
    x, y, z = point
    if axis == 0:
        return x, c * y - s * z, s * y + c * z
    if axis == 1:
        return c * x + s * z, y, c * z - s * x
    return c * x - s * y, s * x + c * y, z


@inlined
def fast(angles: Any, extra: Any, point: Any) -> Any:
    """Rotate eight points; see `sweep`."""
    axes, backward = extra
    e, f, g, _ = angles
    poison, fine = measured(point)
    fine = fine & reachable(e) & reachable(f) & reachable(g)
    if backward:
        e, g = g, e
    s, c = sincos(e)
    point = turn(point, axes[0], s, c)
    s, c = sincos(f)
    point = turn(point, axes[1], s, c)
    s, c = sincos(g)
    x, y, z = turn(point, axes[2], s, c)
    return (x + poison, y + poison, z + poison), fine


@inlined
def careful(angles: Any, extra: Any, point: Any) -> Any:
    """Rotate a point by angles of any size; see `sweep`."""
    axes, backward = extra
    e, f, g, _ = angles
    if backward:
        e, g = g, e
    poison = not_finite(e, f, g)
    point = turn(point, axes[0], math.sin(e), math.cos(e))
    point = turn(point, axes[1], math.sin(f), math.cos(f))
    x, y, z = turn(point, axes[2], math.sin(g), math.cos(g))
    return (x + poison, y + poison, z + poison), True


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
    operands = table[0], table[1], table[1], table[2]
    kinds = p, t, 0.0
    return sweep(
        fast,
        careful,
        (axes, backward),
        apart,
        triples,
        counter,
        outer,
        inner,
        operands,
        (3, 0),
        kinds,
    )
