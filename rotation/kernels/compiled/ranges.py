"""What can be wrong with a row: a length that over- or underflows, zero, NaN, inf."""

import math
from typing import Any

import numpy as np

from rotation.kernels.compiled.access import at, put
from rotation.kernels.compiled.compiling import called, inlined

# Between these a squared length neither overflows nor loses digits; others are scaled beforehand.
SMALL, LARGE = 2.0**-900, 2.0**900


@inlined
def safe(square: Any) -> Any:
    """Tell whether a squared length can be used as it is; NaN cannot."""
    return square >= SMALL and square <= LARGE


@called
def repair(v: Any, number: Any, m: Any, zero: Any) -> Any:
    """Scale the rows of a copy to a largest component of about 1; return whether one is zero.

    The scale is a power of two, so nothing is lost; a row with inf becomes NaN.
    """
    found = False
    for i in range(m):
        largest, nothing = 0.0, True
        for k in range(number):
            value = at(v, 1, i, k, zero)
            largest = max(largest, abs(np.float64(value)))
            nothing = nothing and value == 0.0
        found = found or nothing
        exponent = max(math.frexp(largest)[1], -1000)
        factor = math.ldexp(1.0, -exponent) if largest < np.inf else np.nan
        for k in range(number):
            value = np.float64(at(v, 1, i, k, zero)) * factor
            put(v, 1, i, k, type(zero)(value))
    return found


@inlined
def not_finite(x: Any, y: Any, z: Any) -> Any:
    """Return NaN if a coordinate is NaN or inf, else −0, which changes no sum."""
    return -((x - x) + ((y - y) + (z - z)))


@inlined
def turned(w: Any, a: Any, b: Any, c: Any, x: Any, y: Any, z: Any) -> Any:
    """Return the point (x, y, z) after the rotation by the quaternion (w, a, b, c) of any safe length.

    The matrix of w² + a² − b² − c², 2(ab − wc), … is applied first and divided by |q|² last: of the
    forms tried it has the smallest error, about 3·2⁻⁵² of the length, and needs no unit length.
    """
    ww, aa, bb, cc = w * w, a * a, b * b, c * c
    part = 1.0 / ((ww + aa) + (bb + cc))
    poison = not_finite(x, y, z)
    fx = (a * b - w * c) * y + (a * c + w * b) * z
    fy = (a * b + w * c) * x + (b * c - w * a) * z
    fz = (a * c - w * b) * x + (b * c + w * a) * y
    return (
        (((ww + aa) - (bb + cc)) * x + (2.0 * fx + poison)) * part,
        (((ww - aa) + (bb - cc)) * y + (2.0 * fy + poison)) * part,
        (((ww - aa) - (bb - cc)) * z + (2.0 * fz + poison)) * part,
    )
