"""Ideals: generators, arithmetic, those of a norm, equivalence, connecting ideals and KLPT, recomputed."""

import itertools
import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import count
from random import Random
from typing import Any

from flint import fmpq

from hfield import QuaternionAlgebra
from tests.orders import random_lattices as rand
from tests.orders.recomputed import plainly
from tests.orders.recomputed.of_orders import eichler, suborder
from tests.orders.recomputed.plainly import Plain, Rows, rational, rows, span, vector

NORMS = (2, 3, 5, 7, 11, 9, 25, 35, 101, 1001, 10007)


def ideals(
    rng: Random, number: int = 1, definite: bool | None = None, side: str = "left"
) -> tuple[Any, Plain, Any, list[Any]]:
    """Ideals of an Eichler order of different coprime norms."""
    A, plain, O = eichler(rng, definite)
    found: list[int] = []
    while len(found) < number:
        n = rng.choice(NORMS)
        if math.gcd(n, O.discriminant() * math.prod(found)) == 1:
            found.append(n)
    return A, plain, O, [O.random_ideal(n, side, rng.randrange(10**9)) for n in found]


def from_generators(rng: Random) -> None:
    A, plain, O = suborder(rng)
    given = [rand.element(A, rng) for _ in range(rng.randint(1, 3))]
    some = [vector(x) for x in given]
    assert rows(O.left_ideal(given)) == plain.product(rows(O), some)
    assert rows(O.right_ideal(given)) == plain.product(some, rows(O))
    whole = plain.product(plain.product(rows(O), some), rows(O))
    assert rows(O.two_sided_ideal(given)) == whole


def norm_and_sides(rng: Random) -> None:
    _, plain, O, [I] = ideals(rng)
    x = vector(rand.element(O.algebra, rng))
    J = rng.choice((I, I * O.algebra(*x), I.conjugate(), Fraction(2, 3) * I))
    assert rational(J.norm()) == plain.norm_of(rows(J))
    left, right = (plain.colon(rows(J), rows(J), side) for side in ("left", "right"))
    assert rows(J.left_order()) == left
    assert rows(J.right_order()) == right
    order = left if J.side == "left" else right
    assert rows(J.order) == order
    assert J.is_integral() == plainly.inside(rows(J), order)
    assert J.is_two_sided() == (left == right)
    assert J.is_invertible()


def product(rng: Random) -> None:
    """Compatible ones, I·J with the right order of I the left order of J, and others."""
    _, plain, O, [I, J] = ideals(rng, 2)
    K = rng.choice((J, O.random_ideal(13, "left", 1) if O.discriminant() % 13 else J))
    for first, second in ((I.conjugate(), J), (I, J), (K.conjugate(), K), (J, I.conjugate())):
        assert rows(first * second) == plain.product(rows(first), rows(second))


def inverse(rng: Random) -> None:
    _, plain, O, [I] = ideals(rng, side=rng.choice(("left", "right")))
    back = rows(I.inverse())
    assert plain.product(rows(I), back) == plain.colon(rows(I), rows(I), "left")
    assert plain.product(back, rows(I)) == plain.colon(rows(I), rows(I), "right")
    assert rows(O) in (plain.product(rows(I), back), plain.product(back, rows(I)))


def conjugate(rng: Random) -> None:
    _, plain, O, [I] = ideals(rng)
    J = I.conjugate()
    assert rows(J) == span(map(plain.conj, rows(I)))
    assert J.side == "right"
    assert J.order == O


def primitive_part(rng: Random) -> None:
    _, plain, O, [I] = ideals(rng)
    J, m = (rng.randint(1, 12) * I * rng.choice((1, 2))).primitive_part()
    assert not any(
        plainly.inside([plainly.times(fmpq(1, p), x) for x in rows(J)], rows(O))
        for p in plainly.primes_of(int(rational(J.norm())))
    )
    assert rows(J) == rows(I)
    assert m >= 1
    assert plain.norm_of(rows(J)) == rational(I.norm())


def two_sided_prime(rng: Random) -> None:
    _, plain, O = eichler(rng)
    p = rng.choice([*plainly.primes_of(O.discriminant()), 2, 3])
    e = next(e for e in range(9) if O.discriminant() % p ** (e + 1))
    P = rows(O.two_sided_prime(p))
    assert plain.product(rows(O), P) == P == plain.product(P, rows(O))
    part = [plainly.times(p ** (e or 2), x) for x in rows(O)]
    assert plain.product(P, P) == span(part)


