"""Lattices of rank 4 in a quaternion algebra over ℚ: what they are, and their arithmetic."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from flint import fmpz_mat

from hfield.algebra.quaternion import Parent
from hfield.errors import LatticeError, MixedParentsError, shorten
from hfield.hints import LATTICE, Hinted
from hfield.lattices import hermite
from hfield.lattices.checked_arguments import checked_side, element_row, listed
from hfield.lattices.normed_lattice import NormedLattice
from hfield.lattices.regular_representation import regular
from hfield.rings.whole_numbers import fraction

if TYPE_CHECKING:
    from hfield.lattices.order import Order


class Lattice(Hinted, NormedLattice):
    """The integer combinations of four independent elements of an algebra over ℚ.

    It is kept in its Hermite normal form over (1, i, j, k), so equal lattices are equal, and hash
    alike, however they were given. ``x in L`` asks for membership, ``M <= L`` for containment.

    >>> from hfield import H
    >>> A = H("QQ")
    >>> L = A.lattice([1, "i", "j", "1/2 + 1/2*i + 1/2*j + 1/2*k"])
    >>> L.hnf
    (2, ((1, 1, 1, 1), (0, 2, 0, 0), (0, 0, 2, 0), (0, 0, 0, 2)))
    >>> L.theta_series(4)
    [1, 24, 24, 96, 24]
    """

    elsewhere = LATTICE
    multiplied_by_elements = True  # so that ``q * L`` is asked of L

    @classmethod
    def spanned(cls, algebra: Parent, elements: Iterable[object]) -> Lattice:
        """Return the lattice that elements span over ℤ.

        Raises :class:`LatticeError` when its rank is below 4, :class:`RingError` for an algebra that
        is not over ℚ.
        """
        regular(algebra)
        vectors = [element_row(algebra, x) for x in listed(elements)]
        den = math.lcm(*(d for d, _ in vectors))
        rows = [[x * (den // d) for x in row] for d, row in vectors] or [[0] * 4]
        found = hermite.hermite(den, fmpz_mat(rows))
        if found is None:
            rank = fmpz_mat(rows).rank()
            raise LatticeError(
                f"these {len(vectors)} elements span a lattice of rank {rank}, and lattices here have "
                "rank 4: give four independent elements"
            )
        return Lattice(algebra, *found)

    def _make(self, den: int, matrix: fmpz_mat) -> Lattice:
        """Return the lattice of the rows of an integer matrix over ``den``, of rank 4."""
        found = hermite.hermite(den, matrix)
        if found is None:
            raise LatticeError("this lattice would have a rank below 4")
        return self._in_form(*found)

    def _in_form(self, den: int, matrix: fmpz_mat) -> Lattice:
        """Return the lattice of rows that are in Hermite normal form, over the least denominator."""
        return Lattice(self.algebra, den, matrix)

    # --- what it is ------------------------------------------------------------------------------

    def _row(self, x: object) -> tuple[int, list[int]]:
        """Return an element as an integer row over a denominator."""
        return element_row(self.algebra, x)

    def __contains__(self, x: object) -> bool:
        return hermite.contains(self._den, self._matrix, *self._row(x))

    def coordinates(self, x: object) -> tuple[Any, ...]:
        """Return the rational coordinates of an element with respect to :attr:`basis`."""
        den, row = self._row(x)
        F = self.algebra.ring
        found = hermite.coordinates(self._matrix, row)
        return tuple(F(c * self._den / den) for c in found)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Lattice)
            and self._den == other._den
            and self._matrix == other._matrix
            and self.algebra == other.algebra
        )

    def __hash__(self) -> int:
        return hash(self.hnf)

    def __le__(self, other: Lattice) -> bool:
        """Tell whether every element of this lattice lies in the other."""
        return self._same(other, "compare")._holds(self)

    def __ge__(self, other: Lattice) -> bool:
        return self._holds(self._same(other, "compare"))

    def _holds(self, other: Lattice) -> bool:
        return all(
            hermite.contains(self._den, self._matrix, other._den, row) for row in other.hnf[1]
        )

    def __repr__(self) -> str:
        return f"ℤ⟨{', '.join(map(str, self.basis))}⟩ in {self.algebra}"

    def latex(self) -> str:
        """Write the lattice by its basis over ℤ, and its algebra, in LaTeX."""
        basis = ", ".join(q.text("latex") for q in self.basis)
        return rf"\mathbb{{Z}}\left\langle {basis} \right\rangle \subset {self.algebra.latex()}"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, (type(self), self.algebra, *self.hnf)

    def _same(self, other: object, what: str) -> Lattice:
        if not isinstance(other, Lattice):
            raise LatticeError(
                f"cannot {what} a lattice and {shorten(repr(other))}: expected a lattice"
            )
        if other.algebra is not self.algebra and other.algebra != self.algebra:
            raise MixedParentsError(
                f"cannot {what} a lattice in {self.algebra} and one in {other.algebra}: "
                "they lie in different algebras"
            )
        return other

    # --- arithmetic ------------------------------------------------------------------------------

    def _over(self, den: int) -> fmpz_mat:
        """Return the matrix over a multiple of the denominator."""
        return self._matrix if den == self._den else self._matrix * (den // self._den)

    def __add__(self, other: object) -> Lattice:
        """Return the sum, the least lattice that contains both."""
        other = self._same(other, "add")
        den = math.lcm(self._den, other._den)
        rows = self._over(den).entries() + other._over(den).entries()
        return self._make(den, fmpz_mat(8, 4, rows))

    def __and__(self, other: object) -> Lattice:
        """Return the intersection, through the sum of the dual lattices for the dot product."""
        other = self._same(other, "intersect")
        m, d = hermite.inverse(self._matrix)
        n, e = hermite.inverse(other._matrix)
        den = math.lcm(d, e)
        rows = (m.transpose() * (self._den * (den // d))).entries()
        rows += (n.transpose() * (other._den * (den // e))).entries()
        total = fmpz_mat(8, 4, rows).hnf()
        top = fmpz_mat(4, 4, total.entries()[:16])
        back, f = hermite.inverse(top.transpose())
        return self._make(f, back * den)

    def __mul__(self, other: object) -> Lattice:
        """Return the lattice spanned by all products, or the multiple by an element or a number."""
        if isinstance(other, Lattice):
            return self._product(self._same(other, "multiply"))
        den, row = self._nonzero(other)
        r = self._regular
        return self._make(self._den * den * r.scale, self._matrix * r.right_matrix(row))

    def __rmul__(self, other: object) -> Lattice:
        den, row = self._nonzero(other)
        r = self._regular
        return self._make(self._den * den * r.scale, self._matrix * r.left_matrix(row))

    def _product(self, other: Lattice) -> Lattice:
        r = self._regular
        rows = r.products(self._matrix, other._matrix)
        return self._make(self._den * other._den * r.scale, rows)

    def _nonzero(self, x: object) -> tuple[int, tuple[int, ...]]:
        den, row = self._row(x)
        r = self._regular
        if not (fmpz_mat([row]) * r.form * fmpz_mat([[x] for x in row]))[0, 0]:
            raise LatticeError(
                f"a lattice times {shorten(self._element(row, den))} has a rank below 4: its norm is 0"
            )
        return den, tuple(row)

    def __truediv__(self, n: object) -> Lattice:
        """Return the lattice divided by a rational number."""
        x = fraction(n)
        if not x:
            raise LatticeError("a lattice cannot be divided by 0")
        return self._scaled(1 / x)

    def _scaled(self, x: Fraction) -> Lattice:
        return self._make(self._den * x.denominator, self._matrix * abs(x.numerator))

    def conjugate(self) -> Lattice:
        """Return the lattice of the conjugates."""
        r = self._regular
        if (
            r.conjugate_scale == 1
        ):  # conjugation permutes the integer rows: the denominator stays the least
            return self._in_form(self._den, (self._matrix * r.conjugation).hnf())
        return self._make(self._den * r.conjugate_scale, self._matrix * r.conjugation)

    def dual(self) -> Lattice:
        """Return ``{x : tr(x·L) ⊆ ℤ}``, the codifferent of an order (Voight, definition 15.6.2)."""
        return self._make(*self._dual)

    @property
    def _dual(self) -> tuple[int, fmpz_mat]:
        """A basis of the dual, as rows over a denominator that are in no normal form."""
        r = self._regular
        m, d = hermite.inverse(r.form * self._matrix.transpose())
        return d * r.conjugate_scale, m * r.conjugation * (self._den * r.scale)

    def colon(self, other: object, side: str = "left") -> Lattice:
        """Return ``{x : x·M ⊆ L}`` for M = other, or ``{x : M·x ⊆ L}`` for ``side="right"``."""
        factor = self._same(other, "divide")
        r, (den, dual) = self._regular, self._dual
        pair = (factor._matrix, dual) if checked_side(side) == "left" else (dual, factor._matrix)
        # x·M ⊆ L exactly when tr(x·M·L′) ⊆ ℤ for the dual L′
        return self._make(den * factor._den * r.scale, r.products(*pair)).dual()

    def index(self, other: object) -> int | Fraction:
        """Return the index of the other lattice in this one: an int where it is contained.

        Otherwise the ratio of the volumes, a Fraction (Voight, section 9.6).
        """
        other = self._same(other, "compare")
        ratio = self._volume_ratio(other)
        return ratio.numerator if ratio.denominator == 1 else ratio

    def _volume_ratio(self, other: Lattice) -> Fraction:
        return Fraction(
            hermite.determinant(other._matrix) * self._den**4,
            hermite.determinant(self._matrix) * other._den**4,
        )

    def left_order(self) -> Order:
        """Return ``{x : x·L ⊆ L}``, an order; in M₂(ℚ) as in division algebras."""
        return self._order_of("left")

    def right_order(self) -> Order:
        """Return ``{x : L·x ⊆ L}``, an order."""
        return self._order_of("right")

    def _order_of(self, side: str) -> Order:
        from hfield.lattices.order import Order

        # norms and traces generate N(L)·ℤ in L·conj(L), which is N(L) times the left order if L is invertible
        r, content = self._regular, self._content[0]
        den = r.conjugate_scale * int(content)
        rows = r.norm_products(self._matrix, side).entries()
        found = hermite.hermite(den, fmpz_mat(7, 4, [den, 0, 0, 0, *rows]))
        if found is not None:
            order = Order(self.algebra, *found)
            if order._fits(self):
                return order
        return Order._ring(self.colon(self, side))

    def is_invertible(self) -> bool:
        """Tell whether ``L·L⁻¹`` is the left order: whether L is locally principal (Voight, 16.7.7)."""
        return self.left_order()._fits(self)

    def _fits(self, other: Lattice) -> bool:
        """Tell whether an ideal of this order is locally generated by one element.

        Everywhere locally some element has the norm of the ideal, and generates a part of this index.
        """
        content, r = int(other._content[0]), self._regular
        volume = hermite.determinant(other._matrix) * self._den**4 * r.scale**2
        return volume == content * content * hermite.determinant(self._matrix)

    def inverse(self) -> Lattice:
        """Return ``{x : L·x·L ⊆ L}``, the inverse. Raises :class:`LatticeError` where L has none."""
        if not self.is_invertible():
            raise LatticeError(f"{shorten(self)} is not invertible: it is not locally principal")
        return self.conjugate()._scaled(1 / self._norm)

    def is_integral(self) -> bool:
        """Tell whether products of elements of the lattice lie in it."""
        return self._product(self) <= self


def _restore(kind: type[Lattice], algebra: Parent, den: int, rows: hermite.Rows) -> Lattice:
    """Rebuild a pickled lattice."""
    return kind(algebra, den, fmpz_mat([list(row) for row in rows]))
