"""Maximal orders over ℤ that contain a given one; the orders inside a given one, Eichler orders among them.

At a prime p the left order of the radical is larger until the order is hereditary; then the residue algebra
is a field, or a product of two, and one of its two maximal ideals has a maximal left order (Voight,
*Quaternion Algebras*, sections 15.5, 21.2, 24.4).

A maximal suborder of O contains p·O, so that subalgebras of O/p·O give all of them: of index p, or of index
p² and spanned by 1 and one more.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping
from itertools import count, product
from typing import TypeVar

from flint import fmpz_mat

from hfield.core.factorisation import factorise
from hfield.errors import LatticeError, TooLargeError
from hfield.orders import hermite
from hfield.orders.lattice_values import LatticeValue, hermite_form, order_of
from hfield.orders.linear_algebra_mod_p import kernel, lifted, roots, simple_root
from hfield.orders.validation import expect_coprime
from hfield.orders.z_order import ZOrder
from hfield.rings.whole_numbers import crt

Line = tuple[int, list[int]]
"""A coordinate, and values for the others with 0 in its place."""
MOST = 10_000
"""No more candidates for orders at one prime than this are tried."""
Value = TypeVar("Value")


def radical(order: ZOrder, p: int) -> LatticeValue:
    """Return the elements of O that are in the Jacobson radical modulo p; p·O where O is M₂(ℤₚ).

    They are those with ``tr(x·O) ≡ 0`` and ``N(x) ≡ 0`` modulo p.
    """
    gram = order.gram
    vectors = kernel(gram, p)  # tr(x·conj(y)) ≡ 0 for all y is the same, as conj(O) = O
    if p == 2:  # N is linear on these
        norms = [order.trace_and_norm(v)[1] % 2 for v in vectors]
        odd = [v for v, n in zip(vectors, norms, strict=True) if n]
        vectors = [v for v, n in zip(vectors, norms, strict=True) if not n]
        vectors += [[x + y for x, y in zip(odd[0], v, strict=True)] for v in odd[1:]]
    return above(order, fmpz_mat([*vectors, [0] * 4]) * order.matrix, p)


def above(lattice: LatticeValue, rows: fmpz_mat, n: int) -> LatticeValue:
    """Return the lattice of some rows, over the denominator of the given one, and n times this one."""
    entries = rows.entries() + (lattice.matrix * n).entries()
    return hermite_form(lattice.ambient, lattice.den, fmpz_mat(len(entries) // 4, 4, entries))


def overorder(order: ZOrder) -> ZOrder:
    """Return a maximal order that contains the given one."""
    for p in sorted(factorise(order.level)):
        order = maximal_at(order, p)
    return order


def maximal_at(order: ZOrder, p: int) -> ZOrder:
    """Return an order that contains the given one, is maximal at p, and the same elsewhere."""
    wanted = order.ambient.discriminant % p == 0
    while True:
        discriminant = order.discriminant
        if (discriminant % p == 0) == wanted and discriminant % (p * p):
            return order
        larger = ZOrder.of(order_of(radical(order, p), "left"))
        if larger == order:  # hereditary, of level p
            return endpoints(order, p, 1)[0]
        order = larger


def endpoints(order: ZOrder, p: int, e: int) -> tuple[ZOrder, ZOrder]:
    """Return the two orders, maximal at p, whose intersection is an order that is Eichler of level pᵉ at p.

    They are the left orders of the two-sided ideals of x − r and of x − s, for the two roots r, s modulo
    pᵉ of the characteristic polynomial of an x with distinct roots modulo p.
    """
    v, found = with_two_roots(order, p, product((0, 1), repeat=4))
    t, n = order.trace_and_norm(v)
    first, second = (_end(order, v, lifted(1, -t, n, r, p, e), p**e) for r in found)
    return first, second


def with_two_roots(
    order: ZOrder, p: int, candidates: Iterable[tuple[int, ...]]
) -> tuple[tuple[int, ...], list[int]]:
    """Return the first element whose characteristic polynomial has distinct roots modulo p, and these."""
    for v in candidates:
        t, n = order.trace_and_norm(v)
        found = roots(1, -t, n, p)
        if len(found) == 2:
            return v, found
    raise LatticeError(f"this order is not an Eichler order at {p}")


def _end(order: ZOrder, v: tuple[int, ...], root: int, q: int) -> ZOrder:
    """Return the left order of the two-sided ideal of x − root and q, x with the coordinates v."""
    r, (w, *rest) = order.ambient, order.row(v)
    ideal = r.products(fmpz_mat([[w - root * order.den, *rest]]), order.matrix)
    rows = hermite.divided(r.products(order.matrix, ideal), (order.den * r.scale) ** 2)
    return ZOrder.of(order_of(above(order, rows, q), "left"))


def eichler_suborder(order: ZOrder, level: int) -> ZOrder:
    """Return the Eichler order ``ℤ + O·x + level·O`` in a maximal order, x being always the same.

    Raises :class:`LatticeError` when the level is not prime to the discriminant.
    """
    expect_coprime(level, order.discriminant)
    rows = left_multiples(order, factorise(level), lambda q: small_lines()).entries()
    return ZOrder.of(above(order, fmpz_mat(5, 4, [*rows, order.den, 0, 0, 0]), level))


def left_multiples(
    order: ZOrder, primes: Mapping[int, int], lines: Callable[[int], Iterator[Line]]
) -> fmpz_mat:
    """Return the basis times an x that is, modulo each pᵉ, a zero divisor on one of ``lines(pᵉ)``.

    They are rows over the denominator of the order.
    """
    found = [(zero_divisor(order, p, e, lines(p**e)), p**e) for p, e in sorted(primes.items())]
    x = [crt((y[n], q) for y, q in found)[0] for n in range(4)]
    r = order.ambient
    return hermite.divided(order.matrix * r.right_matrix(order.row(x)), order.den * r.scale)


def zero_divisor(order: ZOrder, p: int, e: int, lines: Iterable[Line]) -> list[int]:
    """Return coordinates of an element of O, not in p·O, whose norm pᵉ divides; O is M₂(ℤₚ).

    On a line the norm is a quadratic polynomial, and its simple roots give no element of p·O.
    """
    gram = order.gram
    for n, v in lines:
        b = sum(gram[n][m] * v[m] for m in range(4))
        root = simple_root(gram[n][n] // 2, b, order.trace_and_norm(v)[1], p, e)
        if root is not None:
            return [*v[:n], root, *v[n + 1 :]]
    raise AssertionError("the norm form modulo p is that of 2 × 2 matrices, which has such zeros")


def small_lines() -> Iterator[Line]:
    """Run through a coordinate and small values for the others, growing without end."""
    for size in count(1):
        for rest in product(range(-size, size + 1), repeat=3):
            if max(map(abs, rest)) == size:
                for n in range(4):
                    yield n, [*rest[:n], 0, *rest[n:]]


# --- orders below ----------------------------------------------------------------------------------


def in_steps(
    start: Value,
    k: int,
    around: Callable[[Value], Iterator[tuple[int, Value]]],
    key: Callable[[Value], Hashable],
) -> list[Value]:
    """Return what is reached in steps whose lengths add up to k. Raises :class:`TooLargeError`."""
    reached: list[dict[Hashable, Value]] = [{key(start): start}, *({} for _ in range(k))]
    for n in range(k):
        for order in reached[n].values():
            for length, other in around(order):
                if n + length <= k:
                    reached[n + length].setdefault(key(other), other)
        if sum(map(len, reached)) > MOST:
            raise TooLargeError("there are too many orders of this index to list them")
    return list(reached[k].values())
