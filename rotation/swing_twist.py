"""Swing and twist: a rotation about a given axis, followed by one about a perpendicular axis."""

from __future__ import annotations

from rotation.array_types import ArrayLike
from rotation.arrays import common_batch
from rotation.batch import expect_rotations
from rotation.coordinates import join, split, unit
from rotation.namespaces import expect_last, floats, namespace, quiet, refuse_zeros
from rotation.rotation import Rotation


@quiet
def swing_twist(rotation: Rotation, axis: ArrayLike) -> tuple[Rotation, Rotation]:
    """Return swing and twist: ``rotation == swing * twist``, twist about ``axis``, swing perpendicular to it.

    Parameters
    ----------
    rotation : Rotation, shape (…)
    axis : array_like, shape (…, 3)
        Of any length but 0; the batch shapes broadcast.

    Returns
    -------
    swing, twist : Rotation
        The twist is the rotation about the axis that is nearest to the given rotation. For a half turn about
        a perpendicular axis all are equally near; then the twist is the identity. P. Dobrowolski,
        "Swing-twist decomposition in Clifford algebra", 2015.

    Raises
    ------
    RotationError
        An axis is zero, or shapes that do not fit.

    Examples
    --------
    >>> swing, twist = swing_twist(Rotation.from_euler("ZX", [30, 40], degrees=True), [0, 0, 1])
    >>> twist.as_rotvec(degrees=True).round(9) + 0.0
    array([ 0.,  0., 30.])
    """
    expect_rotations(rotation=rotation)
    xp = namespace(rotation._q, axis)
    a = floats(axis, "axes", xp)
    expect_last(a, (3,), "axes")
    refuse_zeros(a, "axis")
    common_batch(rotations=rotation.shape, axes=tuple(a.shape[:-1]))
    w, x, y, z = split(rotation._q)
    u, v, s = unit(xp, split(a))
    along = x * u + y * v + z * s
    w = w + 0.0 * along
    tiny = 8.0 * float(xp.finfo(along.dtype).eps)
    none = (xp.abs(w) <= tiny) & (xp.abs(along) <= tiny)
    w, along = xp.where(none, xp.ones_like(w), w), xp.where(none, xp.zeros_like(w), along)
    twist = Rotation._of(join(xp, unit(xp, (w, along * u, along * v, along * s))))
    return rotation * twist.inv(), twist
