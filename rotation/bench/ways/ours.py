"""Rotate points with the functions of this package, into an existing array."""

from __future__ import annotations

from functools import partial

import numpy as np

from rotation.array_types import ArrayLike
from rotation.arrays import Layout
from rotation.bench.tasks import Array, Task, half_turn
from rotation.bench.ways.way import FrameFunction, Way
from rotation.fused import rotate, rotate_euler, rotate_quat

Z = np.array([0.0, 0.0, 1.0])


def _laid_out(array: Array, layout: Layout) -> Array:
    return array if layout == "aos" else np.ascontiguousarray(array.T)


def _rotate(task: Task, layout: Layout) -> FrameFunction:
    points, axes = _laid_out(task.points, layout), _laid_out(task.axes, layout)
    out, length = np.empty_like(points), len(task.points)

    def one(n: int) -> ArrayLike:
        rotate(points, Z, task.angles[n], out=out, layout=layout)
        return out if layout == "aos" else out.T

    def own(n: int) -> ArrayLike:
        rotate(points, axes, task.angles[n : n + length], out=out, layout=layout)
        return out if layout == "aos" else out.T

    return one if task.kind == "one axis" else own


def _rotate_quat(task: Task) -> FrameFunction:
    points, out = task.points, np.empty_like(task.points)
    return lambda n: rotate_quat(points, np.array(half_turn(Z, task.angles[n])), out=out)


def _rotate_euler(task: Task, layout: Layout) -> FrameFunction:
    points = _laid_out(task.points, layout)
    out = np.empty_like(points)
    angles = points.copy()  # apart from the points, as angles usually are

    def frame(n: int) -> ArrayLike:
        rotate_euler(points, angles, "ZYX", out=out, layout=layout)
        return out if layout == "aos" else out.T

    return frame


def _ways(layout: Layout, shape: str) -> Way:
    turn = partial(_rotate, layout=layout)
    return Way(
        f"hfield, {shape}",
        "ours",
        "rotation",
        "hfield",
        "out",
        {"one axis": turn, "own axis": turn, "euler": partial(_rotate_euler, layout=layout)},
    )


OURS: tuple[Way, ...] = (
    _ways("aos", "(N, 3)"),
    _ways("soa", "(3, N)"),
    Way(
        "hfield, rotate_quat",
        "ours",
        "rotation",
        "hfield",
        "out",
        {"one axis": _rotate_quat},
    ),
)
