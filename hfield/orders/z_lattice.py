"""Lattices of rank 4 over ℤ as values: a Hermite form over its least denominator, and their arithmetic.

Elements are integer rows over a denominator, or quaternions. That two lattices lie in one algebra is not
checked here (Voight, *Quaternion Algebras*, chapters 9, 15 and 16).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from flint import fmpq, fmpz, fmpz_mat, fmpz_poly

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import LatticeError, shorten
from hfield.orders import hermite
from hfield.orders.checked_arguments import element_row, listed
from hfield.orders.regular_representation import regular


class ZLattice:
    """Rows of integers in Hermite form over their least denominator, in an algebra; with the norm on them."""

    def __init__(self, algebra: Parent, den: int, matrix: fmpz_mat) -> None:
        self.algebra, self.den, self.matrix = algebra, den, matrix
        self.regular = regular(algebra)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, ZLattice)
            and self.den == other.den
            and self.matrix == other.matrix
            and self.algebra == other.algebra
        )

    def __hash__(self) -> int:
        return hash(self.hnf)

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, (type(self), self.algebra, *self.hnf)

    @cached_property
    def hnf(self) -> tuple[int, hermite.Rows]:
        """The least denominator, and the rows of the Hermite normal form, integers."""
        return self.den, hermite.tuples(self.matrix)

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """The rows of the normal form as elements: a basis, the same for equal lattices."""
        return self.elements(self.matrix)

    def elements(self, rows: fmpz_mat) -> tuple[Quaternion, ...]:
        """Return rows over the denominator as elements of the algebra."""
        return tuple(self.element(row) for row in hermite.tuples(rows))

    def element(self, row: Sequence[int], den: int | None = None) -> Quaternion:
        """Return a row, over the denominator where no other is given, as an element of the algebra."""
        d = self.den if den is None else den
        return self.algebra(*(Fraction(x, d) for x in row))

    @cached_property
    def norm(self) -> Fraction:
        """The reduced norm of the lattice, the gcd of the norms of its elements."""
        return Fraction(int(self.content), self.regular.scale * self.den * self.den)

    @cached_property
    def content(self) -> fmpz:
        """The gcd of all values of the norm, scaled."""
        g = self._gram
        squares = [g[0, 0] // 2, g[1, 1] // 2, g[2, 2] // 2, g[3, 3] // 2]
        mixed = [g[0, 1], g[0, 2], g[0, 3], g[1, 2], g[1, 3], g[2, 3]]
        return fmpz_poly(squares + mixed).content()  # the gcd of a list, as flint has it

    def multiple(self, row: Sequence[int]) -> int:
        """Return the norm of a row over the denominator, as a multiple of that of the lattice."""
        return int(self.regular.norm(row)) // int(self.content)

    @cached_property
    def _gram(self) -> fmpz_mat:
        return self.regular.gram(self.matrix)

    @cached_property
    def even(self) -> fmpz_mat:
        """The matrix of ``tr(x·conj(y))/norm`` on the basis: integral and even."""
        g = self.content
        return hermite.divided(self._gram, g)

    @cached_property
    def reduced(self) -> tuple[fmpz_mat, list[list[int]]]:
        """The rows of an LLL-reduced basis, and their matrix of ``tr(x·conj(y))/norm``.

        In an indefinite algebra the basis is reduced for a positive definite form that majorises the norm.
        """
        r, gram = self.regular, self.even
        if r.definite:
            reduced, steps = gram.lll(transform=True, rep="gram")
        else:
            rows = self.matrix
            _, steps = (rows * r.majorant * rows.transpose()).lll(transform=True, rep="gram")
            reduced = steps * gram * steps.transpose()
        return steps * self.matrix, [list(row) for row in hermite.tuples(reduced)]


def hermite_form(algebra: Parent, den: int, rows: fmpz_mat) -> ZLattice:
    """Return the lattice of the rows of an integer matrix over ``den``, of rank 4."""
    found = hermite.hermite(den, rows)
    if found is None:
        raise LatticeError("this lattice would have a rank below 4")
    return ZLattice(algebra, *found)


def spanned(algebra: Parent, elements: Iterable[object]) -> ZLattice:
    """Return the lattice that elements span. Raises :class:`LatticeError` when its rank is below 4."""
    regular(algebra)
    den, rows = element_rows(algebra, listed(elements))
    found = hermite.hermite(den, rows)
    if found is None:
        raise LatticeError(
            f"these {rows.nrows()} elements span a lattice of rank {rows.rank()}, and lattices here have "
            "rank 4: give four independent elements"
        )
    return ZLattice(algebra, *found)


def element_rows(algebra: Parent, elements: list[object]) -> tuple[int, fmpz_mat]:
    """Return elements as the rows of an integer matrix over a denominator."""
    found = [element_row(algebra, x) for x in elements]
    den = math.lcm(*(d for d, _ in found))
    entries = [x * (den // d) for d, row in found for x in row]
    return den, fmpz_mat(len(found), 4, entries)


def _restore(kind: type[ZLattice], algebra: Parent, den: int, rows: hermite.Rows) -> ZLattice:
    """Rebuild a pickled lattice."""
    return kind(algebra, den, fmpz_mat([list(row) for row in rows]))


def contains(lattice: ZLattice, x: object) -> bool:
    """Tell whether an element lies in a lattice."""
    return hermite.contains(lattice.den, lattice.matrix, *element_row(lattice.algebra, x))


def coordinates(lattice: ZLattice, x: object) -> tuple[Any, ...]:
    """Return the rational coordinates of an element with respect to the basis, in QQ."""
    den, row = element_row(lattice.algebra, x)
    found, d = hermite.in_coordinates(lattice.matrix, fmpz_mat([row]))
    return tuple(fmpq(c * lattice.den, d * den) for c in found.entries())


def includes(lattice: ZLattice, other: ZLattice) -> bool:
    """Tell whether every element of the other lattice lies in the first."""
    return all(
        hermite.contains(lattice.den, lattice.matrix, other.den, row) for row in other.hnf[1]
    )


def add(first: ZLattice, second: ZLattice) -> ZLattice:
    """Return the sum, the least lattice that contains both."""
    return hermite_form(first.algebra, *_joined(first.den, first.matrix, second.den, second.matrix))


def _joined(d: int, m: fmpz_mat, e: int, n: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return the rows of two square matrices over a common denominator."""
    den = math.lcm(d, e)
    if d != e:
        m, n = m * (den // d), n * (den // e)
    return den, fmpz_mat(8, 4, m.entries() + n.entries())


def meet(first: ZLattice, second: ZLattice) -> ZLattice:
    """Return the intersection, through the sum of the dual lattices for the dot product."""
    duals = (_dot_dual(L.den, L.matrix) for L in (first, second))
    den, rows = _joined(*next(duals), *next(duals))
    total = fmpz_mat(4, 4, rows.hnf().entries()[:16])
    return hermite_form(first.algebra, *_dot_dual(den, total))


def _dot_dual(den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return a basis of the dual lattice for the dot product, rows over a denominator."""
    m, d = hermite.inverse(matrix)
    return d, m.transpose() * den


def product(first: ZLattice, second: ZLattice) -> ZLattice:
    """Return the lattice spanned by all products."""
    r = first.regular
    rows = r.products(first.matrix, second.matrix)
    return hermite_form(first.algebra, first.den * second.den * r.scale, rows)


def multiple(lattice: ZLattice, x: object, side: str) -> ZLattice:
    """Return ``x·L`` for ``side="left"``, ``L·x`` for ``side="right"``. Raises :class:`LatticeError`."""
    den, row = element_row(lattice.algebra, x)
    r = lattice.regular
    if not r.norm(row):
        raise LatticeError(
            f"a lattice times {shorten(lattice.element(row, den))} has a rank below 4: its norm is 0"
        )
    matrix = (r.left_matrix if side == "left" else r.right_matrix)(tuple(row))
    return hermite_form(lattice.algebra, lattice.den * den * r.scale, lattice.matrix * matrix)


def scaled(lattice: ZLattice, x: Fraction | int) -> ZLattice:
    """Return a lattice times a rational number that is not 0."""
    rows = lattice.matrix * abs(x.numerator)
    return hermite_form(lattice.algebra, lattice.den * x.denominator, rows)


def conjugate(lattice: ZLattice) -> ZLattice:
    """Return the lattice of the conjugates."""
    r = lattice.regular
    rows = lattice.matrix * r.conjugation
    if r.conjugate_scale == 1:  # the integer rows are permuted: the denominator stays the least
        return ZLattice(lattice.algebra, lattice.den, rows.hnf())
    return hermite_form(lattice.algebra, lattice.den * r.conjugate_scale, rows)


def dual(lattice: ZLattice) -> ZLattice:
    """Return ``{x : tr(x·L) ⊆ ℤ}``, the codifferent of an order (Voight, definition 15.6.2)."""
    return hermite_form(lattice.algebra, *_dual(lattice))


def _dual(lattice: ZLattice) -> tuple[int, fmpz_mat]:
    """Return a basis of the dual, as rows over a denominator that are in no normal form."""
    r = lattice.regular
    m, d = hermite.inverse(r.form * lattice.matrix.transpose())
    return d * r.conjugate_scale, m * r.conjugation * (lattice.den * r.scale)


def colon(lattice: ZLattice, other: ZLattice, side: str) -> ZLattice:
    """Return ``{x : x·M ⊆ L}`` for M = other, or ``{x : M·x ⊆ L}`` for ``side="right"``."""
    r, (den, rows) = lattice.regular, _dual(lattice)
    pair = (other.matrix, rows) if side == "left" else (rows, other.matrix)
    # x·M ⊆ L exactly when tr(x·M·L′) ⊆ ℤ for the dual L′
    return dual(hermite_form(lattice.algebra, den * other.den * r.scale, r.products(*pair)))


def index(lattice: ZLattice, other: ZLattice) -> Fraction:
    """Return the index of the other lattice in this one, the ratio of the volumes (Voight, section 9.6)."""
    return Fraction(
        hermite.determinant(other.matrix) * lattice.den**4,
        hermite.determinant(lattice.matrix) * other.den**4,
    )


def divisor(lattice: ZLattice, other: ZLattice) -> Fraction:
    """Return the largest m for which the other lattice lies in m times this one."""
    rows, d = hermite.in_coordinates(lattice.matrix, other.matrix)
    return Fraction(math.gcd(*map(int, rows.entries())) * lattice.den, d * other.den)


def rows_json(lattice: ZLattice) -> dict[str, object]:
    """Return a lattice as JSON: its denominator and Hermite rows."""
    return {"den": lattice.den, "rows": [list(row) for row in lattice.hnf[1]]}
