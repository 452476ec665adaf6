"""Optimal embeddings of quadratic orders in an order that acts on the hyperbolic plane, and CM points.

An embedding of the quadratic order S of discriminant d is given by the image s of √d, an element of trace 0
with s² = d. The images are the primitive elements of norm −d in the lattice Λ, the trace-0 part of R + 2O,
where R is the ring of integers of the base (Voight, *Quaternion Algebras*, section 30.3). If d is negative at
the split place, s fixes a point of the plane, a CM point; if d is positive, s has an axis. Each orbit under
the units of norm 1 has a point in a fundamental domain, or an axis that meets it. The domain is covered by
balls. Consider the ball around the point of c, an element of trace 0 and norm m > 0, and let ℓ =
tr(s·conj(c))/2. The form

    2·ℓ²/m − N(s)

is positive definite at the split place; its value is |d|·cosh(2·δ), where δ is the distance of the point or
axis of s from the point of c. At the other places N(s) = −d is definite. A rational form near the sum of all
these is bounded on the ball, so the elements can be enumerated; over ℤ one coordinate is solved for. Those
that meet the domain are compared exactly. Cusps of the domain are cut off at a height that no such point or
axis reaches.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np
from flint import fmpq, fmpq_mat, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, TooLargeError, shorten
from hfield.fuchsian.geodesics import axis_meets, generator_of_rotations, orbit
from hfield.fuchsian.plane import Plane, Vector, dot
from hfield.fuchsian.search import free_centers
from hfield.fuchsian.upper_half_plane import fixed_point
from hfield.orders import certificates, enumeration
from hfield.orders.invariants import is_eichler, level
from hfield.orders.local_squares import is_maximal_at, is_square_modulo
from hfield.orders.quadratic_orders import is_primitive, multiplications
from hfield.orders.short_elements import ternary_rows
from hfield.orders.ternary_values import vectors_of_value

if TYPE_CHECKING:
    from hfield.evidence import CertifiedClaim
    from hfield.fuchsian.group import Domain, NormOneGroup
    from hfield.fuchsian.polygon import Polygon
    from hfield.fuchsian.split_order import SplitOrder
    from hfield.orders.base_values import BaseNumber, Prime

RADIUS, RADIUS_OVER_FIELDS = 2.2, 0.6
"""Balls that cover a domain have at most this radius, over ℚ and over other fields."""
MAX_BALLS = 20_000
"""At most so many balls cover a domain."""
MAX_VECTORS = 10**7
"""At most about so many elements are enumerated for one ball."""
MARGIN = 1e-6
"""Bounds that floats give are enlarged by this share."""
SLACK = 1e-3
"""The centre of a ball may be moved by this share of the radius."""
FARTHEST, ROUNDING = 1e-12, 1e-15
"""Points of the unit disc are so far from the circle at least, and floats are wrong by so much at most."""
TRIALS = 40
"""So many balls are searched for one embedding before the whole domain is."""
PRECISION = 2**20
"""Numbers of the field with given real values are found up to about the inverse of this."""

Point = tuple[float, float]
"""A point of Klein's disc around the centre of a plane, in which lines are straight."""


@dataclass(frozen=True)
class CMPoint:
    """A point of the upper half plane that is fixed by an embedded quadratic order of discriminant d.

    ``element`` is the image of (t + √d)/2 with t² ≡ d modulo 4; over ℤ, t = d. ``stabiliser`` is a unit that
    generates, with −1, the units of norm 1 that fix the point.
    """

    group: NormOneGroup
    discriminant: BaseNumber
    element: Quaternion
    stabiliser: Quaternion

    def __complex__(self) -> complex:
        return fixed_point(self.group.order, self.root)

    @property
    def root(self) -> Quaternion:
        """The image of √d."""
        found: Quaternion = 2 * self.element - self.element.trace()
        return found

    def __repr__(self) -> str:
        z = complex(self)
        real = round(z.real, 6) + 0.0  # without a sign of 0
        return f"CM point {real:g} + {round(z.imag, 6):g}i of discriminant {self.discriminant}"


