"""The formulas of the kernels: the fast form of each, on eight points at once, and the careful one.

The fast form also says where it is right: not for a far angle, nor where the square of a length times a
coordinate might leave the range of floats. The careful form is that of few points.
"""

import math
from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

from rotation import action
from rotation.angles import RADIANS
from rotation.compensated import norm
from rotation.coordinates import Coordinates, split, sum_of_squares
from rotation.matrices import matrix_entries
from rotation.native import elementary, tracing
from rotation.native.elementary import COSINE, REACH, SINE, TWO_OVER_PI
from rotation.native.pairs import plus_product, two_product, two_sum
from rotation.native.symbols import Rows
from rotation.quaternions import normalise
from rotation.vectors import about_axis, turn

# Between these a squared length, times a coordinate between those, neither overflows nor loses digits.
SMALL, LARGE = 2.0**-200, 2.0**200
LOW, HIGH = 2.0**-700, 2.0**700


# π/2 = P1 + P2 + P3 with 23 bits in P1 and in P2: the products with a whole number below 2^30 and the
# differences are exact, with or without FMA (Cody and Waite 1980). P3 holds the next 53 bits.
P1 = float.fromhex("0x1.921fb4p+0")
P2 = float.fromhex("0x1.4442dp-24")
P3 = float.fromhex("0x1.8469898cc517p-48")

S1, S2, S3, S4, S5, S6 = SINE
C1, C2, C3, C4, C5, C6 = COSINE


class Kernel(NamedTuple):
    """A formula in its two forms."""

    fast: Callable[..., Any]
    careful: Callable[..., Any] | None = None


def _safe(square: Any) -> Any:
    """Tell whether a squared length can be used as it is; NaN cannot."""
    return (square >= SMALL) & (square <= LARGE)


def _measured(point: Coordinates) -> Any:
    """Return what to add to a result, −0 or NaN if a coordinate is not finite, and whether that is safe.

    It is not for points too large or small for a product with a squared length. Adding −0 changes no sum.
    """
    x, y, z = point
    size = tracing.abs(x) + (tracing.abs(y) + tracing.abs(z))
    return -(size - size), ~((size > HIGH) | ((size < LOW) & (size > 0.0)))


def _reachable(x: Any) -> Any:
    """Tell whether the fast way reaches ``x``; NaN and inf are not reachable."""
    return tracing.abs(x) <= REACH


def _sincos(x: Any, degrees: bool) -> Any:
    """Return sine and cosine of reachable lanes ``x``."""
    k = x * (1.0 / 90.0 if degrees else TWO_OVER_PI) + tracing.ROUND
    n = k - tracing.ROUND  # quarters of a turn
    if degrees:
        r = x - n * 90.0
        r = r * RADIANS[0] + r * RADIANS[1]
    else:
        r = ((x - n * P1) - n * P2) - n * P3
    z = r * r
    s = r + r * z * (S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)))))
    s = tracing.where(r != 0.0, s, r)  # the sum loses the sign of −0
    c = 1.0 - z * (0.5 - z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6))))))
    odd, beyond = tracing.bit(k, 0), tracing.bit(k, 1)  # the last two bits of n
    a, b = tracing.where(odd, c, s), tracing.where(odd, -s, c)
    return tracing.where(beyond, -a, a), tracing.where(beyond, -b, b)


def _one(points: Rows, matrix: Rows) -> Any:
    """Rotate by one matrix, in the precision of the points."""
    a, b, c, d, e, f, g, h, k = split(matrix)
    x, y, z = split(points)
    poison = -((x - x) + ((y - y) + (z - z)))  # NaN or −0
    return (
        a * x + (b * y + (c * z + poison)),
        d * x + (e * y + (f * z + poison)),
        g * x + (h * y + (k * z + poison)),
    ), None


