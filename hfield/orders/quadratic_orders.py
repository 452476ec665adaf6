"""Quadratic orders inside a quaternion order: embeddings, and a frame ``ℤ[α] + ℤ[α]·β`` with α small.

The elements ``s = 2x − tr(x)`` are those of trace 0 in ``ℤ + 2O``, and s² is the discriminant of ``ℤ[x]``;
so the quadratic orders of discriminant d in O are vectors of norm −d of a ternary lattice. They are
embedded optimally when the vector is primitive (Voight, *Quaternion Algebras*, chapter 30; Gross, 1987).

Inside O lies ``ℤ[α] + ℤ[α]·β``, of norm form ``f(x, y) + N(β)·f(z, w)``. For random z, w the rest is a
prime about once in as many times as it has digits, and Cornacchia's algorithm represents it by f: so elements
are found whose norm has hundreds of digits (Kohel, Lauter, Petit and Tignol, "On the quaternion ℓ-isogeny
path problem", 2014, section 3.2). Small norms are decided by enumeration.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import product
from operator import mul
from typing import Any

from flint import fmpz, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.core.factorisation import factorise, remove
from hfield.core.primality import is_probable_prime, primes
from hfield.errors import LatticeError, UndecidedError, shorten
from hfield.evidence import Certified, Claim
from hfield.orders import certificates, enumeration, hermite
from hfield.orders.invariants import is_eichler
from hfield.orders.short_elements import expect_affordable, expect_definite, of_norm
from hfield.orders.z_order import ZOrder
from hfield.rings.whole_numbers import sqrt_mod


@dataclass(frozen=True)
class Embeddings(Certified):
    """The optimal embeddings of the quadratic order of ``discriminant`` in an order of a definite algebra.

    ``elements`` are the images of ``(d + √d)/2``; ``orbits`` counts them up to conjugation by units.
    """

    order: Any  # an Order, whose class stands above
    discriminant: int
    elements: tuple[Quaternion, ...]
    orbits: int

    @property
    def element(self) -> Quaternion | None:
        """One of them, or None."""
        return self.elements[0] if self.elements else None

    @cached_property
    def claim(self) -> Claim:
        """What there is to certify, as a statement with its evidence."""
        return certificates.of_embedding(self.order.value, self.discriminant, self.element)

    def __len__(self) -> int:
        return len(self.elements)

    def __bool__(self) -> bool:
        """Tell whether there is an optimal embedding."""
        return bool(self.elements)


def embeddings(order: ZOrder, d: int) -> tuple[tuple[Quaternion, ...], int]:
    """Return the images of (d + √d)/2 under the optimal embeddings of an order, d < 0, and their orbits.

    Raises :class:`LatticeError` for a d that is no negative discriminant, :class:`IndefiniteError`.
    """
    expect_definite(order.ambient, "embeddings()")
    if d >= 0 or d % 4 not in (0, 1):
        raise LatticeError(
            f"{d} is no discriminant of an imaginary quadratic order: expected d < 0, 0 or 1 modulo 4"
        )
    den, rows, gram = order.reduced_ternary
    expect_affordable(enumeration.volume(gram, -2 * d, 2), "elements of norm at most")
    found = []
    for x in enumeration.vectors_of_length(gram, -2 * d):
        if math.gcd(*x) == 1:
            row = hermite.combination(x, rows)
            found += [row, tuple(-c for c in row)]
    elements = tuple((d + order.element(row, den)) / 2 for row in sorted(found, reverse=True))
    units = of_norm(order, Fraction(1)) if elements else ()
    left, orbits = set(elements), 0
    while left:
        q = left.pop()
        left -= {u * q * u.conjugate() for u in units}
        orbits += 1
    return elements, orbits


@dataclass(frozen=True)
class Frame:
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
def frame(order: ZOrder) -> Frame:
    """Return the frame for a quadratic order of least discriminant in an order of a definite algebra."""
    _, _, gram = order.reduced_ternary
    return next(frames(order, min(gram[n][n] for n in range(3)) // 2))


@lru_cache(maxsize=64)
def extremal_frame(order: ZOrder, largest: int) -> Frame | None:
    """Return a frame with d ≥ −largest and N(β) = p, the discriminant of the order, or None."""
    p = order.discriminant
    return next((f for f in frames(order, largest) if f.norm == p), None)


def frames(order: ZOrder, largest: int) -> Iterator[Frame]:
    """Yield the frames for all optimally embedded quadratic orders with d ≥ −largest, by |d|."""
    _, _, gram = order.reduced_ternary
    short = sorted((value, v) for v, value in enumeration.short_vectors(gram, 2 * largest))
    yield from (_frame(order, v) for _, v in short if math.gcd(*v) == 1)


def _frame(order: ZOrder, x: tuple[int, ...]) -> Frame:
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
    return Frame(d, int(str(beta.norm())), alpha, beta)


SMALL = (2, 3, 5, 7, 11, 13)


def represent(d: int, m: int) -> tuple[int, int] | None:
    """Return (x, y) with ``x² + t·xy + n·y² = m``, t = d modulo 2, n = (t − d)/4, or None if none was found.

    For m a prime times a product of primes up to 13 only.
    """
    t = d % 2
    n = (t - d) // 4
    x, y = 1, 0
    for p in SMALL:
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
    """Tell whether m is a probable prime; most composite numbers are sorted out by their small factors.

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