class TraceZeroLattice:
    """The trace-0 part of R + 2O for an order O over R, with the forms for the enumeration in balls."""

    def __init__(self, order: SplitOrder) -> None:
        self.order, self.ambient, self.base = order, order.order.ambient, order.base
        self.rows = ternary_rows(order.order)
        self._real = np.array(
            [
                [self.base.real(w, v) for v in self.base.real_places]
                for w in self.base.integral_basis
            ]
        )

    @cached_property
    def basis(self) -> list[Quaternion]:
        """A basis over ℤ."""
        return [self.ambient.quaternion(row) for row in self.rows.tolist()]

    @cached_property
    def norms(self) -> fmpz_mat:
        """The matrix of tr(x·conj(y)) on the basis, over ℤ."""
        one = self.base.element_of([fmpq(1)])
        return (self.rows * self.ambient.form(one) * self.rows.transpose()).numer_denom()[0]

    @cached_property
    def multiplications(self) -> list[fmpz_mat]:
        """The matrices of multiplication by the integral basis of R on the lattice."""
        den = self.rows.numer_denom()[1]
        return multiplications(self.ambient, (self.rows * fmpq(den)).numer_denom()[0])

    def products(self, center: Quaternion) -> list[BaseNumber]:
        """Return tr(s·conj(c))/2 for each basis element s, as numbers of the field."""
        scalar, bar = self.order.scalar, center.conjugate()
        return [scalar((s * bar).trace()) / 2 for s in self.basis]

    def number(self, values: Sequence[float]) -> BaseNumber:
        """Return a number of the field with approximately these values at the real places."""
        digits = np.linalg.solve(self._real.T, np.array(values))
        return self.base.element_of([fmpq(round(float(x) * PRECISION), PRECISION) for x in digits])


class Ball:
    """A ball around the point of an element, with a definite form that is small on elements that meet the
    ball.

    An element meets the ball if its fixed point or axis does. ``gram`` is the matrix of the form in a reduced
    basis of the lattice, ``steps`` the change to this basis.
    """

    def __init__(self, lattice: TraceZeroLattice, center: Quaternion, radius: float) -> None:
        self.lattice, self.radius = lattice, radius
        order, base = lattice.order, lattice.base
        self._norm = m = order.scalar(center.norm())
        if base.degree == 1:
            self._gamma, self._beta = base.element_of([fmpq(-1)]), 2 / m
        else:
            here = [v == order.place for v in base.real_places]
            self._gamma = lattice.number([-1.0 if x else 1.0 for x in here])
            size = max(1, round(order.real(m)))
            share = lattice.number([2 * size / order.real(m) if x else 0.0 for x in here])
            self._beta = share / size
        values = base.coordinate_rows(lattice.products(center))
        traces = fmpq_mat(
            [
                [base.trace(self._beta * u * w) for u in base.integral_basis]
                for w in base.integral_basis
            ]
        )
        form = lattice.rows * lattice.ambient.form(self._gamma) * lattice.rows.transpose()
        whole, below = (form * fmpq(1, 2) + values * traces * values.transpose()).numer_denom()
        reduced, self.steps = whole.lll(transform=True, rep="gram")
        self.gram, self._below = _integers(reduced), int(below)
        self._norms = None
        if base.degree == 1:
            norms = _integers(self.steps * lattice.norms * self.steps.transpose())
            self._norms = norms if any(norms[n][n] for n in range(3)) else None

    def bound(self, norm: BaseNumber) -> int:
        """Return a bound of the form on elements of given norm whose point or axis meets the ball."""
        order, base, bound = self.lattice.order, self.lattice.base, 0.0
        for v in base.real_places:
            n, weight, share = (base.real(x, v) for x in (norm, self._gamma, self._beta))
            reach = math.cosh(self.radius) if n > 0 else math.sinh(self.radius)
            square = abs(n) * base.real(self._norm, v) * (reach**2 if v == order.place else 1.0)
            bound += weight * n + max(share, 0.0) * abs(square)
        return math.floor(Fraction(bound * (1 + MARGIN)) * self._below + Fraction(MARGIN))

    def roots(self, d: BaseNumber) -> Iterator[Quaternion]:
        """Yield elements that include one of ±s for each primitive s with s² = d whose point or axis meets
        the ball.

        Raises :class:`TooLargeError`.
        """
        lattice = self.lattice
        for vector in self._vectors(d):
            if is_primitive(vector, lattice.multiplications):
                yield lattice.ambient.quaternion((vector * lattice.rows).entries())

    def _vectors(self, d: BaseNumber) -> Iterator[fmpz_mat]:
        """Yield one of ±s, in coordinates, for each s with s² = d on which the form is at most the bound."""
        bound, lattice = self.bound(-d), self.lattice
        if self._norms is not None:
            for found in vectors_of_value(
                self._norms, -2 * int(lattice.base.trace(d).p), self.gram, bound
            ):
                yield fmpz_mat([list(found)]) * self.steps
            return
        if enumeration.volume(self.gram, bound, len(self.gram)) > MAX_VECTORS:
            raise TooLargeError(f"too many elements of norm {-d} would be enumerated")
        for x, _ in enumeration.short_vectors(self.gram, bound):
            vector = fmpz_mat([list(x)]) * self.steps
            if lattice.ambient.norm((vector * lattice.rows).entries()) == -d:
                yield vector


