"""Elements of a given large norm in an order over ℤ, by quadratic frames (RepresentInteger).

A frame ``ℤ[α] + ℤ[α]·β`` has the norm form ``f(x, y) + N(β)·f(z, w)``. For random z and w the remaining norm
is prime with probability about 1/log, and then Cornacchia's algorithm represents it by f. So elements can be
found whose norms have hundreds of digits (Kohel, Lauter, Petit and Tignol, "On the quaternion ℓ-isogeny path
problem", 2014, section 3.2).
"""

from __future__ import annotations

import math
import random
from functools import lru_cache
from typing import TYPE_CHECKING

from flint import fmpz

from hfield.core.primality import is_probable_prime, primes
from hfield.fields.rationals.whole_numbers import sqrt_mod
from hfield.orders.quadratic_frames import QuadraticFrame, frame

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.orders.lattice_values import LatticeValue

FIRST_PRIMES = (2, 3, 5, 7, 11, 13)
SMALL_PRIMES = math.prod(p for p in primes(200) if p >= 17)
TRIALS = 50_000


def represent(d: int, m: int) -> tuple[int, int] | None:
    """Return (x, y) with ``x² + t·xy + n·y² = m``, t = d modulo 2, n = (t − d)/4, or None if none was found.

    It works only if m is a prime times a product of primes up to 13.
    """
    t = d % 2
    n = (t - d) // 4
    x, y = 1, 0
    for p in FIRST_PRIMES:
        while m % p == 0:
            m //= p
            root = _small(d, p)
            if root is None:  # inert: only squares are norms
                if m % p:
                    return None
                m //= p
                root = (p, 0)
            x, y = x * root[0] - n * y * root[1], x * root[1] + y * root[0] + t * y * root[1]
    if m == 1:
        return x, y
    if not likely(m):
        return None
    last = cornacchia(d, m)
    if last is None:
        return None
    return x * last[0] - n * y * last[1], x * last[1] + y * last[0] + t * y * last[1]


@lru_cache(maxsize=1024)
def _small(d: int, p: int) -> tuple[int, int] | None:
    t = d % 2
    n = (t - d) // 4
    span = range(-p, p + 1)
    return next(
        ((x, y) for y in range(p) for x in span if x * x + t * x * y + n * y * y == p), None
    )


def likely(m: int) -> bool:
    """Return whether m is a probable prime; trial division excludes most composite numbers.

    No proof is needed, because the norm of the element that is found is computed.
    """
    return (m < 40_000 or math.gcd(m, SMALL_PRIMES) == 1) and is_probable_prime(m)


def cornacchia(d: int, m: int) -> tuple[int, int] | None:
    """Return (x, y) with ``x² + t·xy + n·y² = m`` for a prime m > 13, or None.

    Cornacchia's algorithm (Cohen, *A Course in Computational Algebraic Number Theory*, 1.5.3).
    """
    t, absolute = d % 2, -d
    a, b, limit = 2 * m, 0, math.isqrt(4 * m)
    if d % m:
        if fmpz(d % m).jacobi(m) != 1:
            return None
        b = sqrt_mod(d, m)
    if (b - d) % 2:
        b = m - b
    while b > limit:
        a, b = b, a % b
    c, rest = divmod(4 * m - b * b, absolute)
    y = math.isqrt(c)
    if rest or y * y != c:
        return None
    return (b - t * y) // 2, y


def element_of_large_norm(order: LatticeValue, n: int, rng: random.Random) -> Quaternion | None:
    """Return an element of large norm n in an order over ℤ, or None if none was found."""
    f = frame(order)
    return in_frame(f, n, rng) if n % f.norm else _multiple_of_beta(f, n, rng)


def _multiple_of_beta(f: QuadraticFrame, n: int, rng: random.Random) -> Quaternion | None:
    """Return an element whose norm n is divisible by N(β): β times an element of norm n/N(β), or
    any other.
    """
    found = in_frame(f, n // f.norm, rng, TRIALS // 10)
    return in_frame(f, n, rng) if found is None else f.beta * found


def in_frame(
    f: QuadraticFrame, n: int, rng: random.Random, trials: int = TRIALS
) -> Quaternion | None:
    """Return an element of norm n of ``ℤ[α] + ℤ[α]·β``, or None after ``trials`` attempts."""
    bound = n // f.norm
    # f(z, w) ≥ |d|/(4·n)·z² and ≥ |d|/4·w²
    widest = math.isqrt(4 * bound // -f.discriminant)
    for _ in range(trials):
        w = rng.randint(-widest, widest)
        rest = bound + f.discriminant * w * w // 4
        half = math.isqrt(max(rest, 0))
        z = rng.randint(-half, half) - f.t * w // 2
        m = n - f.norm * f.binary(z, w)
        if m <= 0:
            continue
        found = represent(f.discriminant, m)
        if found is not None:
            return f.element(*found, z, w)
    return None
