"""Bases of quaternion algebras over ℤ; multiplication, conjugation and traces as integer matrices.

An element ``w + x·I + y·J + z·IJ`` is a row of 4n rational numbers. Each of w, x, y and z has n coordinates
in the integral basis ω of the base. Over ℚ the row has the coordinates over (1, i, j, k); the constants (a,
t, b) may be fractions. Over GF(q)(t) polynomials replace integers: n is 1, and a row has four rational
functions. Matrices act on rows from the right.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from typing import TYPE_CHECKING, cast

from flint import fmpq, fmpq_mat, fmpz, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.core.product import Coordinates, conjugate, multiply, norm, trace
from hfield.core.properties import cached_property
from hfield.errors import IndefiniteError, LatticeError, RingError, shorten
from hfield.fields.base.ring import Ring
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.rationals.ring import QQ
from hfield.orders.base import RATIONAL_INTEGERS, Base, NumberFieldIntegers
from hfield.orders.base_values import BaseIdeal, BaseNumber, Prime, Rational
from hfield.orders.kernels import Kernels
from hfield.orders.polynomial_base import PolynomialBase

if TYPE_CHECKING:
    from flint import fq_default_poly

    from hfield.algebra.quaternion import Parent
    from hfield.fields.base.flint_types import Polynomial
    from hfield.fields.function_fields.ideals import FunctionFieldIdeal
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import FractionalIdeal
    from hfield.fields.number_fields.prime_ideals import PrimeIdeal
    from hfield.orders.base import TypedBase

UNITS: list[Coordinates[int]] = [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)]


class AlgebraBasis:
    """A basis of an algebra over ℚ, ``size`` = 4n elements ω·1, ω·I, ω·J, ω·IJ, and its multiplication.

    ``right[m]`` is the matrix of ``q ↦ q·(element m)``, ``left[m]`` that of ``q ↦ (element m)·q``, and
    ``traces[k]`` the matrix of the k-th coordinate of ``tr(x·conj(y))`` in ω. All are multiplied by ``scale``
    so that they are integral; ``conjugation`` is multiplied by ``conjugate_scale``.
    """

    def __init__(self, algebra: Parent, base: Base) -> None:
        self.algebra, self.base = algebra, base
        self.domain = domain = base.domain
        self.degree = n = base.degree
        self.size = 4 * n
        self.kernels = Kernels(base)
        self._quaternions = base.quaternion_basis(algebra)
        self.constants = c = self._quaternions.constants
        omega = base.integral_basis
        products = [[multiply(c, u, v) for v in UNITS] for u in UNITS]
        right = [self._matrix(column) for column in zip(*products, strict=True)]
        left = [self._matrix(row) for row in products]
        bars = self._matrix([conjugate(c, u) for u in UNITS])
        pairings = [[trace(c, multiply(c, u, conjugate(c, v))) for v in UNITS] for u in UNITS]
        traces = [[[domain.fraction(0)] * self.size for _ in range(self.size)] for _ in omega]
        for u, v in ((u, v) for u in range(4) for v in range(4) if pairings[u][v] != 0):
            numbers = [x * y * pairings[u][v] for x in omega for y in omega]
            for m, row in enumerate(base.coordinate_rows(numbers).tolist()):
                for table, x in zip(traces, row, strict=True):
                    table[u * n + m // n][v * n + m % n] = x
        forms = list(map(domain.fraction_matrix, traces))
        self.scale = domain.lcm(
            *(domain.integer(m.numer_denom()[1]) for m in (*right, *left, *forms))
        )
        self.scalars = [_integral(self._matrix([_scaled(u, w) for u in UNITS]), 1) for w in omega]
        self.right = [_integral(m, self.scale) * s for m in right for s in self.scalars]
        self.left = [_integral(m, self.scale) * s for m in left for s in self.scalars]
        self.traces = [_integral(m, self.scale) for m in forms]
        self.norm_forms = domain.quadratic(
            self.traces, [norm(c, _scaled(u, base.field.one)) for u in UNITS]
        )
        self.conjugation, below = bars.numer_denom()
        self.conjugate_scale = domain.integer(below)

    def __reduce__(self) -> tuple[object, ...]:
        return basis_of, (self.algebra,)

    def _matrix(self, images: Iterable[Sequence[BaseNumber | int]]) -> fmpq_mat:
        """Return the matrix of a linear map over the base, given the images of 1, I, J, IJ."""
        numbers = [w * x for q in images for w in self.base.integral_basis for x in q]
        entries = self.base.coordinate_rows(numbers).entries()
        return self.domain.fraction_matrix(self.size, self.size, entries)

    @cached_property
    def _coordinates(self) -> list[fmpz_mat]:
        """The coordinates of a product as bilinear forms."""
        size, matrix = range(self.size), self.domain.matrix
        return [matrix([[self.right[y][x, m] for y in size] for x in size]) for m in size]

    @cached_property
    def _norms(self) -> dict[str, list[fmpz_mat]]:
        """The coordinates of ``x·conj(y)``, or of ``conj(x)·y`` for the right side, as bilinear forms."""
        bars = self.conjugation
        return {
            "left": [form * bars.transpose() for form in self._coordinates],
            "right": [bars * form for form in self._coordinates],
        }

    @cached_property
    def pairs(self) -> list[tuple[int, int]]:
        """The pairs of indices of basis elements."""
        return list(combinations(range(self.size), 2))

    # --- elements ----------------------------------------------------------------------------------

    def parts(self, row: Sequence[Rational]) -> Coordinates[BaseNumber]:
        """Return w, x, y, z as numbers of the field."""
        n, number = self.degree, self.base.element_of
        w, x, y, z = (number(row[k : k + n]) for k in range(0, self.size, n))
        return w, x, y, z

    def element(self, row: Sequence[int | fmpz], den: int = 1) -> Quaternion:
        """Return a row over a denominator as an element of the algebra."""
        return self.quaternion([self.domain.fraction(c, den) for c in row])

    def quaternion(self, row: Sequence[fmpq]) -> Quaternion:
        """Return a row of rational numbers as an element of the algebra."""
        found = self._quaternions.back(self.parts(row))
        q: Quaternion = self.algebra(*map(self.base.outside, found))
        return q

    def row(self, x: object) -> fmpq_mat:
        """Return a value that the algebra can read as an element, as a matrix with one row."""
        return self.rows([x])

    def rows(self, elements: Sequence[object]) -> fmpq_mat:
        """Return values that the algebra can read as elements, one per row."""
        inside, into, numbers = self.base.inside, self._quaternions.into, list[BaseNumber]()
        for x in elements:
            q = x if isinstance(x, Quaternion) and x.algebra is self.algebra else self.algebra(x)
            if q.is_batch:
                raise LatticeError(
                    "a lattice is spanned by single elements, and this is an array of them"
                )
            numbers += into([inside(c) for c in q.coordinates])
        entries = self.base.coordinate_rows(numbers).entries()
        return self.domain.fraction_matrix(len(elements), self.size, entries)

    @cached_property
    def one(self) -> fmpq_mat:
        """The element 1, as a matrix with one row."""
        return self.row(1)

    def integral_row(self, x: object) -> tuple[int, list[fmpz]]:
        """Return the row of :meth:`row` as integers over a denominator."""
        row, den = self.row(x).numer_denom()
        return self.domain.integer(den), row.entries()

    def is_integral(self, row: Sequence[fmpq]) -> bool:
        """Return whether an element has an integral trace and norm."""
        numbers = [self.trace(row), self.norm(row)]
        return bool(self.base.coordinate_rows(numbers).numer_denom()[1] == 1)

    def norm(self, row: Sequence[fmpq]) -> BaseNumber:
        """Return the reduced norm of an element, a number of the field."""
        return norm(self.constants, self.parts(row))

    def trace(self, row: Sequence[fmpq]) -> BaseNumber:
        """Return the reduced trace of an element, a number of the field."""
        return trace(self.constants, self.parts(row))

    # --- products ----------------------------------------------------------------------------------

    def products(self, rows: fmpz_mat, others: fmpz_mat) -> fmpz_mat:
        """Return the products of all rows with all others, one per row, multiplied by ``scale``."""
        columns = others.transpose()
        found = zip(*((rows * form * columns).entries() for form in self._coordinates), strict=True)
        entries = [x for row in found for x in row]
        return self.domain.matrix(rows.nrows() * others.nrows(), self.size, entries)

    def norm_products(self, rows: fmpz_mat, side: str) -> fmpz_mat:
        """Return the products ``x·conj(y)`` of all pairs of a basis, or ``conj(x)·y`` for the right side.

        They are multiplied by ``scale·conjugate_scale``.
        """
        columns = rows.transpose()
        found = [rows * form * columns for form in self._norms[side]]
        entries = [m[pair] for pair in self.pairs for m in found]
        return self.domain.matrix(len(self.pairs), self.size, entries)

    def left_matrix(self, row: Sequence[int | fmpz]) -> fmpz_mat:
        """Return ``scale`` times the matrix of ``q ↦ x·q``, for an integer row x."""
        return combined(self.left, row)

    def right_matrix(self, row: Sequence[int | fmpz]) -> fmpz_mat:
        """Return ``scale`` times the matrix of ``q ↦ q·x``, for an integer row x."""
        return combined(self.right, row)

    def times(self, x: fmpq_mat | Sequence[fmpq], side: str = "right") -> fmpq_mat:
        """Return the matrix of ``q ↦ q·x`` for an element with one row, or of ``q ↦ x·q`` for the
        left side.
        """
        whole = self.domain.fraction_matrix(1, self.size, list(x)) if isinstance(x, Sequence) else x
        row, den = whole.numer_denom()
        matrix = (self.right_matrix if side == "right" else self.left_matrix)(row.entries())
        return matrix * self.domain.fraction(1, den * self.scale)

    def scalar(self, x: BaseNumber) -> fmpq_mat:
        """Return the matrix of multiplication by a number of the field."""
        row, den = self.base.coordinate_rows([x]).numer_denom()
        return self.scalar_matrix(row.entries()) * self.domain.fraction(1, den)

    def scalar_matrix(self, row: Sequence[int | fmpz]) -> fmpz_mat:
        """Return the matrix of multiplication by a number with integer coordinates in the integral basis."""
        return combined(self.scalars, row)

    def times_scalar(self, rows: fmpz_mat, number: Sequence[int | fmpz]) -> fmpz_mat:
        """Return rows times a number, given by its coordinates in the integral basis."""
        if any(number[1:]):
            return rows * self.scalar_matrix(number)
        return rows * number[0]

    @cached_property
    def identity(self) -> fmpz_mat:
        """The lattice spanned by 1, I, J, IJ."""
        size = range(self.size)
        return self.domain.matrix([[int(m == k) for m in size] for k in size])

    @cached_property
    def integers(self) -> fmpz_mat:
        """The integral basis of the base, one element per row."""
        n = self.degree
        return self.domain.matrix([[int(m == k) for m in range(self.size)] for k in range(n)])

    @cached_property
    def base_multiplications(self) -> list[fmpz_mat]:
        """The matrices of multiplication by the integral basis, on coordinates of numbers."""
        omega = self.base.integral_basis
        tables = (self.base.coordinate_rows([v * w for v in omega]) for w in omega)
        return [_integral(table, 1) for table in tables]

    def number_matrix(self, row: Sequence[int | fmpz]) -> fmpz_mat:
        """Return the matrix of multiplication by a number with integer coordinates, on coordinates of
        numbers.
        """
        return combined(self.base_multiplications, row)

    def inverse_number(self, row: Sequence[int | fmpz]) -> tuple[list[fmpz], int]:
        """Return 1/x for a number x with integer coordinates, as integers over a denominator."""
        if len(row) == 1:
            return [self.domain.integer(1)], self.domain.integer(row[0])
        found, den = (self._one * self.number_matrix(row).inv()).numer_denom()
        return found.entries(), self.domain.integer(den)

    @cached_property
    def _one(self) -> fmpq_mat:
        return self.base.coordinate_rows([self.base.field.one])

    @cached_property
    def base_traces(self) -> list[int]:
        """The traces of the integral basis."""
        return [self.domain.numerator(self.base.trace(w)) for w in self.base.integral_basis]

    # --- norms -------------------------------------------------------------------------------------

    def grams(self, rows: fmpz_mat) -> list[fmpz_mat]:
        """Return ``scale`` times the Gram matrices of rows, one for each coordinate of ``tr(x·conj(y))``."""
        columns = rows.transpose()
        return [rows * form * columns for form in self.traces]

    def forms(self, rows: fmpz_mat) -> list[fmpz_mat]:
        """Return the matrices F such that ``x·F·x`` is ``form_factor·scale`` times a coordinate of N(x).

        Over ℤ they are those of :meth:`grams`; in characteristic 2 those do not determine norms.
        """
        columns = rows.transpose()
        return [rows * form * columns for form in self.norm_forms]

    def form(self, c: BaseNumber) -> fmpq_mat:
        """Return the matrix of the form ``Tr(c·tr(x·conj(y)))``, which is 2·Tr(c·N(x)) for x = y."""
        base = self.base
        terms = [
            form * base.trace(c * w)
            for w, form in zip(base.integral_basis, self.traces, strict=True)
        ]
        return sum(terms[1:], terms[0]) * self.domain.fraction(1, self.scale)

    def norm_trace(self, row: Sequence[int | fmpz]) -> fmpz:
        """Return ``scale``·Tr(N(x)) for an integer row x; over ℤ, Tr(N(x)) is the norm."""
        return sum(c * row[m] * row[n] for m, n, c in self._squares)

    @cached_property
    def _squares(self) -> list[tuple[int, int, fmpz]]:
        form = self.trace_form
        pairs = [*((k, k) for k in range(self.size)), *self.pairs]
        entries = ((m, n, form[m, n] // (2 if m == n else 1)) for m, n in pairs)
        return [(m, n, c) for m, n, c in entries if c]

    @cached_property
    def trace_form(self) -> fmpz_mat:
        """``scale`` times the matrix of ``Tr(tr(x·conj(y)))``."""
        found = self.form(self.base.field.one) * self.scale
        return found.numer_denom()[0]

    @cached_property
    def definite(self) -> bool:
        """Whether the algebra is totally definite, that is, ramifies at all infinite places."""
        return self.base.is_definite(self.constants)

    @cached_property
    def has_majorant(self) -> bool:
        """Whether bases can be reduced: in definite algebras, and in all algebras over ℚ."""
        return self.definite or (self.degree == 1 and bool(self.base.real_places))

    @cached_property
    def majorant(self) -> fmpz_mat:
        """A positive definite form on rows that is, up to a scale, an upper bound of Tr(N(x)).

        Raises :class:`IndefiniteError` for an indefinite algebra over a field other than ℚ.
        """
        if self.definite:
            return self.trace_form
        if not self.has_majorant:
            raise IndefiniteError(
                f"{self.algebra} is not totally definite: over a field other than QQ bases are reduced in "
                "totally definite algebras"
            )
        a, t, b = (self.base.trace(x) for x in self.constants)  # of degree 1
        h, s = t / 2, abs(a + t * t / 4)
        # over 1, i − t/2, j and their product the norm is diagonal
        rows = fmpq_mat([[1, h, 0, 0], [0, 1, 0, 0], [0, 0, 1, h], [0, 0, 0, 1]])
        norms = fmpq_mat([[1, 0, 0, 0], [0, s, 0, 0], [0, 0, abs(b), 0], [0, 0, 0, s * abs(b)]])
        form, _ = (rows.transpose() * norms * rows).numer_denom()
        return form

    # --- where the algebra ramifies ----------------------------------------------------------------

    @cached_property
    def ramified(self) -> tuple[Prime, ...]:
        """The primes at which the algebra ramifies. Raises :class:`UnfactoredError`."""
        return self.base.ramified_primes(self.constants)

    @cached_property
    def discriminant(self) -> BaseIdeal:
        """The product of the prime ideals at which the algebra ramifies."""
        return math.prod(map(self.base.prime_ideal, self.ramified), start=self.base.one)

    @cached_property
    def unit_discriminant(self) -> BaseIdeal:
        """The reduced discriminant of the lattice of 1, I, J, IJ: the ideal of (t² + 4a)·b."""
        a, t, b = self.constants
        return self.base.principal((t * t + a * 4) * b)

    @cached_property
    def split_places(self) -> tuple[int, ...]:
        """The numbers of the real places at which the algebra splits."""
        if not self.base.real_places:
            return ()
        a, t, b = self.constants
        square, sign = a + t * t / 4, self.base.sign
        return tuple(v for v in self.base.real_places if max(sign(square, v), sign(b, v)) > 0)

    @property
    def ramified_real_places(self) -> tuple[int, ...]:
        """The indices of the real places at which the algebra ramifies."""
        return tuple(v for v in self.base.real_places if v not in self.split_places)

    @property
    def is_fuchsian(self) -> bool:
        """Whether the field is totally real and the algebra splits at exactly one real place."""
        return self.base.is_totally_real and len(self.split_places) == 1


def _scaled(q: Sequence[int], c: BaseNumber) -> Coordinates[BaseNumber]:
    w, x, y, z = q
    return w * c, x * c, y * c, z * c


def _integral(matrix: fmpq_mat, scale: int) -> fmpz_mat:
    return (matrix * scale).numer_denom()[0]


def combined(matrices: list[fmpz_mat], row: Sequence[int | fmpz]) -> fmpz_mat:
    """Return the linear combination of matrices with the given coefficients."""
    found = matrices[0] * row[0]
    for n in range(1, len(matrices)):
        if row[n]:
            found += matrices[n] * row[n]
    return found


@lru_cache(maxsize=256)
def _basis_of(algebra: Parent) -> AlgebraBasis:
    return AlgebraBasis(algebra, base_of(algebra.ring))


def basis_of(algebra: Parent) -> AlgebraBasis:
    """Return the basis of an algebra in which lattices have coordinates.

    Raises :class:`RingError` for an algebra over another ring, or a degenerate one.
    """
    found: AlgebraBasis | None = vars(algebra).get("_basis")  # cached, since every lattice needs it
    if found is None:
        found = vars(algebra)["_basis"] = _basis_of(algebra)
    return found


@lru_cache(maxsize=64)
def base_of(ring: Ring) -> Base:
    """Return the integers of a field. Raises :class:`RingError` for a field without orders."""
    # the kind of base, and with it the types of its numbers, ideals and primes, is hidden here
    return cast("Base", _integers_of(ring))


def _integers_of(
    ring: Ring,
) -> (
    TypedBase[fmpq, Fraction | int, int, int]
    | TypedBase[FieldElement, FractionalIdeal, PrimeIdeal, Polynomial]
    | TypedBase[RationalFunction, FunctionFieldIdeal, FunctionFieldIdeal, fq_default_poly]
):
    if ring == QQ:
        return RATIONAL_INTEGERS
    if isinstance(ring, NumberField):
        return NumberFieldIntegers(ring)
    if isinstance(ring, FunctionField) and ring.base.order is not None:
        return PolynomialBase(ring)
    raise RingError(
        f"lattices, orders and ideals are not defined over {shorten(ring.name)}: expected an algebra over "
        "QQ, another number field or GF(q)(t)"
    )
