"""Local invariants of an order, over any base: level, Eichler symbols, conductor."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from hfield.orders.base_values import BaseIdeal, Prime
from hfield.orders.lattice_values import LatticeValue, discriminant, dual


def level(order: LatticeValue) -> BaseIdeal:
    """Return the index in a maximal order: the reduced discriminant over that of the algebra."""
    found: BaseIdeal = discriminant(order) / order.ambient.discriminant
    return found


def eichler_symbol(order: LatticeValue, prime: Prime) -> int | None:
    """Return the Eichler symbol (O | P): 1, 0 or −1; None where the order is maximal and split at P.

    It tells the residue algebra: split, ramified or inert (Voight, definition 24.3.2). Outside of what is
    central modulo the radical a polynomial x² − tr(x)·x + N(x) is separable.
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
    """Return whether the local units of an order are known to have all local units as norms.

    They have where the Eichler symbols are 1 and −1.
    """
    ambient, base, whole = order.ambient, order.ambient.base, discriminant(order)
    return all(
        (e == 1 and P in ambient.ramified) or eichler_symbol(order, P) != 0
        for P, e in base.factorisation(whole)
    )


def conductor(order: LatticeValue) -> BaseIdeal:
    """Return the largest ideal f with O = R + f·G for an order G, R being the integers of the base.

    It is N(O#)·discrd(O): for Gorenstein orders the dual is locally principal, and f⁻² comes from f⁻¹·G#.
    """
    found: BaseIdeal = dual(order).norm * discriminant(order)
    return found


def is_bass(order: LatticeValue, larger_at: Callable[[LatticeValue, Prime], LatticeValue]) -> bool:
    """Return whether every order that contains this one is Gorenstein.

    With the Eichler symbols 1 and −1 those are Bass that are Gorenstein; with 0 the left order of the
    radical, which ``larger_at`` returns, is the only minimal overorder of a Gorenstein order.
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
    """Yield the primes that do not divide the discriminant of an order, ascending by their norms."""
    base, whole = order.ambient.base, discriminant(order)
    return (prime for prime in base.primes_by_norm() if not base.valuation(whole, prime))
