"""Quadratic forms over 𝔽_q[t] that are anisotropic at infinity: reduced bases and vectors of bounded degree.

A form f is a matrix F, not necessarily symmetric, with the values ``f(x) = x·F·x``. The degree of f(x) is a
norm: deg f(x + y) ≤ max(deg f(x), deg f(y)). In a reduced basis the degree of ``f(Σ cₙ·bₙ)`` is the largest
of the degrees of ``f(cₙ·bₙ)``. So the vectors with values of bounded degree form a vector space over 𝔽_q, and
multiples of the bₙ are a basis of it. The leading terms of values whose degrees have the same parity are
norms from the field with q² elements. A basis is reduced if those of each parity are independent over 𝔽_q.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import TYPE_CHECKING, TypeAlias

from hfield.errors import TooLargeError
from hfield.orders.polynomial_matrices import PolynomialMatrix

if TYPE_CHECKING:
    from flint import fq_default, fq_default_poly

    from hfield.orders.domains import PolynomialDomain

MAX_VECTORS = 10**7
"""The largest number of vectors that are run through."""
Form: TypeAlias = "Sequence[Sequence[fq_default_poly]]"
Vector: TypeAlias = "tuple[fq_default_poly, ...]"


class PolynomialVectors:
    """The vectors of bounded degree in forms over the polynomials over GF(q)."""

    def __init__(self, domain: PolynomialDomain) -> None:
        self._domain = domain
        self._field = domain.constants

    # --- reduction ---------------------------------------------------------------------------------

    def reduced(self, form: PolynomialMatrix) -> tuple[PolynomialMatrix, PolynomialMatrix]:
        """Return a form on a reduced basis, and the basis, one vector per row."""
        domain, rows = self._domain, form.tolist()
        size, gen = len(rows), domain.field.gen.num
        change = [[domain.one if m == k else domain.zero for m in range(size)] for k in range(size)]
        while (found := self._relation(rows)) is not None:
            k, terms = found
            longest = rows[k][k].degree()
            for m, c in terms:
                factor = gen ** ((longest - rows[m][m].degree()) // 2) * c
                change[k] = [x - factor * y for x, y in zip(change[k], change[m], strict=True)]
                rows[k] = [x - factor * y for x, y in zip(rows[k], rows[m], strict=True)]
                for row in rows:
                    row[k] = row[k] - factor * row[m]
        return domain.matrix(rows), domain.matrix(change)

    def _relation(
        self, form: list[list[fq_default_poly]]
    ) -> tuple[int, list[tuple[int, fq_default]]] | None:
        """Return a vector whose leading term is a combination of the leading terms of vectors that are at
        most as long.
        """
        degrees = [row[k].degree() for k, row in enumerate(form)]
        for parity in (0, 1):
            some = sorted(
                (k for k in range(len(form)) if degrees[k] % 2 == parity), key=lambda k: degrees[k]
            )
            kept: list[int] = []
            for k in some:
                terms = self._combination(form, degrees, k, kept)
                if terms is not None:
                    return k, terms
                kept.append(k)
        return None

    def _combination(
        self, form: list[list[fq_default_poly]], degrees: list[int], k: int, kept: list[int]
    ) -> list[tuple[int, fq_default]] | None:
        """Return the coefficients of a leading term in terms of others, or None if it is
        independent of them.
        """
        if not kept:
            return None

        def lead(m: int) -> fq_default:
            return form[m][m].leading_coefficient()

        def pairing(m: int, n: int) -> fq_default:
            degree = (degrees[m] + degrees[n]) // 2
            return form[m][n][degree] + form[n][m][degree]

        even = self._field.characteristic == 2
        if len(kept) == 1:
            (m,) = kept
            b, x, y = pairing(m, k), lead(m), lead(k)
            if even:
                return [(m, (y / x).sqrt())] if b == 0 else None
            return [(m, b / (x + x))] if b * b == x * y * 4 else None
        m, n = kept
        x, y, b = pairing(m, m), pairing(n, n), pairing(m, n)
        u, v = pairing(m, k), pairing(n, k)
        scale = (x * y - b * b).inverse()
        return [(m, (u * y - v * b) * scale), (n, (v * x - u * b) * scale)]

    # --- enumeration -------------------------------------------------------------------------------

    def least_vectors(self, form: Form) -> tuple[int, list[Vector]]:
        """Return the least degree of a value, and each x with this degree up to multiplication by constants.

        The form must be reduced, as for the other methods.
        """
        degrees = [row[k].degree() for k, row in enumerate(form)]
        least, domain, size = min(degrees), self._domain, len(form)
        first, *second = [k for k in range(size) if degrees[k] == least]
        self._expect_few(int(self._field.order) * len(second))
        units = [[domain.one if m == k else domain.zero for m in range(size)] for k in range(size)]
        found = [tuple(units[first])]
        for k in second:
            for c in self._field.elements():
                vector = list(units[k])
                vector[first] = domain.constant(c)
                found.append(tuple(vector))
        return least, found

    def dimension(self, form: Form, degree: int) -> int:
        """Return the dimension over GF(q) of the space of vectors with values up to a degree."""
        return sum(map(len, self._exponents(form, degree)))

    def _exponents(self, form: Form, degree: int) -> list[range]:
        """Return the exponents of t in the coordinates of the vectors with values up to a degree."""
        return [range(max((degree - row[k].degree()) // 2 + 1, 0)) for k, row in enumerate(form)]

    def number(self, form: Form, degree: int) -> int:
        """Return the number of vectors with values up to a degree."""
        return int(self._field.order ** self.dimension(form, degree))

    def volume(self, form: Form, value: fq_default_poly, rank: int) -> float:
        """Return the number of vectors whose values have at most the degree of ``value``."""
        return float(self.number(form, value.degree()))

    def vectors_of_length(
        self, form: Form, value: fq_default_poly, expected: str | None = None
    ) -> Iterator[Vector]:
        """Yield one of ±x for every x with a given nonzero value."""
        for x, found in self.short_vectors(form, value.degree()):
            if found == value:
                yield x

    def short_vectors(self, form: Form, degree: int) -> Iterator[tuple[Vector, fq_default_poly]]:
        """Yield one of ±x for every x ≠ 0 with a value up to a degree, with the value.

        Raises :class:`TooLargeError` for more than 10⁷ vectors.
        """
        domain, size = self._domain, len(form)
        self._expect_few(self.number(form, degree))
        choices = [
            list(domain.of_degree_below(len(some))) for some in self._exponents(form, degree)
        ]
        pairs = [[form[m][n] + form[n][m] for n in range(size)] for m in range(size)]
        last = size - 1
        square = form[last][last]
        for head in product(*choices[:last]):
            value, line = domain.zero, domain.zero
            for m, x in enumerate(head):
                if x:
                    line = line + pairs[m][last] * x
                    value = value + form[m][m] * x * x
                    for n in range(m):
                        if head[n]:
                            value = value + pairs[m][n] * x * head[n]
            sign = next((self._is_positive(x) for x in head if x), None)
            if sign is False:
                continue
            for x in choices[last]:
                if sign is None and not (x and self._is_positive(x)):
                    continue
                yield (*head, x), value + x * (line + square * x)

    def _expect_few(self, number: int) -> None:
        if number > MAX_VECTORS:
            raise TooLargeError(
                f"about {number:.0e} elements of a lattice over {self._domain.symbol} would have to be "
                f"tried, and at most {MAX_VECTORS:.0e} are: expected a smaller q, or norms of smaller degree"
            )

    def _is_positive(self, x: fq_default_poly) -> bool:
        """Return whether x is the representative of ±x."""
        c = x.leading_coefficient()
        label = self._field.label
        return bool(label(c) <= label(-c))
