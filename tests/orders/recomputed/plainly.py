"""Quaternions and lattices on rational numbers alone: what the package computes, computed another way.

A quaternion is ``u + v·j`` with u, v in ℚ(i), so the product follows from ``j·u = conj(u)·j`` (Cayley and
Dickson). A lattice is the triangle of rows that Euclid's algorithm leaves; short elements are those of a
box. Nothing here is shared with :mod:`hfield`, which is read only for the rows of its answers.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from flint import fmpq

Vector = tuple[Any, ...]
Rows = tuple[Vector, ...]
Binary = tuple[Any, Any]

ONE: Vector = (fmpq(1), fmpq(0), fmpq(0), fmpq(0))
MAX_STEPS = 300
"""Very skew bases are left as they are then."""
LARGEST_BOX = 400
"""Boxes have about this many points at most: so far norms are compared."""


def rational(x: Any) -> Any:
    """A rational number of any kind as one of flint, whose arithmetic is quick."""
    return fmpq(int(x.numerator), int(x.denominator))


def vector(q: Any) -> Vector:
    return tuple(q.coordinates)


def rows(lattice: Any) -> Rows:
    """The Hermite form that the package found."""
    den, found = lattice.hnf
    return tuple(tuple(fmpq(x, den) for x in row) for row in found)


def add(x: Vector, y: Vector) -> Vector:
    return tuple(p + q for p, q in zip(x, y, strict=True))


def times(n: Any, x: Vector) -> Vector:
    return tuple(n * c for c in x)


def combination(coefficients: Sequence[Any], basis: Sequence[Vector]) -> Vector:
    both = [(c, b) for c, b in zip(coefficients, basis, strict=True) if c]
    return tuple(sum((c * b[n] for c, b in both), fmpq(0)) for n in range(4))


class Plain:
    """The arithmetic of ``i² = a + t·i, j² = b``."""

    def __init__(self, A: Any) -> None:
        self.a, self.t, self.b = (rational(x) for x in A.constants)

    def _times(self, u: Binary, v: Binary) -> Binary:
        p = u[1] * v[1]
        return u[0] * v[0] + self.a * p, u[0] * v[1] + u[1] * v[0] + self.t * p

    def _bar(self, u: Binary) -> Binary:
        return u[0] + self.t * u[1], -u[1]

    def mul(self, x: Vector, y: Vector) -> Vector:
        u, v, w, z = (x[0], x[1]), (x[2], x[3]), (y[0], y[1]), (y[2], y[3])
        p, q = self._times(u, w), self._times(v, self._bar(z))
        r, s = self._times(u, z), self._times(v, self._bar(w))
        return p[0] + self.b * q[0], p[1] + self.b * q[1], r[0] + s[0], r[1] + s[1]

    def conj(self, x: Vector) -> Vector:
        u = self._bar((x[0], x[1]))
        return u[0], u[1], -x[2], -x[3]

    def trace(self, x: Vector) -> Any:
        return 2 * x[0] + self.t * x[1]

    def norm(self, x: Vector) -> Any:
        u, v = (x[0], x[1]), (x[2], x[3])
        return self._times(u, self._bar(u))[0] - self.b * self._times(v, self._bar(v))[0]

    def inverse(self, x: Vector) -> Vector:
        return times(1 / self.norm(x), self.conj(x))

    def pairing(self, x: Vector, y: Vector) -> Any:
        return self.trace(self.mul(x, self.conj(y)))

    def product(self, first: Iterable[Vector], second: Iterable[Vector]) -> Rows:
        return span(self.mul(x, y) for x, y in itertools.product(first, list(second)))

    def is_order(self, basis: Rows) -> bool:
        return holds(basis, ONE) and all(holds(basis, self.mul(x, y)) for x in basis for y in basis)

    def generated(self, elements: Sequence[Vector]) -> Rows:
        """The ring that elements of rank 4, with their products, generate: until nothing is new."""
        found = span([ONE, *elements, *(self.mul(x, y) for x in elements for y in elements)])
        while True:
            wider = span([*found, *(self.mul(x, y) for x in found for y in elements)])
            if wider == found:
                return found
            found = wider

    def colon(self, first: Rows, second: Rows, side: str = "left") -> Rows:
        """``{x : x·second ⊆ first}``: a condition on x for each product's coordinate."""
        back = inverse(first)
        conditions = []
        for y in second:
            images = [self.mul(e, y) if side == "left" else self.mul(y, e) for e in UNITS]
            lines = [combination(image, back) for image in images]
            conditions += [tuple(line[n] for line in lines) for n in range(4)]
        return dual(span(conditions))

    def norm_of(self, basis: Sequence[Vector]) -> Any:
        """The gcd of the norms of a basis and of the sums of two."""
        both = [*basis, *(add(x, y) for x, y in itertools.combinations(basis, 2))]
        return gcd(self.norm(x) for x in both)

    def gram(self, basis: Sequence[Vector]) -> list[list[Any]]:
        return [[self.pairing(x, y) for y in basis] for x in basis]

    def discriminant(self, basis: Sequence[Vector]) -> int:
        """The reduced discriminant of an order."""
        square = abs(determinant(self.gram(basis)))
        root = math.isqrt(int(square))
        assert root * root == square
        return root

    def shortened(self, basis: Sequence[Vector]) -> list[Vector]:
        """A basis of the same lattice: multiples of one element taken off another while it gets shorter."""
        gram, n = self.gram(basis), len(basis)
        steps = [[int(r == c) for c in range(n)] for r in range(n)]
        for _ in range(MAX_STEPS):
            pairs = itertools.permutations(range(n), 2)
            r, k = next(((r, k) for r, k in pairs if 2 * abs(gram[r][k]) > gram[k][k]), (0, 0))
            if r == k:
                break
            c = round(gram[r][k] / gram[k][k])
            steps[r] = [x - c * y for x, y in zip(steps[r], steps[k], strict=True)]
            gram[r] = [x - c * y for x, y in zip(gram[r], gram[k], strict=True)]
            for line in gram:
                line[r] -= c * line[k]
        return [combination(step, basis) for step in steps]

    def short(self, basis: Sequence[Vector], bound: Any) -> Iterator[tuple[Vector, Any]]:
        """All elements of norm at most a bound, of a definite algebra, with their norms."""
        half = [[x / 2 for x in row] for row in self.gram(basis)]
        back = inverse(half)
        sides = [math.isqrt(math.floor(bound * back[n][n])) for n in range(len(basis))]
        scale = math.lcm(*(x.denominator for row in half for x in row))
        form = [[int(x * scale) for x in row] for row in half]
        largest = bound * scale
        for c in itertools.product(*(range(-s, s + 1) for s in sides)):
            value = sum(
                c[m] * (form[m][m] * c[m] + 2 * sum(form[m][n] * c[n] for n in range(m)))
                for m in range(len(basis))
            )
            if value <= largest:
                yield combination(c, basis), fmpq(value, scale)

    def volume_of_box(self, basis: Sequence[Vector], bound: Any) -> int:
        """How many points the box for :meth:`short` has."""
        back = inverse([[x / 2 for x in row] for row in self.gram(basis)])
        sides = [2 * math.isqrt(math.floor(bound * back[n][n])) + 1 for n in range(len(basis))]
        return math.prod(sides)

    def affordable(self, basis: Sequence[Vector], bound: Any) -> bool:
        """Whether the box for :meth:`short` is small enough to be run through."""
        return self.volume_of_box(basis, bound) <= LARGEST_BOX

    def sample_bound(self, basis: Sequence[Vector]) -> Any:
        """A norm up to which elements may be listed, as large as is affordable."""
        bound = min(self.norm(x) for x in basis)
        while self.affordable(basis, 2 * bound):
            bound *= 2
        return bound


