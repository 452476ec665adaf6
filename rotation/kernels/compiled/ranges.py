"""What can be wrong with a row: a length that over- or underflows, zero, NaN, inf."""

import math
from typing import Any

import numpy as np

from rotation.kernels.compiled.compiling import inlined

# Between these a squared length, times a coordinate between those, neither overflows nor loses digits.
SMALL, LARGE = 2.0**-200, 2.0**200
LOW, HIGH = 2.0**-700, 2.0**700


@inlined
def safe(square: Any) -> Any:
    """Tell whether a squared length can be used as it is; NaN cannot."""
    return (square >= SMALL) & (square <= LARGE)


@inlined
def measured(point: Any) -> Any:
    """Return what to add to a result, −0 or NaN if a coordinate is not finite, and whether that is safe.

    It is not for points too large or small for a product with a squared length. Adding −0 changes no sum.
    """
    x, y, z = point
    size = abs(x) + (abs(y) + abs(z))
    return -(size - size), ~((size > HIGH) | ((size < LOW) & (size > 0.0)))


@inlined
def not_finite(x: Any, y: Any, z: Any) -> Any:
    """Return NaN if a number is NaN or inf, else −0, which changes no sum."""
    return -((x - x) + ((y - y) + (z - z)))


@inlined
def scaled(v: Any) -> Any:
    """Return four numbers times a power of two, the largest about 1, and that power's exponent, negated.

    Nothing is lost thereby; inf gives NaN.
    """
    a, b, c, d = v
    largest = max(max(abs(a), abs(b)), max(abs(c), abs(d)))
    exponent = max(math.frexp(largest)[1], -1000)
    factor = math.ldexp(1.0, -exponent) if largest < np.inf else np.nan
    return (a * factor, b * factor, c * factor, d * factor), exponent


@inlined
def zero(v: Any) -> Any:
    """Tell whether four numbers are all zero."""
    return v[0] == 0.0 and v[1] == 0.0 and v[2] == 0.0 and v[3] == 0.0


@inlined
def turned(q: Any, point: Any, poison: Any) -> Any:
    """Return the point after the rotation by the quaternion of any safe length, plus ``poison``.

    The matrix of w² + a² − b² − c², 2(ab − wc), … is applied first and divided by |q|² last: of the
    forms tried it has the smallest error, about 3·2⁻⁵² of the length, and needs no unit length.
    """
    w, a, b, c = q
    x, y, z = point
    ww, aa, bb, cc = w * w, a * a, b * b, c * c
    part = 1.0 / ((ww + aa) + (bb + cc))
    fx = (a * b - w * c) * y + (a * c + w * b) * z
    fy = (a * b + w * c) * x + (b * c - w * a) * z
    fz = (a * c - w * b) * x + (b * c + w * a) * y
    return (
        (((ww + aa) - (bb + cc)) * x + (2.0 * fx + poison)) * part,
        (((ww - aa) + (bb - cc)) * y + (2.0 * fy + poison)) * part,
        (((ww - aa) - (bb - cc)) * z + (2.0 * fz + poison)) * part,
    )
