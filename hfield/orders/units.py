"""The units of an order of a totally definite algebra, modulo those of the field, over any base."""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq_mat

from hfield.algebra.quaternion import Quaternion
from hfield.orders import short_elements
from hfield.orders.basis import AlgebraBasis
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.short_elements import expect_definite, rows_of_norm

UNIT_GROUPS = {1: "C2", 2: "C4", 3: "C6", 4: "Q8", 6: "Dic3", 12: "SL(2,3)"}
"""Which group the units of an order over ℤ are, by their number modulo ±1 (Voight, section 11.5)."""


def units(order: LatticeValue) -> tuple[Quaternion, ...]:
    """Return all units over ℤ; over other bases, one from each coset of the units of the base.

    Raises :class:`IndefiniteError` if there are infinitely many.
    """
    expect_definite(order.ambient, "units()")
    if order.ambient.base.lists_all_units:
        return short_elements.of_norm(order, order.ambient.base.field.one)
    return tuple(order.ambient.quaternion(row.entries()) for row in units_modulo_scalars(order))


def units_modulo_scalars(order: LatticeValue) -> Iterator[fmpq_mat]:
    """Yield one unit from each coset of the units of the base, if the algebra is definite."""
    expect_definite(order.ambient, "units()")
    for u in order.ambient.base.positive_units:
        yield from rows_of_norm(order, u)


def unit_index(order: LatticeValue) -> int:
    """Return the number of units modulo those of the base. Raises :class:`IndefiniteError` as :func:`units`
    does.
    """
    return sum(1 for _ in units_modulo_scalars(order))


def unit_group(order: LatticeValue) -> str:
    """Return the name of the group of units; over bases other than ℤ, modulo the units of the base.

    Over ℤ it is one of ``C2 C4 C6 Q8 Dic3 SL(2,3)``; else ``C4 D2 D6 A4 S4 A5`` and so on, since a finite
    group of rotations is determined by its order and the largest order of an element. In an indefinite
    algebra it is ``"infinite"``.
    """
    ambient = order.ambient
    if not ambient.definite:
        return "infinite"
    found = list(units_modulo_scalars(order))
    size = len(found)
    if ambient.base.lists_all_units:
        return UNIT_GROUPS[size]
    largest = max(_order(ambient, row) for row in found)
    if largest == size:
        return f"C{size}"
    if 2 * largest == size:
        return f"D{largest}"
    return {12: "A4", 24: "S4", 60: "A5"}[size]


def _order(ambient: AlgebraBasis, row: fmpq_mat) -> int:
    """Return the order of a unit modulo scalars."""
    matrix, power, n = ambient.times(row.entries()), row, 1
    while any(power.entries()[ambient.degree :]):
        power, n = power * matrix, n + 1
    return n
