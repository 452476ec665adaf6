"""Class sets, Brandt matrices and types, recomputed from short elements and the product formulas."""

import math
from random import Random
from typing import Any

from flint import fmpq

from hfield import QuaternionAlgebra
from tests.orders.recomputed import plainly
from tests.orders.recomputed.of_ideals import none_of_norm
from tests.orders.recomputed.of_orders import isometric
from tests.orders.recomputed.plainly import Plain, rational, rows

PAIRS = [
    (d, n)
    for d in range(2, 240)
    if len(plainly.primes_of(d)) % 2 and math.prod(plainly.primes_of(d)) == d
    for n in range(1, 240 // d + 1)
    if math.gcd(d, n) == 1
]


def classes(rng: Random, most: int = 120) -> tuple[int, int, Any, Plain, Any]:
    d, n = rng.choice([pair for pair in PAIRS if pair[0] * pair[1] <= most])
    A = QuaternionAlgebra.from_ramification("QQ", plainly.primes_of(d))
    return d, n, A, Plain(A), A.eichler_order(n).class_set()


def class_set(rng: Random) -> None:
    """Different classes, with as many units as they are said to have, that use up the mass."""
    d, n, A, plain, C = classes(rng, 60)
    found = [rows(I) for I in C]
    for m, I in enumerate(found):
        assert plain.product(I, rows(C.order)) == I
        order = plain.shortened(plain.colon(I, I, "left"))
        assert sum(1 for _, size in plain.short(order, fmpq(1)) if size) == C.unit_counts[m]
    pairs = [(m, k) for m in range(len(C)) for k in range(m)]
    for m, k in rng.sample(pairs, min(3, len(pairs))):
        assert none_of_norm(plain, "right", found[m], found[k])
    mass = fmpq(math.prod(p - 1 for p in plainly.primes_of(d)), 12)
    mass *= n * math.prod(1 + fmpq(1, p) for p in plainly.primes_of(n))
    assert sum(fmpq(2, u) for u in C.unit_counts) == mass == rational(C.mass)
    assert len(C) == A.class_number(n)


def class_of_an_ideal(rng: Random) -> None:
    _, _, _, plain, C = classes(rng)
    n = next(n for n in (2, 3, 5, 7, 11, 13) if C.order.discriminant() % n)
    I = C.order.random_ideal(n ** rng.randint(1, 4), "right", rng.randrange(10**9))
    m = C.index(I)
    answer = C[m].equivalence(I)
    assert answer
    c = plainly.vector(answer.element)
    assert plainly.span(plain.mul(c, x) for x in rows(C[m])) == rows(I)


def brandt_matrix(rng: Random) -> None:
    """Entry (i, j) counts the elements of ``I_i·I_j⁻¹`` of norm n·N(I_i)/N(I_j), by units of j."""
    _, _, _, plain, C = classes(rng, 90)
    n = rng.randint(1, 6)
    if math.gcd(n, C.order.discriminant()) > 1:
        n = 1
    B = C.brandt_matrix(n)
    i, j = rng.randrange(len(C)), rng.randrange(len(C))
    first, second = rows(C[i]), rows(C[j])
    between = plain.shortened(plain.colon(first, second, "left"))
    size = n * plain.norm_of(first) / plain.norm_of(second)
    count = sum(1 for _, m in plain.short(between, size) if m == size)
    assert count == B[i][j] * C.unit_counts[j]
    sums = sum(d for d in range(1, n + 1) if n % d == 0)
    assert {sum(row) for row in B} == {sums}
    assert C.theta_series(i, j, n)[n] == count


def types(rng: Random) -> None:
    _, _, _, plain, C = classes(rng, 40)
    orders = [plain.colon(rows(I), rows(I), "left") for I in C]
    kinds: list[plainly.Rows] = []
    found = []
    for order in orders:
        known = next((n for n, other in enumerate(kinds) if isometric(plain, order, other)), None)
        if known is None:
            known = len(kinds)
            kinds.append(order)
        found.append(known)
    assert C.type_number == len(kinds)
    assert C.types == found


def class_number(rng: Random) -> None:
    """Eichler's formula, once more, from numbers of embeddings of ℤ[i] and ℤ[ω]."""
    d = rng.choice([d for d, _ in PAIRS] + [1_000_003, 30 * 7 * 11, 10_007])
    n = rng.choice([n for n in range(1, 200) if math.gcd(n, d) == 1])
    A = QuaternionAlgebra.from_ramification("QQ", plainly.primes_of(d))
    mass = fmpq(math.prod(p - 1 for p in plainly.primes_of(d)), 12)
    mass *= n * math.prod(1 + fmpq(1, p) for p in plainly.primes_of(n))
    four, three = (embedded(d, n, disc) for disc in (-4, -3))
    assert A.class_number(n) == mass + fmpq(four, 4) + fmpq(three, 3)


def embedded(d: int, n: int, disc: int) -> int:
    """Optimal embeddings into the orders of level n, up to units, summed over the classes.

    ``∏ (1 − (disc/p))`` over p dividing d, times the roots modulo n, all of them simple or above no square.
    """
    t = disc % 2
    norm = (t - disc) // 4
    roots = sum((x * x - t * x + norm) % n == 0 for x in range(n))
    return roots * math.prod(1 - plainly.kronecker(disc, p) for p in plainly.primes_of(d))


OPERATIONS = {
    "class set": class_set,
    "class of an ideal": class_of_an_ideal,
    "Brandt matrix": brandt_matrix,
    "types": types,
    "class number": class_number,
}
