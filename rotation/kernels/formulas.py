"""The formulas of the kernels: a fast form for eight points at once, and a careful form for extreme values.

The fast form also returns where it is valid. It is invalid for large angles, and where the square of a length
times a coordinate may leave the range of floats. The careful form is the one used for few points.
"""

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple, cast

from rotation import action
from rotation.angles import RADIANS
from rotation.array_types import Array, Operand
from rotation.compensated import norm
from rotation.coordinates import Coordinates, split, sum_of_squares
from rotation.matrices import matrix_entries
from rotation.native import elementary, tracing
from rotation.native.elementary import COSINE, REACH, SINE, TWO_OVER_PI
from rotation.native.pairs import Pair, plus_product, quick_two_sum, two_product, two_sum
from rotation.quaternions import normalise
from rotation.vectors import about_axis, turn

# Between these bounds a squared length, times a coordinate between them, neither overflows nor
# loses digits.
SMALL, LARGE = 2.0**-200, 2.0**200
LOW, HIGH = 2.0**-700, 2.0**700


# π/2 = P1 + P2 + P3 with 23 bits in P1 and in P2: the products with a whole number below 2^30 and the
# differences are exact, with or without FMA (Cody and Waite 1980). P3 holds the next 53 bits.
P1 = float.fromhex("0x1.921fb4p+0")
P2 = float.fromhex("0x1.4442dp-24")
P3 = float.fromhex("0x1.8469898cc517p-48")

HALF_ROOT = math.sqrt(0.5)
XP = tracing.NAMESPACE


Image = tuple[Coordinates, Array | None]  # new coordinates, and a mask of the valid ones
Matrix = Sequence[Sequence[Array]]


class Kernel(NamedTuple):
    """A formula in its fast and its careful form."""

    fast: Callable[..., Image]
    careful: Callable[..., Coordinates] | None = None


def _safe(square: Array) -> Array:
    """Return whether a squared length can be used directly; not so for NaN."""
    return (square >= SMALL) & (square <= LARGE)


def _measured(point: Coordinates) -> tuple[Array, Array]:
    """Return the number to add to a result (−0, or NaN if a coordinate is not finite), and whether this is
    safe.

    It is unsafe for points that are too large or too small for a product with a squared length. Adding −0
    does not change a sum.
    """
    x, y, z = point
    size = XP.abs(x) + (XP.abs(y) + XP.abs(z))
    return -(size - size), ~((size > HIGH) | ((size < LOW) & (size > 0.0)))


def _plus(c: Operand, a: Array, b: Operand) -> Array:
    return plus_product(XP, c, a, b)


def _reachable(x: Array) -> Array:
    """Return whether the fast form is valid for ``x``; it is invalid for NaN and inf."""
    return XP.abs(x) <= REACH


def _sincos(x: Array, degrees: bool) -> Pair:
    """Return sine and cosine of lanes ``x`` for which the fast form is valid."""
    k = x * (1.0 / 90.0 if degrees else TWO_OVER_PI) + XP.ROUND
    n = k - XP.ROUND  # quarters of a turn
    if degrees:
        rest = x - n * 90.0
        r = plus_product(XP, rest * RADIANS[1], rest, RADIANS[0])
    else:
        r = ((x - n * P1) - n * P2) - n * P3
    s, c = _sincos_of_eighth(r)
    s = XP.where(r != 0.0, s, r)  # the sum loses the sign of −0
    if degrees:  # both are √½, because those of whole quarters are 0 and 1
        eighth = XP.abs(rest) == 45.0
        s = XP.where(eighth, XP.copysign(HALF_ROOT, s), s)
        c = XP.where(eighth, HALF_ROOT, c)
    odd, beyond = XP.bit(k, 0), XP.bit(k, 1)  # the last two bits of n
    a, b = XP.where(odd, c, s), XP.where(odd, -s, c)
    return XP.where(beyond, -a, a), XP.where(beyond, -b, b)


def _sincos_of_eighth(r: Array) -> Pair:
    """Return sine and cosine of an angle of at most π/4."""
    z = r * r
    sine, cosine = (_polynomial(table, z) for table in (SINE, COSINE))
    return _plus(r, r * z, sine), _plus(1.0, -z, _plus(0.5, -z, cosine))


