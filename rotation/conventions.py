"""From the axes of one program to those of another: which way is forward, left and up, and which hand.

A convention is three signed axes. A change between two of opposite hands is no rotation; what it makes
of a rotation R still is, ``S·R·S⁻¹``, and of a rigid motion one again. The axes are those that the programs'
own manuals state.
"""

from typing import Any

import numpy as np

from rotation.arrays import real
from rotation.batch import expect_rotations
from rotation.errors import RotationError
from rotation.namespaces import Array, expect_last, expect_numpy
from rotation.rigid import RigidTransform, expect_transforms
from rotation.rotation import Rotation

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
    """Return the matrix (3, 3) that takes coordinates of one convention to those of another.

    Conventions: ``ros`` (x forward, y left, z up), ``unity`` and ``unreal`` (left-handed), ``opengl`` and
    ``opencv`` cameras, ``blender``, ``ned`` (north, east, down, for a body that faces north); in letters of
    either case.

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


def convert_points(points: Any, source: str, target: str) -> Array:
    """Return points (…, 3) of one convention in another; see `change_of_axes`.

    Examples
    --------
    >>> convert_points([1, 0, 0], "ros", "opencv") + 0.0  # forward
    array([0., 0., 1.])
    """
    expect_numpy("convert_points", points)
    v = real(points, "points")
    expect_last(v, (3,), "points")
    return np.asarray(v @ change_of_axes(source, target).T.astype(v.dtype))


def convert_rotation(rotation: Rotation, source: str, target: str) -> Rotation:
    """Return rotations of one convention in another; see `change_of_axes`.

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
    """Return rigid transforms of one convention in another; see `change_of_axes`.

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


def _basis(name: str) -> Array:
    """The rows are forward, left and up."""
    axes = AXES.get(name.lower()) if isinstance(name, str) else None
    if axes is None:
        raise RotationError(f"convention {name!r}: one of {', '.join(AXES)} is expected")
    rows = np.zeros((3, 3))
    for row, axis in enumerate(axes):
        rows[row, "xyz".index(axis[1])] = 1.0 if axis[0] == "+" else -1.0
    return rows
