"""From arrays of any shape and stride to what the compiled kernels read: addresses and strides."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from rotation.arrays import Array, Shape

SHORT = 64  # an inner axis shorter than this is exchanged with a longer outer one


class Plan(NamedTuple):
    """A batch as ``outer × inner``, and each operand as a row of the table the kernels read."""

    outer: int
    inner: int
    table: npt.NDArray[np.int64]
    operands: tuple[Array, ...]  # kept alive as long as their addresses are in use


def plan(batch: Shape, operands: tuple[Array, ...]) -> Plan | None:
    """Return the plan for operands with components last, each batch broadcasting to ``batch``.

    None if their common batch does not reduce to two axes of constant stride, or if memory is not
    aligned: then `straightened` operands are needed.
    """
    axes = _reduce(batch, [_strides(batch, a) for a in operands])
    if len(axes) > 2 or any(map(_odd, operands)):
        return None
    while len(axes) < 2:
        axes.insert(0, (1, *(0 for _ in operands)))
    (outer, *outer_strides), (inner, *inner_strides) = axes
    table = np.array(
        [
            (a.ctypes.data, *(s // a.itemsize for s in (a.strides[-1], o, i)))
            for a, o, i in zip(operands, outer_strides, inner_strides, strict=True)
        ],
        np.int64,
    )
    return Plan(outer, inner, table, operands)


def straightened(batch: Shape, array: Array) -> Array:
    """Return a copy of ``array`` in one piece, broadcast to ``batch``."""
    return np.array(np.broadcast_to(array, (*batch, array.shape[-1])), order="C")


def _strides(batch: Shape, array: Array) -> Shape:
    """Return the strides of the array's batch when broadcast, in bytes."""
    own = array.shape[:-1]
    missing = len(batch) - len(own)
    return (0,) * missing + tuple(
        0 if n == 1 else s for n, s in zip(own, array.strides[:-1], strict=True)
    )


def _reduce(batch: Shape, strides: list[Shape]) -> list[tuple[int, ...]]:
    """Return the axes as ``(length, strides…)``, merged where every operand runs on evenly."""
    axes = [(n, *s) for n, *s in zip(batch, *strides, strict=True) if n != 1]
    axes.sort(key=lambda axis: -abs(axis[-1]))  # along the memory of the result
    merged: list[tuple[int, ...]] = []
    for axis in axes:
        n, *steps = axis
        if merged and all(
            before == n * step for before, step in zip(merged[-1][1:], steps, strict=True)
        ):
            merged[-1] = (merged[-1][0] * n, *steps)
        else:
            merged.append(axis)
    if len(merged) == 2 and merged[1][0] < SHORT < merged[0][0]:
        merged.reverse()
    return merged


def _odd(array: Array) -> bool:
    return not array.flags.aligned or any(s % array.itemsize for s in array.strides)


def parameters(points: Array, *arrays: Array) -> tuple[Any, ...]:
    """Return zeros of the points' and the parameters' type, and the parameters in one type.

    float64 if a parameter is, or if the points are: so that three combinations are compiled, not eight.
    """
    kind = np.result_type(points.dtype, *(a.dtype for a in arrays))
    return points.dtype.type(0), kind.type(0), *(a.astype(kind, copy=False) for a in arrays)
