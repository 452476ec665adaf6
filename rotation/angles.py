"""Degrees and radians. Whole turns are taken off in degrees, where that is exact."""

import math
from typing import Any

from rotation.namespaces import Array
from rotation.rowwise import rarely

_RADIANS = math.pi / 180.0


def radians(xp: Any, degrees: Array) -> Array:
    """Return degrees in radians, modulo two turns: 1e9 degrees lose nothing to the conversion.

    Two turns and not one, so that a quaternion made of the half angle keeps its sign.
    """
    size = xp.abs(degrees)
    far = ~(size < 720.0)
    (rest,) = rarely(xp, far, lambda: (_within_two_turns(xp, size, far),), (size,))
    return xp.where(degrees < 0.0, -rest, rest) * _RADIANS


def _within_two_turns(xp: Any, size: Array, far: Array) -> Array:
    return xp.where(far, xp.remainder(size, xp.full_like(size, 720.0)), size)


def to_degrees(radians: Array) -> Array:
    """Return radians in degrees."""
    return radians * (180.0 / math.pi)
