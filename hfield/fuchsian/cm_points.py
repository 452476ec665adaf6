"""Optimal embeddings of quadratic orders in an order that acts on the hyperbolic plane, and CM points.

An embedding of the quadratic order S of discriminant d is given by the image s of √d, an element of trace 0
with s² = d. The images are the primitive elements of norm −d in the lattice Λ, the trace-0 part of ℤ + 2O
(Voight, *Quaternion Algebras*, section 30.3). For d < 0 such an s fixes a point of the plane, a CM point; for
d > 0 it has an axis. Each orbit under the units of norm 1 has a point in a fundamental domain, or an axis
that meets it. The domain is covered by balls. For the ball of radius r around the point of c, the form

    T(s) = 2·ℓ² / N(c) − N(s),   ℓ = tr(s·conj(c)) / 2,

is positive definite, and T(s) = |d|·cosh(2·δ), where δ is the distance of the point or axis of s from the
point of c. So the elements with T(s) ≤ |d|·cosh(2r) are enumerated, and those that meet the domain are
compared exactly. At a cusp the domain is cut: no CM point lies so near to it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from flint import fmpq, fmpq_mat, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, TooLargeError, shorten
from hfield.fuchsian.geodesics import orbit
from hfield.fuchsian.plane import Vector
from hfield.orders import enumeration

if TYPE_CHECKING:
    from hfield.fuchsian.group import Domain, NormOneGroup
    from hfield.fuchsian.polygon import Polygon
    from hfield.fuchsian.split_order import SplitOrder

RADIUS = 0.9
"""Balls that cover a domain have at most this radius."""
MAX_BALLS = 20_000
MAX_VECTORS = 10**7
"""At most about so many elements are enumerated for one ball."""
MARGIN = 1e-6
"""Bounds that floats give are enlarged by this share."""
PRECISION_BITS = 40
"""The forms of balls are rounded to integers after multiplication by 2 to this power."""

Point = tuple[float, float]
"""A point of Klein's disc around the centre of a plane, in which lines are straight."""


@dataclass(frozen=True)
class CMPoint:
    """A point of the upper half plane that is fixed by the image of a quadratic order of discriminant d < 0.

    ``element`` is the image of (d + √d)/2, ``stabiliser`` a unit that generates, with −1, the units of norm 1
    that fix the point.
    """

    group: NormOneGroup
    discriminant: int
    element: Quaternion
    stabiliser: Quaternion

    def __complex__(self) -> complex:
        from hfield.fuchsian.group import fixed_point

        return fixed_point(self.group.order, self.root)

    @property
    def root(self) -> Quaternion:
        """The image of √d."""
        found: Quaternion = 2 * self.element - self.discriminant
        return found

    def __repr__(self) -> str:
        z = complex(self)
        real = round(z.real, 6) + 0.0  # without a sign of 0
        return f"CM point {real:g} + {round(z.imag, 6):g}i of discriminant {self.discriminant}"


@dataclass(frozen=True)
class TraceZeroLattice:
    """The trace-0 part of ℤ + 2O for an order O over ℤ, by a basis."""

    order: SplitOrder
    basis: tuple[Quaternion, ...]

    @classmethod
    def of(cls, order: SplitOrder) -> TraceZeroLattice:
        """Return the lattice of an order, the elements 2x − tr(x)."""
        rows = fmpq_mat([order.flat(2 * x - x.trace()) for x in order.basis])
        whole, below = rows.numer_denom()
        hermite = whole.hnf().tolist()
        units = order.algebra.basis
        basis = tuple(
            sum((e * fmpq(c, below) for e, c in zip(units, row, strict=True)), 0 * units[0])
            for row in hermite
            if any(row)
        )
        return cls(order, basis)

    @cached_property
    def norms(self) -> fmpq_mat:
        """The matrix of tr(x·conj(y))/2, of which the norm is the quadratic form."""
        scalar = self.order.scalar
        return fmpq_mat(
            [[scalar((x * y.conjugate()).trace()) / 2 for y in self.basis] for x in self.basis]
        )

    def element(self, row: Sequence[int]) -> Quaternion:
        """Return the element with these coordinates."""
        return sum((x * c for x, c in zip(self.basis, row, strict=True)), 0 * self.basis[0])

    def majorant(self, center: Quaternion) -> tuple[fmpz_mat, fmpz_mat, int]:
        """Return T on a reduced basis as an integer matrix, the steps to this basis, and its denominator."""
        scalar = self.order.scalar
        column = fmpq_mat([[scalar((x * center.conjugate()).trace()) / 2] for x in self.basis])
        form = column * column.transpose() * (2 / scalar(center.norm())) - self.norms
        whole, below = form.numer_denom()
        reduced, steps = whole.lll(transform=True, rep="gram")
        return reduced, steps, int(below)


