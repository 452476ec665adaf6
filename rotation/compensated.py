"""Sums and products of floats with what rounding cut off: pairs (high, low) worth twice the digits.

T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18
(1971). Only + − × are used, so it runs on every array library; no fused multiply-add is needed.
"""

import math
from collections.abc import Iterable
from typing import Any

from rotation.coordinates import polynomial, root
from rotation.namespaces import Array

Pair = tuple[Array, Array]

# Taylor: sin x = x + x³·Σ SINE[k]·x²ᵏ and 1 − cos x = x²/2 + x⁴·Σ VERSINE[k]·x²ᵏ, without their first terms,
# which are carried in twice the precision. They reach below 2⁻⁶⁰ up to π/8.
SINE = tuple((-1.0) ** k / math.factorial(2 * k + 1) for k in range(1, 9))
VERSINE = tuple((-1.0) ** (k + 1) / math.factorial(2 * k) for k in range(2, 10))


def two_sum(a: Array, b: Array) -> Pair:
    """Return ``a + b`` rounded, and the error."""
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def two_product(xp: Any, a: Array, b: Array) -> Pair:
    """Return ``a·b`` rounded, and the error; for factors far from overflow and underflow."""
    p = a * b
    fma = getattr(xp, "fma", None)  # the error is a float: either way it is found exactly
    if fma is not None:
        return p, fma(a, b, -p)
    a1, a2 = _halves(xp, a)
    b1, b2 = _halves(xp, b)
    return p, ((a1 * b1 - p) + (a1 * b2 + a2 * b1)) + a2 * b2


def total(pairs: Iterable[Pair]) -> Pair:
    """Return the sum of pairs as a pair."""
    high: Array = 0.0
    low: Array = 0.0
    for p, e in pairs:
        high, f = two_sum(high, p)
        low = low + (e + f)
    return high, low


def norm(xp: Any, coordinates: Iterable[Array]) -> Pair:
    """Return ``√(Σ c²)`` as a pair; for coordinates whose squares neither overflow nor vanish."""
    high, low = total(two_product(xp, c, c) for c in coordinates)
    n = root(xp, high)
    square, e = two_product(xp, n, n)
    safe = xp.where(n > 0.0, n, xp.ones_like(n))
    return n, (((high - square) - e) + low) / (2.0 * safe)


def quotient(xp: Any, a: Array, b: Pair) -> Pair:
    """Return ``a / b`` as a pair."""
    q = a / b[0]
    p, e = two_product(xp, q, b[0])
    return q, (((a - p) - e) - q * b[1]) / b[0]


def product(xp: Any, a: Pair, b: Pair) -> Pair:
    """Return ``a·b`` as a pair."""
    p, e = two_product(xp, a[0], b[0])
    return p, e + (a[0] * b[1] + a[1] * b[0])


def sine_and_cosine(xp: Any, angle: Pair) -> tuple[Pair, Pair]:
    """Return sine and cosine as pairs, right to about 58 bits, of angles in [0, π/2].

    Taylor's series at a quarter of the angle, and twice the formulas for the double angle; the
    cosine is carried as ``1 − cos``, so that small angles keep all their digits.
    """
    x, rest = 0.25 * angle[0], 0.25 * angle[1]
    t, e = two_product(xp, x, x)
    odd, even = polynomial(SINE, t), polynomial(VERSINE, t)
    sine = two_sum(x, x * t * odd + rest * (1.0 - 0.5 * t))
    versine = two_sum(0.5 * t, (0.5 * e + x * rest) + t * t * even)
    for _ in range(2):
        p, q = product(xp, sine, versine), product(xp, sine, sine)
        high, low = two_sum(sine[0], -p[0])
        sine = (2.0 * high, 2.0 * (low + (sine[1] - p[1])))
        versine = (2.0 * q[0], 2.0 * q[1])
    high, low = two_sum(xp.ones_like(t), -versine[0])
    return sine, (high, low - versine[1])


def angle(xp: Any, sine: Pair, cosine: Array) -> Pair:
    """Return as a pair the angle in [0, π/2] of ``(cosine, sine)``, a point near the unit circle."""
    a = xp.atan2(sine[0], cosine)
    s, c = sine_and_cosine(xp, (a, xp.zeros_like(a)))
    p, e = two_product(xp, sine[0], c[0])
    q, f = two_product(xp, cosine, s[0])
    return a, (p - q) + (((e - f) + (sine[0] * c[1] + sine[1] * c[0])) - cosine * s[1])


def _halves(xp: Any, a: Array) -> Pair:
    """Two halves of the digits of each float."""
    single = hasattr(a, "dtype") and xp.finfo(a.dtype).bits == 32
    t = (4097.0 if single else 134217729.0) * a  # 2¹² + 1, 2²⁷ + 1
    high = t - (t - a)
    return high, a - high
