"""Sine, cosine and arctangent for eight rows at once, with an error of at most one ulp, and as pairs.

The functions are written against a namespace of symbols, like formulas. They branch only where the fast
computation is not accurate: for angles beyond `REACH` or too close to a multiple of π/2, for points near the
limits of the range of floats, and for infinities and NaN. Such rows use the functions of the system. W. J.
Cody and W. Waite, "Software manual for the elementary functions" (1980).
"""

import math
from collections.abc import Sequence
from itertools import zip_longest

from rotation.array_types import Array, Operand, SymbolNamespace
from rotation.native.pairs import (
    FMA,
    Pair,
    PairLike,
    plus_product,
    quick_two_sum,
    two_product,
    two_sum,
)

# π/2 in three parts of 53 bits. For |n| ≤ 2³⁰, an angle minus n times the first part is a float.
REACH = 2.0**30
TWO_OVER_PI = 2.0 / math.pi
HALF_PI = tuple(
    map(float.fromhex, ("0x1.921fb54442d18p+0", "0x1.1a62633145c07p-54", "-0x1.f1976b7ed8fbcp-110"))
)
SURE = 2.0**-90  # so n·π/2 is known to n·2⁻¹⁶⁰, and the remainder to 60 bits if it is above n·SURE

# Minimax polynomials of sine and cosine on [−π/4, π/4] (fdlibm, Sun Microsystems 1993):
# sin r = r + r³·Σ SINE[k]·r²ᵏ and cos r = 1 − r²/2 + r⁴·Σ COSINE[k]·r²ᵏ.
SINE = (
    -1.66666666666666324348e-01,
    8.33333333332248946124e-03,
    -1.98412698298579493134e-04,
    2.75573137070700676789e-06,
    -2.50507602534068634195e-08,
    1.58969099521155010221e-10,
)
COSINE = (
    4.16666666666666019037e-02,
    -1.38888888888741095749e-03,
    2.48015872894767294178e-05,
    -2.75573143513906633035e-07,
    2.08757232129817482790e-09,
    -1.13596475577881948265e-11,
)
# atan t = t + t³·Σ ATAN[k]·t²ᵏ on [−tan(π/8), tan(π/8)]: Remez's algorithm, to 2⁻⁵⁸ of t.
EIGHTH = 0.41421356237309503  # tan(π/8)
ATAN = (
    float.fromhex("-0x1.555555555554ap-2"),
    float.fromhex("0x1.9999999996e54p-3"),
    float.fromhex("-0x1.2492492314bcfp-3"),
    float.fromhex("0x1.c71c710349a01p-4"),
    float.fromhex("-0x1.745cfb1c1f928p-4"),
    float.fromhex("0x1.3b1131ddf1c1cp-4"),
    float.fromhex("-0x1.10ec416cd8b39p-4"),
    float.fromhex("0x1.df103b7bd7755p-5"),
    float.fromhex("-0x1.9cbd02c35ccbfp-5"),
    float.fromhex("0x1.3766d024fb7ddp-5"),
    float.fromhex("-0x1.241072e0880f3p-6"),
)
# π/4 with 50 bits, so that up to four times it is exact, and the remainder.
QUARTER, QUARTER_LOW = float.fromhex("0x1.921fb54442d18p-1"), float.fromhex("0x1.1a62633145c07p-55")
LOW, HIGH = 2.0**-400, 2.0**400  # between these the error of a quotient is found exactly


def sine_and_cosine(
    xp: SymbolNamespace, a: Array, b: Array | None = None
) -> tuple[PairLike, PairLike]:
    """Return rounded sine and cosine of angles, and 0; with b, pairs.

    With b (below an ulp of a) they are the sine and cosine of ``a + b`` as pairs, accurate to about 56 bits.
    """
    (s, s_low), (c, c_low), right = near(xp, a, b)

    def far() -> tuple[Array, ...]:
        y, x = xp.library("sin", a), xp.library("cos", a)
        if b is None:
            return xp.where(right, s, y), xp.where(right, c, x)
        p, q = xp.library("sin", b), xp.library("cos", b)
        sine, cosine, zero = y * q + x * p, x * q - y * p, xp.zeros_like(y)
        found = zip((s, c, s_low, c_low), (sine, cosine, zero, zero), strict=True)
        return tuple(xp.where(right, f, g) for f, g in found)

    usual = (s, c) if b is None else (s, c, s_low, c_low)
    s, c, *lows = xp.rarely(~right, far, usual)
    sine_low, cosine_low = lows or (0.0, 0.0)
    return (s, sine_low), (c, cosine_low)


