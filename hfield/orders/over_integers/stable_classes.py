"""Local norms of orders over ℤ_K, for the stable classes (:mod:`hfield.orders.class_number`).

Where the Eichler symbol is 0 the units of O_P are those of ℤ_P times 1 + J, J the radical: above an odd prime
their norms are squares. Above 2 those of 1 + y, with y in bases of J, J², …, generate the norms of 1 + J;
where a power of J lies in 4P·O the norms are in 1 + 4P, and squares.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import flint

from hfield.fields.number_fields.symbols import square_class
from hfield.orders.class_number import LocalNorms, StableClasses
from hfield.orders.lattice_values import LatticeValue, includes, product, times_ideal
from hfield.orders.orders_at_primes import OrderAtPrime
from hfield.orders.positive_generators import units_modulo_squares

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.prime_ideals import PrimeIdeal


def stable_classes(order: Any) -> StableClasses:
    """Return the stable classes of a definite order."""
    ambient, places = order.value.ambient, []
    for shown, _ in order.discriminant().factorisation():
        if order.eichler_symbol(shown) == 0:
            P = ambient.base.prime(shown)
            size = P.e * P.f + 1 if P.p == 2 else 1
            norms = {square_class(P, x) for x in _norms(order.value, P)}
            places.append(LocalNorms(P, size, partial(square_class, P), tuple(norms)))
    ring = ambient.base.ring
    return StableClasses(places, units_modulo_squares(ring), ring.narrow_class_group().order)


def _norms(order: LatticeValue, P: PrimeIdeal) -> Iterator[FieldElement]:
    """Yield norms that generate, with the squares, those of the units at P."""
    if P.p > 2:
        return
    ambient = order.ambient
    one, bound = ambient.row(1), times_ideal(order, ambient.base.prime_ideal(P) ** (2 * P.e + 1))
    radical = power = OrderAtPrime(order, P).radical
    while not includes(bound, power):
        for row in power.rows.tolist():
            yield ambient.norm((flint.fmpq_mat([row]) + one).entries())
        power = product(power, radical)
