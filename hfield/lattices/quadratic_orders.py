"""Quadratic orders inside a quaternion order: embeddings, and a frame ``ℤ[α] + ℤ[α]·β`` with α small.

The elements ``s = 2x − tr(x)`` are those of trace 0 in ``ℤ + 2O``, and s² is the discriminant of ``ℤ[x]``;
so the quadratic orders of discriminant d in O are vectors of norm −d of a ternary lattice. They are
embedded optimally when the vector is primitive (Voight, *Quaternion Algebras*, chapter 30; Gross, 1987).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

from flint import fmpz, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError
from hfield.lattices import certificates, enumeration, hermite
from hfield.lattices.certificates import Certified, Claim
from hfield.primality import is_probable_prime, primes
from hfield.rings.whole_numbers import sqrt_mod

if TYPE_CHECKING:
    from hfield.lattices.order import Order


@dataclass(frozen=True)
class Embeddings(Certified):
    """The optimal embeddings of the quadratic order of ``discriminant`` in an order of a definite algebra.

    ``elements`` are the images of ``(d + √d)/2``; ``orbits`` counts them up to conjugation by units.
    """

    order: Order
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
        return certificates.of_embeddings(self)

    def __len__(self) -> int:
        return len(self.elements)

    def __bool__(self) -> bool:
        """Tell whether there is an optimal embedding."""
        return bool(self.elements)


def embeddings(order: Order, d: int) -> Embeddings:
    """Return the optimal embeddings of the order of discriminant d < 0.

    Raises :class:`LatticeError` for a d that is no negative discriminant, :class:`IndefiniteError`.
    """
    order._definite("embeddings()")
    if d >= 0 or d % 4 not in (0, 1):
        raise LatticeError(
            f"{d} is no discriminant of an imaginary quadratic order: expected d < 0, 0 or 1 modulo 4"
        )
    den, rows, gram = order._reduced_ternary
    order._affordable(enumeration.volume(gram, -2 * d, 2), "elements of norm at most")
    found = []
    for x in enumeration.vectors_of_length(gram, -2 * d):
        if math.gcd(*x) == 1:
            row = [int(c) for c in (fmpz_mat([list(x)]) * rows).entries()]
            found += [row, [-c for c in row]]
    elements = [(d + order._element(row, den)) / 2 for row in sorted(found, reverse=True)]
    units = order.units() if elements else ()
    return Embeddings(order, d, tuple(elements), _orbits(elements, units))


def _orbits(elements: list[Quaternion], units: tuple[Quaternion, ...]) -> int:
    left, number = set(elements), 0
    while left:
        x = left.pop()
        left -= {u * x * u.conjugate() for u in units}
        number += 1
    return number


@dataclass(frozen=True)
class Frame:
    """α and β in O with N(β) = ``norm`` and s·β = −β·s for s = 2α − t, s² = d, t = d modulo 2."""

    order: Order
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
def frame(order: Order) -> Frame:
    """Return the frame for a quadratic order of least discriminant in an order of a definite algebra."""
    _, _, gram = order._reduced_ternary
    return next(frames(order, min(gram[n][n] for n in range(3)) // 2))


@lru_cache(maxsize=64)
def extremal_frame(order: Order, largest: int) -> Frame | None:
    """Return a frame with d ≥ −largest and N(β) = p, the discriminant of the order, or None."""
    p = order._discriminant
    return next((f for f in frames(order, largest) if f.norm == p), None)


def frames(order: Order, largest: int) -> Iterator[Frame]:
    """Yield the frames for all optimally embedded quadratic orders with d ≥ −largest, by |d|."""
    _, _, gram = order._reduced_ternary
    short = sorted((value, v) for v, value in enumeration.short_vectors(gram, 2 * largest))
    yield from (_frame(order, v) for _, v in short if math.gcd(*v) == 1)


def _frame(order: Order, x: tuple[int, ...]) -> Frame:
    den, rows, _ = order._reduced_ternary
    s = [int(c) for c in (fmpz_mat([list(x)]) * rows).entries()]
    element = order._element(s, den)
    d = -int(str(element.norm()))
    alpha = (element + d % 2) / 2
    # elements with trace 0 and orthogonal to s
    r = order._regular
    forms = order._matrix * r.form
    conditions = forms * fmpz_mat([[1, s[0]], [0, s[1]], [0, s[2]], [0, s[3]]])
    stacked = [
        [*(int(c) for c in row), *(int(m == n) for n in range(4))]
        for m, row in enumerate(conditions.tolist())
    ]
    h = fmpz_mat(stacked).hnf()
    kernel = fmpz_mat([[int(h[m, n]) for n in range(2, 6)] for m in (2, 3)])
    plane = kernel * order._matrix
    small, steps = (plane * r.form * plane.transpose()).lll(transform=True, rep="gram")
    rows2 = hermite.tuples(steps * plane)
    beta = order._element(rows2[0] if small[0, 0] <= small[1, 1] else rows2[1])
    return Frame(order, d, int(str(beta.norm())), alpha, beta)


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
