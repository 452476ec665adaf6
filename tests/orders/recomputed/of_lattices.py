"""Lattices: their normal form, arithmetic, norm forms and short elements, against plain arithmetic."""

import math
from fractions import Fraction
from random import Random
from typing import Any

from hfield.errors import LatticeError
from tests.orders import random_lattices as rand
from tests.orders.recomputed import plainly
from tests.orders.recomputed.plainly import Plain, rational, rows, span, vector


def pair(rng: Random, definite: bool | None = None) -> tuple[Any, Plain, Any, Any]:
    """An algebra, with constants of any length now and then, and two lattices in it."""
    size = rng.choice((6, 30, 10**4, 2**70))
    A = rand.algebra(rng, definite, 12 if definite else size)
    return A, Plain(A), rand.lattice(A, rng), rand.lattice(A, rng)


def skewed(basis: tuple[Any, ...], rng: Random) -> list[Any]:
    """Another basis of the same lattice, and an element too many."""
    found = list(basis)
    for _ in range(6):
        m, n = rng.sample(range(4), 2)
        found[m] = found[m] + rng.randint(-3, 3) * found[n]
    rng.shuffle(found)
    return [*found, found[0] + found[1]]


def normal_form(rng: Random) -> None:
    A, _, L, _ = pair(rng)
    other = skewed(L.basis, rng)
    assert rows(L) == span(map(vector, other))
    assert A.lattice(other) == L
    assert hash(A.lattice(other)) == hash(L)


def sums(rng: Random) -> None:
    _, _, L, M = pair(rng)
    assert rows(L + M) == span(rows(L) + rows(M))


def intersection(rng: Random) -> None:
    _, _, L, M = pair(rng)
    meet = rows(L & M)
    assert plainly.inside(meet, rows(L))
    assert plainly.inside(meet, rows(M))
    # and it is no smaller: [L : L ∩ M] = [L + M : M]
    both = span(rows(L) + rows(M))
    assert plainly.volume(meet) * plainly.volume(both) == plainly.volume(rows(L)) * plainly.volume(
        rows(M)
    )


def product(rng: Random) -> None:
    _, plain, L, M = pair(rng)
    assert rows(L * M) == plain.product(rows(L), rows(M))


def conjugate(rng: Random) -> None:
    _, plain, L, _ = pair(rng)
    assert rows(L.conjugate()) == span(map(plain.conj, rows(L)))


def scaling(rng: Random) -> None:
    A, plain, L, _ = pair(rng)
    x = rand.element(A, rng)
    n = Fraction(rng.randint(1, 30), rng.randint(1, 30))
    assert rows(x * L) == span(plain.mul(vector(x), y) for y in rows(L))
    assert rows(L * x) == span(plain.mul(y, vector(x)) for y in rows(L))
    assert rows(n * L) == rows(L / (1 / n)) == span(plainly.times(rational(n), y) for y in rows(L))


def index(rng: Random) -> None:
    _, _, L, M = pair(rng)
    assert rational(L.index(M)) == plainly.volume(rows(M)) / plainly.volume(rows(L))
    n = rng.randint(2, 5)
    assert (L + M).index(n * (L & M)) == n**4 * (L + M).index(L) * L.index(L & M)


def containment(rng: Random) -> None:
    _, _, L, M = pair(rng)
    some = rng.choice((M, L + M, rng.randint(1, 6) * L, L & M, Fraction(1, 2) * L))
    assert (some <= L) == (L >= some) == plainly.inside(rows(some), rows(L))
    assert (some == L) == (some <= L <= some)


def membership_and_coordinates(rng: Random) -> None:
    A, _, L, _ = pair(rng)
    c = [Fraction(rng.randint(-9, 9), rng.choice((1, 1, 1, 2))) for _ in range(4)]
    q = sum((n * b for n, b in zip(c, L.basis, strict=True)), A(0))
    x = rng.choice((q, rand.element(A, rng)))
    found = plainly.coordinates(rows(L), vector(x))
    assert tuple(rational(n) for n in L.coordinates(x)) == found
    assert (x in L) == all(n.denominator == 1 for n in found)


def norm(rng: Random) -> None:
    _, plain, L, _ = pair(rng)
    assert rational(L.norm()) == plain.norm_of(rows(L))


def gram_matrix(rng: Random) -> None:
    _, plain, L, _ = pair(rng)
    found = [[rational(x) for x in row] for row in L.gram_matrix()]
    assert found == plain.gram(rows(L))


def dual(rng: Random) -> None:
    _, plain, L, _ = pair(rng)
    pairs = [[plain.trace(plain.mul(x, y)) for y in rows(L.dual())] for x in rows(L)]
    assert span(map(tuple, pairs)) == plainly.UNITS


