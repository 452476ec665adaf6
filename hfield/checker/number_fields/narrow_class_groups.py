"""Decide which ideals of a totally real field have totally positive generators (narrow class group).

Ideals are products of a number and prime ideals in a set S. The relations are given by S-units, which a
certificate proves to generate all S-units. The signs of the units give the totally positive units modulo
squares.
"""

from collections.abc import Sequence
from itertools import product
from math import prod

from hfield.checker.budget import spend
from hfield.checker.number_fields.class_groups import SUnits
from hfield.checker.number_fields.ideals import times_number, times_primes
from hfield.checker.number_fields.integers import Prime
from hfield.checker.number_fields.matrices import Key, hermite, unit
from hfield.checker.rejection import a_list, an_integer, reject
from hfield.checker.scalars.number_fields import Element, NumberField


class NarrowClasses:
    """S-units with fundamental units; they decide which products of primes in S have a totally positive
    generator.
    """

    def __init__(self, field: NumberField, units: object, fundamental: object) -> None:
        self.s = s = SUnits(field, units)
        given = [s.given(x) for x in a_list(fundamental, "fundamental units")]
        s.need_fundamental(given)
        if s.places.complex:
            reject("this is checked over totally real fields")
        self.field, self.n, self.order = field, field.degree, prod(s.invariants)
        every = [field.number(-1), *given]
        spend(2 ** len(every))
        self.units: list[Element] = []
        """The totally positive units modulo squares."""
        for chosen in product((0, 1), repeat=len(every)):
            x: Element = field.one
            for u, e in zip(every, chosen, strict=True):
                x = field.mul(x, u) if e else x
            if not any(self._signs(x)):
                self.units.append(x)
        k = len(s.S)
        rows = [[*row, *self._signs(x)] for row, x in zip(s.rows, s.generators, strict=True)]
        rows += [[0] * k + [1] * self.n]
        rows += [list(unit(k + self.n, k + m, 2)) for m in range(self.n)]
        self._principal = hermite(rows)

    def _signs(self, x: Element) -> list[int]:
        return [int(sign == -1) for sign in self.field.signs(x)]

    def read(self, value: object) -> tuple[Element, list[int]]:
        """Read a product x·∏P^e, P in S: ``[x, [e, …]]``."""
        entry = a_list(value, "a product of primes", 2)
        x = self.s.given(entry[0])
        e = [an_integer(c, "an exponent") for c in a_list(entry[1], "exponents")]
        if len(entry) != 2 or len(e) != len(self.s.S) or not any(x):
            reject(
                "a product of primes is a number, not 0, and an exponent for each prime ideal in S"
            )
        return x, e

    def is_principal(self, x: Element, e: Sequence[int]) -> bool:
        """Return whether x·∏P^e has a totally positive generator."""
        rest = [*e, *self._signs(x)]
        spend(len(rest) ** 2)
        for n, row in enumerate(self._principal):
            c, r = divmod(rest[n], row[n])
            if r:
                return False
            rest = [a - c * b for a, b in zip(rest, row, strict=True)]
        return True

    def classes(self, value: object) -> list[tuple[Element, list[int]]]:
        """Read ideals of distinct narrow classes, as products of primes in S; by default the unit ideal."""
        if value is None:
            return [(self.field.one, [0] * len(self.s.S))]
        found = [self.read(x) for x in a_list(value, "ideals of the narrow classes", 1)]
        for k, (x, e) in enumerate(found):
            for y, f in found[:k]:  # a quotient has the signs of the product
                exponents = [a - b for a, b in zip(e, f, strict=True)]
                if self.is_principal(self.field.mul(x, y), exponents):
                    reject("two norms are in one narrow class")
        return found

    def is_quotient(self, x: Element, e: Sequence[int], above: Key, below: Key) -> bool:
        """Return whether an ideal is x·∏P^e times another ideal."""
        integers, primes = self.s.integers, [self.s.factors.primes[k] for k in self.s.S]

        def powers(sign: int) -> list[tuple[Prime, int]]:
            return [(P, c * sign) for P, c in zip(primes, e, strict=True) if c * sign > 0]

        whole = times_primes(integers, powers(1), times_number(integers, x, below))
        return whole == times_primes(integers, powers(-1), above)

    def need_totally_positive(self, x: Element) -> Element:
        """Return the inverse of a number; reject it unless it is totally positive."""
        if any(sign != 1 for sign in self.field.signs(x)):
            reject("the norm of an ideal is given by a totally positive number")
        inverse = self.field.inverse(x)
        assert inverse is not None, "a number with signs is not 0"
        return inverse
