"""Functions on orders that are one thing over ℤ and another over ℤ_K; the choice is made here.

Over ℤ they handle primes of hundreds of digits and are quicker, over ℤ_K they look at one prime ideal at a
time, with residues in a machine's word. Their arguments and results mean the same: primes and norms are those
of the base, ideals are right ideals unless it is said otherwise. An ``Order`` is what a user holds.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from hfield.orders import (
    class_number,
    hermite,
    ideals_at_primes,
    ideals_of_norm,
    isomorphic_orders,
    lattice_values,
    maximal_orders,
    pseudo_bases,
    quadratic_orders,
    related_orders,
    short_elements,
    z_order,
)
from hfield.orders import orders_at_primes as local_orders
from hfield.orders.class_number import StableClasses
from hfield.orders.lattice_values import LatticeValue, conjugate
from hfield.orders.orders_at_primes import Local
from hfield.orders.over_integers import quadratic_orders as quadratic_orders_over_fields
from hfield.orders.over_integers import stable_classes
from hfield.orders.validation import integer, positive
from hfield.orders.z_order import ZOrder

if TYPE_CHECKING:
    from collections.abc import Iterable

    from hfield.algebra.quaternion import Quaternion
    from hfield.orders.ternary_forms import Triple


@dataclass(frozen=True)
class OrderFunctions:
    """What is computed of an order; the names are those of the methods of ``Order``.

    Orders are values, or an ``Order``, whose class stands above, where an answer keeps it.
    """

    maximal_overorder: Callable[[Any], LatticeValue]
    gorenstein_closure: Callable[[Any], LatticeValue]
    larger_at: Callable[[Any, Any], LatticeValue]
    """The left order of the radical at a prime."""
    connecting_ideal: Callable[[Any, Any], LatticeValue]
    """It is a left ideal of the first order."""
    ideals_of_norm: Callable[[Any, Any], list[LatticeValue]]
    subideals: Callable[[Any, LatticeValue, Any], Iterable[LatticeValue]]
    random_ideal: Callable[[Any, Any, random.Random], LatticeValue]
    """It is a left ideal."""
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


def _larger_over_z(order: LatticeValue, p: int) -> LatticeValue:
    radical = maximal_orders.radical(ZOrder.of(order), p)
    return lattice_values.order_of(radical, "left")


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
    maximal_overorder=maximal_orders.overorder,
    gorenstein_closure=z_order.gorenstein_closure,
    larger_at=_larger_over_z,
    connecting_ideal=isomorphic_orders.connecting_ideal,
    ideals_of_norm=ideals_of_norm.ideals_of_norm,
    subideals=ideals_of_norm.subideals,
    random_ideal=ideals_of_norm.random_ideal,
    ternary_basis=_ternary_basis_over_z,
    ternary_theta_series=lambda O, n: short_elements.theta_series_of_form(O.reduced_ternary[2], n),
    represent_integer=_represent_over_z,
    embeddings=_embeddings_over_z,
    stable_classes=lambda O: class_number.over_z(ZOrder.of(O.value)),
)


# --- over ℤ_K --------------------------------------------------------------------------------------


def _larger_over_fields(order: LatticeValue, prime: Any) -> LatticeValue:
    local = Local(order.ambient, prime)
    return local.left_order(local.radical(order))


def _ternary_basis_over_fields(order: LatticeValue) -> Triple:
    _, *pairs = pseudo_bases.pseudo_basis(order)  # the first are the integers of the field
    i, j, k = pseudo_bases.free_basis(order.ambient, tuple(pairs))
    return i, j, k


OVER_FIELDS = OrderFunctions(
    maximal_overorder=local_orders.maximal,
    gorenstein_closure=related_orders.gorenstein_closure,
    larger_at=_larger_over_fields,
    connecting_ideal=related_orders.connecting,
    ideals_of_norm=ideals_at_primes.ideals_of_norm,
    subideals=ideals_at_primes.subideals_of,
    random_ideal=lambda O, norm, rng: conjugate(ideals_at_primes.random_ideal(O, norm, rng)),
    ternary_basis=_ternary_basis_over_fields,
    ternary_theta_series=short_elements.ternary_theta_series,
    represent_integer=quadratic_orders_over_fields.represent,
    embeddings=lambda O, d: quadratic_orders_over_fields.embeddings(O.value, d),
    stable_classes=stable_classes.stable_classes,
)
