"""Davenport angles: Euler angles about any three axes, the second perpendicular to both others.

P. B. Davenport, "Rotations about nonorthogonal axes", AIAA Journal 11 (1973); read off as Euler angles are:
E. Bernardes and S. Viollet, PLoS ONE 17 (2022).
"""

import math
from typing import Any

import numpy as np

from rotation import quaternions, vectors
from rotation.angles import to_degrees
from rotation.arrays import real, require_nonzero
from rotation.coordinates import split
from rotation.coordinates import unit as unit_of
from rotation.errors import RotationError
from rotation.namespaces import Array, expect_last, expect_numpy, floats, quiet

_ORDERS = ("extrinsic", "e", "intrinsic", "i")
_ACROSS = 1e-7  # how far from perpendicular axes may be
_LOCK = 8.0 * float(np.finfo(np.float64).eps)


def checked_axes(axes: Any, order: str) -> tuple[Array, bool]:
    """Return the unit axes (n, 3), n at most 3, and whether they turn along.

    Raises
    ------
    RotationError
        Another shape or order, or axes next to each other that are not perpendicular.
    ZeroRotationError
        An axis is zero.
    """
    if not isinstance(order, str) or order.lower() not in _ORDERS:
        raise RotationError(f"order {order!r}: 'extrinsic' or 'intrinsic' is expected")
    a = floats(real(axes, "axes"), "axes")
    a = a[None, :] if a.ndim == 1 else a
    if a.ndim != 2 or a.shape[1] != 3 or not 1 <= len(a) <= 3:
        raise RotationError(
            f"axes has shape {a.shape}; one to three axes of three coordinates are expected"
        )
    require_nonzero(a, "axis")
    unit = np.stack(unit_of(np, split(a)), axis=-1)
    for n in range(1, len(unit)):
        if abs(float(unit[n] @ unit[n - 1])) > _ACROSS:
            raise RotationError(
                "axes next to each other must be perpendicular, else not all can be reached"
            )
    return unit, order.lower()[0] == "i"


@quiet
def from_davenport(axes: Any, order: str, angles: Any, degrees: bool = False) -> Array:
    """Return the unit quaternions of turns about one to three axes, by angles (…, n).

    For one axis also a number, or a one-dimensional array of angles.

    Raises
    ------
    RotationError
        Axes, an order or angles that do not fit.
    """
    unit, intrinsic = checked_axes(axes, order)
    expect_numpy("from_davenport", angles)
    a = floats(angles, "angles")
    if len(unit) == 1 and a.ndim < 2 and (a.ndim == 0 or a.shape[-1] != 1):
        a = a[..., None]
    expect_last(a, (len(unit),), f"angles about {len(unit)} axes")
    q: Any = None
    for n, axis in enumerate(unit):
        turn = vectors.from_axis_angle(axis, a[..., n], degrees)
        pair = (q, turn) if intrinsic else (turn, q)
        q = turn if q is None else quaternions.product(*pair)
    return q


@quiet
def to_davenport(
    q: Array, axes: Any, order: str, degrees: bool = False, tolerance: float = _LOCK
) -> tuple[Array, Array]:
    """Return the angles (…, 3) about three axes, and where they are in gimbal lock.

    The first and third lie in [−π, π]. With λ the angle about the second axis from the first to the third (of
    the extrinsic order), the second lies in [λ, λ + π] if λ ≤ 0, else in [λ − π, λ]: in [−π/2, π/2] for
    perpendicular axes, in [0, π] where the first is the third. In gimbal lock the third is 0.

    Raises
    ------
    RotationError
        Not three axes, or axes or an order that do not fit.
    """
    unit, intrinsic = checked_axes(axes, order)
    expect_numpy("as_davenport", q)
    if len(unit) != 3:
        raise RotationError("three axes are needed to hold every rotation")
    first, second, third = unit[::-1] if intrinsic else unit
    across = np.cross(first, second)
    lean = math.atan2(-float(across @ third), float(first @ third))
    # The third axis is the first, turned by λ about the second. Turned back by λ the rotation is one about
    # the first, the second by the angle less λ, and the first again.
    p = quaternions.product(vectors.from_axis_angle(second, -lean), q)
    u = p[..., 1:]
    a, b, c, d = p[..., 0], u @ first, u @ second, u @ across
    ab, cd = np.hypot(a, b), np.hypot(c, d)
    plus, minus = np.arctan2(b, a), np.arctan2(d, c)
    free = 1.0 if intrinsic else -1.0
    flat, upside = cd <= tolerance * ab, ab <= tolerance * cd
    minus, plus = np.where(flat, free * plus, minus), np.where(upside, free * minus, plus)
    start, end, middle = plus - minus, plus + minus, 2.0 * np.arctan2(cd, ab)
    if lean > 1e-12:  # the same rotation, by the opposite turn about the second axis
        middle, turned = -middle, ~(flat | upside)
        start, end = np.where(turned, start + math.pi, start), np.where(turned, end - math.pi, end)
    start, end = (np.remainder(x + math.pi, 2.0 * math.pi) - math.pi for x in (start, end))
    middle = middle + lean
    angles = np.stack([end, middle, start] if intrinsic else [start, middle, end], axis=-1)
    return (to_degrees(np, angles) if degrees else angles), flat | upside
