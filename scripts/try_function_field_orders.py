"""Orders over 𝔽_q[t]: class numbers, Brandt matrices, and supersingular Drinfeld modules.

    python scripts/try_function_field_orders.py [--largest 3000] [--seconds 300]

For q ≤ 9 and each degree d up to 6 the class set of a maximal order of prime discriminant P is enumerated,
where q^d is at most ``--largest``. Its number is compared with Gekeler's, the units with the mass. Brandt
matrices at two primes commute, have row sums q^deg + 1 and are symmetric for the weights. Where there are at
most 100 classes and P has coefficients in the prime field, the Brandt matrix of t is compared with the
isogenies of supersingular Drinfeld modules, computed from their equations. Then come composite discriminants
and levels. Exit status 1 if something differs. It stops after ``--seconds``.
"""

import argparse
import sys
import time
from fractions import Fraction
from itertools import islice, takewhile
from pathlib import Path
from typing import Any

from flint import fmpz_mat

sys.path.insert(0, str(Path(__file__).parents[1]))

from hfield import QuaternionAlgebra, ring
from tests.orders.drinfeld import SupersingularModules

FIELDS = {2: (2, 1), 3: (3, 1), 4: (2, 2), 5: (5, 1), 7: (7, 1), 8: (2, 3), 9: (3, 2)}
MAX_MODULES = 100


def gekeler(q: int, d: int) -> int:
    return (q**d - q) // (q * q - 1) + 1 if d % 2 else (q**d - 1) // (q * q - 1)


def primes(F: Any, d: int) -> Any:
    """The primes of a degree."""
    places = takewhile(lambda v: v.degree <= d, F.places())
    return (v for v in places if v.poly is not None and v.degree == d)


def check_brandt(C: Any, q: int, off: list[Any]) -> list[str]:
    """Compare two Brandt matrices with what they must be."""
    size, weights, found = range(len(C)), C.units, []
    matrices = [C.brandt_matrix(P) for P in off]
    for P, T in zip(off, matrices, strict=True):
        if {sum(row) for row in T} != {q**P.degree + 1}:
            found.append(f"row sums at {P}")
        if any(T[i][j] * weights[j] != T[j][i] * weights[i] for i in size for j in size):
            found.append(f"weights at {P}")
    T, S = map(fmpz_mat, matrices)
    if T * S != S * T:
        found.append("they do not commute")
    return found


def check_prime(q: int, d: int, v: Any) -> str:
    F = v.field
    started = time.perf_counter()
    C = QuaternionAlgebra.from_ramification(F, [v, "inf"]).maximal_order().class_set()
    wrong = []
    if len(C) != gekeler(q, d):
        wrong.append(f"{len(C)} classes, not {gekeler(q, d)}")
    if not C.mass == Fraction(q**d - 1, q * q - 1) == sum(Fraction(1, n) for n in C.units):
        wrong.append("mass")
    compared = ""
    if len(C) <= 1_000:
        off = list(islice((w for w in F.places() if w.poly is not None and w != v), 2))
        wrong += check_brandt(C, q, off)
    p, n = FIELDS[q]
    coefficients = [F.base.label(F.base_element(c)) for c in v.poly.coeffs()]
    if len(C) <= MAX_MODULES and max(coefficients) < p and coefficients[0]:
        modules = SupersingularModules(q, d, coefficients, (p, n))
        isogenies, B = modules.isogenies(), C.brandt_matrix(F.gen)
        compared = ", isogenies compared"
        if sorted(map(sorted, isogenies)) != sorted(map(sorted, B)):
            wrong.append("rows of isogenies")
        if fmpz_mat(isogenies).charpoly() != fmpz_mat(B).charpoly():
            wrong.append("isogenies")
    seconds = time.perf_counter() - started
    print(f"q={q} P={v}: {len(C)} classes, mass {C.mass}{compared}, {seconds:.1f} s", flush=True)
    return f"q={q} P={v}: {', '.join(wrong)}" if wrong else ""


def check_composite(q: int) -> list[str]:
    """Compare masses and units of composite discriminants and levels."""
    F = ring(f"GF({q})(t)")
    linear = list(primes(F, 1))
    P = next(primes(F, 2))
    wrong = []
    for places, level in (([*linear[:2], P], None), ([P], linear[0]), ([linear[0]], P)):
        if len(places) % 2 == 0:
            continue
        A = QuaternionAlgebra.from_ramification(F, [*places, "inf"])
        O = A.maximal_order() if level is None else A.eichler_order(level)
        C = O.class_set()
        mass = Fraction(1, q * q - 1)
        for v in places:
            mass *= q**v.degree - 1
        if level is not None:
            mass *= q**level.degree + 1
        if not C.mass == mass == sum(Fraction(1, n) for n in C.units):
            wrong.append(f"q={q} {places}, level {level}: mass")
        if len(C) <= 300:
            off = (w for d in (1, 2, 3) for w in primes(F, d) if w not in (*places, level))
            wrong += check_brandt(C, q, list(islice(off, 2)))
        print(f"q={q} D={places} N={level}: {len(C)} classes, mass {C.mass}", flush=True)
    return wrong


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--largest", type=int, default=3_000)
    parser.add_argument("--seconds", type=float, default=300)
    args = parser.parse_args()
    end, wrong = time.monotonic() + args.seconds, list[str]()
    for d in range(1, 7):
        for q in FIELDS:
            if q**d > args.largest:
                continue
            for v in islice(primes(ring(f"GF({q})(t)"), d), 3 if q**d < 100 else 1):
                if time.monotonic() > end:
                    print("stopped: the time limit was reached")
                    return bool(wrong)
                wrong += filter(None, [check_prime(q, d, v)])
    for q in FIELDS:
        if q < 8 and time.monotonic() < end:
            wrong += check_composite(q)
    print(*wrong, sep="\n")
    print("all agree" if not wrong else f"{len(wrong)} differ")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
