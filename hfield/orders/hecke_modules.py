"""The functions on the ideal classes as a module of Hecke operators, modulo the ideals of the base."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any

import flint

from hfield.orders import brandt
from hfield.orders.classes import Classes, orbits
from hfield.orders.eigensystems import Module, expect_eichler
from hfield.orders.invariants import good_primes, is_eichler, level


class ClassFunctions(Module):
    """Functions on the classes of an Eichler order; ``make`` returns the classes of another level."""

    def __init__(self, classes: Classes, make: Callable[[Any], Classes]) -> None:
        order, self.classes, self.make = classes.order, classes, make
        expect_eichler(is_eichler(order))
        self.base = base = order.ambient.base
        self.level = base.factorisation(level(order))
        self.ramified = order.ambient.ramified
        self._kinds = orbits(len(classes), classes.central)
        count = len(set(self._kinds))
        self._of = [self._kinds.index(kind) for kind in range(count)]
        weights = [Fraction(0)] * count
        for units, kind in zip(classes.units, self._kinds, strict=True):
            weights[kind] += Fraction(1, units)
        self.weights = [flint.fmpq(w.numerator, w.denominator) for w in weights]
        self.narrow = self._modulo_squares()

    def _modulo_squares(self) -> list[int]:
        """Return the narrow class of the norm of each point modulo squares, by numbers."""
        narrow = self.classes.keys.narrow
        group, classes = narrow.group, self.classes
        numbers = [classes.norms[n].number for n in self._of]
        known: dict[tuple[int, ...], int] = {}
        out = []
        for number in numbers:
            vector = group.class_of(narrow.ideals[number]) if narrow.order > 1 else ()
            reduced = tuple(
                c % 2 for c, d in zip(vector, group.invariants, strict=False) if d % 2 == 0
            )
            out.append(known.setdefault(reduced, len(known)))
        return out

    def prime(self, given: object) -> Any:
        """Return a prime of the base."""
        return self.base.prime(given)

    def shown(self, prime: Any) -> Any:
        """Return a prime as the base field has it."""
        p = self.base.place(prime).below
        return next(P for P, Q in self.base.primes_above(p) if prime == Q)

    def good_primes(self) -> Iterator[Any]:
        """Yield the primes that divide neither the level nor the discriminant."""
        return good_primes(self.classes.order)

    def operator(self, prime: Any) -> flint.fmpq_mat:
        """Return the Brandt matrix of a prime, on functions on the points."""
        matrix = brandt.prime_power(self.classes, prime, 1)
        if len(self._of) == len(self._kinds):
            return flint.fmpq_mat(matrix)
        rows = matrix.tolist()
        table = [[0] * len(self._of) for _ in self._of]
        for line, n in zip(table, self._of, strict=True):
            for j, times in enumerate(rows[n]):
                line[self._kinds[j]] += int(times)
        return flint.fmpq_mat(table)

    def exchange(self, prime: Any) -> list[int]:
        """Return which point each becomes by the two-sided ideal at a prime."""
        moved = self.classes.exchanged(prime)
        return [self._kinds[moved[n]] for n in self._of]

    def lower(self, level: Sequence[tuple[Any, int]]) -> ClassFunctions:
        """Return the module of another level."""
        primes = (self.base.prime_ideal(P) ** e for P, e in level)
        return ClassFunctions(self.make(math.prod(primes, start=self.base.one)), self.make)
