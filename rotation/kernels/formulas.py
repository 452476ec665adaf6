"""The formulas of the kernels: the fast form of each, on eight points at once, and the careful one.

The fast form also says where it is right: not for a far angle, nor where the square of a length times a
coordinate might leave the range of floats. The careful form is that of few points.
"""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

from rotation import action
from rotation.angles import RADIANS
from rotation.coordinates import Coordinates, split, sum_of_squares
from rotation.native import tracing
from rotation.native.elementary import COSINE, REACH, SINE, TWO_OVER_PI
from rotation.native.symbols import Rows
from rotation.quaternions import normalise

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
    """Return v + (|a| sin θ (a × v) + (1 − cos θ) a × (a × v)) / |a|².

    Of the cheap forms tried it has the smallest error, below 4·2⁻⁵²·|v|, since |a|² is divided by but once.
    """
    (a, b, c), (x, y, z), (t,) = split(axis), split(points), split(angle)
    square = a * a + b * b + c * c
    sine, cosine = _sincos(t, degrees)
    poison, fine = _measured((x, y, z))
    w, versine, part = tracing.sqrt(square) * sine, 1.0 - cosine, 1.0 / square
    fx, fy, fz = b * z - c * y, c * x - a * z, a * y - b * x
    return (
        x + part * (w * fx + (versine * (b * fz - c * fy) + poison)),
        y + part * (w * fy + (versine * (c * fx - a * fz) + poison)),
        z + part * (w * fz + (versine * (a * fy - b * fx) + poison)),
    ), fine & _reachable(t) & _safe(square)


def _axis_angle_carefully(degrees: bool, points: Rows, axis: Rows, angle: Rows) -> Any:
    return action.about_axis(axis, angle, points, degrees)


def _quaternions(points: Rows, q: Rows) -> Any:
    """Return the points after the rotation by quaternions of any safe length.

    The matrix of w² + a² − b² − c², 2(ab − wc), … is applied first and divided by |q|² last: of the
    forms tried it has the smallest error, about 3·2⁻⁵² of the length, and needs no unit length.
    """
    (w, a, b, c), (x, y, z) = split(q), split(points)
    poison, fine = _measured((x, y, z))
    ww, aa, bb, cc = w * w, a * a, b * b, c * c
    square = (ww + aa) + (bb + cc)
    part = 1.0 / square
    fx = (a * b - w * c) * y + (a * c + w * b) * z
    fy = (a * b + w * c) * x + (b * c - w * a) * z
    fz = (a * c - w * b) * x + (b * c + w * a) * y
    return (
        (((ww + aa) - (bb + cc)) * x + (2.0 * fx + poison)) * part,
        (((ww - aa) + (bb - cc)) * y + (2.0 * fy + poison)) * part,
        (((ww - aa) - (bb - cc)) * z + (2.0 * fz + poison)) * part,
    ), fine & _safe(square)


def _quaternions_carefully(points: Rows, q: Rows) -> Any:
    return action.turned_by(Rows((4,), list(normalise(q))), split(points), False)


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
