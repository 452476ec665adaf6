"""Class numbers of every definite (D, N) with D·N up to a bound: formula = enumeration = mass.

    python scripts/check_classes.py [BOUND] [JOBS]

The enumeration stops only when the masses of the classes add up to the mass formula. Its number is compared
with Eichler's formula. The sum of each row of a Brandt matrix is compared with
the number of ideals, and the weights that make the matrix symmetric with the units.
"""

import sys
import time
from concurrent.futures import ProcessPoolExecutor
from math import gcd

from hfield import QuaternionAlgebra
from hfield.core.factorisation import factorise


def definite_discriminants(bound: int) -> list[int]:
    """Return the products of an odd number of different primes."""
    found = []
    for d in range(2, bound + 1):
        primes = factorise(d)
        if len(primes) % 2 and max(primes.values()) == 1:
            found.append(d)
    return found


def check(task: tuple[int, int]) -> int:
    """Check one pair, and return the number of classes."""
    d, n = task
    A = QuaternionAlgebra.from_ramification("QQ", sorted(factorise(d)))
    C = A.eichler_order(n).class_set()
    assert len(C) == A.class_number(n), task
    assert sum(2 / type(C.mass)(u) for u in C.unit_counts) == C.mass
    p = next(p for p in (2, 3, 5, 7, 11, 13) if gcd(p, d * n) == 1)
    rows = C.neighbour_counts(p)
    units = C.unit_counts
    for i, row in enumerate(rows):
        assert sum(row.values()) == p + 1, task
        for j, m in row.items():
            assert m * units[j] == rows[j][i] * units[i], task
    return len(C)


def main(words: list[str]) -> None:
    bound = int(words[0]) if words else 2000
    jobs = int(words[1]) if len(words) > 1 else 1
    tasks = [
        (d, n)
        for d in definite_discriminants(bound)
        for n in range(1, bound // d + 1)
        if gcd(d, n) == 1
    ]
    start = time.time()
    with ProcessPoolExecutor(jobs) as pool:
        found = list(pool.map(check, tasks, chunksize=20))
    print(
        f"{len(tasks)} pairs with D·N ≤ {bound}, {sum(found)} classes: all agree, {time.time() - start:.0f} s"
    )


if __name__ == "__main__":
    main(sys.argv[1:])
