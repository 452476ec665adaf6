"""Decide whether two orders are isomorphic, over any base, and find an element that conjugates them."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from hfield.algebra.quaternion import Quaternion
from hfield.errors import IndefiniteError, UndecidedError
from hfield.orders import certificates
from hfield.orders.conjugators import conjugator
from hfield.orders.equivalence import element_generating
from hfield.orders.invariants import conductor, is_eichler
from hfield.orders.lattice_values import LatticeValue, discriminant
from hfield.orders.related_orders import connecting, gorenstein_closure
from hfield.verdicts import Verdict


def isomorphism(first: LatticeValue, second: LatticeValue) -> Verdict[Quaternion]:
    """Return an answer with an element x such that ``x·first·x⁻¹ = second``.

    In an indefinite algebra equal orders, and orders with different discriminants or conductors, are decided
    first. For other pairs the function raises :class:`IndefiniteError` unless every ideal of the base has a
    generator that is positive at the ramified real places. It raises :class:`UndecidedError` unless both
    Gorenstein closures are Eichler orders.
    """
    found = _decide(first, second)
    return replace(found, make_claim=partial(certificates.of_isomorphism, first, second, found))


def _decide(first: LatticeValue, second: LatticeValue) -> Verdict[Quaternion]:
    ambient, conjugates = first.ambient, "the element conjugates one into the other"
    if first == second:
        return Verdict(True, "they are equal", first.algebra(1))
    both = discriminant(first), discriminant(second)
    if both[0] != both[1]:
        return Verdict(False, f"their discriminants are {both[0]} and {both[1]}")
    if ambient.definite:
        x, reason = conjugator(first, second)
        return Verdict(x is not None, reason or conjugates, x)
    if conductor(first) != conductor(second):
        return Verdict(False, "their conductors differ")
    if ambient.base.classes_modulo_signs(ambient).order > 1:
        raise IndefiniteError(
            f"isomorphisms of orders in {first.algebra}, which is indefinite, are decided where every ideal "
            "of the field has a generator that is positive where the algebra ramifies"
        )
    one, other = gorenstein_closure(first), gorenstein_closure(second)
    if not (is_eichler(one) and is_eichler(other)):
        raise UndecidedError(
            "whether two orders of an indefinite algebra are isomorphic is decided where their Gorenstein "
            "closures are Eichler orders, and one of these is not"
        )
    bridge = connecting(one, other)
    found = element_generating(bridge, bridge.norm, one)
    if found.element is None:
        return found
    return Verdict(True, conjugates, found.element.inverse())
