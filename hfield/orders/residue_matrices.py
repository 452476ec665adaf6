"""Matrices over the residue field of a prime polynomial, with the methods of flint's ``nmod_mat``."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from flint import fq_default_poly

    from hfield.orders.domains import PolynomialDomain

Rows: TypeAlias = "list[list[fq_default_poly]]"


class ResidueMatrix:
    """A matrix of polynomials modulo ``p``, with reduced entries."""

    def __init__(self, domain: PolynomialDomain, rows: Rows, p: fq_default_poly) -> None:
        self.domain, self.rows, self.p = domain, rows, p

    def modulus(self) -> fq_default_poly:
        """Return the prime."""
        return self.p

    def nrows(self) -> int:
        """Return the number of rows."""
        return len(self.rows)

    def ncols(self) -> int:
        """Return the number of columns."""
        return len(self.rows[0])

    def tolist(self) -> Rows:
        """Return the rows."""
        return [list(row) for row in self.rows]

    def __getitem__(self, place: tuple[int, int]) -> fq_default_poly:
        return self.rows[place[0]][place[1]]

    def __mul__(self, other: ResidueMatrix | fq_default_poly | int) -> ResidueMatrix:
        """Return the product with a matrix or a polynomial."""
        p, zero = self.p, self.domain.zero
        if not isinstance(other, ResidueMatrix):
            return ResidueMatrix(
                self.domain, [[x * other % p for x in row] for row in self.rows], p
            )
        columns = list(zip(*other.rows, strict=True))
        found = []
        for row in self.rows:
            some = [(k, x) for k, x in enumerate(row) if x]
            found.append([sum((x * column[k] for k, x in some), zero) % p for column in columns])
        return ResidueMatrix(self.domain, found, p)

    def rref(self) -> tuple[ResidueMatrix, int]:
        """Return the reduced echelon form and the rank."""
        rows, p = self.tolist(), self.p
        rank = 0
        for k in range(self.ncols()):
            pivot = next((m for m in range(rank, len(rows)) if rows[m][k]), None)
            if pivot is None:
                continue
            rows[rank], rows[pivot] = rows[pivot], rows[rank]
            inverse = rows[rank][k].inverse_mod(p)
            top = rows[rank] = [x * inverse % p for x in rows[rank]]
            for m, row in enumerate(rows):
                if m != rank and row[k]:
                    factor = row[k]
                    rows[m] = [(x - factor * y) % p for x, y in zip(row, top, strict=True)]
            rank += 1
        return ResidueMatrix(self.domain, rows, p), rank

    def rank(self) -> int:
        """Return the rank."""
        return self.rref()[1]

    def kernel(self) -> Rows:
        """Return a basis of the vectors v with row·v = 0 for every row."""
        reduced, rank = self.rref()
        size, zero, one = self.ncols(), self.domain.zero, self.domain.one
        pivots = [next(k for k, x in enumerate(row) if x) for row in reduced.rows[:rank]]
        found = []
        for free in (k for k in range(size) if k not in pivots):
            vector = [zero] * size
            vector[free] = one
            for row, k in zip(reduced.rows, pivots, strict=False):
                vector[k] = -row[free] % self.p
            found.append(vector)
        return found

    def inv(self) -> ResidueMatrix:
        """Return the inverse."""
        size, zero, one = self.nrows(), self.domain.zero, self.domain.one
        joined = [
            [*row, *(one if m == k else zero for m in range(size))]
            for k, row in enumerate(self.rows)
        ]
        reduced, _ = ResidueMatrix(self.domain, joined, self.p).rref()
        return ResidueMatrix(self.domain, [row[size:] for row in reduced.rows], self.p)
