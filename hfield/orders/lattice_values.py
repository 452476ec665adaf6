"""Lattices of an algebra as values: a Hermite form over its least denominator, and their arithmetic.

A lattice is a module of rank 4 over the integers of the base field. It is stored as a free module over the
domain of the base, of rank 4n over ℤ, in the coordinates of :mod:`hfield.orders.basis`. So the class number
of the base does not matter. Functions do not check that two lattices lie in one algebra (Voight, *Quaternion
Algebras*, chapters 9, 10, 15 and 16).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Self

from flint import fmpq, fmpq_mat, fmpz, fmpz_mat

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.properties import cached_property
from hfield.errors import LatticeError, shorten
from hfield.orders import hermite
from hfield.orders.base_values import BaseIdeal
from hfield.orders.basis import AlgebraBasis, basis_of
from hfield.orders.kernels.general import ideal_multiples
from hfield.orders.validation import expect_number_field, listed


class LatticeValue:
    """Rows of integers in Hermite form over their least denominator, in an algebra; with the norm on them."""

    def __init__(self, ambient: AlgebraBasis, den: int, matrix: fmpz_mat) -> None:
        self.ambient, self.den, self.matrix = ambient, den, matrix

    @classmethod
    def of(cls, lattice: LatticeValue) -> Self:
        """Return a lattice as one of this class."""
        if isinstance(lattice, cls):
            return lattice
        return cls(lattice.ambient, lattice.den, lattice.matrix)

    @property
    def algebra(self) -> Parent:
        """The algebra."""
        return self.ambient.algebra

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, LatticeValue)
            and self.den == other.den
            and self.matrix == other.matrix
            and (self.ambient is other.ambient or self.algebra == other.algebra)
        )

    def __hash__(self) -> int:
        return hash(self.hnf)

    def __reduce__(self) -> tuple[object, ...]:
        pickled = self.ambient.domain.pickled
        rows = tuple(tuple(map(pickled, row)) for row in self.hnf[1])
        return _restore, (type(self), self.algebra, pickled(self.den), rows)

    @cached_property
    def hnf(self) -> tuple[int, hermite.Rows]:
        """The least denominator, and the rows of the Hermite normal form, integers."""
        return self.den, hermite.tuples(self.matrix)

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """The rows of the normal form as elements: a basis over ℤ, the same for equal lattices."""
        return self.elements(self.matrix)

    def elements(self, rows: fmpz_mat) -> tuple[Quaternion, ...]:
        """Return rows over the denominator as elements of the algebra."""
        return tuple(self.element(row) for row in hermite.tuples(rows))

    def element(self, row: Sequence[int], den: int | None = None) -> Quaternion:
        """Return the element of a row, over the lattice's denominator by default."""
        return self.ambient.element(row, self.den if den is None else den)

    @cached_property
    def rows(self) -> fmpq_mat:
        """The basis as rows of rational numbers."""
        return self.matrix * self.ambient.domain.fraction(1, self.den)

    @cached_property
    def inverse_rows(self) -> fmpq_mat:
        """The matrix that maps rows to coordinates in the basis."""
        return self.matrix.inv() * self.den

    # --- the norm ----------------------------------------------------------------------------------

    @cached_property
    def grams(self) -> list[fmpz_mat]:
        """The matrices of the coordinates of ``tr(x·conj(y))`` on the basis, scaled."""
        return self.ambient.grams(self.matrix)

    @cached_property
    def forms(self) -> list[fmpz_mat]:
        """The matrices of the coordinates of norms on the basis (:meth:`AlgebraBasis.forms`), scaled."""
        return self.ambient.forms(self.matrix)

    @cached_property
    def integral_grams(self) -> list[fmpz_mat]:
        """The same, of an order, not scaled: traces and norms of elements of an order are integral."""
        return [hermite.divided(g, self.ambient.scale * self.den**2) for g in self.grams]

    @cached_property
    def integral_forms(self) -> list[fmpz_mat]:
        """The matrices of the coordinates of norms on the basis of an order, not scaled."""
        return [hermite.divided(form, self.ambient.scale * self.den**2) for form in self.forms]

    @cached_property
    def norm(self) -> BaseIdeal:
        """The ideal that the reduced norms of the elements generate; over ℤ their gcd."""
        return self.ambient.kernels.norm(self.ambient, self.forms, self.content, self.den)

    @property
    def _gram(self) -> fmpz_mat:
        """The matrix of a form that is a multiple of ``Tr(N(x))``, that of traces over ℤ, scaled."""
        grams = self.forms
        if len(grams) == 1:
            return grams[0]
        traces = self.ambient.base_traces
        return sum(
            (g * t for g, t in zip(grams[1:], traces[1:], strict=True)), grams[0] * traces[0]
        )

    @cached_property
    def content(self) -> fmpz:
        """The gcd of all values of Tr(N(x)), scaled: over ℤ the norm."""
        return self.ambient.kernels.content(self._gram)

    def multiple(self, row: Sequence[int]) -> int:
        """Return Tr(N(x)) for a row over the denominator, as a multiple of the content."""
        return int(self.ambient.norm_trace(row)) // int(self.content)

    @cached_property
    def even(self) -> fmpz_mat:
        """The matrix of ``Tr(tr(x·conj(y)))`` on the basis over its content: integral and even."""
        return hermite.divided(self._gram, self.content)

    @cached_property
    def reduced(self) -> tuple[fmpz_mat, list[list[int]]]:
        """The rows of an LLL-reduced basis, and their matrix :attr:`even`.

        In an indefinite algebra the basis is reduced for a positive definite form that majorises the norm.
        """
        ambient, gram = self.ambient, self.even
        if ambient.definite:
            reduced, steps = ambient.domain.reduced(gram)
        else:
            rows = self.matrix
            _, steps = (rows * ambient.majorant * rows.transpose()).lll(transform=True, rep="gram")
            reduced = steps * gram * steps.transpose()
        return steps * self.matrix, list(map(list, hermite.tuples(reduced)))

    @property
    def short_rows(self) -> fmpz_mat:
        """The rows of a basis: a reduced one where the algebra has a form for that (``has_majorant``)."""
        return self.reduced[0] if self.ambient.has_majorant else self.matrix

    @cached_property
    def ternary(self) -> tuple[int, fmpz_mat, fmpz_mat]:
        """The elements 2x − tr(x), of an order those of trace 0 in R + 2O (Voight, chapter 22).

        A denominator, rows over it that are a basis over ℤ, and their matrix of ``Tr(tr(x·conj(y)))``, which
        is integral for an order.
        """
        ambient, n = self.ambient, self.ambient.degree
        error = LatticeError(
            "ternary forms exist for orders over ℤ and the integers of number fields, not over "
            f"{ambient.base.symbol}, where 2 may be 0"
        )
        expect_number_field(ambient.base, error)
        rank = 3 * n
        vectors = fmpz_mat([row[n:] for row in self.matrix.tolist()]).hnf().tolist()[:rank]
        without_scalars = fmpz_mat([[0] * n + row for row in vectors])
        c = ambient.conjugate_scale
        rows = without_scalars * (ambient.identity * c - ambient.conjugation)
        den = self.den * c
        gram = rows * ambient.trace_form * rows.transpose()
        scale = ambient.scale * den * den
        return den, rows, fmpz_mat(rank, rank, [x // scale for x in gram.entries()])

    @cached_property
    def reduced_ternary(self) -> tuple[int, fmpz_mat, list[list[int]]]:
        """The same with an LLL-reduced basis, in a definite algebra."""
        den, rows, gram = self.ternary
        reduced, steps = gram.lll(transform=True, rep="gram")
        return den, steps * rows, list(map(list, hermite.tuples(reduced)))

    @cached_property
    def volume(self) -> BaseIdeal:
        """The index ideal of the lattice in that of 1, I, J, IJ; fractional where it is not inside."""
        return self.ambient.kernels.volume(self.ambient, self.matrix, self.den)


def hermite_form(ambient: AlgebraBasis, den: int, rows: fmpz_mat) -> LatticeValue:
    """Return the lattice of the rows of an integer matrix over ``den``, which span it over ℤ."""
    found = hermite.hermite(den, rows)
    if found is None:
        raise LatticeError(
            "this lattice would have a rank below 4: expected generators of a lattice of rank 4 over "
            f"{ambient.base.symbol}"
        )
    return LatticeValue(ambient, *found)


def of_rows(ambient: AlgebraBasis, rows: fmpq_mat) -> LatticeValue:
    """Return the lattice that rational rows span over ℤ."""
    return hermite_form(ambient, *hermite.rational(rows))


def spanned(algebra: Parent, elements: Iterable[object]) -> LatticeValue:
    """Return the lattice that elements span over the integers. Raises :class:`LatticeError` for a low rank.

    Pairs (ideal, element), as of a pseudo-basis, are read too.
    """
    ambient, given = basis_of(algebra), listed(elements)
    den, rows = spanning_rows(ambient, given)
    found = hermite.hermite(den, rows)
    if found is None:
        raise LatticeError(
            f"these {len(given)} elements span a lattice of rank {rows.rank() // ambient.degree}, and "
            "lattices here have rank 4: give four independent elements"
        )
    return LatticeValue(ambient, *found)


def spanning_rows(ambient: AlgebraBasis, elements: Iterable[object]) -> tuple[int, fmpz_mat]:
    """Return rows over a denominator that span over ℤ what elements and pairs span over the integers."""
    base, found = ambient.base, []
    for x in elements:
        ideal, q = (
            (base.ideal(x[0]), x[1]) if isinstance(x, tuple) and len(x) == 2 else (base.one, x)
        )
        den, row = ambient.integral_row(q)
        below, rows = ideal_multiples(ambient, ambient.domain.matrix([row]), ideal)
        found.append((den * below, rows))
    if not found:
        return 1, ambient.domain.matrix(1, ambient.size)
    den = ambient.domain.lcm(*(d for d, _ in found))
    return den, hermite.stacked(*(rows * (den // d) for d, rows in found))


def _restore(
    kind: type[LatticeValue], algebra: Parent, den: int, rows: hermite.Rows
) -> LatticeValue:
    """Rebuild a pickled lattice."""
    ambient = basis_of(algebra)
    return kind(ambient, ambient.domain.integer(den), ambient.domain.matrix(rows))


def contains(lattice: LatticeValue, x: object) -> bool:
    """Return whether an element lies in a lattice."""
    return hermite.contains(lattice.den, lattice.matrix, *lattice.ambient.integral_row(x))


def coordinates(lattice: LatticeValue, x: object) -> tuple[fmpq, ...]:
    """Return the rational coordinates of an element with respect to the basis."""
    found = lattice.ambient.row(x) * lattice.inverse_rows
    return tuple(map(lattice.ambient.base.outside, found.entries()))


def includes(lattice: LatticeValue, other: LatticeValue) -> bool:
    """Return whether every element of the other lattice lies in the first."""
    return all(
        hermite.contains(lattice.den, lattice.matrix, other.den, row) for row in other.hnf[1]
    )


def add(first: LatticeValue, second: LatticeValue) -> LatticeValue:
    """Return the sum, the least lattice that contains both."""
    joined = hermite.joined(first.den, first.matrix, second.den, second.matrix)
    return hermite_form(first.ambient, *joined)


def add_rows(lattice: LatticeValue, rows: fmpq_mat) -> LatticeValue:
    """Return the sum of a lattice and what rows of rational numbers span over ℤ."""
    den, whole = hermite.rational(rows)
    joined = hermite.joined(lattice.den, lattice.matrix, den, whole)
    return hermite_form(lattice.ambient, *joined)


def add_elements(lattice: LatticeValue, rows: fmpq_mat) -> LatticeValue:
    """Return the sum of a lattice and what rows span over the integers of the base."""
    den, whole = hermite.rational(rows)
    multiples = hermite.stacked(*(whole * m for m in lattice.ambient.scalars))
    joined = hermite.joined(lattice.den, lattice.matrix, den, multiples)
    return hermite_form(lattice.ambient, *joined)


def meet(first: LatticeValue, second: LatticeValue) -> LatticeValue:
    """Return the intersection, through the sum of the dual lattices for the dot product."""
    duals = (_dot_dual(L.den, L.matrix) for L in (first, second))
    den, rows = hermite.joined(*next(duals), *next(duals))
    return hermite_form(first.ambient, *_dot_dual(den, _independent(rows)))


def _independent(rows: fmpz_mat) -> fmpz_mat:
    """Return a basis, a square matrix, of what rows of full rank span."""
    size = rows.ncols()
    return rows if rows.nrows() == size else hermite.first_rows(rows.hnf(), size)


def _dot_dual(den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return a basis of the dual lattice for the dot product, rows over a denominator."""
    m, d = hermite.inverse(matrix)
    return d, m.transpose() * den


def product(first: LatticeValue, second: LatticeValue) -> LatticeValue:
    """Return the lattice spanned by all products."""
    ambient = first.ambient
    rows = ambient.products(first.matrix, second.matrix)
    return hermite_form(ambient, first.den * second.den * ambient.scale, rows)


def multiple(lattice: LatticeValue, x: object, side: str) -> LatticeValue:
    """Return ``x·L`` for ``side="left"``, ``L·x`` for ``side="right"``. Raises :class:`LatticeError`."""
    ambient = lattice.ambient
    den, row = ambient.integral_row(x)
    matrix = (ambient.left_matrix if side == "left" else ambient.right_matrix)(row)
    found = hermite.hermite(lattice.den * den * ambient.scale, lattice.matrix * matrix)
    if found is None:
        raise LatticeError(
            f"a lattice times {shorten(lattice.element(row, den))} has a rank below 4: its norm is 0"
        )
    return LatticeValue(ambient, *found)


def scaled(lattice: LatticeValue, x: Fraction | int) -> LatticeValue:
    """Return a lattice times a rational number that is not 0."""
    rows = lattice.matrix * abs(x.numerator)
    return hermite_form(lattice.ambient, lattice.den * x.denominator, rows)


def times_ideal(lattice: LatticeValue, ideal: BaseIdeal) -> LatticeValue:
    """Return a lattice times an ideal of the base."""
    ambient = lattice.ambient
    den, rows = ideal_multiples(ambient, lattice.matrix, ideal)
    if rows.nrows() == ambient.size:  # a multiple of a matrix in Hermite form
        return LatticeValue(ambient, *hermite.reduced(lattice.den * den, rows))
    return hermite_form(ambient, lattice.den * den, rows)


def conjugate(lattice: LatticeValue) -> LatticeValue:
    """Return the lattice of the conjugates."""
    ambient = lattice.ambient
    rows = lattice.matrix * ambient.conjugation
    if ambient.conjugate_scale == 1:  # an automorphism of ℤ⁴ⁿ: the denominator stays the least
        return LatticeValue(ambient, lattice.den, rows.hnf())
    return hermite_form(ambient, lattice.den * ambient.conjugate_scale, rows)


def dual(lattice: LatticeValue) -> LatticeValue:
    """Return the x with tr(x·L) in the integers, the codifferent of an order (Voight, definition 15.6.2)."""
    return hermite_form(lattice.ambient, *_dual(lattice))


def _dual(lattice: LatticeValue) -> tuple[int, fmpz_mat]:
    """Return a basis of the dual, as rows over a denominator that are in no normal form."""
    ambient, other = lattice.ambient, lattice.matrix.transpose()
    columns = hermite.stacked(*((form * other).transpose() for form in ambient.traces))
    m, d = hermite.inverse(_independent(columns).transpose())
    rows = m * ambient.conjugation * (lattice.den * ambient.scale)
    return d * ambient.conjugate_scale, rows


def generated_ideal(order: LatticeValue, generators: list[object], side: str) -> LatticeValue:
    """Return the ideal that elements generate on a side. Raises :class:`LatticeError` for a rank below 4."""
    if not generators:
        raise LatticeError("an ideal has at least one generator, and none was given")
    ambient = order.ambient
    found = [ambient.integral_row(x) for x in generators]
    den = ambient.domain.lcm(*(d for d, _ in found))
    rows = ambient.domain.matrix([[x * (den // d) for x in row] for d, row in found])
    pair = (order.matrix, rows) if side != "right" else (rows, order.matrix)
    products, scale = ambient.products(*pair), ambient.scale * order.den * den
    if side == "two-sided":
        d, left = hermite.span(scale, products)
        products, scale = ambient.products(left, order.matrix), d * order.den * ambient.scale
    whole = hermite.hermite(scale, products)
    if whole is None:
        shown = ", ".join(shorten(x, 30) for x in generators[:4])
        raise LatticeError(
            f"the {side} ideal of {shown} has a rank below 4: expected a generator whose norm is not 0, "
            "such as a number"
        )
    return LatticeValue(ambient, *whole)


def colon(lattice: LatticeValue, other: LatticeValue, side: str) -> LatticeValue:
    """Return ``{x : x·M ⊆ L}`` for M = other, or ``{x : M·x ⊆ L}`` for ``side="right"``."""
    ambient, (den, rows) = lattice.ambient, _dual(lattice)
    pair = (other.matrix, rows) if side == "left" else (rows, other.matrix)
    # x·M ⊆ L exactly when tr(x·M·L′) is integral for the dual L′
    found = ambient.products(*pair)
    return dual(hermite_form(ambient, den * other.den * ambient.scale, found))


def inverse(lattice: LatticeValue) -> LatticeValue:
    """Return ``conj(L)/N(L)``, the inverse of a lattice that is locally principal."""
    return times_ideal(conjugate(lattice), lattice.ambient.base.inverse(lattice.norm))


def order_of(lattice: LatticeValue, side: str) -> LatticeValue:
    """Return the left order ``{x : x·L ⊆ L}``, or the right one ``{x : L·x ⊆ L}``; in M₂ too."""
    # norms and traces generate N(L) in L·conj(L), which is N(L) times the left order if L is invertible
    ambient = lattice.ambient
    pairs = ambient.norm_products(lattice.matrix, side)
    found = hermite.hermite(*ambient.kernels.order_rows(lattice, pairs))
    if found is not None:
        order = LatticeValue(ambient, *found)
        if is_locally_principal(lattice, order):
            return order
    return colon(lattice, lattice, side)


def is_locally_principal(ideal: LatticeValue, order: LatticeValue) -> bool:
    """Return whether an ideal of an order is locally generated by one element (Voight, 16.7.7).

    Everywhere locally some element has the norm of the ideal, and generates a part of this index.
    """
    return ideal.ambient.kernels.is_locally_principal(ideal, order)


def index(lattice: LatticeValue, other: LatticeValue) -> BaseIdeal:
    """Return the index ideal of the other lattice in this one (Voight, section 9.6)."""
    return lattice.ambient.kernels.index(lattice, other)


def scalars_into(lattice: LatticeValue, other: LatticeValue) -> BaseIdeal:
    """Return the ideal of the x of the field with x·L in the other lattice."""
    ambient = lattice.ambient
    images = [(lattice.rows * m * other.inverse_rows).entries() for m in ambient.scalars]
    den, columns = hermite.rational(ambient.domain.fraction_matrix(images).transpose())
    below, rows = _dot_dual(den, _independent(columns))
    return ambient.base.ideal_spanned(rows.entries(), below)


def discriminant(order: LatticeValue) -> BaseIdeal:
    """Return the reduced discriminant of an order, an ideal."""
    return order.ambient.unit_discriminant * order.volume


def rows_json(lattice: LatticeValue) -> dict[str, object]:
    """Return a lattice as JSON: its denominator and Hermite rows."""
    data = lattice.ambient.base.number_data
    return {"den": data(lattice.den), "rows": [list(map(data, row)) for row in lattice.hnf[1]]}
