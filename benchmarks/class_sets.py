"""How long class sets take, by the degree of the field, and how time and memory grow with their size.

    python benchmarks/class_sets.py [NUMBER ...]
    python benchmarks/class_sets.py --growth [P ...]

For each field and number it takes an Eichler order in a totally definite algebra of least discriminant, whose
level is a prime ideal of degree 1, so that there are about so many classes. Prints milliseconds a class, as a
table in Markdown. With --growth it takes maximal orders over ℤ of prime discriminants, each in a process of
its own: seconds for the classes with the rows of T₂, for the rational newforms after that, and memory beyond
that of the start. The exponents e tell that a number grows like (classes)^e from one line to the next.
"""

import json
import math
import resource
import subprocess
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
PRIMES = (1_009, 10_007, 100_003, 1_000_003)
MAX_FORMS_PRIME = 200_000
"""Up to this prime newforms are computed: their time is quadratic in the number of classes."""


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


def measured(p: int) -> dict[str, float]:
    """Return the number of classes of discriminant p, seconds of processor time, and megabytes."""
    O = QuaternionAlgebra(p).maximal_order()
    O.mass()
    QuaternionAlgebra(11).maximal_order().class_set().rational_newforms()  # imports what it needs
    memory, start = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, time.process_time()
    C = O.class_set()
    C.neighbour_counts(2)
    found = {"classes": len(C), "seconds": time.process_time() - start}
    found["MB"] = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - memory) / 1024
    if p <= MAX_FORMS_PRIME:
        start = time.process_time()
        C.rational_newforms()
        found["newforms"] = time.process_time() - start
    return found


def growth(primes: list[int]) -> None:
    """Print how time and memory grow with the discriminant."""
    print("| p | classes | classes and T₂, s | e | memory, MB | e | newforms, s | e |")
    print("|---" * 8 + "|")
    before: dict[str, float] = {}
    for p in primes:
        words = [sys.executable, __file__, "--one", str(p)]
        now = json.loads(subprocess.run(words, capture_output=True, check=True, text=True).stdout)
        cells = [str(p), str(now["classes"])]
        for name in ("seconds", "MB", "newforms"):
            value, last = now.get(name), before.get(name)
            exponent = ""
            if value and last:
                exponent = (
                    f"{math.log(value / last) / math.log(now['classes'] / before['classes']):.2f}"
                )
            cells += ["" if value is None else f"{value:.2g}", exponent]
        print("|", " | ".join(cells), "|", flush=True)
        before = now


def main() -> int:
    """Print the table."""
    if sys.argv[1:2] == ["--one"]:
        print(json.dumps(measured(int(sys.argv[2]))))
        return 0
    if sys.argv[1:2] == ["--growth"]:
        growth(list(map(int, sys.argv[2:])) or list(PRIMES))
        return 0
    by_degree(list(map(int, sys.argv[1:])) or list(NUMBERS))
    return 0


def by_degree(numbers: list[int]) -> None:
    """Print milliseconds a class, by the degree of the field."""
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


if __name__ == "__main__":
    sys.exit(main())
