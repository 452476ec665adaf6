"""Fractional ideals of a number field, by their Hermite forms in the integral basis."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Protocol, overload

from hfield.checker.budget import spend
from hfield.checker.number_fields.integers import Prime, RingOfIntegers
from hfield.checker.number_fields.matrices import (
    Key,
    KeyOf,
    N,
    RowOf,
    diagonal_product,
    hermite,
    ratio,
    reduced,
    times,
)
from hfield.checker.scalars.finite_field_polynomials import FiniteFieldPolynomial, RationalFunction


class Integers(Protocol[N]):
    """A ring of integers by a basis: of a number field, or the polynomials as a basis of themselves."""

    n: int
    zero: N
    one: RowOf[N]
    table: list[list[RowOf[N]]]

    def mul(self, x: Sequence[N], y: Sequence[N], /) -> RowOf[N]:
        """Return a product."""

    def matrix(self, x: Sequence[N], /) -> list[RowOf[N]]:
        """Return the matrix that takes a row y to x·y."""

    def norm(self, x: Sequence[N], /) -> N:
        """Return the norm down to ℚ; over polynomials the number itself."""


def ideal(integers: Integers[N], den: N, rows: Iterable[Sequence[N]]) -> KeyOf[N]:
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


@overload
def index(a: Key) -> Fraction: ...
@overload
def index(a: KeyOf[FiniteFieldPolynomial]) -> RationalFunction: ...
def index(a: KeyOf[N]) -> Fraction | RationalFunction:
    """Return the norm of an ideal down to ℚ; over polynomials its generator."""
    den, rows = a
    return ratio(diagonal_product(rows), den ** len(rows))
