"""Definite Eichler orders with few classes over totally real fields of degree 2 to 6, and identities of each.

    python scripts/try_definite_orders.py [--degree 2] [--discriminant 2000] [--classes 2] [--seconds 600]

Each class has a term 1/[O_L(I)ˣ : ℤ_Kˣ] ≤ 1 in the mass, so that orders with at most so many classes are
among those with at most that mass: over fields whose own mass is small, for all products D of primes and all
levels N (M. Kirschmer and J. Voight, *SIAM J. Comput.* 39, 2010, section 8). Of each class set it is checked
that all stable classes have the same mass, that there are as many as narrow classes, that rows of a Brandt
matrix have the right sums, and that the weights make it symmetric. Fields of degree 3 and more are those of
polynomials with small coefficients, told apart by PARI (cypari): not all fields, perhaps. Prints a line for
each order with few classes: discriminants of field, D, N, classes, types, mass, cancellation, Hermite. Exit
status 1 if an identity fails.
"""

import argparse
import sys
import time
from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

import cypari

sys.path.insert(0, str(Path(__file__).parents[1]))

from hfield import QuaternionAlgebra, ring
from hfield.primality import primes

SIZES = {3: 5, 4: 6, 5: 6, 6: 7}
"""The largest coefficients below the first two, which are 1 and 0 or −1."""


def fields(degree: int, largest: int) -> list[tuple[int, str]]:
    """Return discriminants and polynomials of totally real fields, ascending."""
    found: dict[str, int] = {}
    if degree == 2:
        candidates: Iterator[str] = (f"x^2-x*{d % 4 % 2}-{d // 4}" for d in range(5, largest + 1))
    else:
        sizes = [range(-SIZES[degree], SIZES[degree] + 1)] * (degree - 1)
        candidates = (
            f"x^{degree}-{t}*x^{degree - 1}" + "".join(f"{c:+d}*x^{k}" for k, c in enumerate(cs))
            for t in (0, 1)
            for cs in product(*sizes)
            if cs[0] and cs[-1] < 0
        )
    for text in candidates:
        f = cypari.pari(text)
        if int(f.polsturm()) == degree and f.polisirreducible():
            d = int(f.nfdisc())
            if d <= largest:
                found[str(f.polredabs()).replace("x", "s").replace(" ", "")] = d
    return sorted((d, f) for f, d in found.items())


def ideals(of_primes: list[Any], room: Fraction, factor: Any) -> Iterator[tuple[Any, ...]]:
    """Yield lists of (P, e) for which the product of factors (of the norm and e) is at most a bound."""
    if not of_primes:
        yield ()
        return
    P, *rest = of_primes
    yield from ideals(rest, room, factor)
    e = 1
    while (size := factor(P.norm, e)) and size <= room:
        for other in ideals(rest, room / size, factor):
            yield ((P, e), *other)
        e += 1


def orders(K: Any, most: int) -> Iterator[tuple[Any, int, int]]:
    """Yield Eichler orders with a mass of at most ``most``, and the norms of D and N."""
    n = K.degree
    base = Fraction(abs(K.zeta_minus_one()) * K.class_group().order, 2 ** (n - 1))
    room = most / base
    small = [P for p in primes(int(room) + 2) for P in K.primes_above(p) if P.norm - 1 <= room]
    for ramified in ideals(small, room, lambda q, e: (q - 1) * (e == 1)):
        if (len(ramified) + n) % 2:
            continue
        own = [P for P, _ in ramified]
        A = QuaternionAlgebra.from_ramification(K, [*K.real_places(), *own])
        left = room
        for P in own:
            left /= P.norm - 1
        others = [P for P in small if P not in own]
        for level in ideals(others, left, lambda q, e: q ** (e - 1) * (q + 1)):
            d, size = 1, 1
            for P in own:
                d *= P.norm
            for P, e in level:
                size *= P.norm**e
            yield A.eichler_order(list(level) or 1), d, size


def wrong(C: Any, K: Any) -> list[str]:
    """Return which identities fail."""
    out = []
    masses: Counter[int] = Counter()
    for kind, units in zip(C.stable_classes(), C.units, strict=True):
        masses[kind] += Fraction(1, units)  # type: ignore[assignment]
    if len(masses) != K.narrow_class_group().order or len(set(masses.values())) != 1:
        out.append("the stable classes do not have one mass each")
    P = next(C.good_primes())
    matrix, size = C.brandt_matrix(P), range(len(C))
    sums = {sum(matrix[i][j] for j in size) for i in size}
    if sums != {P.norm + 1}:
        out.append("rows of a Brandt matrix have other sums")
    if any(matrix[i][j] * C.units[j] != matrix[j][i] * C.units[i] for i in size for j in size) and (
        K.narrow_class_group().order == 1
    ):
        out.append("a Brandt matrix is not symmetric for the weights")
    return out


def main() -> int:
    """Run and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--degree", type=int, default=2, choices=range(2, 7))
    parser.add_argument("--discriminant", type=int, default=2000)
    parser.add_argument("--classes", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=600)
    args = parser.parse_args()
    start, tally, failures = time.monotonic(), Counter[str](), 0
    for d, f in fields(args.degree, args.discriminant):
        K: Any = ring(f"QQ[s]/({f})")
        for O, D, N in orders(K, args.classes):
            if time.monotonic() - start > args.seconds:
                print(f"stopped at the field of discriminant {d}")
                print(dict(tally))
                return int(failures > 0)
            C = O.class_set()
            tally["orders"] += 1
            for text in wrong(C, K):
                failures += 1
                print(f"{f}, D = {D}, N = {N}: {text}", flush=True)
            if len(C) <= args.classes:
                cancels, hermite = C.has_cancellation(), C.is_hermite()
                tally[f"of {len(C)} classes"] += 1
                tally["with cancellation"] += cancels
                tally["Hermite"] += hermite
                kinds = "cancellation" * cancels or "Hermite" * hermite or "-"
                print(d, D, N, len(C), C.type_number, C.mass, kinds, flush=True)
    print(dict(tally), f"{time.monotonic() - start:.0f} s")
    return int(failures > 0)


if __name__ == "__main__":
    sys.exit(main())
