"""Rotate many points in one pass over memory: by axis and angle, by quaternion, by Euler angles.

Nothing is built in between: no matrices, no temporary quaternions. The points' dtype decides the
result: float32 and float64 are kept, integers become float64, anything else raises. Batches broadcast
by numpy's rules; any strides are taken. ``out`` may be the points themselves. A row with NaN or inf in
it gives NaN in that row alone. See docs/developers/rotation-kernels.md for accuracy, threads and caching.
"""

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
from rotation.arrays import (
    Array,
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
        Counterclockwise seen against the axis. The sine is right to 2⁻⁵² at any size.
    out : ndarray, optional
        Where to write the result: the points themselves, or memory that overlaps no argument.
    layout : {"aos", "soa"}
        Whether components come last or first, in points, axis and out alike.
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
        A zero axis, with its row. Where ``out`` is the points themselves they are left as they were.
    DTypeError, ForeignArrayError
        Points, axes or angles that are not real numpy arrays.

    Examples
    --------
    >>> rotate([1, 0, 0], [0, 0, 1], 90, degrees=True).round(15)
    array([0., 1., 0.])
    """
    p, points_batch = components(points, 3, "points", layout)
    a, axis_batch = components(axis, 3, "axis", layout)
    t = real(angle, "angle")
    batch = common_batch(points=points_batch, axis=axis_batch, angle=t.shape)
    result, target = destination(out, batch, p, (a, t), layout)
    degrees = bool(degrees)
    if a.size == 3 and t.size == 1:
        require_nonzero(a, "axis")
        axis, angle = (x.astype(np.float64, copy=False) for x in (a.reshape(3), t.reshape(())))
        _turn_all(p, FROM_AXIS_ANGLE[degrees](axis, angle), target)
        return result
    if result.size <= 3 * FEW_SINES:
        if write(ABOUT_AXIS[degrees], target, *_checked(out, p, a), t, p):
            require_nonzero(a, "axis")
        return result
    if _in_place(out, p) and kernels.contains_zero(a):
        require_nonzero(a, "axis")
    if kernels.axis_angle(p, a, t, target, degrees):
        require_nonzero(a, "axis")
    return result


def rotate_quat(
    points: npt.ArrayLike,
    q: "npt.ArrayLike | Batch",
    out: Array | None = None,
    layout: Layout = "aos",
) -> Array:
    """Rotate points by quaternions, ``v ↦ q v q⁻¹`` (thesis, section 2.2.5, Theorem 6).

    Parameters
    ----------
    points : array_like, shape (…, 3), or (3, …) for ``layout="soa"``
    q : array_like, shape (…, 4), or (4, …) for ``layout="soa"``
        Scalar first, of any length but zero: the length makes no difference. A `Rotation` is taken too.
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
    p, points_batch = components(points, 3, "points", layout)
    if isinstance(q, Batch):
        expect_numpy("rotate_quat", q._q)
        r, q_batch = q._double, q.shape
    else:
        r, q_batch = components(q, 4, "q", layout)
    batch = common_batch(points=points_batch, q=q_batch)
    result, target = destination(out, batch, p, (r,), layout)
    if r.size == 4:
        _turn_all(p, normalised(r.reshape(4)), target)
        return result
    if result.size <= 3 * FEW_OWN:
        write(BY_QUATERNION, target, normalised(r), p)
        return result
    if _in_place(out, p) and kernels.contains_zero(r):
        require_nonzero(r, "quaternion")
    if kernels.quaternions(p, r, target):
        require_nonzero(r, "quaternion")
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
    p, points_batch = components(points, 3, "points", layout)
    a, angles_batch = components(angles, len(axes), f"angles for {seq!r}", layout)
    batch = common_batch(points=points_batch, angles=angles_batch)
    result, target = destination(out, batch, p, (a,), layout)
    turns, degrees = axes[::-1] if intrinsic else axes, bool(degrees)
    if result.size <= 3 * FEW_SINES:
        write(by_euler(turns, intrinsic, degrees), target, a, p)
        return result
    kernels.euler(p, a, turns, intrinsic, target, degrees)
    return result


def _checked(out: Array | None, points: Array, axes: Array) -> tuple[Array, ...]:
    if _in_place(out, points):
        require_nonzero(axes, "axis")
    return (axes,)


def _in_place(out: Array | None, points: Array) -> bool:
    """Tell whether an error found on the way would leave the caller's points half rotated."""
    return out is not None and np.may_share_memory(out, points)


def _turn_all(points: Array, q: Array, target: Array) -> None:
    """Turn all points by one unit quaternion."""
    m = TO_MATRIX(q.astype(np.float64, copy=False))
    if target.size <= 3 * FEW:
        write(BY_MATRIX, target, m, points)
    else:
        kernels.one(points, m, target)
