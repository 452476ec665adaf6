"""Sine and cosine of eight angles, in degrees or radians, without a branch."""

import math
from typing import Any

from rotation.angles import RADIANS
from rotation.native.tracing import ROUND, abs, bit, where

# π/2 = P1 + P2 + P3 with 23 bits in P1 and in P2: the products with a whole number below 2^30 and the
# differences are exact, with or without FMA (Cody and Waite 1980). P3 holds the next 53 bits.
REACH = 2.0**30
TWO_OVER_PI = 2.0 / math.pi
P1 = float.fromhex("0x1.921fb4p+0")
P2 = float.fromhex("0x1.4442dp-24")
P3 = float.fromhex("0x1.8469898cc517p-48")

# Minimax polynomials of sine and cosine on [−π/4, π/4] (fdlibm, Sun Microsystems 1993).
S1, S2, S3 = -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04
S4, S5, S6 = 2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10
C1, C2, C3 = 4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05
C4, C5, C6 = -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11


def reachable(x: Any) -> Any:
    """Tell whether the fast way reaches ``x``; NaN and inf are not reachable."""
    return abs(x) <= REACH


def sincos(x: Any, degrees: bool) -> Any:
    """Return sine and cosine of reachable lanes ``x``."""
    k = x * (1.0 / 90.0 if degrees else TWO_OVER_PI) + ROUND
    n = k - ROUND  # quarters of a turn
    if degrees:
        r = x - n * 90.0
        r = r * RADIANS[0] + r * RADIANS[1]
    else:
        r = ((x - n * P1) - n * P2) - n * P3
    z = r * r
    s = r + r * z * (S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)))))
    s = where(r != 0.0, s, r)  # the sum loses the sign of −0
    c = 1.0 - z * (0.5 - z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6))))))
    odd, beyond = bit(k, 0), bit(k, 1)  # the last two bits of n
    a, b = where(odd, c, s), where(odd, -s, c)
    return where(beyond, -a, a), where(beyond, -b, b)