def _polynomial(coefficients: tuple[float, ...], z: Array) -> Array:
    """Return ``Σ coefficients[k]·zᵏ`` by Horner's scheme."""
    *others, before, last = coefficients
    total = _plus(before, z, last)
    for c in reversed(others):
        total = _plus(c, z, total)
    return total


def _one(points: Array, matrix: Array) -> Image:
    """Rotate by one matrix, in the precision of the points."""
    entries, (x, y, z) = split(matrix), split(points)
    poison = -((x - x) + ((y - y) + (z - z)))  # NaN or −0
    return action.by_rows((entries[:3], entries[3:6], entries[6:]), (x, y, z), poison), None


def _axis_angle(degrees: bool, single: bool, points: Array, axis: Array, angle: Array) -> Image:
    """Return points rotated about axes whose lengths are safe."""
    if not single and not hasattr(XP, "fma"):
        return _axis_angle_by_quaternion(degrees, points, axis, angle)
    a, point, t = split(axis), split(points), angle[...]
    poison, fine = _measured(point)
    sine, cosine = _sincos(t, degrees)
    XP.round_all(points[...])
    square = sum_of_squares(a)
    part = 1.0 / XP.sqrt(square)
    m = matrix_about(tuple(part * x for x in a), sine, cosine, single)
    return action.by_rows(m, point, poison), fine & _reachable(t) & _safe(square)


def matrix_about(axis: Coordinates, sine: Array, cosine: Array, single: bool = False) -> Matrix:
    """Return the matrices c + t·u·uᵀ + s·[u] of rotations about axes u, with t = 1 − c.

    The deviation of the length of u from 1 by rounding is measured and corrected, except in single precision.
    """
    t, low = quick_two_sum(1.0, -cosine)
    if single:
        tu = tuple(t * c for c in axis)
    else:
        excess = _excess(axis)
        low = _plus(low, -t, excess)
        tu = tuple(_plus(low * c, t, c) for c in axis)
        sine = _plus(sine, -0.5 * sine, excess)
    diagonal = tuple(_plus(cosine, a, b) for a, b in zip(tu, axis, strict=True))
    return _entries(diagonal, tu, axis, tuple(sine * c for c in axis))


def _excess(axis: Coordinates) -> Array:
    """Return the small number N(u) − 1, summed so that rounding errors are small."""
    x, y, z = axis
    return _plus(_plus(_plus(-0.5, x, x), y, y) - 0.5, z, z)


def _entries(diagonal: Coordinates, tu: Coordinates, u: Coordinates, su: Coordinates) -> Matrix:
    """Return the rows of a matrix: the diagonal, and off it the products t·u·uᵀ and ±s·u."""
    (tx, ty, _), (_, y, z), (sx, sy, sz) = tu, u, su
    return (
        (diagonal[0], _plus(-sz, tx, y), _plus(sy, tx, z)),
        (_plus(sz, tx, y), diagonal[1], _plus(-sx, ty, z)),
        (_plus(-sy, tx, z), _plus(sx, ty, z), diagonal[2]),
    )


def _axis_angle_by_quaternion(degrees: bool, points: Array, axis: Array, angle: Array) -> Image:
    """Return the same by quaternions whose coordinates are rounded once, without fused multiply-add."""
    a, point, half = split(axis), split(points), 0.5 * angle[...]
    poison, fine = _measured(point)
    XP.round_all(points[...])
    sine, cosine, near = _waves_of_degrees(half) if degrees else elementary.near(XP, half)
    q = turn(XP, sine, cosine, a, norm(XP, a))
    image = action.by_rows(matrix_entries(q), point, poison)
    return image, fine & near & _safe(sum_of_squares(a))


def _waves_of_degrees(x: Array) -> tuple[Pair, Pair, Array]:
    """Return sine and cosine of degrees as pairs, and a mask of the angles for which the fast form
    is valid.
    """
    k = x * (1.0 / 90.0) + XP.ROUND
    r = x - (k - XP.ROUND) * 90.0
    p, e = two_product(XP, r, RADIANS[0])
    rest = two_sum(p, plus_product(XP, e, r, RADIANS[1]))
    eighth = XP.abs(r) == 45.0
    sine, cosine = (
        (
            XP.where(eighth, XP.copysign(HALF_ROOT, high), high),
            XP.where(eighth, 0.0 * low, low),
        )
        for high, low in elementary.of_rest(XP, k, *rest)
    )
    return sine, cosine, _reachable(x)


