"""Right ideals of prime norm in right ideals, in coordinates of a basis, by linear algebra modulo p.

Over polynomials, p is P itself.

Let P be a prime of the base above p, K a right ideal of norm P in an order O, and I a right ideal with
``I = y·O`` at all primes above p. Then ``J = y·K + P·I`` is a right ideal of relative norm P in I, and every
such ideal is of this form. K contains p·O, so K is the kernel of linear forms on O/p·O, and J consists of
the z in I for which these forms are 0 at y⁻¹·z. The forms of all K are computed once; for each ideal I they
are composed with multiplication by y⁻¹.

Where O is M₂ at P, with an idempotent e modulo P, the right ideals of norm P correspond to the lines of the
plane (O/P·O)·e over the residue field. Let g be an element of (1 − e)·O·e that is not 0 modulo P. Then z lies
in the ideal of a line if and only if z·e and z·g lie on the line.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import chain, combinations
from typing import TYPE_CHECKING

from flint import fmpq_mat, fmpz_mat, nmod, nmod_mat

from hfield.core.factorisation import remove
from hfield.errors import LatticeError
from hfield.orders.base_values import BaseNumber, Prime
from hfield.orders.domains import EuclideanDomain
from hfield.orders.ideals_of_norm import subideals, two_sided_prime
from hfield.orders.lattice_values import LatticeValue, discriminant
from hfield.orders.orders_at_primes import OrderAtPrime

if TYPE_CHECKING:
    from hfield.orders.base import Base
    from hfield.orders.base_values import Integer, IntegerMatrix, ModularMatrix, Rational
    from hfield.orders.class_keys import Norm, ShortElement, SublatticeKeys

Matrix = list[list[int]]
TRIALS = 1_000
"""The largest number of random elements that are tried at a prime."""


class Neighbours:
    """The right ideals of relative norm P in right ideals of one order.

    With ``only``, they come from these ideals of norm P instead of from all of them. Raises
    :class:`TooLargeError` if there are too many at a prime of the discriminant.
    """

    def __init__(
        self, order: LatticeValue, prime: Prime, only: Sequence[LatticeValue] | None = None
    ) -> None:
        base = order.ambient.base
        self.order, self.prime = order, prime
        place = base.place(prime)
        self.p, self.modular = place.below, order.ambient.domain.modular
        self.degree = len(base.digits(prime, place.one))
        self.ideals: list[LatticeValue] = []
        """Those in the order, where P divides the discriminant."""
        if only is not None or base.valuation(discriminant(order), prime):
            self.ideals = subideals(order, order, prime) if only is None else list(only)
            self._forms = self.modular(order.ambient.identity, self.p)
            self._lines = list(map(self._zeros, self.ideals))
        else:
            self._forms = self.modular(_plane(self), self.p)
            self._lines = list(self._lines_of_the_plane())

    def __len__(self) -> int:
        return len(self._lines)

    def _zeros(self, ideal: LatticeValue) -> nmod_mat:
        """Return linear forms on the order, as rows, whose common zeros are a right ideal of norm P."""
        whole = (ideal.rows * self.order.inverse_rows).numer_denom()[0]
        domain = self.order.ambient.domain
        return self.modular(domain.kernel(whole, self.p), self.p)

    def _lines_of_the_plane(self) -> Iterator[nmod_mat]:
        """Yield, for each line, the combinations of the forms of the plane that vanish on it.

        The forms are the coordinates of z·e in y₁, β·y₁, … and in y₂, β·y₂, …, and those of z·g. The lines
        are those spanned by y₁ + c·y₂ and by y₂.
        """
        f, base = self.degree, self.order.ambient.base
        one = [[int(k == m) for m in range(f)] for k in range(f)]
        none = [[0] * f for _ in one]
        for c in base.residues(self.prime):
            table = zip(*_multiplication(base, self.prime, c, f), strict=True)
            first = [[-x for x in row] for row in table]
            yield self._twice([x + y for x, y in zip(first, one, strict=True)])
        yield self._twice([x + y for x, y in zip(one, none, strict=True)])

    def _twice(self, rows: Matrix) -> nmod_mat:
        zero = [0] * (2 * self.degree)
        doubled = [*(row + zero for row in rows), *(zero + row for row in rows)]
        return self.modular(doubled, self.p)

    def inside(self, around: SublatticeKeys, norm: Norm) -> Iterator[fmpz_mat]:
        """Yield bases of the right ideals of relative norm P in a right ideal, in coordinates of its basis.

        The right ideal has a given norm and contains the order, as class representatives do.
        """
        order, ambient, p = self.order, self.order.ambient, self.p
        rows, den = around.rows, around.den
        y = generator_above(around, p, norm)
        if y is not None:
            row, times, below = y.inverse_over
            rows, den = rows * ambient.left_matrix(row) * times, den * below * ambient.scale
        domain = ambient.domain
        moved, below = (rows * order.inverse_rows * domain.fraction(1, den)).numer_denom()
        inverse = domain.inverse_modulo(below, p)
        forms = self._forms * self.modular(moved.transpose(), p) * inverse
        for line in self._lines:
            yield _solutions(domain, line * forms, p)


@lru_cache(maxsize=64)
def neighbours_at(order: LatticeValue, prime: Prime) -> Neighbours:
    """Return the right ideals of norm P in an order, for computing those in its right ideals."""
    return Neighbours(order, prime)


@lru_cache(maxsize=64)
def two_sided_at(order: LatticeValue, prime: Prime) -> Neighbours:
    """Return the two-sided ideal of norm P in an order, for computing those in its right ideals."""
    return Neighbours(order, prime, [two_sided_prime(order, prime)])


def generator_above(around: SublatticeKeys, p: int, norm: Norm) -> ShortElement | None:
    """Return an element y of a right ideal I with I = y·O at all primes above p; None for 1.

    At these primes N(y) has the same valuation as N(I). If P does not divide all values of a quadratic form,
    then it does not divide the value at some basis element or at the sum of two basis elements.
    """
    ambient = around.keys.ambient
    ideal = ambient.base.narrow_classes.ideals[norm.number]
    domain = ambient.domain
    wanted = _valuation(domain, ambient.base.norm(norm.element), p)
    if norm.number:
        wanted += remove(ambient.base.absolute_norm(ideal), p)[0]
    if not wanted:
        return None
    size, n = ambient.size, ambient.degree
    wanted += n * domain.remove(around.norm_scale, p)[0]
    for some in chain(combinations(range(size), 1), combinations(range(size), 2)):
        found = ambient.number_matrix(around.norm_of_sum(some)).det()
        if found and domain.remove(found, p)[0] == wanted:
            return around.element([int(k in some) for k in range(size)])
    rng = random.Random(1)
    for _ in range(TRIALS):  # if there are several primes above p
        x = around.element([domain.random(rng, p) for _ in range(size)])
        found = ambient.number_matrix(x.scaled_norm).det()
        if found and domain.remove(found, p)[0] == wanted:
            return x
    raise LatticeError(f"no element generates the ideal at the primes above {p}")


def _valuation(domain: EuclideanDomain, x: Rational, p: Integer) -> int:
    return domain.remove(domain.numerator(x), p)[0] - domain.remove(domain.denominator(x), p)[0]


def _solutions(domain: EuclideanDomain, forms: ModularMatrix, p: Integer) -> IntegerMatrix:
    """Return a basis of the integer vectors at which linear forms vanish modulo p, with small entries."""
    reduced, rank = forms.rref()
    size = forms.ncols()
    entries: list[Integer] = [0] * (size * size)
    entries[:: size + 1] = [1] * size
    for row in reduced.tolist()[:rank]:
        pivot = next(m for m, c in enumerate(row) if c)
        entries[pivot * (size + 1)] = p
        for m in range(pivot + 1, size):
            if row[m]:  # no pivot of another row, because this entry is 0
                entries[m * size + pivot] = -domain.small_residue(row[m], p)
    return domain.matrix(size, size, entries)


# --- the plane of an order that is M₂ at P ---------------------------------------------------------


def _plane(neighbours: Neighbours) -> Matrix:
    """Return 4f linear forms on the order modulo p: the coordinates of z·e and z·g in bases of lines."""
    order, prime, p, f = neighbours.order, neighbours.prime, neighbours.p, neighbours.degree
    ambient, base = order.ambient, order.ambient.base
    modular = neighbours.modular
    at = OrderAtPrime(order, prime)
    e = at.idempotent(1)
    embed = _modulo(order, ambient.scalar(_embedding(base, prime, p)), p)
    by_e = _modulo(order, ambient.times(e), p)
    image = _lists(by_e * embed)
    joined = [x + y for x, y in zip(image, _lists(by_e), strict=True)]
    reduced = _lists(modular(joined, p).rref()[0])[: 2 * f]
    size = ambient.size
    pivots = [next(k for k, c in enumerate(row) if c) for row in reduced]
    start = next(k for row in image for k, c in enumerate(row) if c)
    # the row of the first pivot first: it determines the order of the classes
    if not reduced[0][start]:
        reduced.reverse()
    residues = [
        base.lift(prime, base.residue(prime, [int(k == m) for m in range(f)])) for k in range(f)
    ]
    multiply = [_modulo(order, ambient.scalar(c), p) for c in residues]

    def line(row: list[int]) -> Matrix:
        """Return the coordinates, at the pivots, of the multiples of an element by residues."""
        y = modular([row[size:]], p)
        return [[_whole((y * m * embed)[0, k]) for k in pivots] for m in multiply]

    first = line(reduced[0])
    lines = (first + line(row) for row in reduced[1:])
    basis = next(m for rows in lines if (m := modular(rows, p)).rank() == 2 * f)
    back = basis.inv()
    for g in at.corners(e)[1].tolist():
        by_g = _modulo(order, ambient.times(g), p) * embed
        if any(c for row in _lists(by_g) for c in row):
            break
    else:
        raise AssertionError("(1 − e)·O·e is not 0 modulo P")
    forms: Matrix = []
    for matrix in (by_e * embed, by_g):
        coordinates = modular([[row[k] for k in pivots] for row in _lists(matrix)], p) * back
        forms += map(list, zip(*_lists(coordinates), strict=True))
    return forms


def _whole(x: nmod | Integer) -> Integer:
    """Return an element of a matrix modulo a prime as an integer of the domain."""
    return int(x) if isinstance(x, nmod) else x


def _lists(matrix: nmod_mat) -> Matrix:
    """Return the rows of a matrix modulo p."""
    return [list(map(_whole, row)) for row in matrix.tolist()]


def _modulo(order: LatticeValue, matrix: fmpq_mat, p: int) -> nmod_mat:
    """Return the matrix modulo p of a linear map of the order to itself, in coordinates of the order."""
    moved = (order.rows * matrix * order.inverse_rows).numer_denom()[0]
    return order.ambient.domain.modular(moved, p)


def _embedding(base: Base, prime: Prime, p: int) -> BaseNumber:
    """Return an integer t of the field such that t·x is divisible by p if and only if x is in P."""
    domain = base.domain
    den, rows = base.ideal_rows(base.inverse(base.prime_ideal(prime)))
    for row in rows:
        coordinates = [domain.fraction(c * p, den) for c in row]
        if any(domain.numerator(c) % p for c in coordinates):
            return base.element_of(coordinates)
    raise AssertionError("p·P⁻¹ is not contained in p·ℤ_K")


def _multiplication(base: Base, prime: Prime, c: BaseNumber, f: int) -> Matrix:
    """Return the matrix of multiplication by a residue, on rows of digits."""
    place = base.place(prime)
    units = (base.residue(prime, [int(k == m) for m in range(f)]) for k in range(f))
    residue = place.reduce(c)
    return [base.digits(prime, place.multiply(residue, x)) for x in units]
