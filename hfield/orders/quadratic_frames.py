"""Quadratic orders inside an order over ℤ as frames ``ℤ[α] + ℤ[α]·β`` with α small.

A frame has the norm form ``f(x, y) + N(β)·f(z, w)``. For random z, w the rest is a
prime about once in as many times as it has digits, and Cornacchia's algorithm represents it by f: so elements
are found whose norm has hundreds of digits (Kohel, Lauter, Petit and Tignol, "On the quaternion ℓ-isogeny
path problem", 2014, section 3.2).
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from flint import fmpz, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.core.primality import is_probable_prime, primes
from hfield.fields.rationals.whole_numbers import sqrt_mod
from hfield.orders import enumeration, hermite
from hfield.orders.lattice_values import LatticeValue, discriminant


@dataclass(frozen=True)
class QuadraticFrame:
    """α and β in O with N(β) = ``norm`` and s·β = −β·s for s = 2α − t, s² = d, t = d modulo 2."""

    discriminant: int
    norm: int
    alpha: Quaternion
    beta: Quaternion

    @property
    def t(self) -> int:
        """The trace of α."""
        return self.discriminant % 2

    @property
    def root(self) -> Quaternion:
        """The root s = 2α − t of the discriminant."""
        return 2 * self.alpha - self.t

    @property
    def n(self) -> int:
        """The norm of α."""
        return (self.t - self.discriminant) // 4

    def binary(self, x: int, y: int) -> int:
        """Return the norm of x + y·α."""
        return x * x + self.t * x * y + self.n * y * y

    def element(self, x: int, y: int, z: int, w: int) -> Quaternion:
        """Return x + y·α + (z + w·α)·β."""
        return x + y * self.alpha + (z + w * self.alpha) * self.beta


@lru_cache(maxsize=64)
def frame(order: LatticeValue) -> QuadraticFrame:
    """Return the frame for a quadratic order of least discriminant in an order of a definite algebra."""
    _, _, gram = order.reduced_ternary
    return next(frames(order, min(gram[n][n] for n in range(3)) // 2))


@lru_cache(maxsize=64)
def extremal_frame(order: LatticeValue, largest: int) -> QuadraticFrame | None:
    """Return a frame with d ≥ −largest and N(β) = p, the discriminant of the order, or None."""
    p = discriminant(order)
    return next((f for f in frames(order, largest) if f.norm == p), None)


def frames(order: LatticeValue, largest: int) -> Iterator[QuadraticFrame]:
    """Yield the frames for all optimally embedded quadratic orders with d ≥ −largest, by |d|."""
    _, _, gram = order.reduced_ternary
    short = sorted((value, v) for v, value in enumeration.short_vectors(gram, 2 * largest))
    yield from (_frame(order, v) for _, v in short if math.gcd(*v) == 1)


def _frame(order: LatticeValue, x: tuple[int, ...]) -> QuadraticFrame:
    den, rows, _ = order.reduced_ternary
    s = hermite.combination(x, rows)
    element = order.element(s, den)
    d = -int(str(element.norm()))
    alpha = (element + d % 2) / 2
    # elements with trace 0 and orthogonal to s
    r = order.ambient
    forms = order.matrix * r.trace_form
    conditions = forms * fmpz_mat([[1, s[0]], [0, s[1]], [0, s[2]], [0, s[3]]])
    stacked = [
        [*row, *(int(m == n) for n in range(4))] for m, row in enumerate(conditions.tolist())
    ]
    h = fmpz_mat(stacked).hnf()
    kernel = fmpz_mat([row[2:] for row in h.tolist()[2:]])
    plane = kernel * order.matrix
    small, steps = (plane * r.trace_form * plane.transpose()).lll(transform=True, rep="gram")
    rows2 = hermite.tuples(steps * plane)
    beta = order.element(rows2[0] if small[0, 0] <= small[1, 1] else rows2[1])
    return QuadraticFrame(d, int(str(beta.norm())), alpha, beta)


FIRST_PRIMES = (2, 3, 5, 7, 11, 13)


def represent(d: int, m: int) -> tuple[int, int] | None:
    """Return (x, y) with ``x² + t·xy + n·y² = m``, t = d modulo 2, n = (t − d)/4, or None if none was found.

    For m a prime times a product of primes up to 13 only.
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


SMALL_PRIMES = math.prod(p for p in primes(200) if p >= 17)


def likely(m: int) -> bool:
    """Return whether m is a probable prime; trial division excludes most composite numbers.

    No proof is needed: what is represented is an element, and its norm is known.
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


TRIALS = 50_000


def represent_integer(order: LatticeValue, n: int, rng: random.Random) -> Quaternion | None:
    """Return an element of norm n, large, of an order over ℤ, or None where none was found."""
    f = frame(order)
    return in_frame(f, n, rng) if n % f.norm else _multiple_of_beta(f, n, rng)


def _multiple_of_beta(f: QuadraticFrame, n: int, rng: random.Random) -> Quaternion | None:
    """Return an element of a norm n that N(β) divides: β times one of norm n/N(β), or any."""
    found = in_frame(f, n // f.norm, rng, TRIALS // 10)
    return in_frame(f, n, rng) if found is None else f.beta * found


def in_frame(
    f: QuadraticFrame, n: int, rng: random.Random, trials: int = TRIALS
) -> Quaternion | None:
    """Return an element of norm n of ``ℤ[α] + ℤ[α]·β``, or None after so many trials."""
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
