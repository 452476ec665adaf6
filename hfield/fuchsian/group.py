"""The group of units of norm 1 of an order that acts on the hyperbolic plane: the public classes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import acosh
from typing import TYPE_CHECKING, NamedTuple

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, TooLargeError, shorten
from hfield.evidence import Certified, CertifiedClaim
from hfield.fuchsian import area, presentation
from hfield.fuchsian.presentation import Word
from hfield.fuchsian.split_order import SplitOrder
from hfield.fuchsian.upper_half_plane import fixed_point, fixing
from hfield.hints import GROUP, Hinted

if TYPE_CHECKING:
    from hfield.fuchsian import dirichlet
    from hfield.fuchsian.cm_points import CMPoint
    from hfield.fuchsian.geodesics import Geodesic
    from hfield.fuchsian.polygon import Polygon
    from hfield.fuchsian.search import Rows
    from hfield.orders.base_values import BaseNumber


class Signature(NamedTuple):
    """The signature of the quotient: genus, orders of the elliptic points (ascending), number of cusps."""

    genus: int
    orders: tuple[int, ...]
    cusps: int


CENTERS = 4
"""So many centres are tried for a domain."""
MAX_FAR = 1e9
"""No centre is farther from 0."""
MAX_AREA_OF_CENTERS = 200
"""For groups with more area, in units of 2π, only one is tried."""
MAX_TRACE = 100_000
"""Traces of hyperbolic elements are listed up to here."""


def signature_of(
    partners: Sequence[int], cycles: Sequence[dirichlet.VertexCycle], area: Fraction
) -> Signature:
    """Return the signature of the group with a domain."""
    orders = [c.order for c in cycles if c.order > 1]
    orders += [2 for n, partner in enumerate(partners) if n == partner]
    cusps = sum(c.order == 0 for c in cycles)
    return _signature(area, tuple(sorted(orders)), cusps)


def _signature(area: Fraction, orders: tuple[int, ...], cusps: int) -> Signature:
    """Return the signature, with the genus by the formula of Gauss and Bonnet."""
    twice = area + 2 - cusps - sum(1 - Fraction(1, m) for m in orders)
    if twice % 2 or twice < 0:
        raise ArithmeticError(f"elliptic points {orders} and {cusps} cusps do not fit the area")
    return Signature(int(twice / 2), orders, cusps)


class QuotientOrbifold(NamedTuple):
    """The quotient of the plane by a group between the units of norm 1 and the normaliser of an order.

    ``elements`` maps each norm to an element of the normaliser; these represent the larger group modulo the
    smaller group and the scalars.
    """

    signature: Signature
    area: Fraction
    elements: dict[BaseNumber, Quaternion]


@dataclass(frozen=True)
class Side:
    """A side of a domain: ``element`` maps it onto side number ``partner``, which may be itself."""

    element: Quaternion
    partner: int


@dataclass(frozen=True, repr=False)
class Domain(Certified):
    """A Dirichlet domain, proved complete: the points nearer to a centre than to its images.

    Sides and vertices are listed counterclockwise; side n goes from vertex n to the next vertex.
    """

    group: NormOneGroup
    polygon: Polygon
    partners: tuple[int, ...]
    cycles: tuple[dirichlet.VertexCycle, ...]

    def __repr__(self) -> str:
        return f"a Dirichlet domain with {len(self.partners)} sides of {self.group}"

    @property
    def claim(self) -> CertifiedClaim:
        """The claim that the domain has these sides, with its evidence."""
        from hfield.fuchsian import certificates

        return certificates.of_domain(self)

    @cached_property
    def sides(self) -> tuple[Side, ...]:
        """The sides, each with the unit that maps it to its partner."""
        units = (unit.conjugate() for unit in self.polygon.units)
        return tuple(map(Side, units, self.partners))

    @cached_property
    def vertices(self) -> tuple[complex, ...]:
        """The vertices in Poincaré's disc around the centre, as complex floats; cusps lie on the circle."""
        return tuple(map(self.polygon.plane.disc, self.polygon.starts))

    @property
    def center_element(self) -> Quaternion:
        """The exact centre, as an element of trace 0 that fixes it."""
        return self.polygon.plane.center

    @property
    def center(self) -> complex:
        """The centre in the upper half plane, as a float; :attr:`center_element` is exact."""
        return fixed_point(self.group.order, self.center_element)

    @property
    def stabiliser(self) -> Quaternion:
        """The unit that generates, with −1, the units of norm 1 that fix the centre: 1 or the least rotation.

        It turns counterclockwise by 2π divided by its order modulo ±1, and maps the first side of the sector
        to the last one.
        """
        last, one = self.polygon.units[-1], self.group.order.algebra(1)
        return last if self.polygon.images[-1] == self.polygon.plane.image(one) else one

    @property
    def area(self) -> Fraction:
        """The area by Gauss and Bonnet from the exact angles, in units of 2π."""
        from hfield.fuchsian import dirichlet

        return dirichlet.area_of(list(self.partners), list(self.cycles))

    def reduce(self, point: CMPoint) -> CMPoint:
        """Return the image of a CM point in the domain, under a unit of norm 1.

        If there are several images in the domain, they lie on its boundary.

        >>> from hfield import QuaternionAlgebra
        >>> G = QuaternionAlgebra(6).maximal_order().norm_one_group()
        >>> point = G.cm_points(-24)[1]; point
        CM point 1.10819 + 1.27963i of discriminant -24
        >>> G.domain(3 + 1j).reduce(point)
        CM point 2.73316 + 1.05199i of discriminant -24
        """
        from hfield.fuchsian import cm_points

        return cm_points.reduced(self, point)

    def draw(
        self,
        path: object,
        *,
        points: Iterable[CMPoint] = (),
        dark: bool = False,
        depth: int | None = None,
        replace: bool | None = None,
    ) -> None:
        """Draw the domain and its images under words of up to ``depth`` sides, to a .svg, .png or .pdf file.

        Paired sides share a colour and a letter; elliptic points and the centre are marked. CM points are
        moved into the domain, with one colour per discriminant. A .html file becomes a page on which the
        centre can be dragged. ``replace`` says whether an existing file may be replaced; with None it may be
        replaced if it existed before drawing began. Raises :class:`hfield.errors.LatticeError` if the file
        cannot be written.
        """
        if str(path).endswith(".html"):
            from hfield.fuchsian.page import write

            return write(self, path, dark, replace, points)
        from hfield.fuchsian.picture import draw

        draw(self, path, dark=dark, depth=depth, replace=replace, points=points)

    def _repr_svg_(self) -> str:
        """The domain as SVG, for notebooks."""
        from hfield.fuchsian.picture import svg

        return svg(self)


