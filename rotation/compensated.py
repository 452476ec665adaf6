"""Sums, products, quotients, roots, sines and angles as pairs of floats (high, low), with twice the digits.

The functions run on every array library. For symbols the angle of a point is computed by
`rotation.native.elementary`.
"""

import math
from collections.abc import Iterable

from rotation.array_types import Array, Namespace
from rotation.coordinates import polynomial, root
from rotation.native.pairs import FMA, Pair, PairLike, two_product, two_sum

# Taylor: sin x = x + x³·Σ SINE[k]·x²ᵏ and 1 − cos x = x²/2 + x⁴·Σ VERSINE[k]·x²ᵏ, without their first terms,
# which are carried in twice the precision. They reach below 2⁻⁶⁰ up to π/8.
SINE = tuple((-1.0) ** k / math.factorial(2 * k + 1) for k in range(1, 9))
VERSINE = tuple((-1.0) ** (k + 1) / math.factorial(2 * k) for k in range(2, 10))


def total(pairs: Iterable[Pair]) -> Pair:
    """Return the sum of pairs as a pair."""
    (high, low), *others = pairs
    for p, e in others:
        high, f = two_sum(high, p)
        low = low + (e + f)
    return high, low


def norm(xp: Namespace, coordinates: Iterable[Array]) -> Pair:
    """Return ``√(Σ c²)`` as a pair, for coordinates whose squares neither overflow nor underflow."""
    high, low = total(two_product(xp, c, c) for c in coordinates)
    n = root(xp, high)
    square, e = two_product(xp, n, n)
    safe = xp.where(n > 0.0, n, xp.ones_like(n))
    return n, (((high - square) - e) + low) * (0.5 * (1.0 / safe))


def quotient(xp: Namespace, a: Pair, b: Pair) -> Pair:
    """Return ``a / b`` as a pair."""
    inverse = 1.0 / b[0]
    q = a[0] * inverse
    p, e = two_product(xp, q, b[0])
    return q, ((((a[0] - p) - e) + a[1]) - q * b[1]) * inverse


def times(xp: Namespace, a: Pair, b: Array) -> Array:
    """Return ``a·b``, almost correctly rounded."""
    fma: FMA | None = getattr(xp, "fma", None)
    if fma is not None:
        return fma(a[0], b, a[1] * b)
    p, e = two_product(xp, a[0], b)
    found: Array = p + (e + a[1] * b)
    return found


def product(xp: Namespace, a: PairLike, b: PairLike) -> Pair:
    """Return ``a·b`` as a pair."""
    p, e = two_product(xp, a[0], b[0])
    return p, e + (a[0] * b[1] + a[1] * b[0])


def sine_and_cosine(xp: Namespace, angle: Pair) -> tuple[Pair, Pair]:
    """Return sine and cosine as pairs, accurate to about 58 bits, of angles in [0, π/2].

    Taylor series at a quarter of the angle, followed by the double-angle formulas twice. The cosine is
    represented as ``1 − cos``, so that small angles keep all their digits.
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


def angle(xp: Namespace, sine: Pair, cosine: Array) -> Pair:
    """Return as a pair the angle in [0, π/2] of ``(cosine, sine)``, a point close to the unit circle."""
    if hasattr(xp, "angle_of"):
        a, b = xp.angle_of(sine[0], cosine)
        return a, b + sine[1] * cosine
    a = xp.atan2(sine[0], cosine)
    s, c = sine_and_cosine(xp, (a, xp.zeros_like(a)))
    p, e = two_product(xp, sine[0], c[0])
    q, f = two_product(xp, cosine, s[0])
    return a, (p - q) + (((e - f) + (sine[0] * c[1] + sine[1] * c[0])) - cosine * s[1])
