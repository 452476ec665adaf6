"""Plain numpy: a copy of the points, as a lower bound for the time, and arithmetic on whole arrays."""

from __future__ import annotations

import numpy as np

from rotation.array_types import ArrayLike
from rotation.bench.tasks import Array, Task
from rotation.bench.ways.way import FrameFunction, Way
from rotation.thesis import zaxisMatrixrotation


def _copy(task: Task) -> FrameFunction:
    out = np.empty_like(task.points)

    def frame(n: int) -> ArrayLike:
        np.copyto(out, task.points)
        return out

    return frame


def _one_axis(task: Task) -> FrameFunction:
    out = np.empty_like(task.points)

    def frame(n: int) -> ArrayLike:
        matrix: Array = np.array(zaxisMatrixrotation(task.angles[n]))
        return np.matmul(task.points, matrix.T, out=out)

    return frame


def _own_axis(task: Task) -> FrameFunction:
    """Rotate by Rodrigues' formula, component by component, which is several times faster than
    ``np.cross``.
    """
    x, y, z = np.ascontiguousarray(task.points.T)
    out = np.empty_like(task.points)
    axes = np.ascontiguousarray(task.axes.T)
    length = len(task.points)

    def frame(n: int) -> ArrayLike:
        angle = task.angles[n : n + length]
        a, b, c = axes / np.sqrt(np.einsum("ij,ij->j", axes, axes))
        s, cosine = np.sin(angle), np.cos(angle)
        along = (1 - cosine) * (a * x + b * y + c * z)
        out[:, 0] = x * cosine + s * (b * z - c * y) + a * along
        out[:, 1] = y * cosine + s * (c * x - a * z) + b * along
        out[:, 2] = z * cosine + s * (a * y - b * x) + c * along
        return out

    return frame


def _euler(task: Task) -> FrameFunction:
    x, y, z = angles = np.ascontiguousarray(task.points.T)
    out = np.empty_like(task.points)

    def frame(n: int) -> ArrayLike:
        (s0, s1, s2), (c0, c1, c2) = np.sin(angles), np.cos(angles)
        y1, z1 = c2 * y - s2 * z, s2 * y + c2 * z
        x2 = c1 * x + s1 * z1
        out[:, 0] = c0 * x2 - s0 * y1
        out[:, 1] = s0 * x2 + c0 * y1
        out[:, 2] = c1 * z1 - s1 * x
        return out

    return frame


PLAIN: tuple[Way, ...] = (
    Way(
        "copy (np.copyto)",
        "floor",
        "numpy",
        "numpy",
        "out",
        {"one axis": _copy, "own axis": _copy, "euler": _copy},
        rotates=False,
    ),
    Way(
        "plain numpy",
        "peer",
        "numpy",
        "numpy",
        "out",
        {"one axis": _one_axis, "own axis": _own_axis, "euler": _euler},
    ),
)