class NormOneGroup(Certified, Hinted):
    """The units of norm 1 of an order, modulo ±1: a discrete group of motions of the hyperbolic plane.

    >>> from hfield import QuaternionAlgebra
    >>> G = QuaternionAlgebra("QQ", 3, -1).maximal_order().norm_one_group()
    >>> G.area, G.signature
    (Fraction(1, 3), Signature(genus=0, orders=(2, 2, 3, 3), cusps=0))
    """

    foreign_names = GROUP

    def __init__(self, order: SplitOrder) -> None:
        self.order = order

    def __repr__(self) -> str:
        return f"the units of norm 1, modulo ±1, of {self.order}"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, NormOneGroup) and self.order.order == other.order.order

    def __hash__(self) -> int:
        return hash(self.order.order)

    @cached_property
    def area(self) -> Fraction:
        """The area of the plane modulo the group in units of 2π, by Shimizu's formula."""
        return self.order.area()

    @cached_property
    def signature(self) -> Signature:
        """Genus, orders of the elliptic points, and number of cusps, computed from the domain.

        For Eichler orders with an area above 2π·200, formulas with optimal embeddings are used instead. Over
        ℚ and quadratic fields the formulas are compared with every computed domain, and a difference raises
        an error.
        """
        if self.area > MAX_AREA_OF_CENTERS and (found := self._signature_by_formulas()) is not None:
            return found
        found = signature_of(self._domain.partners, self._domain.cycles, self.area)
        if self.order.degree <= 2 and self._signature_by_formulas() not in (None, found):
            raise ArithmeticError("the domain and the formulas for the signature do not agree")
        return found

    def _signature_by_formulas(self) -> Signature | None:
        counts, cusps = self.order.elliptic_points(), self.order.cusps()
        if counts is None or cusps is None:
            return None
        orders = tuple(m for m, n in sorted(counts.items()) for _ in range(n))
        return _signature(self.area, orders, cusps)

    @property
    def claim(self) -> CertifiedClaim:
        """The claim of signature and presentation, with the domain as evidence."""
        from hfield.fuchsian import certificates

        return certificates.of_group(self, self._domain)

    # --- the domain --------------------------------------------------------------------------------

    def domain(self, center: complex | CMPoint | None = None) -> Domain:
        """Return the Dirichlet domain around a point, by default around one with a small c in the order.

        ``center`` is a complex number of the upper half plane, on which i and j act as real matrices; one of
        the two with positive square acts as a diagonal matrix. The actual centre, ``D.center``, is a nearby
        point that is fixed by an element of trace 0 and by no unit other than ±1. A CM point is used as the
        centre itself. If its stabiliser has order m > 1 modulo ±1, the domain is a sector of angle 2π/m of
        the Dirichlet polygon, and ``D.stabiliser`` maps one of its two sides at the centre to the other.
        Raises :class:`LatticeError`.

        >>> from hfield import QuaternionAlgebra
        >>> G = QuaternionAlgebra(6).maximal_order().norm_one_group()
        >>> D = G.domain(G.cm_points(-3)[0])
        >>> len(D.sides), D.stabiliser**3, D.area == G.area
        (4, 1, True)
        """
        from hfield.fuchsian.cm_points import CMPoint

        if center is None:
            return self._domain
        if isinstance(center, CMPoint):
            c = center.root
            stabiliser = center.stabiliser if center.group is self else self._stabiliser(c)
            return self._around(c, stabiliser)
        try:
            z = complex(center)
        except (TypeError, ValueError, OverflowError):
            z = complex("nan")
        if not (z.imag > 0 and abs(z) < MAX_FAR):
            raise LatticeError(
                f"{shorten(center)} is no centre: expected a complex number with positive imaginary part and "
                f"an absolute value below {MAX_FAR:g}, such as 0.5+1j"
            )
        return self._around(self._nearby(z))

    @cached_property
    def _domain(self) -> Domain:
        from hfield.fuchsian import search

        for n, c in enumerate(search.free_centers(self._above or self.order)):
            try:
                return self._around(c)
            except TooLargeError:  # some centres see the plane worse than others
                if n == CENTERS - 1 or self.area > MAX_AREA_OF_CENTERS:
                    raise
        raise TooLargeError("no centre that units do not fix was found; try center=")

    @cached_property
    def _above(self) -> SplitOrder | None:
        """A maximal order above this order whose domain is used, if the index is large enough."""
        from hfield.fuchsian import dirichlet

        return dirichlet.order_above(self.order)

    @cached_property
    def _known(self) -> Rows | None:
        """Coordinates of generators of this order's group, computed from the domain of that maximal order."""
        from hfield.fuchsian import dirichlet

        return (
            None if self._above is None else dirichlet.generators_by_cosets(self.order, self._above)
        )

    def _around(self, c: Quaternion, stabiliser: Quaternion | None = None) -> Domain:
        from hfield.fuchsian import dirichlet

        if stabiliser in (1, -1):
            stabiliser = None
        found, partners, cycles = dirichlet.domain(
            self.order, c, self.area, self._known, stabiliser
        )
        return Domain(self, found, tuple(partners), tuple(cycles))

    def _stabiliser(self, c: Quaternion) -> Quaternion:
        """Return a unit that generates, with −1, the units of norm 1 with the fixed point of c."""
        from hfield.fuchsian import geodesics

        return geodesics.stabiliser(self._domain.polygon, c)

    def _nearby(self, z: complex) -> Quaternion:
        from hfield.fuchsian import search

        # beside it where units fix the point itself, or all that is near and simple
        for n in range(20):
            aside = z.imag * n * complex(0.005, 0.003)
            c = fixing(self.order, z + aside, 2 ** (5 + n))
            if (
                c is not None
                and abs(fixed_point(self.order, c) - z) < z.imag / 8
                and not search.is_fixed(self.order, c)
            ):
                return c
        raise LatticeError(
            f"no point near {z} that units do not fix was found: expected one nearer to 1j"
        )

    # --- closed geodesics --------------------------------------------------------------------------

    def traces(self, most: int) -> tuple[int, ...]:
        """Return the traces t of hyperbolic elements with 2 < t ≤ most, up to sign.

        A closed geodesic of trace t has the length 2·arccosh(t/2). Raises :class:`LatticeError` except for
        Eichler orders over ℤ, and :class:`TooLargeError` for a large ``most``.

        >>> from hfield import QuaternionAlgebra
        >>> G = QuaternionAlgebra.from_ramification("QQ", [2, 11]).eichler_order(3).norm_one_group()
        >>> G.traces(17), round(G.systole, 6)
        ((5, 10, 11, 13, 16, 17), 3.133598)
        """
        if not area.decides_traces(self.order.order):
            raise LatticeError(
                "traces and the systole are computed for Eichler orders over ZZ only"
            )
        if most > MAX_TRACE:
            raise TooLargeError(
                f"there are too many traces up to {shorten(most)}: expected a bound of at most {MAX_TRACE}"
            )
        value = self.order.order
        return tuple(t for t in range(3, most + 1) if area.is_hyperbolic_trace(value, t))

    @property
    def systole(self) -> float:
        """The approximate length of the shortest closed geodesic, ``2·arccosh(t/2)`` for the least trace t.

        Raises :class:`LatticeError` for a non-Eichler order with cusps.
        """
        if not area.decides_traces(self.order.order):
            length = 1.0
            while not (closed := self.geodesics(length)):
                length += 1
            return closed[0].length
        most = 8
        while not (found := self.traces(most)):
            most *= 2
        return 2 * acosh(found[0] / 2)

    def geodesics(self, length: float) -> tuple[Geodesic, ...]:
        """Return the primitive closed geodesics of the quotient up to a length, ordered by length.

        Each geodesic has a unit that translates along it. If several geodesics have the same length, all are
        listed. Raises :class:`LatticeError` if there are cusps, and :class:`TooLargeError`.

        >>> from hfield import QuaternionAlgebra
        >>> G = QuaternionAlgebra.from_ramification("QQ", [2, 3]).maximal_order().norm_one_group()
        >>> [round(g.length, 4) for g in G.geodesics(3)]
        [1.9248, 1.9248, 2.6339, 2.6339]
        """
        from hfield.fuchsian import geodesics

        return geodesics.closed(self._domain, length)

    def conjugator(self, x: object, y: object) -> Quaternion | None:
        """Return a unit u of norm 1 with ``u·x·u⁻¹ == y``; None if there is none.

        This decides whether two embeddings of a quadratic order, given by the images of a generator, are
        conjugate. Raises :class:`LatticeError` for parabolic elements and for axes that end at cusps, and
        :class:`TooLargeError` for very long closed paths.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra.from_ramification("QQ", [2, 3]).maximal_order()
        >>> G = O.norm_one_group(); x, g = G.generators[:2]
        >>> u = G.conjugator(x, g * x * g.conjugate()); u * x == g * x * g.conjugate() * u
        True
        """
        from hfield.fuchsian import geodesics

        element = self.order.algebra
        return geodesics.conjugating_unit(self._domain.polygon, element(x), element(y))

    def fundamental_unit(self, x: object) -> Quaternion:
        """Return the unit of positive trace that generates, with −1, the units of norm 1 commuting with x.

        It is the fundamental unit of norm 1 of the quadratic order ``O ∩ F(x)``, and a primitive hyperbolic
        element. Raises :class:`LatticeError` if x has no axis or its axis ends at cusps, and
        :class:`TooLargeError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ", 3, -1).maximal_order()
        >>> u = O.norm_one_group().fundamental_unit("i"); u.trace(), u.norm()
        (4, 1)
        """
        from hfield.fuchsian import geodesics

        return geodesics.fundamental_unit(self._domain.polygon, self.order.algebra(x))

    # --- CM points -------------------------------------------------------------------------------

    def cm_points(self, d: object) -> tuple[CMPoint, ...]:
        """Return the points fixed by embeddings of the quadratic order of discriminant d < 0.

        The result has one point of the upper half plane for each orbit of the group. Over a number field d is
        a number of the field. An Eichler order of squarefree level N in the algebra of discriminant D has
        h(d)·Π(1 − (S/p))·Π(1 + (S/p)) such points, with p | D in the first product, p | N in the second, and
        Eichler's symbol (Voight, *Quaternion Algebras*, theorem 30.7.3). Raises :class:`LatticeError` unless
        d is a totally negative discriminant, and :class:`TooLargeError`.

        >>> from hfield import QuaternionAlgebra
        >>> G = QuaternionAlgebra(6).maximal_order().norm_one_group()
        >>> G.cm_points(-24)[0], G.cm_points(-7)
        (CM point 0 + 1.01461i of discriminant -24, ())
        """
        from hfield.fuchsian import cm_points

        return cm_points.cm_points(self, d)

    def involution(self, m: int, point: CMPoint) -> CMPoint:
        """Return the image of a CM point under an Atkin–Lehner involution, as one of :meth:`cm_points`.

        ``m`` must be an exact divisor of the discriminant of an Eichler order over ℤ; otherwise
        :class:`LatticeError` is raised.

        >>> from hfield import QuaternionAlgebra
        >>> G = QuaternionAlgebra(6).maximal_order().norm_one_group()
        >>> first, second = G.cm_points(-24)
        >>> G.involution(2, first) == second, G.involution(6, first) == first
        (True, True)
        """
        from hfield.fuchsian import cm_points

        return cm_points.involution(self, m, point)

    def fixed_points(self, m: int) -> tuple[CMPoint, ...]:
        """Return the CM points fixed by an Atkin–Lehner involution with m > 1 (A. Ogg, 1983).

        Their discriminants are −4m, −m, and −4 if m = 2. If there are no cusps, these are all the fixed
        points of the involution, and their number gives the genus of the quotient. Raises
        :class:`LatticeError` as :meth:`involution` does.

        >>> from hfield import QuaternionAlgebra
        >>> G = QuaternionAlgebra(26).maximal_order().norm_one_group()
        >>> [len(G.fixed_points(m)) for m in (2, 13, 26)]
        [2, 2, 6]
        """
        from hfield.fuchsian import cm_points

        return cm_points.fixed_points(self, m)

    # --- larger groups -----------------------------------------------------------------------------

    def quotient(self, *norms: object) -> QuotientOrbifold:
        """Return the quotient of the plane by this group and normalising elements of totally positive norm.

        Without arguments all such elements are taken, otherwise those with the given norms, up to squares of
        ideals, and their products. Norms are exact divisors of the discriminant of an Eichler order (Atkin
        and Lehner): integers over ℤ, else ideals or their generators. Over other fields units of totally
        positive norm are always included. Raises :class:`LatticeError` for other norms and for those of no
        such element, and :class:`TooLargeError`.

        >>> from hfield import QuaternionAlgebra
        >>> G = QuaternionAlgebra.from_ramification("QQ", [2, 3]).maximal_order().norm_one_group()
        >>> G.quotient().signature
        Signature(genus=0, orders=(2, 4, 6), cusps=0)
        """
        from hfield.fuchsian import normaliser

        cosets = normaliser.Cosets(self._domain.polygon, norms)
        _, partners, cycles = normaliser.domain(cosets, self.area)
        area = self.area / len(cosets.elements)
        elements: dict[BaseNumber, Quaternion] = {}
        for w in cosets.elements:
            while w.norm() in elements:  # two ideals may have one norm
                w = 2 * w
            elements[w.norm()] = w
        return QuotientOrbifold(signature_of(partners, cycles, area), area, elements)

    def unit_of_norm(self, u: object) -> Quaternion | None:
        """Return a unit of the order with a given norm, such as −1; None if none was found.

        The search for units starts from many points. If u is negative at a ramified real place there is no
        such unit; otherwise every Eichler order has one. Raises :class:`LatticeError` if u is not a unit.

        >>> from hfield import QuaternionAlgebra
        >>> G = QuaternionAlgebra("QQ", 3, -1).maximal_order().norm_one_group()
        >>> G.unit_of_norm(-1).norm()
        -1
        """
        from hfield.fuchsian import search

        ring = self.order.algebra.ring
        x = ring(u)
        q = self.order.algebra(x)
        if ring.is_zero(x) or q not in self.order or 1 / q not in self.order:
            raise LatticeError(f"{shorten(u)} is not a unit of the integers of {ring.name}")
        norm = self.order.scalar(x)
        if any(value < 0 for value in self.order.values_at_other_places(norm)):
            return None
        return search.element_of_norm(self.order, self.order.basis, norm)

    # --- the presentation --------------------------------------------------------------------------

    @cached_property
    def _presentation(self) -> tuple[tuple[Quaternion, ...], tuple[Word, ...], tuple[Word, ...]]:
        """Generators, relations, and the word of each side's unit."""
        domain = self._domain
        numbers: dict[int, int] = {}
        for n, partner in enumerate(domain.partners):
            if n not in numbers:
                numbers[partner] = -1 - max(numbers.values(), default=0)
                numbers[n] = -numbers[partner]
        # side n has the unit g with inverse ``sides[n].element``
        sides = [domain.polygon.units[n] for n, number in sorted(numbers.items()) if number > 0]
        relations: list[Word] = [
            (numbers[n],) * 2 for n, partner in enumerate(domain.partners) if n == partner
        ]
        for cycle in domain.cycles:
            around = tuple(numbers[n] for n in cycle.sides)  # the inverse of the cycle's product
            relations.append(around * cycle.order)
        left, relations, words = presentation.simplified(len(sides), relations)
        new = {old: n for n, old in enumerate(left, 1)}
        new |= {-old: -n for old, n in new.items()}

        def renamed(word: Word) -> Word:
            return tuple(new[letter] for letter in word)

        of_sides = tuple(
            renamed(words[m] if m > 0 else presentation.inverse(words[-m]))
            for m in (numbers[n] for n in range(len(domain.partners)))
        )
        return tuple(sides[n - 1] for n in left), tuple(map(renamed, relations)), of_sides

    @property
    def generators(self) -> tuple[Quaternion, ...]:
        """Units that generate the group; fewer than the units that pair the sides."""
        return self._presentation[0]

    @property
    def relations(self) -> tuple[Word, ...]:
        """Relations: words in the generators that are ±1, and that imply all other such words."""
        return self._presentation[1]

    @property
    def abelian_invariants(self) -> tuple[int, ...]:
        """The orders of the cyclic factors of the abelianisation, each dividing the next; 0 stands for ℤ."""
        return presentation.abelian_invariants(len(self.generators), self.relations)

    def word(self, x: object) -> Word:
        """Return the word of a unit of norm 1, up to sign; the word of ±1 is ().

        Raises :class:`LatticeError` for an element that is not in the group.
        """
        q = self.order.algebra(x)
        if q not in self.order or q.norm() != 1:
            raise LatticeError(
                f"{shorten(q)} is not a unit of norm 1 of the order: it has norm {q.norm()}"
                + ("" if q in self.order else " and is not in the order")
            )
        polygon, of_sides = self._domain.polygon, self._presentation[2]
        _, path = polygon.reduced(polygon.plane.image(q))
        return presentation.freely_reduced(letter for n in path for letter in of_sides[n])

    def evaluate(self, word: Word) -> Quaternion:
        """Return the product of generators given by a word."""
        product: Quaternion = self.order.algebra(1)
        for letter in word:
            g = self.generators[abs(letter) - 1]
            product = product * (g if letter > 0 else g.conjugate())
        return product
