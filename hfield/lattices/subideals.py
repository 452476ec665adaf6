"""Ideals of given norm inside an ideal: all of them, or one at random.

Where O is M₂(ℤₚ) the p + 1 ideals of norm p correspond to the lines of a plane over ℤ/p, through an element
of O that is idempotent modulo p. Nothing is special about p = 2, or about p that divides a constant.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache, partial
from itertools import product
from operator import add
from typing import TYPE_CHECKING, Any

from flint import fmpz, fmpz_mat

from hfield.errors import LatticeError, TooLargeError
from hfield.factorisation import factorise, remove
from hfield.lattices import hermite
from hfield.lattices.maximal_orders import (
    above,
    left_multiples,
    maximal_at,
    zero_divisor,
    zero_on_line,
)
from hfield.lattices.modulo_primes import echelon, roots
from hfield.lattices.two_sided_ideals import two_sided_prime

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.lattices.lattice import Lattice
    from hfield.lattices.order import Order

MOST = 10**5
"""No more ideals of one norm than this are listed."""


class Units:
    """Elements e and f of an order with e² ≡ e, f ≡ e·f·(1 − e) ≢ 0 modulo p, as matrices from the right."""

    def __init__(self, order: Order, p: int) -> None:
        for v in product(range(min(p, 3)), repeat=4):
            t, n = order._trace_and_norm(v)
            found = roots(t, n, p)
            if len(found) == 2:
                break
        else:
            raise AssertionError("2 × 2 matrices over a field have elements with two eigenvalues")
        table = order._table
        inverse = pow(found[0] - found[1], -1, p)
        e = [(x - found[1] * y) * inverse % p for x, y in zip(v, order._one, strict=True)]
        rest = [(y - x) % p for x, y in zip(e, order._one, strict=True)]

        def times(x: list[int], y: list[int]) -> list[int]:
            return [
                sum(x[i] * y[j] * table[i][j][n] for i in range(4) for j in range(4)) % p
                for n in range(4)
            ]

        basis = [[int(i == j) for j in range(4)] for i in range(4)]
        f = next(x for b in basis if any(x := times(times(e, b), rest)))
        r = order._regular
        self.divisor = order._den * r.scale
        self.e, self.f = (r.right_matrix(tuple(order._from_coordinates(x))) for x in (e, f))


@lru_cache(maxsize=64)
def _units(order: Order, p: int) -> Units:
    return Units(order, p)


def right_subideals(ideal: Lattice, order: Order, p: int) -> Iterator[tuple[int, fmpz_mat]]:
    """Yield the p + 1 right ideals of relative norm p in a right ideal; the order is M₂(ℤₚ) at p.

    They are matrices over denominators, in Hermite form.
    """
    units = _units(order, p)
    rows = ideal._matrix
    image = _divided(rows * units.e, units.divisor)
    coordinates, d = hermite.in_coordinates(rows, image)
    pivots = echelon([[int(x) // d for x in row] for row in coordinates.tolist()], p)
    lines = [fmpz_mat([v]) * rows for v in pivots.values()]
    first, second = lines
    # an element of the lattice that is ≡ y·e modulo p times it
    first, second = (_divided(y * units.e, units.divisor) for y in (first, second))
    tail = (rows * p).entries()
    along = _divided(first * units.f, units.divisor), _divided(second * units.f, units.divisor)
    for c in range(p):
        y, z = first + second * c, along[0] + along[1] * c
        yield _of(ideal, y, z, tail)
    yield _of(ideal, second, along[1], tail)


def _of(ideal: Lattice, y: fmpz_mat, z: fmpz_mat, tail: list[fmpz]) -> tuple[int, fmpz_mat]:
    found = hermite.hermite(ideal._den, fmpz_mat(6, 4, y.entries() + z.entries() + tail))
    if found is None:
        raise AssertionError("p times a lattice has rank 4")
    return found


def _divided(matrix: fmpz_mat, n: int) -> fmpz_mat:
    """Return an integer matrix divided by an integer that divides all entries."""
    if n == 1:
        return matrix
    return fmpz_mat(matrix.nrows(), 4, [x // n for x in matrix.entries()])


def ideals_of_norm(order: Order, n: int) -> list[Lattice]:
    """Return all invertible integral right ideals of an order of norm n, in a fixed order.

    Raises :class:`TooLargeError` for more than 10⁵.
    """
    layer: dict[Any, Lattice] = {order.hnf: order}
    for p, e in sorted(factorise(n).items()):
        if len(layer) * number_maximal(p, e) > MOST:
            raise TooLargeError(f"there are too many ideals of norm {n} to list them")
        local = of_prime_power_norm(order, p, e)
        both = (J & K for J in layer.values() for K in local)
        layer = {J.hnf: J for J in both}
    return [layer[key] for key in sorted(layer)]


def of_prime_power_norm(order: Order, p: int, e: int) -> list[Lattice]:
    """Return the invertible right ideals of an order of norm pᵉ, as lattices."""
    if order.level % p == 0:
        return _at_the_level(order, p, e)
    layer: dict[Any, Lattice] = {order.hnf: order}
    for _ in range(e):
        layer = {J.hnf: J for K in layer.values() for J in of_prime_norm(K, order, p)}
    return list(layer.values())


def number_maximal(p: int, e: int) -> int:
    """Return how many right ideals of norm pᵉ the ring M₂(ℤₚ) has."""
    return int((p ** (e + 1) - 1) // (p - 1))


def of_prime_norm(ideal: Lattice, order: Order, p: int) -> Iterator[Lattice]:
    """Yield the right ideals of relative norm p in a right ideal; the order is maximal at p."""
    if order._discriminant % p:
        for den, matrix in right_subideals(ideal, order, p):
            yield order._in_form(den, matrix)
    else:
        yield ideal._product(two_sided_prime(order, p))


def _at_the_level(order: Order, p: int, e: int) -> list[Lattice]:
    """Return those at a prime of the level, through the ideals y·M of a maximal order M at p that contains O.

    An ideal x·O has the norm pᵉ where x·M has; then it is y·u·O with x·M = y·M, for a unit u of M modulo
    units of O. Not all are products of ideals of norm p.
    """
    larger = maximal_at(order, p)
    number, depth = _number_of_cosets(order, p), 1
    while not larger._scaled(Fraction(p**depth)) <= order:
        depth += 1
    around = of_prime_power_norm(larger, p, e)
    if len(around) * number > MOST:
        raise TooLargeError(f"there are too many candidates for ideals of norm {p}^{e} to try them")
    units = _unit_cosets(order, larger, p, depth, number)
    rest = order._scaled(Fraction(p ** (depth + e)))
    found = []
    for ideal in around:
        y = ideal._element(_of_least_norm(ideal, p))
        found += [order.__rmul__(x) + rest for u in units if (x := y * u) in order]
    return found


def _number_of_cosets(order: Order, p: int) -> int:
    """Return the index of the units of O in those of a maximal order that contains it, at p."""
    units = Fraction(1)  # the part of a maximal order, over that of O, that are units
    symbols = [
        (-1 if order._regular.discriminant % p == 0 else None, 1),
        (order.eichler_symbol(p), -1),
    ]
    for symbol, sign in symbols:
        inverse, one = Fraction(1, p), Fraction(1)
        part = {
            None: (one - inverse) * (one - inverse**2),
            1: (one - inverse) ** 2,
            0: one - inverse,
            -1: one - inverse**2,
        }[symbol]
        units *= part**sign
    return int(units * p ** remove(order.level, p)[0])


def _unit_cosets(order: Order, larger: Order, p: int, depth: int, number: int) -> list[Quaternion]:
    """Return units u of the larger order at p, one for each u·O; pᵈᵉᵖᵗʰ times the order lies in O."""
    rng, whole = random.Random(1), larger._scaled(Fraction(p**depth))
    found: dict[Any, Quaternion] = {}
    while len(found) < number:
        v = [rng.randrange(p**depth) for _ in range(4)]
        if larger._trace_and_norm(v)[1] % p:
            u = larger._element(larger._from_coordinates(v))
            found.setdefault((order.__rmul__(u) + whole).hnf, u)
    return list(found.values())


def _of_least_norm(lattice: Lattice, p: int) -> tuple[int, ...]:
    """Return the row of an element whose norm, over that of the lattice, is prime to p."""
    rows, gram = lattice._reduced
    pairs = [(m, n) for m in range(4) for n in range(m, 4)]
    for m, n in sorted(pairs, key=lambda x: x[0] != x[1]):
        value = gram[m][m] // 2 if m == n else (gram[m][m] + gram[n][n]) // 2 + gram[m][n]
        if value % p:
            lines = hermite.tuples(rows)
            return lines[m] if m == n else tuple(map(add, lines[m], lines[n]))
    raise AssertionError("the values of a primitive form have no common divisor")


def prime_to(ideal: Lattice, p: int) -> Lattice:
    """Return a right ideal of integral norm prime to p in the class of a right ideal: ``conj(x)·I/N(I)``."""
    x = ideal._element(_of_least_norm(ideal, p))
    return ideal.__rmul__(x.conjugate())._scaled(1 / ideal._norm)


def random_ideal(order: Order, n: int, rng: random.Random) -> Lattice:
    """Return ``O·x + n·O`` of norm n, prime to the discriminant, for a random x; O/I is cyclic."""
    primes = factorise(n)
    for p in primes:
        if order._discriminant % p == 0:
            raise LatticeError(
                f"random ideals have a norm prime to the discriminant, and {p} divides both"
            )
    multiples = left_multiples(order, primes, partial(_random_zero_divisor, rng))
    return above(order, multiples, n)


def _random_zero_divisor(rng: random.Random, order: Order, p: int, e: int) -> list[int]:
    for _ in range(200):
        n = rng.randrange(4)
        v = [rng.randrange(p**e) for _ in range(4)]
        v[n] = 0
        found = zero_on_line(order, v, n, p, e)
        if found is not None:
            return found
    return zero_divisor(order, p, e)