ENUMERATED = 2 * 10**5
TRIALS = 50_000


def represent_integer(order: ZOrder, n: int, seed: int | None = None) -> Quaternion | None:
    """Return an element of O of norm n, or None where an enumeration, or a prime, shows that there is none.

    Raises :class:`IndefiniteError`, and :class:`UndecidedError` where n is too large to enumerate and nothing
    was found.
    """
    expect_definite(order.ambient, "represent_integer()")
    rows, gram = order.reduced
    if enumeration.volume(gram, 2 * n, 3) < ENUMERATED:
        for x in enumeration.vectors_of_length(gram, 2 * n):
            return order.element(hermite.combination(x, rows))
        return None
    if not is_eichler(order) and any(
        is_obstructed(order, p, n) for p in factorise(order.discriminant)
    ):
        return None
    found = in_frame(frame(order), n, random.Random(0 if seed is None else seed))
    if found is None:
        raise UndecidedError(
            f"no element of norm {shorten(n)} was found in {TRIALS} trials; the order contains quadratic "
            f"orders of discriminant {shorten(frame(order).discriminant)} and beyond only"
        )
    return found


TRIED = 20_000
"""No more classes of elements modulo powers of a prime than this are tried for a local obstruction."""


def is_obstructed(order: ZOrder, p: int, n: int) -> bool:
    """Tell whether no element has the norm n in the completion at p; False where that is not seen.

    An x outside of p·O with N(x) − n small beside the derivatives tr(x·conj(y)) can be changed to one of norm
    n (Hensel); one in p·O has the norm of one of norm n/p².
    """
    if p**4 > TRIED:
        return False
    classes = list(product(range(p), repeat=4))
    level, k = classes[1:], 1
    while level:
        rest = []
        for x in level:
            difference = order.trace_and_norm(x)[1] - n
            if difference % p**k:
                continue
            slopes = (sum(map(mul, row, x)) for row in order.gram)
            slope = min((remove(s, p)[0] for s in slopes if s), default=math.inf)
            if not difference or remove(difference, p)[0] > 2 * slope:
                return False
            rest.append(x)
        if len(rest) * len(classes) > TRIED:
            return False
        level = [
            tuple(a + p**k * b for a, b in zip(x, v, strict=True)) for x in rest for v in classes
        ]
        k += 1
    return bool(n % p**2) or is_obstructed(order, p, n // p**2)


def in_frame(f: Frame, n: int, rng: random.Random, trials: int = TRIALS) -> Quaternion | None:
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
