"""Dirichlet domains of the units of norm 1 of an order, found by search and then proved to be complete.

Elements are looked for, and reduced by one another, until the points nearer to the centre than to its images
under them make a polygon of finite area whose sides are paired (Voight, *J. Théor. Nombres
Bordeaux* 21, 2009;
Page; Rickards). The polygon contains the true domain. By Poincaré's theorem its area is the sum of its exact
angles, and the formula says what that of the true domain is: where they agree, it is the true one.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from flint import fmpq

from hfield.algebra.quaternion import Quaternion
from hfield.errors import TooLargeError
from hfield.fuchsian import polygon, search
from hfield.fuchsian.plane import Motion, Plane, Vector, apply, dot, rational
from hfield.lattices.z_order import ZOrder

CENTER = (fmpq(1), fmpq(0), fmpq(0))
ROUNDS = 2000
"""More points than this are not looked from for units."""


@dataclass(frozen=True)
class Cycle:
    """A vertex up to the group: the sides that lead around it, in order, and its stabiliser's order.

    ``order`` is 0 at a cusp. ``start`` is the vertex where it begins.
    """

    start: int
    sides: tuple[int, ...]
    order: int


class Polygon:
    """The sides of a polygon around the centre of a plane, each halfway to ``g·c`` for a unit g.

    ``units[n]`` is that g, and its inverse maps the side onto side ``partners[n]``.
    """

    def __init__(self, plane: Plane, units: dict[Vector, Quaternion]) -> None:
        self.plane = plane
        # a square around the circle, so that there is always a polygon; no image of the centre has x = −1
        a, b = (fmpq(round(900 * s), 1000) for s in plane.stretch)
        square = [(a, fmpq(0)), (-a, fmpq(0)), (fmpq(0), b), (fmpq(0), -b)]
        lines: dict[Vector, Vector] = {(fmpq(-1), *f): (fmpq(1), *f) for f in square}
        lines |= {x: plane.halfway(x) for x in units}
        every = polygon.bounding(lines)
        sides = [n for n, x in enumerate(every) if x in units]
        corners = polygon.corners([lines[x] for x in every])
        self.images = [every[n] for n in sides]
        self.units = [units[x] for x in self.images]
        self.forms = [lines[x] for x in self.images]
        self.starts = [corners[n] for n in sides]
        self.ends = [corners[(n + 1) % len(corners)] for n in sides]
        self.closed = len(sides) == len(every) and all(plane.norm(x) >= 0 for x in corners)
        self._motions: dict[int, Motion] = {}

    def back(self, n: int) -> Motion:
        """Return what the inverse of a unit does."""
        if n not in self._motions:
            self._motions[n] = self.plane.motion(self.units[n].conjugate())
        return self._motions[n]

    def beyond(self, x: Vector) -> int | None:
        """Return the side beyond which a point lies, nearest to its image of the centre; None inside."""
        least, found = fmpq(0), None
        for n, form in enumerate(self.forms):
            value = dot(form, x)
            if value < least:
                least, found = value, n
        return found

    def reduced(self, x: Vector) -> tuple[Vector, list[int]]:
        """Move a point into the polygon by inverses of units; return it, and by which, in order."""
        path: list[int] = []
        while (n := self.beyond(x)) is not None:
            path.append(n)
            x = apply(self.back(n), x)
        return x, path


def domain(
    order: ZOrder, center: Quaternion, area: Fraction
) -> tuple[Polygon, list[int], list[Cycle]]:
    """Return the domain around a point of trivial stabiliser, the partners of sides, cycles of vertices.

    Raises :class:`TooLargeError` where the search does not find enough units.
    """
    plane = Plane(center)
    units: dict[Vector, Quaternion] = {}
    rng = random.Random(1)
    cosh = 2 + 1.5 * math.sqrt(order.discriminant)
    first = search.carrying(order, center, center, cosh)
    wide = 2 + 2 * float(area)
    for tried in range(ROUNDS):
        _add(plane, units, first)
        found = normalised(plane, units)
        units = dict(zip(found.images, found.units, strict=True))
        if found.closed:
            partners = paired(found)
            cycles = cycles_of(found, partners)
            if area_of(partners, cycles) == area:
                return found, partners, cycles
        batch: list[Quaternion] = []
        for _ in range(4 + tried):
            # evenly by area in a disc with cosh of the radius up to 1 + wide
            height = rng.random() * wide + 1
            radius = math.sqrt((height - 1) / (height + 1))
            target = plane.nearby(cmath.rect(radius, 2 * math.pi * rng.random()))
            batch.extend(search.carrying(order, center, target, cosh))
        first = iter(batch)
        wide = min(1.1 * wide, 100 + 2 * float(area))
    raise TooLargeError(
        f"the domain, of area 2π·{area}, was not completed from {ROUNDS} points; try another center="
    )


def _add(plane: Plane, units: dict[Vector, Quaternion], found: Iterable[Quaternion]) -> None:
    """Add units and their inverses, each by its image of the centre."""
    for g in found:
        for h in (g, g.conjugate()):
            x = plane.vector(h * plane.center * h.conjugate())
            if x != CENTER:
                units.setdefault(x, h)


def normalised(plane: Plane, units: dict[Vector, Quaternion]) -> Polygon:
    """Return the polygon of the group that units generate, or of as much of it as bounds it so far.

    What bounds nothing is reduced by the rest; where a vertex is not mapped into the polygon, a
    unit that cuts
    it off is added.
    """
    while True:
        found = Polygon(plane, units)
        sides = set(found.images)
        new: list[Quaternion] = []
        for x, g in units.items():
            if x not in sides:
                rest, path = found.reduced(x)
                if rest != CENTER:
                    for n in path:
                        g = found.units[n].conjugate() * g
                    new.append(g)
        if not new:
            new = list(_cutting(found))
        if not new:
            return found
        units = {}
        _add(plane, units, [*found.units, *new])


def _cutting(found: Polygon) -> Iterator[Quaternion]:
    """Yield units that cut off vertices which the inverse of a side's unit maps outside."""
    for n, unit in enumerate(found.units):
        for corner in (found.starts[n], found.ends[n]):
            if found.plane.norm(corner) >= 0:
                beyond = found.beyond(apply(found.back(n), corner))
                if beyond is not None:
                    yield unit * found.units[beyond]


