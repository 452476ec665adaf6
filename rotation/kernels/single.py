"""The matrix of a single rotation, right to the last bit: it is used for every point."""

import math

import numpy as np

from rotation.angles import waves
from rotation.arrays import Array


def matrix_of_quaternion(q: Array) -> Array:
    """Return the 3 × 3 matrix of ``v ↦ q v q⁻¹``, every entry the float64 nearest to the exact one.

    A float is a whole number times a power of two, so the entries are quotients of whole numbers, and
    Python divides these with one rounding. No length of ``q`` over- or underflows. A ``q`` that is not
    finite gives NaN.
    """
    if not np.isfinite(q).all():
        return np.full((3, 3), np.nan)
    ratios = [float(c).as_integer_ratio() for c in q]
    common = max(denominator for _, denominator in ratios)
    w, x, y, z = (numerator * (common // denominator) for numerator, denominator in ratios)
    ww, xx, yy, zz = w * w, x * x, y * y, z * z
    n = ww + xx + yy + zz
    return np.array(
        [
            [(ww + xx - yy - zz) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
            [2 * (x * y + w * z) / n, (ww - xx + yy - zz) / n, 2 * (y * z - w * x) / n],
            [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (ww - xx - yy + zz) / n],
        ]
    )


def matrix_of_axis_angle(axis: Array, angle: Array, degrees: bool) -> Array:
    """Return the matrix of the rotation about ``axis``, of any length, by ``angle``."""
    if not (np.isfinite(axis).all() and math.isfinite(angle)):
        return np.full((3, 3), np.nan)
    a, b, c = (float(v) for v in axis)
    _, exponent = math.frexp(max(abs(a), abs(b), abs(c)))
    a, b, c = (math.ldexp(v, -exponent) for v in (a, b, c))
    half = 0.5 * float(angle)
    if degrees:
        sine, cosine = map(float, waves(np, np.float64(half), degrees))
    else:
        sine, cosine = math.sin(half), math.cos(half)
    scale = sine / math.hypot(a, b, c)
    return matrix_of_quaternion(np.array([cosine, a * scale, b * scale, c * scale]))
