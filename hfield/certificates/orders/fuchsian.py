"""Units of norm 1 of an indefinite order: a polygon with their area is their Dirichlet domain.

The plane is that of the elements of trace 0 with positive norm, up to positive factors, on the sheet of the
centre c; g of norm 1 moves x to g·x·ḡ. Points and lines are rows of integers, over a number field of its
integers at the real place that splits, and the polygon that lies nearer to c than to the g·c contains the
domain (docs/trust.md).
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import Any, Protocol

from hfield.certificates.number_fields.factoring import factored
from hfield.certificates.number_fields.matrices import Row, longest, times
from hfield.certificates.orders.algebra import Algebra
from hfield.certificates.orders.lattice import Element, Lattice
from hfield.certificates.orders.local_types import discriminant, eichler_symbol
from hfield.certificates.rejection import reject
from hfield.certificates.work import charge

Vector = tuple[Any, Any, Any]
Word = tuple[int, ...]
MOST_SIDES = 5_000
MOST_ORDER = 21
"""Elliptic points have at most this order m over a field of degree 6: ζ₂ₘ has degree φ(2m) ≤ 12 over ℚ."""


class Order(Protocol):
    """What a domain asks of an order."""

    @property
    def algebra(self) -> Algebra:
        """The algebra."""

    def holds(self, den: int, rows: Sequence[Row]) -> bool:
        """Tell whether rows over a denominator lie in it."""


def area(order: Lattice) -> Fraction:
    """Return the area of the plane modulo the units of norm 1 over 2π: Shimizu's formula, which is cited."""
    n = discriminant(order)
    found = Fraction(n, 6)
    for p in factored(n):
        symbol = eichler_symbol(order, p)
        found *= (1 - Fraction(1, p * p)) / (1 - Fraction(symbol, p))
        if symbol == 0:
            found /= _norm_index(order, p)
    return found