def _integers(matrix: fmpz_mat) -> list[list[int]]:
    return [list(map(int, row)) for row in matrix.tolist()]


def roots(domain: Domain, d: BaseNumber) -> Iterator[tuple[Quaternion, Vector]]:
    """Yield pairs (s, v) that include all optimal embeddings whose point or axis meets a domain.

    s is the image of √d, and v is the vector of s in the plane of the domain. Only one of s and −s is
    yielded; if s fixes a point, it is the one whose vector lies on the sheet of the centre. ``d`` is a number
    of the base field. Raises :class:`TooLargeError`.
    """
    seen = set()
    # a covering for a larger discriminant is one for d
    for ball in covering(domain, math.ceil(math.log2(abs(domain.group.order.real(d))))):
        for s in ball.roots(d):
            on_sheet, v = _on_sheet(domain.polygon, s)
            if v not in seen:
                seen.add(v)
                yield on_sheet, v


def discriminant(order: SplitOrder, d: object) -> tuple[BaseNumber, BaseNumber]:
    """Return a discriminant as a number of the base field, and t with t² ≡ d modulo 4.

    Raises :class:`LatticeError` for a square, or a number that is not the discriminant of a quadratic order.
    """
    x = order.scalar(order.algebra.ring(d))
    t = order.base.root_modulo_4(x)
    if t is None or order.algebra.ring.is_square(order.base.outside(x)):
        raise LatticeError(
            f"{shorten(d)} is not a discriminant of a quadratic order over the integers of "
            f"{shorten(order.algebra.ring.name)}: expected an integer "
            "that is a square modulo 4 but not a square"
        )
    return x, t


def cm_points(group: NormOneGroup, d: object) -> tuple[CMPoint, ...]:
    """Return the CM points of a totally negative discriminant d, one per orbit, from left to right.

    Raises :class:`LatticeError` if d is not such a discriminant, and :class:`TooLargeError`.
    """
    order = group.order
    x, t = discriminant(order, d)
    if not order.base.is_totally_positive(-x):
        raise LatticeError(
            f"{shorten(d)} is not totally negative, and CM points belong to such discriminants: "
            "embeddings() has the embeddings of others"
        )
    return _points(group, x, t)


