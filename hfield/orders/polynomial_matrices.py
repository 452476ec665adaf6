"""Matrices of polynomials and of rational functions over finite fields, with the methods of flint's matrices.

The methods have the names of those of ``fmpz_mat`` and ``fmpq_mat``, so that functions on lattices work with
both. flint has polynomials over GF(q), ``fq_default_poly``, but no matrices of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, TypeAlias, overload

from hfield.fields.function_fields.quotients import RationalFunction

if TYPE_CHECKING:
    from flint import fq_default_poly

    from hfield.orders.base_values import Integer, Rational
    from hfield.orders.domains import PolynomialDomain

Row: TypeAlias = "list[fq_default_poly]"


class PolynomialMatrix:
    """A matrix of polynomials."""

    __slots__ = ("_columns", "_entries", "_rows", "domain")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, domain: PolynomialDomain, rows: int, columns: int, entries: Row) -> None:
        self.domain, self._rows, self._columns, self._entries = domain, rows, columns, entries

    def nrows(self) -> int:
        """Return the number of rows."""
        return self._rows

    def ncols(self) -> int:
        """Return the number of columns."""
        return self._columns

    def entries(self) -> Row:
        """Return all entries, row by row."""
        return list(self._entries)

    def tolist(self) -> list[Row]:
        """Return the rows."""
        n = self._columns
        return [self._entries[k * n : (k + 1) * n] for k in range(self._rows)]

    def __getitem__(self, place: tuple[int, int]) -> fq_default_poly:
        return self._entries[place[0] * self._columns + place[1]]

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, PolynomialMatrix)
            and self._columns == other._columns
            and self._entries == other._entries
        )

    def _like(self, entries: Row) -> PolynomialMatrix:
        return PolynomialMatrix(self.domain, self._rows, self._columns, entries)

    def __add__(self, other: PolynomialMatrix) -> PolynomialMatrix:
        return self._like([x + y for x, y in zip(self._entries, other._entries, strict=True)])

    def __sub__(self, other: PolynomialMatrix) -> PolynomialMatrix:
        return self._like([x - y for x, y in zip(self._entries, other._entries, strict=True)])

    def __neg__(self) -> PolynomialMatrix:
        return self._like([-x for x in self._entries])

    @overload
    def __mul__(self, other: FractionMatrix | RationalFunction) -> FractionMatrix: ...

    @overload
    def __mul__(self, other: PolynomialMatrix | fq_default_poly | int) -> PolynomialMatrix: ...

    def __mul__(
        self, other: PolynomialMatrix | FractionMatrix | RationalFunction | fq_default_poly | int
    ) -> PolynomialMatrix | FractionMatrix:
        """Return the product with a matrix, or with a number, which may be a fraction."""
        if isinstance(other, FractionMatrix):
            return FractionMatrix(self * other.numerators, other.denominator)
        if isinstance(other, RationalFunction):
            return FractionMatrix(self * other.num, other.den)
        if not isinstance(other, PolynomialMatrix):
            return self._like([x * other for x in self._entries])
        zero, n = self.domain.zero, other._columns
        columns = [other._entries[k::n] for k in range(n)]
        found = []
        for row in self.tolist():
            support = [(k, x) for k, x in enumerate(row) if x]
            for column in columns:
                total = zero
                for k, x in support:
                    y = column[k]
                    if y:
                        total = total + x * y
                found.append(total)
        return PolynomialMatrix(self.domain, self._rows, n, found)

    def transpose(self) -> PolynomialMatrix:
        """Return the transposed matrix."""
        n = self._columns
        entries = [x for k in range(n) for x in self._entries[k::n]]
        return PolynomialMatrix(self.domain, n, self._rows, entries)

    def hnf(self) -> PolynomialMatrix:
        """Return the row Hermite form: an echelon form with monic pivots of larger degree than the entries
        above them.
        """
        rows, size = self.tolist(), self._columns
        top = 0
        for k in range(size):
            if top == len(rows):
                break
            if _eliminate(rows, top, k):
                rows[top] = _monic(rows[top], k)
                pivot = rows[top][k]
                for m in range(top):
                    _subtract(rows[m], rows[top], rows[m][k] // pivot, k)
                top += 1
        return self._like([x for row in rows for x in row])

    def rank(self) -> int:
        """Return the rank."""
        return sum(1 for row in self.hnf().tolist() if any(row))

    def det(self) -> fq_default_poly:
        """Return the determinant of a square matrix."""
        return _eliminated(self.tolist(), self._rows, self.domain.one)[0]

    def inv(self) -> FractionMatrix:
        """Return the inverse. Raises :class:`ZeroDivisionError` for a singular matrix."""
        size, one, zero = self._rows, self.domain.one, self.domain.zero
        rows = [
            row + [one if m == k else zero for m in range(size)]
            for k, row in enumerate(self.tolist())
        ]
        det, done = _eliminated(rows, size, one)
        if not det:
            raise ZeroDivisionError("the matrix is singular")
        entries = [x for row in done for x in row[size:]]
        return FractionMatrix(PolynomialMatrix(self.domain, size, size, entries), det)

    def nullspace(self) -> tuple[PolynomialMatrix, int]:
        """Return a matrix whose first columns are a basis of all x with matrix·x = 0, and the number of these
        columns.
        """
        size, one, zero = self._columns, self.domain.one, self.domain.zero
        table = self.transpose().tolist()
        rows = [row + [one if m == k else zero for m in range(size)] for k, row in enumerate(table)]
        width = self._rows
        whole = PolynomialMatrix(
            self.domain, size, width + size, [x for row in rows for x in row]
        ).hnf()
        kept = [row[width:] for row in whole.tolist() if not any(row[:width])]
        padded = kept + [[zero] * size for _ in range(size - len(kept))]
        found = PolynomialMatrix(self.domain, size, size, [x for row in padded for x in row])
        return found.transpose(), len(kept)


class FractionMatrix:
    """A matrix of rational functions: polynomials over a common denominator."""

    __slots__ = ("_lowest", "denominator", "numerators")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, numerators: PolynomialMatrix, denominator: fq_default_poly) -> None:
        self.numerators, self.denominator, self._lowest = numerators, denominator, False

    @property
    def domain(self) -> PolynomialDomain:
        """The ring of the polynomials."""
        return self.numerators.domain

    def numer_denom(self) -> tuple[PolynomialMatrix, fq_default_poly]:
        """Return the numerators over the least denominator, which is monic."""
        if not self._lowest:
            domain, den = self.domain, self.denominator
            common = domain.content([den, *self.numerators._entries])
            scale = common * den.leading_coefficient()
            if scale != domain.one:
                self.numerators = domain.divided(self.numerators, scale)
                self.denominator = den // scale
            self._lowest = True
        return self.numerators, self.denominator

    def nrows(self) -> int:
        """Return the number of rows."""
        return self.numerators.nrows()

    def ncols(self) -> int:
        """Return the number of columns."""
        return self.numerators.ncols()

    def entries(self) -> list[RationalFunction]:
        """Return all entries, row by row, as elements of the field."""
        num, den = self.numer_denom()
        return [self.domain.fraction(x, den) for x in num._entries]

    def tolist(self) -> list[list[RationalFunction]]:
        """Return the rows."""
        n, entries = self.ncols(), self.entries()
        return [entries[k * n : (k + 1) * n] for k in range(self.nrows())]

    def __getitem__(self, place: tuple[int, int]) -> RationalFunction:
        return self.domain.fraction(self.numerators[place], self.denominator)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, FractionMatrix) and self.numer_denom() == other.numer_denom()

    def __add__(self, other: FractionMatrix) -> FractionMatrix:
        den = self.denominator * other.denominator
        return FractionMatrix(
            self.numerators * other.denominator + other.numerators * self.denominator, den
        )

    def __sub__(self, other: FractionMatrix) -> FractionMatrix:
        return self + (-other)

    def __neg__(self) -> FractionMatrix:
        return FractionMatrix(-self.numerators, self.denominator)

    def __mul__(
        self, other: PolynomialMatrix | FractionMatrix | RationalFunction | fq_default_poly | int
    ) -> FractionMatrix:
        """Return the product with a matrix, or with a number."""
        if isinstance(other, FractionMatrix):
            den = self.denominator * other.denominator
            return FractionMatrix(self.numerators * other.numerators, den)
        if isinstance(other, RationalFunction):
            return FractionMatrix(self.numerators * other.num, self.denominator * other.den)
        return FractionMatrix(self.numerators * other, self.denominator)

    def transpose(self) -> FractionMatrix:
        """Return the transposed matrix."""
        return FractionMatrix(self.numerators.transpose(), self.denominator)

    def inv(self) -> FractionMatrix:
        """Return the inverse. Raises :class:`ZeroDivisionError` for a singular matrix."""
        found: FractionMatrix = self.numerators.inv() * self.denominator
        return found


def fractions(
    domain: PolynomialDomain, rows: Iterable[Sequence[Rational | Integer]]
) -> FractionMatrix:
    """Return rows of rational functions as a matrix."""
    table = [list(map(domain.as_fraction, row)) for row in rows]
    den = domain.lcm(*(x.den for row in table for x in row))
    entries = [x.num * (den // x.den) for row in table for x in row]
    columns = len(table[0]) if table else 0
    return FractionMatrix(PolynomialMatrix(domain, len(table), columns, entries), den)


def _subtract(row: Row, other: Row, factor: fq_default_poly, start: int) -> None:
    """Subtract a multiple of another row, starting at a column."""
    if factor:
        for k in range(start, len(row)):
            if other[k]:
                row[k] = row[k] - factor * other[k]


def _eliminate(rows: list[Row], top: int, k: int) -> bool:
    """Clear column k below row ``top`` by Euclid's algorithm; return whether there is a pivot."""
    while True:
        some = [m for m in range(top, len(rows)) if rows[m][k]]
        if not some:
            return False
        least = min(some, key=lambda m: rows[m][k].degree())
        rows[top], rows[least] = rows[least], rows[top]
        if len(some) == 1:
            return True
        pivot = rows[top]
        for m in range(top + 1, len(rows)):
            if rows[m][k]:
                _subtract(rows[m], pivot, rows[m][k] // pivot[k], k)


def _monic(row: Row, k: int) -> Row:
    """Return a row times the constant that makes its entry in column k monic."""
    lead = row[k].leading_coefficient()
    if lead == 1:
        return row
    inverse = lead.inverse()
    return [x * inverse for x in row]


def _eliminated(
    rows: list[Row], size: int, one: fq_default_poly
) -> tuple[fq_default_poly, list[Row]]:
    """Reduce the first columns of rows to d times the identity without fractions (Bareiss); return
    d as well.
    """
    before = one
    for k in range(size):
        pivot = next((m for m in range(k, size) if rows[m][k]), None)
        if pivot is None:
            return one * 0, rows
        if pivot != k:
            rows[k], rows[pivot] = rows[pivot], [-x for x in rows[k]]
        top, head = rows[k], rows[k][k]
        for m in range(size):
            if m != k:
                factor = rows[m][k]
                rows[m] = [
                    (x * head - factor * y) // before for x, y in zip(rows[m], top, strict=True)
                ]
        before = head
    return before, rows
