"""Compute tables of class sets, or of unit groups, over ranges of algebras, row by row.

Rows are appended to a journal in blocks as they are computed, and only rows missing from it are computed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence, Set
from concurrent.futures import Executor
from dataclasses import dataclass
from fractions import Fraction
from math import gcd
from typing import Generic, Protocol, Self, TypeVar, runtime_checkable

from hfield.algebra import QuaternionAlgebra
from hfield.core.executors import unordered
from hfield.core.factorisation import factorise
from hfield.core.journal import Row
from hfield.core.product import Scalar
from hfield.errors import HFieldError
from hfield.fields.names import ring
from hfield.orders import mass_formula

X = TypeVar("X", int, str)
Pair = tuple[X, X]
"""The discriminant and the level of an order, or the texts of a field and a level."""
PIECE = 8
"""Pairs that are computed at one place, one after the other."""


class IdealOfField(Protocol):
    """A fractional ideal of a number field."""

    @property
    def generators(self) -> Sequence[Scalar]:
        """Generators of the ideal."""

    def norm(self) -> Fraction | int:
        """Return the norm."""

    def __add__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...
    def __pow__(self, exponent: int, /) -> Self: ...


class PrimeOfField(Hashable, Protocol):
    """A prime ideal of a number field, with its residue degree."""

    f: int

    def norm(self) -> int:
        """Return the norm."""


@runtime_checkable
class FieldWithIdeals(Protocol):
    """A number field."""

    name: str

    @property
    def degree(self) -> int:
        """The degree over ℚ."""

    def ideal(self, *generators: object) -> IdealOfField:
        """Return the ideal that elements and ideals generate."""

    def primes_above(self, p: int) -> Sequence[PrimeOfField]:
        """Return the prime ideals above a prime number."""

    def real_places(self) -> Sequence[Hashable]:
        """Return the real places."""

    def text(self, x: Scalar) -> str:
        """Return the text of an element."""


@dataclass(frozen=True)
class Survey(Generic[X]):
    """The row of one pair; ``names`` are the keys that identify the pair."""

    row: Callable[[Pair[X], int], Row]
    names: tuple[str, str]


def definite_pairs(discriminants: Iterable[int], levels: Iterable[int]) -> list[Pair[int]]:
    """Return the pairs (D, N) of the discriminant of a definite algebra and a level prime to it."""
    return _pairs(discriminants, levels, 1)


def indefinite_pairs(discriminants: Iterable[int], levels: Iterable[int]) -> list[Pair[int]]:
    """Return the pairs (D, N) of the discriminant of an indefinite algebra and a level prime to it."""
    return _pairs(discriminants, levels, 0)


def _pairs(discriminants: Iterable[int], levels: Iterable[int], parity: int) -> list[Pair[int]]:
    wanted = list(levels)
    found: list[Pair[int]] = []
    for d in discriminants:
        primes = factorise(d) if d > 1 else {}
        if len(primes) % 2 == parity and max(primes.values(), default=1) == 1:
            found += [(d, n) for n in wanted if gcd(d, n) == 1]
    return found


def field_pairs(fields: Iterable[str], norms: Iterable[int]) -> list[Pair[str]]:
    """Return pairs (field, level): ideals with one of these norms, prime to the discriminant.

    The algebra is ramified at the real places; if their number is odd, also at a prime over 2 of least norm.
    """
    wanted, found = list(norms), []
    for name in fields:
        K = _number_field(name)
        D = K.ideal(_definite(name).maximal_order().discriminant())
        for n in wanted:
            levels = [K.ideal(1)]
            for p, e in factorise(n).items() if n > 1 else ():
                levels = [a * b for a in levels for b in _of_prime_power(K, p, e)]
            whole = [N for N in levels if (N + D).norm() == 1]
            found += [(K.name, ", ".join(map(K.text, N.generators))) for N in whole]
    return found


def _of_prime_power(K: FieldWithIdeals, p: int, e: int) -> list[IdealOfField]:
    """Return the ideals of norm pᵉ."""
    found = [(K.ideal(1), 0)]
    for P in K.primes_above(p):
        powers = range(e // P.f + 1)
        found = [(a * K.ideal(P) ** k, s + k * P.f) for a, s in found for k in powers]
    return [a for a, s in found if s == e]


def _number_field(name: str) -> FieldWithIdeals:
    found = ring(name)
    if not isinstance(found, FieldWithIdeals):
        raise HFieldError(f"{name} is not a number field: expected one such as QQ(sqrt(5))")
    return found


def _definite(name: str) -> QuaternionAlgebra:
    K = _number_field(name)
    places = list(K.real_places())
    if len(places) < K.degree:
        raise HFieldError(f"{name} is not totally real: over it no algebra is totally definite")
    if len(places) % 2:
        least: Hashable = min(K.primes_above(2), key=lambda P: P.norm())
        places.append(least)
    return QuaternionAlgebra.from_ramification(name, places)


def field_row(pair: Pair[str], most: int) -> Row:
    """Return the row of the classes of an order over the integers of a field; not if the mass exceeds
    ``most``.
    """
    name, text = pair
    A, K = _definite(name), _number_field(name)
    order = A.eichler_order(K.ideal([A.ring(word) for word in text.split(", ")]))
    found: Row = {
        "field": name,
        "level": text,
        "norm": int(K.ideal(order.level).norm()),
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


def group_row(pair: Pair[int], most: int) -> Row:
    """Return the unit group of norm 1 of an Eichler order over ℤ; with its domain for areas up to 2π·most."""
    d, n = pair
    A = QuaternionAlgebra.from_ramification("QQ", sorted(factorise(d)) if d > 1 else [])
    G = A.eichler_order(n).norm_one_group()
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


def row(pair: Pair[int], most: int) -> Row:
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


def rows(task: tuple[Survey[X], list[Pair[X]], int]) -> list[Row]:
    """Return the rows of a block of pairs."""
    survey, pairs, most = task
    return [survey.row(pair, most) for pair in pairs]


@dataclass(frozen=True)
class Plan(Generic[X]):
    """A survey, and the pairs for which it is to have rows."""

    survey: Survey[X]
    pairs: list[Pair[X]]

    def run(self, executor: Executor, most: int, done: Set[object]) -> Iterator[list[Row]]:
        """Yield the rows of the pairs that are not done, one block at a time, as they are finished."""
        missing = [pair for pair in self.pairs if pair not in done]
        pieces = [
            (self.survey, missing[n : n + PIECE], most) for n in range(0, len(missing), PIECE)
        ]
        for _, found in unordered(executor, rows, pieces):
            yield found
