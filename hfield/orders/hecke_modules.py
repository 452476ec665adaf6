"""The functions on the ideal classes over ℤ as a module of Hecke operators."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import flint

from hfield.core.factorisation import factorise
from hfield.core.primality import primes
from hfield.orders import validation
from hfield.orders.classes import Classes
from hfield.orders.eigensystems import Module, expect_eichler
from hfield.orders.invariants import is_eichler
from hfield.orders.standard_orders import eichler_order


class RationalModule(Module):
    """Functions on the classes of an Eichler order over ℤ."""

    def __init__(self, classes: Classes) -> None:
        self.classes, order = classes, classes.ring
        expect_eichler(is_eichler(order))
        self.level = sorted(factorise(order.level).items())
        self.ramified = sorted(factorise(order.ambient.discriminant))
        self.weights = [flint.fmpq(1, units) for units in classes.unit_counts]
        self.narrow = [0] * len(classes)

    def prime(self, given: object) -> int:
        """Return a prime number."""
        return validation.prime(given)

    def good_primes(self) -> Iterator[int]:
        """Yield the primes that divide neither the level nor the discriminant."""
        return (p for p in primes() if self.classes.ring.discriminant % p)

    def operator(self, prime: Any) -> flint.fmpq_mat:
        """Return the Brandt matrix of a prime."""
        return flint.fmpq_mat(flint.fmpz_mat(self.classes.brandt_matrix(prime)))

    def exchange(self, prime: Any) -> list[int]:
        """Return which class each becomes by the two-sided ideal at a prime."""
        return self.classes.exchanged_at(prime)

    def lower(self, level: Sequence[tuple[Any, int]]) -> RationalModule:
        """Return the module of another level."""
        number = 1
        for p, e in level:
            number *= p**e
        return RationalModule(Classes(eichler_order(self.classes.ring.algebra, number)))
