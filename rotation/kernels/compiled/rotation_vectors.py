"""The kernel for the quaternions of rotation vectors: `rotation.vectors.from_rotvec`, to its last bit."""

import math
from typing import Any

import numpy as np

from rotation.kernels.compiled.access import at, put, throughout
from rotation.kernels.compiled.compiling import SOURCES, kernel, strict
from rotation.kernels.compiled.pairs import two_product, two_sum
from rotation.kernels.compiled.ranges import LARGE, SMALL
from rotation.kernels.compiled.series import SINE, VERSINE


@strict
def product(a: Any, b: Any) -> Any:
    """Return the product of two pairs."""
    p, e = two_product(a[0], b[0])
    return p, e + (a[0] * b[1] + a[1] * b[0])


@strict
def series(c: Any, t: Any) -> Any:
    """Return ``Σ c[k]·tᵏ`` of eight terms."""
    high = ((c[7] * t + c[6]) * t + c[5]) * t + c[4]
    return (((high * t + c[3]) * t + c[2]) * t + c[1]) * t + c[0]


@strict
def doubled(sine: Any, versine: Any) -> Any:
    """Return sine and ``1 − cos`` of twice the angle, as pairs."""
    p, q = product(sine, versine), product(sine, sine)
    high, low = two_sum(sine[0], -p[0])
    return (2.0 * high, 2.0 * (low + (sine[1] - p[1]))), (2.0 * q[0], 2.0 * q[1])


@strict
def sine_and_cosine(a: Any, b: Any) -> Any:
    """Return sine and cosine of ``a + b`` in [0, π/2] as pairs; see `rotation.compensated`."""
    x, rest = 0.25 * a, 0.25 * b
    t, e = two_product(x, x)
    sine = two_sum(x, x * t * series(SINE, t) + rest * (1.0 - 0.5 * t))
    versine = two_sum(0.5 * t, (0.5 * e + x * rest) + t * t * series(VERSINE, t))
    sine, versine = doubled(sine, versine)
    sine, versine = doubled(sine, versine)
    high, low = two_sum(1.0, -versine[0])
    return sine, (high, low - versine[1])


@strict
def loop(vectors: Any, out: Any, m: Any, extra: Any) -> Any:
    """Convert ``m`` vectors; return whether some are left to others, their quaternions NaN."""
    zero, unit = extra
    left = False
    for i in range(m):
        x, y, z = at(vectors, 3, i, 0, zero), at(vectors, 3, i, 1, zero), at(vectors, 3, i, 2, zero)
        high, low = two_product(x, x)
        p, e = two_product(y, y)
        high, f = two_sum(high, p)
        low = low + (e + f)
        p, e = two_product(z, z)
        high, f = two_sum(high, p)
        low = low + (e + f)
        n = math.sqrt(high)
        square, e = two_product(n, n)
        n_low = (((high - square) - e) + low) / (2.0 * n)
        a, b = (0.5 * n) * unit, (0.5 * n_low) * unit
        sine, cosine = sine_and_cosine(a, b)
        ratio = sine[0] / n
        p, e = two_product(ratio, n)
        rest = (((sine[0] - p) - e) - ratio * n_low) / n
        rest = rest + sine[1] / n
        done = (high >= SMALL) & (high <= LARGE) & (a < 0.5 * math.pi)
        left |= not done
        w = cosine[0] + cosine[1]
        put(out, 4, i, 0, w if done else np.nan)
        p, e = two_product(ratio, x)
        put(out, 4, i, 1, p + (e + rest * x))
        p, e = two_product(ratio, y)
        put(out, 4, i, 2, p + (e + rest * y))
        p, e = two_product(ratio, z)
        put(out, 4, i, 3, p + (e + rest * z))
    return left


@kernel
def rotation_vectors(
    counter: Any,
    outer: Any,
    inner: Any,
    table: Any,
    zero: Any,
    unit: Any,
    sources: int = SOURCES,
) -> Any:
    """Write the quaternions of vectors in one piece, as long as half a turn at most.

    ``unit`` radians are one of angle. Returns whether some are left: longer ones, tiny ones, zeros,
    inf and NaN.
    """
    return throughout(loop, counter, outer, inner, table, (zero, unit))
