"""Random cases of every operation of lattices, orders and ideals against another way of computing it.

    python scripts/check_lattices.py [CASES] [SEED]

The other ways are written here on Fractions and Python's integers: products of all basis elements and
an elimination of their own for spans, intersections of the lattices ``L·b⁻¹`` for orders, sums over
boxes for norms. Answers with an element are multiplied out; answers without one are compared with the
theta series of the lattice between.
"""

import itertools
import math
import sys
import time
from collections import Counter
from fractions import Fraction
from random import Random
from typing import Any

from hfield import QuaternionAlgebra
from hfield.structure.rationals.whole_numbers import fraction

Vector = list[Fraction]


def span(vectors: list[Vector]) -> tuple[int, tuple[tuple[int, ...], ...]]:
    """Return the Hermite form over the least denominator, by Euclid's algorithm on the rows."""
    den = math.lcm(*(x.denominator for v in vectors for x in v))
    rows = [[int(x * den) for x in v] for v in vectors]
    found: list[list[int]] = []
    for c in range(4):
        while True:
            live = sorted((r for r in rows if r[c]), key=lambda r: abs(r[c]))
            if len(live) < 2:
                break
            for r in live[1:]:
                q = r[c] // live[0][c]
                r[:] = [x - q * y for x, y in zip(r, live[0], strict=True)]
        pivot = live[0] if live[0][c] > 0 else [-x for x in live[0]]
        rows = [r for r in rows if r is not live[0]]
        for r in found:
            q = r[c] // pivot[c]
            r[:] = [x - q * y for x, y in zip(r, pivot, strict=True)]
        found.append(pivot)
    g = math.gcd(den, *(x for r in found for x in r))
    return den // g, tuple(tuple(x // g for x in r) for r in found)


def vector(q: Any) -> Vector:
    return [fraction(c) for c in q.coordinates]


def vectors(elements: Any) -> list[Vector]:
    return [vector(q) for q in elements]


def algebra(rng: Random) -> QuaternionAlgebra:
    while True:
        size = rng.choice((8, 40, 10**4))
        a, b = (
            rng.choice((-1, -1, 1)) * Fraction(rng.randrange(1, size), rng.choice((1, 1, 1, 3)))
            for _ in "ab"
        )
        t = rng.choice((0, 0, 0, 1, 2))
        if t * t + 4 * a:
            return QuaternionAlgebra("QQ", a, b, t)


def element(A: QuaternionAlgebra, rng: Random) -> Any:
    while True:
        q = A(*(Fraction(rng.randint(-9, 9), rng.choice((1, 1, 2, 3))) for _ in range(4)))
        if q.norm() != 0:
            return q


def lattice(A: QuaternionAlgebra, rng: Random) -> Any:
    from hfield.errors import LatticeError

    while True:
        try:
            return A.lattice([element(A, rng) for _ in range(4)])
        except LatticeError:
            continue


def check_lattices(A: QuaternionAlgebra, rng: Random, count: Counter[str]) -> None:
    L, M = lattice(A, rng), lattice(A, rng)
    assert L.hnf == span(vectors(L.basis))
    assert (L + M).hnf == span(vectors(L.basis) + vectors(M.basis))
    assert (L * M).hnf == span(vectors(p * q for p in L.basis for q in M.basis))
    assert L.conjugate().hnf == span(vectors(q.conjugate() for q in L.basis))
    x = element(A, rng)
    assert (x * L).hnf == span(vectors(x * q for q in L.basis))
    assert (L * x).hnf == span(vectors(q * x for q in L.basis))
    meet = L & M
    assert all(q in L and q in M for q in meet.basis)
    assert (L + M).index(L) == M.index(meet)
    pairs = [*L.basis, *(p + q for p, q in itertools.combinations(L.basis, 2))]
    norms = [fraction(q.norm()) for q in pairs]
    d = math.lcm(*(n.denominator for n in norms))
    assert fraction(L.norm()) == Fraction(math.gcd(*(int(n * d) for n in norms)), d)
    D = L.dual()
    pairing = [[fraction((p * q).trace()) for q in D.basis] for p in L.basis]
    assert span(pairing) == span([[Fraction(int(m == n)) for n in range(4)] for m in range(4)])
    if all(q.norm() != 0 for q in L.basis):
        left, right = None, None
        for q in L.basis:
            one, two = L * q.inverse(), q.inverse() * L
            left = one if left is None else left & one
            right = two if right is None else right & two
        assert L.left_order() == left
        assert L.right_order() == right
        count["left and right order"] += 1
    for name in (
        "normal form",
        "sum",
        "product",
        "conjugate",
        "scaling",
        "intersection",
        "index",
        "norm",
        "dual",
    ):
        count[name] += 1


