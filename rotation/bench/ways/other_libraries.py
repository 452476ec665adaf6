"""Rotate points with other libraries, each by the fastest calls in its documentation."""

from __future__ import annotations

import numpy as np

from rotation.array_types import ArrayLike
from rotation.bench.tasks import Array, Task
from rotation.bench.ways.way import FrameFunction, Way


def _rotation_vectors(task: Task, frame: int) -> Array:
    """Return unit axes times their angles; all three libraries accept rotation vectors."""
    lengths = np.sqrt(np.einsum("ij,ij->i", task.axes, task.axes))
    angles = task.angles[frame : frame + len(task.points)]
    vectors: Array = task.axes * (angles / lengths)[:, None]
    return vectors


def _scipy_one_axis(task: Task) -> FrameFunction:
    from scipy.spatial.transform import Rotation

    return lambda n: Rotation.from_rotvec([0.0, 0.0, task.angles[n]]).apply(task.points)


def _scipy_own_axis(task: Task) -> FrameFunction:
    from scipy.spatial.transform import Rotation

    return lambda n: Rotation.from_rotvec(_rotation_vectors(task, n)).apply(task.points)


def _scipy_euler(task: Task) -> FrameFunction:
    from scipy.spatial.transform import Rotation

    return lambda n: Rotation.from_euler("ZYX", task.points).apply(task.points)


def _quaternionic_one_axis(task: Task) -> FrameFunction:
    import quaternionic

    def frame(n: int) -> ArrayLike:
        q = quaternionic.array.from_rotation_vector(np.array([0.0, 0.0, task.angles[n]]))
        turned: ArrayLike = q.rotate(task.points)
        return turned

    return frame


def _quaternionic_own_axis(task: Task) -> FrameFunction:
    """Rotate by products, since ``rotate`` combines all quaternions with all points."""
    import quaternionic

    points = quaternionic.array.from_vector_part(task.points)

    def frame(n: int) -> ArrayLike:
        q = quaternionic.array.from_rotation_vector(_rotation_vectors(task, n))
        turned: ArrayLike = (q * points * q.conjugate()).vector
        return turned

    return frame


def _quaternionic_euler(task: Task) -> FrameFunction:
    """Rotate by three quaternions, since ``from_euler_angles`` supports only ZYZ."""
    import quaternionic

    points = quaternionic.array.from_vector_part(task.points)

    def frame(n: int) -> ArrayLike:
        z, y, x = (quaternionic.array(rotor) for rotor in _rotors(task))
        q = z * y * x
        turned: ArrayLike = (q * points * q.conjugate()).vector
        return turned

    return frame


def _numpy_quaternion_one_axis(task: Task) -> FrameFunction:
    import quaternion

    def frame(n: int) -> ArrayLike:
        q = quaternion.from_rotation_vector(np.array([0.0, 0.0, task.angles[n]]))
        turned: ArrayLike = quaternion.rotate_vectors(q, task.points)
        return turned

    return frame


def _numpy_quaternion_own_axis(task: Task) -> FrameFunction:
    """Rotate by products, since ``rotate_vectors`` combines all quaternions with all points."""
    import quaternion

    points = quaternion.from_vector_part(task.points)

    def frame(n: int) -> ArrayLike:
        q = quaternion.from_rotation_vector(_rotation_vectors(task, n))
        turned: ArrayLike = quaternion.as_vector_part(q * points * q.conjugate())
        return turned

    return frame


def _numpy_quaternion_euler(task: Task) -> FrameFunction:
    """Rotate by three quaternions, since ``from_euler_angles`` supports only ZYZ."""
    import quaternion

    points = quaternion.from_vector_part(task.points)

    def frame(n: int) -> ArrayLike:
        z, y, x = (quaternion.as_quat_array(rotor) for rotor in _rotors(task))
        q = z * y * x
        turned: ArrayLike = quaternion.as_vector_part(q * points * q.conjugate())
        return turned

    return frame


def _rotors(task: Task) -> list[Array]:
    """Return the quaternions of rotations about z, y and x, scalar first, for Euler angles (n, 3)."""
    half = task.points / 2
    c, s = np.cos(half), np.sin(half)
    rotors = [np.zeros((len(half), 4)) for _ in range(3)]
    for n, rotor in enumerate(rotors):
        rotor[:, 0], rotor[:, 3 - n] = c[:, n], s[:, n]
    return rotors


PEERS: tuple[Way, ...] = (
    Way(
        "scipy",
        "peer",
        "scipy",
        "scipy",
        "new",
        {"one axis": _scipy_one_axis, "own axis": _scipy_own_axis, "euler": _scipy_euler},
    ),
    Way(
        "quaternionic",
        "peer",
        "quaternionic",
        "quaternionic",
        "new",
        {
            "one axis": _quaternionic_one_axis,
            "own axis": _quaternionic_own_axis,
            "euler": _quaternionic_euler,
        },
    ),
    Way(
        "numpy-quaternion",
        "peer",
        "quaternion",
        "numpy-quaternion",
        "new",
        {
            "one axis": _numpy_quaternion_one_axis,
            "own axis": _numpy_quaternion_own_axis,
            "euler": _numpy_quaternion_euler,
        },
    ),
)
