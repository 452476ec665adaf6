"""Check by its area a fundamental polygon of the units of norm 1 of an order that splits at one real place.

Points of the hyperbolic plane are elements of trace 0 and positive norm, up to positive factors, on the same
sheet of the hyperboloid as the centre c. A unit g of norm 1 maps x to g·x·ḡ. Points and lines are rows of
integers of the field, ordered by the real place. The Dirichlet domain is contained in the polygon of the
points that are nearer to c than to g·c for the given units g; if the areas agree they are equal
(docs/explanation/trust.md).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product

from hfield.checker.budget import spend
from hfield.checker.number_fields.integers import Primes
from hfield.checker.number_fields.matrices import longest
from hfield.checker.number_fields.real_numbers import RealNumber, RealRow
from hfield.checker.orders.lattice import Lattice, LatticeElement
from hfield.checker.orders.local_types import mass, symbols
from hfield.checker.orders.presentations import Word, simplified
from hfield.checker.orders.real_algebra import RealAlgebra, RealElement
from hfield.checker.rejection import reject

Vector = tuple[RealNumber, RealNumber, RealNumber]
MAX_SIDES = 5_000
MAX_ORDER = 21
"""Elliptic points have at most this order m over a field of degree 6: ζ₂ₘ has degree φ(2m) ≤ 12 over ℚ."""


def area(order: Lattice, primes: Primes) -> Fraction:
    """Return the area of the plane modulo the units of norm 1, over 2π, by Shimizu's formula (cited).

    It is twice the mass, divided by the indices of norms of local units.
    """
    found = 2 * mass(order, primes)
    for P, symbol in symbols(order, primes):
        if symbol == 0:
            # at an odd prime norms of units are the squares modulo it
            found /= 2 if P.p > 2 else _norm_index_at_two(order)
    return found


def _norm_index_at_two(order: Lattice) -> int:
    """Return the index of the norms of local units in the units of ℤ₂."""
    if order.algebra.n > 1:
        reject("the area is not known here where an Eichler symbol above 2 is 0")
    spend(40_000)
    form = [
        [x // order.unit for x in row] for row in order.gram[0]
    ]  # integral, even on the diagonal
    norms = {
        sum(x[m] * x[n] * form[m][n] for m in range(4) for n in range(4)) // 2 % 8
        for x in product(range(8), repeat=4)
    }
    return 4 // len(norms & {1, 3, 5, 7})


class FundamentalDomain:
    """The Dirichlet domain around the fixed point of c, for the units of norm 1.

    Side n lies halfway between c and its image under unit n; units and sides go counterclockwise. If the
    first unit fixes c, the last is its inverse, and the domain is a sector of that polygon, whose first and
    last sides connect c with corners. ``area`` is the area of the plane modulo the group, over 2π.
    """

    def __init__(
        self,
        order: Lattice,
        algebra: RealAlgebra,
        area: Fraction,
        center: LatticeElement,
        units: Sequence[LatticeElement],
    ) -> None:
        if not 3 <= len(units) <= MAX_SIDES:
            reject(f"a domain has 3 to {MAX_SIDES} sides")
        self.algebra, self.area = algebra, area
        self.units = [algebra.element(g.den, g.row) for g in units]
        self._axes = self._seen_from(algebra.element(center.den, center.row).row)
        bits = longest([*self._axes, *(g.row for g in self.units)]) + algebra.bits
        spend(len(units) * (400 + 5_000 * (order.algebra.n - 1) + bits * bits // 3_000))
        for own, g in zip(units, self.units, strict=True):
            size = 2 * algebra.scale * g.den * g.den
            if not order.holds(own.den, [own.row]) or algebra.pairing(g.row, g.row) != size:
                reject("an element is no unit of norm 1 of the order")
        self._is_sector = not any(self._line(self.units[0]))
        self.corners, self._ideal = self._sector() if self._is_sector else self._polygon(self.units)
        self.partners = self._paired()
        self.cycles = list(self._cycles())
        angles = sum((Fraction(1, c.order) for c in self.cycles if c.order), Fraction(0))
        if Fraction(len(units) - 2, 2) - angles != area:
            reject("the polygon has not the area of the plane modulo the group")

    def _seen_from(self, c: RealRow) -> tuple[RealRow, RealRow, RealRow]:
        """Return c, an element u that anticommutes with c, and c·u, up to positive factors."""
        algebra = self.algebra
        if algebra.pairing(c, (1, 0, 0, 0)) or algebra.pairing(c, c) <= 0:
            reject("the centre is no element of trace 0 and positive norm")
        for k in range(1, 4):
            v = tuple(int(k == m) for m in range(4))
            u = tuple(x - y for x, y in zip(algebra.times(c, v), algebra.times(v, c), strict=True))
            size = algebra.pairing(u, u)
            if size > 0:
                reject("the algebra is definite")
            if size:
                return c, u, algebra.times(c, u)
        reject("the centre commutes with everything")

    def _moved(self, g: RealRow, x: RealRow) -> RealRow:
        """Return g·x·ḡ, multiplied by the third power of the scale of the algebra."""
        return self.algebra.times(self.algebra.times(g, x), self.algebra.conjugate(g))

    # --- the polygon ---------------------------------------------------------------------------------

    def _far(self, g: RealElement) -> RealRow:
        """Return g·c − c up to a positive factor; its pairing with a point is ≥ 0 if c is as near as g·c."""
        size = g.den * g.den * self.algebra.scale**3
        c = self._axes[0]
        return tuple(x - size * y for x, y in zip(self._moved(g.row, c), c, strict=True))

    def _line(self, g: RealElement) -> Vector:
        """Return the form that is ≥ 0 at points at least as near to c as to g·c: the pairing with g·c − c."""
        far = self._far(g)
        a, b, d = (self.algebra.pairing(far, v) for v in self._axes)
        return (a, b, d)

    def _polygon(self, units: Sequence[RealElement]) -> tuple[list[RealRow], list[bool]]:
        """Return the starting point of each side, and whether it is at infinity.

        Reject unless the lines, in order, bound a convex polygon with corners in the plane or at infinity.
        The forms f, positive at the centre, are the points (f₁/f₀, f₂/f₀) of the dual plane. They are the
        corners of a convex polygon around 0 if the path turns left at each of them, also as seen from 0, and
        winds around once.
        """
        lines = [self._line(g) for g in units]
        if any(f[0] <= 0 for f in lines):
            reject("a unit does not move the centre")
        meetings = [_meeting(lines[n - 1], f) for n, f in enumerate(lines)]
        turns = sum(lines[n - 1][2] < 0 <= f[2] for n, f in enumerate(lines))
        if turns != 1 or any(x[0] <= 0 for x in meetings):
            reject("the sides do not go once around the centre")
        if any(_dot(lines[n - 2], x) <= 0 for n, x in enumerate(meetings)):
            reject("a side does not bound the polygon")
        norms = [self.algebra.pairing(v, v) for v in self._axes]
        sizes = [sum(m * a * a for m, a in zip(norms, x, strict=True)) for x in meetings]
        if any(size < 0 for size in sizes):
            reject("two sides meet beyond infinity")
        corners = [self.algebra.primitive(0, times_axes(x, self._axes)).row for x in meetings]
        return corners, [size == 0 for size in sizes]

    def _sector(self) -> tuple[list[RealRow], list[bool]]:
        """Check a sector: the other units, rotated by powers of the last one, bound a polygon."""
        rotation, sides = self.units[-1], self.units[1:-1]
        if self._up_to_sign(self._inverse(rotation)) != self._up_to_sign(self.units[0]):
            reject("the first unit fixes the centre, and is not the inverse of the last")
        order = self._order(rotation)
        if order < 2:
            reject("the first unit does not move the centre, and is no rotation")
        spend(len(sides) * order * 1_000)
        whole = list(sides)
        for _ in range(order - 1):
            whole += [self.algebra.product(rotation, g) for g in whole[-len(sides) :]]
        corners, ideal = self._polygon(whole)
        corners, ideal = corners + corners[:1], ideal + ideal[:1]
        end = len(sides) + 1
        return [self._axes[0], *corners[:end]], [False, *ideal[:end]]

    def _inverse(self, g: RealElement) -> RealElement:
        return RealElement(g.den * self.algebra.scale, self.algebra.conjugate(g.row))

    def _paired(self) -> list[int]:
        """Return the side to which each side is mapped by the inverse of its unit; that inverse must be the
        unit there.
        """
        places = {self._up_to_sign(g): n for n, g in enumerate(self.units)}
        partners = []
        count = len(self.units)
        for n, g in enumerate(self.units):
            bar = self.algebra.conjugate(g.row)
            if self._is_sector and n in (0, count - 1):
                partner: int | None = count - 1 - n
            else:
                partner = places.get(self._up_to_sign(self._inverse(g)))
            if partner is None:
                reject("the inverse of a unit belongs to no side")
            ends = [self.corners[n], self.corners[(n + 1) % count]]
            images = [self._moved(bar, x) for x in ends]
            others = [self.corners[(partner + 1) % count], self.corners[partner]]
            if not all(map(_same_point, images, others)):
                reject("a side is not mapped to a side")
            partners.append(partner)
        return partners

    def _up_to_sign(self, g: RealElement) -> tuple[int, RealRow]:
        """Return a key shared by g and −g only."""
        own = self.algebra.primitive(g.den, g.row)
        first = next((x for x in own.row if x), 0)
        return own.den, tuple(-x for x in own.row) if first < 0 else own.row

    def _cycles(self) -> Iterator["Cycle"]:
        left, count = set(range(len(self.units))), len(self.units)
        while left:
            start = n = min(left)
            path: list[int] = []
            around = RealElement(1, (1, 0, 0, 0))
            while not path or n != start:
                if n not in left:
                    reject("the corners are in no cycles")
                left.discard(n)
                path.append(n)
                g = self.units[n]
                around = self.algebra.product(self._inverse(g), around)
                n = (self.partners[n] + 1) % count
            order = self._order(around)
            if (order == 0) != self._ideal[start]:
                reject("what goes around a corner does not fix it as it should")
            yield Cycle(tuple(path), order)

    def _order(self, g: RealElement) -> int:
        """Return the order of a unit modulo ±1; 0 for a parabolic unit."""
        trace = self.algebra.pairing(g.row, (1, 0, 0, 0))
        if any(g.row[1:]) and trace * trace == (2 * self.algebra.scale * g.den) ** 2:
            return 0
        power = g
        for m in range(1, MAX_ORDER + 1):
            if not any(power.row[1:]):
                return m
            power = self.algebra.product(power, g)
        reject("what goes around a corner moves it")

    # --- points in it --------------------------------------------------------------------------------

    def orbit(self, s: LatticeElement) -> set[RealRow]:
        """Return the images, under units, in the domain of an element of trace 0; over ℚ.

        Reject unless it stands for a point of the domain; reject a sector as well. Tiles around a point are
        reached across sides that contain it.
        """
        if self._is_sector:
            reject("points are compared in a domain, and this is a sector")
        if self.algebra.pairing(s.row, self._axes[0]) <= 0:
            reject("a point is not on the sheet of the centre")
        own = self.algebra.element(s.den, s.row)
        found, waiting = {(own.den, *own.row)}, [own]
        while waiting:
            x = waiting.pop()
            spend(50 * len(self.units))
            for g, far in zip(self.units, self._bounds, strict=True):
                side = self.algebra.pairing(far, x.row)
                if side < 0:
                    reject("a point is not in the domain")
                if side == 0:
                    back = self._inverse(g)
                    row = self._moved(back.row, x.row)
                    size = back.den * back.den * self.algebra.scale**3
                    image = self.algebra.primitive(x.den * size, row)
                    if (key := (image.den, *image.row)) not in found:
                        found.add(key)
                        waiting.append(image)
        return found

    @cached_property
    def _bounds(self) -> list[RealRow]:
        return [self._far(g) for g in self.units]

    # --- the group -----------------------------------------------------------------------------------

    @cached_property
    def elliptic(self) -> list[int]:
        """The orders of the elliptic points, ascending; a side paired with itself has one at its midpoint."""
        halves = [2 for n, partner in enumerate(self.partners) if n == partner]
        return sorted([*halves, *(c.order for c in self.cycles if c.order > 1)])

    @property
    def cusps(self) -> int:
        """The number of cusps."""
        return sum(c.order == 0 for c in self.cycles)

    @property
    def genus(self) -> Fraction:
        """The genus of the quotient, from area = 2·genus − 2 + Σ (1 − 1/order) + cusps."""
        return (self.area + 2 - self.cusps - sum(1 - Fraction(1, m) for m in self.elliptic)) / 2

    def need_group(
        self,
        signature: tuple[Fraction, list[int], Fraction],
        generators: Sequence[LatticeElement],
        relations: Sequence[Word],
    ) -> None:
        """Reject unless the group has this signature, and the presentation obtained from the domain."""
        if signature != (self.genus, self.elliptic, Fraction(self.cusps)):
            reject("the group has another signature")
        own = [self.algebra.element(x.den, x.row) for x in generators]
        if (own, list(relations)) != self.presentation():
            reject("this is not the presentation that the domain gives")

    def presentation(self) -> tuple[list[RealElement], list[Word]]:
        """Return generators and relations from the sides, after eliminating generators that a relation
        expresses by others.
        """
        letters: dict[int, int] = {}
        for n, partner in enumerate(self.partners):
            if n not in letters:
                letters[partner] = -1 - max(letters.values(), default=0)
                letters[n] = -letters[partner]
        relations: list[Word] = [
            (letters[n],) * 2 for n, partner in enumerate(self.partners) if n == partner
        ]
        relations += [tuple(letters[n] for n in c.sides) * c.order for c in self.cycles]
        left, relations = simplified(sorted(x for x in letters.values() if x > 0), relations)
        numbers = {old: n for n, old in enumerate(left, 1)}
        numbers |= {-old: -n for old, n in numbers.items()}
        sides = {letter: n for n, letter in letters.items()}
        return (
            [self.units[sides[letter]] for letter in left],
            [tuple(numbers[x] for x in word) for word in relations],
        )


@dataclass(frozen=True)
class Cycle:
    """A corner up to the group: the sides around it, and the order of its stabiliser (0 at a cusp)."""

    sides: tuple[int, ...]
    order: int


def times_axes(x: Sequence[RealNumber], axes: Sequence[RealRow]) -> RealRow:
    """Return a linear combination of rows."""
    return tuple(sum(a * v[k] for a, v in zip(x, axes, strict=True)) for k in range(4))


def _meeting(f: Vector, g: Vector) -> Vector:
    """Return the intersection of two lines."""
    return (
        f[1] * g[2] - f[2] * g[1],
        f[2] * g[0] - f[0] * g[2],
        f[0] * g[1] - f[1] * g[0],
    )


def _dot(f: Vector, x: Vector) -> RealNumber:
    return f[0] * x[0] + f[1] * x[1] + f[2] * x[2]


def _same_point(x: RealRow, y: RealRow) -> bool:
    """Return whether coordinates are proportional; on one sheet the factor is positive."""
    n = next(n for n, c in enumerate(y) if c)
    return all(x[n] * b == a * y[n] for a, b in zip(x, y, strict=True))