def roots(domain: Domain, d: int) -> Iterator[tuple[Quaternion, Vector]]:
    """Yield the images s of √d for all optimal embeddings whose point lies in a domain, or whose axis may meet it.

    Each with its vector in the plane of the domain. Of s and −s one is given: for d < 0 that on the sheet of the
    centre. Raises :class:`TooLargeError`.
    """
    plane = domain.polygon.plane
    lattice, seen = TraceZeroLattice.of(domain.group.order), set()
    for center, radius in balls(domain, lattice, abs(d)):
        gram, steps, below = lattice.majorant(center)
        bound = math.floor(abs(d) * math.cosh(2 * radius) * (1 + MARGIN) * below)
        rows = [list(map(int, row)) for row in gram.tolist()]
        if enumeration.volume(rows, bound, 3) > MAX_VECTORS:
            raise TooLargeError(f"too many elements of norm {-d} would be enumerated")
        norm = steps * lattice.norms * steps.transpose()
        for x, value in enumeration.short_vectors(rows, bound):
            row = fmpz_mat([list(x)])
            if (row * norm * row.transpose())[0, 0] != -d or math.gcd(*x) != 1:
                continue
            s = lattice.element([int(c) for c in (row * steps).entries()])
            s, v = _on_sheet(domain.polygon, s)
            if v not in seen:
                seen.add(v)
                yield s, v


def cm_points(group: NormOneGroup, d: int) -> tuple[CMPoint, ...]:
    """Return the CM points of discriminant d < 0, one of each orbit, by the places of their points.

    Raises :class:`LatticeError` for a d that is no negative discriminant, :class:`TooLargeError`.
    """
    if not isinstance(d, int) or d >= 0 or d % 4 > 1:
        raise LatticeError(
            f"{shorten(d)} is no discriminant of an imaginary quadratic order: expected an integer below 0 that "
            "is 0 or 1 modulo 4, such as -4 or -23"
        )
    polygon = group.domain().polygon
    found: list[CMPoint] = []
    seen: set[Vector] = set()
    for s, v in roots(group.domain(), d):
        if v in seen or polygon.beyond(v) is not None:
            continue
        around = [s / 2] if d == -4 else [(1 + s) / 2] if d == -3 else []
        if any(form[0] * v[0] + form[1] * v[1] + form[2] * v[2] == 0 for form in polygon.forms):
            seen.update(
                orbit(polygon, s).units
            )  # on the boundary: its images there are no other points
        found.append(
            CMPoint(group, d, (d + s) / 2, around[0] if around else group.order.algebra(1))
        )
    return tuple(
        sorted(found, key=lambda point: (round(complex(point).real, 9), complex(point).imag))
    )


# --- Atkin–Lehner involutions ------------------------------------------------------------------------


def involution(group: NormOneGroup, m: int, point: CMPoint) -> CMPoint:
    """Return the image of a CM point under an Atkin–Lehner involution, among those of :func:`cm_points`.

    Raises :class:`LatticeError` where m is no exact divisor of the discriminant of an Eichler order.
    """
    polygon, w = group.domain().polygon, _normalising(group, m)
    image = w * point.root * w.inverse()
    images = orbit(polygon, image).units
    for other in cm_points(group, point.discriminant):
        if _on_sheet(polygon, other.root)[1] in images:
            return other
    raise ArithmeticError("the image of a CM point is none of those that were found")


def fixed_points(group: NormOneGroup, m: int) -> tuple[CMPoint, ...]:
    """Return the CM points that an Atkin–Lehner involution with m > 1 fixes (A. Ogg, 1983).

    Their discriminants are −4m, −m, and −4 where m is 2: elements of norm m that fix a point have the trace
    0, 2 or 3.
    """
    discriminants = [-4 * m] + [-m] * (m % 4 == 3) + [-4] * (m == 2)
    points = [point for d in discriminants for point in cm_points(group, d)]
    return tuple(point for point in points if involution(group, m, point) == point)


def _normalising(group: NormOneGroup, m: int) -> Quaternion:
    from hfield.fuchsian.normaliser import generator

    ((basis, norm),) = group.order.normalising([m])
    return generator(group.order, basis, norm)


def _on_sheet(polygon: Polygon, s: Quaternion) -> tuple[Quaternion, Vector]:
    """Return s or −s with its vector, that on the sheet of the centre."""
    v = polygon.plane.vector(s)
    if polygon.plane.order.sign(v[0]) < 0:
        return -s, (-v[0], -v[1], -v[2])
    return s, v


# --- balls that cover a domain -----------------------------------------------------------------------


