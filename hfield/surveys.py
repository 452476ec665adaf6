"""Compute tables of class sets, or of groups of units, over ranges of algebras, row by row.

Rows are appended to a journal as they come, whole pieces at a time, and only what is missing in it is
computed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass
from math import gcd
from typing import Any

from hfield.algebra import QuaternionAlgebra
from hfield.core.executors import unordered
from hfield.core.factorisation import factorise
from hfield.core.journal import Row
from hfield.errors import HFieldError
from hfield.fields.names import ring
from hfield.orders import mass_formula

Pair = tuple[Any, Any]
PIECE = 8
"""Pairs that are computed at one place, one after the other."""


@dataclass(frozen=True)
class Survey:
    """The row of one pair; ``names`` are the keys that identify the pair."""

    row: Callable[[Pair, int], Row]
    names: tuple[str, str]


def definite_pairs(discriminants: Iterable[int], levels: Iterable[int]) -> list[Pair]:
    """Return the pairs (D, N) of a definite algebra and a level prime to its discriminant."""
    return _pairs(discriminants, levels, 1)


def indefinite_pairs(discriminants: Iterable[int], levels: Iterable[int]) -> list[Pair]:
    """Return the pairs (D, N) of an indefinite algebra and a level prime to its discriminant."""
    return _pairs(discriminants, levels, 0)


def _pairs(discriminants: Iterable[int], levels: Iterable[int], parity: int) -> list[Pair]:
    wanted = list(levels)
    found: list[Pair] = []
    for d in discriminants:
        primes = factorise(d) if d > 1 else {}
        if len(primes) % 2 == parity and max(primes.values(), default=1) == 1:
            found += [(d, n) for n in wanted if gcd(d, n) == 1]
    return found


def field_pairs(fields: Iterable[str], norms: Iterable[int]) -> list[Pair]:
    """Return the pairs of a field and a level, an ideal with one of these norms, prime to the discriminant.

    The algebra is ramified at the real places, and for an odd number of them at a prime over 2 of least norm.
    """
    wanted, found = list(norms), []
    for name in fields:
        K: Any = ring(name)
        D: Any = _definite(name).maximal_order().discriminant()
        for n in wanted:
            levels = [K.ideal(1)]
            for p, e in factorise(n).items() if n > 1 else ():
                levels = [a * b for a in levels for b in _of_prime_power(K, p, e)]
            whole = [N for N in levels if (N + D).norm() == 1]
            found += [(K.name, ", ".join(map(K.text, N.generators))) for N in whole]
    return found


def _of_prime_power(K: Any, p: int, e: int) -> list[Any]:
    """Return the ideals of norm pᵉ."""
    found = [(K.ideal(1), 0)]
    for P in K.primes_above(p):
        powers = range(e // P.f + 1)
        found = [(a * K.ideal(P) ** k, s + k * P.f) for a, s in found for k in powers]
    return [a for a, s in found if s == e]


def _definite(name: str) -> QuaternionAlgebra:
    K: Any = ring(name)
    places = list(K.real_places())
    if len(places) < K.degree:
        raise HFieldError(f"{name} is not totally real: over it no algebra is totally definite")
    if len(places) % 2:
        places.append(min(K.primes_above(2), key=lambda P: P.norm()))
    return QuaternionAlgebra.from_ramification(K, places)


def field_row(pair: Pair, most: int) -> Row:
    """Return the classes of an order over the integers of a field, unless their mass is above ``most``."""
    name, text = pair
    A: Any = _definite(name)
    order = A.eichler_order(A.ring.ideal([A.ring(word) for word in text.split(", ")]))
    found: Row = {
        "field": name,
        "level": text,
        "norm": int(order.level.norm()),
        "algebra": A.name,
        "mass": str(order.mass()),
        "class_number": None,
        "type_number": None,
        "stable_classes": order.stable_class_number(),
        "hermite": order.is_hermite(),
        "cancellation": None,
        "units": None,
    }
    if order.mass() <= most:
        C = order.class_set()
        found["class_number"], found["type_number"] = len(C), C.type_number
        found["cancellation"] = C.has_cancellation()
        found["units"] = {str(u): m for u, m in sorted(Counter(C.units).items())}
    return found


def group_row(pair: Pair, most: int) -> Row:
    """Return the group of units of norm 1 of an Eichler order over ℤ; its domain for areas up to 2π·most."""
    d, n = pair
    A = QuaternionAlgebra.from_ramification("QQ", sorted(factorise(d)) if d > 1 else [])
    G: Any = A.eichler_order(n).norm_one_group()
    genus, orders, cusps = G.signature
    found: Row = {
        "discriminant": d,
        "level": n,
        "algebra": A.name,
        "area": str(G.area),
        "genus": genus,
        "orders": list(orders),
        "cusps": cusps,
        "sides": None,
        "generators": None,
        "relations": None,
        "systole": None,
    }
    if G.area <= most:
        found["sides"], found["systole"] = len(G.domain().sides), G.systole
        found["generators"] = [q.text() for q in G.generators]
        found["relations"] = [list(word) for word in G.relations]
    return found


def row(pair: Pair, most: int) -> Row:
    """Return the invariants of the classes of (D, N); at most ``most`` classes are enumerated."""
    d, n = pair
    A = QuaternionAlgebra.from_ramification("QQ", sorted(factorise(d)))
    number = mass_formula.class_number(d, n)
    mass = mass_formula.eichler_mass(d, n)
    found: Row = {
        "discriminant": d,
        "level": n,
        "algebra": A.name,
        "class_number": number,
        "mass": str(mass),
        "type_number": None,
        "units": None,
    }
    if number <= most:
        C = A.eichler_order(n).class_set()
        if len(C) != number:
            raise AssertionError(
                f"{len(C)} classes were enumerated for {pair}, the formula says {number}"
            )
        found["type_number"] = C.type_number
        found["units"] = {str(u): m for u, m in sorted(Counter(C.unit_counts).items())}
    return found


CLASSES = Survey(row, ("discriminant", "level"))
FIELDS = Survey(field_row, ("field", "level"))
GROUPS = Survey(group_row, ("discriminant", "level"))


def rows(task: tuple[Survey, list[Pair], int]) -> list[Row]:
    """Return the rows of a piece."""
    survey, pairs, most = task
    return [survey.row(pair, most) for pair in pairs]


def run(
    executor: Executor, pairs: list[Pair], most: int, done: set[Pair], survey: Survey = CLASSES
) -> Iterator[list[Row]]:
    """Yield the rows of the pairs that are not done, a piece at a time, as they are finished."""
    missing = [pair for pair in pairs if pair not in done]
    pieces = [(survey, missing[n : n + PIECE], most) for n in range(0, len(missing), PIECE)]
    for _, found in unordered(executor, rows, pieces):
        yield found
