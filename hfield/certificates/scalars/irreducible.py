"""Irreducibility of integer polynomials over ℚ: modulo a prime, or because no set of roots makes a factor.

The second argument tries everything: a monic factor over ℚ has integer coefficients (Gauss), so the sums of
the k-th powers of its roots are integers; and of every set of some but not all roots one such sum is shown to
be none. The roots lie in discs, whose numbers are integers over 2^BITS.

If z₁, …, zₙ are different and wₖ = f(zₖ)/∏(zₖ − zₘ), the roots of a monic f lie in the discs around zₖ of the
radius n·|wₖ|, and as many in each connected part of their union as it has discs (Smith 1970). The zₖ may come
from anywhere; here they come from the iteration zₖ ↦ zₖ − wₖ.
"""

from fractions import Fraction
from itertools import product

from hfield.certificates.rejection import Rejected, reject, shown
from hfield.certificates.scalars.finite import Residues
from hfield.certificates.scalars.quotients import Quotient
from hfield.certificates.work import charge

PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29)
MAX_DEGREE = 14
BITS = 160
ROUNDS = 400
REFINED = 6

Disc = tuple[int, int, int]  # real part, imaginary part, radius
Complex = tuple[Fraction, Fraction]


def check_irreducible(f: list[int], name: str) -> None:
    """Reject a field unless its monic polynomial, low degree first, is shown to be irreducible."""
    if any(_is_irreducible_modulo(p, f) for p in PRIMES):
        return
    n = len(f) - 1
    if n > MAX_DEGREE:
        reject(
            f"that the modulus of {shown(name)} is irreducible is shown up to the degree {MAX_DEGREE} here"
        )
    discs = root_discs(f)
    sums = [[_power(disc, k) for disc in discs] for k in range(1, n + 1)]
    charge(5 * 2**n * n)
    for rest in product((False, True), repeat=n - 1):
        chosen = [0, *(k for k, taken in enumerate(rest, 1) if taken)]
        if len(chosen) < n and not any(_is_no_integer([row[k] for k in chosen]) for row in sums):
            reject(f"the modulus of {shown(name)} may be reducible")


def _is_irreducible_modulo(p: int, f: list[int]) -> bool:
    try:
        Quotient(Residues(p, True, f"GF({p})"), [c % p for c in f])
    except Rejected:
        return False
    return True


def _power(disc: Disc, k: int) -> Disc:
    """Return a disc around the k-th powers of the numbers of a disc."""
    x, y, radius = disc
    re, im, size = 1 << BITS, 0, abs(x) + abs(y) + radius
    bound, error = 1 << BITS, 0
    for _ in range(k):
        # |zw − z'w'| ≤ |z|·|w − w'| + |w'|·|z − z'|, and 2 for what is cut off
        error = (size * error + bound * radius >> BITS) + 4
        re, im = re * x - im * y >> BITS, re * y + im * x >> BITS
        bound = (bound * size >> BITS) + 3
    return re, im, error


def _is_no_integer(terms: list[Disc]) -> bool:
    """Tell whether the sum of numbers in these discs is surely no integer."""
    x, y, error = (sum(column) for column in zip(*terms, strict=True))
    away = min(x % (1 << BITS), -x % (1 << BITS))
    return bool(abs(y) > error or away > error)


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
