"""The norm on a lattice of rank 4: its quadratic form, reduced bases, short vectors, theta series."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from flint import fmpq, fmpz_mat, fmpz_poly

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import IndefiniteError, TooLargeError
from hfield.lattices import enumeration, hermite
from hfield.lattices.checked_arguments import natural
from hfield.lattices.regular_representation import Regular, regular
from hfield.rings.whole_numbers import fraction

MANY = 10**6
"""More vectors than this are not listed."""
MOST_STEPS = 2 * 10**7
"""More vectors than this are not run through."""


class NormedLattice:
    """Four rows of integers over a denominator, and the norm of their combinations."""

    def __init__(self, algebra: Parent, den: int, matrix: fmpz_mat) -> None:
        self.algebra, self._den, self._matrix = algebra, den, matrix

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

    def _elements(self, matrix: fmpz_mat) -> tuple[Quaternion, ...]:
        return tuple(self._element(row) for row in hermite.tuples(matrix))

    def _element(self, row: Sequence[int], den: int | None = None) -> Quaternion:
        d = self._den if den is None else den
        return self.algebra(*(Fraction(x, d) for x in row))

    def norm(self) -> fmpq:
        """Return the reduced norm of the lattice, the gcd of the norms of its elements, in QQ."""
        return fmpq(self._content[0], self._regular.scale * self._den * self._den)

    @cached_property
    def _norm(self) -> Fraction:
        return Fraction(int(self._content[0]), self._regular.scale * self._den * self._den)

    @cached_property
    def _content(self) -> tuple[Any, Any]:
        """The gcd of all values of the norm, and the Gram matrix, both scaled."""
        g = self._regular.gram(self._matrix)
        squares = [g[0, 0] // 2, g[1, 1] // 2, g[2, 2] // 2, g[3, 3] // 2]
        mixed = [g[0, 1], g[0, 2], g[0, 3], g[1, 2], g[1, 3], g[2, 3]]
        return fmpz_poly(squares + mixed).content(), g  # the gcd of a list, as flint has it

    @cached_property
    def _even(self) -> fmpz_mat:
        """The matrix of ``tr(x·conj(y))/norm`` on the basis: integral and even."""
        content, gram = self._content
        return gram if content == 1 else fmpz_mat(4, 4, [x // content for x in gram.entries()])

    def gram_matrix(self) -> tuple[tuple[fmpq, ...], ...]:
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
    def _reduced(self) -> tuple[fmpz_mat, list[list[int]]]:
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

    def elements_of_norm(self, n: object) -> tuple[Quaternion, ...]:
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

    def elements_of_norm_at_most(self, n: object) -> tuple[Quaternion, ...]:
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
        n = natural(n, "a theta series goes up to")
        _, gram = self._reduced
        self._affordable(enumeration.volume(gram, 2 * n, 4), "elements as short as")
        counts = enumeration.count_by_length(gram, 2 * n)
        return [counts.get(2 * m, 0) for m in range(n + 1)]


def _combine(x: Sequence[int], rows: fmpz_mat) -> tuple[int, ...]:
    return tuple(int(c) for c in (fmpz_mat([list(x)]) * rows).entries())
