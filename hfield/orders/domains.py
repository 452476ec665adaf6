"""The principal ideal domains over which lattices are matrices: ℤ, and 𝔽_q[t].

A lattice over ℤ or ℤ_K is a matrix over ℤ; a lattice over 𝔽_q[t] is a matrix over 𝔽_q[t]. This module
contains everything that differs between the two: matrices, fractions, linear algebra modulo a prime, and
short vectors.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Protocol, TypeAlias, cast, overload

from flint import fmpq, fmpq_mat, fmpz, fmpz_mat, fmpz_poly, nmod_mat

from hfield.core.factorisation import remove
from hfield.fields.function_fields.quotients import RationalFunction
from hfield.orders import enumeration
from hfield.orders.linear_algebra_mod_p import kernel
from hfield.orders.polynomial_matrices import FractionMatrix, PolynomialMatrix, fractions
from hfield.orders.polynomial_vectors import PolynomialVectors
from hfield.orders.residue_matrices import ResidueMatrix

if TYPE_CHECKING:
    from _typeshed import SupportsRichComparison
    from flint import fq_default, fq_default_poly

    from hfield.fields.finite.ring import ExtensionField
    from hfield.fields.function_fields.ring import FunctionField
    from hfield.orders.base_values import (
        Integer,
        IntegerMatrix,
        ModularMatrix,
        Rational,
        RationalMatrix,
    )


IntegerRows: TypeAlias = "IntegerMatrix | Sequence[Sequence[Integer]]"
RationalRows: TypeAlias = "IntegerMatrix | Sequence[Sequence[Rational | Integer]]"
Form: TypeAlias = "Sequence[Sequence[Integer]]"
DegreeAndLabels: TypeAlias = tuple[int, tuple[int, ...]]
"""A polynomial as it is sorted: its degree, and the labels of its coefficients from the highest on."""


class VectorsOfForms(Protocol):
    """Functions on the vectors of bounded length for a form that is definite, or anisotropic at infinity."""

    def least_vectors(self, form: Form, /) -> tuple[int, Sequence[Sequence[Integer]]]:
        """Return the least length of a nonzero vector, and the vectors of this length up to sign."""

    def short_vectors(
        self, form: Form, bound: int, /
    ) -> Iterator[tuple[Sequence[Integer], Integer]]:
        """Yield one of ±x for every x ≠ 0 of bounded length, with its value."""

    def vectors_of_length(
        self, form: Form, value: Integer, expected: str | None = ..., /
    ) -> Iterator[Sequence[Integer]]:
        """Yield one of ±x for every x with a given value."""

    def volume(self, form: Form, value: Integer, rank: int, /) -> float:
        """Return the approximate number of vectors up to a value."""


class EuclideanDomain(Protocol):
    """A Euclidean domain, with matrices that have the same methods as those of flint."""

    symbol: str
    """How the ring is written."""
    latex: str
    """How it is written in LaTeX."""
    form_factor: int
    """By which factor values of forms are larger than norms: 2 over ℤ, where forms are matrices of traces."""

    @overload
    def matrix(self, rows: IntegerRows, /) -> IntegerMatrix:
        """Return the matrix with given rows, as ``fmpz_mat`` does."""

    @overload
    def matrix(self, m: int, n: int, entries: Sequence[Integer] = ..., /) -> IntegerMatrix:
        """Return the matrix with a given shape and entries (0 by default)."""

    @overload
    def fraction_matrix(self, rows: RationalRows, /) -> RationalMatrix:
        """Return a matrix of fractions with given rows, as ``fmpq_mat`` does."""

    @overload
    def fraction_matrix(
        self, m: int, n: int, entries: Sequence[Rational | Integer], /
    ) -> RationalMatrix:
        """Return a matrix of fractions with a given shape and entries."""

    def fraction(self, x: Rational | Integer, den: Integer = ..., /) -> Rational:
        """Return the fraction with a given numerator and denominator, as ``fmpq`` does."""

    def integer(self, x: Integer, /) -> Integer:
        """Return a number in the type used for denominators: an int over ℤ."""

    def modular(self, rows: IntegerRows, p: Integer, /) -> ModularMatrix:
        """Return a matrix modulo a prime, as ``nmod_mat`` does."""

    @property
    def vectors(self) -> VectorsOfForms:
        """Functions on vectors of bounded length in a form, as in :mod:`hfield.orders.enumeration`."""

    def as_fraction(self, x: Rational | Integer) -> Rational:
        """Return a rational number, or an element of the field, as a fraction."""

    def lcm(self, *numbers: Integer) -> Integer:
        """Return the least common multiple."""

    def content(self, numbers: Sequence[Integer]) -> Integer:
        """Return the greatest common divisor of a list."""

    def quadratic(self, traces: list[IntegerMatrix], norms: list[Rational]) -> list[IntegerMatrix]:
        """Return matrices F with ``x·F·x`` = form_factor·N(x), given matrices of tr(x·conj(y)) and norms."""

    def common_divisor(self, x: Integer, numbers: Sequence[Integer]) -> Integer:
        """Return the greatest common divisor of a number and a list."""

    def polar(self, form: IntegerMatrix) -> IntegerMatrix:
        """Return the matrix of the symmetric bilinear form of a quadratic form given by a matrix."""

    def divided(self, matrix: IntegerMatrix, n: Integer) -> IntegerMatrix:
        """Return a matrix divided by a number that divides all entries."""

    def lowest_terms(self, den: Integer, matrix: IntegerMatrix) -> tuple[Integer, IntegerMatrix]:
        """Return a triangular matrix over a denominator, reduced to the least denominator."""

    def length(self, value: Rational | Integer) -> fmpq | int:
        """Return the key by which values of a definite form are compared."""

    def reduced(self, form: IntegerMatrix) -> tuple[IntegerMatrix, IntegerMatrix]:
        """Return a definite form on a reduced basis, and the basis, one vector per row."""

    def denominator(self, x: Rational) -> Integer:
        """Return the denominator of a fraction."""

    def numerator(self, x: Rational) -> Integer:
        """Return the numerator of a fraction."""

    def kernel(self, matrix: IntegerRows, p: Integer) -> Sequence[Sequence[Integer]]:
        """Return a basis of the vectors v with row·v = 0 modulo a prime for every row."""

    def inverse_modulo(self, x: Integer, p: Integer) -> Integer:
        """Return the inverse modulo p of a number prime to p."""

    def small_residue(self, x: Integer, p: Integer) -> Integer:
        """Return the least representative of a class modulo p."""

    def remove(self, x: Integer, p: Integer) -> tuple[int, Integer]:
        """Return the exponent of a prime in a nonzero number, and the cofactor."""

    def random(self, rng: random.Random, modulus: Integer) -> Integer:
        """Return a random residue."""

    def few_residues(self, p: Integer) -> Iterable[Integer]:
        """Return up to three residues modulo p, beginning with 0 and 1."""

    def small(self, size: int) -> Iterator[Integer]:
        """Yield numbers of a given size; the sizes 0, 1, 2, … together give all numbers."""

    def sort_key(self, numbers: tuple[Integer, ...]) -> SupportsRichComparison:
        """Return the key by which tuples of numbers are sorted."""

    def pickled(self, x: Integer) -> int | tuple[int, ...]:
        """Return a number as plain data that :attr:`integer` reads."""

    def code(self, x: Integer, /) -> int:
        """Return an integer that encodes a number, for packed storage."""

    def decode(self, n: int, /) -> Integer:
        """Return the number that an integer encodes."""


class IntegerDomain:
    """The ring ℤ, with flint's matrices."""

    symbol = "ℤ"
    latex = r"\mathbb{Z}"
    matrix = fmpz_mat
    fraction_matrix = fmpq_mat
    fraction = fmpq
    integer = int
    code = int
    decode = int
    modular = nmod_mat
    form_factor = 2
    vectors = enumeration
    kernel = staticmethod(kernel)
    lcm = staticmethod(math.lcm)

    def as_fraction(self, x: fmpq | Fraction | int) -> fmpq:
        """Return a rational number as a flint rational."""
        return fmpq(x.numerator, x.denominator)

    def content(self, numbers: Sequence[int | fmpz]) -> fmpz:
        """Return the gcd of a list, as a flint integer."""
        return fmpz_poly(numbers).content()

    def common_divisor(self, x: int, numbers: Sequence[int | fmpz]) -> fmpz:
        """Return the gcd, stopping as soon as it is 1."""
        found = fmpz(x)
        for n in numbers:
            if found == 1:
                break
            if n:
                found = found.gcd(n)
        return found

    def quadratic(self, traces: list[fmpz_mat], norms: list[fmpq]) -> list[fmpz_mat]:
        """Return the matrices of traces."""
        return traces

    def polar(self, form: fmpz_mat) -> fmpz_mat:
        """Return the matrix itself."""
        return form

    def divided(self, matrix: fmpz_mat, n: int | fmpz) -> fmpz_mat:
        """Return an integer matrix divided by an integer that divides all entries."""
        if n == 1:
            return matrix
        return (matrix * fmpq(1, n)).numer_denom()[0]

    def lowest_terms(self, den: int, matrix: fmpz_mat) -> tuple[int, fmpz_mat]:
        """Return a triangular matrix over its least denominator; often the diagonal suffices to find it."""
        before, common = fmpz(0), fmpz(den)
        for k in range(matrix.nrows()):
            if common == before:
                break
            before, common = common, common.gcd(matrix[k, k])
        if common == 1:
            return int(den), matrix
        whole, below = (matrix * fmpq(1, den)).numer_denom()
        return int(below), whole

    def denominator(self, x: fmpq) -> int:
        """Return the denominator."""
        return int(x.q)

    def numerator(self, x: fmpq) -> int:
        """Return the numerator."""
        return int(x.p)

    def inverse_modulo(self, x: int | fmpz, p: int) -> int:
        """Return the inverse modulo p."""
        return pow(int(x), -1, p)

    def small_residue(self, x: int | fmpz, p: int) -> int:
        """Return a representative between −p/2 and p/2."""
        c = int(x) % p
        return c if 2 * c < p else c - p

    def remove(self, x: int | fmpz, p: int) -> tuple[int, int]:
        """Return the exponent of p in a number, and the cofactor prime to p."""
        return remove(int(x), p)

    def length(self, value: fmpq | int) -> fmpq | int:
        """Return the value."""
        return value

    def reduced(self, form: fmpz_mat) -> tuple[fmpz_mat, fmpz_mat]:
        """Return a definite form on an LLL-reduced basis, and the basis, one vector per row."""
        found: tuple[fmpz_mat, fmpz_mat] = form.lll(transform=True, rep="gram")
        return found

    def random(self, rng: random.Random, modulus: int) -> int:
        """Return a random residue."""
        return rng.randrange(modulus)

    def few_residues(self, p: int) -> Iterable[int]:
        """Return 0, 1 and, for odd p, 2."""
        return range(min(p, 3))

    def small(self, size: int) -> Iterator[int]:
        """Yield the numbers from −size to size."""
        return iter(range(-size, size + 1))

    def sort_key(self, numbers: tuple[int, ...]) -> tuple[int, ...]:
        """Return the numbers."""
        return numbers

    def pickled(self, x: int | fmpz) -> int:
        """Return an int."""
        return int(x)