def _axis_angle_carefully(
    degrees: bool, single: bool, points: Array, axis: Array, angle: Array
) -> Coordinates:
    a = split(axis)
    XP.flag_if(_all_zero(a))
    return action.turned_by(about_axis(a, angle[...], degrees), split(points), False)


def _quaternions(single: bool, points: Array, q: Array) -> Image:
    """Return points rotated by quaternions whose lengths are safe, using their matrices."""
    c, point = split(q), split(points)
    poison, fine = _measured(point)
    XP.round_all(points[...])
    if single or hasattr(XP, "fma"):
        m, square = matrix_of(c, single)
    else:
        square = sum_of_squares(c)
        part = 1.0 / XP.sqrt(square)
        m = matrix_entries(tuple(a * part for a in c))
    return action.by_rows(m, point, poison), fine & _safe(square)


def matrix_of(q: Coordinates, single: bool = False) -> tuple[Matrix, Array]:
    """Return the matrices 1 + t·(w·[u] + [u]²) of quaternions (w, u) of any length, and N(q); t = 2/N(q)."""
    w, *u = q
    square, t, low = _twice_inverse_norm(q)
    tu = tuple(t * c if single else _plus(low * c, t, c) for c in u)
    (x, y, z), (tx, ty, tz) = u, tu
    without_y, without_z = _plus(1.0, -ty, y), _plus(1.0, -tz, z)
    diagonal = (_plus(without_z, -ty, y), _plus(without_z, -tx, x), _plus(without_y, -tx, x))
    return _entries(diagonal, tu, tuple(u), tuple(c * w for c in tu)), square


def _twice_inverse_norm(q: Coordinates) -> tuple[Array, Array, Array]:
    """Return N(q) and t = 2/N(q), both rounded, and a correction of t for both rounding errors."""
    w, x, y, z = q
    square, low = two_product(XP, z, z)
    for c in (y, x, w):
        total = _plus(square, c, c)
        low = _plus(square - total, c, c) + low
        square = total
    t = 2.0 / square
    return square, t, (-0.5 * t) * _plus(_plus(-2.0, t, square), low, t)


def _quaternions_carefully(single: bool, points: Array, q: Array) -> Coordinates:
    return action.turned_by(tuple(normalise(q)), split(points), False)


def _euler(
    axes: tuple[int, ...], backward: bool, degrees: bool, points: Array, angles: Array
) -> Image:
    """Rotate about coordinate axes one after another."""
    turns = split(angles)
    poison, fine = _measured(split(points))
    for t in turns:
        fine = fine & _reachable(t)
    waves = [_sincos(t, degrees) for t in (turns[::-1] if backward else turns)]
    image = action.turned_about(axes, waves, split(points))
    return tuple(x + poison for x in image), fine


def _euler_carefully(
    axes: tuple[int, ...], backward: bool, degrees: bool, points: Array, angles: Array
) -> Coordinates:
    image = action.by_angles(angles, points, axes, backward, degrees)
    return cast(Coordinates, image)  # symbols are joined to a tuple


def _contains_zero(rows: Array) -> Image:
    return (), _safe(sum_of_squares(split(rows)))


def _contains_zero_carefully(rows: Array) -> Coordinates:
    XP.flag_if(_all_zero(split(rows)))
    return ()


def _all_zero(coordinates: Coordinates) -> Array:
    """Return where all coordinates are 0."""
    zero: Array
    zero, *others = (c == 0.0 for c in coordinates)
    for other in others:
        zero = zero & other
    return zero


_KERNELS = {
    "one": Kernel(_one),
    "axis_angle": Kernel(_axis_angle, _axis_angle_carefully),
    "quaternions": Kernel(_quaternions, _quaternions_carefully),
    "euler": Kernel(_euler, _euler_carefully),
    "contains_zero": Kernel(_contains_zero, _contains_zero_carefully),
}


def kernel(name: str, *parameters: bool | tuple[int, ...]) -> Kernel:
    """Return a kernel by its name and its parameters.

    "axis_angle" has two parameters: whether angles are in degrees, and whether the result is float32.
    "quaternions" has only the latter. "euler" has the axes, whether they are applied backwards, and whether
    angles are in degrees.
    """
    fast, careful = _KERNELS[name]
    return Kernel(partial(fast, *parameters), careful and partial(careful, *parameters))
