"""The functions on the ideal classes over ℤ_K as a module of Hecke operators, modulo the ideals of K."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import flint

from hfield.orders.classes import orbits
from hfield.orders.eigensystems import Module, expect_eichler

if TYPE_CHECKING:
    from hfield.fields.number_fields.prime_ideals import PrimeIdeal
    from hfield.orders.over_integers.class_sets import Classes


class IntegersModule(Module):
    """Functions on the classes of an Eichler order; ``make`` returns the classes of another level."""

    def __init__(self, classes: Classes, make: Callable[[Any], Classes]) -> None:
        order, self.classes, self.make = classes.ring, classes, make
        expect_eichler(order.is_eichler())
        self.ambient = ambient = classes.ambient
        self.level = [(ambient.base.prime(P), e) for P, e in order.level.factorisation()]
        self.ramified = ambient.ramified
        self._kinds = orbits(len(classes), classes.central)
        count = len(set(self._kinds))
        self._of = [self._kinds.index(kind) for kind in range(count)]
        self.weights = [
            sum(
                (flint.fmpq(1, classes.units[n]) for n, k in enumerate(self._kinds) if k == kind),
                flint.fmpq(0),
            )
            for kind in range(count)
        ]
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

    def prime(self, given: object) -> PrimeIdeal:
        """Return a prime ideal of QQ[s]/(f)."""
        found: PrimeIdeal = self.ambient.base.prime(given)
        return found

    def shown(self, prime: Any) -> Any:
        """Return a prime as the base field has it."""
        return next(P for P, Q in self.ambient.base.primes_above(prime.p) if prime == Q)

    def good_primes(self) -> Iterator[PrimeIdeal]:
        """Yield the primes that divide neither the level nor the discriminant."""
        return self.classes.good_primes()

    def operator(self, prime: Any) -> flint.fmpq_mat:
        """Return the Brandt matrix of a prime, on functions on the points."""
        rows = self.classes.neighbours(prime)
        table = [[0] * len(self._of) for _ in self._of]
        for line, n in zip(table, self._of, strict=True):
            for j, times in rows[n].items():
                line[self._kinds[j]] += times
        return flint.fmpq_mat(table)

    def exchange(self, prime: Any) -> list[int]:
        """Return which point each becomes by the two-sided ideal at a prime."""
        moved = self.classes.exchanged(prime)
        return [self._kinds[moved[n]] for n in self._of]

    def lower(self, level: Sequence[tuple[Any, int]]) -> IntegersModule:
        """Return the module of another level."""
        return IntegersModule(self.make(level), self.make)