def gcd(numbers: Iterable[Any]) -> Any:
    found = list(numbers)
    d = math.lcm(*(x.denominator for x in found))
    return fmpq(math.gcd(*(int(x * d) for x in found)), d)


UNITS: Rows = tuple(tuple(fmpq(int(m == n)) for n in range(4)) for m in range(4))


def span(vectors: Iterable[Vector]) -> Rows:
    """The triangle of what vectors span, of rank 4, by Euclid's algorithm on the rows."""
    given = list(vectors)
    den = math.lcm(*(x.denominator for v in given for x in v))
    left = [[int(x * den) for x in v] for v in given]
    found: list[list[int]] = []
    for c in range(4):
        while True:
            live = sorted((r for r in left if r[c]), key=lambda r: abs(r[c]))
            if len(live) < 2:
                break
            for r in live[1:]:
                q = r[c] // live[0][c]
                r[:] = [x - q * y for x, y in zip(r, live[0], strict=True)]
        pivot = live[0] if live[0][c] > 0 else [-x for x in live[0]]
        left = [r for r in left if r is not live[0]]
        for r in found:
            q = r[c] // pivot[c]
            r[:] = [x - q * y for x, y in zip(r, pivot, strict=True)]
        found.append(pivot)
    return tuple(tuple(fmpq(x, den) for x in r) for r in found)


