"""From arrays of any shape and stride to what the compiled kernels read: addresses and strides."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from hfield.compiling.memory import address
from rotation.arrays import Array, Shape

MIN_INNER_AXIS = 64  # an inner axis shorter than this is exchanged with a longer outer one


class Plan(NamedTuple):
    """A batch as ``outer × inner``, and each operand as the kernels read it."""

    outer: int
    inner: int
    strides: tuple[tuple[int, ...], ...]  # three an operand
    table: list[int]  # of each operand the address, then its strides
    operands: tuple[Array, ...]  # kept alive as long as their addresses are in use


def plan(batch: Shape, operands: tuple[Array, ...]) -> Plan | None:
    """Return the plan for operands with components last, each batch broadcasting to ``batch``.

    The strides lead from one component to the next, along the outer and along the inner axis, in bytes.
    None if the common batch does not reduce to two axes of constant stride, or if memory is
    not aligned: then operands in one piece are needed.
    """
    if not all(a.flags.aligned for a in operands):
        return None
    shape = _geometry(batch, tuple((a.shape, a.strides) for a in operands))
    if shape is None:
        return None
    outer, inner, strides = shape
    table: list[int] = []
    for a, own in zip(operands, strides, strict=True):
        table += (address(a), *own)
    return Plan(outer, inner, strides, table, operands)


@lru_cache(maxsize=1024)  # frame after frame has arrays of the same kind
def _geometry(
    batch: Shape, arrays: tuple[tuple[Shape, Shape], ...]
) -> tuple[int, int, tuple[Shape, ...]] | None:
    """Return outer and inner length and the strides of arrays given by shape and strides."""
    axes = _reduce(batch, [_strides(batch, shape, strides) for shape, strides in arrays])
    if len(axes) > 2:
        return None
    while len(axes) < 2:
        axes.insert(0, (1, *(0 for _ in arrays)))
    (outer, *outer_strides), (inner, *inner_strides) = axes
    found = zip(arrays, outer_strides, inner_strides, strict=True)
    strides = tuple((own[-1], o, i) for (_, own), o, i in found)
    return outer, inner, strides


def _strides(batch: Shape, shape: Shape, strides: Shape) -> Shape:
    """Return the strides of an array's batch when broadcast, in bytes."""
    missing = len(batch) - len(shape) + 1
    return (0,) * missing + tuple(
        0 if n == 1 else s for n, s in zip(shape[:-1], strides[:-1], strict=True)
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
    if len(merged) == 2 and merged[1][0] < MIN_INNER_AXIS < merged[0][0]:
        merged.reverse()
    return merged


def parameters(points: Array, *arrays: Array) -> tuple[Array, ...]:
    """Return the parameters in one type: float64 if one of them is, or if the points are."""
    if all(a.dtype == points.dtype for a in arrays):
        return arrays
    kind = np.result_type(points.dtype, *(a.dtype for a in arrays))
    return tuple(a.astype(kind, copy=False) for a in arrays)
