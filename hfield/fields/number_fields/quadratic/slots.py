"""Common slots over quadratic fields: an e for which every (x, e) ramifies at given places and nowhere else.

Isomorphic algebras (a, b) and (p, q) have one: (a, b) = (a, e) = (p, e) = (p, q). It is built as a zero of a
quadratic form in four variables is in the theorem of Hasse and Minkowski (Serre, *A Course in
Arithmetic*, chapter IV, §3): at each odd prime that divides an x or is to ramify a class is picked, and
numbers in these classes are tried until, apart from these primes, only one prime ideal divides them. At that
one and at a lone place above 2 the symbols are right or wrong together, by the product formula.

Inside, numbers are pairs (s, t) of integers, s + t√d.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Callable, Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from hfield.errors import UndecidedError
from hfield.factorisation import factorise, remove
from hfield.fields.number_fields.quadratic.places import QuadraticPlace, places_above
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.quadratic.symbols import (
    direct_symbol,
    integral,
    is_dyadic,
    pair,
    ramified_places_quadratic,
)
from hfield.primality import is_prime
from hfield.product import Constants
from hfield.rings.whole_numbers import crt

if TYPE_CHECKING:
    from hfield.rings.closed_fields.surds import Surd


TRIALS = 50_000
LOCAL_TRIALS = 300
Whole = tuple[int, int]


def common_slot(
    field: QuadraticField, c: Constants, numbers: Sequence[Surd]
) -> tuple[Surd, list[int]]:
    """Return an e with (x, e) isomorphic to the algebra (a, b), for each of the numbers x.

    Along with it 2 and the primes that divide the norms of a, b, e and the numbers, for what follows. Raises
    :class:`UndecidedError` where these are too hard to factor, or where no e was found, because
    there is none or by bad luck.
    """
    d = field.d
    a, b, *others = (integral(pair(field, x)) for x in (c.a, c.b, *numbers))
    primes = {2}
    at_numbers: set[int] = set()
    for x in (a, b, *others):
        found = factorise(_norm(d, x), primes)
        primes.update(found)
        if x in others:
            at_numbers.update(found)
    ramified = ramified_places_quadratic(field, pair(field, c.a), pair(field, c.b), primes)
    relevant = at_numbers.union(v.prime for v in ramified) - {0, 2}
    e, new = _slot(field, others, ramified, sorted(relevant))
    return field(e[0]) + field.gen * e[1], sorted(primes.union(new))


def _norm(d: int, x: Whole) -> int:
    return x[0] * x[0] - d * x[1] * x[1]


def _slot(
    field: QuadraticField,
    numbers: list[Whole],
    ramified: Collection[QuadraticPlace],
    odd: list[int],
) -> tuple[Whole, list[int]]:
    """Return e and the prime of its norm that is neither 2 nor one of those given, if any."""
    d, rng = field.d, random.Random(1)

    def fits(v: QuadraticPlace, e: Whole) -> bool:
        sign = -1 if v in ramified else 1
        return is_dyadic(v) or all(direct_symbol(v, x, e) == sign for x in numbers)

    classes = [_local_class(field, p, fits, rng) for p in odd]
    for e in _lifts(d, classes, rng):
        if all(fits(v, e) for v in places_above(field, 0)):
            rest = abs(_norm(d, e))
            for p in (2, *odd):
                rest = remove(rest, p)[1]
            if rest == 1 or is_prime(rest):
                new = [rest] if rest > 1 else []
                if all(fits(v, e) for p in (2, *new) for v in places_above(field, p)):
                    return e, new
    raise UndecidedError(
        f"no common slot over QQ(sqrt({d})) was found among {TRIALS} numbers of fitting local classes"
    )


def _local_class(
    field: QuadraticField, p: int, fits: Callable[[QuadraticPlace, Whole], bool], rng: random.Random
) -> tuple[Whole, int]:
    """Return a number and a modulus: what is congruent to it has right symbols above the odd prime p."""
    d, above = field.d, places_above(field, p)
    for size in range(len(above) + 1):
        for chosen in itertools.combinations(above, size):
            base = (1, 0)
            for v in chosen:
                base = _product(d, base, _uniformiser(v))
            for _ in range(LOCAL_TRIALS):
                unit = rng.randrange(p), rng.randrange(p)
                if _norm(d, unit) % p:
                    e = _product(d, base, unit)
                    if all(fits(v, e) for v in above):
                        return e, p * p if chosen else p
    raise UndecidedError(f"no number was found that has the symbols asked for above {p}")


def _product(d: int, x: Whole, y: Whole) -> Whole:
    return x[0] * y[0] + d * x[1] * y[1], x[0] * y[1] + x[1] * y[0]


def _uniformiser(v: QuadraticPlace) -> Whole:
    """Return a number of valuation 1 at a place above an odd prime, and 0 at its conjugate."""
    p, d, r = v.prime, v.d, v.root
    if r is None:
        return (p, 0) if d % p else (0, 1)
    return (-r if (r * r - d) % (p * p) else p - r), 1


def _lifts(d: int, classes: list[tuple[Whole, int]], rng: random.Random) -> Iterator[Whole]:
    """Run through random numbers with the given classes, of growing size."""
    (s, modulus), (t, _) = (crt((e[i], m) for e, m in classes) for i in (0, 1))
    wide = math.isqrt(abs(d)) + 1
    for trial in range(TRIALS):
        box = 2 + trial // 1000
        (u, whole), (v, _) = (crt(((x, modulus), (rng.randrange(64), 64))) for x in (s, t))
        yield u + whole * rng.randint(-box * wide, box * wide), v + whole * rng.randint(-box, box)
