"""Unit quaternions as arrays of shape (…, 4), scalar first: the group that turns space.

Products use the formula of `hfield.core.product` with Hamilton's constants, on coordinate tuples. Thesis,
section 2.2.5; K. Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985.
"""

from __future__ import annotations

from functools import reduce
from operator import and_

import numpy as np

from hfield.core import product as formula
from rotation.angles import to_degrees, waves
from rotation.array_types import Array, ArrayLike, Namespace, Operand
from rotation.arrays import common_batch
from rotation.coordinates import Coordinates, join, length, split, sum_of_squares, unchanging, unit
from rotation.namespaces import expect_last, floats, namespace, number, quiet, refuse_zeros
from rotation.optimum import is_differentiable, without_derivatives
from rotation.rowwise import RowFormula, flag_if, rarely

HAMILTON: formula.Constants[float] = formula.Constants(
    -1.0, 0, -1.0
)  # whole zeros leave no trace in compiled programs


def normalised(q: ArrayLike) -> Array:
    """Return quaternions divided by their modulus, which may be anything from 1e-300 to 1e300.

    A quaternion whose norm is 1 up to rounding is returned unchanged. NaN or inf makes the whole row NaN.

    Parameters
    ----------
    q : array_like, shape (…, 4)

    Raises
    ------
    RotationError
        A quaternion is zero, or the shape is wrong.
    """
    q = floats(q, "quaternions")
    expect_last(q, (4,), "quaternions")
    units, zeros = _NORMALISED.with_flag(q)
    if zeros:
        refuse_zeros(q, "quaternion")
    return units


def normalise(q: Array) -> Array:
    """Return the formula of `normalised`, with a flag for zeros."""
    xp, c = namespace(q), split(q)
    norm = sum_of_squares(c)
    flag_if(xp, norm == 0.0)
    info = xp.finfo(q.dtype)
    exact = xp.abs(norm - 1.0) <= 4.0 * float(info.eps)
    one = xp.ones_like(norm)
    if is_differentiable(norm):  # √norm beside 1, which is 1 here but has its derivatives
        off = norm - without_derivatives(norm)
        one = one + off * (0.5 - 0.125 * off)
    modulus = xp.where(exact, one, xp.sqrt(norm))
    wide = float(info.max) ** 0.6
    far = ~((norm > 1.0 / wide) & (norm < wide))  # squares may have been rounded off, or NaN
    near = tuple(a / modulus for a in c)

    def brought_near() -> Coordinates:
        return tuple(xp.where(exact, a, b) for a, b in zip(near, unit(xp, c), strict=True))

    return join(xp, rarely(xp, far, brought_near, near))


_NORMALISED = RowFormula(normalise, (4,))


def product(p: Array, q: Array) -> Array:
    """Return the unit quaternions ``p·q``: the rotation that applies q first, then p.

    Shapes broadcast. One Newton step brings each norm back to 1, so long chains do not drift.

    Parameters
    ----------
    p, q : array, shape (…, 4)
        Unit quaternions.
    """
    if not type(p) is type(q) is np.ndarray:
        namespace(p, q)  # of two libraries it raises
    if p.shape != q.shape:
        common_batch(left=tuple(p.shape[:-1]), right=tuple(q.shape[:-1]))
    return PRODUCT(p, q)


def _product(p: Array, q: Array) -> Array:
    return join(namespace(p), steadied(multiplied(split(p), split(q))))


PRODUCT = RowFormula(_product, (4,), (4,))


def multiplied(p: tuple[Operand, ...], q: tuple[Operand, ...]) -> Coordinates:
    """Return the coordinates of ``p·q`` by the product formula, for any norms."""
    (w1, x1, y1, z1), (w2, x2, y2, z2) = p, q
    return formula.multiply(HAMILTON, (w1, x1, y1, z1), (w2, x2, y2, z2))


def conjugated(q: Coordinates) -> Coordinates:
    """Return the coordinates of the conjugate of ``q``."""
    w, x, y, z = q
    return formula.conjugate(HAMILTON, (w, x, y, z))


def steadied(c: Coordinates) -> Coordinates:
    """Return coordinates of norm ``1 + δ`` with δ removed, where δ is of the size of rounding errors."""
    w, x, y, z = c
    norm = formula.norm(HAMILTON, (w, x, y, z))
    factor = (3.0 - norm) * 0.5
    return tuple(a * factor for a in c)


def inverse(q: Array) -> Array:
    """Return the conjugates of unit quaternions, which are their inverses (thesis, Definitions 3 and 4)."""
    return INVERSE(q)


def _inverse(q: Array) -> Array:
    return join(namespace(q), conjugated(split(q)))


INVERSE = RowFormula(_inverse, (4,))


def canonical(q: Array) -> Array:
    """Return the one of q and −q, which are the same rotation, whose first nonzero coordinate is positive."""
    return _CANONICAL(q)


def _canonical(q: Array) -> Array:
    return join(namespace(q), upright(namespace(q), split(q)))


_CANONICAL = RowFormula(_canonical, (4,))


def upright(xp: Namespace, c: Coordinates) -> Coordinates:
    """Return the coordinates of q or −q with a positive first nonzero coordinate."""
    w, x, y, z = c
    sign = xp.where(w != 0.0, w, xp.where(x != 0.0, x, xp.where(y != 0.0, y, z)))
    return tuple(xp.where(sign < 0.0, -a, a) for a in c)


def scalar_last(q: Array) -> Array:
    """Return (x, y, z, w) of (w, x, y, z)."""
    return _SCALAR_LAST(q)


