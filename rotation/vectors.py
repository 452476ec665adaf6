"""Rotation vectors and axes: the length is the angle, the direction the axis (thesis, section 2.2.5).

The functions are accurate over the whole range of floats: a rotation by 1e-300 keeps its direction and size,
and one by 1e300 does not overflow.
"""

from __future__ import annotations

import math
from functools import reduce

from rotation.angles import in_degrees, to_degrees, waves, waves_of_degrees
from rotation.array_types import Array, ArrayLike, Namespace
from rotation.arrays import common_batch
from rotation.compensated import angle, norm, quotient, sine_and_cosine, times
from rotation.coordinates import (
    STEP,
    Coordinates,
    backwards,
    factor,
    join,
    length,
    middling,
    poison,
    polynomial,
    split,
    sum_of_squares,
    unit,
)
from rotation.namespaces import expect_last, finfo, floats, namespace, quiet, refuse_zeros
from rotation.native.pairs import Pair
from rotation.optimum import is_differentiable
from rotation.quaternions import multiplied, upright
from rotation.rowwise import RowFormula, rarely

# Of t = |v|² below SHORT: cos(|v|/2), sin(|v|/2)/|v| and 2·arcsin(√t)/√t, to 2⁻⁵⁶ of them.
SHORT = 2.0**-24
COSINE = (1.0, -1.0 / 8.0, 1.0 / 384.0)
SINE = (1.0 / 2.0, -1.0 / 48.0, 1.0 / 3840.0)
ARCSINE = (2.0, 1.0 / 3.0, 3.0 / 20.0)


def from_rotvec(vectors: ArrayLike, degrees: bool = False) -> Array:
    """Return the unit quaternions of rotation vectors of shape (…, 3).

    The length is computed with twice the digits, because it is an angle: half an ulp of 1e9 is a visible
    rotation. Degrees are reduced in degrees.
    """
    v = floats(vectors, "rotation vectors")
    expect_last(v, (3,), "rotation vectors")
    return _FROM_ROTVEC[bool(degrees)](v)


def _from_rotvec(v: Array, degrees: bool) -> Array:
    xp = namespace(v)
    if is_differentiable(v) and not degrees:
        return _exponential(xp, v)
    f = factor(xp, split(v))
    c = tuple(f * a for a in split(v))
    n = norm(xp, c)
    turning = n[0] > 0.0
    n = (xp.where(turning, n[0], xp.ones_like(f)), n[1])
    back = backwards(xp, f)
    half = (0.5 * n[0] * back, 0.5 * n[1] * back)
    sine, cosine = waves_of_degrees(xp, half) if degrees else _sine_and_cosine(xp, half)
    w, *u = turn(xp, sine, cosine, c, n)
    spoilt = poison(c)
    tangent = (
        0.5 * (math.radians(1.0) if degrees else 1.0) * back
    )  # only the derivative at 0 needs it
    u = [xp.where(turning, x, tangent * a + spoilt) for x, a in zip(u, c, strict=True)]
    return join(xp, (xp.where(turning, w, xp.ones_like(f)) + spoilt, *u))


def _exponential(xp: Namespace, v: Array) -> Array:
    """Return the exponential without pairs, for libraries with derivatives.

    Near 0 series are used, which have all derivatives there. Expressions that a compiler should compute once
    per row are separate from the coordinates that they multiply.
    """
    c = split(v)
    largest = reduce(xp.maximum, (xp.abs(a) for a in c))
    info, one = finfo(xp, largest), xp.ones_like(largest)
    far = largest > float(info.max) ** 0.5 / 4.0
    f = xp.where(far, (1.0 / STEP[info.bits]) * one, one)
    square = sum_of_squares([f * a for a in c])
    short = ~far & (square < SHORT)
    n = xp.sqrt(xp.where(short, one, square)) / f
    t = xp.where(short, square, xp.zeros_like(square))
    half = 0.5 * n
    cosine = xp.where(short, polynomial(COSINE, t), xp.cos(half))
    ratio = xp.where(short, polynomial(SINE, t), xp.sin(half) / n)
    return xp.concat([cosine[..., None], ratio[..., None] * v], axis=-1)


def turn(xp: Namespace, sine: Pair, cosine: Pair, axis: Coordinates, n: Pair) -> Coordinates:
    """Return the coordinates ``cos, sin·a/n`` for an axis a of length n, each almost correctly rounded."""
    ratio = quotient(xp, sine, n)
    return (cosine[0] + cosine[1], *(times(xp, ratio, a) for a in axis))


_FROM_ROTVEC = [RowFormula(_from_rotvec, (3,), parameters=(degrees,)) for degrees in (False, True)]


