"""The invertible right ideal classes of an order over ℤ_K, in a totally definite algebra.

A class is known by one lattice, so classes are looked up and not compared in pairs. An ideal I has the norm
ν·a, with ν totally positive and a one of the ideals that stand for the narrow classes of K. The x in I of
least Tr(N(x)/ν), over all such ν modulo squares of units, are the same for c·I but for the factor c. Of these
take those for which the numbers Tr(ω·N(x)/ν), and the inner products with the others, come first. Of their
x⁻¹·I that is the key whose Hermite form comes first. It lies in the class, and as many of these x as the left
order has units modulo ℤ_K give it.

Starting from O, neighbours at primes are taken until the mass is used up: then no class is missing, and as
all are different none comes twice (J. Voight, *Quaternion Algebras*, main theorem 26.1.5; M. Kirschmer and
J. Voight, *SIAM J. Comput.* 39, 2010). Neighbours at one prime reach a part of the narrow classes only.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

import flint

from hfield.core.progress import report, track
from hfield.errors import LatticeError, TooLargeError, shorten
from hfield.orders import ideals_of_norm
from hfield.orders.brandt import of_power
from hfield.orders.class_number import mass
from hfield.orders.classes import orbits, renumbered
from hfield.orders.conjugators import conjugator
from hfield.orders.enumeration import Vector, least_vectors
from hfield.orders.invariants import good_primes
from hfield.orders.lattice_values import (
    LatticeValue,
    inverse,
    order_of,
    product,
    times_ideal,
)
from hfield.orders.positive_generators import (
    narrow_classes,
    totally_positive_generator,
    units_modulo_squares,
)
from hfield.orders.short_elements import rows_of_norm

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import Ideal
    from hfield.fields.number_fields.prime_ideals import PrimeIdeal
    from hfield.orders.basis import AlgebraBasis

Key = tuple[int, ...]
Row = list[int]
MOST_CLASSES = 20_000
"""More classes than this are not enumerated."""


def number_by_signs(algebra: Any) -> int:
    """Return the order of the class group of K modulo generators positive at the ramified real places.

    So many right ideal classes has an Eichler order of an algebra that splits at an infinite place
    (M. Eichler, 1938; Voight, *Quaternion Algebras*, chapter 28).
    """
    K: Any = algebra.ring
    places: list[Any] = [v for v in algebra.ramified_places() if v in K.real_places()]
    units = K.unit_group()
    signs = [[int(v.sign(u) < 0) for v in places] for u in (units.torsion, *units.generators)]
    rank = flint.nmod_mat(signs, 2).rank() if places else 0
    return int(K.class_group().order << (len(places) - rank))


@dataclass(frozen=True)
class Norm:
    """The norm of an ideal, ν·a: the number of the narrow class of a, and ν."""

    number: int
    element: FieldElement


class Keys:
    """What finds keys of ideals of one algebra."""

    def __init__(self, ambient: AlgebraBasis) -> None:
        self.ambient = ambient
        self.narrow = narrow_classes(ambient.base.ring)
        self.units = units_modulo_squares(ambient.base.ring)


class Around:
    """What finds keys of sublattices of a lattice that have one norm, given by coordinates in its basis.

    ``ways`` has, for each ν modulo squares of units, the forms Tr(N(x)/ν) and Tr(ω·N(x)/ν), each over a
    common divisor.
    """

    def __init__(self, keys: Keys, norm: Norm, lattice: LatticeValue) -> None:
        self.keys, self.norm = keys, norm
        self.rows, self.den = lattice.matrix, lattice.den
        rows, back = lattice.rows, lattice.rows.transpose()
        every = []
        # the first form is there whether or not 1 is in the integral basis
        for w in (keys.ambient.base.field.one, *keys.ambient.base.integral_basis):
            forms = (keys.ambient.form(u * w / norm.element) for u in keys.units)
            every.append(_without_content([rows * form * back for form in forms]))
        self.ways = list(zip(*every, strict=True))

    def find(self, coordinates: flint.fmpz_mat) -> tuple[Key, int, Row]:
        """Return the key of a sublattice, the units of its left order modulo ℤ_Kˣ, and x·den.

        x⁻¹ times the lattice is the key.
        """
        least = -1
        found: list[Found] = []
        for forms in self.ways:
            gram = coordinates * forms[0] * coordinates.transpose()
            reduced, change = gram.lll(transform=True, rep="gram")
            value, vectors = least_vectors(_table(reduced))
            if least < 0 or value < least:
                least, found = value, []
            if value == least:
                found.append((vectors, change * coordinates, forms))
        matrix, keys = coordinates * self.rows, []
        rows = _table(flint.fmpz_mat(_first(found)) * self.rows)
        for start, units in self._orbits(matrix, rows):
            keys.append((self._key(matrix, start), units, start))
        return min(keys)

    def _orbits(self, matrix: flint.fmpz_mat, rows: list[Row]) -> Iterator[tuple[Row, int]]:
        """Yield an x for each x⁻¹·I, and how many give it: the u·x, u in the group Oˣ/ℤ_Kˣ of the left order.

        The first of them tell the group. Where units have several norms, u·x may have to be divided by a unit
        of the field; then some x⁻¹·I come more than once.
        """
        ambient = self.keys.ambient
        first, rest = self._orbit(matrix, rows)
        yield first[0], len(first)
        if not rest:
            return
        units = flint.fmpq_mat(flint.fmpz_mat(first)) * ambient.times(first[0]).inv()
        group = [ambient.times(u, "left").transpose().tolist() for u in units.tolist()]
        whole, den = flint.fmpq_mat([line for lines in group for line in lines]).numer_denom()
        seen: set[tuple[int, ...]] = set()
        for x in rest:
            if tuple(x) not in seen:
                column = whole * flint.fmpz_mat([[c] for c in x])  # den·u·x, one u after another
                image = [int(c) // int(den) for c in column.entries()]
                for k in range(0, len(image), ambient.size):
                    y = image[k : k + ambient.size]
                    seen |= {tuple(y), tuple(-c for c in y)}
                yield x, len(first)

    def rest(self, row: Row) -> Norm:
        """Return the norm of the lattice that is the key."""
        size = self.keys.ambient.norm([flint.fmpq(c, self.den) for c in row])
        return Norm(self.norm.number, self.norm.element / size)

    def _key(self, matrix: flint.fmpz_mat, row: Row) -> Key:
        """Return x⁻¹·I in Hermite normal form, the denominator first."""
        inverse, den = self.keys.ambient.times(row, "left").inv().numer_denom()
        entries = list(map(int, (matrix * inverse).hnf().entries()))
        common = math.gcd(int(den), *entries)
        return int(den) // common, *(c // common for c in entries)

    def _orbit(self, matrix: flint.fmpz_mat, rows: list[Row]) -> tuple[list[Row], list[Row]]:
        """Return the y that give the same x⁻¹·I as the first, x, and the others: x⁻¹·y is a unit there."""
        if len(rows) == 1:
            return rows, []
        inverse = self.keys.ambient.times(rows[0], "left").inv()
        basis = flint.fmpq_mat(matrix) * inverse
        quotients = flint.fmpq_mat(flint.fmpz_mat(rows)) * inverse
        back, inside, outside = basis.inv(), rows, []
        for row in basis.tolist():
            products = quotients * (self.keys.ambient.times(row) * back)
            if products.numer_denom()[1] == 1:
                continue
            good = [all(c.q == 1 for c in product) for product in products.tolist()]
            outside += [y for y, fits in zip(inside, good, strict=True) if not fits]
            inside = [y for y, fits in zip(inside, good, strict=True) if fits]
            if len(inside) == 1:  # x itself is always there
                break
            table = quotients.tolist()
            quotients = flint.fmpq_mat([q for q, fits in zip(table, good, strict=True) if fits])
        return inside, outside


Found = tuple[list[Vector], flint.fmpz_mat, tuple[flint.fmpz_mat, ...]]


def _first(found: list[Found]) -> list[Row]:
    """Return, of vectors in coordinates of bases, those where some numbers come first, as rows.

    The numbers are the values of the forms but the first, and then, in the first form, the inner products
    with all ±y that have the same values, sorted. They are the same for lattices that differ by an element.
    """
    if sum(len(vectors) for vectors, _, _ in found) == 1:
        return [
            row for vectors, basis, _ in found for row in _table(flint.fmpz_mat(vectors) * basis)
        ]
    import numpy as np

    parts = []
    for vectors, basis, forms in found:
        grams = [_table(basis * form * basis.transpose()) for form in forms]
        size = (max(abs(c) for v in vectors for c in v) * len(grams[0])) ** 2
        size *= max(abs(c) for gram in grams for row in gram for c in row)
        x = np.array(vectors, dtype=np.int64 if size < 2**62 else object)
        parts.append((x, basis, [np.array(gram, dtype=x.dtype) for gram in grams]))
    values = [
        list(zip(*((x @ gram * x).sum(axis=1).tolist() for gram in grams[1:]), strict=True))
        for x, _, grams in parts
    ]
    least = min(map(min, values))
    parts = [
        (x[[v == least for v in own]], basis, grams)
        for (x, basis, grams), own in zip(parts, values, strict=True)
    ]
    products = [np.sort(np.abs(x @ grams[0] @ x.T), axis=1).tolist() for x, _, grams in parts]
    first = min(min(own) for own in products if own)
    rows: list[Row] = []
    for (x, basis, _), own in zip(parts, products, strict=True):
        chosen = [v for v, numbers in zip(x.tolist(), own, strict=True) if numbers == first]
        if chosen:
            rows += _table(flint.fmpz_mat(chosen) * basis)
    return rows


def _without_content(matrices: list[flint.fmpq_mat]) -> list[flint.fmpz_mat]:
    """Return rational matrices over the common divisor of all their entries."""
    den = math.lcm(*(int(m.numer_denom()[1]) for m in matrices))
    tables = [_table((m * den).numer_denom()[0]) for m in matrices]
    common = math.gcd(*(c for table in tables for row in table for c in row))
    return [flint.fmpz_mat([[c // common for c in row] for row in table]) for table in tables]


def _table(matrix: flint.fmpz_mat) -> list[list[int]]:
    return [list(map(int, row)) for row in matrix.tolist()]


class Classes:
    """The classes as values: keys, norms, units of left orders, and neighbours."""

    def __init__(self, ring: Any) -> None:
        self.ring, self.ambient = ring, ring.value.ambient
        self.mass = mass(ring.value)
        if self.mass > MOST_CLASSES:
            raise TooLargeError(
                f"the mass is {self.mass}, so there are more than {MOST_CLASSES} classes: too many"
            )
        self.keys = Keys(self.ambient)
        self.units: list[int] = []
        """[O_L(I)ˣ : ℤ_Kˣ], class by class."""
        self.lattices: list[LatticeValue] = []
        self.norms: list[Norm] = []
        self._numbers: dict[Key, int] = {}
        self._rows: dict[PrimeIdeal, list[Counter[int]]] = {}
        self._exchanged: dict[PrimeIdeal, list[int]] = {}
        self._local: dict[PrimeIdeal, list[flint.fmpq_mat]] = {}
        self._steps: dict[tuple[PrimeIdeal, int], Norm] = {}
        self._enumerate()

    def _enumerate(self) -> None:
        self._left = self.mass
        one = Norm(*self.keys.narrow.split(self.ambient.base.one))
        self._index(self.ring.value, one)
        for prime in self.good_primes():
            if not self._left:
                return
            rows: list[Counter[int]] = []
            while len(rows) < len(self.lattices) and self._left:
                rows.append(self.neighbours_of(len(rows), prime))
                report(self.mass - self._left, self.mass, "the mass")
            if len(rows) == len(self.lattices) and not self._left:
                self._rows[prime] = rows

    def good_primes(self) -> Iterator[PrimeIdeal]:
        """Yield the primes that do not divide the discriminant, ascending by their norms."""
        return good_primes(self.ring.value)

    def _look_up(self, around: Around, coordinates: flint.fmpz_mat) -> int:
        """Return the number of the class of a sublattice, which may be new."""
        key, units, row = around.find(coordinates)
        if key not in self._numbers:
            size = self.ambient.size
            self._numbers[key] = len(self.lattices)
            whole = flint.fmpz_mat(size, size, key[1:])
            self.lattices.append(LatticeValue(self.ambient, key[0], whole))
            self.units.append(units)
            self.norms.append(around.rest(row))
            self._left -= Fraction(1, units)
            if self._left < 0:
                raise AssertionError("the classes found exceed the mass")
        return self._numbers[key]

    def _index(self, lattice: LatticeValue, norm: Norm) -> int:
        """Return the number of the class of an invertible right ideal."""
        size = self.ambient.size
        whole = flint.fmpz_mat([[int(k == m) for m in range(size)] for k in range(size)])
        return self._look_up(Around(self.keys, norm, lattice), whole)

    def neighbours_of(self, n: int, prime: PrimeIdeal) -> Counter[int]:
        """Return how many ideals of relative norm P in class n belong to which class."""
        return Counter(self._classes_inside(n, prime))

    def _classes_inside(self, n: int, prime: PrimeIdeal) -> list[int]:
        """Return the classes of the ideals of relative norm P in class n, in the order of `generators`."""
        lattice = self.lattices[n]
        around = Around(self.keys, self._step(prime, n), lattice)
        inside = ideals_of_norm.coordinates_of_subideals(prime, self._inside(prime), lattice)
        return [self._look_up(around, J) for J in inside]

    def _inside(self, prime: PrimeIdeal) -> list[flint.fmpq_mat]:
        """Return what :func:`coordinates_of_subideals` asks, for a prime."""
        if prime not in self._local:
            found = ideals_of_norm.of_prime_norm(self.ring.value, prime).generators
            scalars = self.ambient.scalars
            spans = [[x for m in scalars for x in (pair * m).tolist()] for pair in found]
            self._local[prime] = list(map(flint.fmpq_mat, spans))
        return self._local[prime]

    def _step(self, prime: PrimeIdeal, n: int) -> Norm:
        """Return the norm of the ideals of relative norm P in class n."""
        before = self.norms[n]
        known = prime, before.number
        if known not in self._steps:
            ideal = self.keys.narrow.ideals[before.number] * self.ambient.base.prime_ideal(prime)
            self._steps[known] = Norm(*self.keys.narrow.split(ideal))
        step = self._steps[known]
        return Norm(step.number, step.element * before.element)

    # --- the classes -------------------------------------------------------------------------------

    def __len__(self) -> int:
        return len(self.lattices)

    def class_of(self, lattice: LatticeValue) -> int:
        """Return the number of the class of an invertible right ideal."""
        return self._index(lattice, Norm(*self.keys.narrow.split(lattice.norm)))

    def _times(self, n: int, by: Callable[[LatticeValue], LatticeValue], norm: Ideal) -> int:
        """Return which class class n becomes when a change of lattices multiplies norms by an ideal."""
        before = self.norms[n]
        whole = self.keys.narrow.ideals[before.number] * norm
        step = Norm(*self.keys.narrow.split(whole))
        return self._index(by(self.lattices[n]), Norm(step.number, step.element * before.element))

    @cached_property
    def central(self) -> list[list[int]]:
        """Which class each becomes by ideals of K that generate the class group."""
        ambient, size, moves = self.ambient, range(len(self)), []
        for a in ambient.base.ring.class_group().generators:
            by = partial(times_ideal, ideal=a)
            moves.append([self._times(n, by, a * a) for n in size])
        return moves

    def exchanged(self, prime: object) -> list[int]:
        """Return which class each becomes by the two-sided prime ideal at a prime.

        Raises :class:`LatticeError` where the order is neither maximal nor Eichler there.
        """
        P = self.ambient.base.prime(prime)
        if P not in self._exchanged:
            ideal = self.ring.two_sided_prime(P)
            self._exchanged[P] = [
                self._times(n, lambda I: product(I, ideal.value), ideal.norm())
                for n in track(range(len(self)), len(self), "types")
            ]
        return self._exchanged[P]

    @cached_property
    def types(self) -> list[int]:
        """The number of the type of each class: which left orders are isomorphic.

        They are the orbits of the invertible two-sided ideals on the classes (Voight, section 18.5): those of
        K and, for maximal and Eichler orders, one at each prime of the discriminant. Left orders of other
        orders are compared.
        """
        primes = [P for P, _ in self.ring.discriminant().factorisation()]
        if self.ring.is_eichler():
            return orbits(len(self), [*self.central, *map(self.exchanged, primes)])
        kinds = orbits(len(self), self.central)
        firsts: dict[int, tuple[int, LatticeValue]] = {}  # a type: units and left order of a class
        names: dict[int, int] = {}
        for n, kind in enumerate(kinds):
            if kind in names:
                continue
            units, order = self.units[n], order_of(self.lattices[n], "left")
            names[kind] = next(
                (
                    other
                    for other, (count, known) in firsts.items()
                    if count == units and conjugator(known, order)[0] is not None
                ),
                kind,
            )
            firsts.setdefault(names[kind], (units, order))
        return renumbered([names[kind] for kind in kinds])

    @property
    def type_number(self) -> int:
        """How many isomorphism classes of left orders there are, as algebras over K."""
        return len(set(self.types))

    # --- Brandt matrices -----------------------------------------------------------------------------

    def neighbours(self, prime: object) -> list[Counter[int]]:
        """Return for each class how many right ideals of relative norm P in it belong to which class."""
        P = self.ambient.base.prime(prime)
        if P not in self._rows:
            self._rows[P] = [
                self.neighbours_of(n, P) for n in track(range(len(self)), len(self), "rows")
            ]
        return self._rows[P]

    def brandt_matrix(self, norm: object) -> list[list[int]]:
        """Return the Brandt matrix of an ideal: [i][j] counts the ideals of that norm in I_i of class j.

        They are the invertible ideals of that relative norm. It may be given as a number that generates it.
        Raises :class:`LatticeError` for what is no ideal of the integers.
        """
        size, ideal = range(len(self)), self.ambient.base.ideal(norm)
        if not ideal.is_integral():
            raise LatticeError(f"expected an ideal of the integers, not {shorten(ideal)}")
        found = flint.fmpz_mat([[int(i == j) for j in size] for i in size])
        for P, e in ideal.factorisation():
            found = found * self._prime_power(self.ambient.base.prime(P), e)
        return [[int(x) for x in row] for row in found.tolist()]

    def _prime_power(self, P: PrimeIdeal, e: int) -> flint.fmpz_mat:
        """Return the Brandt matrix of Pᵉ, by the classes of P·I (Voight, section 41.3).

        Where the algebra ramifies and the order is maximal it is a power. Elements are counted for orders
        that are at P neither maximal nor Eichler of level P.
        """
        exponent, ramified = self.ring.discriminant().valuation(P), P in self.ambient.ramified
        if e == 1 or (exponent == 1 and ramified):
            return self._matrix(self.neighbours(P)) ** e
        ideal = self.ambient.base.prime_ideal(P)
        if exponent > 1:
            return self._by_elements(ideal**e)
        size = range(len(self))

        moved = [self._times(n, lambda I: times_ideal(I, ideal), ideal**2) for n in size]
        central = self._matrix([Counter([n]) for n in moved])
        if exponent:
            return self._at_level(P, central, e)
        return of_power(self._matrix(self.neighbours(P)), central * P.norm(), e)

    def _matrix(self, rows: list[Counter[int]]) -> flint.fmpz_mat:
        return flint.fmpz_mat([[row[j] for j in range(len(self))] for row in rows])

    def _at_level(self, P: PrimeIdeal, central: flint.fmpz_mat, e: int) -> flint.fmpz_mat:
        """Return the Brandt matrix of Pᵉ for an order that is Eichler of level P there.

        With U and V of the ideals of norm P in either column and W of the two-sided one, Pᵉ has those of
        diagonal matrices, Dₑ = Uᵉ + Vᵉ + central·Dₑ₋₂, and W·Dₑ₋₁ (the affine Weyl group of GL₂).
        """
        q, one = P.norm(), central**0
        found = [self._classes_inside(n, P) for n in track(range(len(self)), len(self), "rows")]
        cuts = (slice(q), slice(q, 2 * q), slice(2 * q, None))
        U, V, W = (self._matrix([Counter(classes[cut]) for classes in found]) for cut in cuts)
        diagonal = [one * 0, one]
        for k in range(1, e + 1):
            diagonal.append(U**k + V**k + central * diagonal[-2])
        return diagonal[-1] + W * diagonal[-2]

    def _by_elements(self, norm: Ideal) -> flint.fmpz_mat:
        """Return the Brandt matrix of an ideal for any order: the x·I_j in I_i, x modulo units.

        N(x) generates norm·N(I_i)/N(I_j), and of all x·u, u a unit of the field, one of ±x has one of the
        totally positive generators modulo squares of units as its norm. Raises :class:`TooLargeError`.
        """
        if norm.norm() > ideals_of_norm.MAX_LISTED_IDEALS:
            raise TooLargeError(
                f"there are too many ideals of norm {shorten(norm)} in an order neither maximal nor of "
                "level P at its primes: there they are counted by their elements"
            )
        keys, size = self.keys, range(len(self))
        ideals = keys.narrow.ideals
        generators = {
            (m, n): totally_positive_generator(norm * a / b)
            for m, a in enumerate(ideals)
            for n, b in enumerate(ideals)
        }
        inverses = list(map(inverse, self.lattices))
        table = [[0] * len(self) for _ in size]
        for i in track(size, len(self), "rows"):
            for j in size:
                I, J = self.norms[i], self.norms[j]
                generator = generators[I.number, J.number]
                if generator is not None:
                    between = product(self.lattices[i], inverses[j])
                    values = (generator * u * I.element / J.element for u in keys.units)
                    found = sum(1 for x in values for _ in rows_of_norm(between, x))
                    table[i][j] = found // self.units[j]
        return flint.fmpz_mat(table)

    def hecke_polynomial(self, norm: object) -> list[int]:
        """Return the characteristic polynomial of the Brandt matrix, low degree first."""
        return list(map(int, flint.fmpz_mat(self.brandt_matrix(norm)).charpoly().coeffs()))