def balls(
    domain: Domain, lattice: TraceZeroLattice, size: int
) -> Iterator[tuple[Quaternion, float]]:
    """Yield balls, by elements that fix their centres and radii, that cover a domain.

    At a cusp the part is left out in which no primitive element of the lattice with the norm ``size`` has its
    point.
    """
    plane = domain.polygon.plane
    corners = [_corner(domain, lattice, size, n) for n in range(len(domain.polygon.starts))]
    triangles: list[tuple[Point, Point, Point]] = []
    for n, (p, cut) in enumerate(corners):
        q, cut_next = corners[(n + 1) % len(corners)]
        path = [p if cut is None else _before(p, cut, (0.0, 0.0))]
        if cut is not None:
            path.append(_before(p, cut, q))
        if cut_next is not None:
            path += [_before(q, cut_next, p), _before(q, cut_next, (0.0, 0.0))]
        else:
            path.append(q)
        triangles += [((0.0, 0.0), path[k], path[k + 1]) for k in range(len(path) - 1)]
    count = 0
    while triangles:
        triangle = triangles.pop()
        center = (sum(p[0] for p in triangle) / 3, sum(p[1] for p in triangle) / 3)
        radius = max(_distance(center, p) for p in triangle)
        if radius > RADIUS:
            triangles += _halves(triangle)
            continue
        count += 1
        if count > MAX_BALLS:
            raise TooLargeError(
                f"the domain is so large that more than {MAX_BALLS} balls would cover it"
            )
        disc = complex(*center) / (1 + math.sqrt(1 - abs(complex(*center)) ** 2))
        c = plane.nearby(disc, 20)
        x, y, z = plane.floats(plane.vector(c))
        moved = (y / x, z / x)
        yield c, max(_distance(moved, p) for p in triangle) * (1 + MARGIN) + MARGIN


def _corner(
    domain: Domain, lattice: TraceZeroLattice, size: int, n: int
) -> tuple[Point, float | None]:
    """Return a corner of the domain; with what cuts it off where it is a cusp."""
    plane, start = domain.polygon.plane, domain.polygon.starts[n]
    x, y, z = plane.floats(start)
    if plane.order.sign(plane.norm(start)) != 0:
        return (y / x, z / x), None
    # a null vector ν: tr(s·conj(ν))/2 is a nonzero multiple of g for s in the lattice, if s has positive norm
    null = sum((axis * c for axis, c in zip(plane.axes, start, strict=True)), 0 * plane.center)
    values = [plane.order.scalar((s * null.conjugate()).trace()) / 2 for s in lattice.basis]
    whole, below = fmpq_mat([values]).numer_denom()
    g = fmpq(math.gcd(*map(int, whole.entries())), int(below))
    # with the vectors of the plane so scaled that the first coordinate is 1 and that of c has norm 1
    n0 = plane.order.real(plane.norms[0])
    height = plane.order.real(g) / (x * n0) * math.sqrt(n0) / math.sqrt(size)
    return (y / x, z / x), height * (1 - MARGIN)


def _before(cusp: Point, height: float, start: Point) -> Point:
    """Return the point on the line from a point to a cusp at which the horoball begins."""
    product = 1 - start[0] * cusp[0] - start[1] * cusp[1]
    norm = 1 - start[0] ** 2 - start[1] ** 2
    if norm <= 0:  # from another cusp: from the middle
        return _before(cusp, height, ((start[0] + cusp[0]) / 2, (start[1] + cusp[1]) / 2))
    excess = max(0.0, product**2 - height**2 * norm)
    share = excess / (excess + 2 * height**2 * product)
    return (
        start[0] + share * (cusp[0] - start[0]),
        start[1] + share * (cusp[1] - start[1]),
    )


def _halves(triangle: tuple[Point, Point, Point]) -> list[tuple[Point, Point, Point]]:
    """Return two halves of a triangle, cut at its longest side."""
    k = max(range(3), key=lambda n: _distance(triangle[n], triangle[(n + 1) % 3]))
    p, q, r = triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]
    middle = _middle(p, q)
    return [(p, middle, r), (middle, q, r)]


def _middle(p: Point, q: Point) -> Point:
    """Return the middle of two points in the hyperbolic metric."""
    a, b = (1 / math.sqrt(1 - x * x - y * y) for x, y in (p, q))
    return ((a * p[0] + b * q[0]) / (a + b), (a * p[1] + b * q[1]) / (a + b))


def _distance(p: Point, q: Point) -> float:
    """Return the distance of two points of Klein's disc."""
    product = 1 - p[0] * q[0] - p[1] * q[1]
    norms = (1 - p[0] ** 2 - p[1] ** 2) * (1 - q[0] ** 2 - q[1] ** 2)
    return math.acosh(max(1.0, product / math.sqrt(norms)))