def coordinates(basis: Rows, x: Vector) -> Vector:
    return combination(x, inverse(basis))


def holds(triangle: Rows, x: Vector) -> bool:
    """Whether a vector is an integer combination of triangular rows."""
    rest = list(x)
    for n, row in enumerate(triangle):
        c = rest[n] / row[n]
        if c.denominator != 1:
            return False
        rest = [p - c * q for p, q in zip(rest, row, strict=True)]
    return True


def inside(first: Rows, second: Rows) -> bool:
    return all(holds(second, x) for x in first)


def inverse(matrix: Sequence[Sequence[Any]]) -> Rows:
    """The inverse by elimination."""
    n = len(matrix)
    work = [[*row, *(fmpq(int(r == c)) for c in range(n))] for r, row in enumerate(matrix)]
    for c in range(n):
        pivot = next(r for r in range(c, n) if work[r][c])
        work[c], work[pivot] = work[pivot], work[c]
        work[c] = [x / work[c][c] for x in work[c]]
        for r in range(n):
            if r != c and work[r][c]:
                f = work[r][c]
                work[r] = [x - f * y for x, y in zip(work[r], work[c], strict=True)]
    return tuple(tuple(row[n:]) for row in work)


def dual(triangle: Rows) -> Rows:
    """What has integral dot products with the rows."""
    back = inverse(triangle)
    return span(tuple(back[m][n] for m in range(4)) for n in range(4))


def determinant(matrix: Sequence[Sequence[Any]]) -> Any:
    """The determinant by elimination."""
    work = [list(row) for row in matrix]
    total = fmpq(1)
    for c in range(len(work)):
        pivot = next((r for r in range(c, len(work)) if work[r][c]), None)
        if pivot is None:
            return fmpq(0)
        if pivot != c:
            work[c], work[pivot] = work[pivot], work[c]
            total = -total
        total *= work[c][c]
        for r in range(c + 1, len(work)):
            f = work[r][c] / work[c][c]
            work[r] = [x - f * y for x, y in zip(work[r], work[c], strict=True)]
    return total


def volume(basis: Sequence[Vector]) -> Any:
    return abs(determinant(basis))


def primes_of(n: int) -> list[int]:
    found, p = [], 2
    while p * p <= n:
        if n % p == 0:
            found.append(p)
            while n % p == 0:
                n //= p
        p += 1
    return [*found, n] if n > 1 else found


def is_prime(n: int) -> bool:
    return n > 1 and primes_of(n) == [n]


def discriminant_of(plain: Plain) -> int:
    """The product of the primes where ``a, b`` have the Hilbert symbol −1 (Serre, chapter III)."""
    square = plain.a + plain.t**2 / 4
    a, b = (int(x.numerator * x.denominator) for x in (square, plain.b))
    candidates = {2, *primes_of(abs(a)), *primes_of(abs(b))}
    return math.prod(p for p in candidates if _symbol(a, b, p) < 0)


def _symbol(a: int, b: int, p: int) -> int:
    alpha = beta = 0
    while a % p == 0:
        a, alpha = a // p, alpha + 1
    while b % p == 0:
        b, beta = b // p, beta + 1
    if p == 2:
        exponent = (a - 1) // 2 * ((b - 1) // 2) + alpha * (b * b - 1) // 8
        return (-1) ** (exponent + beta * (a * a - 1) // 8)
    sign = (-1) ** (alpha * beta * (p - 1) // 2)
    return int(sign * _legendre(a, p) ** (beta % 2) * _legendre(b, p) ** (alpha % 2))


def _legendre(a: int, p: int) -> int:
    return 1 if pow(a, (p - 1) // 2, p) == 1 else -1


def kronecker(d: int, p: int) -> int:
    """The symbol (d/p) of a discriminant: 1 where p splits, −1 where it is inert."""
    if p == 2:
        return 0 if d % 2 == 0 else 1 if d % 8 == 1 else -1
    return 0 if d % p == 0 else _legendre(d, p)
