"""Fractional ideals of the integers of a number field, as lattices in Hermite normal form.

H. Cohen, *A Course in Computational Algebraic Number Theory*, section 4.7. An ideal is an integer matrix over
a denominator, in lowest terms: rows are coordinates in the integral basis. That is unique, so ideals are
equal where matrices are. Inverses and intersections go by duals in the trace form.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import product
from operator import index
from typing import TYPE_CHECKING

import flint

from hfield.core.factorisation import factorise
from hfield.errors import HFieldError, RingError, shorten
from hfield.fields.number_fields.elements import FieldElement, coefficients
from hfield.fields.number_fields.integers import multiplication_tables
from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.prime_ideals import PrimeIdeal, primes_above
from hfield.fields.number_fields.ring import NumberField
from hfield.syntax.brackets import is_balanced, split

if TYPE_CHECKING:
    from hfield.fields.number_fields.classes.class_groups import Principality


class MaximalOrder:
    """The ring of integers of a number field, for the arithmetic of ideals."""

    def __init__(self, field: NumberField) -> None:
        self.field = field
        self.n = n = field.degree
        self.basis = field.integral_basis()
        rows = flint.fmpq_mat(n, n, [c for w in self.basis for c in coefficients(w)])
        self.tables = multiplication_tables(field, rows)
        traces = [(v * w).trace() for v in self.basis for w in self.basis]
        self.trace_form = flint.fmpq_mat(n, n, traces)

    def prime_ideal(self, x: object) -> PrimeIdeal:
        """Return a prime ideal of the field unchanged. Raises :class:`RingError` for anything else."""
        if isinstance(x, PrimeIdeal) and x.field == self.field:
            return x
        raise RingError(
            f"{shorten(x)} is not a prime ideal of {shorten(self.field.name)}; see primes_above(p) of the "
            "field"
        )

    def ideal(self, rows: flint.fmpq_mat) -> FractionalIdeal:
        """Return the ideal that rows of coordinates span over ℤ."""
        whole, den = rows.numer_denom()
        n = self.n
        entries = whole.hnf().entries()[: n * n]
        if not entries[n * n - 1]:
            raise RingError(
                f"expected a nonzero ideal of the integers of {shorten(self.field.name)}; give a nonzero "
                "generator"
            )
        common = math.gcd(int(den), *map(int, entries))
        matrix = flint.fmpz_mat(n, n, [c // common for c in entries])
        return FractionalIdeal(self, matrix, int(den) // common)

    def principal(self, x: FieldElement) -> FractionalIdeal:
        """Return the ideal of one element, not 0."""
        return self.ideal(coordinate_rows(self.field, [x * w for w in self.basis]))

    def prime(self, prime: PrimeIdeal) -> FractionalIdeal:
        """Return a prime ideal as a lattice."""
        # the root s may have a denominator prime to p
        scale = int(coordinate_rows(self.field, [prime.pi]).numer_denom()[1])
        pair = self.field(prime.p), prime.pi * scale
        return self.ideal(coordinate_rows(self.field, [x * w for x in pair for w in self.basis]))

    @cached_property
    def codifferent(self) -> FractionalIdeal:
        """The x with tr(x·y) in ℤ for all integers y."""
        return self.ideal(self.trace_form.inv())

    @cached_property
    def one(self) -> FractionalIdeal:
        """The ideal of all integers."""
        return self.principal(self.field.one)


@lru_cache(maxsize=256)
def integers(field: NumberField) -> MaximalOrder:
    """Return the integers of a field."""
    return MaximalOrder(field)


def ideal(ring: NumberField, *generators: object) -> FractionalIdeal:
    """Return the fractional ideal that some elements, prime ideals and ideals generate, or that a text names.

    Raises :class:`RingError` for the zero ideal, :class:`CoercionError` for what is not of the field.
    """
    frame = integers(ring)
    things: Sequence[object] = generators
    if len(things) == 1:
        (one,) = things
        if isinstance(one, FractionalIdeal) and one.ring == ring:
            return one
        if isinstance(one, str):
            things = _generators(one)
        elif isinstance(one, Iterable) and not isinstance(one, FractionalIdeal):
            things = list(one)
    rows: list[flint.fmpq] = []
    for x in things:
        rows += _rows(frame, x)
    n = frame.n
    return (
        frame.ideal(flint.fmpq_mat(len(rows) // n, n, rows))
        if rows
        else frame.ideal(flint.fmpq_mat(n, n))
    )


def _generators(text: str) -> list[str]:
    """Return the texts of the generators in "ideal(a, b)", "(a, b)", as primes are written, or "a, b"."""
    m = re.fullmatch(r"\s*ideal\((.*)\)\s*", text) or re.fullmatch(r"\s*\((.*,.*)\)\s*", text)
    inside = m[1] if m and is_balanced(m[1]) else text
    return [part for part in split(inside, ",") if part.strip()]


def _rows(frame: MaximalOrder, x: object) -> list[flint.fmpq]:
    """Return the coordinates of a basis of the ideal of one generator or ideal; nothing for 0."""
    if isinstance(x, FractionalIdeal):
        if x.ring != frame.field:
            raise RingError(
                f"{shorten(x)} is an ideal of {shorten(x.ring.name)}, not of {shorten(frame.field.name)}"
            )
        return x.rows.entries()  # type: ignore[no-any-return]
    if isinstance(x, PrimeIdeal):
        return frame.prime(frame.prime_ideal(x)).rows.entries()  # type: ignore[no-any-return]
    y = frame.field(x)
    products = [y * w for w in frame.basis]
    return coordinate_rows(frame.field, products).entries() if y else []


class FractionalIdeal:
    """A nonzero fractional ideal of the integers of a number field: ``K.ideal(gens)``.

    ``basis`` is a basis over ℤ, ``matrix`` over ``denominator`` its coordinates in ``K.integral_basis()``, in
    Hermite normal form. Numbers, elements and prime ideals multiply and add as the ideals that they generate.

    >>> from hfield import ring
    >>> K = ring("QQ(sqrt(-5))"); a = K.ideal([2, 1 + K.gen])
    >>> a, a * a, a**-1, a.norm(), a.factorisation()
    (ideal(2, 1+sqrt(-5)), ideal(2), ideal(1, 1/2+1/2*sqrt(-5)), 2, (((2, 1+sqrt(-5)), 1),))
    >>> 1 + K.gen in a, 1 in a, a + 3 == K.ideal(1), a & 3 == 3 * a
    (True, False, True, True)
    """

    __slots__ = ("__dict__", "denominator", "frame", "matrix")

    def __init__(self, frame: MaximalOrder, matrix: flint.fmpz_mat, denominator: int) -> None:
        self.frame, self.matrix, self.denominator = frame, matrix, denominator

    @property
    def ring(self) -> NumberField:
        """The field."""
        return self.frame.field

    @cached_property
    def rows(self) -> flint.fmpq_mat:
        """The coordinates of a basis in the integral basis."""
        return flint.fmpq_mat(self.matrix) * flint.fmpq(1, self.denominator)

    @cached_property
    def basis(self) -> tuple[FieldElement, ...]:
        """A basis over ℤ, of elements of the field."""
        return tuple(element_of(self.frame.field, row) for row in self.rows.tolist())

    def __reduce__(self) -> tuple[object, ...]:
        return ideal, (self.ring, list(self.basis))

    # --- arithmetic --------------------------------------------------------------------------------

    def _other(self, x: object) -> FractionalIdeal | None:
        if isinstance(x, FractionalIdeal):
            return x if x.ring == self.ring else None
        if isinstance(x, str):
            return None
        try:
            return ideal(self.ring, [x])
        except HFieldError:
            return None

    def __mul__(self, other: object) -> FractionalIdeal:
        b = self._other(other)
        if b is None:
            return NotImplemented
        n, tables = self.frame.n, self.frame.tables
        entries: list[flint.fmpz] = []
        for row in self.matrix.tolist():
            action = flint.fmpz_mat(n, n)
            for c, table in zip(row, tables, strict=True):
                if c:
                    action += table * c
            entries += (b.matrix * action).entries()
        products = flint.fmpq_mat(flint.fmpz_mat(n * n, n, entries))
        return self.frame.ideal(products * flint.fmpq(1, self.denominator * b.denominator))

    __rmul__ = __mul__

    def __add__(self, other: object) -> FractionalIdeal:
        b = self._other(other)
        if b is None:
            return NotImplemented
        n = self.frame.n
        both = [*self.rows.entries(), *b.rows.entries()]
        return self.frame.ideal(flint.fmpq_mat(2 * n, n, both))

    __radd__ = __add__

    def __and__(self, other: object) -> FractionalIdeal:
        b = self._other(other)
        return NotImplemented if b is None else (self._dual() + b._dual())._dual()

    __rand__ = __and__

    def _dual(self) -> FractionalIdeal:
        """Return the x with tr(x·y) in ℤ for all y of the ideal."""
        return self.frame.ideal((self.rows * self.frame.trace_form).inv().transpose())

    def inverse(self) -> FractionalIdeal:
        """Return the x with x·a integral: the dual of the product with the codifferent."""
        return (self * self.frame.codifferent)._dual()

    def __truediv__(self, other: object) -> FractionalIdeal:
        b = self._other(other)
        return NotImplemented if b is None else self * b.inverse()

    def __rtruediv__(self, other: object) -> FractionalIdeal:
        b = self._other(other)
        return NotImplemented if b is None else b * self.inverse()

    def __pow__(self, exponent: int) -> FractionalIdeal:
        try:
            exponent = index(exponent)
        except TypeError:
            return NotImplemented
        base, n = (self.inverse(), -exponent) if exponent < 0 else (self, exponent)
        result = self.frame.one
        while n:
            if n & 1:
                result = result * base
            n >>= 1
            base = base * base if n else base
        return result

    # --- what it is --------------------------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        b = self._other(other)
        if b is None:
            return NotImplemented
        return self.denominator == b.denominator and bool(self.matrix == b.matrix)

    def __hash__(self) -> int:
        return hash((self.ring, self.denominator, tuple(map(int, self.matrix.entries()))))

    def __contains__(self, x: object) -> bool:
        row = coordinate_rows(self.frame.field, [self.frame.field(x)])
        return all(c.q == 1 for c in (row * self.rows.inv()).entries())

    def contains(self, other: object) -> bool:
        """Return whether an ideal lies in this one: whether this one divides it."""
        b = ideal(self.ring, other)
        return all(c.q == 1 for c in (b.rows * self.rows.inv()).entries())

    def is_integral(self) -> bool:
        """Return whether all elements are integers of the field."""
        return self.denominator == 1

    def norm(self) -> int | Fraction:
        """Return the absolute norm, positive: the number of residues, for an integral ideal."""
        size = Fraction(int(self.matrix.det()), self.denominator**self.frame.n)
        return size.numerator if size.denominator == 1 else size

    def valuation(self, prime: object) -> int:
        """Return the exponent of a prime ideal in this ideal. Raises :class:`RingError` if it is not
        prime.
        """
        P = self.frame.prime_ideal(prime)
        return int(min(P.valuation(x) for x in self.basis))

    def factorisation(self) -> tuple[tuple[PrimeIdeal, int], ...]:
        """Return pairs (prime ideal, exponent ≠ 0), ascending by the primes below; the norm is factored.

        Raises :class:`UnfactoredError`.
        """
        above = factorise(int(self.matrix.det())) if abs(self.matrix.det()) != 1 else {}
        below = factorise(self.denominator) if self.denominator != 1 else {}
        out = []
        for p in sorted({*above, *below}):
            for prime in primes_above(self.frame.field, p):
                e = min(prime.valuation(x) for x in self.basis)
                if e:
                    out.append((prime, e))
        return tuple(out)

    @cached_property
    def generators(self) -> tuple[FieldElement, ...]:
        """One or two elements that generate the ideal, the first of them rational."""
        least = flint.fmpq(self.least_integer, self.denominator)
        first = self.frame.field.one * least
        found = [first]
        if self.frame.principal(first) != self:
            found.append(self._second(first))
        return tuple(found)

    @property
    def least_integer(self) -> int:
        """The least positive integer in ``denominator`` times the ideal."""
        row = coordinate_rows(self.frame.field, [self.frame.field.one])
        inverse = flint.fmpq_mat(self.matrix).inv()
        return math.lcm(*(int(c.q) for c in (row * inverse).entries()))

    def _second(self, first: FieldElement) -> FieldElement:
        """Return an element that generates the ideal together with a given one, among small combinations."""
        start = self.frame.principal(first)
        for bound in range(1, 50):
            digits = sorted(range(-bound, bound + 1), key=lambda k: (abs(k), k < 0))
            for c in product(digits, repeat=self.frame.n):
                if max(map(abs, c)) != bound or next(k for k in c if k) < 0:
                    continue
                x = sum((w * k for w, k in zip(self.basis, c, strict=True)), self.frame.field.zero)
                if start + self.frame.principal(x) == self:
                    return x
        raise RingError(f"no two small generators were found for an ideal of norm {self.norm()}")

    def is_principal(self) -> Principality:
        """Return an answer, true or false, with ``generator`` (None if false) and ``evidence``.

        Raises :class:`TooLargeError` where the class group of the field is out of reach.
        """
        from hfield.fields.number_fields.classes.class_groups import is_principal

        return is_principal(self)

    def __str__(self) -> str:
        return f"ideal({', '.join(map(self.ring.text, self.generators))})"

    __repr__ = __str__
