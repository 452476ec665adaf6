"""Maximal orders containing a given order, Eichler orders inside one, and ideals from zero divisors."""

from __future__ import annotations

import math
import random
from collections.abc import Callable

from flint import fmpz_mat

from hfield.orders import hermite
from hfield.orders.base_values import BaseIdeal, Prime
from hfield.orders.invariants import level
from hfield.orders.kernels.general import ideal_multiples
from hfield.orders.lattice_values import LatticeValue, hermite_form
from hfield.orders.orders_at_primes import OrderAtPrime, order_at_prime

Factors = list[tuple[Prime, int]]
"""Primes with their exponents."""


def overorder(order: LatticeValue) -> LatticeValue:
    """Return a maximal order that contains the given one; always the same one."""
    for prime, e in order.ambient.base.factorisation(level(order)):
        order = maximal_at(order, prime, e)
    return order


def maximal_at(order: LatticeValue, prime: Prime, e: int) -> LatticeValue:
    """Return an order that contains the given one with index Pᵉ and is maximal at P."""
    while e:
        at = OrderAtPrime(order, prime)
        # of level P, and split there, it is hereditary
        larger = at.ends(1)[0] if e == 1 and prime not in order.ambient.ramified else at.larger
        e -= order.ambient.base.valuation(order.volume / larger.volume, prime)
        order = larger
    return order


def eichler_suborder(order: LatticeValue, index: BaseIdeal) -> LatticeValue:
    """Return the Eichler order R + I for a left ideal I of norm ``index``; the order is maximal and split at
    its primes.

    R is the ring of integers of the base.
    """
    ambient, factors = order.ambient, order.ambient.base.factorisation(index)
    den, rows = _ideal_rows(order, factors, OrderAtPrime.zero_divisor)
    return hermite_form(ambient, *hermite.joined(den, rows, 1, ambient.integers))


def random_cyclic_ideal(order: LatticeValue, factors: Factors, rng: random.Random) -> LatticeValue:
    """Return a random left ideal I with cyclic O/I, of norm prime to the discriminant.

    All such ideals are equally likely, because the units of O/Pᵉ, which is M₂ of the residues, permute them
    transitively.
    """

    def element(at: OrderAtPrime, e: int) -> fmpz_mat:
        return at.times(at.zero_divisor(e), at.random_unit(rng, e))

    return hermite_form(order.ambient, *_ideal_rows(order, factors, element))


def _ideal_rows(
    order: LatticeValue, factors: Factors, element: Callable[[OrderAtPrime, int], fmpz_mat]
) -> tuple[int, fmpz_mat]:
    """Return rows over a denominator that span O·x + N·O, where N is the product of the ``factors``.

    Modulo each factor Pᵉ, x is ``element`` at P times a number prime to P.
    """
    ambient, base = order.ambient, order.ambient.base
    places = [(order_at_prime(order, prime), e) for prime, e in factors]
    powers = [at.ideal**e for at, e in places]
    norm = math.prod(powers, start=base.one)
    x = ambient.domain.matrix(1, ambient.size)
    for n, (at, e) in enumerate(places):
        others = math.prod((*powers[:n], *powers[n + 1 :]), start=base.one)
        _, numbers = base.ideal_rows(others)
        prime_to_p = next(c for c in numbers if at.residue(c) != 0)
        x = x + ambient.times_scalar(element(at, e), prime_to_p)
    products = order.matrix * ambient.right_matrix(x.entries())
    rows = hermite.divided(products, order.den * ambient.scale)
    below, multiples = ideal_multiples(ambient, order.matrix, norm)
    return order.den * below, hermite.stacked(multiples, rows)
