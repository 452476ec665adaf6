"""The units of an order over ℤ of a definite algebra: at most 24."""

from __future__ import annotations

from hfield.algebra.quaternion import Quaternion
from hfield.orders import short_elements
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.short_elements import expect_definite

UNIT_GROUPS = {1: "C2", 2: "C4", 3: "C6", 4: "Q8", 6: "Dic3", 12: "SL(2,3)"}
"""Which group the units are, by their number modulo ±1 (Voight, section 11.5)."""


def units(order: LatticeValue) -> tuple[Quaternion, ...]:
    """Return all units. Raises :class:`IndefiniteError` where they are infinitely many."""
    expect_definite(order.ambient, "units()")
    return short_elements.of_norm(order, order.ambient.base.inside(1))


def unit_index(order: LatticeValue) -> int:
    """Return how many units there are modulo ±1. Raises likewise."""
    expect_definite(order.ambient, "unit_index()")
    return sum(1 for _ in short_elements.up_to(order, 1))


def unit_group(order: LatticeValue) -> str:
    """Return the name of the group of units; ``"infinite"`` in an indefinite algebra."""
    return UNIT_GROUPS[unit_index(order)] if order.ambient.definite else "infinite"
