"""Check the calls for cryptographers on random ideals, and the orders of SQIsign, within a time.

    python -m scripts.try_quaternion_ideals [--ideals 1000] [--seconds 120]

For each prime random left and right ideals of extremal and other orders: two generators, reduced equivalent
ideals, norms that divide a smooth number, pairs of norms with a sum, and matrices modulo N. All is checked by
arithmetic of lattices. For primes below 2²⁰ the norms that divide a small number are compared with a list of
all short elements, and numbers of all sizes are tried, which leaves none undecided. Prints a line for each
prime: how many ideals, how often each call was undecided, and milliseconds a call.
"""

import argparse
import math
import random
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from hfield import Ideal, NoEquivalentIdealError, Order, QuaternionAlgebra, UndecidedError
from hfield.core.primality import is_prime

PRIMES = (419, 1009, 2**61 - 1, 5 * 2**248 - 1, 27 * 2**500 - 1, 2**500 + 55)
SMOOTH = math.prod(q**9 for q in range(3, 200, 2) if all(q % d for d in range(3, q, 2)))
LEVELS = {
    5 * 2**248 - 1: (1, 5, 17, 37, 41, 53, 97),
    65 * 2**376 - 1: (1, 5, 13, 17, 41, 73, 89, 97),
    27 * 2**500 - 1: (1, 5, 37, 61, 97, 113, 149),
}
"""The primes of SQIsign 2.0.1, and the q of its extremal orders."""


def check(claim: bool, what: str) -> None:
    """Raise AssertionError with a text unless a claim holds."""
    if not claim:
        raise AssertionError(what)


def moved(ideal: Ideal, c: Any) -> Any:
    """Return the equivalent ideal I·c, or c·I."""
    return c * ideal if ideal.side == "right" else ideal * c


def generators(ideal: Ideal, _: random.Random) -> None:
    """Check that the two generators span the ideal."""
    n, x = ideal.generators
    make = ideal.order.right_ideal if ideal.side == "right" else ideal.order.left_ideal
    check(make([n, x]) == ideal, "two generators")


def reduced(ideal: Ideal, _: random.Random) -> None:
    """Check the multiplier, and that no shorter element was missed."""
    J = ideal.reduced_equivalent()
    check(moved(ideal, J.element) == J and ideal.order >= J, "reduced equivalent ideal")
    check(J.norm() == ideal.shortest()[0].norm() / ideal.norm(), "its norm")