def _norm_index(order: Lattice, p: int) -> int:
    """Return the index of norms of local units in the units of ℤₚ, for the residue ring 𝔽ₚ."""
    if p > 2:
        return 2  # modulo p the norm is a square
    charge(40_000)
    form = [[x // order.unit for x in row] for row in order.gram]  # integral, even on the diagonal
    norms = {
        sum(x[m] * x[n] * form[m][n] for m in range(4) for n in range(4)) // 2 % 8
        for x in product(range(8), repeat=4)
    }
    return 4 // len(norms & {1, 3, 5, 7})


class Domain:
    """The Dirichlet domain of the units of norm 1 around the fixed point of c.

    Side n lies halfway between c and the image of c under unit n; units and sides go counterclockwise.
    ``area`` is that of the plane modulo the group, over 2π.
    """

    def __init__(
        self, order: Order, area: Fraction, center: Element, units: Sequence[Element]
    ) -> None:
        self.algebra, self.units, self.area = order.algebra, units, area
        if not 3 <= len(units) <= MOST_SIDES:
            reject(f"a domain has 3 to {MOST_SIDES} sides")
        self._axes = self._seen_from(center)
        bits = longest([*self._axes, *(g.row for g in units)]) + self.algebra.bits
        charge(len(units) * (400 + bits * bits // 3_000))
        for g in units:
            size = 2 * self.algebra.scale * g.den * g.den
            if not order.holds(g.den, [g.row]) or self._pairing(g.row, g.row) != size:
                reject("an element is no unit of norm 1 of the order")
        self._need_polygon()
        self.partners = self._paired()
        self.cycles = list(self._cycles())
        angles = sum((Fraction(1, c.order) for c in self.cycles if c.order), Fraction(0))
        if Fraction(len(units) - 2, 2) - angles != area:
            reject("the polygon has not the area of the plane modulo the group")

    def _seen_from(self, center: Element) -> tuple[Row, Row, Row]:
        """Return c, some u that anticommutes with c, and c·u, up to positive factors."""
        algebra, c = self.algebra, center.row
        if times([c], algebra.form)[0][0] or self._pairing(c, c) <= 0:
            reject("the centre is no element of trace 0 and positive norm")
        for k in range(1, 4):
            v = tuple(int(k == m) for m in range(4))
            u = tuple(x - y for x, y in zip(self._times(c, v), self._times(v, c), strict=True))
            size = self._pairing(u, u)
            if size > 0:
                reject("the algebra is definite")
            if size:
                return c, u, self._times(c, u)
        reject("the centre commutes with everything")

    def _times(self, x: Row, y: Row) -> Row:
        """Return x·y, times the scale of the algebra."""
        return times([y], self.algebra.left(x))[0]

    def _pairing(self, x: Row, y: Row) -> Any:
        """Return tr(x·ȳ), times the scale of the algebra."""
        (row,) = times([x], self.algebra.form)
        return sum(a * b for a, b in zip(row, y, strict=True))

    def _moved(self, g: Row, x: Row) -> Row:
        """Return g·x·ḡ, times the scale of the algebra to the power 3."""
        return self._times(self._times(g, x), self.algebra.conjugate(g))

    # --- the polygon ---------------------------------------------------------------------------------

    def _line(self, g: Element) -> Vector:
        """Return the form that is ≥ 0 where c is at least as near as g·c: the pairing with g·c − c."""
        size = g.den * g.den * self.algebra.scale**3
        c = self._axes[0]
        far = tuple(x - size * y for x, y in zip(self._moved(g.row, c), c, strict=True))
        a, b, d = (self._pairing(far, v) for v in self._axes)
        return (a, b, d)

    def _need_polygon(self) -> None:
        """Reject unless the lines bound a convex polygon, in order, with corners at most at infinity.

        The forms f, positive at the centre, are the points (f₁/f₀, f₂/f₀) of the dual plane: corners of a
        convex polygon around 0 if they turn left there, seen from 0 and from one another, once around.
        """
        lines = [self._line(g) for g in self.units]
        if any(f[0] <= 0 for f in lines):
            reject("a unit does not move the centre")
        meetings = [_meeting(lines[n - 1], f) for n, f in enumerate(lines)]
        turns = sum(lines[n - 1][2] < 0 <= f[2] for n, f in enumerate(lines))
        if turns != 1 or any(x[0] <= 0 for x in meetings):
            reject("the sides do not go once around the centre")
        if any(_dot(lines[n - 2], x) <= 0 for n, x in enumerate(meetings)):
            reject("a side does not bound the polygon")
        norms = [self._pairing(v, v) for v in self._axes]
        sizes = [sum(m * a * a for m, a in zip(norms, x, strict=True)) for x in meetings]
        if any(size < 0 for size in sizes):
            reject("two sides meet beyond infinity")
        self._ideal = [size == 0 for size in sizes]
        self.corners = [self.algebra.primitive(times_axes(x, self._axes))[1] for x in meetings]

    def _paired(self) -> list[int]:
        """Return to which side each is mapped by the inverse of its unit, which is the unit there."""
        places = {self._up_to_sign(g): n for n, g in enumerate(self.units)}
        partners = []
        count = len(self.units)
        for n, g in enumerate(self.units):
            bar = self.algebra.conjugate(g.row)
            back = Element(g.den * self.algebra.scale, bar)
            partner = places.get(self._up_to_sign(back))
            if partner is None:
                reject("the inverse of a unit belongs to no side")
            ends = [self.corners[n], self.corners[(n + 1) % count]]
            images = [self._moved(bar, x) for x in ends]
            others = [self.corners[(partner + 1) % count], self.corners[partner]]
            if not all(map(_same_point, images, others)):
                reject("a side is not mapped to a side")
            partners.append(partner)
        return partners

    def _up_to_sign(self, g: Element) -> tuple[int, Row]:
        """Return what g and −g have in common, and no other element."""
        den, row = self.algebra.primitive(g.row, g.den)
        first = next((x for x in row if x), 0)
        return den, tuple(-x for x in row) if first < 0 else row

    def _cycles(self) -> Iterator["Cycle"]:
        left, count = set(range(len(self.units))), len(self.units)
        while left:
            start = n = min(left)
            path: list[int] = []
            around = Element(1, (1, 0, 0, 0))
            while not path or n != start:
                if n not in left:
                    reject("the corners are in no cycles")
                left.discard(n)
                path.append(n)
                g = self.units[n]
                bar = Element(g.den * self.algebra.scale, self.algebra.conjugate(g.row))
                around = self._product(bar, around)
                n = (self.partners[n] + 1) % count
            order = self._order(around)
            if (order == 0) != self._ideal[start]:
                reject("what goes around a corner does not fix it as it should")
            yield Cycle(tuple(path), order)

    def _product(self, g: Element, h: Element) -> Element:
        row = self._times(g.row, h.row)
        charge(50 + longest([row]) ** 2 // 10_000)
        return Element(*self.algebra.primitive(row, g.den * h.den * self.algebra.scale))

    def _order(self, g: Element) -> int:
        """Return the order of a unit modulo ±1; 0 for a parabolic one."""
        trace = times([g.row], self.algebra.form)[0][0]
        if any(g.row[1:]) and trace * trace == (2 * self.algebra.scale * g.den) ** 2:
            return 0
        power = g
        for m in range(1, MOST_ORDER + 1):
            if not any(power.row[1:]):
                return m
            power = self._product(power, g)
        reject("what goes around a corner moves it")

    # --- the group -----------------------------------------------------------------------------------

    @cached_property
    def elliptic(self) -> list[int]:
        """The orders of the elliptic points, ascending; one is in the middle of a side paired with itself."""
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
        generators: Sequence[Element],
        relations: Sequence[Word],
    ) -> None:
        """Reject unless the group has this signature, and this is the presentation that the domain gives."""
        if signature != (self.genus, self.elliptic, Fraction(self.cusps)):
            reject("the group has another signature")
        if (list(generators), list(relations)) != self.presentation():
            reject("this is not the presentation that the domain gives")

    def presentation(self) -> tuple[list[Element], list[Word]]:
        """Return generators and relations: of the sides, less those that a relation expresses by others."""
        letters: dict[int, int] = {}
        for n, partner in enumerate(self.partners):
            if n not in letters:
                letters[partner] = -1 - max(letters.values(), default=0)
                letters[n] = -letters[partner]
        relations: list[Word] = [
            (letters[n],) * 2 for n, partner in enumerate(self.partners) if n == partner
        ]
        relations += [tuple(letters[n] for n in c.sides) * c.order for c in self.cycles]
        left, relations = _simplified(sorted(x for x in letters.values() if x > 0), relations)
        numbers = {old: n for n, old in enumerate(left, 1)}
        numbers |= {-old: -n for old, n in numbers.items()}
        sides = {letter: n for n, letter in letters.items()}
        return (
            [self.units[sides[letter]] for letter in left],
            [tuple(numbers[x] for x in word) for word in relations],
        )


@dataclass(frozen=True)
class Cycle:
    """A corner up to the group: the sides around it, and the order of its stabiliser, 0 at a cusp."""

    sides: tuple[int, ...]
    order: int


def _simplified(left: list[int], relations: list[Word]) -> tuple[list[int], list[Word]]:
    """Put away generators that occur once in a relation, short relations first (Tietze)."""
    relations = [r for r in map(_cyclically_reduced, relations) if r]
    while True:
        charge(10 + 10 * sum(map(len, relations)))
        found = [
            (len(r) - 1, n, r)
            for r in relations
            for n in set(map(abs, r))
            if sum(abs(x) == n for x in r) == 1
        ]
        if not found:
            return left, relations
        _, n, relation = min(found)
        at = next(m for m, x in enumerate(relation) if abs(x) == n)
        rest = relation[at + 1 :] + relation[:at]  # the relation is n^±1·rest, up to a conjugate
        value = _inverse(rest) if relation[at] > 0 else rest
        put = {n: value, -n: _inverse(value)}
        relations.remove(relation)
        relations = [
            tuple(x for letter in r for x in put.get(letter, (letter,))) for r in relations
        ]
        charge(sum(map(len, relations)))
        relations = [r for r in map(_cyclically_reduced, relations) if r]
        left = [x for x in left if x != n]


def _cyclically_reduced(letters: Iterable[int]) -> Word:
    word: list[int] = []
    for x in letters:
        if word and word[-1] == -x:
            word.pop()
        else:
            word.append(x)
    first, last = 0, len(word)
    while last - first > 1 and word[first] == -word[last - 1]:
        first, last = first + 1, last - 1
    return tuple(word[first:last])


def _inverse(word: Word) -> Word:
    return tuple(-x for x in reversed(word))


def times_axes(x: Sequence[int], axes: Sequence[Row]) -> Row:
    """Return a combination of rows."""
    return tuple(sum(a * v[k] for a, v in zip(x, axes, strict=True)) for k in range(4))


def _meeting(f: Vector, g: Vector) -> Vector:
    """Return the point where two lines meet."""
    return (
        f[1] * g[2] - f[2] * g[1],
        f[2] * g[0] - f[0] * g[2],
        f[0] * g[1] - f[1] * g[0],
    )


def _dot(f: Vector, x: Vector) -> Any:
    return f[0] * x[0] + f[1] * x[1] + f[2] * x[2]


def _same_point(x: Row, y: Row) -> bool:
    """Tell whether coordinates are multiples of one another; on one sheet the factor is positive."""
    n = next(n for n, c in enumerate(y) if c)
    return all(x[n] * b == a * y[n] for a, b in zip(x, y, strict=True))
