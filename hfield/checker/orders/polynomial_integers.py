"""GF(q)[t], with the operations of the integers of a number field that lattices need."""

from collections.abc import Hashable, Iterator, Sequence
from itertools import product

from hfield.checker.budget import spend
from hfield.checker.number_fields.matrices import RowOf
from hfield.checker.rejection import reject
from hfield.checker.scalars.finite import Finite
from hfield.checker.scalars.finite_field_polynomials import FiniteFieldPolynomial
from hfield.checker.scalars.functions import Fraction as Function
from hfield.checker.scalars.functions import Functions
from hfield.checker.scalars.polynomials import dense
from hfield.checker.scalars.quotients import QuotientField
from hfield.checker.statement import Setting

PolynomialRow = RowOf[FiniteFieldPolynomial]


class PolynomialIntegers:
    """GF(q)[t], with the operations of a ring of integers of degree 1."""

    def __init__(self, setting: Setting) -> None:
        field = setting.field
        if not (
            isinstance(field, Functions)
            and isinstance(field.base, Finite)
            and field.base.order is not None
            and field.base.is_field
        ):
            reject("lattices over polynomials are those of functions GF(q)(t) in one variable")
        self.n, self.functions = 1, field
        self.base: Finite[Hashable] = field.base
        self.zero = FiniteFieldPolynomial(self.base, ())
        self.one: PolynomialRow = (FiniteFieldPolynomial(self.base, [self.base.one]),)
        self.table: list[list[PolynomialRow]] = [[self.one]]

    @property
    def order(self) -> int:
        """The number q of elements of the constant field."""
        return self.base.order

    def coordinates(
        self, x: Sequence[Function[Hashable]]
    ) -> tuple[FiniteFieldPolynomial, PolynomialRow]:
        """Return a rational function, in a row of one entry, as a polynomial over a monic denominator."""
        top, below = (FiniteFieldPolynomial(self.base, dense(part, self.base)) for part in x[0])
        scale = below.to_normal
        return below * scale, (top * scale,)

    def mul(
        self, x: Sequence[FiniteFieldPolynomial], y: Sequence[FiniteFieldPolynomial]
    ) -> PolynomialRow:
        """Return a product."""
        return (x[0] * y[0],)

    def matrix(self, x: Sequence[FiniteFieldPolynomial]) -> list[PolynomialRow]:
        """Return the matrix of multiplication by x."""
        row: PolynomialRow = tuple(x)
        return [row]

    def norm(self, x: Sequence[FiniteFieldPolynomial]) -> FiniteFieldPolynomial:
        """Return the norm down to the functions: the polynomial itself."""
        return x[0]

    def of_degree_below(self, bound: int) -> Iterator[FiniteFieldPolynomial]:
        """Yield all polynomials of degree below a bound."""
        spend(self.order)
        for coefficients in product(*[list(self.base.elements())] * max(bound, 0)):
            spend(2 + bound)
            yield FiniteFieldPolynomial(self.base, coefficients)

    def prime(self, text: str) -> tuple[FiniteFieldPolynomial, QuotientField[Hashable]]:
        """Read a monic prime polynomial, and return it with its residue field."""
        den, (P,) = self.coordinates([self.functions.read(text)])
        if den.degree or P.degree < 1 or P.lead != self.base.one:
            reject("a prime of the polynomials is written as a monic polynomial")
        return P, QuotientField(self.base, P.coefficients)
