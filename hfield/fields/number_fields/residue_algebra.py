"""Decompose the algebra O/pO of an order of a number field into local algebras, one for each prime above
p.

If ℤ[s] is not maximal at p, its primitive idempotents determine the primes (Buchmann and Lenstra; H. Cohen,
*A Course in Computational Algebraic Number Theory*, section 6.2).
"""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.core.primality import WORD
from hfield.errors import TooLargeError, shorten
from hfield.fields.base.residue_polynomials import (
    coefficients,
    idempotent,
    residues,
    sorted_factors,
)
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.integers import (
    LocalOrder,
    left_kernel,
    multiplication_tables,
    one_in,
    p_radical,
    residue_matrix,
)
from hfield.fields.number_fields.prime_ideals import PrimeIdeal

if TYPE_CHECKING:
    pass


def by_idempotents(order: LocalOrder) -> tuple[PrimeIdeal, ...]:
    """Decompose the algebra O/pO by idempotents."""
    algebra = _ResidueAlgebra(order)
    out = [_at_idempotent(algebra, e) for e in algebra.idempotents(algebra.prime_count())]
    out.sort(key=lambda P: (P.f, P.e, P.order.coordinates(P.pi)[0][::-1]))
    return tuple(out)


class _ResidueAlgebra:
    """The algebra O/pO of an order: elements are rows of coordinates modulo p."""

    def __init__(self, order: LocalOrder) -> None:
        self.order, self.p, self.n = order, order.p, order.field.degree
        if self.p >= WORD:
            raise TooLargeError(
                f"the residues of an order modulo {shorten(self.p)} are not computed"
            )
        table = multiplication_tables(order.field, order.rows)
        self.table = [residue_matrix(m, self.p) for m in table]
        self.one = self.row(one_in(order.rows))
        self.radical = p_radical(table, self.p, order.rows)

    def row(self, values: list[int]) -> flint.nmod_mat:
        return flint.nmod_mat(1, self.n, [v % self.p for v in values], self.p)

    def matrix(self, x: flint.nmod_mat) -> flint.nmod_mat:
        """Return the matrix of multiplication by x."""
        total = flint.nmod_mat(self.n, self.n, [0] * self.n**2, self.p)
        for c, m in zip(x.entries(), self.table, strict=True):
            if int(c):
                total = total + m * int(c)
        return total

    def at(self, f: flint.nmod_poly, x: flint.nmod_mat) -> flint.nmod_mat:
        """Return f(x) for a polynomial f over GF(p)."""
        m, total = self.matrix(x), self.one * 0
        for c in reversed(coefficients(f)):
            total = total * m + self.one * c
        return total

    def random(self, rng: Random) -> flint.nmod_mat:
        return self.row([rng.randrange(self.p) for _ in range(self.n)])

    def lift(self, x: flint.nmod_mat) -> FieldElement:
        return self.order.element(int(c) for c in x.entries())

    def span(self, rows: list[flint.nmod_mat]) -> list[flint.nmod_mat]:
        """Return a basis, in reduced echelon form, of the space that the rows span."""
        entries = [int(c) for row in rows for c in row.entries()]
        reduced, rank = flint.nmod_mat(len(rows), self.n, entries, self.p).rref()
        return [self.row([int(c) for c in r]) for r in reduced.tolist()[:rank]]

    def idempotents(self, count: int) -> list[flint.nmod_mat]:
        """Return the ``count`` primitive idempotents."""
        rng, found = Random(1), [self.one]
        while len(found) < count:
            x = self.random(rng)
            f = self.matrix(x).charpoly()
            parts = [self.at(idempotent(f, g**e), x) for g, e in sorted_factors(f)]
            products = [e * self.matrix(part) for e in found for part in parts]
            found = [e for e in products if any(int(c) for c in e.entries())]
        return found

    def prime_count(self) -> int:
        """Return the number of primes: the dimension of the space of x with xᵖ = x, modulo the radical."""
        frobenius = [self.one * m**self.p for m in self.table]
        radical = [self.row(r) for r in self.radical]
        n = self.n
        entries = []
        for k, image in enumerate(frobenius):
            row = [int(c) for c in image.entries()]
            row[k] = (row[k] - 1) % self.p
            entries += row
        # x with xᵖ − x in the radical: the kernel of both together
        entries += [int(c) for r in radical for c in r.entries()]
        kernel = left_kernel(flint.nmod_mat(n + len(radical), n, entries, self.p))
        fixed = self.span([self.row(v[:n]) for v in kernel] + [self.one])
        return len(fixed) - len(radical)


