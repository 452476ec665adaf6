"""When two orders are isomorphic, with the element, and ideals that connect two orders.

Isomorphisms of orders are conjugations, hence isometries of the trace-0 parts of ``ℤ + 2O``; conversely such
an isometry, times −1 if it turns the orientation, is a conjugation that maps one order onto the other
(Voight, *Quaternion Algebras*, chapter 22). So in a definite algebra all reduced bases of
one lattice are compared with one of the other, whatever the orders are.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from flint import fmpz_mat

from hfield.errors import LatticeError, UndecidedError
from hfield.factorisation import factorise
from hfield.lattices import hermite, ternary_reduction
from hfield.lattices.answers import STRONG_APPROXIMATION, Answer
from hfield.lattices.as_json import element_json, rows_json
from hfield.lattices.equivalence import element_of_norm, root
from hfield.lattices.maximal_orders import endpoints

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.lattices.lattice import Lattice
    from hfield.lattices.order import Order


def isomorphism(first: Order, second: Order) -> Answer:
    """Return an answer with an element x such that ``x·first·x⁻¹ = second``.

    Raises :class:`UndecidedError` for orders of an indefinite algebra that are not Eichler orders, unless
    they are equal or their discriminants differ.
    """
    first._same(second, "compare")
    evidence: dict[str, Any] = {
        "kind": "isomorphic-orders",
        "algebra": str(first.algebra),
        "first": rows_json(first),
        "second": rows_json(second),
    }

    lattices = (first, second)

    def yes(x: Quaternion, reason: str) -> Answer:
        evidence["element"] = element_json(x)
        return Answer(True, reason, x, evidence=evidence, lattices=lattices)

    def no(reason: str) -> Answer:
        return Answer(False, reason, evidence=evidence, lattices=lattices)

    if first == second:
        return yes(first.algebra(1), "they are equal")
    if first._discriminant != second._discriminant:
        reason = f"their discriminants are {first._discriminant} and {second._discriminant}"
        return no(reason)
    if first._regular.definite:
        row, reason = _conjugator(first, second)
        if row is None:
            return no(reason)
        x = first._element(row, 1)
        return yes(x, "the element conjugates one into the other")
    if first.conductor() != second.conductor():
        return no("their conductors differ")
    first, second = first.gorenstein_closure(), second.gorenstein_closure()
    if not (first.is_eichler() and second.is_eichler()):
        raise UndecidedError(
            "whether two orders of an indefinite algebra are isomorphic is decided where their "
            "Gorenstein closures are Eichler orders, and one of these is none"
        )
    bridge = connecting_ideal(first, second)
    found, reason = element_of_norm(bridge, bridge._norm)
    if found is not None:
        return yes(found.inverse(), "the element conjugates one into the other")
    return Answer(
        True, f"{reason}, but there is one", None, STRONG_APPROXIMATION, evidence, lattices
    )


def _conjugator(first: Order, second: Order) -> tuple[list[int] | None, str]:
    """Return a primitive row x with ``x·first = second·x``, or None and why."""
    den, rows, gram = first._reduced_ternary
    other_den, other_rows, other_gram = second._reduced_ternary
    steps, form = next(ternary_reduction.reduced_bases(gram))
    images = list(ternary_reduction.reduced_bases(other_gram))
    least, other_least = form[0] // 2, images[0][1][0] // 2
    if least != other_least:
        return None, (
            f"the least norm in the trace-0 part of ℤ + 2O is {least} for one and {other_least} for the other"
        )
    found = next((image for image, own in images if own == form), None)
    if found is None:
        return None, (
            f"none of the {len(images)} bases of the trace-0 part of ℤ + 2O that are reduced after Korkine "
            "and Zolotarev has the inner products that one has for the other order"
        )
    sources, targets = fmpz_mat(steps) * rows, fmpz_mat(found) * other_rows
    return _conjugating(first, sources * other_den, targets * den), ""


def _conjugating(order: Order, sources: fmpz_mat, targets: fmpz_mat) -> list[int]:
    """Return x ≠ 0 with x·s = ±t·x for the three rows s and t, one sign for all."""
    r = order._regular
    s, t = hermite.tuples(sources), hermite.tuples(targets)
    for sign in (1, -1):
        columns = [r.right_matrix(u) - r.left_matrix(v) * sign for u, v in zip(s, t, strict=True)]
        stacked = [x for m in columns for x in m.transpose().entries()]
        kernel, rank = fmpz_mat(12, 4, stacked).nullspace()
        if rank:
            x = [int(kernel[n, 0]) for n in range(4)]
            content = math.gcd(*x)
            return [n // content for n in x]
    raise AssertionError("an isometry, or its negative, is a conjugation")


def connecting_ideal(first: Order, second: Order) -> Lattice:
    """Return the primitive integral ideal with left order ``first`` and right order ``second``.

    For maximal orders it is the only one up to two-sided ideals. Raises :class:`LatticeError` unless both
    are Eichler orders of one level.
    """
    first._same(second, "connect")
    if first._discriminant != second._discriminant or not (
        first.is_eichler() and second.is_eichler()
    ):
        raise LatticeError(
            "connecting ideals exist here between Eichler orders of one level, and these are none"
        )
    ideals = [x._product(y) for x, y in zip(_ends(first), _ends(second), strict=True)]
    if first.level == 1:
        found = ideals[0]
    else:
        # locally both are generated by one element, up to numbers
        scale = root(ideals[0]._norm / ideals[1]._norm)
        if scale is None:
            raise AssertionError("the distances of the two ends have the same parity")
        found = ideals[0] & ideals[1]._scaled(scale)
    return _primitive(found, first)


def _ends(order: Order) -> list[Lattice]:
    """Return two maximal orders with the given one as their intersection."""
    ends: list[Lattice] = [order, order]
    for p, e in factorise(order.level).items():
        # locally at p the sum is the end at p, as all other summands are the order there
        ends = [x + y for x, y in zip(ends, endpoints(order, p, e), strict=True)]
    return ends


def _primitive(lattice: Lattice, order: Order) -> Lattice:
    """Return the multiple of an ideal that is integral and divisible by no integer."""
    m = hermite.multiple(order._den, order._matrix, lattice._den, lattice._matrix)
    return lattice._scaled(1 / m)
