"""Fractional ideals of a number field, by their Hermite forms in the integral basis."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import prod
from typing import Any

from hfield.checker.budget import spend
from hfield.checker.number_fields.integers import Prime, RingOfIntegers
from hfield.checker.number_fields.matrices import Key, hermite, ratio, reduced, times


def ideal(integers: RingOfIntegers, den: int, rows: Iterable[Sequence[int]]) -> Key:
    """Return the ideal that integers of the field over a denominator generate, in Hermite normal form."""
    own = [row for row in rows if any(row)]
    spend(len(own) * integers.n**3 // 4)
    return reduced(den, hermite([row for by in integers.table for row in times(own, by)]))


def times_number(integers: RingOfIntegers, x: Sequence[Fraction], other: Key) -> Key:
    """Return the product of a number and an ideal."""
    den, row = integers.coordinates(x)
    return ideal(integers, den * other[0], [integers.mul(row, y) for y in other[1]])


def times_primes(integers: RingOfIntegers, powers: Iterable[tuple[Prime, int]], other: Key) -> Key:
    """Return the product of prime ideals with an ideal."""
    for P, e in powers:
        spend(e)
        for _ in range(e):
            span = [*P.span, tuple(P.p * c for c in integers.one)]
            other = ideal(integers, other[0], [integers.mul(x, y) for x in span for y in other[1]])
    return other


def index(a: Key) -> Any:
    """Return the norm of an ideal down to ℚ; over polynomials its generator."""
    den, rows = a
    return ratio(prod(row[k] for k, row in enumerate(rows)), den ** len(rows))