def dividing(ideal: Ideal, rng: random.Random) -> None:
    """Check multiplier and norm of an equivalent ideal whose norm divides a number."""
    bits = 7 * int(ideal.order.discriminant()).bit_length() + 120
    number = rng.choice(
        [2**bits, 3 ** (2 * bits // 3), 6 ** (bits // 2), SMOOTH * 2 ** (bits // 2)]
    )
    check_dividing(ideal, number, rng.randrange(99))


def check_dividing(ideal: Ideal, number: int, seed: int = 0) -> bool:
    """Find and check an equivalent ideal."""
    J, c, n = ideal.equivalent_of_norm_dividing(number, seed=seed)
    check(moved(ideal, c) == J and ideal.order >= J, "norm that divides: multiplier")
    check(J.norm() == n and number % n == 0, "norm that divides: norm")
    return True


def pairs(ideal: Ideal, rng: random.Random) -> None:
    """Check multipliers and norms of a pair."""
    p = int(ideal.order.discriminant())
    total = rng.choice(
        [2 * p + rng.randrange(1, p), 2 ** (p.bit_length() + 1), 2 ** (p.bit_length() + 30)]
    )
    check_pair(ideal, total, rng.randrange(99))


def check_pair(ideal: Ideal, total: int, seed: int = 0) -> bool:
    """Find and check a pair."""
    (J, c), (K, d) = ideal.equivalent_pair(total, seed=seed)
    check(moved(ideal, c) == J and moved(ideal, d) == K, "pair: multipliers")
    check(J.norm() + K.norm() == total and math.gcd(J.norm(), K.norm()) == 1, "pair: norms")
    return True


def matrices(ideal: Ideal, rng: random.Random) -> None:
    """Check that ideals and their kernels belong together, and products of matrices."""
    n = int(ideal.norm())
    M = ideal.order.modulo(n, factors=[q for q in (2, 3, 5, 7, 2**127 - 1) if n % q == 0])
    left = ideal.conjugate() if ideal.side == "right" else ideal
    check(M.ideal(M.kernel(left)) == left, "kernel")
    x, y = (sum((rng.randrange(n) * b for b in ideal.order.basis), ideal.algebra(0)) for _ in "xy")
    (a, b), (c, d) = M(x)
    (e, f), (g, h) = M(y)
    product = ((a * e + b * g) % n, (a * f + b * h) % n), ((c * e + d * g) % n, (c * f + d * h) % n)
    check(M(x * y) == product and M.lift(M(x)) - x in n * ideal.order, "matrices")


CALLS: dict[str, Callable[[Ideal, random.Random], None]] = {
    "generators": generators,
    "reduced": reduced,
    "dividing": dividing,
    "pair": pairs,
    "modulo": matrices,
}


def ideals(order: Order, number: int, rng: random.Random) -> Iterator[Ideal]:
    """Yield random ideals of an order, of norms smooth or prime, small or large."""
    norms = (2, 3, 4, 5, 6, 35, 36, 101, 1013, 2**64, 3**40, 2**127 - 1, 210**9)
    p = int(order.discriminant())
    fitting = [n for n in norms if n % p]
    for _ in range(number):
        side = rng.choice(["left", "left", "right"])
        yield order.random_ideal(rng.choice(fitting), side, seed=rng.randrange(2**30))


def try_prime(p: int, number: int, seconds: float) -> None:
    """Try a prime: four in five ideals belong to the extremal order, the others to other orders."""
    start, rng = time.monotonic(), random.Random(p)
    O = QuaternionAlgebra(p).extremal_order()
    other = O.random_ideal(2**89 - 1, seed=1).right_order()
    times, undecided, tried = Counter[str](), Counter[str](), 0
    for k in range(number):
        if time.monotonic() - start > seconds:
            break
        order = other if k % 5 == 4 else O
        (I,) = ideals(order, 1, rng)
        tried += 1
        for name, call in CALLS.items():
            if name == "pair" and order is other and p > 2**40:
                continue
            before = time.process_time()
            try:
                call(I, rng)
            except UndecidedError:
                undecided[name] += 1
            times[name] += time.process_time() - before
    shown = ", ".join(f"{name} {1000 * times[name] / max(tried, 1):.1f}" for name in CALLS)
    print(
        f"p of {p.bit_length()} bits: {tried} ideals; ms with checks: {shown}; undecided: {dict(undecided)}"
    )
    sys.stdout.flush()


def try_small_primes(number: int, seconds: float) -> None:
    """Compare with lists of all short elements, for primes below 2²⁰."""
    start, rng, tried, found = time.monotonic(), random.Random(1), 0, 0
    while tried < number and time.monotonic() - start < seconds:
        p = rng.randrange(2, 2 ** rng.randrange(3, 21))
        if not is_prime(p):
            continue
        O = QuaternionAlgebra(p).extremal_order()
        order = (
            O
            if rng.random() < 0.5
            else O.random_ideal(2**61 - 1, seed=rng.randrange(99)).right_order()
        )
        n = next(n for n in (rng.choice([1, 2, 3, 5, 101, 1013]) for _ in range(99)) if n % p)
        I = order.random_ideal(n, seed=rng.randrange(99))
        bound = 8 * math.isqrt(p) + 20
        norms = sorted({int(x.norm() / n) for x in I.elements_of_norm_at_most(bound * n)} - {0})
        T = rng.choice(
            [rng.choice(norms), rng.choice(norms) * rng.randrange(1, 99), rng.randrange(1, bound)]
        )
        least = next((m for m in norms if T % m == 0), None)
        tried += 1
        try:
            J, c, m = I.equivalent_of_norm_dividing(T)
        except NoEquivalentIdealError:
            check(least is None, f"refused, and {least} is the norm of one: p = {p}, T = {T}")
            continue
        found += 1
        check(I * c == J and J.norm() == m and T % m == 0, "small: multiplier")
        check(least is None or m == least, f"{least} is a smaller norm: p = {p}, T = {T}")
    print(
        f"primes below 2^20: {tried} ideals, {found} with such a norm, none refused that a list shows"
    )


def try_sizes(number: int, seconds: float) -> None:
    """Try numbers of all sizes for primes below 2²⁰: each is found, or proved to have no solution."""
    start, rng, answers = time.monotonic(), random.Random(2), Counter[str]()
    slowest = 0.0
    while sum(answers.values()) < 3 * number and time.monotonic() - start < seconds:
        p = rng.randrange(2, 2 ** rng.randrange(3, 21))
        if not is_prime(p):
            continue
        order = QuaternionAlgebra(p).extremal_order()
        if rng.random() < 0.6:
            order = order.random_ideal(2**61 - 1, seed=rng.randrange(99)).right_order()
        I = order.random_ideal(rng.choice([n for n in (1, 3, 4, 101, 1013) if n % p]), seed=1)
        bits = rng.randrange(1, 3 * p.bit_length() + 40)
        T = rng.getrandbits(bits) | 1 << bits
        if rng.random() < 0.6:  # a prime has no other divisor that may be a norm
            T = next(n for n in range(T, 2 * T + 9) if is_prime(n))
        for name, call in (
            ("dividing", partial(check_dividing, I, T)),
            ("pair", partial(check_pair, I, T)),
            ("integer", partial(check_integer, order, T * rng.choice([1, 1, p]))),
        ):
            before = time.process_time()
            try:
                answer = "found" if call() else "none"
            except NoEquivalentIdealError:
                answer = "none"
            except UndecidedError:
                answer = "undecided"
                print(f"{name}: undecided for p = {p}, number {T}")
            slowest = max(slowest, time.process_time() - before)
            answers[f"{name} {answer}"] += 1
    print(f"primes below 2^20, all sizes: {dict(sorted(answers.items()))}; slowest {slowest:.1f} s")
    sys.stdout.flush()


def check_integer(order: Order, n: int) -> bool:
    """Return whether an element has norm n, and check it."""
    x = order.represent_integer(n)
    check(x is None or (x.norm() == n and x in order), "integer")
    return x is not None


def try_levels() -> None:
    """Check the extremal orders of SQIsign and the ideals that connect them to the first one."""
    for p, numbers in LEVELS.items():
        A = QuaternionAlgebra("QQ", -1, -p)
        first = A.extremal_order()
        for q in numbers:
            E = A.extremal_order(q)
            B = QuaternionAlgebra("QQ", -q, -p)
            root = next(r for r in range(4 * q) if (r * r + p) % (4 * q) == 0)
            half = "1/2*i + 1/2*j" if q == 1 else "1/2 + 1/2*j"
            last = "1/2 + 1/2*k" if q == 1 else f"{root}/{2 * q}*i - 1/{2 * q}*k"
            theirs = B.order_from_basis(["1", "i", half, last])
            check(B.extremal_order(q).is_isomorphic(theirs), f"order of q = {q}")
            K = first.connecting_ideal(E)
            check(K.left_order() == first and K.right_order() == E, f"connecting ideal of q = {q}")
        print(
            f"SQIsign, p of {p.bit_length()} bits: {len(numbers)} extremal orders and connecting ideals"
        )


def main() -> None:
    """Try everything."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--ideals", type=int, default=1000, help="random ideals for each prime")
    parser.add_argument("--seconds", type=float, default=120, help="at most so long for each prime")
    given = parser.parse_args()
    try_levels()
    try_small_primes(given.ideals, given.seconds)
    try_sizes(given.ideals, given.seconds)
    for p in PRIMES:
        try_prime(p, given.ideals, given.seconds)


if __name__ == "__main__":
    main()
