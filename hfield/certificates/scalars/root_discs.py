"""Discs around the complex roots of an integer polynomial, each with one; numbers are integers over 2^BITS.

If z₁, …, zₙ are different and wₖ = f(zₖ)/∏(zₖ − zₘ), the roots of a monic f lie in the discs around zₖ of the
radius n·|wₖ|, and as many in each connected part of their union as it has discs (Smith 1970). The zₖ may come
from anywhere; here they come from the iteration zₖ ↦ zₖ − wₖ.
"""

from fractions import Fraction

from hfield.certificates.rejection import reject
from hfield.certificates.work import charge

BITS = 160
ROUNDS = 400
REFINED = 6

Disc = tuple[int, int, int]  # real part, imaginary part, radius
Complex = tuple[Fraction, Fraction]


def root_discs(f: list[int]) -> list[Disc]:
    """Return disjoint discs with one root each of a monic polynomial, low degree first, of degree ≥ 1."""
    n = len(f) - 1
    charge(ROUNDS * n * n + 100 * n**3 * REFINED)
    size = 1 + max(abs(c) for c in f[:-1])
    if size.bit_length() > 200:
        reject("the coefficients of a modulus are too large for its roots to be found here")
    radius = (
        max(abs(c) ** (1.0 / (n - k)) for k, c in enumerate(f[:-1]) if c) if any(f[:-1]) else 1.0
    )
    points = [radius * (0.4 + 0.9j) ** k for k in range(n)]
    for _ in range(ROUNDS):
        try:
            points = [z - _weight(f, points, k) for k, z in enumerate(points)]
        except (ZeroDivisionError, OverflowError):
            reject("the roots of a modulus are not found here")
    try:
        exact = [(Fraction(z.real), Fraction(z.imag)) for z in points]
    except (ValueError, OverflowError):
        reject("the roots of a modulus are not found here")
    for _ in range(REFINED):
        exact = [_cut(_minus(z, _exact_weight(f, exact, k))) for k, z in enumerate(exact)]
    discs = []
    for k, (x, y) in enumerate(exact):
        u, v = _exact_weight(f, exact, k)
        bound = (abs(u) + abs(v)) * n
        discs.append((int(x * 2**BITS), int(y * 2**BITS), int(bound * 2**BITS) + 1))
    for k, (x0, y0, r) in enumerate(discs):
        if any(max(abs(x0 - u0), abs(y0 - v0)) <= r + s for u0, v0, s in discs[:k]):
            reject("the roots of a modulus are not parted here")
    return discs


def _weight(f: list[int], points: list[complex], k: int) -> complex:
    z, value, below = points[k], 0j, 1 + 0j
    for c in reversed(f):
        value = value * z + c
    for m, w in enumerate(points):
        if m != k:
            below *= z - w
    return value / below


def _exact_weight(f: list[int], points: list[Complex], k: int) -> Complex:
    z = points[k]
    value, below = (Fraction(0), Fraction(0)), (Fraction(1), Fraction(0))
    for c in reversed(f):
        x, y = _times(value, z)
        value = x + c, y
    for m, w in enumerate(points):
        if m != k:
            below = _times(below, _minus(z, w))
    u, v = below
    size = u * u + v * v
    if not size:
        reject("the roots of a modulus are not parted here")
    x, y = _times(value, (u, -v))
    return x / size, y / size


def _times(z: Complex, w: Complex) -> Complex:
    return z[0] * w[0] - z[1] * w[1], z[0] * w[1] + z[1] * w[0]


def _minus(z: Complex, w: Complex) -> Complex:
    return z[0] - w[0], z[1] - w[1]


def _cut(z: Complex) -> Complex:
    """Return a number close by with denominator 2^BITS."""
    x, y = (Fraction(int(c * 2**BITS), 2**BITS) for c in z)
    return x, y
