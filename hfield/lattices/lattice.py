"""Lattices of rank 4 in a quaternion algebra over ℚ: what they are, and their arithmetic."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from flint import fmpq, fmpz_mat, fmpz_poly

from hfield.errors import IndefiniteError, LatticeError, MixedParentsError, TooLargeError, shorten
from hfield.lattices import enumeration, hermite
from hfield.lattices.regular import Regular, regular
from hfield.quaternion import Parent, Quaternion
from hfield.structure.rationals.whole_numbers import fraction

if TYPE_CHECKING:
    from hfield.lattices.order import Order

MANY = 10**6
"""More vectors than this are not listed."""
MOST_STEPS = 2 * 10**7
"""More vectors than this are not run through."""


class Lattice:
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

    multiplied_by_elements = True  # so that ``q * L`` is asked of L

    def __init__(self, algebra: Parent, den: int, matrix: Any) -> None:
        self.algebra, self._den, self._matrix = algebra, den, matrix

    @classmethod
    def spanned(cls, algebra: Parent, elements: Iterable[Any]) -> Lattice:
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

    def _make(self, den: int, matrix: Any) -> Lattice:
        """Return the lattice of the rows of an integer matrix over ``den``, of rank 4."""
        found = hermite.hermite(den, matrix)
        if found is None:
            raise LatticeError("this lattice would have a rank below 4")
        return Lattice(self.algebra, *found)

    # --- what it is ------------------------------------------------------------------------------

    @property
    def _regular(self) -> Regular:
        return regular(self.algebra)

    @cached_property
    def hnf(self) -> tuple[int, hermite.Rows]:
        """The least denominator, and the rows of the Hermite normal form, integers."""
        return self._den, hermite.tuples(self._matrix)

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """The rows of the normal form as elements: a basis, the same for equal lattices."""
        return self._elements(self._matrix)

    def _elements(self, matrix: Any) -> tuple[Quaternion, ...]:
        return tuple(self._element(row) for row in hermite.tuples(matrix))

    def _element(self, row: Sequence[int], den: int | None = None) -> Quaternion:
        d = self._den if den is None else den
        return self.algebra(*(Fraction(x, d) for x in row))

    def _row(self, x: Any) -> tuple[int, list[int]]:
        """Return an element as an integer row over a denominator."""
        return element_row(self.algebra, x)

    def __contains__(self, x: Any) -> bool:
        return hermite.contains(self._den, self._matrix, *self._row(x))

    def coordinates(self, x: Any) -> tuple[Any, ...]:
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

    def __reduce__(self) -> Any:
        return _restore, (type(self), self.algebra, *self.hnf)

    def _same(self, other: Any, what: str) -> Lattice:
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

    def _over(self, den: int) -> Any:
        """Return the matrix over a multiple of the denominator."""
        return self._matrix if den == self._den else self._matrix * (den // self._den)

    def __add__(self, other: Any) -> Lattice:
        """Return the sum, the least lattice that contains both."""
        other = self._same(other, "add")
        den = math.lcm(self._den, other._den)
        rows = self._over(den).entries() + other._over(den).entries()
        return self._make(den, fmpz_mat(8, 4, rows))

    def __and__(self, other: Any) -> Lattice:
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

    def __mul__(self, other: Any) -> Lattice:
        """Return the lattice spanned by all products, or the multiple by an element or a number."""
        if isinstance(other, Lattice):
            return self._product(self._same(other, "multiply"))
        den, row = self._nonzero(other)
        r = self._regular
        return self._make(self._den * den * r.scale, self._matrix * r.right_matrix(row))

    def __rmul__(self, other: Any) -> Lattice:
        den, row = self._nonzero(other)
        r = self._regular
        return self._make(self._den * den * r.scale, self._matrix * r.left_matrix(row))

    def _product(self, other: Lattice) -> Lattice:
        r = self._regular
        rows = r.products(self._matrix, other._matrix)
        return self._make(self._den * other._den * r.scale, rows)

    def _nonzero(self, x: Any) -> tuple[int, tuple[int, ...]]:
        den, row = self._row(x)
        r = self._regular
        if not (fmpz_mat([row]) * r.form * fmpz_mat([[x] for x in row]))[0, 0]:
            raise LatticeError(
                f"a lattice times {shorten(self._element(row, den))} has a rank below 4: its norm is 0"
            )
        return den, tuple(row)

    def __truediv__(self, n: Any) -> Lattice:
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
            return Lattice(self.algebra, self._den, (self._matrix * r.conjugation).hnf())
        return self._make(self._den * r.conjugate_scale, self._matrix * r.conjugation)

    def dual(self) -> Lattice:
        """Return ``{x : tr(x·L) ⊆ ℤ}``, the codifferent of an order (Voight, definition 15.6.2)."""
        return self._make(*self._dual)

    @property
    def _dual(self) -> tuple[int, Any]:
        """A basis of the dual, as rows over a denominator that are in no normal form."""
        r = self._regular
        m, d = hermite.inverse(r.form * self._matrix.transpose())
        return d * r.conjugate_scale, m * r.conjugation * (self._den * r.scale)

    def colon(self, other: Any, side: str = "left") -> Lattice:
        """Return ``{x : x·M ⊆ L}`` for M = other, or ``{x : M·x ⊆ L}`` for ``side="right"``."""
        factor = self._same(other, "divide")
        r, (den, dual) = self._regular, self._dual
        pair = (factor._matrix, dual) if checked_side(side) == "left" else (dual, factor._matrix)
        # x·M ⊆ L exactly when tr(x·M·L′) ⊆ ℤ for the dual L′
        return self._make(den * factor._den * r.scale, r.products(*pair)).dual()

    def index(self, other: Any) -> int | Fraction:
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

        found = self.colon(self, side)
        return Order(found.algebra, found._den, found._matrix)

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

    # --- norms -----------------------------------------------------------------------------------

    def norm(self) -> Any:
        """Return the reduced norm of the lattice, the gcd of the norms of its elements, in QQ."""
        return fmpq(self._content[0], self._regular.scale * self._den * self._den)

    @cached_property
    def _norm(self) -> Fraction:
        return Fraction(int(self._content[0]), self._regular.scale * self._den * self._den)

    @cached_property
    def _content(self) -> tuple[Any, list[Any]]:
        """The gcd of all values of the norm, and the entries of its Gram matrix, both scaled."""
        entries = (self._regular.gram(self._matrix)).entries()
        a, b, c, d, _, e, f, g, _, _, h, i, _, _, _, j = entries
        form = [a // 2, b, c, d, e // 2, f, g, h // 2, i, j // 2]
        return fmpz_poly(form).content(), entries  # the gcd of a list, as flint has it

    @cached_property
    def _even(self) -> Any:
        """The matrix of ``tr(x·conj(y))/norm`` on the basis: integral and even."""
        content, entries = self._content
        return fmpz_mat(4, 4, [x // content for x in entries] if content != 1 else entries)

    def gram_matrix(self) -> tuple[tuple[Any, ...], ...]:
        """Return ``tr(x·conj(y))`` for x, y in :attr:`basis`: twice the norms are on the diagonal."""
        F, norm = self.algebra.ring, self._norm
        return tuple(tuple(F(x * norm) for x in row) for row in hermite.tuples(self._even))

    def _definite(self, what: str) -> None:
        if not self._regular.definite:
            raise IndefiniteError(
                f"{self.algebra} is indefinite, so infinitely many elements may have one norm: "
                f"{what} asks for a definite algebra, a < 0 and b < 0 where t = 0"
            )

    @cached_property
    def _reduced(self) -> tuple[Any, list[list[int]]]:
        """The rows of an LLL-reduced basis, and their matrix of ``tr(x·conj(y))/norm``.

        In an indefinite algebra the basis is reduced for a positive definite form that majorises the norm.
        """
        r, gram = self._regular, self._even
        if r.definite:
            reduced, steps = gram.lll(transform=True, rep="gram")
        else:
            rows = self._matrix
            _, steps = (rows * r.majorant * rows.transpose()).lll(transform=True, rep="gram")
            reduced = steps * gram * steps.transpose()
        return steps * self._matrix, [list(row) for row in hermite.tuples(reduced)]

    def reduced_basis(self) -> tuple[Quaternion, ...]:
        """Return an LLL-reduced basis for the norm, the shortest first in a definite algebra.

        In an indefinite one the norm is replaced by ``|w² …|``, the sum of the absolute values of its terms.
        """
        rows, gram = self._reduced
        found = self._elements(rows)
        if not self._regular.definite:
            return found
        return tuple(found[n] for n in sorted(range(4), key=lambda n: (gram[n][n], n)))

    def _short(self, bound: int) -> Iterator[tuple[tuple[int, ...], int]]:
        """Yield one of ±x for the nonzero elements of norm at most ``bound·norm()``, and their multiples.

        Elements are rows over the denominator of the lattice.
        """
        rows, gram = self._reduced
        a, b, c, d = hermite.tuples(rows)
        for (p, q, r, s), value in enumeration.short_vectors(gram, 2 * bound):
            yield tuple(p * a[n] + q * b[n] + r * c[n] + s * d[n] for n in range(4)), value // 2

    def _least(self) -> int:
        """Return the least norm of a nonzero element, as a multiple of the norm of the lattice."""
        _, gram = self._reduced
        bound = min(gram[n][n] for n in range(4))
        return min(value for _, value in enumeration.short_vectors(gram, bound)) // 2

    def shortest(self) -> tuple[Quaternion, ...]:
        """Return the nonzero elements of least norm, of a definite algebra, x and −x."""
        self._definite("shortest()")
        least = self._least()
        return self._signed(row for row, m in self._short(least) if m == least)

    def elements_of_norm(self, n: Any) -> tuple[Quaternion, ...]:
        """Return all elements of norm n, of a definite algebra.

        Raises :class:`IndefiniteError`, and :class:`TooLargeError` where there are more than a million.
        """
        self._definite("elements_of_norm()")
        multiple = fraction(n) / self._norm
        if multiple.denominator != 1 or multiple < 0:
            return ()
        if not multiple:
            return (self.algebra(0, 0, 0, 0),)
        rows, gram = self._reduced
        wanted = 2 * multiple.numerator
        self._affordable(enumeration.volume(gram, wanted, 3), "elements of norm at most")
        vectors = enumeration.vectors_of_length(gram, wanted)
        return self._signed(_combine(x, rows) for x in vectors)

    def _affordable(self, vectors: float, what: str) -> None:
        if vectors > MOST_STEPS:
            raise TooLargeError(
                f"about {vectors:.0e} {what} the one asked for would have to be run through, and at most "
                f"{MOST_STEPS:.0e} are; O.represent_integer(n) finds one element of large norm"
            )

    def elements_of_norm_at_most(self, n: Any) -> tuple[Quaternion, ...]:
        """Return all elements of norm at most n, 0 too, of a definite algebra, by ascending norm.

        Raises as :meth:`elements_of_norm` does.
        """
        self._definite("elements_of_norm_at_most()")
        bound = math.floor(fraction(n) / self._norm)
        if bound < 0:
            return ()
        found = self._signed(row for row, _ in self._short(bound))
        zero = self.algebra(0, 0, 0, 0)
        return (zero, *sorted(found, key=lambda q: fraction(q.norm())))

    def _signed(self, rows: Iterable[tuple[int, ...]]) -> tuple[Quaternion, ...]:
        """Return the elements of some rows and their negatives, in a fixed order."""
        both: list[tuple[int, ...]] = []
        for row in rows:
            both += (row, tuple(-x for x in row))
            if len(both) > MANY:
                raise TooLargeError(
                    f"more than {MANY} elements have so small a norm; theta_series(n) counts them"
                )
        return tuple(self._element(row) for row in sorted(both, reverse=True))

    def theta_series(self, n: int) -> list[int]:
        """Return [r(0), …, r(n)], where r(m) elements have the norm ``m·norm()``, in a definite algebra.

        Raises :class:`IndefiniteError`.
        """
        self._definite("theta_series()")
        natural(n)
        _, gram = self._reduced
        self._affordable(enumeration.volume(gram, 2 * n, 4), "elements as short as")
        counts = enumeration.count_by_length(gram, 2 * n)
        return [counts.get(2 * m, 0) for m in range(n + 1)]


def element_row(algebra: Parent, x: Any) -> tuple[int, list[int]]:
    """Return what the algebra reads as an element as integer coordinates over a denominator."""
    q = x if isinstance(x, Quaternion) and x.algebra is algebra else algebra(x)
    if q.is_batch:
        raise LatticeError("a lattice is spanned by single elements, and this is an array of them")
    den, rows = hermite.integral([[fraction(c) for c in q.coordinates]])
    return den, rows[0]


def _combine(x: Sequence[int], rows: Any) -> tuple[int, ...]:
    return tuple(int(c) for c in (fmpz_mat([list(x)]) * rows).entries())


def listed(elements: Any) -> list[Any]:
    """Return elements as a list. Raises :class:`LatticeError` for one element, or for what is no list."""
    if isinstance(elements, (str, Quaternion)) or not isinstance(elements, Iterable):
        raise LatticeError(
            f"{shorten(repr(elements))} is no list of elements: expected one, such as [e, i, j, k]"
        )
    return list(elements)


def natural(n: Any) -> None:
    """Raise :class:`LatticeError` unless n is an integer ≥ 0."""
    if not isinstance(n, int) or n < 0:
        raise LatticeError(
            f"a theta series goes up to an integer ≥ 0, and {shorten(repr(n))} is none"
        )


def checked_side(side: str) -> str:
    """Return the side. Raises :class:`LatticeError` unless it is left or right."""
    if side not in ("left", "right"):
        raise LatticeError(f"the side {side!r} does not exist: expected 'left' or 'right'")
    return side


def _restore(kind: type[Lattice], algebra: Parent, den: int, rows: hermite.Rows) -> Lattice:
    """Rebuild a pickled lattice."""
    return kind(algebra, den, fmpz_mat([list(row) for row in rows]))
