"""The orders of an algebra that have names: maximal, Eichler, Lipschitz and Hurwitz."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from flint import fmpz_mat

from hfield.algebra.quaternion import Parent
from hfield.errors import CoercionError
from hfield.lattices import class_number as class_numbers
from hfield.lattices import hermite
from hfield.lattices.checked_arguments import expect_coprime, positive
from hfield.lattices.hurwitz_order import HurwitzOrder
from hfield.lattices.maximal_orders import eichler_suborder
from hfield.lattices.order import Order
from hfield.lattices.regular_representation import regular
from hfield.structure.clifford import maximal_basis


def maximal_order(algebra: Parent) -> Order:
    """Return a maximal order, by minimising a ternary form; the same for the same algebra.

    Raises :class:`UndecidedError` when the constants are too hard to factor.
    """
    constants = regular(algebra).constants
    den, rows = hermite.integral(maximal_basis(constants))
    found = hermite.hermite(den, fmpz_mat(rows))
    if found is None:
        raise AssertionError("the even Clifford algebra has rank 4")
    order = Order(algebra, *found)
    if not order.is_maximal():  # also remembers the primes, which the caller may have named
        raise AssertionError("the even Clifford algebra of a minimal form is maximal")
    return order


def eichler_order(algebra: Parent, level: object) -> Order:
    """Return an Eichler order of the given level inside the maximal order.

    Raises :class:`LatticeError` unless the level is a positive integer prime to the discriminant.
    """
    n = positive(level, "level")
    known: Any = algebra
    order = _maximal(known)
    return order if n == 1 else Order._ring(eichler_suborder(order, n))


def lipschitz_order(algebra: Parent) -> Order:
    """Return the integer combinations of e, i, j, k.

    Raises :class:`CoercionError` unless a, t and b are integers.
    """
    constants = regular(algebra).constants
    if any(x.denominator != 1 for x in constants):
        raise CoercionError(
            "e, i, j, k span an order over the integers only if a, t and b are integers"
        )
    return Order(algebra, 1, fmpz_mat([[int(m == n) for n in range(4)] for m in range(4)]))


def hurwitz_order(algebra: Parent) -> HurwitzOrder:
    """Return the Hurwitz order. Raises :class:`CoercionError` except for (−1,−1|ℚ)."""
    regular(algebra)
    return HurwitzOrder.of(algebra)


def class_number(algebra: Parent, level: object) -> int:
    """Return the number of ideal classes of an Eichler order of the given level."""
    n = positive(level, "level")
    r = regular(algebra)
    if r.definite:
        return class_numbers.class_number(r.discriminant, n)
    expect_coprime(n, r.discriminant)
    return 1  # strong approximation


@lru_cache(maxsize=64)
def _maximal(algebra: Parent) -> Order:
    return maximal_order(algebra)


__all__ = ["class_number", "eichler_order", "hurwitz_order", "lipschitz_order", "maximal_order"]
