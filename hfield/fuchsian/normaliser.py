"""The Atkin–Lehner involutions of an Eichler order over ℤ, and the plane modulo the group with some of them.

For pᵉ exactly dividing the discriminant D·N, the two-sided ideal of this norm has a generator w of
positive norm; these generate the normaliser of the order, modulo numbers and the units of norm 1
(Voight, *Quaternion
Algebras*, section 28.9). A domain of the larger group lies in one of the smaller.
"""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, TooLargeError
from hfield.factorisation import factorise
from hfield.fuchsian import dirichlet
from hfield.fuchsian.growing import grown
from hfield.fuchsian.plane import Plane
from hfield.fuchsian.polygon import Polygon
from hfield.fuchsian.search import Rows, Sight, free_centers
from hfield.fuchsian.split_order import RationalOrder
from hfield.lattices import z_lattice
from hfield.lattices.ideals_of_norm import two_sided_prime

CENTERS = 20
"""Centres that are tried at most."""


def involution(order: RationalOrder, m: int) -> Quaternion:
    """Return a primitive element of the order with norm m that normalises it.

    Raises :class:`LatticeError` where m and discriminant/m are not coprime whole numbers.
    """
    whole = order.order.discriminant
    if not isinstance(m, int) or m < 1 or whole % m or math.gcd(m, whole // m) != 1:
        raise LatticeError(
            f"{m} is no exact divisor of {whole}, the discriminant of the order: "
            "an involution belongs to a divisor that is coprime to its cofactor"
        )
    lattice = order.order
    ideals = [two_sided_prime(lattice, p) for p in factorise(m)] if m > 1 else []
    ideal: Any = lattice
    for other in ideals:
        ideal = z_lattice.meet(ideal, other)
    found = Sight(Plane(order, next(free_centers(order))), ideal.basis).of_norm(m)
    if found is None:
        raise TooLargeError(f"no element of norm {m} that normalises the order was found")
    return found


def generated(order: RationalOrder, norms: Sequence[int]) -> dict[int, Quaternion]:
    """Return an element for each product, modulo squares, of exact divisors."""
    found = {1: order.algebra(1)}
    for m in norms:
        if m not in found:
            w = involution(order, m)
            found |= {
                m * n // math.gcd(m, n) ** 2: w * x / math.gcd(m, n) for n, x in found.items()
            }
    return found


class NormaliserSight(Sight):
    """Primitive elements of an order that normalise it, as they look from a point, in floats."""

    def motions(self, rows: Rows) -> tuple[Any, Any]:
        """Return a and b of elements, divided by the roots of their norms."""
        a, b = super().motions(rows)
        size = np.sqrt(abs(a) ** 2 - abs(b) ** 2)
        return a / size, b / size

    def times(self, matrices: Any, rows: Rows) -> Rows:
        """Return products without the numbers that divide them."""
        found = super().times(matrices, rows)
        return found // np.gcd.reduce(found, axis=1)[:, None]


def domain(
    order: RationalOrder, elements: dict[int, Quaternion], area: Fraction
) -> dirichlet.Found:
    """Return a domain, proved complete, of the group with these elements; ``area`` is that of the units.

    Raises :class:`TooLargeError` where none was found.
    """
    plane, rng = Plane(order, next(free_centers(order))), random.Random(1)
    rows = np.array(order.rows(list(elements.values()))[1:]).reshape(-1, 4)
    for n in range(CENTERS):
        center = plane.nearby(0.4 * rng.random() * np.exp(6.28j * rng.random()), 5 + n // 4)
        units, _, _ = dirichlet.domain(order, center, area)
        sight = NormaliserSight(units.plane)
        if (abs(sight.motions(rows)[1]) < 1e-6).any():
            continue
        shape = grown(sight, np.array(order.rows(units.units)), rows)
        sides = Polygon(units.plane, [order.element(row) for row in shape.rows.tolist()])
        found = dirichlet.proof(sides.without_points(), area / len(elements))
        if found is not None and all(_normalises(order, g) for g in sides.units):
            return found
    raise TooLargeError(f"no domain of the larger group was completed around {CENTERS} points")


def _normalises(order: RationalOrder, g: Quaternion) -> bool:
    return g in order and all(g * x / g in order for x in order.basis)
