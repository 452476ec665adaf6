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
    quadratic_orders,
)
from hfield.orders.class_number import StableClasses
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.over_integers import quadratic_orders as quadratic_orders_over_fields
from hfield.orders.over_integers import stable_classes
from hfield.orders.validation import integer, positive
from hfield.orders.z_order import ZOrder

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion


@dataclass(frozen=True)
class OrderFunctions:
    """What is computed of an order; the names are those of the methods of ``Order``.

    Orders are values, or an ``Order``, whose class stands above, where an answer keeps it.
    """

    represent_integer: Callable[[Any, Any, int | None], Quaternion | None]
    embeddings: Callable[[Any, Any], Any]
    stable_classes: Callable[[Any], StableClasses]


def functions(order: LatticeValue) -> OrderFunctions:
    """Return the functions for an order."""
    return OVER_Z if order.ambient.base.is_rational else OVER_FIELDS


# --- over ℤ ----------------------------------------------------------------------------------------


def _represent_over_z(order: ZOrder, n: object, seed: int | None) -> Quaternion | None:
    return quadratic_orders.represent_integer(order, positive(n, "norm"), seed)


def _embeddings_over_z(order: Any, discriminant: object) -> quadratic_orders.Embeddings:
    d = integer(discriminant, "discriminant")
    found = quadratic_orders.embeddings(ZOrder.of(order.value), d)
    return quadratic_orders.Embeddings(order, d, *found)


OVER_Z = OrderFunctions(
    represent_integer=_represent_over_z,
    embeddings=_embeddings_over_z,
    stable_classes=lambda O: class_number.over_z(ZOrder.of(O.value)),
)


# --- over ℤ_K --------------------------------------------------------------------------------------


OVER_FIELDS = OrderFunctions(
    represent_integer=quadratic_orders_over_fields.represent,
    embeddings=lambda O, d: quadratic_orders_over_fields.embeddings(O.value, d),
    stable_classes=stable_classes.stable_classes,
)
