"""The implementation of the thesis (3.1): point by point, with lists of three numbers."""

from __future__ import annotations

import numpy as np

from rotation import thesis
from rotation.bench.tasks import Task
from rotation.bench.ways.way import FrameFunction, Way


def _quaternion_one_axis(task: Task) -> FrameFunction:
    points, axis, turn = task.points.tolist(), [0.0, 0.0, 1.0], thesis.rotationquaternion
    angles = task.angles.tolist()
    return lambda n: [turn(angles[n], axis, point) for point in points]


def _quaternion_own_axis(task: Task) -> FrameFunction:
    points, axes = task.points.tolist(), task.axes.tolist()
    angles, length, turn = task.angles.tolist(), len(points), thesis.rotationquaternionNormalized
    return lambda n: [
        turn(angle, axis, point)
        for angle, axis, point in zip(angles[n : n + length], axes, points, strict=True)
    ]


def _matrix_one_axis(task: Task) -> FrameFunction:
    points, angles, turn = task.points.tolist(), task.angles.tolist(), thesis.rotationbyMatrix

    def frame(n: int) -> list[list[float]]:
        matrix = thesis.rotationMatrixZYX(angles[n], 0.0, 0.0)
        return [turn(matrix, point) for point in points]

    return frame


def _matrix_euler(task: Task) -> FrameFunction:
    points, turn, matrix = task.points.tolist(), thesis.rotationbyMatrix, thesis.rotationMatrixZYX
    return lambda n: [turn(matrix(*point), point) for point in points]


def _matmul_one_axis(task: Task) -> FrameFunction:
    points, angles, turn = task.points.tolist(), task.angles.tolist(), thesis.rotationbyMatrix

    def frame(n: int) -> list[list[float]]:
        matrix = thesis.rotationMatrixZYX(angles[n], 0.0, 0.0, matmul=np.matmul)
        return [turn(matrix, point, matmul=np.matmul) for point in points]

    return frame


def _matmul_euler(task: Task) -> FrameFunction:
    points, turn, matrix = task.points.tolist(), thesis.rotationbyMatrix, thesis.rotationMatrixZYX
    return lambda n: [
        turn(matrix(*point, matmul=np.matmul), point, matmul=np.matmul) for point in points
    ]


PRINTED: tuple[Way, ...] = (
    Way(
        "thesis, quaternion",
        "thesis",
        "rotation",
        "hfield",
        "new",
        {"one axis": _quaternion_one_axis, "own axis": _quaternion_own_axis},
        slow=True,
    ),
    Way(
        "thesis, matrix on lists",
        "thesis",
        "rotation",
        "hfield",
        "new",
        {"one axis": _matrix_one_axis, "euler": _matrix_euler},
        slow=True,
    ),
    Way(
        "thesis, matrix by np.matmul",
        "thesis",
        "rotation",
        "hfield",
        "new",
        {"one axis": _matmul_one_axis, "euler": _matmul_euler},
        slow=True,
    ),
)
