"""Ideals of given norm over ℤ_K, in steps of prime norm: all of them, those in an ideal, or one at random."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from random import Random
from typing import Any

from hfield.errors import LatticeError, TooLargeError
from hfield.orders.lattice_values import LatticeValue, discriminant, includes
from hfield.orders.orders_at_primes import Local, Rows
from hfield.orders.over_integers.ideals_of_norm import (
    MOST,
    generators,
    random_generators,
    subideals,
)


def ideals_of_norm(order: LatticeValue, norm: Any) -> list[LatticeValue]:
    """Return all invertible integral right ideals of an order of a norm.

    Raises :class:`LatticeError` where squares of primes divide the norm and the discriminant,
    :class:`TooLargeError` for more than 10⁵.
    """
    base, layer = order.ambient.base, [order]
    for prime, e in base.factorisation(norm):
        if e > 1 and base.valuation(discriminant(order), prime) > 1:
            raise LatticeError(
                f"ideals of norm {norm} are not listed at {prime}, whose square divides the discriminant; "
                "those of norm P are"
            )
        for _ in range(e):
            if len(layer) * (prime.norm() + 1) > MOST:
                raise TooLargeError(f"there are too many ideals of norm {norm} to list them")
            layer = list({J: J for I in layer for J in subideals_of(order, I, prime)})
    return layer


def subideals_of(order: LatticeValue, ideal: LatticeValue, prime: Any) -> Iterator[LatticeValue]:
    """Yield the invertible right ideals of relative norm P in an invertible right ideal of an order."""
    local, found = _at_prime(order, prime)
    return subideals(local, ideal, found)


@lru_cache(maxsize=64)
def _at_prime(order: LatticeValue, prime: Any) -> tuple[Local, list[Rows]]:
    """Return what is needed to list right ideals of norm P."""
    local = Local(order.ambient, prime)
    return local, generators(local, order)


def random_ideal(order: LatticeValue, norm: Any, rng: Random) -> LatticeValue:
    """Return a random right ideal of an order of a norm, prime to the discriminant; O/I is cyclic."""
    base, found = order.ambient.base, order
    for prime, e in base.factorisation(norm):
        if base.valuation(discriminant(order), prime):
            raise LatticeError(
                f"random ideals have a norm prime to the discriminant, and {prime} divides both"
            )
        local, before = Local(order.ambient, prime), None
        for _ in range(e):
            ideal = None
            while ideal is None or (before and includes(local.times_prime(before), ideal)):
                (ideal,) = subideals(local, found, [random_generators(local, order, rng)])
            before, found = found, ideal
    return found
