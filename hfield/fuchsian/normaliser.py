"""Elements of positive norm that normalise an Eichler order, and quotients of the plane by them.

An element x normalises the order if and only if x·O is a two-sided ideal: an ideal of the field times a
product of the two-sided primes over the discriminant. By strong approximation such an ideal has a generator
of norm n for every totally positive n that generates the norm of the ideal (Voight, *Quaternion Algebras*,
sections 28.5 and 28.9). Modulo scalars and units of norm 1 the normalising elements form a group of exponent
2. A domain of the larger group lies in one of the smaller.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property

import numpy as np

from hfield.algebra.quaternion import Quaternion
from hfield.errors import TooLargeError
from hfield.fuchsian import dirichlet
from hfield.fuchsian.plane import Plane
from hfield.fuchsian.polygon import Polygon
from hfield.fuchsian.search import Rows, Sight, element_of_norm, free_centers
from hfield.fuchsian.side_search import enlarge_polygon
from hfield.fuchsian.split_order import SplitOrder
from hfield.orders.base_values import BaseNumber

CENTERS = 20
"""Centres that are tried at most."""
CENTERS_BEFORE_TEST = 3
"""So many may see too little of the plane for a domain of the units."""
MAX_COORDINATES = 128
"""Coordinates of an element of the larger group, over all cosets, at most."""


def generator(order: SplitOrder, basis: Sequence[Quaternion], norm: BaseNumber) -> Quaternion:
    """Return an element of a two-sided ideal with the given norm, a number that generates the norm of the
    ideal.

    Raises :class:`TooLargeError` if none was found.
    """
    found = element_of_norm(order, basis, order.scalar(norm))
    if found is None or not all(found * x / found in order for x in order.basis):
        raise TooLargeError(f"no element of norm {norm} that normalises the order was found")
    return found


class Cosets:
    """The elements that normalise an order, or those of some norms, modulo scalars and units of norm 1.

    Coset n is represented by ``elements[n]``, an element of the order; the product of cosets m and n is
    number m ^ n. An element of the larger group is, up to a scalar, a representative times a unit. Its row
    has the coordinates of the unit in the block of its coset, and 0 in the other blocks.
    """

    def __init__(self, polygon: Polygon, norms: Sequence[object]) -> None:
        """``polygon`` is a domain of the units of norm 1; representatives are chosen to move its centre
        inside it.
        """
        self.order = order = polygon.plane.order
        self.elements = [order.algebra(1)]
        for basis, norm in order.normalising(norms):
            g = generator(order, basis, norm)
            if not any(self._same(g, w) for w in self.elements):
                for w in tuple(self.elements):
                    x = order.primitive(g * w)
                    for n in polygon.reduced(polygon.plane.image(x))[1]:
                        x = polygon.units[n].conjugate() * x
                    self.elements.append(x)
        self.size = len(order.basis)
        if self.size * len(self.elements) > MAX_COORDINATES:
            raise TooLargeError(
                f"the group is of index {len(self.elements)} in the larger one: up to "
                f"{MAX_COORDINATES // self.size} are within reach in this field, and quotient() takes norms"
            )

    def _same(self, x: Quaternion, y: Quaternion) -> bool:
        z = x / y
        root = self.order.root(self.order.scalar(z.norm()))
        return root is not None and z / root in self.order

    def block(self, n: int, rows: Rows | list[list[int]]) -> Rows:
        """Return coordinates in coset n of an element given by its coordinates in the order."""
        found = np.zeros((len(rows), len(self.elements), self.size), dtype=np.int64)
        found[:, n] = rows
        return found.reshape(len(rows), -1)

    def element(self, row: Rows) -> Quaternion | None:
        """Return the element with these coordinates, or None if it is not in the coset."""
        blocks = row.reshape(-1, self.size)
        n = int(abs(blocks).sum(axis=1).argmax())
        unit = self.order.element(blocks[n].tolist())
        return self.elements[n] * unit if unit.norm() == 1 else None

    @cached_property
    def products(self) -> Rows:
        """The products of the basis: (w·x)·(w'·y) is a scalar times w''·(w''⁻¹·w·x·w'·y)."""
        order, found = self.order, []
        norms = [order.scalar(w.norm()) for w in self.elements]
        table = np.array(order.products).reshape((self.size,) * 3)
        for m, w in enumerate(self.elements):
            for n, v in enumerate(self.elements):
                u = self.elements[m ^ n]
                number = order.root(norms[m] * norms[n] / norms[m ^ n])
                left = np.array(order.rows([u.inverse() * w * x * v / number for x in order.basis]))
                rows = np.einsum("ix,xjk->ijk", left, table).reshape(-1, self.size)
                found.append(self.block(m ^ n, rows).reshape(self.size, self.size, -1))
        count = len(self.elements)
        whole = np.array(found).reshape(count, count, self.size, self.size, -1)
        return whole.transpose(0, 2, 1, 3, 4).reshape((self.size * count,) * 3)

    @cached_property
    def bar(self) -> Rows:
        """The conjugates of the basis, which are inverses up to scalars."""
        found = [
            self.block(
                n, self.order.rows([w.inverse() * (w * x).conjugate() for x in self.order.basis])
            )
            for n, w in enumerate(self.elements)
        ]
        return np.concatenate(found)


class CosetSight(Sight):
    """Elements of cosets, scaled to norm 1, in floats, as seen from a point of the plane."""

    def __init__(self, plane: Plane, cosets: Cosets) -> None:
        super().__init__(plane)
        a, b = self.motions(np.array(plane.order.rows(cosets.elements)))
        a, b = np.array([a, b])[:, :, None] / np.sqrt(abs(a) ** 2 - abs(b) ** 2)[:, None]
        self.a, self.b = (
            (a * self.a + b * self.b.conj()).reshape(-1),
            (a * self.b + b * self.a.conj()).reshape(-1),
        )
        self.other_norms = np.asarray(np.kron(np.eye(len(a))[None], self.other_norms), dtype=float)
        self.products, self.bar, self.rank = cosets.products, cosets.bar, len(self.a)


def domain(cosets: Cosets, area: Fraction) -> dirichlet.Found:
    """Return a domain, proved complete, of the group of cosets; ``area`` is the area for the units of norm 1.

    Raises :class:`TooLargeError` if none was found.
    """
    order, count = cosets.order, len(cosets.elements)
    plane, rng = Plane(order, next(free_centers(order))), random.Random(1)
    one = order.rows([order.algebra(1)])
    new = np.concatenate([cosets.block(n, one) for n in range(count)])[1:]
    for n in range(CENTERS):
        center = plane.nearby(0.4 * rng.random() * np.exp(6.28j * rng.random()), 5 + n // 4)
        try:
            units, partners, cycles = dirichlet.domain(order, center, area)
        except TooLargeError:  # some centres see the plane worse than others
            if n >= CENTERS_BEFORE_TEST:
                raise
            continue
        if count == 1:
            return units, partners, cycles
        sight = CosetSight(units.plane, cosets)
        if (abs(sight.motions(new)[1]) < 1e-6).any():
            continue
        shape = enlarge_polygon(sight, cosets.block(0, order.rows(units.units)), new)
        elements = [g for row in shape.rows if (g := cosets.element(row)) is not None]
        sides = Polygon(units.plane, elements)
        found = dirichlet.proof(sides.without_points(), area / count)
        if found is not None:
            return found
    raise TooLargeError(f"no domain of the larger group was completed around {CENTERS} points")
