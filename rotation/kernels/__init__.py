"""The loops that rotate points, compiled by numba, and the threads that share them.

Every function takes arrays with the components last, in any strides, whose batches broadcast to that
of ``out``; ``out`` may be the points themselves. Nothing is checked here but zero axes and zero
quaternions, which only the loop itself can see cheaply. numba is imported at the first call, and only
the kernel that is called is compiled or read from its cache.
"""

from functools import cache
from importlib import import_module
from typing import Any

import numpy as np

from rotation.arrays import Array
from rotation.kernels import twins, uncompiled
from rotation.kernels.announcing import announce
from rotation.kernels.memory import parameters, plan, straightened
from rotation.kernels.pool import share, threads

__all__ = [
    "axis_angle",
    "contains_zero",
    "cumulative",
    "euler",
    "one",
    "quaternions",
    "threads",
]

# Below this many points for each thread, waking one takes longer than its part of the work.
LIGHT, HEAVY = 100_000, 8_000


def one(points: Array, matrix: Array, out: Array) -> None:
    """Rotate all points by one matrix ``(3, 3)``."""
    rows = tuple(matrix.astype(points.dtype).flat)
    _run("one", LIGHT, (points, out), (points.dtype.type(0), rows))


def axis_angle(points: Array, axis: Array, angle: Array, out: Array) -> bool:
    """Rotate points about their own axes by their own angles; tell whether an axis was zero."""
    p, t, axis, angle = parameters(points, axis, angle)
    return _run("axis_angle", HEAVY, (points, axis, angle[..., None], out), (p, t))


def quaternions(points: Array, q: Array, out: Array) -> bool:
    """Rotate points by their own quaternions of any length; tell whether one was zero."""
    p, t, q = parameters(points, q)
    return _run("quaternions", HEAVY, (points, q, out), (p, t))


def euler(
    points: Array, angles: Array, axes: tuple[int, int, int], backward: bool, out: Array
) -> None:
    """Rotate points about three coordinate axes, in that order, by their own angles ``(…, 3)``.

    The first axis takes the last of the angles if ``backward``, else the first.
    """
    p, t, angles = parameters(points, angles)
    _run("euler", HEAVY, (points, angles, out), (p, t, axes, backward))


def contains_zero(array: Array) -> bool:
    """Tell whether a row has all its components zero."""
    return _run("contains_zero", LIGHT, (array,), (array.shape[-1], array.dtype.type(0)), False)


def cumulative(q: Array) -> Array:
    """Return ``q[0]``, ``q[1]·q[0]``, ``q[2]·q[1]·q[0]``, … for ``q`` of shape ``(N, 4)``, normalised.

    The running product is kept in twice the precision, so errors do not add up over its length.
    """
    q = np.ascontiguousarray(q, np.float64)
    result = np.empty_like(q)
    kernel = _kernel("cumulative")
    if kernel is None:
        return twins.cumulative(q)
    kernel(q, result)
    return result


def _run(
    name: str,
    grain: int,
    operands: tuple[Array, ...],
    arguments: tuple[Any, ...],
    writes: bool = True,
) -> bool:
    out = operands[-1]
    batch = out.shape[:-1]
    if out.size == 0:
        return False
    kernel = _kernel(name)
    if kernel is None:
        return uncompiled.run(name, operands, arguments)
    made = plan(batch, operands) or plan(batch, tuple(straightened(batch, a) for a in operands))
    if made is None:
        raise AssertionError("arrays in one piece have constant strides")
    pieces = made.outer * made.inner // grain + 1
    answer = share(kernel, pieces, made.operands, made.outer, made.inner, made.table, *arguments)
    if writes and made.operands[-1] is not out:
        out[...] = made.operands[-1]
    return answer


@cache
def _kernel(name: str) -> Any:
    """Return the kernel, or None if numba leaves functions as they are, as for debugging."""
    from numba import config

    if config.DISABLE_JIT:
        return None
    kernel = getattr(import_module(f"rotation.kernels.compiled.{name}"), name)
    announce(kernel)
    return kernel
