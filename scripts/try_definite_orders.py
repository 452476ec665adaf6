"""All definite Hermite orders over totally real fields of degree 1 to 6, with their classes and types.

    python scripts/try_definite_orders.py [--degrees 123456] [--processes 2]

In a Hermite order stably free right ideals are free. What contains a Hermite order is one: the search goes
from maximal orders down, at all primes where the mass, the number of stable classes over that of units,
allows one. The mass of a maximal order is at most the number of narrow classes, which bounds the
discriminant D of the algebra, and that of the field, as |ζ_K(−1)| > d^(3/2)/(2π²)ⁿ. Fields of degree 3 to 5
are those of polynomials with small coefficients, distinguished by PARI (cypari): they are all of the tables
of J. Voight (ANTS 2008, 268–281) that allow one, and so are those of degree 6, which are listed. Prints a
line for each order: discriminant of the field, norms of D and of the discriminant, classes, stable classes,
types, C for cancellation. Of each class set it is checked that its stable classes have one mass each and that
rows of a Brandt matrix have the right sums. Exit status 1 if that fails, or a count is not that of the
published orders and ours. All degrees take six minutes of one processor's time.
"""

import argparse
import math
import sys
import time
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction
from importlib.util import find_spec
from itertools import combinations, product
from pathlib import Path
from typing import Any, NamedTuple

sys.path.insert(0, str(Path(__file__).parents[1]))

from hfield import QuaternionAlgebra, ring
from hfield.core.primality import primes
from hfield.orders.invariants import good_primes

PUBLISHED = {1: (40, 39), 2: (209, 173), 3: (60, 59), 4: (59, 40), 5: (5, 5), 6: (2, 0)}
"""Hermite orders up to isomorphism over the base, and those with cancellation, by degree.

They are those of D. Smertnig and J. Voight, *Trans. London Math. Soc.* 6, 2019: 375 and 316.
"""
OURS = {2: (2, 2), 3: (3, 3), 4: (2, 0)}
"""Those that are not in their list.

Suborders of index P where the algebra ramifies, over ℚ(√2), N(P) = 7, and over the cubic field of
discriminant 49, N(P) = 13; a maximal order of discriminant 1 over ℚ(√3, √5), and the Eichler order of level
P, N(P) = 4, in it.
"""
SIZES = {3: (14, 14), 4: (64, 20), 5: (8, 8)}
"""The largest constant term, and the largest of the other coefficients below the first two."""
SEXTIC = """
    -1 -2 7 2 -7 -1; -1 -3 6 4 -5 -1; -1 -2 4 5 -4 -2; 1 -8 8 6 -6 -1; 1 -5 2 8 -4 -2; -1 -2 5 4 -5 -1;
    1 -9 2 11 -5 -2; 1 -5 4 7 -6 -1; 1 -5 0 9 -2 -3; -1 3 9 -4 -9 0; -1 -9 7 9 -7 -1; -1 0 8 4 -6 -1; -1
    -5 7 6 -6 -1; -7 0 14 0 -7 0; -1 2 7 -2 -6 0; -1 -3 4 6 -4 -2; -1 1 6 -2 -6 0; -8 0 24 0 -10 0; 1 7
    11 -2 -7 0; -3 0 9 0 -6 0; -1 -11 10 10 -6 -2; -1 0 6 -1 -6 0; -1 -12 12 7 -7 -1; 1 -4 -1 9 -2 -3; 1
    -6 3 10 -3 -3; 1 -9 6 9 -5 -2; -1 -3 3 7 -3 -3; -1 1 9 2 -6 -1; -1 1 11 -1 -7 0; -2 1 8 -1 -6 0; -13
    0 19 0 -8 0; -1 3 12 2 -7 -1; -5 -1 13 0 -7 0; -1 -1 8 0 -6 0; -11 -4 19 5 -8 -1; 2 10 12 -4 -8 0;
    -5 10 19 -13 -12 1
"""
"""Coefficients of polynomials, but the first, of the fields of degree 6 that allow one, from Voight's
tables."""


# --- fields and algebras ---------------------------------------------------------------------------


