"""CM points of Eichler orders over QQ: their numbers, genera of quotients, and embeddings of random orders.

    python scripts/try_cm_points.py counts --most 200 --seconds 600 --file counts.jsonl
    python scripts/try_cm_points.py quotients --most 60 --seconds 600 --file quotients.jsonl
    python scripts/try_cm_points.py table --names names.txt
    python scripts/try_cm_points.py random --count 10000 --seconds 600

``counts`` compares the points of all discriminants -300 <= d < 0 with the class number formula, for each
discriminant D and level N with D·N up to a bound. ``quotients`` compares the genera of all quotients by one
Atkin-Lehner involution, by fixed points, with those of their domains. ``table`` compares the genera of
quotients with a list of names such as X(6,5)-g0-[1,5]. ``random`` looks whether embeddings exist, and are
optimal, in random orders that need not be Eichler orders. With a file, what is in it is not computed again.
Exit status 1 where something differs.
"""

import argparse
import json
import re
import sys
import time
from collections.abc import Iterator
from functools import cache
from math import gcd, isqrt, prod
from pathlib import Path
from random import Random
from typing import Any

from hfield import QuaternionAlgebra
from hfield.core.factorisation import factorise
from hfield.errors import TooLargeError

DISCRIMINANTS = [d for d in range(-300, 0) if d % 4 < 2]