@lru_cache(maxsize=64)
def _points(group: NormOneGroup, x: BaseNumber, t: BaseNumber) -> tuple[CMPoint, ...]:
    """Return the CM points of a discriminant x ≡ t² modulo 4; x and t are numbers of the base field."""
    order, domain = group.order, group.domain()
    polygon, shift = domain.polygon, order.algebra(order.base.outside(t))
    found: list[CMPoint] = []
    seen: set[Vector] = set()
    for s, v in roots(domain, x):
        if v in seen or polygon.beyond(v) is not None:
            continue
        stabiliser = order.algebra(1)
        if any(
            dot(form, v) == 0 for form in polygon.forms
        ):  # images on the boundary are not new points
            images = orbit(polygon, s)
            seen.update(images.units)
            stabiliser = generator_of_rotations(polygon, images)
        found.append(CMPoint(group, order.base.outside(x), (shift + s) / 2, stabiliser))
    places = {point: complex(point) for point in found}
    return tuple(sorted(found, key=lambda p: (round(places[p].real, 9), places[p].imag)))


def reduced(domain: Domain, point: CMPoint) -> CMPoint:
    """Return the image of a CM point in a domain, under a unit of norm 1."""
    polygon = domain.polygon
    _, path = polygon.reduced(_on_sheet(polygon, point.root)[1])
    unit: Quaternion = domain.group.order.algebra(1)
    for n in path:
        unit = polygon.units[n].conjugate() * unit
    back = unit.conjugate()
    return CMPoint(
        point.group, point.discriminant, unit * point.element * back, unit * point.stabiliser * back
    )


def place(domain: Domain, point: CMPoint) -> complex:
    """Return the approximate position of a CM point in Poincaré's disc around the centre of a domain."""
    return domain.polygon.plane.disc(_on_sheet(domain.polygon, point.root)[1])


def embedding(group: NormOneGroup, d: object) -> tuple[Quaternion | None, str, Prime | None]:
    """Return the image of (t + √d)/2 under an optimal embedding, t² ≡ d modulo 4.

    If there is none, return None, a reason, and a prime without a local embedding if one is known. The search
    begins near some points and then covers the whole domain. Raises :class:`LatticeError` if d is a square or
    not a discriminant, and :class:`TooLargeError`.
    """
    order = group.order
    x, t = discriminant(order, d)
    if (obstruction := _local_obstruction(order, x, t)) is not None:
        reason, prime = obstruction
        return None, reason, prime
    shift = order.algebra(order.base.outside(t))
    for s in _near_some_points(order, x):
        return (shift + s) / 2, "", None
    for s, _ in roots(group.domain(), x):
        return (shift + s) / 2, "", None
    return None, "no element of the order with this discriminant is optimal", None


def of_orbits(group: NormOneGroup, d: object) -> tuple[Quaternion, ...]:
    """Return one embedding for each orbit under the units of norm 1.

    Raises :class:`LatticeError` if d is a square or not a discriminant, and :class:`TooLargeError`.
    """
    order = group.order
    x, t = discriminant(order, d)
    if order.base.is_totally_positive(-x):
        elements = [point.element for point in _points(group, x, t)]
        return (*elements, *(q.conjugate() for q in elements))
    shift = order.algebra(order.base.outside(t))
    return tuple((shift + s) / 2 for s in _directed_axes(group, x))


def _directed_axes(group: NormOneGroup, x: BaseNumber) -> Iterator[Quaternion]:
    """Yield an image of √d for each orbit, for a discriminant d that is positive at the split place.

    Two opposite elements have the same axis; they may lie in one orbit or in two.
    """
    domain = group.domain()
    seen: set[Vector] = set()
    for s, v in roots(domain, x):
        if v in seen or not axis_meets(domain.polygon, v):
            continue
        opposite = (-v[0], -v[1], -v[2])
        for root, vector in ((s, v), (-s, opposite)):
            if vector not in seen:
                seen.update(orbit(domain.polygon, root).units)
                yield root


