"""Davenport angles: Euler angles about any three axes, the second perpendicular to the others.

P. B. Davenport, "Rotations about nonorthogonal axes", AIAA Journal 11 (1973). They are computed from a
quaternion as Euler angles are: E. Bernardes and S. Viollet, PLoS ONE 17 (2022).
"""

from __future__ import annotations

import math
from functools import cache, reduce

import numpy as np

from rotation.angles import to_degrees, waves
from rotation.array_types import Array, ArrayLike
from rotation.arrays import common_batch, real, require_nonzero
from rotation.coordinates import Coordinates, join, length, split, unit
from rotation.errors import RotationError
from rotation.namespaces import expect_last, expect_numpy, floats, namespace, refuse_rows
from rotation.quaternions import multiplied, steadied
from rotation.rowwise import RowFormula
from rotation.vectors import cross

_ORDERS = ("extrinsic", "e", "intrinsic", "i")
_ACROSS = 1e-7  # how far from perpendicular axes may be
_LOCK = 8.0 * float(np.finfo(np.float64).eps)


def checked_axes(axes: ArrayLike, order: str) -> tuple[Array, bool]:
    """Return the unit axes (…, n, 3), n at most 3, and whether they are intrinsic (rotate with the body).

    Raises
    ------
    RotationError
        Another shape or order, or consecutive axes that are not perpendicular.
    ZeroRotationError
        An axis is zero.
    """
    if not isinstance(order, str) or order.lower() not in _ORDERS:
        raise RotationError(f"order {order!r}: 'extrinsic' or 'intrinsic' is expected")
    a = floats(real(axes, "axes"), "axes")
    a = a[None, :] if a.ndim == 1 else a
    if a.ndim < 2 or a.shape[-1] != 3 or not 1 <= a.shape[-2] <= 3:
        raise RotationError(
            f"axes has shape {a.shape}; one to three axes of three coordinates are expected, (…, n, 3)"
        )
    require_nonzero(a, "axis")
    unit = _UNITS(a)
    leaning = np.abs(np.sum(unit[..., 1:, :] * unit[..., :-1, :], axis=-1)) > _ACROSS
    if leaning.any():
        refuse_rows(
            leaning.any(axis=-1),
            "the list of axes",
            "has neighbours that are not perpendicular: not all rotations can be reached",
        )
    return unit, order.lower()[0] == "i"


_UNITS = RowFormula(lambda axis: join(namespace(axis), unit(namespace(axis), split(axis))), (3,))


def from_davenport(axes: ArrayLike, order: str, angles: ArrayLike, degrees: bool = False) -> Array:
    """Return the unit quaternions of rotations about one to three axes (…, n, 3), by angles (…, n).

    For one axis, a number or a one-dimensional array of angles is also accepted; the batch shapes broadcast.

    Raises
    ------
    RotationError
        Axes, an order or angles that do not fit.
    """
    unit, intrinsic = checked_axes(axes, order)
    expect_numpy("from_davenport", angles)
    a, n = floats(angles, "angles"), unit.shape[-2]
    if n == 1 and a.ndim < 2 and (a.ndim == 0 or a.shape[-1] != 1):
        a = a[..., None]
    expect_last(a, (n,), f"angles about {n} axes")
    common_batch(axes=unit.shape[:-2], angles=a.shape[:-1])
    return _making(n, intrinsic, bool(degrees))(unit, a)


@cache
def _making(n: int, intrinsic: bool, degrees: bool) -> RowFormula:
    return RowFormula(_from_davenport, (n, 3), (n,), parameters=(intrinsic, degrees))


def _from_davenport(axes: Array, angles: Array, intrinsic: bool, degrees: bool) -> Array:
    xp, turns = namespace(angles), list[Coordinates]()
    for axis, angle in zip(_rows(axes, angles.shape[-1]), split(angles), strict=True):
        s, c = waves(xp, 0.5 * angle, degrees)
        turns.append((c, *(s * x for x in axis)))
    return join(xp, steadied(reduce(multiplied, turns if intrinsic else turns[::-1])))


def _rows(axes: Array, n: int) -> list[Coordinates]:
    return [tuple(axes[..., r, c] for c in range(3)) for r in range(n)]


def to_davenport(
    q: Array, axes: ArrayLike, order: str, degrees: bool = False, tolerance: float = _LOCK
) -> tuple[Array, Array]:
    """Return the angles (…, 3) about three axes (…, 3, 3), and a mask of gimbal lock.

    The first and third angle lie in [−π, π]. Let λ be the angle about the second axis from the first to the
    third (in the extrinsic order). The second angle lies in [λ, λ + π] if λ ≤ 0, else in [λ − π, λ]: that is
    [−π/2, π/2] for perpendicular axes, and [0, π] if the first axis is the third. In gimbal lock the third
    angle is 0.

    Raises
    ------
    RotationError
        Not three axes, or axes or an order that do not fit.
    """
    unit, intrinsic = checked_axes(axes, order)
    expect_numpy("as_davenport", q)
    if unit.shape[-2] != 3:
        raise RotationError("three axes are needed to represent every rotation")
    common_batch(rotations=q.shape[:-1], axes=unit.shape[:-2])
    found = _reading(intrinsic, bool(degrees), tolerance)(q, unit)
    return np.ascontiguousarray(found[..., :3], q.dtype), found[..., 3] != 0.0


@cache
def _reading(intrinsic: bool, degrees: bool, tolerance: float) -> RowFormula:
    return RowFormula(_to_davenport, (4,), (3, 3), parameters=(intrinsic, degrees, tolerance))


def _to_davenport(q: Array, axes: Array, intrinsic: bool, degrees: bool, tolerance: float) -> Array:
    """Return the three angles, and a flag that is 1 in gimbal lock."""
    xp, rows = namespace(q), _rows(axes, 3)
    first, second, third = rows[::-1] if intrinsic else rows
    across = cross(first, second)
    lean = xp.atan2(-_dot(across, third), _dot(first, third))
    # The third axis is the first one turned by λ about the second. Turned back by λ, the rotation
    # becomes one about the first axis, then about the second by the angle minus λ, then about the
    # first again.
    s, c = waves(xp, -0.5 * lean, False)
    a, *u = steadied(multiplied((c, *(s * x for x in second)), split(q)))
    b, c, d = (_dot(tuple(u), axis) for axis in (first, second, across))
    ab, cd = length(xp, (a, b)), length(xp, (c, d))
    plus, minus = xp.atan2(b, a), xp.atan2(d, c)
    free = 1.0 if intrinsic else -1.0
    flat, upside = cd <= tolerance * ab, ab <= tolerance * cd
    minus, plus = xp.where(flat, free * plus, minus), xp.where(upside, free * minus, plus)
    start, end, middle = plus - minus, plus + minus, 2.0 * xp.atan2(cd, ab)
    # Where λ > 0: the same rotation, by the opposite turn about the second axis.
    over = lean > 1e-12
    middle = xp.where(over, -middle, middle) + lean
    turned = over & ~(flat | upside)
    start, end = xp.where(turned, start + math.pi, start), xp.where(turned, end - math.pi, end)
    start, end = (x - 2.0 * math.pi * xp.round(x / (2.0 * math.pi)) for x in (start, end))
    angles = (end, middle, start) if intrinsic else (start, middle, end)
    locked = xp.where(flat | upside, xp.ones_like(ab), xp.zeros_like(ab))
    return join(xp, (*(to_degrees(xp, x) if degrees else x for x in angles), locked))


def _dot(a: Coordinates, b: Coordinates) -> Array:
    found: Array = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    return found
