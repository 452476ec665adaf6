"""Seeded random algebras, elements and lattices, and plain ways to compute what the tests ask."""

import itertools
import math
from fractions import Fraction
from random import Random
from typing import Any

from hfield import QuaternionAlgebra, ternary_form
from hfield.fields.rationals.whole_numbers import fraction


def algebra(rng: Random, definite: bool | None = None, size: int = 30) -> QuaternionAlgebra:
    """An algebra with fractions and any t among its constants."""
    while True:
        a, b = (
            Fraction(rng.choice((-1, 1)) * rng.randrange(1, size), rng.choice((1, 1, 1, 2, 3, 5)))
            for _ in "ab"
        )
        t = rng.choice((0, 0, 0, 1, -2, Fraction(1, 3)))
        if definite:
            a, b, t = -abs(a) - t * t, -abs(b), t
        if t * t + 4 * a:
            return QuaternionAlgebra("QQ", a, b, t)


def element(A: QuaternionAlgebra, rng: Random, size: int = 9) -> Any:
    """An element of nonzero norm."""
    while True:
        q = A(*(Fraction(rng.randint(-size, size), rng.choice((1, 1, 2, 3))) for _ in range(4)))
        if q.norm() != 0:
            return q


def lattice(A: QuaternionAlgebra, rng: Random) -> Any:
    while True:
        rows = [
            [Fraction(rng.randint(-9, 9), rng.choice((1, 2, 3))) for _ in range(4)]
            for _ in range(4)
        ]
        if determinant(rows):
            return A.lattice(rows)


def coordinates(q: Any) -> list[Fraction]:
    return [fraction(c) for c in q.coordinates]


def determinant(rows: list[list[Fraction]]) -> Fraction:
    total = Fraction(0)
    for p in itertools.permutations(range(len(rows))):
        sign = (-1) ** sum(p[s] > p[r] for r in range(len(p)) for s in range(r))
        total += sign * math.prod((rows[r][p[r]] for r in range(len(p))), start=Fraction(1))
    return total


def volume(L: Any) -> Fraction:
    return abs(determinant([coordinates(q) for q in L.basis]))


def norm_by_gcd(L: Any) -> Fraction:
    """The gcd of the norms of the basis and of all sums of two."""
    elements = [*L.basis, *(p + q for p, q in itertools.combinations(L.basis, 2))]
    norms = [fraction(q.norm()) for q in elements]
    d = math.lcm(*(n.denominator for n in norms))
    return Fraction(math.gcd(*(int(n * d) for n in norms)), d)


def box(L: Any, size: int) -> list[Any]:
    """All combinations of a basis with coefficients up to size."""
    span = range(-size, size + 1)
    a, b, c, d = L.reduced_basis()
    return [w * a + x * b + y * c + z * d for w, x, y, z in itertools.product(span, repeat=4)]


def random_step(F: Any, rng: Random) -> list[list[Any]]:
    """A 3 × 3 matrix of determinant 1, over a field with integers."""
    m = [[F(int(r == c)) for c in range(3)] for r in range(3)]
    for _ in range(4):
        r, c = rng.sample(range(3), 2)
        n = rng.choice((-1, 1, 2))
        m[r] = [x + n * y for x, y in zip(m[r], m[c], strict=True)]
    return m


def moved(f: Any, m: list[list[Any]]) -> Any:
    """The form v ↦ f(v·m)."""
    rows = [f(*row) for row in m]
    mixed = [
        f(*(x + y for x, y in zip(m[r], m[c], strict=True))) - rows[r] - rows[c]
        for r, c in ((1, 2), (0, 2), (0, 1))
    ]
    return ternary_form([*rows, *mixed], f.ring)
