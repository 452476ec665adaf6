"""Local invariants of an order, over any base: level, Eichler symbols, conductor."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from hfield.orders.base_values import BaseIdeal, Prime
from hfield.orders.lattice_values import LatticeValue, discriminant, dual


def level(order: LatticeValue) -> BaseIdeal:
    """Return the index in a maximal order: the reduced discriminant divided by that of the algebra."""
    found: BaseIdeal = discriminant(order) / order.ambient.discriminant
    return found


def eichler_symbol(order: LatticeValue, prime: Prime) -> int | None:
    """Return the Eichler symbol (O | P): 1, 0 or −1; None if the order is maximal and split at P.

    The values mean that the residue algebra is split, ramified or inert (Voight, definition 24.3.2). For
    elements that are not central modulo the radical, x² − tr(x)·x + N(x) is a separable polynomial in the
    split and inert cases.
    """
    ambient, base = order.ambient, order.ambient.base
    if not base.valuation(discriminant(order), prime):
        return None
    for row in order.rows.tolist():
        symbol = base.quadratic_symbol(ambient.trace(row), ambient.norm(row), prime)
        if symbol:
            return symbol
    return 0


def is_eichler(order: LatticeValue) -> bool:
    """Return whether an order is an intersection of two maximal orders (Voight, section 24.3)."""
    ramified = order.ambient.ramified
    return all(
        P not in ramified and eichler_symbol(order, P) == 1
        for P, _ in order.ambient.base.factorisation(level(order))
    )


def has_all_unit_norms(order: LatticeValue) -> bool:
    """Return whether all local units of the base are known to be norms of local units of the order.

    This is known if all Eichler symbols are 1 or −1.
    """
    ambient, base, whole = order.ambient, order.ambient.base, discriminant(order)
    return all(
        (e == 1 and P in ambient.ramified) or eichler_symbol(order, P) != 0
        for P, e in base.factorisation(whole)
    )


def conductor(order: LatticeValue) -> BaseIdeal:
    """Return the largest ideal f with O = R + f·G for an order G, where R is the ring of integers of the
    base.

    It is N(O#)·discrd(O): for Gorenstein orders the dual is locally principal, and f⁻² comes from f⁻¹·G#.
    """
    found: BaseIdeal = dual(order).norm * discriminant(order)
    return found


def is_bass(order: LatticeValue, larger_at: Callable[[LatticeValue, Prime], LatticeValue]) -> bool:
    """Return whether every order that contains this one is Gorenstein.

    With Eichler symbol 1 or −1 an order is Bass if and only if it is Gorenstein. With symbol 0 the left order
    of the radical, which ``larger_at`` returns, is the only minimal overorder of a Gorenstein order.
    """
    base = order.ambient.base
    for prime, e in base.factorisation(discriminant(order)):
        larger, exponent = order, e
        while exponent > 1:
            if base.valuation(conductor(larger), prime):
                return False
            if eichler_symbol(larger, prime):
                break
            larger = larger_at(larger, prime)
            exponent = base.valuation(discriminant(larger), prime)
    return True


def good_primes(order: LatticeValue) -> Iterator[Prime]:
    """Yield the primes that do not divide the discriminant of an order, in order of norm."""
    base, whole = order.ambient.base, discriminant(order)
    return (prime for prime in base.primes_by_norm() if not base.valuation(whole, prime))