def paired(found: Polygon) -> list[int]:
    """Return the partner of each side of a closed polygon, having checked that sides are mapped to sides."""
    place = {x: n for n, x in enumerate(found.images)}
    partners = []
    for n, unit in enumerate(found.units):
        g = unit.conjugate()
        partner = place.get(found.plane.vector(g * found.plane.center * unit))
        if partner is None or not (
            _same_point(apply(found.back(n), found.starts[n]), found.ends[partner])
            and _same_point(apply(found.back(n), found.ends[n]), found.starts[partner])
        ):
            raise ArithmeticError("a side of a normalised polygon has no partner")
        partners.append(partner)
    return partners


def _same_point(x: Vector, y: Vector) -> bool:
    return bool(x[0] * y[1] == x[1] * y[0] and x[0] * y[2] == x[2] * y[0])


def cycles_of(found: Polygon, partners: list[int]) -> list[Cycle]:
    """Return the vertices up to the pairing, with what goes around them, having checked the angles.

    Around a vertex of the plane the angles have the sum 2π/order, the condition of Poincaré's theorem; at a
    cusp what goes around is parabolic.
    """
    left = set(range(len(partners)))
    cycles = []
    while left:
        start = n = min(left)
        path: list[int] = []
        angles = []
        around = found.plane.center.algebra(1)
        while not path or n != start:
            left.discard(n)
            path.append(n)
            angles.append((found.forms[n - 1], found.forms[n]))
            around = found.units[n].conjugate() * around
            n = (partners[n] + 1) % len(partners)
        order = _rotation_order(around)
        cusp = found.plane.norm(found.starts[start]) == 0
        if cusp != (order == 0):
            raise ArithmeticError("what goes around a vertex of the domain does not fix it")
        if not cusp and polygon.turns(found.plane, angles, order) != 1:
            raise ArithmeticError("the angles around a vertex of the domain are more than a turn")
        cycles.append(Cycle(start, tuple(path), order))
    return cycles


def _rotation_order(g: Quaternion) -> int:
    """Return the order, up to the sign, of a unit of norm 1 over ℤ; 0 for a parabolic one."""
    trace = abs(int(rational(g.trace())))
    if g == g.conjugate():
        return 1
    return {0: 2, 1: 3, 2: 0}[trace]


def area_of(partners: list[int], cycles: list[Cycle]) -> Fraction:
    """Return the area of a paired polygon by Gauss and Bonnet, in units of 2π."""
    angles = sum((Fraction(1, c.order) for c in cycles if c.order), Fraction(0))
    return Fraction(len(partners) - 2, 2) - angles
