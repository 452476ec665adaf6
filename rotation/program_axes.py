"""Convert points and rotations between the axes of programs: ROS, Unity, Unreal, OpenGL, OpenCV, Blender.

A convention says which signed axes point forward, left and up; conventions of Euler angles are in
:mod:`rotation.euler`. A change S between conventions of opposite handedness is not a rotation, but
``S·R·S⁻¹`` is a rotation for every rotation R, and a rigid motion for every rigid motion. The axes are taken
from the manuals of the programs.
"""

from __future__ import annotations

import numpy as np

from rotation.action import by_rows
from rotation.array_types import NUMPY, Array, ArrayLike
from rotation.batch import expect_rotations
from rotation.coordinates import join, length, split, unchanging
from rotation.errors import RotationError
from rotation.namespaces import expect_last, expect_numpy, floats, points_of, quiet, refuse_rows
from rotation.rigid import RigidTransform, expect_transforms
from rotation.rotation import Rotation

_STRAIGHT = 2.0**-40  # the sine of an invalid angle

# The directions forward, left and up in the axes x, y, z.
AXES = {
    "ros": ("+x", "+y", "+z"),
    "unity": ("+z", "-x", "+y"),
    "unreal": ("+x", "-y", "+z"),
    "opengl": ("-z", "-x", "+y"),
    "opencv": ("+z", "-x", "-y"),
    "blender": ("-y", "+x", "+z"),
    "ned": ("+x", "-y", "-z"),
}


def change_of_axes(source: str, target: str) -> Array:
    """Return the matrix (3, 3) that converts coordinates of one convention to another.

    Conventions are ``ros`` (x forward, y left, z up), ``unity`` and ``unreal`` (left-handed), ``opengl`` and
    ``opencv`` cameras, ``blender``, and ``ned`` (north, east, down, for a body that faces north); upper and
    lower case are equivalent.

    Raises
    ------
    RotationError
        No such convention.

    Examples
    --------
    >>> change_of_axes("ros", "opencv")
    array([[ 0., -1.,  0.],
           [ 0.,  0., -1.],
           [ 1.,  0.,  0.]])
    """
    first, second = (_basis(name) for name in (source, target))
    return np.asarray(second.T @ first)


@quiet
def convert_points(points: ArrayLike, source: str, target: str) -> Array:
    """Return points (…, 3) converted from one convention to another; see `change_of_axes`.

    A row that contains NaN or inf gives NaN in that row only.

    Examples
    --------
    >>> convert_points([1, 0, 0], "ros", "opencv") + 0.0  # forward
    array([0., 0., 1.])
    """
    expect_numpy("convert_points", points)
    v = points_of(points, NUMPY)
    c = split(v)
    spoilt = unchanging(NUMPY, c)
    image = by_rows(change_of_axes(source, target).astype(v.dtype), c)
    return join(NUMPY, tuple(x + spoilt for x in image))


def convert_rotation(rotation: Rotation, source: str, target: str) -> Rotation:
    """Return rotations converted from one convention to another; see `change_of_axes`.

    ``convert_points(r.apply(v)) == convert_rotation(r).apply(convert_points(v))``.

    Examples
    --------
    >>> left = Rotation.from_euler("Z", 90, degrees=True)  # to the left, in ROS
    >>> convert_rotation(left, "ros", "unity").as_rotvec(degrees=True).round(9) + 0.0
    array([  0., -90.,   0.])
    """
    expect_rotations(rotation=rotation)
    expect_numpy("convert_rotation", rotation._q)
    s = change_of_axes(source, target)
    hand = round(float(np.linalg.det(s)))
    q = rotation.as_quat()
    q[..., 1:] = hand * (q[..., 1:] @ s.T)
    return Rotation._of(q)


def convert_transform(transform: RigidTransform, source: str, target: str) -> RigidTransform:
    """Return rigid transforms converted from one convention to another; see `change_of_axes`.

    ``convert_points(t.apply(v)) == convert_transform(t).apply(convert_points(v))``.

    Examples
    --------
    >>> ahead = RigidTransform.from_translation([2, 0, 0])  # forward, in ROS
    >>> convert_transform(ahead, "ros", "unity").translation + 0.0
    array([0., 0., 2.])
    """
    expect_transforms(transform=transform)
    turn = convert_rotation(transform.rotation, source, target)
    return RigidTransform.from_components(
        convert_points(transform.translation, source, target), turn
    )


@quiet
def look_at(
    eye: ArrayLike, target: ArrayLike, up: ArrayLike = (0.0, 0.0, 1.0), convention: str = "opengl"
) -> RigidTransform:
    """Return the pose of a body at ``eye`` that faces ``target``, with its up axis as close to ``up`` as
    possible.

    Parameters
    ----------
    eye, target, up : array_like, shape (…, 3)
        In the axes of the world; the batch shapes broadcast.
    convention : str
        Which of the body's axes are forward, left and up; see `change_of_axes`. An ``opengl`` camera looks
        along −z, an ``opencv`` camera along z with y down, and a ``ros`` body along x.

    Returns
    -------
    RigidTransform
        It maps camera coordinates to world coordinates; its inverse is the "view matrix".

    Raises
    ------
    RotationError
        A target at the eye, or straight up or down from it; a left-handed convention.

    Examples
    --------
    >>> camera = look_at([0, -5, 0], [0, 0, 0], convention="opencv")
    >>> camera.apply([0, 0, 5]).round(12) + 0.0, camera.apply([0, 1, 0]) + 0.0  # five ahead; below
    (array([0., 0., 0.]), array([ 0., -5., -1.]))
    """
    own = _basis(convention)
    if np.linalg.det(own) < 0.0:
        raise RotationError(f"convention {convention!r} is left-handed: no rotation converts to it")
    expect_numpy("look_at", eye, target, up)
    at, to, above = (floats(v, n) for v, n in ((eye, "eye"), (target, "target"), (up, "up")))
    for v, name in ((at, "eye"), (to, "target"), (above, "up")):
        expect_last(v, (3,), name)
    forward = _directed(to - at, "the target", "is where the eye is")
    left = np.cross(_directed(above, "up", "is zero"), forward)
    refuse_rows(
        length(NUMPY, split(left)) <= _STRAIGHT, "the target", "is straight up or down from the eye"
    )
    left = _directed(left, "the target", "is straight up or down from the eye")
    axes = np.stack(np.broadcast_arrays(forward, left, np.cross(forward, left)), axis=-1)
    return RigidTransform.from_components(at, Rotation.from_matrix(axes @ own))


def _directed(v: Array, subject: str, fault: str) -> Array:
    refuse_rows(np.all(v == 0.0, axis=-1), subject, fault)
    return np.asarray(v / length(NUMPY, split(v))[..., None])


def _basis(name: str) -> Array:
    """Return the matrix whose rows are forward, left and up."""
    axes = AXES.get(name.lower()) if isinstance(name, str) else None
    if axes is None:
        raise RotationError(f"convention {name!r}: one of {', '.join(AXES)} is expected")
    rows = np.zeros((3, 3))
    for row, axis in enumerate(axes):
        rows[row, "xyz".index(axis[1])] = 1.0 if axis[0] == "+" else -1.0
    return rows