INTEGERS = IntegerDomain()


class PolynomialDomain:
    """The polynomials over GF(q), as flint's ``fq_default_poly``; ``field`` contains their fractions."""

    form_factor = 1

    def __init__(self, field: FunctionField) -> None:
        constants = cast("ExtensionField", field.base)  # of degree 1 or more
        self.field, self.constants = field, constants
        self.zero, self.one = field.zero.num, field.one.num
        self.symbol = f"{constants.name}[{field.gen_name}]"
        self.latex = rf"\mathbb{{F}}_{{{constants.order}}}[{field.gen_name}]"
        self.vectors = PolynomialVectors(self)

    def integer(self, x: int | tuple[int, ...] | fq_default_poly) -> fq_default_poly:
        """Return a polynomial from an int, a tuple that :meth:`pickled` returned, or a polynomial."""
        if isinstance(x, int):
            return self.one * x
        if isinstance(x, tuple):
            return self._polynomial(x)
        return x

    def _polynomial(self, labels: Sequence[int]) -> fq_default_poly:
        t, found = self.field.gen.num, self.zero
        for label in reversed(labels):
            found = found * t + self.constant(self.constants.from_label(label))
        return found

    def constant(self, c: fq_default) -> fq_default_poly:
        """Return an element of GF(q) as a polynomial."""
        return self.field.constant(c).num

    def pickled(self, x: fq_default_poly) -> tuple[int, ...]:
        """Return the labels of the coefficients, low degree first."""
        return tuple(self.constants.label(c) for c in x.coeffs())

    @overload
    def matrix(self, rows: IntegerRows, /) -> PolynomialMatrix: ...

    @overload
    def matrix(self, m: int, n: int, entries: Sequence[Integer] = ..., /) -> PolynomialMatrix: ...

    def matrix(
        self, given: IntegerRows | int, n: int = 0, entries: Sequence[Integer] | None = None, /
    ) -> PolynomialMatrix:
        """Return a matrix given by rows, or by a shape and entries, as ``fmpz_mat`` takes them."""
        if isinstance(given, PolynomialMatrix):
            return given
        if isinstance(given, int):
            listed = [self.zero] * (given * n) if entries is None else map(self.integer, entries)
            return PolynomialMatrix(self, given, n, list(listed))
        rows = [list(row) for row in given]
        columns = len(rows[0]) if rows else 0
        return PolynomialMatrix(
            self, len(rows), columns, [self.integer(x) for row in rows for x in row]
        )

    @overload
    def fraction_matrix(self, rows: RationalRows, /) -> FractionMatrix: ...

    @overload
    def fraction_matrix(
        self, m: int, n: int, entries: Sequence[Rational | Integer], /
    ) -> FractionMatrix: ...

    def fraction_matrix(
        self, given: RationalRows | int, n: int = 0, entries: Sequence[Rational | Integer] = (), /
    ) -> FractionMatrix:
        """Return a matrix of fractions, given in the same ways."""
        if isinstance(given, PolynomialMatrix):
            return FractionMatrix(given, self.one)
        if isinstance(given, int):
            return fractions(self, [entries[k : k + n] for k in range(0, len(entries), n)])
        return fractions(self, given)

    def fraction(self, x: Rational | Integer, den: Integer | None = None) -> RationalFunction:
        """Return x/den as an element of the field."""
        num = self.as_fraction(x)
        return num if den is None else num / self.as_fraction(den)

    def as_fraction(self, x: Rational | Integer) -> RationalFunction:
        """Return a number, a polynomial or an element of the field as an element of the field."""
        if isinstance(x, int):
            return self.field(x)
        if isinstance(x, RationalFunction):
            return x
        return self.field.quotient(x, self.one)

    def modular(self, rows: IntegerRows, p: fq_default_poly) -> ResidueMatrix:
        """Return a matrix modulo a prime."""
        table = rows.tolist() if isinstance(rows, PolynomialMatrix) else rows
        return ResidueMatrix(self, [[self.integer(x) % p for x in row] for row in table], p)

    def kernel(self, matrix: IntegerRows, p: fq_default_poly) -> list[list[fq_default_poly]]:
        """Return a basis of the vectors v with row·v = 0 modulo a prime for every row."""
        return self.modular(matrix, p).kernel()

    def lcm(self, *numbers: Integer) -> fq_default_poly:
        """Return the monic least common multiple."""
        found = self.one
        for x in map(self.integer, numbers):
            found = found * (x // found.gcd(x))
        return self.monic(found)

    def monic(self, x: fq_default_poly) -> fq_default_poly:
        """Return x divided by its leading coefficient."""
        return x.monic() if x else x

    def content(self, numbers: Iterable[fq_default_poly]) -> fq_default_poly:
        """Return the monic gcd of a list."""
        found = self.zero
        for x in numbers:
            found = found.gcd(x)
            if found == self.one:
                break
        return found

    def common_divisor(
        self, x: fq_default_poly, numbers: Sequence[fq_default_poly]
    ) -> fq_default_poly:
        """Return the monic gcd."""
        return self.content([x, *numbers])

    def quadratic(
        self, traces: list[PolynomialMatrix], norms: list[RationalFunction]
    ) -> list[PolynomialMatrix]:
        """Return a matrix with the norms on the diagonal and traces above it; the constants must be
        integral.
        """
        (table,), size = traces, len(norms)
        entries = [
            self.as_fraction(norms[m]).num if m == n else table[m, n] if m < n else self.zero
            for m in range(size)
            for n in range(size)
        ]
        return [PolynomialMatrix(self, size, size, entries)]

    def polar(self, form: PolynomialMatrix) -> PolynomialMatrix:
        """Return the sum of a matrix and its transpose."""
        return form + form.transpose()

    def divided(self, matrix: PolynomialMatrix, n: fq_default_poly) -> PolynomialMatrix:
        """Return a matrix divided by a polynomial that divides all entries."""
        if n == self.one:
            return matrix
        return PolynomialMatrix(
            self, matrix.nrows(), matrix.ncols(), [x // n for x in matrix.entries()]
        )

    def lowest_terms(
        self, den: Integer, matrix: PolynomialMatrix
    ) -> tuple[fq_default_poly, PolynomialMatrix]:
        """Return a matrix over a monic denominator."""
        if den == 1:
            return self.integer(den), matrix
        whole, below = (matrix * self.fraction(1, den)).numer_denom()
        return below, whole

    def length(self, value: Rational | Integer) -> int:
        """Return the degree of a polynomial or a fraction."""
        x = self.as_fraction(value)
        return int(x.num.degree() - x.den.degree())

    def reduced(self, form: PolynomialMatrix) -> tuple[PolynomialMatrix, PolynomialMatrix]:
        """Return a form that is anisotropic at infinity on a reduced basis, and the basis."""
        return self.vectors.reduced(form)

    def denominator(self, x: RationalFunction) -> fq_default_poly:
        """Return the denominator."""
        return x.den

    def numerator(self, x: RationalFunction) -> fq_default_poly:
        """Return the numerator."""
        return x.num

    def inverse_modulo(self, x: Integer, p: fq_default_poly) -> fq_default_poly:
        """Return the inverse modulo p."""
        return self.integer(x).inverse_mod(p)

    def small_residue(self, x: fq_default_poly, p: fq_default_poly) -> fq_default_poly:
        """Return the remainder modulo p."""
        return x % p

    def remove(self, x: Integer, p: fq_default_poly) -> tuple[int, fq_default_poly]:
        """Return the exponent of p in a number, and the cofactor prime to p."""
        n, x = 0, self.integer(x)
        while True:
            quotient, rest = divmod(x, p)
            if rest:
                return n, x
            n, x = n + 1, quotient

    def random(self, rng: random.Random, modulus: fq_default_poly) -> fq_default_poly:
        """Return a random residue."""
        q = int(self.constants.order)
        return self._polynomial([rng.randrange(q) for _ in range(modulus.degree())])

    def few_residues(self, p: fq_default_poly) -> list[fq_default_poly]:
        """Return 0, 1 and one more residue, if there is one."""
        some = [self.zero, self.one]
        if p.degree() > 1:
            return [*some, self.field.gen.num]
        return [
            self.constant(self.constants.from_label(n)) for n in range(min(3, self.constants.order))
        ]

    def small(self, size: int) -> Iterator[fq_default_poly]:
        """Yield 2·size + 1 polynomials, the first ones by degree and then by labels of coefficients."""
        return map(self.decode, range(2 * size + 1))

    def of_degree_below(self, bound: int) -> Iterator[fq_default_poly]:
        """Yield the polynomials of degree below a bound."""
        return map(self.decode, range(self.constants.order**bound))

    def code(self, x: fq_default_poly) -> int:
        """Return the integer whose digits are the labels of the coefficients."""
        found = 0
        for label in reversed(self.pickled(x)):
            found = found * self.constants.order + label
        return int(found)

    def decode(self, n: int) -> fq_default_poly:
        """Return the polynomial whose coefficients have the digits of an integer as labels."""
        labels = []
        while n:
            n, c = divmod(n, self.constants.order)
            labels.append(c)
        return self._polynomial(labels)

    def sort_key(self, numbers: tuple[fq_default_poly, ...]) -> tuple[DegreeAndLabels, ...]:
        """Return degrees and coefficients."""
        return tuple((x.degree(), self.pickled(x)[::-1]) for x in numbers)


INTEGRAL = (fmpz_mat, fmpq_mat)


def domain_of(matrix: IntegerMatrix | RationalMatrix) -> EuclideanDomain:
    """Return the domain of a matrix."""
    found: EuclideanDomain = INTEGERS if isinstance(matrix, INTEGRAL) else matrix.domain
    return found
