"""Conjugacy and centralisers in a group of units of norm 1, and closed geodesics of its quotient.

An element x that is not a scalar fixes a point of the plane or an axis, that of its part v of trace 0. Only
finitely many of its conjugates have a point or axis that meets a Dirichlet domain. One reaches them all from
one of them across the sides that the point or axis meets. So two elements are conjugate if and only if they
share one of these conjugates, and the closed paths generate the centraliser. All this is exact. Closed
geodesics up to a given length come from units that move the centre by a bounded distance. These units are
enumerated tile by tile, in floats with a margin, and then compared exactly.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import acosh, cosh
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, TooLargeError, shorten
from hfield.fuchsian.dirichlet import rotation_order
from hfield.fuchsian.plane import Vector, apply, dot
from hfield.fuchsian.polygon import Polygon
from hfield.fuchsian.search import Rows, Sight, distinct

if TYPE_CHECKING:
    from hfield.fuchsian.group import Domain

MAX_CONJUGATES = 20_000
"""Conjugates of one element that meet the domain, at most."""
TILES = 1_000_000
"""Images of the domain, at most, among which closed geodesics are looked for."""
MARGIN = 1e-6


class Geodesic(NamedTuple):
    """A closed geodesic of the quotient, traversed once, without direction.

    ``element`` is a unit that translates along it, ``length`` is approximately 2·arccosh(\\|trace\\|/2).
    """

    length: float
    element: Quaternion


@dataclass(frozen=True)
class Orbit:
    """The conjugates of an element that meet a domain, by their vectors, with the conjugating units.

    ``around`` are units that commute with the element; with −1 they generate its centraliser in the units of
    norm 1.
    """

    units: dict[Vector, Quaternion]
    around: list[Quaternion]


def orbit(polygon: Polygon, x: Quaternion) -> Orbit:
    """Return the conjugates of x that meet a domain.

    Raises :class:`LatticeError` for a scalar, a parabolic element, and an axis that ends at cusps, and
    :class:`TooLargeError`.
    """
    v = polygon.plane.vector(x - x.trace() / 2)
    sign = polygon.plane.order.sign(polygon.plane.norm(v))
    if sign == 0:
        raise LatticeError(
            f"{shorten(x)} fixes neither a point of the plane nor an axis: expected an element that is "
            "neither a scalar nor parabolic"
        )
    if sign < 0 and x.algebra.ring.is_square(x.trace() * x.trace() - 4 * x.norm()):
        raise LatticeError(f"the axis of {shorten(x)} ends at cusps, and no unit moves along it")
    _, path = polygon.reduced(_point(polygon, v, sign))
    start: Quaternion = x.algebra(1)
    for n in path:
        v, start = apply(polygon.back(n), v), polygon.units[n].conjugate() * start
    units, waiting, around = {v: start}, [v], []
    while waiting:
        v = waiting.pop()
        for n in _met(polygon, v, sign):
            image, unit = apply(polygon.back(n), v), polygon.units[n].conjugate() * units[v]
            if image not in units:
                units[image] = unit
                waiting.append(image)
            else:
                around.append(units[image].conjugate() * unit)
        if len(units) > MAX_CONJUGATES:
            raise TooLargeError(
                f"more than {MAX_CONJUGATES} conjugates of {shorten(x)} meet the domain"
            )
    return Orbit(units, [u for u in around if u != u.conjugate()])


def stabiliser(polygon: Polygon, x: Quaternion) -> Quaternion:
    """Return a unit that generates, with −1, the units of norm 1 with the fixed point of x."""
    return generator_of_rotations(polygon, orbit(polygon, x))


def generator_of_rotations(polygon: Polygon, images: Orbit) -> Quaternion:
    """Return the unit of greatest order among those that fix a point, or 1."""
    order = polygon.plane.order
    return max(images.around, key=lambda u: rotation_order(order, u), default=order.algebra(1))


def _point(polygon: Polygon, v: Vector, sign: int) -> Vector:
    """Return the fixed point, or the point of the axis that is nearest to the centre."""
    if sign > 0:
        upper = polygon.plane.order.sign(v[0]) > 0
        return v if upper else (-v[0], -v[1], -v[2])
    # c less its part along v, which is orthogonal to the axis
    n = polygon.plane.norms[0] * v[0] / polygon.plane.norm(v)
    return (1 - n * v[0], -n * v[1], -n * v[2])


def _met(polygon: Polygon, v: Vector, sign: int) -> Iterator[int]:
    """Yield the closed sides that the axis meets, or on which the fixed point in the domain lies."""
    if sign > 0:
        yield from (n for n, form in enumerate(polygon.forms) if dot(form, v) == 0)
        return
    a, b, c = polygon.plane.norms
    form = (a * v[0], b * v[1], c * v[2])
    signs = [polygon.plane.order.sign(dot(form, x)) for x in polygon.starts]
    yield from (n for n, s in enumerate(signs) if s * signs[(n + 1) % len(signs)] <= 0)


def axis_meets(polygon: Polygon, v: Vector) -> bool:
    """Return whether the axis of an element of trace 0 meets the polygon."""
    return any(True for _ in _met(polygon, v, -1))


def conjugating_unit(polygon: Polygon, x: Quaternion, y: Quaternion) -> Quaternion | None:
    """Return a unit u of norm 1 with ``u·x·u⁻¹ == y``, or None if there is none."""
    if x == y:
        found: Quaternion = x.algebra(1)
        return found
    if x.trace() != y.trace() or x.norm() != y.norm() or x == x.conjugate():
        return None
    here, there = orbit(polygon, x).units, orbit(polygon, y).units
    for v, unit in here.items():
        if v in there:
            return there[v].conjugate() * unit
    return None


def fundamental_unit(polygon: Polygon, x: Quaternion) -> Quaternion:
    """Return the unit that generates, with −1, the units of norm 1 that commute with a hyperbolic element.

    The unit, its inverse and their negatives all qualify; one of positive trace is returned. Raises
    :class:`LatticeError`.
    """
    order = polygon.plane.order
    if order.sign(order.scalar(x.trace() * x.trace() - 4 * x.norm())) <= 0:
        raise LatticeError(
            f"{shorten(x)} has no axis: expected an element with trace² − 4·norm > 0 at the place that splits"
        )

    def size(u: Quaternion) -> float:
        return abs(order.real(order.scalar(u.trace())))

    units = orbit(polygon, x).around
    # all are powers of one, and of two the larger becomes smaller, as in Euclid's algorithm
    while True:
        units.sort(key=size)
        least, rest = units[0], units[1:]
        if not rest:
            break
        smaller = [min(u * least, u * least.conjugate(), key=size) for u in rest]
        units = [least, *(u for u in smaller if u != u.conjugate())]
    return least if order.sign(order.scalar(least.trace())) > 0 else -least


def closed(domain: Domain, most: float) -> tuple[Geodesic, ...]:
    """Return the closed geodesics up to a given length, ordered by length.

    Raises :class:`LatticeError` if there are cusps, and :class:`TooLargeError`.
    """
    polygon, order = domain.polygon, domain.group.order
    if any(cycle.order == 0 for cycle in domain.cycles):
        raise LatticeError(
            "closed geodesics are listed for groups without cusps; traces() gives the lengths"
        )
    found: list[Geodesic] = []
    seen: set[Vector] = set()
    for g in _hyperbolic(domain, most):
        v = polygon.plane.vector(g - g.conjugate())
        if _axis(v) in seen or not axis_meets(polygon, v):
            continue
        # of those with this axis, g is the first, and so moves least
        seen.update(map(_axis, orbit(polygon, g).units))
        length = 2 * acosh(abs(order.real(order.scalar(g.trace()))) / 2)
        found.append(Geodesic(length, g))
    return tuple(found)


def _axis(v: Vector) -> Vector:
    """Return a normal form that is the same for all multiples of a vector."""
    first = next(c for c in v if c != 0)
    return (v[0] / first, v[1] / first, v[2] / first)


def _hyperbolic(domain: Domain, most: float) -> list[Quaternion]:
    """Return hyperbolic units by trace, including all those up to a length whose axes meet the domain.

    A geodesic from a point of the domain to its image lies in tiles whose centres are at most its length plus
    twice the radius of the domain away from the centre.
    """
    plane, order = domain.polygon.plane, domain.group.order
    sight = Sight(plane)
    corners = np.array(domain.vertices)
    radius = float(np.arccosh((1 + abs(corners) ** 2) / (1 - abs(corners) ** 2)).max())
    reach = cosh(most + 2 * radius)
    if (tiles := reach / float(domain.area)) > TILES:
        raise TooLargeError(
            f"closed geodesics of up to the length {most:g} are among {tiles:.0e} images of the domain, and "
            f"at most {TILES} are searched; choose a smaller length"
        )
    klein = 2 * corners / (1 + abs(corners) ** 2)
    bound = 2 * cosh(most / 2) * (1 + MARGIN)
    chosen = []
    for rows in _tiles(sight, np.array(order.rows(domain.polygon.units)), reach):
        a, b = sight.motions(rows)
        size = 2 * abs(a.real)
        right = (size > 2 - MARGIN) & (size < bound)
        rows, a, b = rows[right], a[right], b[right]
        # on the axis of g, the plane's form of g − conj(g) is 0
        value = a.imag[:, None] + (b[:, None] * klein.conj()).imag
        near = (value.min(axis=1) < MARGIN) & (value.max(axis=1) > -MARGIN)
        chosen += rows[near].tolist()
    units = [order.element(row) for row in chosen]
    sized = []
    for g in units:
        t = order.scalar(g.trace())
        if order.sign(t * t - 4) > 0 and (length := abs(order.real(t))) < bound:
            sized.append((length, g if order.sign(t) > 0 else -g))
    return [g for _, g in sorted(sized, key=lambda pair: pair[0])]


def _tiles(sight: Sight, sides: Rows, reach: float) -> Iterator[Rows]:
    """Yield the units that move the centre by a bounded distance, given by its cosh, going across sides."""
    right = np.einsum("nj,ijk->nik", sides, sight.products)
    identity = np.array(sight.plane.order.rows([sight.plane.order.algebra(1)]))
    rows, seen = identity, {tuple(identity[0].tolist())}
    while len(rows):
        found = distinct(np.einsum("ri,nik->rnk", rows, right).reshape(-1, sight.rank))
        b = sight.motions(found)[1]
        found = found[1 + 2 * abs(b) ** 2 <= reach * (1 + MARGIN)]
        fresh = [
            tuple(row) not in seen and tuple(-x for x in row) not in seen for row in found.tolist()
        ]
        rows = found[np.array(fresh, dtype=bool)]
        seen.update(map(tuple, rows.tolist()))
        yield rows
