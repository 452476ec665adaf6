"""Local norms of orders, for the stable classes (:mod:`hfield.orders.mass_formula`).

Where the Eichler symbol is 0 the units of O_P are those of R_P times 1 + J, R the integers of the base and J
the radical: above an odd prime their norms are squares. Above 2 those of 1 + y, with y in bases of J, J², …,
generate the norms of 1 + J; where a power of J lies in 4P·O the norms are in 1 + 4P, and squares.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq_mat

from hfield.orders.base_values import Prime, Scalar
from hfield.orders.invariants import eichler_symbol
from hfield.orders.lattice_values import (
    LatticeValue,
    discriminant,
    includes,
    product,
    times_ideal,
)
from hfield.orders.mass_formula import LocalNorms, StableClasses
from hfield.orders.orders_at_primes import OrderAtPrime


def stable_classes(order: LatticeValue) -> StableClasses:
    """Return the stable classes of a definite order."""
    base, places = order.ambient.base, []
    for P, _ in base.factorisation(discriminant(order)):
        if eichler_symbol(order, P) == 0:
            size, square_class = base.square_classes(P)
            norms = set(map(square_class, _norms(order, P)))
            places.append(LocalNorms(P, size, square_class, tuple(norms)))
    return StableClasses(places, base.positive_units, base.narrow_classes.order)


def _norms(order: LatticeValue, P: Prime) -> Iterator[Scalar]:
    """Yield norms that generate, with the squares, those of the units at P."""
    ambient, place = order.ambient, order.ambient.base.place(P)
    if place.below > 2:
        return
    ideal = ambient.base.prime_ideal(P)
    one, bound = ambient.one, times_ideal(order, ideal ** (2 * place.index + 1))
    radical = power = OrderAtPrime(order, P).radical
    while not includes(bound, power):
        for row in power.rows.tolist():
            yield ambient.norm((fmpq_mat([row]) + one).entries())
        power = product(power, radical)