def check_orders(A: QuaternionAlgebra, rng: Random, count: Counter[str]) -> None:
    O = A.maximal_order()
    assert O.discriminant() == A.discriminant()
    assert O.hnf == span(vectors([*O.basis, *(p * q for p in O.basis for q in O.basis)]))
    count["maximal order"] += 1
    n = rng.choice([n for n in (2, 3, 4, 5, 7, 9, 12, 101) if math.gcd(n, O.discriminant()) == 1])
    E = A.eichler_order(n)
    assert E.discriminant() == n * O.discriminant()
    assert E.hnf == span(vectors([*E.basis, *(p * q for p in E.basis for q in E.basis)]))
    assert E <= O
    count["Eichler order"] += 1
    x, y = (sum((rng.randint(-3, 3) * b for b in O.basis), A(0)) for _ in range(2))
    if x * y != y * x and A.is_division_algebra():  # in M₂(ℚ) they may be triangular
        S = A.order([x, y])
        assert S.hnf == span(vectors([A(1), x, y, x * y]))
        larger = S.maximal_overorder()
        assert larger >= S
        assert larger.discriminant() == A.discriminant()
        assert larger.hnf == span(
            vectors([*larger.basis, *(p * q for p in larger.basis for q in larger.basis)])
        )
        f, G = S.conductor(), S.gorenstein_closure()
        assert S.hnf == span(vectors([A(1), *(f * q for q in G.basis)]))
        count["generated order, maximal over-order, conductor"] += 1
    x = element(A, rng)
    P = x * E * x.inverse()
    found = E.isomorphism(P)
    assert found
    if found.element is not None:
        y = found.element
        assert y * E * y.inverse() == P
    count["isomorphism of orders"] += 1


def check_ideals(A: QuaternionAlgebra, rng: Random, count: Counter[str]) -> None:
    level = rng.choice([n for n in (1, 1, 2, 3, 4, 5, 6, 35) if math.gcd(n, A.discriminant()) == 1])
    O = A.eichler_order(level)
    q, r = rng.sample([p for p in (101, 103, 107, 10007) if O.discriminant() % p], 2)
    I, J = (O.random_ideal(n, seed=rng.randrange(10**9)) for n in (q, r))
    assert I.hnf == span(vectors(b * g for b in O.basis for g in I.basis))
    assert I.norm() == q
    K = I.conjugate() * J
    assert K.hnf == span(vectors(x.conjugate() * y for x in I.basis for y in J.basis))
    x = element(A, rng)
    found = I.equivalence(I * x)
    assert found
    assert found.element is None or I * found.element == I * x
    count["equivalence, true"] += 1
    found = I.equivalence(J)
    if found and found.element is not None:
        assert I * found.element == J
    elif not found:
        assert K.theta_series(1)[1] == 0
        count["equivalence, false"] += 1
    assert I * I.inverse() == O
    assert I.inverse() * I == I.right_order()
    F = I.pushforward(J)
    assert I * F == I & J
    assert I.pullback(F) == J
    count["inverse, pushforward, pullback"] += 1
    P, Q = I.right_order(), J.right_order()
    C = P.connecting_ideal(Q)
    assert (C.left_order(), C.right_order()) == (P, Q)
    assert C <= P
    assert C.primitive_part()[1] == 1
    count["connecting ideal"] += 1
    p = rng.choice((2, 3, 5))
    if O.discriminant() % p:
        ideals = O.ideals_of_norm(p, rng.choice(("left", "right")))
        assert len(set(ideals)) == p + 1
        assert all(x.norm() == p and x <= O for x in ideals)
        count["ideals of given norm"] += 1


def main(words: list[str]) -> None:
    cases = int(words[0]) if words else 10_000
    rng = Random(int(words[1]) if len(words) > 1 else 0)
    count: Counter[str] = Counter()
    start = time.time()
    while not count or min(count.values()) < cases:
        A = algebra(rng)
        for check in (check_lattices, check_orders, check_ideals):
            check(A, rng, count)
    for name, number in sorted(count.items()):
        print(f"{number:7d}  {name}")
    print(f"all agree, {time.time() - start:.0f} s")


if __name__ == "__main__":
    main(sys.argv[1:])