def _scalar_last(q: Array) -> Array:
    w, *u = split(q)
    return join(namespace(q), (*u, w))


_SCALAR_LAST = RowFormula(_scalar_last, (4,))


def angle(q: Array, degrees: bool = False) -> Array:
    """Return the angle of rotation in [0, π], accurate for very small and very large angles."""
    return _ANGLE[bool(degrees)](q)


def _angle(q: Array, degrees: bool) -> Array:
    xp = namespace(q)
    w, *u = split(q)
    found = 2.0 * xp.atan2(length(xp, tuple(u)), xp.abs(w))
    return to_degrees(xp, found) if degrees else found


_ANGLE = [RowFormula(_angle, (4,), parameters=(degrees,)) for degrees in (False, True)]


def power(q: Array, exponent: Operand) -> Array:
    """Return the rotation about the same axis by ``exponent`` times the angle in [0, π].

    It is within (3 + 2.5·|exponent|)·2⁻⁵² of the exact quaternion (docs/explanation/rotation-errors.md).

    Parameters
    ----------
    q : array, shape (…, 4)
        Unit quaternions; of q and −q the canonical one counts.
    exponent : array or float
        Its shape must broadcast with the shape of the rotations.

    Raises
    ------
    RotationError
        A whole number beyond the largest float.
    """
    return _raised(SHORTER_POWER, exponent, q)


def direct_power(q: Array, exponent: Operand) -> Array:
    """Return the power of unit quaternions (…, 4) without sign change; −q takes the longer path."""
    return _raised(_POWER, exponent, q)


def slerp(p: Array, q: Array, t: Operand) -> Array:
    """Return ``p·(p⁻¹·q)ᵗ`` for unit quaternions (…, 4); p if q is p or −p."""
    return _raised(SLERP, t, p, q)


def _raised(raise_to: RowFormula, exponent: Operand, *rotations: Array) -> Array:
    xp = namespace(*rotations)
    plain = all(type(q) is np.ndarray for q in rotations)
    if isinstance(exponent, int | float):
        exponent = xp.asarray(
            number(exponent, "exponent"), dtype=None if plain else rotations[-1].dtype
        )
    else:
        namespace(*rotations, exponent)  # of two libraries it raises
    shapes = {f"rotations{n or ''}": tuple(q.shape[:-1]) for n, q in enumerate(rotations)}
    common_batch(**shapes, exponents=tuple(getattr(exponent, "shape", ())))
    raised = raise_to(*rotations, exponent)
    # What exponents are stored in does not decide for numpy; floats of Python are of every precision.
    return raised.astype(np.result_type(*rotations), copy=False) if plain else raised


def _power(q: Array, exponent: Array, shorter: bool) -> Array:
    return join(namespace(q), _powers(namespace(q), split(q), exponent[...], shorter))


def _powers(xp: Namespace, q: Coordinates, exponent: Array, shorter: bool) -> Coordinates:
    w, *u = upright(xp, q) if shorter else q
    n = length(xp, tuple(u))
    half = xp.atan2(n, w) * exponent
    turning = n > 0.0
    # At ±1 there is no axis and no rotation; near 1, the ratio for the power is the exponent.
    near = xp.where(xp.isfinite(exponent) & (w > 0.0), exponent, xp.zeros_like(half))
    sine, cosine = waves(xp, half, False)
    ratio = xp.where(turning, sine / xp.where(turning, n, xp.ones_like(n)), near + 0.0 * n)
    cosine = xp.where(n == 0.0, xp.ones_like(half), cosine)
    return (cosine, *(ratio * c for c in u))


_POWER, SHORTER_POWER = (
    RowFormula(_power, (4,), (), parameters=(short,)) for short in (False, True)
)


def _slerp(p: Array, q: Array, t: Array) -> Array:
    xp, start, end, exponent = namespace(p), split(p), split(q), t[...]
    way = steadied(multiplied(conjugated(start), end))
    point = steadied(multiplied(start, _powers(xp, way, exponent, True)))
    if is_differentiable(p) or is_differentiable(q):  # also there it moves with both ends
        return join(xp, point)
    same, opposite = (
        reduce(and_, (a == b for a, b in zip(start, ends, strict=True)))
        for ends in (end, tuple(-c for c in end))
    )
    spoilt = unchanging(xp, (exponent,))
    return join(
        xp,
        tuple(xp.where(same | opposite, a, b) + spoilt for a, b in zip(start, point, strict=True)),
    )


SLERP = RowFormula(_slerp, (4,), (4,), ())


@quiet
def T_q(q: ArrayLike, points: ArrayLike) -> Array:
    """Return ``q·v·q⁻¹`` for points v: Theorem 6 of the thesis, computed literally.

    This is the definition; `rotation.rotate_quat` is faster.

    Parameters
    ----------
    q : array_like, shape (…, 4)
        Quaternions, scalar first, of any length but 0.
    points : array_like, shape (…, 3)
        The batch shapes broadcast.

    Examples
    --------
    >>> T_q([1, 0, 0, 1], [1, 0, 0])  # a quarter turn about z
    array([0., 1., 0.])
    """
    unit = normalised(q)
    xp = namespace(unit, points)
    v = floats(points, "points", xp)
    expect_last(v, (3,), "points")
    common_batch(quaternions=tuple(unit.shape[:-1]), points=tuple(v.shape[:-1]))
    c = split(unit)
    vector = (xp.zeros_like(v[..., 0]), *split(v))
    whole = multiplied(multiplied(c, vector), conjugated(c))
    norm = sum_of_squares(c)
    return join(xp, tuple(a / norm for a in whole[1:]))