def _sine_and_cosine(xp: Namespace, angle: Pair) -> tuple[Pair, Pair]:
    """Return sine and cosine, as pairs in the first quadrant, rounded beyond it."""
    if hasattr(xp, "waves"):
        both: tuple[Pair, Pair] = xp.waves(*angle)
        return both
    a, b = angle
    near = a < 0.5 * math.pi
    zero = xp.zeros_like(a)
    (s, s_low), (c, c_low) = sine_and_cosine(xp, (xp.where(near, a, zero), b))

    def beyond() -> Coordinates:
        sa, ca, sb, cb = xp.sin(a), xp.cos(a), xp.sin(b), xp.cos(b)
        sine = xp.where(near, s, sa * cb + ca * sb)
        cosine = xp.where(near, c, ca * cb - sa * sb)
        return sine, xp.where(near, s_low, zero), cosine, xp.where(near, c_low, zero)

    s, s_low, c, c_low = rarely(xp, ~near, beyond, (s, s_low, c, c_low))
    return (s, s_low), (c, c_low)


def to_rotvec(q: Array, degrees: bool = False) -> Array:
    """Return the rotation vectors, with lengths in [0, π], of unit quaternions of shape (…, 4)."""
    return _TO_ROTVEC[bool(degrees)](q)


def _to_rotvec(q: Array, degrees: bool) -> Array:
    xp = namespace(q)
    w, *u = upright(xp, split(q))
    if is_differentiable(q) and not degrees:
        return _logarithm(xp, w, tuple(u))
    f = factor(xp, tuple(u))
    c = tuple(f * a for a in u)
    n = norm(xp, c)
    turning = n[0] > 0.0
    n = (xp.where(turning, n[0], xp.ones_like(f)), n[1])
    back = backwards(xp, f)
    half = angle(xp, (n[0] * back, n[1] * back), w)
    whole = (2.0 * half[0], 2.0 * half[1])
    if degrees:
        whole = in_degrees(xp, whole)
    ratio = quotient(xp, whole, n)
    tangent = 2.0 * (math.degrees(1.0) if degrees else 1.0)  # only the derivative at 0 needs it
    v = (xp.where(turning, times(xp, ratio, a), tangent * b) for a, b in zip(c, u, strict=True))
    return join(xp, tuple(v))


def _logarithm(xp: Namespace, w: Array, u: Coordinates) -> Array:
    """Return the inverse of `_exponential`, also without pairs."""
    square = sum_of_squares(u)
    short = square < SHORT
    n = xp.sqrt(xp.where(short, xp.ones_like(square), square))
    t = xp.where(short, square, xp.zeros_like(square))
    ratio = xp.where(short, polynomial(ARCSINE, t), 2.0 * xp.atan2(n, w) / n)
    return ratio[..., None] * join(xp, u)


_TO_ROTVEC = [RowFormula(_to_rotvec, (4,), parameters=(degrees,)) for degrees in (False, True)]


@quiet
def from_axis_angle(axis: ArrayLike, angle: ArrayLike, degrees: bool = False) -> Array:
    """Return the unit quaternions of rotations by ``angle`` (…) about ``axis`` (…, 3), of any length but 0.

    Raises
    ------
    RotationError
        An axis is zero.
    """
    xp = namespace(axis, angle)
    v = floats(axis, "axes", xp)
    expect_last(v, (3,), "axes")
    refuse_zeros(v, "axis")
    a = floats(angle, "angles", xp)
    common_batch(axes=tuple(v.shape[:-1]), angles=tuple(a.shape))
    return FROM_AXIS_ANGLE[bool(degrees)](v, a)


def _from_axis_angle(axis: Array, angle: Array, degrees: bool) -> Array:
    return join(namespace(axis), about_axis(split(axis), angle[...], degrees))


def about_axis(axis: Coordinates, angle: Array, degrees: bool) -> Coordinates:
    """Return the coordinates of quaternions of rotations about axes; NaN for axes that are 0 or not
    finite.
    """
    xp, half = namespace(axis[0]), 0.5 * angle
    if not hasattr(xp, "waves"):
        s, c = waves(xp, half, degrees)
        return (c + poison(axis), *(s * x for x in unit(xp, axis)))
    a = middling(xp, axis)
    zero = xp.zeros_like(half)
    sine, cosine = waves_of_degrees(xp, (half, zero)) if degrees else xp.waves(half, zero)
    return tuple(x + poison(axis) for x in turn(xp, sine, cosine, a, norm(xp, a)))


FROM_AXIS_ANGLE = [
    RowFormula(_from_axis_angle, (3,), (), parameters=(degrees,)) for degrees in (False, True)
]


def to_axis_angle(q: Array, degrees: bool = False) -> tuple[Array, Array]:
    """Return unit axes (…, 3) and angles (…) in [0, π]; the identity has the axis z and the angle 0."""
    both = _TO_AXIS_ANGLE[bool(degrees)](q)
    angle = both[..., 3]
    return both[..., :3], angle if angle.ndim else angle[()]


