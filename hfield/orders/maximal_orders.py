"""Maximal orders that contain a given order, the Eichler orders inside one, and ideals from zero divisors."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

from flint import fmpz_mat

from hfield.orders import hermite
from hfield.orders.invariants import level
from hfield.orders.kernels.general import ideal_multiples
from hfield.orders.lattice_values import LatticeValue, hermite_form
from hfield.orders.orders_at_primes import Line, OrderAtPrime, small_lines

Lines = Callable[[int, int], Iterator[Line]]
"""Lines among vectors of a length, for a modulus."""


def overorder(order: LatticeValue) -> LatticeValue:
    """Return a maximal order that contains the given one, always the same."""
    for prime, e in order.ambient.base.factorisation(level(order)):
        order = maximal_at(order, prime, e)
    return order


def maximal_at(order: LatticeValue, prime: Any, e: int) -> LatticeValue:
    """Return an order that contains the given one with the index Pᵉ, maximal at P."""
    while e:
        at = OrderAtPrime(order, prime)
        # of level P, and split there, it is hereditary
        larger = at.ends(1)[0] if e == 1 and prime not in order.ambient.ramified else at.larger
        e -= order.ambient.base.valuation(order.volume / larger.volume, prime)
        order = larger
    return order


def eichler_suborder(order: LatticeValue, index: Any) -> LatticeValue:
    """Return the Eichler order R + I, I a left ideal of a norm in an order, maximal and split at its primes.

    R are the integers of the base.
    """
    ambient, factors = order.ambient, order.ambient.base.factorisation(index)
    den, rows = _ideal_rows(order, factors, lambda size, modulus: small_lines(size))
    return hermite_form(ambient, *hermite.joined(den, rows, 1, ambient.integers))


def cyclic_ideal(order: LatticeValue, factors: list[tuple[Any, int]], lines: Lines) -> LatticeValue:
    """Return a left ideal I with cyclic O/I, of a norm prime to the discriminant, given by its factors.

    It is that of an x that is, modulo each prime power in the norm, a zero divisor on one of some lines.
    """
    return hermite_form(order.ambient, *_ideal_rows(order, factors, lines))


def _ideal_rows(
    order: LatticeValue, factors: list[tuple[Any, int]], lines: Lines
) -> tuple[int, fmpz_mat]:
    """Return rows over a denominator that span N·O and, for each power Pᵉ in N, the N·P⁻ᵉ·O·x."""
    ambient, base = order.ambient, order.ambient.base
    places = [(OrderAtPrime(order, prime), e) for prime, e in factors]
    norm = math.prod((at.ideal**e for at, e in places), start=base.one)
    found = ideal_multiples(ambient, order.matrix, norm)
    for at, e in places:
        x = at.zero_divisor(e, lines(ambient.size, at.power_of_p(e)))
        rows = hermite.divided(
            order.matrix * ambient.right_matrix(x.entries()), order.den * ambient.scale
        )
        den = 1
        if len(places) > 1:
            den, rows = ideal_multiples(ambient, rows, norm * base.inverse(at.ideal**e))
        found = hermite.joined(*found, den, rows)
    return found[0] * order.den, found[1]