def of_norm(rng: Random) -> None:
    """At 2 and 3 all planes of O/p·O are tried; elsewhere left ideals are counted by σ(n)."""
    A, plain, O = eichler(rng)
    side = rng.choice(("left", "right"))
    p = rng.choice((2, 2, 3))
    if rng.random() < 0.6:
        found = {rows(I) for I in O.ideals_of_norm(p, side)}
        assert len(found) == len(O.ideals_of_norm(p, side))
        assert found == set(planes(plain, rows(O), p, side))
        return
    full = A.discriminant()
    n = rng.choice([n for n in range(1, 30) if math.gcd(n, O.level) == 1])
    listed = O.ideals_of_norm(n, side)
    good = [d for d in range(1, n + 1) if n % d == 0 and math.gcd(d, full) == 1]
    assert len({rows(I) for I in listed}) == len(listed) == sum(d for d in good if free(n, full, d))
    for I in listed:
        pair = (rows(O), rows(I)) if side == "left" else (rows(I), rows(O))
        assert plain.product(*pair) == rows(I)
        assert plain.norm_of(rows(I)) == n
        assert plainly.volume(rows(I)) == n * n * plainly.volume(rows(O))


def free(n: int, full: int, d: int) -> bool:
    """Whether d divides the part of n that is prime to the discriminant."""
    while (g := math.gcd(n, full)) > 1:
        n //= g
    return n % d == 0


def planes(plain: Plain, order: Rows, p: int, side: str) -> Iterator[Rows]:
    """Ideals between O and p·O of index p² and norm p: they are locally principal."""
    wide = [plainly.times(p, x) for x in order]
    for lines in echelons(p):
        pair = [plainly.combination(line, order) for line in lines]
        if plain.norm_of([*pair, *wide]) != p:
            continue
        plane = span([*pair, *wide])
        moved = (
            plain.mul(x, y) if side == "left" else plain.mul(y, x) for x in order for y in pair
        )
        if all(plainly.holds(plane, x) for x in moved):
            yield plane


def echelons(p: int) -> Iterator[tuple[list[int], list[int]]]:
    """A basis of each plane in 𝔽ₚ⁴."""
    for m, n in itertools.combinations(range(4), 2):
        free = [k for k in range(m + 1, 4) if k != n], list(range(n + 1, 4))
        for values in itertools.product(range(p), repeat=sum(map(len, free))):
            left = list(values)
            first, second = [int(k == m) for k in range(4)], [int(k == n) for k in range(4)]
            for line, places in zip((first, second), free, strict=True):
                for k in places:
                    line[k] = left.pop()
            yield first, second


def random_ideal(rng: Random) -> None:
    _, plain, O, [I] = ideals(rng)
    n = int(rational(I.norm()))
    assert plain.norm_of(rows(I)) == n
    assert plain.product(rows(O), rows(I)) == rows(I)
    assert plainly.volume(rows(I)) == n * n * plainly.volume(rows(O))
    assert not any(
        plainly.inside([plainly.times(fmpq(1, p), x) for x in rows(I)], rows(O))
        for p in plainly.primes_of(n)
    )


def pushforward_and_pullback(rng: Random) -> None:
    """I·F is the intersection, and J is what lies above it: J = I·F + N(J)·O."""
    _, plain, O, [I, J] = ideals(rng, 2)
    F = I.pushforward(J)
    meet = plain.product(rows(I), rows(F))
    assert plainly.inside(meet, rows(I))
    assert plainly.inside(meet, rows(J))
    assert plainly.volume(meet) * plainly.volume(rows(O)) == plainly.volume(
        rows(I)
    ) * plainly.volume(rows(J))
    wide = [plainly.times(int(rational(J.norm())), x) for x in rows(O)]
    assert rows(I.pullback(F)) == rows(J) == span([*meet, *wide])


def connecting_ideal(rng: Random) -> None:
    _, plain, O, [I, J] = ideals(rng, 2)
    P, Q = rng.choice(((I.right_order(), J.right_order()), (O, I.right_order())))
    C = P.connecting_ideal(Q)
    assert plain.colon(rows(C), rows(C), "left") == rows(P)
    assert plain.colon(rows(C), rows(C), "right") == rows(Q)
    assert plainly.inside(rows(C), rows(P))
    n = int(plain.norm_of(rows(C)))
    assert not any(
        plainly.inside([plainly.times(fmpq(1, p), x) for x in rows(C)], rows(P))
        for p in plainly.primes_of(n)
    )


