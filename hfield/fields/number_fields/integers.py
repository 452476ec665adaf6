"""Integers of a number field: p-maximal orders by Dedekind's criterion and Round 2, the integral basis.

H. Cohen, *A Course in Computational Algebraic Number Theory*, sections 6.1.2 to 6.1.4. An order is stored as
a matrix: row n contains the coefficients of the n-th basis element in powers of the generator s.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import cached_property, lru_cache
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.core.factorisation import factorise, remove
from hfield.core.primality import WORD
from hfield.errors import TooLargeError, shorten
from hfield.fields.base.roots import integral
from hfield.fields.number_fields.elements import FieldElement, coefficients

if TYPE_CHECKING:
    from hfield.fields.number_fields.ring import NumberField


class LocalOrder:
    """A ℤ-order of a number field that is maximal at the prime p.

    ``plain`` says that it is, at p, ℤ[s] for the generator s; an order that is not has ``rows``.
    """

    rows: flint.fmpq_mat

    def __init__(self, field: NumberField, p: int) -> None:
        self.field, self.p = field, p
        scale, whole = integral_generator(field)
        self.plain = scale % p != 0 and dedekind(whole, p)
        if not self.plain:
            self.rows = _p_maximal(field, p)

    @cached_property
    def basis(self) -> list[FieldElement]:
        """The basis of the order, if it is not plain."""
        return _elements(self.field, self.rows)

    @cached_property
    def _inverse(self) -> flint.fmpq_mat:
        return self.rows.inv()

    def coordinates(self, x: FieldElement) -> tuple[list[int], int]:
        """Return integers and a denominator, in lowest terms, that give x in the basis or, if plain, in
        powers of s.
        """
        if self.plain:
            numerator = x.poly.numer().coeffs()
            below = int(x.poly.denom())
        else:
            n = self.field.degree
            row = flint.fmpq_mat(1, n, coefficients(x)) * self._inverse
            whole, den = row.numer_denom()
            numerator, below = whole.entries(), int(den)
        return [int(c) for c in numerator], below

    def content(self, x: FieldElement) -> int:
        """Return the greatest k for which x/pᵏ is in the order at p; x is not 0."""
        if self.plain:
            common, below = int(x.poly.numer().content()), int(x.poly.denom())
        else:
            numerators, below = self.coordinates(x)
            common = math.gcd(*numerators)
        return remove(common, self.p)[0] - remove(below, self.p)[0]

    def element(self, coordinates: Iterable[int | flint.fmpq]) -> FieldElement:
        """Return the element with given integers as coordinates."""
        values = [int(c) for c in coordinates]
        if self.plain:
            return FieldElement(self.field, flint.fmpq_poly(values))
        row = flint.fmpq_mat(flint.fmpz_mat(1, self.field.degree, values)) * self.rows
        return FieldElement(self.field, flint.fmpq_poly(row.entries()))

    def truncated(self, x: FieldElement, modulus: int) -> FieldElement:
        """Return an element of the order congruent to x modulo a power of p, for x in the order at p."""
        numerators, below = self.coordinates(x)
        inverse = pow(below, -1, modulus)
        return self.element(c * inverse % modulus for c in numerators)


@lru_cache(maxsize=4096)
def local_order(field: NumberField, p: int) -> LocalOrder:
    """Return the order that is maximal at p."""
    return LocalOrder(field, p)


@lru_cache(maxsize=256)
def integral_generator(field: NumberField) -> tuple[int, flint.fmpz_poly]:
    """Return the least c > 0 such that c·s has a monic integer minimal polynomial, and that polynomial."""
    n, scale = field.degree, 1
    for k in range(n):
        c = field.polynomial[k]  # times scale^(n−k) it must be an integer
        for p, e in factorise(int(c.q)).items() if c.q != 1 else ():
            needed = -(-e // (n - k))
            scale *= p ** max(0, needed - remove(scale, p)[0])
    return scale, integral(field.polynomial, scale)


def dedekind(whole: flint.fmpz_poly, p: int) -> bool:
    """Return whether ℤ[s] is maximal at p, by Dedekind's criterion (Cohen, theorem 6.1.4)."""
    from hfield.fields.base.residue_polynomials import residues

    reduced = residues(p, whole.coeffs())
    if reduced.gcd(reduced.derivative()).degree() == 0:
        return True
    g = residues(p, [1])
    for factor, _ in reduced.factor()[1]:
        g = g * factor
    h = reduced // g
    lifted = [flint.fmpz_poly([int(c) for c in f.coeffs()]) for f in (g, h)]
    defect = lifted[0] * lifted[1] - whole
    rest = residues(p, [c // p for c in defect.coeffs()])
    return bool(rest.gcd(g).gcd(h).degree() == 0)


def _p_maximal(field: NumberField, p: int) -> flint.fmpq_mat:
    """Return the rows of an order that is maximal at p, by Round 2 from ℤ[c·s] (Cohen, algorithm 6.1.8)."""
    if p >= WORD:
        raise TooLargeError(
            f"the order of {shorten(field.name)} at {shorten(p)} is not computed: the prime is too long"
        )
    scale, _ = integral_generator(field)
    n = field.degree
    rows = flint.fmpq_mat(n, n, [scale**i if i == j else 0 for i in range(n) for j in range(n)])
    while True:
        larger = _enlarged(field, rows, p)
        if larger is None:
            return _by_degrees(rows.tolist(), n)
        rows = larger


def _enlarged(field: NumberField, rows: flint.fmpq_mat, p: int) -> flint.fmpq_mat | None:
    """Return the multiplier ring of the p-radical of an order, or None if it is the order itself."""
    n = field.degree
    table = multiplication_tables(field, rows)
    radical = p_radical(table, p, rows)
    ideal = _lattice([*radical, *_multiples(n, p)], n)
    inverse = flint.fmpq_mat(ideal).inv()
    columns = []
    for matrix in table:
        action = flint.fmpq_mat(ideal * matrix) * inverse
        columns.append([int(c.p) % p for c in action.entries()])
    # combinations of the basis that map the ideal into p times itself
    kernel = left_kernel(flint.nmod_mat(n, n * n, [c for row in columns for c in row], p))
    if not kernel:
        return None
    finer = _lattice([*kernel, *_multiples(n, p)], n)
    return flint.fmpq_mat(finer) * rows * flint.fmpq(1, p)


def multiplication_tables(field: NumberField, rows: flint.fmpq_mat) -> list[flint.fmpz_mat]:
    """Return integer matrices; row j of the i-th contains the coordinates of ωⱼ·ωᵢ in the basis ω."""
    n, basis, inverse = field.degree, _elements(field, rows), rows.inv()
    out = []
    for x in basis:
        entries = [c for y in basis for c in coefficients(x * y)]
        whole, den = (flint.fmpq_mat(n, n, entries) * inverse).numer_denom()
        assert den == 1, "an order is a ring"
        out.append(whole)
    return out


def p_radical(table: list[flint.fmpz_mat], p: int, rows: flint.fmpq_mat) -> list[list[int]]:
    """Return vectors that span, modulo p, the nilpotent elements: those with x^(pʲ) = 0, where pʲ ≥ n."""
    n = len(table)
    power = p
    while power < n:
        power *= p
    one = one_in(rows)
    images = [
        (flint.nmod_mat(1, n, one, p) * residue_matrix(matrix, p) ** power).entries()
        for matrix in table
    ]
    return left_kernel(flint.nmod_mat(n, n, [int(c) for row in images for c in row], p))


def one_in(rows: flint.fmpq_mat) -> list[int]:
    """Return the coordinates of 1 in an order."""
    n = rows.nrows()
    return [int(c.p) for c in (flint.fmpq_mat(1, n, [1] + [0] * (n - 1)) * rows.inv()).entries()]


def residue_matrix(matrix: flint.fmpz_mat, p: int) -> flint.nmod_mat:
    """Return an integer matrix modulo p."""
    return flint.nmod_mat(matrix.nrows(), matrix.ncols(), [int(c) % p for c in matrix.entries()], p)


def left_kernel(matrix: flint.nmod_mat) -> list[list[int]]:
    """Return a basis of the row vectors v with v·M = 0 modulo p."""
    kernel, rank = matrix.transpose().nullspace()
    columns = kernel.transpose().tolist()[:rank]
    return [[int(c) for c in row] for row in columns]


def _multiples(n: int, p: int) -> list[list[int]]:
    return [[p if i == j else 0 for j in range(n)] for i in range(n)]


def _lattice(rows: list[list[int]], n: int) -> flint.fmpz_mat:
    """Return a basis, as an n × n matrix in Hermite normal form, of the lattice that integer rows of rank n
    span.
    """
    whole = flint.fmpz_mat(len(rows), n, [c for row in rows for c in row]).hnf()
    return flint.fmpz_mat(n, n, whole.entries()[: n * n])


def _by_degrees(rows: list[list[flint.fmpq]], n: int) -> flint.fmpq_mat:
    """Return a basis in Hermite normal form of the lattice that rational rows span: elements of degrees 0, 1,
    … in s.
    """
    below = math.lcm(*(int(flint.fmpq(c).q) for row in rows for c in row))
    integers = [[int(flint.fmpq(c) * below) for c in reversed(row)] for row in rows]
    basis = [c for row in reversed(_lattice(integers, n).tolist()) for c in reversed(row)]
    return flint.fmpq_mat(flint.fmpz_mat(n, n, basis)) * flint.fmpq(1, below)


def _elements(field: NumberField, rows: flint.fmpq_mat) -> list[FieldElement]:
    return [FieldElement(field, flint.fmpq_poly(row)) for row in rows.tolist()]


@lru_cache(maxsize=256)
def _maximal(field: NumberField) -> tuple[flint.fmpq_mat, int]:
    """Return the rows of the maximal order, of degrees 0, 1, …, and its discriminant."""
    scale, whole = integral_generator(field)
    n, discriminant = field.degree, int(whole.discriminant())
    orders = [local_order(field, p) for p, e in factorise(discriminant).items() if e > 1]
    finer = [order.rows for order in orders if not order.plain]
    rows = [[scale**i if i == j else 0 for j in range(n)] for i in range(n)]
    rows += [row for matrix in finer for row in matrix.tolist()]
    matrix = _by_degrees(rows, n)
    index = matrix.det() / flint.fmpq(scale) ** (n * (n - 1) // 2)
    return matrix, int((index * index * discriminant).p)


def integral_basis(field: NumberField) -> tuple[FieldElement, ...]:
    """Return a basis over ℤ of the ring of integers of the field, of degrees 0, 1, … in s, 1 first."""
    return tuple(_elements(field, _maximal(field)[0]))


def discriminant(field: NumberField) -> int:
    """Return the discriminant of the field."""
    return _maximal(field)[1]


def small_integer(field: NumberField, size: int, rng: Random) -> FieldElement:
    """Return a random integer of the field with coordinates of at most the given size."""
    x: FieldElement = field.zero
    for w in field.integral_basis():
        x = x + w * rng.randint(-size, size)
    return x
