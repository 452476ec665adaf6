"""The loops that rotate many points, and the threads that share them.

Every function takes arrays with the components last, in any strides, whose batches broadcast to that
of ``out``; ``out`` may be the points themselves. Nothing is checked here but zero axes and zero
quaternions, which only the loop itself can see cheaply. A loop is compiled, in some hundredths of a
second, for the way its arrays lie in memory, when first asked for.
"""

import ctypes
from functools import cache
from typing import Any

import numpy as np

from rotation.arrays import Array
from rotation.kernels import uncompiled
from rotation.kernels.strides import parameters, plan, straightened
from rotation.pool import share, threads

__all__ = ["axis_angle", "contains_zero", "cumulative", "euler", "one", "quaternions", "threads"]

# Below this many points for each thread, waking one takes longer than its part of the work.
LIGHT, HEAVY = 100_000, 8_000


def one(points: Array, matrix: Array, out: Array) -> None:
    """Rotate all points by one matrix ``(3, 3)``."""
    entries = matrix.astype(points.dtype).reshape(9)
    _run(("one",), LIGHT, (points, entries), out)


def axis_angle(points: Array, axis: Array, angle: Array, out: Array, degrees: bool = False) -> bool:
    """Rotate points about their own axes by their own angles; tell whether an axis was zero."""
    axis, angle = parameters(points, axis, angle)
    return _run(("axis_angle", degrees), HEAVY, (points, axis, angle[..., None]), out)


def quaternions(points: Array, q: Array, out: Array) -> bool:
    """Rotate points by their own quaternions of any length; tell whether one was zero."""
    return _run(("quaternions",), HEAVY, (points, *parameters(points, q)), out)


def euler(
    points: Array,
    angles: Array,
    axes: tuple[int, ...],
    backward: bool,
    out: Array,
    degrees: bool = False,
) -> None:
    """Rotate points about coordinate axes, in that order, by their own angles ``(…, len(axes))``.

    The first axis takes the last of the angles if ``backward``, else the first.
    """
    _run(("euler", axes, backward, degrees), HEAVY, (points, *parameters(points, angles)), out)


def contains_zero(array: Array) -> bool:
    """Tell whether a row has all its components zero."""
    return _run(("contains_zero",), LIGHT, (array,), None)


def cumulative(q: Array) -> Array:
    """Return ``q[0]``, ``q[1]·q[0]``, ``q[2]·q[1]·q[0]``, … for ``q`` of shape ``(N, 4)``, normalised.

    The running product is kept in twice the precision, so errors do not add up over its length.
    """
    from rotation.kernels import chains

    return chains.cumulative(np.ascontiguousarray(q, np.float64))


def _run(name: tuple[Any, ...], grain: int, read: tuple[Array, ...], out: Array | None) -> bool:
    operands = read if out is None else (*read, out)
    batch = operands[-1].shape[:-1]
    if operands[-1].size == 0:
        return False
    made = plan(batch, operands) or plan(batch, tuple(straightened(batch, a) for a in operands))
    if made is None:
        raise AssertionError("arrays in one piece have constant strides")
    kinds = tuple(
        (a.shape[-1], a.dtype.char, s[0], s[2])
        for a, s in zip(made.operands, made.strides, strict=True)
    )
    kernel = _kernel(name, kinds, out is not None)
    if kernel is None:
        return uncompiled.run(name, read, out)
    table = (ctypes.c_int64 * (2 + 4 * len(operands)))(made.outer, made.inner, *made.table)
    pieces = made.outer * made.inner // grain + 1
    alive = (made.operands, table)
    answer = share(kernel, pieces, alive, ctypes.addressof(table))
    if out is not None and made.operands[-1] is not out:
        out[...] = made.operands[-1]
    return answer


@cache
def _kernel(
    name: tuple[Any, ...], kinds: tuple[tuple[int, str, int, int], ...], writes: bool
) -> Any:
    """Return the loop for operands of these widths, types and strides, or None where there can be none."""
    from rotation.kernels import compiling

    return compiling.compiled(name, kinds, writes)
