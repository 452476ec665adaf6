"""Everything that is compiled on first use, compiled now."""

import numpy as np

from rotation import kernels
from rotation.fused import rotate, rotate_euler, rotate_quat
from rotation.interpolation import slerp, squad
from rotation.rotation import Rotation

_PRECISIONS = (np.float64, np.float32)


def warm_up() -> None:
    """Compile everything that would be compiled on first use, and keep it on disk where that can be done.

    Each formula and each loop takes some hundredths of a second, once on a machine. Nothing of this is
    needed: calls compile what they miss, such as a loop for arrays with other strides.

    Examples
    --------
    >>> import rotation
    >>> rotation.warm_up()  # doctest: +SKIP
    """
    q = np.tile([1.0, 2.0, 3.0, 4.0], (3, 1))
    points, angles = q[:, 1:], q[:, 0]
    r = Rotation(q)
    (r * r, r**0.5, r.inv(), r.magnitude(), r.apply(points), r.apply(points, inverse=True))
    (
        r.as_matrix(),
        r.as_mrp(),
        r.as_quat(canonical=True),
        r[0].apply(points),
        slerp(r, r, 0.5),
        squad(r, r, r, r, 0.5),
    )
    for kind in _PRECISIONS:  # each with its own tolerance
        Rotation.from_matrix(r.as_matrix().astype(kind))
    Rotation.from_matrix(r.as_matrix(), orthonormalize=True)
    Rotation.from_mrp(r.as_mrp())
    for degrees in (False, True):
        Rotation.from_rotvec(r.as_rotvec(degrees), degrees)
        Rotation.from_axis_angle(*r.as_axis_angle(degrees), degrees)
        Rotation.from_euler("ZYX", r.as_euler("ZYX", degrees), degrees)
    rotate(points, points, angles)
    rotate_quat(points, q)
    rotate_euler(points, points)
    for points_kind in _PRECISIONS:
        for turn in (np.ascontiguousarray, np.asfortranarray):
            v = turn(points.astype(points_kind))
            out = np.empty_like(v)
            kernels.one(v, np.eye(3), out)
            for kind in _PRECISIONS if points_kind is np.float32 else (np.float64,):
                p, t, n = turn(points.astype(kind)), angles.astype(kind), turn(q.astype(kind))
                kernels.axis_angle(v, p, t, out)
                kernels.quaternions(v, n, out)
                kernels.euler(v, p, (2, 1, 0), True, out)
    for kind in _PRECISIONS:
        kernels.contains_zero(q.astype(kind))
        kernels.contains_zero(points.astype(kind))
    kernels.cumulative(q)
