"""Four pipelines that compute the same motion (section 3.4), and their differences.

Each pipeline computes a unit quaternion or a matrix for each instant from the parameters, with the arithmetic
of the thesis; it is then applied to the points of the top.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from anim import attitude
from anim.checks import one_of
from anim.film import Clip
from anim.motion import Motion
from anim.timeline import Instants, Timeline
from rotation.matrices import R_x, R_y, R_z, to_matrix
from rotation.quaternions import T_q, product
from rotation.vectors import from_axis_angle

Floats = NDArray[np.float64]
Pipeline = Callable[[Timeline, Instants], Floats]

VERTICAL = np.array([0.0, 0.0, 1.0])
ABOUT = {"x": R_x, "y": R_y, "z": R_z}


def _spin_and_tilt(reading: Timeline, now: Instants) -> tuple[Floats, Floats]:
    """Return the first and the second quaternion, in the order in which they rotate the top."""
    spin, tilt = from_axis_angle(VERTICAL, now.spin), from_axis_angle(now.axes, now.angles)
    return (spin, tilt) if reading.order == "spin-first" else (tilt, spin)


def two_rotations(reading: Timeline, now: Instants) -> Floats:
    """Rotate by one quaternion and then by the other (3.4.1, spin3d); return matrices."""
    first, second = (q[:, None, :] for q in _spin_and_tilt(reading, now))
    turned = np.asarray(T_q(second, T_q(first, np.eye(3))))
    return np.swapaxes(turned, -1, -2)


def product_quaternion(reading: Timeline, now: Instants) -> Floats:
    """Multiply the quaternions and rotate once (3.4.2, Theorem 7, spin3dOptimized)."""
    first, second = _spin_and_tilt(reading, now)
    return np.asarray(product(second, first))


def product_matrix(reading: Timeline, now: Instants) -> Floats:
    """Compute the matrix of the product of the quaternions (3.4.4, spin3dMatrixRotationFromQuaternion)."""
    return np.asarray(to_matrix(product_quaternion(reading, now)))


def euler_matrices(reading: Timeline, now: Instants) -> Floats:
    """Multiply the matrix of the spin by that of the Euler angles (3.4.3, spin3dMatrixRotation)."""
    spin, tilt = np.asarray(R_z(now.spin)), np.eye(3)
    for axis, angles in zip(reading.euler, now.euler.T, strict=True):
        tilt = np.asarray(tilt @ ABOUT[axis](angles))
    return tilt @ spin if reading.order == "spin-first" else spin @ tilt


PIPELINES: Mapping[str, Pipeline] = MappingProxyType(
    {
        "quaternions": two_rotations,
        "product": product_quaternion,
        "euler": euler_matrices,
        "matrix": product_matrix,
    }
)


@dataclass(frozen=True)
class Kinematic:
    """The sampler of a pipeline over a timeline of ``seconds``."""

    pipeline: str
    reading: Timeline
    seconds: float

    def __call__(self, times: Floats) -> Floats:
        """Return the attitudes at ``times`` (n,): quaternions (n, 4) or matrices (n, 3, 3)."""
        now = self.reading.at(times / self.seconds, self.seconds)
        return PIPELINES[self.pipeline](self.reading, now)


def kinematic(
    pipeline: str = "quaternions", clip: Clip | None = None, reading: Timeline | None = None
) -> Motion:
    """Return the thesis's motion by one of :data:`PIPELINES`.

    Raises :class:`~anim.errors.AnimationError` for an unknown name.

    >>> motion = kinematic("product")
    >>> motion.frames, motion.duration, float(motion.tilts[-1].round(4))
    (500, 10.0, 0.3554)
    """
    one_of("model", pipeline, PIPELINES)
    film = clip or Clip()
    return Motion.sample(pipeline, film, Kinematic(pipeline, reading or Timeline(), film.seconds))


@dataclass(frozen=True, eq=False, repr=False)
class PipelineComparison:
    """The largest differences between the pipelines, in radians."""

    names: tuple[str, ...]
    attitudes: Floats
    """The greatest angle between the attitudes of two pipelines over all frames, (n, n)."""
    axes: Floats
    """The greatest angle between the axes of their tops, whatever the spin, (n, n)."""
    tilts: Floats
    """How far each top leans in the end, (n,)."""

    def agree(self, first: str, second: str) -> bool:
        """Return whether two pipelines give the same motion up to rounding (1e-12)."""
        pair = self.names.index(first), self.names.index(second)
        return bool(self.attitudes[pair] < 1e-12)

    def __str__(self) -> str:
        return self.table()

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        return self.table()

    def table(self) -> str:
        """Return the angles between the attitudes, and the tilts, as a Markdown table: in degrees, or radians
        if tiny.
        """
        rows = [
            f"| | {' | '.join(self.names)} | tilt in the end |",
            "|---" * (len(self.names) + 2) + "|",
        ]
        for name, angles, tilt in zip(self.names, self.attitudes, self.tilts, strict=True):
            rows.append(f"| {name} | {' | '.join(map(_angle, [*angles, tilt]))} |")
        return "\n".join(rows)


def compare(clip: Clip | None = None, reading: Timeline | None = None) -> PipelineComparison:
    """Return the largest differences between the four pipelines over the frames of ``clip``.

    >>> compare().agree("quaternions", "matrix"), compare().agree("product", "euler")
    (True, False)
    """
    film = clip or Clip()
    turned = [
        _turned_basis(Kinematic(name, reading or Timeline(), film.seconds)(film.times))
        for name in PIPELINES
    ]
    axes = [basis[:, :, 2] for basis in turned]
    return PipelineComparison(
        tuple(PIPELINES),
        _greatest(attitude.angle_between, turned),
        _greatest(attitude.angle_between_directions, axes),
        np.array([attitude.tilts(axis)[-1] for axis in axes]),
    )


def _turned_basis(values: Floats) -> Floats:
    """Return the images of the basis under each attitude, (n, 3, 3); a quaternion acts by q·x·q⁻¹."""
    if values.ndim == 3:
        return values
    return np.swapaxes(np.asarray(T_q(values[:, None, :], np.eye(3))), -1, -2)


def _greatest(angle: Callable[[Floats, Floats], Floats], values: list[Floats]) -> Floats:
    return np.array([[float(angle(p, q).max()) for q in values] for p in values])


def _angle(radians: float) -> str:
    degrees = np.degrees(radians)
    return f"{degrees:.2f}°" if degrees >= 0.01 else f"{radians:.0e}" if radians else "0"