def _axis_angle(degrees: bool, points: Rows, axis: Rows, angle: Rows) -> Any:
    """Return the points after the rotation by the quaternions of turns about axes."""
    a, point, half = split(axis), split(points), 0.5 * split(angle)[0]
    points[...].program.flags = ""  # nothing is fused that is to be exact
    poison, fine = _measured(point)
    sine, cosine, near = _waves_of_degrees(half) if degrees else elementary.near(tracing, half)
    q = turn(tracing, sine, cosine, a, norm(tracing, a))
    image = action.by_rows(matrix_entries(q), point)
    return tuple(x + poison for x in image), fine & near & _safe(sum_of_squares(a))


def _waves_of_degrees(x: Any) -> Any:
    """Return sine and cosine of reachable degrees as pairs, and where they are reachable."""
    k = x * (1.0 / 90.0) + tracing.ROUND
    r = x - (k - tracing.ROUND) * 90.0
    p, e = two_product(tracing, r, RADIANS[0])
    pairs = elementary.of_rest(tracing, k, *two_sum(p, plus_product(tracing, e, r, RADIANS[1])))
    eighth = tracing.abs(r) == 45.0  # both are √½, as whole quarters have 0 and 1
    exact = (
        (
            tracing.where(eighth, tracing.copysign(math.sqrt(0.5), high), high),
            tracing.where(eighth, 0.0 * low, low),
        )
        for high, low in pairs
    )
    return *exact, _reachable(x)


def _axis_angle_carefully(degrees: bool, points: Rows, axis: Rows, angle: Rows) -> Any:
    a = split(axis)
    tracing.tell(tracing.all([c == 0.0 for c in a]))
    return action.turned_by(about_axis(a, angle[...], degrees), split(points), False)


def _quaternions(points: Rows, q: Rows) -> Any:
    """Return the points after the rotation by quaternions of any safe length, by their matrices."""
    c, point = split(q), split(points)
    poison, fine = _measured(point)
    square = sum_of_squares(c)
    part = 1.0 / tracing.sqrt(square)
    image = action.by_rows(matrix_entries(tuple(a * part for a in c)), point)
    return tuple(x + poison for x in image), fine & _safe(square)


def _quaternions_carefully(points: Rows, q: Rows) -> Any:
    return action.turned_by(tuple(normalise(q)), split(points), False)


def _euler(axes: tuple[int, ...], backward: bool, degrees: bool, points: Rows, angles: Rows) -> Any:
    """Rotate about coordinate axes one after the other."""
    turns = split(angles)
    poison, fine = _measured(split(points))
    for t in turns:
        fine = fine & _reachable(t)
    waves = [_sincos(t, degrees) for t in (turns[::-1] if backward else turns)]
    image = action.turned_about(axes, waves, split(points))
    return tuple(x + poison for x in image), fine


def _euler_carefully(
    axes: tuple[int, ...], backward: bool, degrees: bool, points: Rows, angles: Rows
) -> Any:
    return action.by_angles(angles, points, axes, backward, degrees)


def _contains_zero(rows: Rows) -> Any:
    return (), _safe(sum_of_squares(split(rows)))


def _contains_zero_carefully(rows: Rows) -> Any:
    zero, *others = (c == 0.0 for c in split(rows))
    for other in others:
        zero = zero & other
    tracing.tell(zero)
    return ()


_KERNELS = {
    "one": Kernel(_one),
    "axis_angle": Kernel(_axis_angle, _axis_angle_carefully),
    "quaternions": Kernel(_quaternions, _quaternions_carefully),
    "euler": Kernel(_euler, _euler_carefully),
    "contains_zero": Kernel(_contains_zero, _contains_zero_carefully),
}


def kernel(name: str, *parameters: Any) -> Kernel:
    """Return a kernel by its name; with that of Euler angles come the axes, and whether they go backward.

    With all of angles comes whether they are in degrees.
    """
    fast, careful = _KERNELS[name]
    return Kernel(partial(fast, *parameters), careful and partial(careful, *parameters))
