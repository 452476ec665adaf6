"""Dirichlet domains of the units of norm 1 of an order, found by a float search and then proved complete.

Elements are searched for, and reduced by one another, in floats (``search``, ``side_search``), until they
seem to bound a polygon of finite area with paired sides. Then everything is decided exactly. The points that
are nearer to the centre than to its images under these units form a polygon that contains the true domain. By
Poincaré's theorem its area follows from its exact angles. If it equals the area that the formula gives for
the true domain, the polygon is the true domain (Voight, *J. Théor. Nombres Bordeaux* 21, 2009; Page;
Rickards).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from flint import fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.core.progress import report
from hfield.errors import TooLargeError
from hfield.fuchsian.plane import Plane, apply, same_point
from hfield.fuchsian.polygon import Polygon
from hfield.fuchsian.search import Points, Rows, Sight, distinct, free_centers
from hfield.fuchsian.sector import least_rotation, sector
from hfield.fuchsian.side_search import Shape, enlarge_polygon
from hfield.fuchsian.split_order import SplitOrder
from hfield.orders import maximal_orders
from hfield.orders.invariants import is_eichler

ROUNDS = 50
"""So often at most units are looked for from more points."""
IDLE = 12
"""So many searches in a row that find no new side are the last ones."""
MAX_SEARCHED_INDEX = 30
"""Up to this index units are found quicker by the search."""
MAX_AREA = 1_000
"""In units of 2π: larger domains are not searched, which would take minutes and find too little."""
MAX_COSETS = 3_000
"""Cosets, at most."""
DEEPEST = 1e6
"""Points are this far from the centre at most, by the hyperbolic cosine: floats do not go farther."""


@dataclass(frozen=True)
class VertexCycle:
    """A vertex up to the group: the sides that lead around it, in order, and the order of its stabiliser.

    ``order`` is 0 at a cusp. ``start`` is the first vertex of the cycle.
    """

    start: int
    sides: tuple[int, ...]
    order: int


Found = tuple[Polygon, list[int], list[VertexCycle]]
"""A domain, the partners of its sides, and the cycles of its vertices."""


def domain(
    order: SplitOrder,
    center: Quaternion,
    area: Fraction,
    given: Rows | None = None,
    stabiliser: Quaternion | None = None,
) -> Found:
    """Return the domain around a point, the partners of its sides, and its cycles of vertices.

    ``given`` are the coordinates of units already known. If units other than ±1 fix the point, ``stabiliser``
    is one that generates them with −1, and the domain is a sector.

    Raises :class:`TooLargeError` if the search does not find enough units.
    """
    plane = Plane(order, center)
    sight, turns = Sight(plane), 1
    if stabiliser is not None:
        turns = rotation_order(order, stabiliser)
        stabiliser = least_rotation(plane, stabiliser, turns)
        sight.turn_about_center(stabiliser, turns)
    rng = np.random.default_rng(1)
    shape = enlarge_polygon(
        sight, sight.empty, sight.carrying(np.zeros(1)) if given is None else given
    )
    total, known, idle = float(area), 0, 0
    for _ in range(ROUNDS):
        idle = 0 if len(shape.rows) > known else idle + 1
        if idle == IDLE:
            break
        known = max(known, len(shape.rows))
        report(min(known / (5.5 * total + 10), 0.99), 1, "the domain")
        shape = enlarge_polygon(sight, shape.rows, sight.carrying(places(shape, float(area), rng)))
        # at cusps rounding may add a side that only touches, and its angles to the area
        if shape.closed and (order.cusps() != 0 or abs(shape.area() / turns - total) < 0.02):
            sides = Polygon(plane, [order.element(row) for row in shape.rows.tolist()])
            proved = proof(sides.without_points(), area, stabiliser)
            if proved is not None and all(g.norm() == 1 for g in sides.units):
                report(1, 1, "the domain")
                return proved
    report(1, 1, "the domain")
    raise TooLargeError(
        f"the domain, of area 2π·{area}, has more sides than the {known} that were found; groups of an area "
        "up to 2π·200 are within reach, and perhaps another center= helps"
    )


def order_above(order: SplitOrder) -> SplitOrder | None:
    """Return a maximal order above a non-Eichler order over ℤ of large index; None for other orders.

    Raises :class:`TooLargeError` if the index or the search space is too large.
    """
    found, index = None, Fraction(1)
    if order.base.is_rational and not is_eichler(order.order):
        found = SplitOrder(maximal_orders.overorder(order.order))
        index = order.area() / found.area()
    if index > MAX_COSETS:
        raise TooLargeError(
            f"the group is of index {index} in that of a maximal order: domains are found up to "
            f"{MAX_COSETS}"
        )
    if index > MAX_SEARCHED_INDEX:
        return found
    if order.area() > MAX_AREA:
        raise TooLargeError(
            f"the domain, of area 2π·{order.area()}, is too large: groups of an area up to 2π·200 are within "
            f"reach, and none above 2π·{MAX_AREA} is tried"
        )
    return None  # the search finds what is needed


def generators_by_cosets(order: SplitOrder, above: SplitOrder) -> Rows:
    """Return generators of the group of an order in a maximal one, in coordinates of the smaller order.

    The images of the larger group's domain under coset representatives form a domain of the smaller group.
    The elements that map one of these images to a neighbour of another generate the smaller group (Schreier).
    """
    polygon, _, _ = domain(above, next(free_centers(above)), above.area())
    sight = Sight(polygon.plane)
    sides = np.array(above.rows(polygon.units))
    right = np.einsum("nj,ijk->nik", sides, sight.products)  # x ↦ x·s
    # an element with these coordinates is in the order if row·inside is 0 modulo the denominator
    whole, denominator = fmpz_mat(above.rows(list(order.basis))).inv().numer_denom()
    entries = [[int(c) for c in row] for row in whole.tolist()]
    inside, modulus = np.array(entries, dtype=np.int64), int(denominator)
    tests = np.empty((4, MAX_COSETS, 4), dtype=np.int64)
    cosets: list[Rows] = []
    backs: list[Rows] = []  # for each representative h, x ↦ x·conj(h)
    found: list[Rows] = []

    def add(h: Rows) -> None:
        backs.append(np.einsum("j,ijk->ik", h @ sight.bar, sight.products))
        tests[:, len(cosets)] = backs[-1] @ inside % modulus
        cosets.append(h)

    add(np.array(above.rows([above.algebra(1)])[0]))
    for h in cosets:  # which grows
        for image in h @ right:
            left = (image % modulus @ tests[:, : len(cosets)].reshape(4, -1)) % modulus
            same = np.flatnonzero(~left.reshape(-1, 4).any(axis=1))
            if same.size:
                found.append(image @ backs[same[0]])
            else:
                add(image)
    units = [above.element(row) for row in distinct(np.array(found)).tolist()]
    return np.array(order.rows([u for u in units if u != u.conjugate()]))


def places(shape: Shape, area: float, rng: np.random.Generator) -> Points:
    """Return points of a polygon, in Poincaré's disc, near which to search for further units.

    They lie where the polygon reaches the circle, at a depth at which there are such units, and some are
    spread evenly over the polygon. Points outside the polygon would give nothing new.
    """
    start, width = shape.gaps()
    times = 2 + min(int(area), 64) // max(1, len(width))  # the last ones are hard to close
    start, width = np.tile([start, width], times)
    # a line between the ends of a gap is at a distance with the cosine 1/sin(width/2)
    deep = 1 + 4 * area * rng.random(len(width)) ** 3 / np.sin(np.minimum(width, np.pi) / 2)
    deep = np.minimum(deep, DEEPEST)
    gaps = np.sqrt((deep - 1) / (deep + 1)) * np.exp(1j * (start + width * rng.random(len(width))))
    high = 1 + 4 * area * rng.random(6 if len(width) else 6 + int(area))
    klein = np.sqrt(1 - high**-2) * np.exp(2j * np.pi * rng.random(len(high)))
    points = shape.inside(klein)
    return np.concatenate([points / (1 + np.sqrt(1 - abs(points) ** 2)), gaps])


def proof(found: Polygon, area: Fraction, rotation: Quaternion | None = None) -> Found | None:
    """Return the polygon, the partners of its sides and its cycles of vertices, if it is the whole domain.

    If units fix the centre, the domain is a sector, and ``rotation`` is the unit that turns by the least
    angle.
    """
    if not found.is_closed():
        return None
    if rotation is not None:
        part = sector(found, rotation, rotation_order(found.plane.order, rotation))
        if part is None:
            return None
        found = part
    partners = paired(found)
    if partners is None:
        return None
    cycles = cycles_of(found, partners)
    return (found, partners, cycles) if area_of(partners, cycles) == area else None


def paired(found: Polygon) -> list[int] | None:
    """Return the partner of each side of a closed polygon, or None if some side is not mapped to a side."""
    partners = []
    for n in range(len(found.units)):
        partner = found.partner(n)
        if partner is None or not (
            same_point(apply(found.back(n), found.starts[n]), found.ends[partner])
            and same_point(apply(found.back(n), found.ends[n]), found.starts[partner])
        ):
            return None
        partners.append(partner)
    return partners


def cycles_of(found: Polygon, partners: list[int]) -> list[VertexCycle]:
    """Return the vertex cycles of the side pairing, with checked angle sums.

    Around a vertex of the plane the angles sum to 2π/order, the condition of Poincaré's theorem; at a cusp
    the product around the cycle is parabolic.
    """
    left = set(range(len(partners)))
    cycles = []
    while left:
        start = n = min(left)
        path: list[int] = []
        around = found.plane.center.algebra(1)
        while not path or n != start:
            left.discard(n)
            path.append(n)
            around = found.units[n].conjugate() * around
            n = (partners[n] + 1) % len(partners)
        order = rotation_order(found.plane.order, around)
        cusp = found.plane.norm(found.starts[start]) == 0
        if cusp != (order == 0):
            raise ArithmeticError(
                "the product of the side pairings around a vertex of the domain does not fix it"
            )
        if not cusp and found.turns(path, order) != 1:
            raise ArithmeticError("the angles around a vertex of the domain exceed 2π")
        cycles.append(VertexCycle(start, tuple(path), order))
    return cycles


def rotation_order(order: SplitOrder, g: Quaternion) -> int:
    """Return the order modulo scalars of an element that fixes a point; 0 for a parabolic element.

    Raises :class:`ArithmeticError` for a hyperbolic element. The trace of g is a multiple of a cosine and
    lies in the field. This bounds the order m, because the cosine of 2π/m generates a field of degree φ(m)/2.
    """
    if g == g.conjugate():
        return 1
    excess = order.sign(order.scalar(g.trace() * g.trace() - 4 * g.norm()))
    if excess == 0:
        return 0
    power, m = g, 1
    # the square of g, over its norm, has norm 1 and a trace in the field: φ(m)/2 ≤ 2n for the degree n,
    # and φ(k) ≥ √(k/2)
    while excess < 0 and m <= 2 * len(order.basis) ** 2:
        power, m = power * g, m + 1
        if power == power.conjugate():
            return m
    raise ArithmeticError("a unit that must fix a point has infinite order")


def area_of(partners: list[int], cycles: list[VertexCycle]) -> Fraction:
    """Return the area of a polygon with paired sides, by Gauss and Bonnet, in units of 2π."""
    angles = sum((Fraction(1, c.order) for c in cycles if c.order), Fraction(0))
    return Fraction(len(partners) - 2, 2) - angles
