"""Rotate many points in one pass over memory: by axis and angle, by quaternion, by Euler angles.

No intermediate matrices or quaternions are stored. The dtype of the points determines that of the result:
float32 and float64 are kept, integers become float64, any other dtype raises an error. Batches broadcast by
numpy's rules, and strides are arbitrary. ``out`` may be the points themselves. NaN or inf in a row gives NaN
in that row only. See docs/developers/rotation-kernels.md for accuracy, threads and caching.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from rotation import kernels
from rotation.action import (
    ABOUT_AXIS,
    BY_MATRIX,
    BY_QUATERNION,
    FEW,
    FEW_OWN,
    FEW_SINES,
    by_euler,
    write,
)
from rotation.array_types import Array
from rotation.arrays import (
    Layout,
    common_batch,
    components,
    destination,
    real,
    require_nonzero,
)
from rotation.batch import Batch
from rotation.euler import sequence
from rotation.matrices import TO_MATRIX
from rotation.namespaces import expect_numpy
from rotation.quaternions import normalised
from rotation.vectors import FROM_AXIS_ANGLE


def rotate(
    points: npt.ArrayLike,
    axis: npt.ArrayLike,
    angle: npt.ArrayLike,
    out: Array | None = None,
    layout: Layout = "aos",
    degrees: bool = False,
) -> Array:
    """Rotate points about axes through the origin (thesis, section 2.2, Theorem 5).

    Parameters
    ----------
    points, axis : array_like, shape (…, 3), or (3, …) for ``layout="soa"``
        An axis may have any length but zero, from the smallest float to the largest.
    angle : array_like, shape (…)
        Counterclockwise when the axis points at the viewer. The sine is accurate to 2⁻⁵² for angles of any
        size.
    out : ndarray, optional
        The array for the result: the points themselves, or memory that does not overlap any argument.
    layout : {"aos", "soa"}
        Whether components come last or first; this applies to points, axis and out.
    degrees : bool
        The angles are in degrees, not radians.

    Returns
    -------
    ndarray
        ``out``, or a new array; ‖error‖₂ ≤ 5·2⁻⁵²·‖v‖ in float64, as docs/explanation/rotation-errors.md
        proves. In float32 it is 2⁻²⁴·‖v‖, and 5·2⁻²³·‖v‖ for one axis and angle.

    Raises
    ------
    RotationError
        Shapes that do not fit together; ``out`` of another shape, read-only or overlapping in part.
    ZeroRotationError
        A zero axis; the message names its row. If ``out`` is the points themselves, they are unchanged.
    DTypeError, ForeignArrayError
        Points, axes or angles that are not real numpy arrays.

    Examples
    --------
    >>> rotate([1, 0, 0], [0, 0, 1], 90, degrees=True).round(15)
    array([0., 1., 0.])
    """
    points = components(points, 3, "points", layout)
    axis = components(axis, 3, "axis", layout)
    angle = real(angle, "angle")
    batch = common_batch(points=points.shape[:-1], axis=axis.shape[:-1], angle=angle.shape)
    result, target = destination(out, batch, points, (axis, angle), layout)
    in_place = out is not None and np.may_share_memory(out, points)  # then nothing may fail halfway
    degrees = bool(degrees)
    if axis.size == 3 and angle.size == 1:
        require_nonzero(axis, "axis")
        axis, angle = axis.reshape(3).astype(np.float64), angle.reshape(()).astype(np.float64)
        _turn_all(points, FROM_AXIS_ANGLE[degrees](axis, angle), target)
    elif result.size <= 3 * FEW_SINES:
        if in_place:
            require_nonzero(axis, "axis")
        if write(ABOUT_AXIS[degrees], target, axis, angle, points):
            require_nonzero(axis, "axis")
    else:
        if in_place and kernels.contains_zero(axis):
            require_nonzero(axis, "axis")
        if kernels.axis_angle(points, axis, angle, target, degrees):
            require_nonzero(axis, "axis")
    return result


def rotate_quat(
    points: npt.ArrayLike,
    q: npt.ArrayLike | Batch,
    out: Array | None = None,
    layout: Layout = "aos",
) -> Array:
    """Rotate points by quaternions, ``v ↦ q v q⁻¹`` (thesis, section 2.2.5, Theorem 6).

    Parameters
    ----------
    points : array_like, shape (…, 3), or (3, …) for ``layout="soa"``
    q : array_like, shape (…, 4), or (4, …) for ``layout="soa"``
        Scalar first, of any nonzero length, which has no effect. A `Rotation` is also accepted.
    out, layout
        As in `rotate`.

    Returns
    -------
    ndarray
        ``out``, or a new array; ‖error‖₂ ≤ 5·2⁻⁵²·‖v‖ in float64. In float32 it is 2⁻²⁴·‖v‖, and
        5·2⁻²³·‖v‖ for one quaternion.

    Raises
    ------
    ZeroRotationError
        A zero quaternion, with its row.
    RotationError, DTypeError, ForeignArrayError
        As in `rotate`.

    Examples
    --------
    >>> rotate_quat([1, 0, 0], [1, 1, 1, 1]).round(15)
    array([0., 1., 0.])
    """
    points = components(points, 3, "points", layout)
    if isinstance(q, Batch):
        expect_numpy("rotate_quat", q._q)
    quaternions: Array = q._double if isinstance(q, Batch) else components(q, 4, "q", layout)
    batch = common_batch(points=points.shape[:-1], q=quaternions.shape[:-1])
    result, target = destination(out, batch, points, (quaternions,), layout)
    if quaternions.size == 4:
        _turn_all(points, normalised(quaternions.reshape(4)), target)
    elif result.size <= 3 * FEW_OWN:
        write(BY_QUATERNION, target, normalised(quaternions), points)
    else:
        in_place = out is not None and np.may_share_memory(out, points)
        if in_place and kernels.contains_zero(quaternions):
            require_nonzero(quaternions, "quaternion")
        if kernels.quaternions(points, quaternions, target):
            require_nonzero(quaternions, "quaternion")
    return result


def rotate_euler(
    points: npt.ArrayLike,
    angles: npt.ArrayLike,
    seq: str = "ZYX",
    out: Array | None = None,
    layout: Layout = "aos",
    degrees: bool = False,
) -> Array:
    """Rotate points by Euler angles, in any of the 24 conventions (thesis, sections 2.2.2 to 2.2.4).

    Parameters
    ----------
    points : array_like, shape (…, 3), or (3, …) for ``layout="soa"``
    angles : array_like, shape (…, len(seq)), or (len(seq), …) for ``layout="soa"``
        In the order of the letters.
    seq : str
        Uppercase is intrinsic, ``ZYX = R_z(a₀) R_y(a₁) R_x(a₂)``; lowercase is extrinsic,
        ``zyx = R_x(a₂) R_y(a₁) R_z(a₀)``. One or two letters are taken too.
    out, layout
        As in `rotate`.
    degrees : bool
        The angles are in degrees.

    Returns
    -------
    ndarray
        ``out``, or a new array.

    Raises
    ------
    RotationError, DTypeError, ForeignArrayError
        A sequence that does not exist; otherwise as in `rotate`.

    Examples
    --------
    >>> rotate_euler([1, 0, 0], [90, 0, 0], degrees=True).round(15) + 0.0
    array([0., 1., 0.])
    """
    axes, intrinsic = sequence(seq)
    points = components(points, 3, "points", layout)
    angles = components(angles, len(axes), f"angles for {seq!r}", layout)
    batch = common_batch(points=points.shape[:-1], angles=angles.shape[:-1])
    result, target = destination(out, batch, points, (angles,), layout)
    turns, degrees = axes[::-1] if intrinsic else axes, bool(degrees)
    if result.size <= 3 * FEW_SINES:
        write(by_euler(turns, intrinsic, degrees), target, angles, points)
    else:
        kernels.euler(points, angles, turns, intrinsic, target, degrees)
    return result


def _turn_all(points: Array, q: Array, target: Array) -> None:
    """Turn all points by one unit quaternion."""
    m = TO_MATRIX(q.astype(np.float64, copy=False))
    if target.size <= 3 * FEW:
        write(BY_MATRIX, target, m, points)
    else:
        kernels.one(points, m, target)