def claim_of_orbits(group: NormOneGroup, d: object) -> CertifiedClaim:
    """Return the claim of the number of orbits of embeddings, with representatives of all orbits as evidence.

    Raises :class:`LatticeError` over bases other than ℤ, and as :func:`of_orbits` does.
    """
    elements = of_orbits(group, d)
    if group.order.base.is_totally_positive(-discriminant(group.order, d)[0]):
        elements = elements[: len(elements) // 2]  # without the conjugates
    polygon = group.domain().polygon
    return certificates.of_embedding_orbits(
        group.order.order, d, elements, polygon.plane.center, polygon.units
    )


def _near_some_points(order: SplitOrder, d: BaseNumber) -> Iterator[Quaternion]:
    """Yield images of √d whose point or axis meets a ball around one of several points of the plane."""
    lattice, rng = TraceZeroLattice(order), random.Random(1)
    plane = Plane(order, next(free_centers(order)))
    for _ in range(TRIALS):
        disc = math.tanh(rng.uniform(0, 2)) * cmath.exp(2j * math.pi * rng.random())
        yield from Ball(lattice, plane.nearby(disc, 20), 1.0).roots(d)


def _local_obstruction(
    order: SplitOrder, d: BaseNumber, t: BaseNumber
) -> tuple[str, Prime | None] | None:
    """Return why an embedding is impossible at some place, with the prime, or None if no obstruction applies.

    If the algebra ramifies at P, the quadratic field must not split there, and an Eichler order has no
    embedding of a quadratic order that is not maximal at P. If Pᵉ divides the level, d must be the square of
    a difference modulo 4·Pᵉ; this is decided for e = 1, and over ℤ for all e.
    """
    base, value = order.base, order.order
    if any(base.sign(d, v) > 0 for v in value.ambient.ramified_real_places):
        return "the algebra ramifies at a real place at which the discriminant is positive", None
    norm, eichler = (t * t - d) / 4, is_eichler(value)
    for P in value.ambient.ramified:
        if base.quadratic_symbol(t, norm, P) == 1:
            return f"{P} splits in the quadratic field, and the algebra ramifies at {P}", P
        p = base.absolute_norm(base.prime_ideal(P))
        if eichler and base.is_rational and not is_maximal_at(int(base.trace(d).p), p):
            return f"{P} divides the conductor, and the algebra ramifies at {P}", P
    for P, e in base.factorisation(level(value)) if eichler else ():
        if e == 1 and base.quadratic_symbol(t, norm, P) == -1:
            return f"{P} is inert in the quadratic field, and divides the level", P
        p = base.absolute_norm(base.prime_ideal(P))
        if base.is_rational and not is_square_modulo(int(base.trace(d).p), p, e + 2 * (p == 2)):
            return (
                f"{d} is not a square modulo {'4·' * (P == 2)}{P}^{e}, which divides the level",
                P,
            )
    return None


# --- Atkin–Lehner involutions ------------------------------------------------------------------------


def involution(group: NormOneGroup, m: int, point: CMPoint) -> CMPoint:
    """Return the image of a CM point under an Atkin–Lehner involution, as one of :func:`cm_points`.

    Raises :class:`LatticeError` unless m is an exact divisor of the discriminant of an Eichler order.
    """
    polygon, w = group.domain().polygon, _normalising(group, m)
    image = w * point.root * w.inverse()
    images = orbit(polygon, image).units
    for other in cm_points(group, point.discriminant):
        if _on_sheet(polygon, other.root)[1] in images:
            return other
    raise ArithmeticError("the image of a CM point is not among the points found")


def fixed_points(group: NormOneGroup, m: int) -> tuple[CMPoint, ...]:
    """Return the CM points fixed by an Atkin–Lehner involution with m > 1 (A. Ogg, 1983).

    Their discriminants are −4m, −m, and −4 if m = 2, because elements of norm m that fix a point have trace
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
    """Return the one of s and −s on the sheet of the centre, with its vector."""
    v = polygon.plane.vector(s)
    if polygon.plane.order.sign(v[0]) < 0:
        return -s, (-v[0], -v[1], -v[2])
    return s, v


# --- balls that cover a domain -----------------------------------------------------------------------


def covering(domain: Domain, exponent: int) -> list[Ball]:
    """Return balls that cover a domain.

    A neighbourhood of each cusp is left out. It contains no fixed point of a primitive element of the lattice
    of norm up to 2 to the power of ``exponent``. Raises :class:`TooLargeError`.
    """
    has_cusps = any(cycle.order == 0 for cycle in domain.cycles)
    return _covering(domain, exponent if has_cusps else 0)


@lru_cache(maxsize=16)
def _covering(domain: Domain, exponent: int) -> list[Ball]:
    lattice, size = TraceZeroLattice(domain.group.order), 2.0**exponent
    plane = domain.polygon.plane
    most = RADIUS if lattice.base.degree == 1 else RADIUS_OVER_FIELDS
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
    found: list[Ball] = []
    middles: list[Point] = []
    while triangles:
        triangle = triangles.pop()
        # a ball is convex
        if any(all(_distance(p, q) < most for q in triangle) for p in reversed(middles)):
            continue
        center = (sum(p[0] for p in triangle) / 3, sum(p[1] for p in triangle) / 3)
        if max(_distance(center, p) for p in triangle) > (1 - SLACK) * most:
            triangles += _halves(triangle)
            continue
        if len(found) == MAX_BALLS:
            raise TooLargeError(
                f"the domain is so large that more than {MAX_BALLS} balls would cover it"
            )
        disc = complex(*center) / (1 + math.sqrt(1 - abs(complex(*center)) ** 2))
        # with enough bits to come closer to the point than the point is to the circle
        c = plane.nearby(disc, 20 - math.floor(math.log2(1 - abs(complex(*center)) ** 2)))
        x, y, z = plane.floats(plane.vector(c))
        middles.append((y / x, z / x))
        if max(_distance(middles[-1], p) for p in triangle) > most:
            raise ArithmeticError("a ball does not contain its triangle")
        found.append(Ball(lattice, c, most * (1 + MARGIN) + MARGIN))
    return found


def _corner(
    domain: Domain, lattice: TraceZeroLattice, size: float, n: int
) -> tuple[Point, float | None]:
    """Return a corner of the domain; for a cusp, the points at which the cusp is cut off."""
    plane, start = domain.polygon.plane, domain.polygon.starts[n]
    x, y, z = plane.floats(start)
    if plane.order.sign(plane.norm(start)) != 0:
        return (y / x, z / x), None
    # if s fixes a point and ν is a null vector, tr(s·conj(ν))/2 is a nonzero multiple of g; the
    # base is ℤ
    null = sum((e * c for e, c in zip(plane.axes, start, strict=True)), 0 * plane.center)
    whole, below = fmpq_mat([lattice.products(null)]).numer_denom()
    g = fmpq(math.gcd(*map(int, whole.entries())), int(below))
    # with the vectors of the plane so scaled that the first coordinate is 1 and that of c has norm 1
    n0 = plane.order.real(plane.norms[0])
    height = plane.order.real(g) / (x * n0) * math.sqrt(n0) / math.sqrt(size)
    return (y / x, z / x), height * (1 - MARGIN)


def _before(cusp: Point, height: float, start: Point) -> Point:
    """Return the point at which the line from a point to a cusp enters the horoball."""
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
    """Return the two halves of a triangle, cut at its longest side."""
    k = max(range(3), key=lambda n: _distance(triangle[n], triangle[(n + 1) % 3]))
    p, q, r = triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]
    middle = _middle(p, q)
    return [(p, middle, r), (middle, q, r)]


def _middle(p: Point, q: Point) -> Point:
    """Return the hyperbolic midpoint of two points."""
    a, b = (1 / math.sqrt(1 - x * x - y * y) for x, y in (p, q))
    return ((a * p[0] + b * q[0]) / (a + b), (a * p[1] + b * q[1]) / (a + b))


def _distance(p: Point, q: Point) -> float:
    """Return a close upper bound for the distance of two points of Klein's disc.

    Raises :class:`TooLargeError` for points so close to the circle that floats cannot separate them from it.
    """
    product = 1 - p[0] * q[0] - p[1] * q[1]
    a, b = 1 - p[0] ** 2 - p[1] ** 2, 1 - q[0] ** 2 - q[1] ** 2
    if min(a, b) < FARTHEST:
        raise TooLargeError("the domain reaches too far from its centre to be covered by balls")
    return math.acosh(max(1.0, product / math.sqrt(a * b)) * (1 + ROUNDING / a + ROUNDING / b))