def mass_allows(d: int, n: int, signs: int) -> bool:
    """Tell whether the mass allows a Hermite order; h⁺ is h·2^signs."""
    return d**3 <= 4 ** (n - 1 + signs) * Fraction(20) ** (2 * n)  # 20 > 2π²


def fields(degree: int) -> list[str]:
    """Return names of totally real fields whose mass allows one, by discriminants ascending."""
    if degree == 1:
        return ["QQ"]
    if degree == 6:
        return [
            "QQ[s]/(s^6" + "".join(f"{int(c):+d}*s^{k}" for k, c in enumerate(part.split())) + ")"
            for part in SEXTIC.split(";")
        ]
    import cypari  # of the extra "oracles"

    if degree == 2:
        largest = next(d for d in range(2, 10_000) if not mass_allows(d, 2, 1))
        candidates: Iterator[str] = (f"x^2-x*{d % 4 % 2}-{d // 4}" for d in range(5, largest))
    else:
        first, size = SIZES[degree]
        middle = [range(-size, size + 1)] * (degree - 3)
        candidates = (
            f"x^{degree}-{t}*x^{degree - 1}" + "".join(f"{c:+d}*x^{k}" for k, c in enumerate(cs))
            for t in range(degree // 2 + 1)
            for cs in product(range(-first, first + 1), *middle, range(-size, 0))
            if cs[0]
        )
    found: dict[str, int] = {}
    for text in candidates:
        f = cypari.pari(text)
        if int(f.polsturm()) == degree and f.polisirreducible():
            d = int(f.nfdisc())
            if mass_allows(d, degree, degree - 1):
                found[str(f.polredabs()).replace("x", "s").replace(" ", "")] = d
    return [f"QQ[s]/({f})" for _, f in sorted((d, f) for f, d in found.items())]


def algebras(name: str) -> Iterator[list[Any]]:
    """Yield the finite places at which algebras ramify whose maximal orders may be Hermite."""
    K: Any = ring(name)
    if name == "QQ":
        n, left = 1, Fraction(12)
    else:
        n = K.degree
        h, narrow = K.class_group().order, K.narrow_class_group().order
        if not mass_allows(K.discriminant(), n, (narrow // h).bit_length() - 1):
            return
        left = Fraction(narrow * 2 ** (n - 1), h) / abs(K.zeta_minus_one())
    small = [P for P in places(K, int(left) + 1) if norm(P) - 1 <= left]
    for size in range(n % 2, len(small) + 1, 2):
        chosen = [c for c in combinations(small, size) if math.prod(norm(P) - 1 for P in c) <= left]
        if not chosen:
            break
        yield from map(list, chosen)


def places(K: Any, bound: int) -> list[Any]:
    """Return the primes of norm at most a bound."""
    small = primes(bound + 1)
    if K.name == "QQ":
        return list(small)
    return [P for p in small for P in K.primes_above(p) if norm(P) <= bound]


def norm(P: Any) -> int:
    """Return the number of residues at a prime."""
    return P if isinstance(P, int) else int(P.p**P.f)


def dimension(P: Any) -> int:
    """Return the dimension of local units modulo squares."""
    if isinstance(P, int):
        return 2 if P == 2 else 1
    return P.e * P.f + 1 if P.p == 2 else 1


# --- Hermite orders --------------------------------------------------------------------------------


def fits(O: Any, units: int, P: Any, k: int) -> bool:
    """Tell whether a suborder of index Pᵏ may be Hermite: units/units' is a ratio of masses over 2ʲ."""
    q = norm(P)
    factor = {None: 1, 1: 1 + Fraction(1, q), -1: 1 - Fraction(1, q), 0: 1 - Fraction(1, q * q)}
    before = factor[O.eichler_symbol(P)]
    return any(
        (units / (q**k * factor[t] / before / 2**j)).denominator == 1
        for t in (1, 0, -1)
        for j in range(dimension(P) + 1 if t == 0 else 1)
    )


def hermite_orders(name: str, ramified: list[Any]) -> list[Any]:
    """Return the Hermite orders of the definite algebra that ramifies at some primes, up to isomorphism."""
    K: Any = ring(name)
    real = [] if name == "QQ" else K.real_places()
    A = QuaternionAlgebra.from_ramification(K, [*real, *ramified])
    found: list[tuple[Any, int, Any]] = []

    def keep(O: Any) -> None:
        if O.is_hermite():
            units = O.unit_count() // 2 if name == "QQ" else O.unit_index()
            kind = str(O.discriminant()), units, str(O.conductor())
            if not any(kind == other and O.isomorphism(T) for T, _, other in found):
                found.append((O, units, kind))

    first = A.maximal_order()
    if (
        first.mass() / first.stable_class_number()
    ).numerator == 1:  # over units of one of its genus
        for O in first.class_set().left_orders():
            keep(O)
    small = places(K, 2 * max((units for _, units, _ in found), default=0) + 1)
    for O, units, _ in found:  # which grows
        for P in small:
            for k in (1, 2):
                if not fits(O, units, P, k):
                    continue
                if k == 1 and O.eichler_symbol(P) is None:
                    # all are Eichler, and if one is Hermite units of O conjugate them
                    keep(O & O.ideals_of_norm(P)[0].right_order())
                else:
                    for S in O.suborders(P, k):
                        keep(S)
    return [O for O, _, _ in found]


class Line(NamedTuple):
    """The printed facts about an order."""

    field: int
    algebra: int
    discriminant: int
    classes: int
    stable: int
    types: int
    cancellation: bool
    wrong: str


def describe(O: Any, ramified: list[Any]) -> Line:
    """Return the class set of an order in numbers, and which identities fail."""
    C, over_q, wrong = O.class_set(), isinstance(O.discriminant(), int), []
    units = C.units
    masses: Counter[int] = Counter()
    for kind, u in zip(C.stable_classes(), units, strict=True):
        masses[kind] += Fraction(1, u)  # type: ignore[assignment]
    if len(masses) != O.stable_class_number() or len(set(masses.values())) != 1:
        wrong.append("the stable classes do not have one mass each")
    if [C.stable_classes().count(0)] != [1]:
        wrong.append("the stable class of the order has other classes")
    base, P = O.value.ambient.base, next(good_primes(O.value))
    number = base.absolute_norm(base.prime_ideal(P)) + 1
    if any(sum(row.values()) != number for row in C.neighbours(P)):
        wrong.append("rows of a Brandt matrix have other sums")
    return Line(
        1 if over_q else int(O.algebra.ring.discriminant()),
        math.prod(map(norm, ramified)),
        O.discriminant() if over_q else O.norm_of_discriminant(),
        len(C),
        O.stable_class_number(),
        C.type_number,
        C.has_cancellation(),
        ", ".join(wrong),
    )


def of_field(name: str) -> list[Line]:
    """Return the lines of a field."""
    return [describe(O, D) for D in algebras(name) for O in hermite_orders(name, D)]


def main() -> int:
    """Run and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--degrees", default="123456")
    parser.add_argument("--processes", type=int, default=2)
    args = parser.parse_args()
    if set(args.degrees) & set("2345") and not find_spec("cypari"):
        parser.error("PARI tells fields of degree 2 to 5 apart: pip install '.[oracles]'")
    start, failures = time.monotonic(), 0
    with ProcessPoolExecutor(args.processes) as pool:
        for n in map(int, args.degrees):
            lines = [line for part in pool.map(of_field, fields(n)) for line in part]
            for line in lines:
                failures += bool(line.wrong)
                print(*line[:6], "C" * line.cancellation, line.wrong)
            found = len(lines), sum(line.cancellation for line in lines)
            published, ours = PUBLISHED[n], OURS.get(n, (0, 0))
            failures += found != (published[0] + ours[0], published[1] + ours[1])
            print(
                f"degree {n}: {found[0]} Hermite orders, {found[1]} with cancellation; published "
                f"{published[0]}, {published[1]}, ours {ours[0]}, {ours[1]}; "
                f"after {time.monotonic() - start:.0f} s",
                flush=True,
            )
    return int(failures > 0)


if __name__ == "__main__":
    sys.exit(main())