def colon(rng: Random) -> None:
    _, plain, L, M = pair(rng)
    for side in ("left", "right"):
        assert rows(L.colon(M, side)) == plain.colon(rows(L), rows(M), side)


def left_and_right_order(rng: Random) -> None:
    A, plain, L, M = pair(rng)
    if rng.random() < 0.5:  # one that is locally principal
        O = A.maximal_order()
        L = O * rand.element(A, rng) if rng.random() < 0.5 else O * rand.element(A, rng) + O * 5
    elif rng.random() < 0.3:
        L = L * M
    assert rows(L.left_order()) == plain.colon(rows(L), rows(L), "left")
    assert rows(L.right_order()) == plain.colon(rows(L), rows(L), "right")


def inverse(rng: Random) -> None:
    A, plain, L, _ = pair(rng)
    if rng.random() < 0.5:
        L = A.maximal_order() * rand.element(A, rng)
    # the largest X with L·X·L ⊆ L: L·X ⊆ the left order
    order = plain.colon(rows(L), rows(L), "left")
    back = plain.colon(order, rows(L), "right")
    invertible = plain.product(rows(L), back) == order
    assert L.is_invertible() == invertible
    if invertible:
        assert rows(L.inverse()) == back
    else:
        try:
            L.inverse()
        except LatticeError:
            return
        raise AssertionError("this lattice has no inverse")


def reduced_basis(rng: Random) -> None:
    _, plain, L, _ = pair(rng, rng.choice((True, None)))
    basis = [vector(q) for q in L.reduced_basis()]
    assert span(basis) == rows(L)
    if L.value.ambient.definite:
        lengths = [2 * plain.norm(x) for x in basis]
        assert lengths == sorted(lengths)
        # the bound of Lenstra, Lenstra and Lovász
        assert math.prod(lengths) <= 64 * plainly.determinant(plain.gram(basis))


def small(rng: Random) -> tuple[Any, Plain, list[Any], Any]:
    """A definite lattice, and a reduced basis to run through boxes with."""
    A, plain, L, _ = pair(rng, True)
    if rng.random() < 0.4:
        L = A.maximal_order()
    return L, plain, [vector(q) for q in L.reduced_basis()], A


def shortest(rng: Random) -> None:
    L, plain, basis, _ = small(rng)
    found = list(plain.short(basis, min(plain.norm(x) for x in basis)))
    least = min(n for x, n in found if n)
    assert {vector(q) for q in L.shortest()} == {x for x, n in found if n == least}


def elements_of_bounded_norm(rng: Random) -> None:
    L, plain, basis, _ = small(rng)
    bound = plain.sample_bound(basis)
    found = dict(plain.short(basis, bound))
    listed = L.elements_of_norm_at_most(bound)
    assert len(listed) == len(found)
    assert {vector(q) for q in listed} == set(found)
    assert [found[vector(q)] for q in listed] == sorted(found.values())


def elements_of_norm(rng: Random) -> None:
    L, plain, basis, _ = small(rng)
    bound = plain.sample_bound(basis)
    found = dict(plain.short(basis, bound))
    for n in (*rng.sample(sorted(found.values()), min(2, len(found))), bound):
        listed = L.elements_of_norm(n)
        assert len(listed) == len(set(listed))
        assert {vector(q) for q in listed} == {x for x, m in found.items() if m == n}


def theta_series(rng: Random) -> None:
    L, plain, basis, _ = small(rng)
    unit = plain.norm_of(rows(L))
    bound = plain.sample_bound(basis)
    most = min(int(bound / unit), 300)
    counts = [0] * (most + 1)
    for _, n in plain.short(basis, most * unit):
        counts[int(n / unit)] += 1
    assert L.theta_series(most) == counts


OPERATIONS = {
    "normal form of any generators": normal_form,
    "sum of lattices": sums,
    "intersection of lattices": intersection,
    "product of lattices": product,
    "conjugate lattice": conjugate,
    "multiples of lattices": scaling,
    "index": index,
    "containment": containment,
    "membership, coordinates": membership_and_coordinates,
    "norm": norm,
    "Gram matrix": gram_matrix,
    "dual": dual,
    "colon": colon,
    "left and right order": left_and_right_order,
    "invertibility, inverse of lattices": inverse,
    "reduced basis": reduced_basis,
    "shortest vectors": shortest,
    "elements of norm at most B": elements_of_bounded_norm,
    "elements of a norm": elements_of_norm,
    "theta series": theta_series,
}
