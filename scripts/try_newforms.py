"""Newforms over ℚ against PARI's (cypari): every level up to a bound, weights 2 to 12.

    python scripts/try_newforms.py [--below 301] [--from 2] [--weights 2 12] [--seconds 600] [--orbits 20]
        [--log FILE]

Each level is written in every way as D·N with D a product of an odd number of primes that do not divide N.
The characteristic polynomials of T₂, T₃, T₅, T₇ on the new subspace are compared with ``mfheckemat``. If one
is squarefree, the degrees of its factors are those of the orbits. If the subspace has at most ``--orbits``
dimensions, the orbits are compared with ``mfsplit`` too, by the minimal polynomials of these eigenvalues.

Small level·(weight − 1) come first. With ``--log`` each level and weight compared is written to the file, and
those already in it are passed over. Ends when all are compared or the time is over. Exit status 1 if a
polynomial or a degree differs.
"""

import argparse
import sys
import time
from collections.abc import Iterator
from itertools import combinations, product
from math import gcd, prod
from pathlib import Path

from cypari import pari
from flint import fmpz_poly

sys.path.insert(0, str(Path(__file__).parents[1]))

from hfield import QuaternionAlgebra
from hfield.core.factorisation import factorise
from hfield.orders.newforms import Newform

PRIMES = [2, 3, 5, 7]
Polynomials = list[list[int]]
# Modulo primes, as far as Deligne's bound of the eigenvalues asks: exact ones of large matrices take minutes.
POLYNOMIALS = """
(mf, k, primes) -> my(matrices = mfheckemat(mf, primes));
vector(#primes, i, my(bound = (3 + 2 * sqrtint(primes[i]^(k - 1)))^#matrices[i], p = 2^61, f = 0, size = 1);
while(size <= 2 * bound, p = nextprime(p + 1); my(g = charpoly(matrices[i] * Mod(1, p)));
f = if(size == 1, g, chinese(f, g)); size *= p);
Vecrev(centerlift(f)))
"""
ORBITS = """
(mf, primes) -> my(minimal(c) = Vecrev(if(type(c) == "t_POLMOD", minpoly(c), x - c)));
apply(f -> apply(p -> minimal(mfcoef(f, p)), primes), mfeigenbasis(mf))
"""


def algebras(level: int) -> Iterator[tuple[int, int]]:
    """The (D, N) with D·N = level, D a product of an odd number of primes that do not divide N."""
    primes = sorted(factorise(level))
    for size in range(1, len(primes) + 1, 2):
        for some in combinations(primes, size):
            D = prod(some)
            if gcd(D, level // D) == 1:
                yield D, level // D


def hecke_polynomials(forms: list[Newform]) -> Polynomials:
    """The characteristic polynomials of the Hecke operators on the new subspace."""
    found = []
    for p in PRIMES:
        whole = fmpz_poly([1])
        for f in forms:
            polynomial = fmpz_poly(f.minimal_polynomial(p))
            whole *= polynomial ** (f.degree // polynomial.degree())
        found.append([int(c) for c in whole.coeffs()])
    return found


def orbit_degrees(polynomials: Polynomials) -> list[int] | None:
    """The degrees of the Galois orbits, if one of the characteristic polynomials is squarefree."""
    for coefficients in polynomials:
        factors = fmpz_poly(coefficients).factor()[1]
        if all(exponent == 1 for _, exponent in factors):
            return sorted(f.degree() for f, _ in factors)
    return None


def orbits(forms: list[Newform]) -> list[Polynomials]:
    """The minimal polynomials of the eigenvalues, orbit by orbit."""
    return sorted([f.minimal_polynomial(p) for p in PRIMES] for f in forms)


def main() -> int:
    """Compare, print what differs, and count."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--from", dest="first", type=int, default=2)
    parser.add_argument("--below", type=int, default=301)
    parser.add_argument("--weights", type=int, nargs=2, default=(2, 12))
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--orbits", type=int, default=20)
    parser.add_argument("--log", type=Path)
    args = parser.parse_args()
    pari.allocatemem(2 * 10**9)
    whole, split = (pari(text.replace("\n", " ")) for text in (POLYNOMIALS, ORBITS))
    end = time.monotonic() + args.seconds
    compared = spaces = orbit_spaces = failures = 0
    mine = its = 0.0
    weights = range(args.weights[0], args.weights[1] + 1, 2)
    done: set[tuple[int, ...]] = set()
    if args.log and args.log.exists():
        done = {tuple(map(int, line.split()[:2])) for line in args.log.read_text().splitlines()}
    levels = [M for M in range(args.first, args.below) if any(algebras(M))]
    pairs = sorted(set(product(levels, weights)) - done, key=lambda pair: pair[0] * (pair[1] - 1))
    for level, k in pairs:
        if time.monotonic() > end:
            break
        start = time.monotonic()
        mf = pari(f"mfinit([{level}, {k}], 0)")
        dimension = int(pari.mfdim(mf))
        expected: Polynomials = [[1]] * len(PRIMES)
        if dimension:
            expected = [[int(c) for c in f] for f in whole(mf, k, PRIMES)]
        has_orbits = 0 < dimension <= args.orbits
        expected_orbits = (
            sorted([[int(c) for c in f] for f in form] for form in split(mf, PRIMES))
            if has_orbits
            else []
        )
        degrees = orbit_degrees(expected)
        middle = time.monotonic()
        differences = failures
        for D, N in algebras(level):
            forms = QuaternionAlgebra(D).eichler_order(N).class_set().newforms(weight=k)
            same = hecke_polynomials(forms) == expected
            if degrees is not None:
                same = same and sorted(f.degree for f in forms) == degrees
            if has_orbits:
                same = same and orbits(forms) == expected_orbits
            if not same:
                failures += 1
                print(f"differs: D = {D}, N = {N}, weight {k}", flush=True)
            spaces += 1
            orbit_spaces += has_orbits or degrees is not None
        its += middle - start
        mine += time.monotonic() - middle
        compared += 1
        if args.log:
            depth = "orbits" if has_orbits else "polynomials" if degrees is None else "degrees"
            with args.log.open("a") as log:
                log.write(
                    f"{level} {k} dimension {dimension}, {depth}, {failures - differences} differ, "
                    f"{middle - start:.1f} s PARI, {time.monotonic() - middle:.1f} s here\n"
                )
    print(
        f"{compared} of {len(pairs)} levels and weights: {spaces} new subspaces, "
        f"{orbit_spaces} of them with degrees of orbits, {failures} differ; {mine:.0f} s here, "
        f"{its:.0f} s PARI"
    )
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
