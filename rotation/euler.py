"""Convert Euler angles, in all 24 conventions, to quaternions and back (thesis, 2.2.2 to 2.2.4: ZYX).

A sequence is one to three letters. Uppercase is intrinsic, about axes that rotate with the body: ``ZYX =
R_z(a₀)·R_y(a₁)·R_x(a₂)``. Lowercase is extrinsic, about fixed axes: ``zyx`` rotates about z first, then y,
then x, ``R_x(a₂)·R_y(a₁)·R_z(a₀)``.
"""

from __future__ import annotations

import math
from functools import cache, reduce
from itertools import pairwise, product
from typing import NamedTuple, cast

from rotation.angles import to_degrees, waves
from rotation.array_types import Array, ArrayLike, Namespace, Operand
from rotation.coordinates import Coordinates, join, length, root, split
from rotation.errors import RotationError
from rotation.namespaces import expect_last, finfo, floats, namespace
from rotation.quaternions import multiplied, steadied
from rotation.rowwise import RowFormula, rarely

SEQUENCES = [
    "".join(letters)
    for axes in ("xyz", "XYZ")
    for letters in product(axes, repeat=3)
    if letters[0] != letters[1] != letters[2]
]


class Sequence(NamedTuple):
    """A convention: the axes in the order of the angles, and whether they are intrinsic."""

    axes: tuple[int, ...]
    intrinsic: bool


def sequence(seq: str) -> Sequence:
    """Read a sequence such as ``"ZYX"`` or ``"zxz"``.

    Raises
    ------
    RotationError
        The sequence does not consist of one to three letters xyz or XYZ, mixes both cases, or repeats a
        letter consecutively.
    """
    if isinstance(seq, str):
        return _read(seq)
    raise RotationError(f"sequence {seq!r}: a text such as 'ZYX' is expected")


@cache
def _read(seq: str) -> Sequence:
    if not 1 <= len(seq) <= 3 or set(seq.lower()) - set("xyz"):
        raise RotationError(
            f"sequence {seq!r}: one to three letters are expected, of XYZ (intrinsic) or xyz (extrinsic)"
        )
    if seq not in (seq.upper(), seq.lower()):
        raise RotationError(
            f"sequence {seq!r} mixes intrinsic (uppercase) and extrinsic (lowercase) axes"
        )
    if any(a == b for a, b in pairwise(seq)):
        raise RotationError(
            f"sequence {seq!r} turns about one axis twice in a row; add the two angles instead"
        )
    return Sequence(tuple("xyz".index(c) for c in seq.lower()), seq.isupper())


def prepare(seq: str) -> None:
    """Build the formulas of a sequence of axes, for compilation."""
    axes, intrinsic = sequence(seq)
    for degrees in (False, True):
        _making(axes, intrinsic, degrees)
        if len(axes) == 3:
            _reading(axes, intrinsic, degrees)


def from_euler(seq: str, angles: ArrayLike, degrees: bool = False) -> Array:
    """Return the unit quaternions of Euler angles.

    Parameters
    ----------
    seq : str
        One to three letters.
    angles : array_like, shape (…, len(seq))
        For a single letter also a number, or a one-dimensional array with one rotation per entry.
    degrees : bool
        The angles are in degrees, not radians.

    Raises
    ------
    RotationError
        A sequence that does not exist, or angles whose last axis does not fit it.
    """
    axes, intrinsic = sequence(seq)
    a = floats(angles, "angles")
    if len(axes) == 1 and a.ndim < 2:
        a = a[..., None]
    expect_last(a, (len(axes),), f"angles for the sequence {seq!r}")
    return _making(axes, intrinsic, bool(degrees))(a)


@cache
def _making(axes: tuple[int, ...], intrinsic: bool, degrees: bool) -> RowFormula:
    return RowFormula(_from_euler, (len(axes),), parameters=(axes, intrinsic, degrees))


def _from_euler(a: Array, axes: tuple[int, ...], intrinsic: bool, degrees: bool) -> Array:
    xp = namespace(a)
    halves = [waves(xp, 0.5 * x, degrees) for x in split(a)]
    zero = 0 if len(axes) > 1 else xp.zeros_like(halves[0][0])
    turns: list[tuple[Operand, ...]] = [
        (c, *(s if axis == m else zero for m in range(3)))
        for (s, c), axis in zip(halves, axes, strict=True)
    ]
    first, *others = turns if intrinsic else turns[::-1]
    whole = reduce(multiplied, others, first)
    return join(xp, steadied(cast(Coordinates, whole)))  # of one turn all are arrays


