"""Screws: every rigid motion is a turn about a line and a shift along it.

M. Chasles, Bull. Sci. Math. Férussac 14 (1830); R. S. Ball, "A treatise on the theory of screws" (1900).
"""

from typing import Any, NamedTuple

from rotation.acting import BY_QUATERNION
from rotation.angles import to_degrees
from rotation.arrays import common_batch
from rotation.coordinates import join, length, split, unit
from rotation.namespaces import Array, expect_last, floats, namespace, quiet, refuse_zeros
from rotation.vectors import cross, from_axis_angle, to_axis_angle


class Screw(NamedTuple):
    """A motion along a screw: directions (…, 3), points of the lines (…, 3), angles and displacements (…).

    Examples
    --------
    >>> from rotation import RigidTransform
    >>> RigidTransform.from_translation([0, 0, 2]).as_screw().displacement
    np.float64(2.0)
    """

    axis: Array
    point: Array
    angle: Array
    displacement: Array


@quiet
def from_screw(
    axis: Any, point: Any, angle: Any, displacement: Any, degrees: bool = False
) -> tuple[Array, Array]:
    """Return quaternions and translations of screws; see `RigidTransform.from_screw`."""
    xp = namespace(axis, point, angle, displacement)
    a, p = floats(axis, "axes", xp), floats(point, "points", xp)
    expect_last(a, (3,), "axes")
    expect_last(p, (3,), "points")
    d = floats(displacement, "displacements", xp)
    refuse_zeros(a, "axis")
    t = floats(angle, "angles", xp)
    common_batch(
        axis=tuple(a.shape[:-1]),
        point=tuple(p.shape[:-1]),
        angle=tuple(t.shape),
        displacement=tuple(d.shape),
    )
    q = from_axis_angle(a, t, degrees)
    along = join(xp, unit(xp, split(a)))
    return q, p - BY_QUATERNION(q, p) + d[..., None] * along


@quiet
def to_screw(q: Array, t: Array, degrees: bool = False) -> Screw:
    """Return the screws of motions (q, t), of angles in [0, π].

    The point is the one of the line nearest to the origin. Where nothing turns the axis is the direction
    of the shift and the line goes through the origin; the identity has the axis z.
    """
    xp = namespace(q)
    axis, angle = to_axis_angle(q)
    u, s = split(axis), split(t)
    shift = length(xp, s)
    still = angle == 0.0
    pure = still & (shift > 0.0)
    way = unit(xp, tuple(xp.where(pure, b, xp.ones_like(b)) for b in s))
    u = tuple(xp.where(pure, b, a) for a, b in zip(u, way, strict=True))
    along = sum((a * b for a, b in zip(u, s, strict=True)), 0.0 * shift)
    half = 0.5 * xp.where(still, xp.ones_like(angle), angle)
    sine, cosine = xp.sin(half), xp.cos(half)
    across = tuple(b - along * a for a, b in zip(u, s, strict=True))
    point = tuple(
        xp.where(still, 0.0 * a, 0.5 * (a + cosine * b / sine))
        for a, b in zip(across, cross(u, across), strict=True)
    )
    return Screw(join(xp, u), join(xp, point), to_degrees(xp, angle) if degrees else angle, along)