def pairs(most: int, least: int = 1) -> Iterator[tuple[int, int]]:
    """Yield D and N, D·N in order."""
    for whole in range(least, most + 1):
        for D in (d for d in range(1, whole + 1) if whole % d == 0):
            primes = factorise(D) if D > 1 else {}
            if len(primes) % 2 == 0 and set(primes.values()) <= {1} and gcd(D, whole // D) == 1:
                yield D, whole // D


@cache
def order(D: int, N: int) -> Any:
    if D == 1:
        return QuaternionAlgebra("QQ", 1, 1).eichler_order(N)
    return QuaternionAlgebra.from_ramification("QQ", list(factorise(D))).eichler_order(N)


# --- the formula ------------------------------------------------------------------------------------


@cache
def class_number(d: int) -> int:
    forms = 0
    for a in range(1, isqrt(-d // 3) + 1):
        for b in range(-a + 1, a + 1):
            c, rest = divmod(b * b - d, 4 * a)
            if not rest and (c > a or (c == a and b >= 0)) and gcd(a, b, c) == 1:
                forms += 1
    return forms


@cache
def local_number(d: int, p: int, e: int) -> int:
    """Count local embeddings by roots modulo a power of p; e is 0 where the algebra ramifies."""
    t = d % 2

    def roots(k: int) -> list[int]:
        return [x for x in range(p**k) if (x * x - t * x + (t - d) // 4) % p**k == 0]

    if e == 0:
        maximal = d % (p * p) != 0 or d // (p * p) % 4 > 1
        return 2 - len(roots(1)) if maximal and d % p else int(maximal)
    return len(roots(e)) + (len({x % p**e for x in roots(e + 1)}) if d % p == 0 else 0)


def expected(D: int, N: int, d: int) -> int:
    levels = factorise(N) if N > 1 else {}
    ramified = factorise(D) if D > 1 else {}
    numbers = [local_number(d, p, 0) for p in ramified]
    numbers += [local_number(d, p, e) for p, e in levels.items()]
    return class_number(d) * prod(numbers)


# --- what is tried ----------------------------------------------------------------------------------


def counts(D: int, N: int) -> dict[str, Any]:
    G = order(D, N).norm_one_group()
    wrong = {}
    points = 0
    for d in DISCRIMINANTS:
        number = len(G.cm_points(d))
        points += number
        if number != expected(D, N, d):
            wrong[d] = [number, expected(D, N, d)]
    return {"compared": len(DISCRIMINANTS), "points": points, "wrong": wrong}


def quotients(D: int, N: int) -> dict[str, Any]:
    G, whole, wrong, compared = order(D, N).norm_one_group(), D * N, {}, 0
    for m in (m for m in range(2, whole + 1) if whole % m == 0 and gcd(m, whole // m) == 1):
        genus = genus_by_fixed_points(D, N, (1, m))
        by_domain = G.quotient(m).signature.genus
        compared += 1
        if genus != by_domain:
            wrong[m] = [genus, by_domain]
    return {"compared": compared, "wrong": wrong}


@cache
def number_of_fixed_points(D: int, N: int, m: int) -> int:
    return len(order(D, N).norm_one_group().fixed_points(m))


def genus_by_fixed_points(D: int, N: int, group: tuple[int, ...]) -> int | None:
    """Return g' from 2g − 2 = |W|·(2g' − 2) + Σ fixed points, for D > 1; None where it is not an integer."""
    g = order(D, N).norm_one_group().signature.genus
    fixed = sum(number_of_fixed_points(D, N, m) for m in group if m > 1)
    genus, rest = divmod(2 * g - 2 - fixed + 2 * len(group), 2 * len(group))
    return None if rest else genus


def table(names: Path) -> int:
    """Compare a list of names of quotients with their genera."""
    agree, wrong = 0, []
    for line in names.read_text(encoding="utf-8").splitlines():
        m = re.search(r"X\((\d+),\s*(\d+)\)-g(\d+)-\[([\d,\s]*)\]", line)
        if m is None:
            continue
        D, N, genus = int(m[1]), int(m[2]), int(m[3])
        group = tuple(sorted(map(int, m[4].split(","))))
        products = {a * b // gcd(a, b) ** 2 for a in group for b in group}
        if products != set(group):
            wrong.append(f"{line}: {list(group)} is no group")
        elif genus_by_fixed_points(D, N, group) != genus:
            wrong.append(f"{line}: the genus is {genus_by_fixed_points(D, N, group)}")
        else:
            agree += 1
    print(f"{agree} genera agree, {len(wrong)} do not")
    print("\n".join(wrong))
    return int(bool(wrong))


def random_orders(count: int, seconds: float) -> int:
    """Look for embeddings in random orders: elements are optimal, and none agrees with local conditions.

    In orders that are not Eichler orders the local conditions are tried modulo small powers of primes: where
    these find none, "none" is counted as coarse for discriminants with high powers, and else as wrong.
    """
    rng, end, wrong = Random(1), time.monotonic() + seconds, 0
    tally = dict.fromkeys(("found", "none", "none, coarse", "too large"), 0)
    eichler = [(D, N) for D, N in pairs(150) if D > 1]
    others = [
        other_order(rng, *rng.choice([x for x in eichler if x[0] * x[1] < 30])) for _ in range(40)
    ]
    for _ in range(count):
        if time.monotonic() > end:
            break
        D, N = rng.choice(eichler)
        is_eichler = rng.randrange(5) > 0
        O = order(D, N) if is_eichler else rng.choice(others)
        while True:
            d = rng.randrange(-2000, 400)
            if d % 4 < 2 and (d < 0 or isqrt(d) ** 2 != d):
                break
        try:
            E = O.embeddings(d)
        except TooLargeError:
            tally["too large"] += 1
            continue
        good, kind = True, "found" if E else "none"
        if E:
            x = E.element
            good = x in O and x.trace() ** 2 - 4 * x.norm() == d and is_optimal(O, x)
        elif not is_eichler and not none_locally(O, d):
            primes = factorise(int(O.discriminant()))
            good, kind = any(d % p ** (2 + 2 * (p == 2)) == 0 for p in primes), "none, coarse"
        if not good or (is_eichler and bool(E) != exists(D, N, d)):
            wrong += 1
            print("wrong:", D, N, d, O)
        tally[kind] += 1
    print(f"{sum(tally.values())} pairs: {tally}, {wrong} wrong")
    return int(bool(wrong))


def other_order(rng: Random, D: int, N: int) -> Any:
    """Return ZZ + n·O for an Eichler order O, perhaps with an element of O."""
    O, n = order(D, N), rng.choice([2, 3])
    more = [rng.choice(O.basis)] if rng.randrange(2) else []
    return O.algebra.order([*more, *(n * q for q in O.basis)])


def exists(D: int, N: int, d: int) -> bool:
    numbers = [local_number(d, p, 0) for p in factorise(D)] if D > 1 else []
    numbers += [local_number(d, p, e) for p, e in (factorise(N) if N > 1 else {}).items()]
    return all(numbers)


def is_optimal(O: Any, x: Any) -> bool:
    """No (x − m)/p lies in the order, for a prime p whose square divides the discriminant."""
    d = x.trace() ** 2 - 4 * x.norm()
    primes = [p for p, e in factorise(abs(int(d))).items() if e > 1]
    return not any((x - m) / p in O for p in primes for m in range(p))


def none_locally(O: Any, d: int) -> bool:
    """Whether at some prime of the discriminant no element of O modulo a power has this polynomial."""
    t = d % 2
    for p in factorise(int(O.discriminant())):
        k = 1
        while p ** (4 * k) <= 3_000_000 and k < 4:
            if not any(True for _ in local_solutions(O, d, t, p, k)):
                return True
            k += 1
    return False


def local_solutions(O: Any, d: int, t: int, p: int, k: int) -> Iterator[int]:
    """Yield residues modulo pᵏ of elements with trace t and norm (t − d)/4, primitive modulo ZZ."""
    import numpy as np

    q = p**k
    basis = O.basis
    traces = np.array([int(x.trace()) for x in basis])
    gram = np.array([[int((x * y.conjugate()).trace()) for y in basis] for x in basis])
    box = np.indices((q,) * 4).reshape(4, -1).T
    modulus = q * (2 if p == 2 else 1)
    one = np.array([int(c) for c in coordinates(O, O.algebra(1))])
    fits = (box @ traces - t) % q == 0
    box = box[fits]
    double = ((box @ gram) * box).sum(axis=1)
    box = box[(double - 2 * ((t - d) // 4)) % modulus == 0]
    minors = [(box[:, m] * one[n] - box[:, n] * one[m]) % p for m in range(4) for n in range(m)]
    yield from np.flatnonzero(np.any(minors, axis=0)).tolist()


def coordinates(O: Any, x: Any) -> list[Any]:
    from flint import fmpq_mat

    rows = O.value.ambient.rows(list(O.basis))
    found: fmpq_mat = O.value.ambient.row(x) * rows.inv()
    return [c.p for c in found.entries()]


def in_pieces(what: Any, args: argparse.Namespace) -> int:
    """Try all pairs that the file does not have, for so many seconds; report on the whole file."""
    done: dict[str, Any] = {}
    if args.file and args.file.exists():
        lines = args.file.read_text(encoding="utf-8").splitlines()
        done = {data["pair"]: data for data in map(json.loads, lines)}
    end = time.monotonic() + args.seconds
    every = [(D, N) for D, N in pairs(args.most, args.least) if D > 1 or what is counts]
    for D, N in every:
        if str([D, N]) in done:
            continue
        if time.monotonic() > end:
            break
        start = time.process_time()
        data = {"pair": str([D, N]), **what(D, N)}
        data["seconds"] = round(time.process_time() - start, 2)
        done[data["pair"]] = data
        if args.file:
            with args.file.open("a", encoding="utf-8") as file:
                file.write(json.dumps(data) + "\n")
    compared = sum(data["compared"] for data in done.values())
    wrong = {pair: data["wrong"] for pair, data in done.items() if data["wrong"]}
    print(f"{len(done)} pairs, {compared} numbers compared, {len(wrong)} pairs differ")
    print(*wrong.items(), sep="\n")
    return int(bool(wrong))


def main() -> int:
    """Run and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("what", choices=("counts", "quotients", "table", "random"))
    parser.add_argument("--most", type=int, default=200, help="the greatest D·N")
    parser.add_argument("--least", type=int, default=1, help="the least D·N")
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument(
        "--file", type=Path, help="results, one a line; those in it are not repeated"
    )
    parser.add_argument("--names", type=Path, help="names of quotients, one a line")
    parser.add_argument("--count", type=int, default=10_000)
    args = parser.parse_args()
    if args.what == "table":
        return table(args.names)
    if args.what == "random":
        return random_orders(args.count, args.seconds)
    return in_pieces(counts if args.what == "counts" else quotients, args)


if __name__ == "__main__":
    sys.exit(main())
