"""Maximal and Eichler orders over the integers of a number field."""

from __future__ import annotations

from typing import Any

from hfield.errors import LatticeError, shorten
from hfield.fields.number_fields.ideals import Ideal
from hfield.orders import orders_at_primes as local_orders
from hfield.orders.basis import AlgebraBasis, basis_of
from hfield.orders.lattice_values import (
    LatticeValue,
    discriminant,
    hermite_form,
)


def maximal_order(algebra: Any) -> LatticeValue:
    """Return a maximal order over the integers of a number field, always the same.

    Raises :class:`LatticeError` for a degenerate algebra, :class:`UnfactoredError` where a norm or the
    discriminant of the field is too hard to factor, :class:`TooLargeError` at primes of 64 bits and more.
    """
    ambient = basis_of(algebra)
    start = hermite_form(ambient, 1, ambient.identity)
    found = local_orders.maximal(start)
    if discriminant(found) != ambient.discriminant:
        raise AssertionError("a maximal order has the discriminant of its algebra")
    return found


def eichler_order(algebra: Any, level: object) -> LatticeValue:
    """Return an Eichler order of a level prime to the discriminant of the algebra, always the same.

    The level is a number, an ideal, or pairs (prime ideal, exponent). Raises :class:`LatticeError`.
    """
    ambient = basis_of(algebra)
    ideal = read_level(ambient, level)
    common = [P for P, _ in ideal.factorisation() if ambient.base.prime(P) in ambient.ramified]
    if common:
        raise LatticeError(
            f"the level {ideal} and the discriminant of {shorten(algebra)} have the prime {common[0]} in "
            "common: Eichler orders have a level prime to the discriminant"
        )
    return local_orders.eichler(maximal_order(algebra), ideal)


def read_level(ambient: AlgebraBasis, level: object) -> Ideal:
    """Return an integral ideal, given as a number, an ideal or pairs. Raises :class:`LatticeError`."""
    if isinstance(level, list | tuple) and all(isinstance(x, tuple | list) for x in level):
        ideal: Ideal = ambient.base.ideal(1)
        for pair in level:
            if len(pair) != 2 or not isinstance(pair[1], int) or pair[1] < 0:
                raise LatticeError(
                    f"{shorten(pair)} is no pair of a prime ideal and an exponent ≥ 0"
                )
            ideal = ideal * ambient.base.prime_ideal(ambient.base.prime(pair[0])) ** pair[1]
        return ideal
    ideal = ambient.base.ideal(level)
    if not ideal.is_integral():
        raise LatticeError(f"the level {ideal} is no ideal of integers")
    return ideal
