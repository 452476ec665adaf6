"""Totally real number fields of eigenvalues, given by small polynomials.

The field ℚ[x]/(g) of an algebraic integer often has a much smaller defining polynomial. The field is totally
real, so the trace form Tr(x·y) is positive definite, and it is integral on algebraic integers. LLL reduces a
lattice of algebraic integers with this form, in exact arithmetic. The minimal polynomial of a short element
that generates the field is the new polynomial (H. Cohen, *A Course in Computational Algebraic Number Theory*,
section 4.4.2).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from flint import fmpq, fmpq_mat, fmpq_poly, fmpz_mat, fmpz_poly

from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ring import NumberField

MAX_REDUCED_DEGREE = 60
"""Fields of a larger degree keep the polynomial that defines them."""
MAX_DIGITS_OF_DISCRIMINANT = 40
"""The ring of integers is used where the discriminant of the polynomial has no more digits than this."""
MAX_PAIRS_DEGREE = 12
"""Up to this degree sums and differences of two short elements are tried as generators too."""


class EigenvalueField:
    """The field of a root α of g, and the elements N(α)/g′(α) for integral polynomials N in it.

    These are all integers of the field, and others. ``some`` are coefficients of N for integers besides the
    powers of α: the more of them, the smaller the polynomial.
    """

    def __init__(self, g: fmpz_poly, some: Sequence[Sequence[int]] = ()) -> None:
        self.polynomial, self.degree = fmpq_poly(g), int(g.degree())
        derivative = self.polynomial.derivative()
        inverse = derivative.xgcd(self.polynomial)[1]
        self._over_derivative = self._matrix(inverse)
        generator = fmpq_poly([0, 1])
        if 1 < self.degree <= MAX_REDUCED_DEGREE:
            generator = self._short_generator(some)
        self.field, change = self._field_of(generator)
        self._coordinates = self._over_derivative * change

    def element(self, numerator: Sequence[int]) -> FieldElement:
        """Return N(α)/g′(α) for the coefficients of N, low degree first."""
        row = fmpq_mat(1, self.degree, list(numerator)) * self._coordinates
        return FieldElement(self.field, fmpq_poly(row.entries()))

    def _row(self, x: fmpq_poly) -> list[fmpq]:
        found: list[fmpq] = (x % self.polynomial).coeffs()
        return found + [fmpq(0)] * (self.degree - len(found))

    def _matrix(self, x: fmpq_poly) -> fmpq_mat:
        """Return the multiplication by x(α) on coordinates in powers of α, in rows."""
        rows = []
        for _ in range(self.degree):
            rows.append(self._row(x))
            x = x * fmpq_poly([0, 1]) % self.polynomial
        return fmpq_mat(rows)

    def _field_of(self, generator: fmpq_poly) -> tuple[NumberField, fmpq_mat]:
        """Return the field that x(α) generates, and the change to coordinates in powers of it."""
        powers, power = [], fmpq_poly([1])
        for _ in range(self.degree):
            powers.append(self._row(power))
            power = power * generator % self.polynomial
        back = fmpq_mat(powers).inv()
        polynomial = fmpq_poly(self._matrix(generator).charpoly())
        return NumberField(polynomial), back

    def _short_generator(self, some: Sequence[Sequence[int]]) -> fmpq_poly:
        """Return x with x(α) a short integer that generates the field, of trace at least 0."""
        d = self.degree
        derivative = self.polynomial.derivative()
        powers = [self._row(fmpq_poly([0] * k + [1]) * derivative) for k in range(d)]
        whole = fmpz_mat([*([int(c) for c in row] for row in powers), *map(list, some)]).hnf()
        rows = fmpq_mat(d, d, whole.entries()[: d * d]) * self._over_derivative
        generator, polynomial = self._shortest(rows)
        if abs(polynomial.discriminant()) < 10**MAX_DIGITS_OF_DISCRIMINANT:
            field, _ = self._field_of(generator)
            integers = []
            for w in field.integral_basis():
                integers.append(self._row(w.poly(generator) % self.polynomial))
            generator, _ = self._shortest(fmpq_mat(integers))
        return generator

    def _shortest(self, rows: fmpq_mat) -> tuple[fmpq_poly, fmpz_poly]:
        """Return a short generator of the field in a lattice of integers, and its polynomial."""
        d = self.degree
        traces = self._traces(2 * d - 1)
        form = fmpq_mat([[traces[i + j] for j in range(d)] for i in range(d)])
        gram = (rows * form * rows.transpose()).numer_denom()[0]
        _, change = gram.lll(transform=True, rep="gram")
        reduced = (change * rows).tolist()
        candidates = [fmpq_poly(row) for row in reduced]
        if d <= MAX_PAIRS_DEGREE:
            candidates += [y for u, v in combinations(candidates, 2) for y in (u + v, u - v)]
        found: list[tuple[list[int], fmpq_poly, fmpz_poly]] = []
        for x in sorted(candidates, key=self._length):
            if found and self._length(x) > self._length(found[0][1]):
                break
            polynomial = fmpz_poly(self._matrix(x).charpoly().numer())
            if not polynomial.gcd(polynomial.derivative()).degree():
                found.append((_key(polynomial), x, polynomial))
        if not found:
            return fmpq_poly([0, 1]), fmpz_poly(self.polynomial.numer())
        _, x, polynomial = min(found, key=lambda triple: triple[0])
        if any(polynomial[k] > 0 for k in _first_odd(polynomial)):
            x, polynomial = -x, polynomial(fmpz_poly([0, -1])) * (-1) ** d
        return x, polynomial

    def _length(self, x: fmpq_poly) -> fmpq:
        """Return Tr(x²)."""
        return _trace(self._matrix(x * x % self.polynomial))

    def _traces(self, number: int) -> list[fmpq]:
        """Return the traces of 1, α, α², …"""
        matrix = self._matrix(fmpq_poly([0, 1]))
        found, power = [], self._matrix(fmpq_poly([1]))
        for _ in range(number):
            found.append(_trace(power))
            power = power * matrix
        return found


def _trace(matrix: fmpq_mat) -> fmpq:
    return sum((matrix[k, k] for k in range(matrix.nrows())), fmpq(0))


def _key(polynomial: fmpz_poly) -> list[int]:
    """Return a key by which polynomials are sorted: absolute values of coefficients, high degree first."""
    return [abs(int(c)) for c in reversed(polynomial.coeffs())]


def _first_odd(polynomial: fmpz_poly) -> Iterator[int]:
    """Yield the index of the first nonzero coefficient that x ↦ −x negates, if there is one."""
    places = range(polynomial.degree() - 1, -1, -2)
    yield from [k for k in places if polynomial[k]][:1]
