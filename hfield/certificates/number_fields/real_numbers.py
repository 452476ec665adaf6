"""Units of norm 1 of orders over ℤ_K that split at one real place: domains and groups, as over ℚ.

``dirichlet-domain-over-integers{O; c; g | …}`` ·
``norm-one-group-over-integers{O; genus; orders; cusps; g | …; words}``. All is computed in integers of K that
are ordered as real numbers, by that place: bounds of the basis tell the sign of any but 0.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import ceil, floor, gcd
from typing import Any

from hfield.certificates.finding import Finding
from hfield.certificates.glossary import BY_AREA, FIELD, POINCARE, SHIMIZU, SIEGEL
from hfield.certificates.number_fields.classes import coefficients
from hfield.certificates.number_fields.integers import Factors, Integers
from hfield.certificates.number_fields.lattices import Frame, Lattice, a_frame
from hfield.certificates.number_fields.local_types import mass, symbols
from hfield.certificates.number_fields.matrices import Row, rational_rows
from hfield.certificates.number_fields.modular import Vector
from hfield.certificates.orders.algebra import Algebra
from hfield.certificates.orders.fuchsian import Domain
from hfield.certificates.orders.lattice import Element
from hfield.certificates.orders.reading import numbers_of, words_of
from hfield.certificates.rejection import a_list, an_object, reject
from hfield.certificates.scalars.real_roots import RealRoot, real_roots
from hfield.certificates.statement import Setting
from hfield.certificates.work import charge

BITS = 128
"""So precisely bounds at a place are found first."""


class RealPlace:
    """The integers of a field, ordered by a real root of its polynomial."""

    def __init__(self, integers: Integers, root: RealRoot) -> None:
        self.integers, self._root = integers, root
        self._bounds: list[list[tuple[int, int]]] = []

    def sign(self, x: Vector) -> int:
        """Return the sign of an integer."""
        if not any(x):
            return 0
        n = 0
        while True:
            if n == len(self._bounds):
                self._refine()
            bounds = self._bounds[n]
            charge(2 * len(x) + sum(map(int.bit_length, x)) * (BITS << n) // 500_000)
            least = sum(c * ends[c < 0] for c, ends in zip(x, bounds, strict=True))
            most = sum(c * ends[c > 0] for c, ends in zip(x, bounds, strict=True))
            if least > 0 or most < 0:
                return 1 if least > 0 else -1
            n += 1

    def _refine(self) -> None:
        """Find bounds of the basis with twice as many bits."""
        bits = BITS << len(self._bounds)
        self._root = self._root.within(Fraction(1, 1 << bits))
        values = map(self._root.bounds, self.integers.rows)
        self._bounds.append([(floor(a * 2**bits), ceil(b * 2**bits)) for a, b in values])


class Real:
    """An integer of a field as a real number, by its value at a place."""

    __slots__ = ("place", "row")

    def __init__(self, place: RealPlace, row: Vector) -> None:
        self.place, self.row = place, row

    def _row(self, other: Any) -> Vector:
        if isinstance(other, Real):
            return other.row
        return tuple(other * c for c in self.place.integers.one)

    def __add__(self, other: Any) -> "Real":
        if isinstance(other, int) and not other:
            return self
        return Real(
            self.place, tuple(a + b for a, b in zip(self.row, self._row(other), strict=True))
        )

    __radd__ = __add__

    def __neg__(self) -> "Real":
        return Real(self.place, tuple(-a for a in self.row))

    def __sub__(self, other: Any) -> "Real":
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> "Real":
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, int):
            return Real(self.place, tuple(other * a for a in self.row)) if other else 0
        return Real(self.place, self.place.integers.mul(self.row, other.row))

    __rmul__ = __mul__

    def __floordiv__(self, n: int) -> "Real":
        return Real(self.place, tuple(a // n for a in self.row))

    def __bool__(self) -> bool:
        return any(self.row)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Real | int) and self.row == self._row(other)

    def __hash__(self) -> int:
        return hash(self.row)

    def __lt__(self, other: Any) -> bool:
        return self.place.sign((self - other).row) < 0

    def __gt__(self, other: Any) -> bool:
        return self.place.sign((self - other).row) > 0

    def __le__(self, other: Any) -> bool:
        return not self > other

    def __ge__(self, other: Any) -> bool:
        return not self < other

    def bit_length(self) -> int:
        """Return how long its longest coordinate is."""
        return max(map(int.bit_length, self.row))


class RealAlgebra(Algebra):
    """An algebra over K at a real place."""

    def __init__(self, setting: Setting, base: Frame, place: RealPlace) -> None:
        self.place, n = place, base.n

        def parts(x: Any) -> tuple[int, Real]:
            den, row = base.integers.coordinates(coefficients(base.ring, x))
            return den, Real(place, row)

        self._blocks = [slice(k * n, k * n + n) for k in range(4)]
        self._tabulate(setting, parts)

    def element(self, den: int, row: Sequence[int]) -> Element:
        """Return an element, of coordinates over ℤ."""
        return Element(
            *self.primitive(tuple(Real(self.place, tuple(row[b])) for b in self._blocks), den)
        )

    def primitive(self, row: Row, den: int = 0) -> tuple[int, Row]:
        """Divide a row, and a denominator, by the positive integers that divide all of it."""
        row = tuple(x if isinstance(x, Real) else self._zero + x for x in row)
        common = gcd(den, *(c for x in row for c in x.row))
        return den // common, tuple(x // common for x in row)

    @property
    def _zero(self) -> Real:
        return Real(self.place, (0,) * self.place.integers.n)


class _Order:
    """An order at the one real place where the algebra splits."""

    def __init__(self, setting: Setting, data: Mapping[str, Any], text: str) -> None:
        self.base = base = a_frame(setting, data["basis"])
        self.lattice = base.order(text)
        self.algebra = RealAlgebra(
            setting, base, RealPlace(base.integers, _split_place(setting, base))
        )
        self.area = area(self.lattice, Factors(base.integers, data["primes"]))

    def holds(self, den: int, rows: Sequence[Row]) -> bool:
        """Tell whether rows over a denominator lie in the order."""
        return self.lattice.holds(den, [tuple(c for x in row for c in x.row) for row in rows])

    def read(self, text: str) -> list[Element]:
        """Read elements of the statement."""
        found = (rational_rows([row]) for row in self.base.elements(text))
        return [self.algebra.element(den, row) for den, (row,) in found]

    def given(self, value: object) -> Element:
        """Read an element of the evidence."""
        return self.algebra.element(*self.base.element(value))

    def domain(self, center: Element, units: Sequence[Element]) -> Domain:
        """Return the domain."""
        charge(2_500 * self.base.n * len(units))
        return Domain(self, self.area, center, units)


def _split_place(setting: Setting, base: Frame) -> RealRoot:
    """Return the root at whose place the algebra splits; rejects unless it is one, and all are real."""
    ring, roots = base.ring, real_roots(base.field.modulus)
    a, t, b = (ring.value(tree, "a structure constant") for tree in setting.constants)
    d = ring.add(ring.mul(t, t), ring.mul(ring.number(4), a))
    first, second = (coefficients(ring, x) for x in (d, b))
    found = [root for root in roots if root.sign(first) > 0 or root.sign(second) > 0]
    if len(roots) < base.n or len(found) != 1:
        reject("groups are of algebras over totally real fields that split at one real place")
    return found[0]


def area(order: Lattice, factors: Factors) -> Fraction:
    """Return the area of the plane modulo the units of norm 1 over 2π: Shimizu's formula, which is cited.

    It is twice the mass, divided by the local indices of norms of units: 2 at an odd prime with the symbol 0,
    where they are the squares modulo it.
    """
    found = 2 * mass(order, factors)
    for q, symbol in symbols(order, factors):
        if symbol == 0 and q % 2 == 0:
            reject("the area is not known here where an Eichler symbol above 2 is 0")
        found /= 1 if symbol else 2
    return found


# --- the statements -----------------------------------------------------------------------------------


def _is_domain(parts: tuple[str, ...], setting: Setting, verdict: str, evidence: Any) -> Finding:
    _expect("dirichlet-domain-over-integers", verdict, evidence)
    data = an_object(evidence, "kind basis primes", "the evidence")
    order = _Order(setting, data, parts[0])
    center = order.read(parts[1])
    if len(center) != 1:
        reject("a domain has one centre")
    order.domain(center[0], order.read(parts[2]))
    return Finding(FIELD, BY_AREA).citing(SIEGEL, SHIMIZU)


def _is_group(parts: tuple[str, ...], setting: Setting, verdict: str, evidence: Any) -> Finding:
    _expect("norm-one-group-over-integers", verdict, evidence)
    data = an_object(evidence, "kind basis primes center units", "the evidence")
    order = _Order(setting, data, parts[0])
    units = [order.given(x) for x in a_list(data["units"], "units")]
    order.domain(order.given(data["center"]), units).need_group(
        (Fraction(parts[1]), list(numbers_of(parts[2])), Fraction(parts[3])),
        order.read(parts[4]),
        list(words_of(parts[5])),
    )
    return Finding(FIELD, BY_AREA).citing(SIEGEL, SHIMIZU, POINCARE)


def _expect(word: str, verdict: str, evidence: Any) -> None:
    if verdict != "proved" or not isinstance(evidence, dict) or evidence.get("kind") != word:
        reject(f"evidence of this kind does not show that {word} is {verdict}")


_WHOLE, _LETTERS = "(0|[1-9][0-9]{0,9})", "-?[1-9][0-9]{0,3}( +-?[1-9][0-9]{0,3})*"
FORMS = {
    "dirichlet-domain-over-integers": "[^;]+;[^;]+;[^;]+",
    "norm-one-group-over-integers": f"[^;]+;{_WHOLE};(none|{_WHOLE}(,{_WHOLE})*);{_WHOLE};[^;]+;"
    f"(none|{_LETTERS}(,{_LETTERS})*)",
}
CHECKS = {
    "dirichlet-domain-over-integers": _is_domain,
    "norm-one-group-over-integers": _is_group,
}
