"""Iterate compiled kernels over arrays of any shape and stride, along two axes of constant stride."""

from functools import lru_cache
from typing import NamedTuple

from rotation.arrays import Shape

MIN_INNER_AXIS = 64  # an inner axis shorter than this is exchanged with a longer outer one


class BatchAxes(NamedTuple):
    """The axes of a batch as ``outer × inner``, with the strides of each array in bytes."""

    outer: int
    inner: int
    strides: tuple[Shape, ...]  # between components, along the outer and the inner axis


@lru_cache(maxsize=1024)  # frame after frame has arrays of the same kind
def walk(batch: Shape, arrays: tuple[tuple[Shape, Shape], ...]) -> BatchAxes | None:
    """Return how to iterate over arrays with components last, given their shapes and strides.

    Each batch broadcasts to ``batch``. The result is None if the common batch does not reduce to two axes of
    constant stride; then contiguous arrays are needed.
    """
    axes = _reduce(batch, [_strides(batch, shape, strides) for shape, strides in arrays])
    if len(axes) > 2:
        return None
    while len(axes) < 2:
        axes.insert(0, (1, *(0 for _ in arrays)))
    (outer, *outer_strides), (inner, *inner_strides) = axes
    found = zip(arrays, outer_strides, inner_strides, strict=True)
    return BatchAxes(outer, inner, tuple((own[-1], o, i) for (_, own), o, i in found))


def _strides(batch: Shape, shape: Shape, strides: Shape) -> Shape:
    """Return the strides in bytes of an array's batch after broadcasting."""
    missing = len(batch) - len(shape) + 1
    return (0,) * missing + tuple(
        0 if n == 1 else s for n, s in zip(shape[:-1], strides[:-1], strict=True)
    )


def _reduce(batch: Shape, strides: list[Shape]) -> list[tuple[int, ...]]:
    """Return the axes as ``(length, strides…)``, merging axes over which every operand is contiguous."""
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
