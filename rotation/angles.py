"""Convert between degrees and radians; quarter turns are subtracted in degrees, where this is exact.

The remainder, at most an eighth of a turn, is converted to radians with twice the digits. So sines and
cosines of degrees are as accurate as those of radians, and those of quarter turns are exactly 0 and ±1.
"""

import numpy as np

from rotation.array_types import Array, Namespace
from rotation.compensated import product, sine_and_cosine
from rotation.namespaces import namespace
from rotation.native.pairs import Pair, PairLike, two_sum
from rotation.rowwise import RowFormula, rarely

# π/180 and 180/π: as many bits as float32 holds, and the rest.
RADIANS = (float.fromhex("0x1.1df46ap-6"), float.fromhex("0x1.294e9c8ae0ec6p-33"))
_DEGREES = (float.fromhex("0x1.ca5dc2p+5"), float.fromhex("-0x1.670f8211e7ab4p-21"))


def waves(xp: Namespace, angle: Array, degrees: bool) -> tuple[Array, Array]:
    """Return sine and cosine of angles of any size, in degrees or radians."""
    if not degrees:
        if hasattr(xp, "waves"):
            (sine, _), (cosine, _) = xp.waves(angle)
            return sine, cosine
        return xp.sin(angle), xp.cos(angle)
    if type(angle) is np.ndarray:
        both = _BOTH(angle[..., None])
        return both[..., 0], both[..., 1]
    return _rounded(xp, angle)


def _rounded(xp: Namespace, angle: Array) -> tuple[Array, Array]:
    (s, s_low), (c, c_low) = waves_of_degrees(xp, (angle, xp.zeros_like(angle)))
    return s + s_low, c + c_low


def _both(angle: Array) -> Array:
    xp = namespace(angle)
    return xp.stack(_rounded(xp, angle[..., 0]), axis=-1)


_BOTH = RowFormula(_both, (1,))


def waves_of_degrees(xp: Namespace, angle: Pair) -> tuple[Pair, Pair]:
    """Return sine and cosine of degrees as pairs, accurate to about 58 bits."""
    far = ~(xp.abs(angle[0]) < 360.0)
    a, b = rarely(xp, far, lambda: two_sum(*(_within_a_turn(xp, x) for x in angle)), angle)
    quarters = xp.round(a / 90.0)
    sine, cosine = sine_and_cosine(xp, _times(xp, (a - 90.0 * quarters, b), RADIANS))
    turn = quarters - 4.0 * xp.round(quarters / 4.0)  # from −2 to 2
    odd, back = xp.abs(turn) == 1.0, (turn == -1.0) | (xp.abs(turn) == 2.0)
    parts = (
        (xp.where(odd, c, s), xp.where(odd, 0.0 - s, c)) for s, c in zip(sine, cosine, strict=True)
    )
    (s, c), (s_low, c_low) = ([xp.where(back, 0.0 - x, x) for x in part] for part in parts)
    return (s, s_low), (c, c_low)


def _within_a_turn(xp: Namespace, degrees: Array) -> Array:
    rest = xp.remainder(xp.abs(degrees), xp.full_like(degrees, 360.0))
    return xp.where(degrees < 0.0, -rest, rest)


def to_degrees(xp: Namespace, radians: Array) -> Array:
    """Return radians in degrees, rounded once."""
    high, low = in_degrees(xp, (radians, 0.0))
    return high + low


def in_degrees(xp: Namespace, radians: PairLike) -> Pair:
    """Convert a pair from radians to degrees."""
    return _times(xp, radians, _DEGREES)


def _times(xp: Namespace, angle: PairLike, factor: tuple[float, float]) -> Pair:
    high, low = factor
    return two_sum(*product(xp, angle, (xp.full_like(angle[0], high), low)))
