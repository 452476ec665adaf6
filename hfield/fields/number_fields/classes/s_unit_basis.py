"""A basis of the proved S-units of a number field: fundamental units, and S-units with triangular exponents.

It serves to reduce ideals to products of primes in S, and to find generators of principal ideals.
"""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import flint

from hfield.errors import UndecidedError
from hfield.fields.base.balls import precision
from hfield.fields.number_fields.classes.abelian_groups import AbelianGroup
from hfield.fields.number_fields.classes.s_units import SUnits, logarithms, s_units

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import FractionalIdeal
    from hfield.fields.number_fields.ring import NumberField


class SUnitBasis:
    """The S-units of a field: its units, and S-units with a triangular matrix of exponents ``rows``."""

    def __init__(self, ring: NumberField) -> None:
        self.s: SUnits = s_units(ring)
        s = self.s
        k = len(s.primes)
        count = len(s.rows)
        whole = [[*row, *(int(i == j) for j in range(count))] for i, row in enumerate(s.rows)]
        reduced = flint.fmpz_mat(whole).hnf().tolist() if whole else []
        self.rows = [list(map(int, row[:k])) for row in reduced[:k]]
        self._change = [list(map(int, row[k:])) for row in reduced]

    @cached_property
    def classes(self) -> AbelianGroup:
        """The exponents at the primes of S modulo those of S-units: the class group."""
        return AbelianGroup(self.s.rows, len(self.s.primes))

    @cached_property
    def units(self) -> list[FieldElement]:
        """Fundamental units, with short logarithms."""
        s = self.s
        vectors = self._change[len(s.primes) :]
        if not vectors:
            return []
        if s.reduced_ideals is not None:
            return s.generators[-1:]
        bits = 256 + 2 * max(abs(c).bit_length() for row in vectors for c in row)
        logs = [logarithms(s.frame, x, bits, s.rank) for x in s.generators]
        whole = []
        with precision(bits):
            scale = flint.arb(2) ** 64
            for row in vectors:
                sums = [
                    sum((log[j] * c for log, c in zip(logs, row, strict=True)), flint.arb(0))
                    for j in range(s.rank)
                ]
                whole.append([int((x.mid() * scale).floor().unique_fmpz()) for x in sums])
        change = flint.fmpz_mat(whole).lll(transform=True)[1]
        short = (change * flint.fmpz_mat(vectors)).tolist()
        return [s.product(s.generators, list(map(int, row))) for row in short]

    @cached_property
    def s_elements(self) -> list[FieldElement]:
        """Elements with the exponents ``rows``."""
        return [
            self.shortened(self.s.product(self.s.generators, c))
            for c in self._change[: len(self.rows)]
        ]

    def shortened(self, x: FieldElement) -> FieldElement:
        """Return x times a unit, with conjugates of about the same size."""
        s, units = self.s, self.units
        if not units:
            return x
        bits = 256
        logs = [logarithms(s.frame, u, bits) for u in units]
        its = logarithms(s.frame, x, bits)
        n, real = s.n, s.field.signature[0]
        with precision(bits):
            mean = sum(its, flint.arb(0)) / n
            excess = [v - mean * (1 if k < real else 2) for k, v in enumerate(its)][: s.rank]
            matrix = flint.arb_mat([row[: s.rank] for row in logs])
            found = (flint.arb_mat([excess]) * matrix.inv()).entries()
            turns = [_nearest(c) for c in found]
        return s.product([x, *units], [1, *(-t for t in turns)])

    def class_of(self, a: FractionalIdeal) -> tuple[FieldElement, list[int]]:
        """Return (x, e): a is x times the product of the primes in S with exponents e."""
        s = self.s
        if s.reduced_ideals is not None:
            located = s.reduced_ideals.class_of(a)
            assert located is not None, "the primes in S generate the class group"
            return located
        inverse = a.inverse()
        for turn in range(400):
            helper = inverse
            for _ in range(turn % 5 if turn else 0):
                if s.base:
                    helper = helper * s.frame.prime(
                        s.base[s.rng.randrange(min(len(s.base), 4 + turn))]
                    )
            for y in s.short(helper, 20):
                exponents = s.smooth_ideal(s.frame.principal(y) * a)
                if exponents is not None:
                    x, found = s.reduced(s.field.one, exponents)
                    # y·a = ∏Pᵉ = x⁻¹·∏_S
                    return (y * x).inverse(), found
        raise UndecidedError(f"no element was found that brings {a} into the base of primes")

    def principal(self, a: FractionalIdeal) -> FieldElement | None:
        """Return a generator of an ideal, or None if there is none."""
        s = self.s
        size = a.norm()
        if len(a.generators) == 1:
            return a.generators[0]
        for y in s.short(a, 60):
            if abs(y.norm()) == flint.fmpq(size.numerator, size.denominator):
                return y
        x, exponents = self.class_of(a)
        if any(self.classes.coordinates(exponents)):
            return None
        left = list(exponents)
        for k, row in enumerate(self.rows):  # upper triangular
            times = left[k] // row[k]
            if times:
                left = [c - times * d for c, d in zip(left, row, strict=True)]
                x = x * s.field.power(self.s_elements[k], times)
        x = self.shortened(x)
        assert s.frame.principal(x) == a, "a generator generates"
        return x


def _nearest(c: flint.arb) -> int:
    """Return an integer near the middle of a ball. Any nearby integer is correct; a nearer one gives a
    shorter number.
    """
    whole = (c.mid() + flint.arb("0.5")).mid().floor().unique_fmpz()
    return 0 if whole is None else int(whole)


@lru_cache(maxsize=256)
def s_unit_basis(ring: NumberField) -> SUnitBasis:
    """Return the basis of the S-units of a field."""
    return SUnitBasis(ring)