def to_euler(q: Array, seq: str, degrees: bool = False) -> Array:
    """Return the Euler angles (…, 3) of unit quaternions (…, 4).

    The first and third angle lie in [−π, π], the second in [−π/2, π/2], or in [0, π] if the first and the
    last letter agree. In gimbal lock (the second angle is within 16·2⁻⁵² of an end of its interval) only a
    sum or a difference of the other angles is determined; then the third angle is 0. The angles describe the
    rotation up to 8·2⁻⁵² radians, in gimbal lock up to 24·2⁻⁵². They are computed from the quaternion, so no
    accuracy is lost near gimbal lock: E. Bernardes and S. Viollet, "Quaternion to Euler angles conversion: a
    direct, general and computationally efficient method", PLoS ONE 17 (2022).

    Raises
    ------
    RotationError
        The sequence does not have three letters.
    """
    axes, intrinsic = sequence(seq)
    if len(axes) != 3:
        raise RotationError(
            f"sequence {seq!r}: three letters are needed to represent every rotation"
        )
    return _reading(axes, intrinsic, bool(degrees))(q)


@cache
def _reading(axes: tuple[int, ...], intrinsic: bool, degrees: bool) -> RowFormula:
    return RowFormula(_to_euler, (4,), parameters=(axes, intrinsic, degrees))


def _to_euler(q: Array, axes: tuple[int, ...], intrinsic: bool, degrees: bool) -> Array:
    xp = namespace(q)
    (a, b, c, d), sine, sign = _folded(q, axes[::-1] if intrinsic else axes)
    ab, cd = a * a + b * b, c * c + d * d
    both = root(xp, ab * cd)
    if sine is None:
        small = both < float(finfo(xp, a).smallest_normal) ** 0.5

        def scaled() -> Coordinates:
            return (xp.where(small, length(xp, (a, b)) * length(xp, (c, d)), both),)

        (both,) = rarely(xp, small, scaled, (both,))
        middle = xp.atan2(2.0 * both, ab - cd)
    else:
        middle = xp.atan2(sine, both)
    # If one of the pairs consists only of rounding errors, its angle is free. It is chosen so that
    # the user's third angle (for intrinsic angles, the first of the extrinsic order) is 0.
    tiny = (8.0 * float(xp.finfo(q.dtype).eps)) ** 2
    free = 1.0 if intrinsic else -1.0
    plus_free, minus_free = ab <= tiny * cd, cd <= tiny * ab
    plus, minus = _angle(xp, b, a, plus_free), _angle(xp, d, c, minus_free)
    plus, minus = (
        xp.where(plus_free, free * minus, plus),
        xp.where(minus_free, free * plus, minus),
    )
    start = _wrapped(xp, plus - minus)
    end = sign * _wrapped(xp, plus + minus)
    angles = (end, middle, start) if intrinsic else (start, middle, end)
    return join(xp, tuple(to_degrees(xp, x) for x in angles) if degrees else angles)


def _angle(xp: Namespace, y: Array, x: Array, free: Array) -> Array:
    """Return the angle of (x, y), 0 in gimbal lock, where its derivative may not be finite."""
    return xp.atan2(xp.where(free, xp.zeros_like(y), y), xp.where(free, xp.ones_like(x), x))


def _folded(q: Array, axes: tuple[int, ...]) -> tuple[Coordinates, Array | None, float]:
    """Return the four numbers (a, b, c, d) of Bernardes and Viollet for extrinsic ``axes``.

    ``2·atan2(|c, d|, |a, b|)`` is the second angle of a proper Euler sequence; for a Tait–Bryan sequence π/2
    is subtracted, and twice its sine, which is more accurate near 0, is also returned. The sign of the third
    angle comes third.
    """
    w, *u = split(q)
    i, j = axes[0], axes[1]
    k = 3 - i - j
    sign = 1.0 if (j - i) % 3 == 1 else -1.0
    x, y, z = u[i], u[j], sign * u[k]
    if axes[2] == i:
        return (w, x, y, z), None, 1.0
    return (w - y, x + z, y + w, z - x), 2.0 * (w * y - x * z), sign


def _wrapped(xp: Namespace, angle: Array) -> Array:
    """Return angles between −2π and 2π, reduced to [−π, π]."""
    down = xp.where(angle > math.pi, angle - 2.0 * math.pi, angle)
    return xp.where(angle < -math.pi, angle + 2.0 * math.pi, down)
