"""Rational points on conics ``a·x² + b·y² = z²`` with coefficients that can be factored.

Legendre's lattice: for pairwise coprime squarefree A, B, C, it consists of the integer vectors on which
``A·x² + B·y² + C·z²`` is a multiple of A·B·C by virtue of square roots modulo its primes. On this lattice the
form divided by A·B·C is integral of determinant 1. A vector of least length there (found by lattice reduction
for the definite form with |A|, |B|, |C|) has value 0, 1 or −1, because its length is at most 2^(1/3)·|ABC|.
If the value is ±1, the vector splits off, and the complement is a binary form of determinant ±1, from which
the solution is read off. Compare Cremona and Rusin, "Efficient solution of rational conics", Math. Comp. 72
(2003), and Serre, *A Course in Arithmetic*, chapter IV, §3.
"""

from __future__ import annotations

import itertools
import math
from fractions import Fraction
from typing import TYPE_CHECKING

import flint

from hfield.fields.linear_algebra.lattice_reduction import combination, steps_of_gram
from hfield.fields.rationals.whole_numbers import crt, sqrt_mod, square_class, squarefree
from hfield.fields.rationals.whole_numbers import fraction as to_fraction

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Rational


Vector = list[int]


def solve_conic(a: Rational, b: Rational) -> tuple[Fraction, Fraction, Fraction]:
    """Return rationals ``(x, y, z)``, not all 0, with ``a·x² + b·y² = z²``; a, b are nonzero rationals.

    The conic must have a point, that is, ``(a, b | ℚ)`` must be unramified everywhere.
    """
    m, s, in_m = squarefree(square_class(a))
    n, r, in_n = squarefree(square_class(b))
    g = math.gcd(m, n)
    # m·X² + n·Y² = Z² with Z = g·z:  (m/g)·X² + (n/g)·Y² − g·z² = 0
    form = (m // g, n // g, -g)
    primes = (_dividing(in_m, form[0]), _dividing(in_n, form[1]), _dividing(in_m, g))
    x, y, z = legendre(form, primes)
    # a = m·s²/den², so x = X·den/s
    den_a, den_b = to_fraction(a).denominator, to_fraction(b).denominator
    return Fraction(x * den_a, s), Fraction(y * den_b, r), Fraction(g * z)


def _dividing(primes: list[int], n: int) -> list[int]:
    return [p for p in primes if n % p == 0]


def legendre(
    form: tuple[int, int, int], primes: tuple[list[int], list[int], list[int]]
) -> tuple[int, int, int]:
    """Return a primitive integer zero of ``A·x² + B·y² + C·z²``, given the primes of A, B and C.

    The coefficients are squarefree, pairwise coprime and not all of the same sign, and a zero exists.
    """
    basis = _lattice(form, primes)
    determinant = abs(math.prod(form))
    gram = [
        [sum(abs(f) * u * v for f, u, v in zip(form, p, q, strict=True)) for q in basis]
        for p in basis
    ]
    reduced = [combination(c, basis) for c in steps_of_gram(gram)]
    first = None
    for coefficients in itertools.product(range(-2, 3), repeat=3):
        if any(coefficients):
            v = combination(coefficients, reduced)
            size = sum(f * t * t for f, t in zip(form, v, strict=True)) // determinant
            if size == 0:
                return _primitive(v)
            if first is None and abs(size) == 1:
                first = (v, size)
    assert first is not None, "the least vector of Legendre's lattice has value 0 or ±1"
    return _primitive(_split_off(form, determinant, reduced, *first))


def _lattice(
    form: tuple[int, int, int], primes: tuple[list[int], list[int], list[int]]
) -> list[Vector]:
    """Return a basis of Legendre's lattice, of index |A·B·C|."""
    conditions: list[tuple[tuple[int, int], int]] = []  # (y : z) modulo A, and cyclically
    for index, ps in enumerate(primes):
        f, g = form[(index + 1) % 3], form[(index + 2) % 3]
        root, modulus = crt((sqrt_mod(-g * pow(f, -1, p), p), p) for p in ps)
        conditions.append(((root, index), modulus))
    # x = β·z (mod B), x' ... : rows of the generators, one congruence at a time
    rows: list[Vector] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    for (root, index), modulus in conditions:
        i, j = (index + 1) % 3, (index + 2) % 3  # coordinate i ≡ root·coordinate j (mod modulus)
        rows = _sublattice(rows, [v[i] - root * v[j] for v in rows], modulus)
    return rows


def _sublattice(rows: list[Vector], values: list[int], modulus: int) -> list[Vector]:
    """Return a basis of the integer combinations of ``rows`` whose value is 0 modulo ``modulus``."""
    rows, values = [list(v) for v in rows], [v % modulus for v in values]
    while sum(v != 0 for v in values) > 1:
        small = min((i for i, v in enumerate(values) if v), key=lambda i: values[i])
        for i, v in enumerate(values):
            if i != small and v:
                q = v // values[small]
                rows[i] = [s - q * t for s, t in zip(rows[i], rows[small], strict=True)]
                values[i] -= q * values[small]
    for i, v in enumerate(values):
        if v:
            rows[i] = [s * (modulus // math.gcd(v, modulus)) for s in rows[i]]
    return rows


def _primitive(v: Vector) -> tuple[int, int, int]:
    g = math.gcd(*v)
    x, y, z = (t // g for t in v)
    return x, y, z


def _split_off(
    form: tuple[int, int, int], determinant: int, basis: list[Vector], v: Vector, size: int
) -> Vector:
    """Return a zero of the form, which on the lattice is ``size·X²`` plus a binary form of determinant ±1."""

    def pair(p: Vector, q: Vector) -> int:
        return sum(f * s * t for f, s, t in zip(form, p, q, strict=True)) // determinant

    # the complement of v: project, then take a basis of the three projections
    projected = [[s - size * pair(u, v) * t for s, t in zip(u, v, strict=True)] for u in basis]
    p, q = _rank_two(projected)
    a, b, c = pair(p, p), pair(p, q), pair(q, q)
    if b * b - a * c > 0:  # then it is 1, a square: the binary form is a product of two lines
        if a == 0:
            return p
        return [(1 - b) * s + a * t for s, t in zip(p, q, strict=True)]
    # definite and of determinant 1, hence a sum of two squares up to sign; the other sign than v
    steps = steps_of_gram([[abs(a), b if a > 0 else -b], [b if a > 0 else -b, abs(c)]])
    w = combination(steps[0], [p, q])
    return [s + t for s, t in zip(v, w, strict=True)]


def _rank_two(rows: list[Vector]) -> tuple[Vector, Vector]:
    """Return a basis of the rank-2 lattice that three vectors span."""
    hermite = flint.fmpz_mat(3, 3, [x for row in rows for x in row]).hnf().tolist()
    p, q = ([int(x) for x in row] for row in hermite if any(int(x) for x in row))
    return p, q


def diagonalise(gram: list[list[Fraction]]) -> tuple[list[Fraction], list[list[Fraction]]]:
    """Return the diagonal of a nondegenerate symmetric matrix and the rows of an orthogonal basis."""
    n = len(gram)

    def pair(u: list[Fraction], v: list[Fraction]) -> Fraction:
        return sum((u[i] * gram[i][j] * v[j] for i in range(n) for j in range(n)), Fraction(0))

    rest = [[Fraction(int(i == j)) for j in range(n)] for i in range(n)]
    values: list[Fraction] = []
    basis: list[list[Fraction]] = []
    while rest:
        for i, j in itertools.combinations(range(len(rest)), 2):
            if not any(pair(u, u) for u in rest):
                rest[i] = [x + y for x, y in zip(rest[i], rest[j], strict=True)]
        v = next(u for u in rest if pair(u, u))
        size = pair(v, v)
        rest.remove(v)
        rest = [[x - pair(u, v) / size * y for x, y in zip(u, v, strict=True)] for u in rest]
        values.append(size)
        basis.append(v)
    return values, basis