def near(xp: SymbolNamespace, a: Array, b: Array | None = None) -> tuple[Pair, Pair, Array]:
    """Return sine and cosine of ``a`` or of ``a + b`` as pairs, and a mask of where they are accurate."""
    k = a * TWO_OVER_PI + xp.ROUND
    n = k - xp.ROUND  # quarters of a turn
    t, (p, p_low) = _rest(xp, a, n), two_product(xp, n, HALF_PI[1])
    r, low = two_sum(t, -p)
    low = plus_product(xp, low - p_low, n, -HALF_PI[2])
    if b is not None:
        r, e = two_sum(r, b)
        low = low + e
    (s, s_low), cosine = of_rest(xp, k, r, low)
    s = xp.where(a == 0.0, a, s)  # −0 has the sine −0
    return (s, s_low), cosine, (xp.abs(a) <= REACH) & (xp.abs(r) >= xp.abs(n) * SURE)


def of_rest(xp: SymbolNamespace, k: Array, r: Array, low: Array) -> tuple[Pair, Pair]:
    """Return sine and cosine of ``r + low``, at most an eighth of a turn, plus k quarter turns."""
    z, z_low = two_product(xp, r, r)
    half = 0.5 * z
    u, u_low = quick_two_sum(1.0, -half)
    bent = low - half * low  # how the rest turns the sine
    s = quick_two_sum(r, plus_product(xp, bent, r * z, _sum(xp, SINE, z)))
    rest = u_low - plus_product(xp, 0.5 * z_low, r, low)
    c = quick_two_sum(u, plus_product(xp, rest, z * z, _sum(xp, COSINE, z)))
    odd, beyond = xp.bit(k, 0), xp.bit(k, 1)  # the last two bits of the quarters
    sine = (xp.where(odd, y, x) for x, y in zip(s, c, strict=True))
    cosine = (xp.where(odd, -x, y) for x, y in zip(s, c, strict=True))
    (high, low), (other, other_low) = (
        [xp.where(beyond, -x, x) for x in pair] for pair in (sine, cosine)
    )
    return (high, low), (other, other_low)


def _rest(xp: SymbolNamespace, a: Array, n: Array) -> Array:
    """Return ``a − n·HALF_PI[0]``, exactly."""
    fma: FMA | None = getattr(xp, "fma", None)
    if fma is not None:
        return fma(-n, HALF_PI[0], a)
    p, e = two_product(xp, n, HALF_PI[0])
    return (a - p) - e


def angle_of(xp: SymbolNamespace, y: Array, x: Array, pair: bool = True) -> PairLike:
    """Return the angle in [−π, π] of the point (x, y), as a pair of 56 bits, or rounded and 0."""
    p, q = xp.abs(y), xp.abs(x)
    steep, back = p > q, x < 0.0
    small, large = xp.where(steep, q, p), xp.where(steep, p, q)
    # atan(s/l) is π/4 + atan((s − l)/(s + l)) if the quotient is above tan(π/8).
    eighth = small > EIGHTH * large
    d, d_low = quick_two_sum(-large, small)
    w, w_low = quick_two_sum(large, small)
    zero = xp.zeros_like(small)
    above, above_low = xp.where(eighth, d, small), xp.where(eighth, d_low, zero)
    below, below_low = xp.where(eighth, w, large), xp.where(eighth, w_low, zero)
    part = 1.0 / below
    t = above * part
    f, f_low = two_product(xp, t, below)
    rest = ((above - f) - f_low) + (above_low - t * below_low)
    z = t * t
    low = plus_product(xp, rest * part, t * z, _sum(xp, ATAN, z))
    # Eighths of a turn k and a sign: k·π/4 ± atan t.
    minus = xp.where(steep, ~back, back)
    sign = xp.where(minus, -1.0 + zero, 1.0 + zero)
    k = xp.where(steep, 2.0 + zero, xp.where(back, 4.0 + zero, zero))
    k = xp.where(eighth, k + sign, k)
    t, low = sign * t, sign * low
    high, e = quick_two_sum(k * QUARTER, t)
    high, low = quick_two_sum(high, e + plus_product(xp, low, k, QUARTER_LOW))
    right = (large <= HIGH) & ((small >= LOW) | ((small == 0.0) & (large >= LOW)))
    usual = [xp.copysign(high, y)]
    if pair:
        usual.append(xp.where(xp.copysign(1.0, y) < 0.0, -low, low))

    def anyhow() -> tuple[Array, ...]:
        system = (xp.library("atan2", y, x), zero)
        return tuple(xp.where(right, f, g) for f, g in zip(usual, system, strict=False))

    high, *lows = xp.rarely(~right, anyhow, tuple(usual))
    return high, lows[0] if lows else 0.0


def _sum(xp: SymbolNamespace, coefficients: Sequence[Operand], z: Array) -> Operand:
    """Return ``Σ coefficients[k]·zᵏ`` by Estrin's scheme, which has few dependent steps."""
    if len(coefficients) == 1:
        return coefficients[0]
    pairs = zip_longest(coefficients[::2], coefficients[1::2])
    halved = [c if d is None else plus_product(xp, c, z, d) for c, d in pairs]
    return _sum(xp, halved, z * z)
