"""How long class sets take, by the degree of the field and the number of classes.

    python benchmarks/class_sets.py [NUMBER ...]

For each field and number it takes an Eichler order in a totally definite algebra of least discriminant, whose
level is a prime ideal of degree 1, so that there are about so many classes. Prints milliseconds a class, as a
table in Markdown.
"""

import sys
import time
from itertools import count
from typing import Any

from hfield import QuaternionAlgebra, ring
from hfield.core.primality import is_prime

FIELDS = {
    1: "QQ",
    2: "QQ[s]/(s^2-s-1)",
    3: "QQ[s]/(s^3-s^2-2*s+1)",
    4: "QQ[s]/(s^4-s^3-3*s^2+s+1)",
    5: "QQ[s]/(s^5-s^4-4*s^3+3*s^2+3*s-1)",
    6: "QQ[s]/(s^6-s^5-7*s^4+2*s^3+7*s^2-2*s-1)",
}
NUMBERS = (100, 1_000)


def algebra(name: str) -> Any:
    """Return a totally definite algebra of least discriminant."""
    if name == "QQ":
        return QuaternionAlgebra(2)
    K: Any = ring(name)
    odd = K.primes_above(2)[:1] if K.degree % 2 else []
    return QuaternionAlgebra.from_ramification(K, [*K.real_places(), *odd])


def order(A: Any, number: int) -> Any:
    """Return an Eichler order with about so many classes."""
    least = int(number / A.maximal_order().mass())
    for p in filter(is_prime, count(least)):
        if A.ring.name == "QQ":
            return A.eichler_order(p)
        for P in A.ring.primes_above(p):
            if P.f == 1:
                return A.eichler_order([(P, 1)])
    raise AssertionError("there are infinitely many primes of degree 1")


def main() -> int:
    """Print the table."""
    numbers = list(map(int, sys.argv[1:])) or NUMBERS
    print("| degree |", " | ".join(f"{n} classes" for n in numbers), "|")
    print("|---" * (len(numbers) + 1) + "|")
    for degree, name in FIELDS.items():
        cells = []
        A = algebra(name)
        for number in numbers:
            O = order(A, number)
            O.mass()
            start = time.process_time()
            C = O.class_set()
            cells.append(f"{(time.process_time() - start) / len(C) * 1000:.2g}")
        print(f"| {degree} |", " | ".join(cells), "|", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
