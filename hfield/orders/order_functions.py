"""Functions on orders that are one thing over ℤ and another over ℤ_K; the choice is made here.

Over ℤ they handle primes of hundreds of digits and are quicker, over ℤ_K they look at one prime ideal at a
time, with residues in a machine's word. Their arguments and results mean the same: primes and norms are those
of the base, ideals are right ideals unless it is said otherwise. An ``Order`` is what a user holds.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from hfield.orders import (
    class_number,
    hermite,
    pseudo_bases,
    quadratic_orders,
    short_elements,
)
from hfield.orders.class_number import StableClasses
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.over_integers import quadratic_orders as quadratic_orders_over_fields
from hfield.orders.over_integers import stable_classes
from hfield.orders.validation import integer, positive
from hfield.orders.z_order import ZOrder

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.orders.ternary_forms import Triple


@dataclass(frozen=True)
class OrderFunctions:
    """What is computed of an order; the names are those of the methods of ``Order``.

    Orders are values, or an ``Order``, whose class stands above, where an answer keeps it.
    """

    ternary_basis: Callable[[Any], Triple]
    """Elements i, j, k with which 1 is a basis of the order, or such elements up to numbers."""
    ternary_theta_series: Callable[[Any, object], Any]
    represent_integer: Callable[[Any, Any, int | None], Quaternion | None]
    embeddings: Callable[[Any, Any], Any]
    stable_classes: Callable[[Any], StableClasses]


def functions(order: LatticeValue) -> OrderFunctions:
    """Return the functions for an order."""
    return OVER_Z if order.ambient.base.is_rational else OVER_FIELDS


# --- over ℤ ----------------------------------------------------------------------------------------


def _ternary_basis_over_z(order: ZOrder) -> Triple:
    den, rows, _ = order.reduced_ternary if order.ambient.definite else order.ternary
    i, j, k = (order.element(row, 2 * den) for row in hermite.tuples(rows))
    return i, j, k


def _represent_over_z(order: ZOrder, n: object, seed: int | None) -> Quaternion | None:
    return quadratic_orders.represent_integer(order, positive(n, "norm"), seed)


def _embeddings_over_z(order: Any, discriminant: object) -> quadratic_orders.Embeddings:
    d = integer(discriminant, "discriminant")
    found = quadratic_orders.embeddings(ZOrder.of(order.value), d)
    return quadratic_orders.Embeddings(order, d, *found)


OVER_Z = OrderFunctions(
    ternary_basis=_ternary_basis_over_z,
    ternary_theta_series=lambda O, n: short_elements.theta_series_of_form(O.reduced_ternary[2], n),
    represent_integer=_represent_over_z,
    embeddings=_embeddings_over_z,
    stable_classes=lambda O: class_number.over_z(ZOrder.of(O.value)),
)


# --- over ℤ_K --------------------------------------------------------------------------------------


def _ternary_basis_over_fields(order: LatticeValue) -> Triple:
    _, *pairs = pseudo_bases.pseudo_basis(order)  # the first are the integers of the field
    i, j, k = pseudo_bases.free_basis(order.ambient, tuple(pairs))
    return i, j, k


OVER_FIELDS = OrderFunctions(
    ternary_basis=_ternary_basis_over_fields,
    ternary_theta_series=short_elements.ternary_theta_series,
    represent_integer=quadratic_orders_over_fields.represent,
    embeddings=lambda O, d: quadratic_orders_over_fields.embeddings(O.value, d),
    stable_classes=stable_classes.stable_classes,
)
