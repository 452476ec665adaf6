"""Keys of right ideal classes: lattices x⁻¹·I for short elements x of a right ideal I.

An ideal I has the norm ν·a, with ν totally positive and a one of the ideals that represent the narrow classes
of the base. For every x in I the lattice x⁻¹·I lies in the class of I and contains the order. Such lattices
are compared by their Hermite forms in coordinates of the order. A lookup takes the shortest x of a reduced
basis; it need not be proved shortest, since I is in the class of x⁻¹·I in any case.

Only if the lattice is not known, all x of least Tr(u·N(x)/ν) are enumerated, where u runs over the totally
positive units modulo squares. Passing from I to c·I multiplies these x by c, up to units of the base. Of
these, only the x with least coordinates of u·N(x)/ν are kept. So the set of the lattices x⁻¹·I depends only
on the class of I. Each of these lattices arises from as many x as the left order has units modulo those of
the base. The least of their keys represents the class.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from flint import fmpz, fmpz_mat

from hfield.core.properties import cached_property
from hfield.orders.base_values import BaseIdeal, BaseNumber, Integer
from hfield.orders.basis import combined
from hfield.orders.hermite import inverse, tuples
from hfield.orders.lattice_values import LatticeValue

if TYPE_CHECKING:
    from hfield.orders.basis import AlgebraBasis

Key: TypeAlias = tuple[Integer, ...]
MAX_QUOTIENTS = 12
"""From more short elements than this some are chosen by their inner products; over ℤ there are no more."""


@dataclass(frozen=True)
class Norm:
    """The norm ν·a of an ideal: the index of the narrow class of a, and ν."""

    number: int
    element: BaseNumber


class ClassKeys:
    """The data shared by the keys of all right ideals of one order."""

    def __init__(self, order: LatticeValue) -> None:
        self.order, self.ambient = order, order.ambient
        base = order.ambient.base
        self.narrow, self.units = base.narrow_classes, base.positive_units
        back, den = inverse(order.matrix)
        self._left = [matrix * back for matrix in self.ambient.left]
        self._den = den
        self._step: dict[tuple[BaseIdeal, int], Norm] = {}

    def norm_of(self, ideal: BaseIdeal) -> Norm:
        """Return an ideal of the base as the norm of a lattice."""
        return Norm(*self.narrow.split(ideal))

    def multiplied(self, norm: Norm, ideal: BaseIdeal) -> Norm:
        """Return a norm times an ideal of the base."""
        known = ideal, norm.number
        if known not in self._step:
            self._step[known] = self.norm_of(self.narrow.ideals[norm.number] * ideal)
        step = self._step[known]
        return Norm(step.number, step.element * norm.element)

    def quotient(self, rows: fmpz_mat, x: ShortElement) -> Key:
        """Return x⁻¹·I in Hermite form in coordinates of the order, for rows that span I.

        The key consists of the denominator d and the rows whose pivots are not d; the other rows are d times
        a unit row.
        """
        row, times, below = x.inverse_over
        matrix = combined(self._left, row)
        scale = below * x.den * self.ambient.scale * self._den
        domain = self.ambient.domain
        whole, den = (rows * matrix * domain.fraction(times * self.order.den, scale)).numer_denom()
        integer = domain.integer
        d, entries = integer(den), whole.hnf().entries()
        size = self.ambient.size
        kept: list[fmpz] = []
        for k, pivot in enumerate(entries[:: size + 1]):
            if pivot != d:
                kept += entries[k * size : (k + 1) * size]
        return (d, *map(integer, kept))

    def divided(self, rows: fmpz_mat, x: ShortElement) -> tuple[fmpz_mat, int]:
        """Return a basis of x⁻¹·I as rows over a denominator, given a basis of I."""
        ambient = self.ambient
        row, times, below = x.inverse_over
        fraction = ambient.domain.fraction(times, below * x.den * ambient.scale)
        found, den = (rows * ambient.left_matrix(row) * fraction).numer_denom()
        return found, ambient.domain.integer(den)


class ShortElement:
    """An element of a lattice: a row over the denominator of the lattice, and the coordinates of its norm."""

    def __init__(self, ambient: AlgebraBasis, row: list[fmpz], den: int, norm: list[fmpz]) -> None:
        self._ambient, self.row, self.den = ambient, row, den
        self.scaled_norm = norm
        """form_factor·scale·den² times too large."""

    @property
    def norm(self) -> BaseNumber:
        """The reduced norm, a number of the field."""
        domain = self._ambient.domain
        below = self._ambient.scale * self.den**2 * domain.form_factor
        found: BaseNumber = self._ambient.base.element_of(
            [domain.fraction(c, below) for c in self.scaled_norm]
        )
        return found

    @cached_property
    def inverse_over(self) -> tuple[list[Integer], Integer, Integer]:
        """Return an integer row and two numbers: the inverse is the row times the first number over the
        second.
        """
        ambient = self._ambient
        # x⁻¹ = conj(x)/N(x)
        number, below = ambient.inverse_number(self.scaled_norm)
        bar = ambient.times_scalar(ambient.domain.matrix([self.row]) * ambient.conjugation, number)
        times = ambient.scale * self.den * ambient.domain.form_factor
        return bar.entries(), times, below * ambient.conjugate_scale

    @property
    def inverse(self) -> tuple[list[fmpz], int]:
        """The inverse, as an integer row over a denominator."""
        row, times, below = self.inverse_over
        domain = self._ambient.domain
        found, den = (domain.matrix([row]) * domain.fraction(times, below)).numer_denom()
        return found.entries(), domain.integer(den)


class Reduced(NamedTuple):
    """A reduced basis of a sublattice: its Gram matrix, coordinates, and rows."""

    gram: fmpz_mat
    coordinates: fmpz_mat
    rows: fmpz_mat


class Representative(NamedTuple):
    """The representative of a class: a reduced basis, rows over a denominator, and its invariants."""

    rows: fmpz_mat
    den: int
    norm: Norm
    units: int
    """[O_L(I)ˣ : Rˣ], R being the integers of the base."""
    keys: list[Key]
    """Those of the shortest elements."""


class SublatticeKeys:
    """Keys of sublattices of one norm in a lattice; sublattices are given in coordinates of its rows."""

    def __init__(self, keys: ClassKeys, rows: fmpz_mat, den: int, norm: Norm) -> None:
        self.keys, self.rows, self.den, self.norm = keys, rows, den, norm
        self._ambient = ambient = keys.ambient
        self._grams = ambient.forms(rows)
        self._forms = ambient.kernels.class_forms(ambient, self._grams, norm.element, keys.units)
        """Multiples of Tr(u·N(x)/ν), one for each unit u modulo squares, by one factor."""

    def reduced(self, coordinates: fmpz_mat, number: int = 0) -> Reduced:
        """Return a basis of a sublattice that is reduced for one of the forms."""
        gram = coordinates * self._forms[number] * coordinates.transpose()
        gram, change = self._ambient.domain.reduced(gram)
        found = change * coordinates
        return Reduced(gram, found, found * self.rows)

    def with_coordinates(self, coordinates: fmpz_mat) -> Reduced:
        """Return a basis of a sublattice that :meth:`reduced` has returned, from its coordinates."""
        gram = coordinates * self._forms[0] * coordinates.transpose()
        return Reduced(gram, coordinates, coordinates * self.rows)

    def element(self, coordinates: list[Integer]) -> ShortElement:
        """Return the element with given coordinates."""
        row = self._ambient.domain.matrix(1, self._ambient.size, coordinates)
        column = row.transpose()
        norm = [(row * gram * column)[0, 0] for gram in self._grams]
        return ShortElement(self._ambient, (row * self.rows).entries(), self.den, norm)

    @property
    def norm_scale(self) -> Integer:
        """The common factor of the computed coordinates of norms."""
        return self._ambient.scale * self.den**2 * self._ambient.domain.form_factor

    def norm_of_sum(self, numbers: Sequence[int]) -> list[fmpz]:
        """Return the scaled coordinates of the norm of a sum of basis elements."""
        return [sum(gram[m, n] for m in numbers for n in numbers) for gram in self._grams]

    def key(self, basis: Reduced) -> Key:
        """Return x⁻¹·I for a shortest x of a reduced basis."""
        return self.keys.quotient(basis.rows, self.shortest_of(basis))

    def shortest_of(self, basis: Reduced) -> ShortElement:
        """Return a shortest element of a reduced basis."""
        gram, size = basis.gram, basis.gram.nrows()
        length = self._ambient.domain.length
        lengths = [length(gram[k, k]) for k in range(size)]
        k = lengths.index(min(lengths))
        return self.element([basis.coordinates[k, m] for m in range(size)])

    def representative(self, basis: Reduced) -> Representative:
        """Return the representative of the class of a sublattice, from all its shortest elements."""
        elements = self._chosen(self._all_shortest(basis))
        quotients: dict[Key, tuple[ShortElement, int]] = {}
        for x in elements:
            key = self.keys.quotient(basis.rows, x)
            quotients[key] = x, quotients[key][1] + 1 if key in quotients else 1
        x, units = quotients[min(quotients, key=self._ambient.domain.sort_key)]
        rest = Norm(self.norm.number, self.norm.element / x.norm)
        return Representative(*self.keys.divided(basis.rows, x), rest, units, list(quotients))

    def all_shortest(self, basis: Reduced) -> list[ShortElement]:
        """Return all shortest elements of a sublattice, one of ±x."""
        return [self.element(vector) for _, vector in self._all_shortest(basis)]

    def _all_shortest(self, basis: Reduced) -> list[tuple[int, list[int]]]:
        """Return the shortest elements as coordinates, with the index of the form for which they are
        short.
        """
        least, found, domain = -1, list[tuple[int, list[int]]](), self._ambient.domain
        for number, _ in enumerate(self._forms):
            some = self.reduced(basis.coordinates, number) if number else basis
            value, vectors = domain.vectors.least_vectors(tuples(some.gram))
            if least < 0 or value < least:
                least, found = value, []
            if value == least:
                rows = domain.matrix([list(v) for v in vectors]) * some.coordinates
                found += [(number, list(row)) for row in tuples(rows)]
        return found

    def _chosen(self, found: list[tuple[int, list[int]]]) -> list[ShortElement]:
        """Return a subset of the elements, chosen in the same way for every ideal c·I in the class.

        The elements with the least coordinates of u·N(x)/ν are chosen. If more than MAX_QUOTIENTS remain,
        those are chosen whose sorted absolute inner products with the others are least.
        """
        elements = [self.element(vector) for _, vector in found]
        base, units = self._ambient.base, self.keys.units
        if len(found) > 1 and base.degree > 1:
            numbers = [
                x.norm * units[n] / self.norm.element
                for x, (n, _) in zip(elements, found, strict=True)
            ]
            values = list(map(tuple, base.coordinate_rows(numbers).tolist()))
            least = min(values)
            kept = [k for k, value in enumerate(values) if value == least]
            elements, found = [elements[k] for k in kept], [found[k] for k in kept]
        if len(found) <= MAX_QUOTIENTS:
            return elements
        return [elements[k] for k in self._ambient.kernels.least_products(found, self._forms)]