def _at_idempotent(algebra: _ResidueAlgebra, epsilon: flint.nmod_mat) -> PrimeIdeal:
    """Return the prime ideal of the local algebra that a primitive idempotent cuts out."""
    order, p, n = algebra.order, algebra.p, algebra.n
    project = algebra.matrix(epsilon)
    units = [algebra.row([int(i == k) for i in range(n)]) for k in range(n)]
    local = algebra.span([u * project for u in units])
    radical = [algebra.row(r) * project for r in algebra.radical]
    inside = algebra.span(radical) if radical else []
    f = len(local) - len(inside)
    e = len(local) // f
    pi = algebra.one - epsilon
    if e > 1:
        squares = algebra.span([r * algebra.matrix(s) for r in inside for s in inside])
        pi = pi + next(r for r in inside if len(algebra.span([*squares, r])) > len(squares))
    # the annihilator of π modulo p
    beta = algebra.row(left_kernel(algebra.matrix(pi))[0])
    residue, gen, images = _residue_field(algebra, epsilon, inside, f)
    return PrimeIdeal(
        order,
        e,
        f,
        algebra.lift(pi) if any(int(c) for c in pi.entries()) else order.field(p),
        algebra.lift(beta),
        algebra.lift(epsilon),
        residue,
        algebra.lift(gen),
        images,
    )


def _residue_field(
    algebra: _ResidueAlgebra, epsilon: flint.nmod_mat, inside: list[flint.nmod_mat], f: int
) -> tuple[flint.nmod_poly, flint.nmod_mat, flint.nmod_mat]:
    """Return a polynomial that defines the residue field, its root, and the matrix that maps coordinates to
    residues.
    """
    p, n, rng = algebra.p, algebra.n, Random(1)
    project = algebra.matrix(epsilon)
    while True:
        gen = algebra.random(rng) if f > 1 else algebra.one
        m = algebra.matrix(gen)
        powers = [epsilon]
        for _ in range(f):
            powers.append(powers[-1] * m)
        if len(algebra.span([*inside, *powers[:f]])) == len(inside) + f:
            break
    # every ε·ωₖ is a combination of the powers, modulo the radical
    basis = [*powers[:f], *inside]
    targets = [algebra.row([int(i == k) for i in range(n)]) * project for k in range(n)]
    solved = [_combination(algebra, basis, t)[:f] for t in [*targets, powers[f]]]
    images = flint.nmod_mat(n, f, [c for row in solved[:n] for c in row], p)
    residue = residues(p, [*(-c for c in solved[n]), 1])
    if f == 1:
        residue = residues(p, [0, 1])
        gen = algebra.one * 0
    return residue, gen, images


def _combination(
    algebra: _ResidueAlgebra, basis: list[flint.nmod_mat], target: flint.nmod_mat
) -> list[int]:
    """Return the coefficients of a vector in terms of linearly independent ones."""
    rows = [*basis, target]
    entries = [int(c) for v in rows for c in v.entries()]
    relation = left_kernel(flint.nmod_mat(len(rows), algebra.n, entries, algebra.p))[0]
    scale = -pow(relation[-1], -1, algebra.p)
    return [c * scale % algebra.p for c in relation[:-1]]
