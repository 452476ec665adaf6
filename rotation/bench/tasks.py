"""The two tests of the thesis (3.2.1): the computation of each frame, and its expected result.

The points are uniformly distributed in the unit cube, as in the thesis (``random()``), drawn by numpy from a
fixed seed; or they are the user's own points.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from hfield.core.product import Constants, Coordinates, conjugate, multiply

Array = NDArray[np.float64]
Kind = Literal["one axis", "own axis", "euler"]

H = Constants(-1.0, 0.0, -1.0)
SEED = 20_170_228


@dataclass(frozen=True)
class Task:
    """The input of one test, independent of the implementation.

    ``points`` has the shape (n, 3). *one axis*: frame f rotates all points about z by ``angles[f]``. *own
    axis*: it rotates point i about ``axes[i]``, of any length, by ``angles[f + i]``, so that no frame repeats
    another. *euler*: it rotates point i by R_z(a₀)·R_y(a₁)·R_x(a₂), where a is the point itself.

    One additional frame, number ``frames``, is used to check an implementation: its angle is not a multiple
    of π/2.
    """

    kind: Kind
    frames: int
    points: Array
    angles: Array
    axes: Array

    @property
    def check(self) -> int:
        """The number of the frame used for checking."""
        return self.frames

    def part(self, start: int, stop: int) -> Task:
        """Return the same task for the points from ``start`` up to but excluding ``stop``."""
        rows = slice(start, stop)
        angles = self.angles if self.kind == "one axis" else self.angles[start : stop + self.frames]
        return Task(self.kind, self.frames, self.points[rows], angles, self.axes[rows])

    def expected(self, frame: int) -> Array:
        """Return the points after ``frame``, as the products q·v·q̄ of :mod:`hfield.core.product`."""
        if self.kind == "one axis":
            q = half_turn(np.array([0.0, 0.0, 1.0]), self.angles[frame])
        elif self.kind == "own axis":
            q = half_turn(self.axes, self.angles[frame : frame + len(self.points)])
        else:
            z, y, x = (
                half_turn(axis, angle)
                for axis, angle in zip(np.eye(3)[::-1], self.points.T, strict=True)
            )
            q = multiply(H, z, multiply(H, y, x))
        point = (np.zeros(len(self.points)), *self.points.T)
        return np.stack(multiply(H, multiply(H, q, point), conjugate(H, q))[1:], axis=-1)


def half_turn(axis: Array, angle: float | Array) -> Coordinates:
    """Return the coordinates of cos(angle/2) + sin(angle/2)·u, where u is the direction of ``axis``
    (…, 3).
    """
    s = np.sin(angle / 2) / np.linalg.norm(axis, axis=-1)
    return np.cos(angle / 2), s * axis[..., 0], s * axis[..., 1], s * axis[..., 2]


@dataclass(frozen=True)
class Test:
    """One test: its name, whose first letter is its number in the thesis, and its input.

    ``printed`` is the mean measured in the thesis, for 550 000 points and 300 frames. ``make`` takes the
    number of points, or the points, and the number of frames.
    """

    __test__ = False  # no test for pytest to collect

    name: str
    title: str
    what: str
    printed: str
    make: Callable[[int | Array, int], Task]


def _cloud(points: int | Array, rng: np.random.Generator) -> Array:
    return rng.random((points, 3)) if isinstance(points, int) else points


def _one_axis(points: int | Array, frames: int) -> Task:
    cloud = _cloud(points, np.random.default_rng(SEED))
    angles = np.append(np.linspace(0, 2 * np.pi, frames), 1.0)
    return Task("one axis", frames, cloud, angles, cloud[:0])


def _own_axis(points: int | Array, frames: int) -> Task:
    rng = np.random.default_rng(SEED)
    cloud = _cloud(points, rng)
    return Task(
        "own axis",
        frames,
        cloud,
        rng.random(len(cloud) + frames),
        rng.standard_normal(cloud.shape),
    )


def _itself(points: int | Array, frames: int) -> Task:
    task = _own_axis(points, frames)
    return Task(task.kind, frames, task.points, task.angles, task.points)


def _euler(points: int | Array, frames: int) -> Task:
    task = _one_axis(points, frames)
    return Task("euler", frames, task.points, task.angles, task.axes)


TESTS: tuple[Test, ...] = (
    Test(
        "1",
        "Test 1: one axis",
        "Each frame turns all points about the z axis by one angle of linspace(0, 2π, frames).",
        "434.9 s a run by quaternions, 385.2 s by matrices",
        _one_axis,
    ),
    Test(
        "2 quaternion, as printed",
        "Test 2, quaternion model, as printed",
        "Each point turns about the axis x/|x| where x is the point itself, so nothing moves.",
        "444.5 s a run",
        _itself,
    ),
    Test(
        "2 quaternion, own axes",
        "Test 2, quaternion model, independent axes",
        "Each point turns about a random axis of its own: the test that the thesis means.",
        "",
        _own_axis,
    ),
    Test(
        "2 matrix",
        "Test 2, matrix model",
        "Each point turns by R_z(x₁)·R_y(x₂)·R_x(x₃), the Euler angle equal to the point itself.",
        "1763.7 s a run",
        _euler,
    ),
)
