"""Maximal orders that contain a given one, and the Eichler orders inside a given maximal one.

At a prime p the left order of the radical is larger until the order is hereditary; then the residue algebra
is a field, or a product of two, and one of its two maximal ideals has a maximal left order (Voight,
*Quaternion Algebras*, sections 15.5, 21.2, 24.4).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import product
from typing import TYPE_CHECKING

from flint import fmpz_mat

from hfield.errors import LatticeError
from hfield.factorisation import factorise
from hfield.lattices.checked_arguments import expect_coprime
from hfield.lattices.modulo_primes import kernel, lifted, roots, simple_root

if TYPE_CHECKING:
    from hfield.lattices.lattice import Lattice
    from hfield.lattices.order import Order


def radical(order: Order, p: int) -> Lattice:
    """Return the elements of O that are in the Jacobson radical modulo p; p·O where O is M₂(ℤₚ).

    They are those with ``tr(x·O) ≡ 0`` and ``N(x) ≡ 0`` modulo p.
    """
    gram = order._integral_gram
    vectors = kernel(gram, 4, p)  # tr(x·conj(y)) ≡ 0 for all y is the same, as conj(O) = O
    if p == 2:  # N is linear on these
        norms = [order._trace_and_norm(v)[1] % 2 for v in vectors]
        odd = [v for v, n in zip(vectors, norms, strict=True) if n]
        vectors = [v for v, n in zip(vectors, norms, strict=True) if not n]
        vectors += [[x + y for x, y in zip(odd[0], v, strict=True)] for v in odd[1:]]
    return above(order, [order._from_coordinates(v) for v in vectors], p)


def above(lattice: Lattice, rows: list[list[int]], n: int) -> Lattice:
    """Return the lattice of some rows, over the denominator of the given one, and n times this one."""
    matrix = fmpz_mat(rows + [[n * x for x in row] for row in lattice.hnf[1]])
    return lattice._make(lattice._den, matrix)


def overorder(order: Order) -> Order:
    """Return a maximal order that contains the given one."""
    for p in sorted(factorise(order.level)):
        order = maximal_at(order, p)
    return order


def maximal_at(order: Order, p: int) -> Order:
    """Return an order that contains the given one, is maximal at p, and the same elsewhere."""
    wanted = order._regular.discriminant % p == 0
    while True:
        discriminant = order._discriminant
        if (discriminant % p == 0) == wanted and discriminant % (p * p):
            return order
        larger = radical(order, p).left_order()
        if larger == order:  # hereditary, of level p
            return endpoints(order, p, 1)[0]
        order = larger


def endpoints(order: Order, p: int, e: int) -> tuple[Order, Order]:
    """Return the two orders, maximal at p, whose intersection is an order that is Eichler of level pᵉ at p.

    They are the left orders of the two-sided ideals of x − r and of x − s, for the two roots r, s modulo
    pᵉ of the characteristic polynomial of an x with distinct roots modulo p.
    """
    for v in product((0, 1), repeat=4):
        t, n = order._trace_and_norm(v)
        found = roots(t, n, p)
        if len(found) == 2:
            break
    else:
        raise LatticeError(f"this order is not an Eichler order at {p}")
    q = p**e
    first, second = (_end(order, v, lifted(1, -t, n, r, p, e), q) for r in found)
    return first, second


def _end(order: Order, v: tuple[int, ...], root: int, q: int) -> Order:
    x = [a - root * b for a, b in zip(v, order._one, strict=True)]
    table = order._table
    left = [_combine(x, [table[i][j] for i in range(4)]) for j in range(4)]  # x·b_j
    both = [
        _combine(y, [table[i][j] for j in range(4)]) for y in left for i in range(4)
    ]  # b_i·x·b_j
    return above(order, [order._from_coordinates(y) for y in both], q).left_order()


def _combine(x: list[int], rows: list[tuple[int, ...]]) -> list[int]:
    return [sum(a * row[n] for a, row in zip(x, rows, strict=True)) for n in range(4)]


def eichler_suborder(order: Order, level: int) -> Lattice:
    """Return the Eichler order ``ℤ + O·x + level·O`` in a maximal order, x being always the same.

    Raises :class:`LatticeError` when the level is not prime to the discriminant.
    """
    expect_coprime(level, order._discriminant)
    rows = left_multiples(order, factorise(level), zero_divisor)
    rows.append(order._from_coordinates(list(order._one)))
    return above(order, rows, level)


def left_multiples(
    order: Order, primes: Mapping[int, int], choose: Callable[[Order, int, int], list[int]]
) -> list[list[int]]:
    """Return the rows of the basis times an x that is ``choose(order, p, e)`` modulo each pᵉ.

    They are over the denominator of the order.
    """
    x, modulus = [0, 0, 0, 0], 1
    for p, e in sorted(primes.items()):
        q = p**e
        y = choose(order, p, e)
        step = pow(modulus, -1, q)
        x = [a + modulus * ((b - a) * step % q) for a, b in zip(x, y, strict=True)]
        modulus *= q
    return [order._from_coordinates(_combine(x, row)) for row in order._table]


def zero_divisor(order: Order, p: int, e: int) -> list[int]:
    """Return coordinates of an element of O, not in p·O, whose norm pᵉ divides; O is M₂(ℤₚ)."""
    for n, rest in _lines():
        found = zero_on_line(order, [*rest[:n], 0, *rest[n:]], n, p, e)
        if found is not None:
            return found
    raise AssertionError("the norm form modulo p is that of 2 × 2 matrices, which has such zeros")


def zero_on_line(order: Order, v: list[int], n: int, p: int, e: int) -> list[int] | None:
    """Return v with another n-th coordinate in place of 0, not in p·O, whose norm pᵉ divides; or None.

    The norm is a quadratic polynomial in that coordinate, and its simple roots give no element of p·O.
    """
    gram = order._integral_gram
    b = sum(gram[n][m] * v[m] for m in range(4))
    root = simple_root(gram[n][n] // 2, b, order._trace_and_norm(v)[1], p, e)
    return None if root is None else [*v[:n], root, *v[n + 1 :]]


def _lines() -> Iterator[tuple[int, tuple[int, ...]]]:
    """Run through a coordinate and small values for the others, growing without end."""
    size = 1
    while True:
        for rest in product(range(-size, size + 1), repeat=3):
            if max(map(abs, rest)) == size:
                for n in range(4):
                    yield n, rest
        size += 1


__all__ = [
    "above",
    "eichler_suborder",
    "endpoints",
    "maximal_at",
    "overorder",
    "radical",
    "zero_divisor",
]
