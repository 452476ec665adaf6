"""Lattices of full rank in an algebra: integer rows over a denominator, and their Hermite form.

The numbers are integers, or polynomials over GF(q) (:mod:`hfield.checker.orders.polynomial_lattices`).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Generic, Self

from hfield.checker.budget import spend
from hfield.checker.number_fields.ideals import ideal
from hfield.checker.number_fields.matrices import (
    KeyOf,
    N,
    Quotient,
    Row,
    RowOf,
    Rows,
    RowsOf,
    diagonal_product,
    gcd,
    hermite,
    inverse,
    is_one,
    longest,
    normal,
    ratio,
    reduced,
    times,
    transposed,
)
from hfield.checker.orders.algebra import Algebra, AlgebraOf
from hfield.checker.rejection import reject


@dataclass(frozen=True)
class ElementOf(Generic[N]):
    """A row over a denominator."""

    den: N
    row: RowOf[N]


class LatticeElement(ElementOf[int]):
    """A row of integers over a denominator."""


@dataclass(frozen=True)
class LatticeOf(Generic[N]):
    """The integer combinations of independent ``rows`` over ``den``; any basis."""

    algebra: AlgebraOf[N]
    den: N
    rows: RowsOf[N]

    @cached_property
    def bits(self) -> int:
        """The bit length of the longest number in the lattice, plus that of the algebra."""
        return longest([(self.den,), *self.rows]) + self.algebra.bits

    def pay(self, matrices: int, bits: int = 0) -> None:
        """Spend the cost of so many products of square matrices, with numbers longer by ``bits``."""
        count, bits = matrices * self.algebra.size**3, self.bits + bits
        spend(count // 4 + count * bits * bits // 2_000_000)

    @cached_property
    def key(self) -> KeyOf[N]:
        """The least denominator and the Hermite form: equal exactly for equal lattices."""
        return reduced(self.den, hermite(self.rows))

    @cached_property
    def gram(self) -> list[RowsOf[N]]:
        """The matrices of tr(x·conj(y)) on the rows, place by place, :attr:`unit` times too large."""
        self.pay(2 * self.algebra.n)
        columns = transposed(self.rows)
        return [tuple(times(times(self.rows, form), columns)) for form in self.algebra.forms]

    @property
    def unit(self) -> N:
        """The factor by which :attr:`gram` is too large."""
        return self.algebra.scale * self.den * self.den

    @cached_property
    def volume(self) -> Quotient[N]:
        """The determinant of the rows, without its sign; over polynomials made monic."""
        den, rows = self.key
        spend(self.algebra.size * self.bits**2 // 40_000)
        return ratio(diagonal_product(rows), den**self.algebra.size)

    @cached_property
    def discriminant(self) -> N:
        """The norm down to ℚ of the reduced discriminant of an order; over polynomials its generator."""
        found = self.algebra.volume * self.volume
        if not is_one(found.denominator):
            reject("this order has no integral discriminant")
        return found.numerator

    @property
    def norms(self) -> list[RowOf[N]]:
        """The norms of the rows, :attr:`unit` times too large."""
        return [tuple([g[m][m] // 2 for g in self.gram]) for m in range(self.algebra.size)]

    @cached_property
    def norm(self) -> KeyOf[N]:
        """The ideal of the field that the norms of all elements generate, by those of sums."""
        self.pay(1)
        traces = [
            tuple([g[m][n] for g in self.gram]) for n in range(self.algebra.size) for m in range(n)
        ]
        return ideal(self.algebra.integers, self.unit, self.norms + traces)

    def holds(self, den: N, rows: Iterable[Sequence[N]]) -> bool:
        """Return whether all rows, divided by ``den``, lie in the lattice."""
        own = self.key[0]
        common = gcd(own, den)
        up, down = own // common, den // common
        for row in rows:
            rest = [x * up for x in row]
            if down != 1:
                if any(x % down for x in rest):
                    return False
                rest = [x // down for x in rest]
            for n, (pivot, others) in enumerate(self._steps):
                c, r = divmod(rest[n], pivot)
                if r:
                    return False
                if c:
                    for m, y in others:
                        rest[m] -= c * y
        return True

    @cached_property
    def _steps(self) -> list[tuple[N, list[tuple[int, N]]]]:
        """The pivots of the Hermite form, and the nonzero entries that follow each in its row."""
        return [
            (row[n], [(m, y) for m, y in enumerate(row) if y and m > n])
            for n, row in enumerate(self.key[1])
        ]

    def times(self, x: ElementOf[N], side: str) -> Self:
        """Return L·x for the ``right`` side, x·L for the left."""
        self.pay(2, longest([x.row]))
        multiply = self.algebra.right if side == "right" else self.algebra.left
        rows = tuple(times(self.rows, multiply(x.row)))
        return replace(self, den=self.den * x.den * self.algebra.scale, rows=rows)

    def products_lie_in(self, other: Self, inside: Self) -> bool:
        """Return whether all products of an element of this lattice and one of the other lie in a third."""
        self.pay(3 * self.algebra.size, other.bits + inside.bits)
        den = self.den * other.den * self.algebra.scale
        return all(
            inside.holds(den, times(self.rows, self.algebra.right(row))) for row in other.rows
        )

    def into(self, other: Self, side: str) -> Self:
        """Return {x: L·x ⊆ M} for the ``left`` side, {x: x·L ⊆ M} for the right, M being ``other``."""
        self.pay(2 * self.algebra.size, 4 * other.bits)
        # x is in it exactly where x·c is an integer for the columns c of these matrices
        multiply = self.algebra.left if side == "left" else self.algebra.right
        back, det = inverse(other.rows)
        columns: list[RowOf[N]] = []
        for row in self.rows:
            columns += transposed(times(multiply(row), back))
        found, d = inverse(transposed(hermite(columns)))
        top, below = self.den * self.algebra.scale * normal(det), other.den * normal(d)
        g = gcd(below, top)
        up, down = top // g, below // g
        return replace(self, den=down, rows=tuple(tuple(x * up for x in row) for row in found))

    @property
    def conjugate(self) -> Self:
        """The lattice of all conjugates."""
        self.pay(1)
        rows = tuple(map(self.algebra.conjugate, self.rows))
        return replace(self, den=self.den * self.algebra.scale, rows=rows)


class Lattice(LatticeOf[int]):
    """The combinations of ``rows`` over ``den`` in an algebra over ℚ or a number field."""

    algebra: Algebra
    volume: Fraction

    def form(self, weights: Sequence[int]) -> Rows:
        """Return the matrix of a combination of the forms of :attr:`gram`."""
        if tuple(weights) == (1,):
            return self.gram[0]
        self.pay(1)
        size = range(self.algebra.size)
        return tuple(
            tuple([sum(w * g[m][k] for w, g in zip(weights, self.gram, strict=True)) for k in size])
            for m in size
        )

    def norm_of(self, x: Row) -> Row:
        """Return 2·``unit`` times the norm of the element with these coordinates in the rows."""
        values = (sum(c * d for c, d in zip(times([x], g)[0], x, strict=True)) for g in self.gram)
        return tuple(values)
