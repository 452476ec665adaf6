"""Which left orders of the classes are isomorphic: the types of the genus.

For a maximal or an Eichler order they are the orbits of the two-sided ideals on the classes (Voight,
*Quaternion Algebras*, section 17.4).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.factorisation import factorise
from hfield.lattices.two_sided_ideals import generators, is_maximal_or_eichler

if TYPE_CHECKING:
    from hfield.lattices.classes import ClassSet
    from hfield.lattices.order import Order


def types(classes: ClassSet) -> list[int]:
    """Return the number of the type of each class."""
    known = [-1] * len(classes)
    parts = factorise(classes.order._discriminant)
    if not all(is_maximal_or_eichler(classes.order, p, e) for p, e in parts.items()):
        return types_by_isomorphism(classes)
    ideals = generators(classes.order)
    kinds = 0
    for start in range(len(classes)):
        if known[start] >= 0:
            continue
        known[start], todo = kinds, [start]
        while todo:
            lattice = classes._lattices[todo.pop()]
            for ideal in ideals:
                n = classes._index(lattice._product(ideal))
                if known[n] < 0:
                    known[n] = kinds
                    todo.append(n)
        kinds += 1
    return known


def types_by_isomorphism(classes: ClassSet) -> list[int]:
    """Return the same for any order, found by comparing left orders in pairs."""
    found: list[Order] = []
    kinds: list[int] = []
    for order in classes.left_orders():
        known = next((n for n, other in enumerate(found) if order.isomorphism(other)), None)
        if known is None:
            known = len(found)
            found.append(order)
        kinds.append(known)
    return kinds