def equivalence(rng: Random) -> None:
    """J = I·c with the element; or no element of conj(I)·J has norm N(I)·N(J)."""
    A, plain, _, [I, J] = ideals(rng, 2, rng.choice((True, None)), "left")
    side = rng.choice(("left", "right"))
    if side == "right":
        I, J = I.conjugate(), J.conjugate()
    if rng.random() < 0.5:
        x = rand.element(A, rng)
        J = I * x if side == "left" else x * I
        assert I.equivalence(J)
    answer = I.equivalence(J)
    if answer.element is not None:
        c = vector(answer.element)
        moved = (plain.mul(y, c) if side == "left" else plain.mul(c, y) for y in rows(I))
        assert span(moved) == rows(J)
    elif not answer:
        assert none_of_norm(plain, side, rows(I), rows(J))


def none_of_norm(plain: Plain, side: str, first: Rows, second: Rows) -> bool:
    """Whether what carries one ideal into the other has no element of the norm that it needs."""
    between = plain.colon(second, first, "right" if side == "left" else "left")
    size = plain.norm_of(second) / plain.norm_of(first)
    basis = plain.shortened(between)
    box = plain.short(basis, size) if plain.volume_of_box(basis, size) < 10**5 else ()
    return all(n != size for _, n in box)


def principal(rng: Random) -> None:
    A, plain, O = eichler(rng, True)
    x = sum((rng.randint(-3, 3) * b for b in O.basis), A(0))
    if x.norm() == 0:
        return
    I = O.left_ideal([x])
    if rng.random() < 0.5:
        n = next(n for n in (2, 3, 5, 7, 11, 13) if O.discriminant() % n)
        I = rng.choice(O.ideals_of_norm(n))
    answer = I.is_principal()
    if answer:
        assert span(plain.mul(y, vector(answer.element)) for y in rows(O)) == rows(I)
    else:
        assert none_of_norm(plain, "left", rows(O), rows(I))


def equivalent_of_prime_norm(rng: Random) -> None:
    """It is equivalent, and no equivalent ideal has a smaller prime norm: no element of I has."""
    _, plain, _, [I] = ideals(rng, 1, True)
    J, c = I.equivalent_of_prime_norm()
    n = int(rational(J.norm()))
    assert plainly.is_prime(n)
    assert span(plain.mul(x, vector(c)) for x in rows(I)) == rows(J)
    size = plain.norm_of(rows(I))
    basis = [vector(q) for q in I.reduced_basis()]
    if plain.affordable(basis, n * size):
        smaller = {m / size for _, m in plain.short(basis, n * size)} - {n}
        assert not any(m.denominator == 1 and plainly.is_prime(int(m)) for m in smaller)


def klpt(rng: Random) -> None:
    p = next(
        n for n in count(rng.randrange(3, 10 ** rng.choice((3, 4, 6, 9)))) if plainly.is_prime(n)
    )
    A = QuaternionAlgebra.from_ramification("QQ", [p])
    O, plain = A.extremal_order(), Plain(A)
    prime = rng.choice([n for n in (2, 3, 5, 7) if n != p])
    norm = rng.choice([n for n in (2, 3, 7, 101, 103, 1009, 1_000_003) if n not in (p, prime)])
    I = O.random_ideal(norm, "left", rng.randrange(10**9))
    J, c, e = I.equivalent_of_power_norm(prime, rng.randrange(100))
    assert span(plain.mul(x, vector(c)) for x in rows(I)) == rows(J)
    assert plain.product(rows(O), rows(J)) == rows(J)
    assert plain.norm_of(rows(J)) == prime**e


OPERATIONS = {
    "ideals of generators: left, right, two-sided": from_generators,
    "norm, orders and sides of ideals": norm_and_sides,
    "product of ideals": product,
    "inverse of ideals": inverse,
    "conjugate ideal": conjugate,
    "primitive part": primitive_part,
    "two-sided prime": two_sided_prime,
    "ideals of given norm": of_norm,
    "random ideal": random_ideal,
    "pushforward, pullback": pushforward_and_pullback,
    "connecting ideal": connecting_ideal,
    "equivalence of ideals": equivalence,
    "principal ideals": principal,
    "equivalent ideal of prime norm": equivalent_of_prime_norm,
    "KLPT": klpt,
}