def _to_axis_angle(q: Array, degrees: bool) -> Array:
    xp = namespace(q)
    w, *u = upright(xp, split(q))
    c = tuple(u)
    n = length(xp, c)
    still = n == 0.0
    zero, one = xp.zeros_like(n), xp.ones_like(n)
    usual = (zero, zero, one)
    axis = unit(xp, tuple(xp.where(still, a, b) for a, b in zip(usual, c, strict=True)))
    angle = 2.0 * xp.atan2(n, w)
    return join(xp, (*axis, to_degrees(xp, angle) if degrees else angle))


_TO_AXIS_ANGLE = [
    RowFormula(_to_axis_angle, (4,), parameters=(degrees,)) for degrees in (False, True)
]


def from_mrp(parameters: ArrayLike) -> Array:
    """Return the unit quaternions of modified Rodrigues parameters (…, 3): ``tan(angle/4)·axis``."""
    v = floats(parameters, "modified Rodrigues parameters")
    expect_last(v, (3,), "modified Rodrigues parameters")
    return _FROM_MRP(v)


def _from_mrp(v: Array) -> Array:
    """Return ``(1 − t², 2·v) / (1 + t²)`` for v of length t; long v are first divided by a power of two."""
    xp = namespace(v)
    c = split(v)
    f = factor(xp, c)
    f = xp.where(f < 1.0, f, xp.ones_like(f))  # short ones may vanish when squared
    scaled = tuple(f * a for a in c)
    square, one = sum_of_squares(scaled), f * f
    whole = one + square
    spoilt = poison(c)
    return join(
        xp,
        ((one - square) / whole + spoilt, *(2.0 * a * (f / whole) + spoilt for a in scaled)),
    )


_FROM_MRP = RowFormula(_from_mrp, (3,))


def to_mrp(q: Array) -> Array:
    """Return the modified Rodrigues parameters, with lengths in [0, 1], of unit quaternions."""
    return _TO_MRP(q)


def _to_mrp(q: Array) -> Array:
    xp = namespace(q)
    w, *u = upright(xp, split(q))
    return join(xp, tuple(c / (1.0 + w) for c in u))


_TO_MRP = RowFormula(_to_mrp, (4,))


@quiet
def between(source: ArrayLike, target: ArrayLike) -> Array:
    """Return the unit quaternions of the rotations of least angle that map ``source`` to ``target``.

    Opposite directions are related by half turns about all perpendicular axes; the axis used is perpendicular
    to ``source`` and to the coordinate axis farthest from it.

    Parameters
    ----------
    source, target : array_like, shape (…, 3)
        Directions of any length but 0; the batch shapes broadcast.

    Raises
    ------
    RotationError
        A direction is zero.
    """
    xp = namespace(source, target)
    ends = []
    for value, name in ((source, "source"), (target, "target")):
        v = floats(value, f"{name} directions", xp)
        expect_last(v, (3,), f"{name} directions")
        refuse_zeros(v, f"{name} direction")
        ends.append(join(xp, unit(xp, split(v))))
    common_batch(
        **{k: tuple(v.shape[:-1]) for k, v in zip(("source", "target"), ends, strict=True)}
    )
    a, b = (split(v) for v in xp.broadcast_arrays(*ends))
    sums = tuple(s + t for s, t in zip(a, b, strict=True))
    differences = tuple(t - s for s, t in zip(a, b, strict=True))
    chord = length(xp, sums)  # 2·cos of half the angle; the other chord is 2·sin
    # a × b = a × (b − a) = a × (a + b): with the shorter of the two, nothing is lost to
    # cancellation.
    obtuse = chord < length(xp, differences)
    short = tuple(xp.where(obtuse, s, d) for s, d in zip(sums, differences, strict=True))
    opposite = chord <= 8.0 * float(xp.finfo(chord.dtype).eps)
    safe = xp.where(opposite, xp.ones_like(chord), chord)
    axis = tuple(c / safe for c in cross(a, short))
    aside = cross(a, _farthest_axis(xp, a))
    u = (xp.where(opposite, p, c) for p, c in zip(aside, axis, strict=True))
    w = xp.where(opposite, xp.zeros_like(chord), 0.5 * chord)
    return join(xp, unit(xp, (w, *u)))


def cross(a: Coordinates, b: Coordinates) -> Coordinates:
    """Return ``a × b``, the vector part of the product of two pure quaternions (thesis, 2.2.5)."""
    return multiplied((0.0, *a), (0.0, *b))[1:]


def _farthest_axis(xp: Namespace, a: Coordinates) -> Coordinates:
    """Return the unit coordinate axis with the largest angle to ``a``; the first one if there are several."""
    x, y, z = (xp.abs(c) for c in a)
    one, zero = xp.ones_like(x), xp.zeros_like(x)
    first = (x <= y) & (x <= z)
    second = ~first & (y <= z)
    return (
        xp.where(first, one, zero),
        xp.where(second, one, zero),
        xp.where(first | second, zero, one),
    )
