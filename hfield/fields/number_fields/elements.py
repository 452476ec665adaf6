"""Elements of number fields ℚ(s): polynomials of FLINT in s, reduced modulo the minimal polynomial of s."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING

import flint

from hfield.fields.base.coercion import fmpq, rational
from hfield.sympy_printing import PrintedBySympy

if TYPE_CHECKING:
    import sympy

    from hfield.fields.algebraic.surds import Surd
    from hfield.fields.number_fields.ring import NumberField


# The operators of python-flint's polynomials look up the type of the other operand, which takes
# longer than adding or multiplying two short polynomials. The methods that they call are faster if
# both operands are polynomials.
_add = getattr(flint.fmpq_poly, "_add_", operator.add)
_subtract = getattr(flint.fmpq_poly, "_sub_", operator.sub)
_multiply = getattr(flint.fmpq_poly, "_mul_", operator.mul)
_remainder = getattr(flint.fmpq_poly, "_mod_", operator.mod)


class FieldElement(PrintedBySympy):
    """An element of a :class:`NumberField`; ``poly`` is flint's polynomial in s of least degree.

    Do not modify it: equal elements have equal polynomials and equal hashes.

    >>> from hfield import ring
    >>> K = ring("QQ[s]/(s^3-2)"); s = K.gen
    >>> (1 + s).norm(), (1 + s).trace(), (1 + s).inverse()
    (3, 3, 1/3-1/3*s+1/3*s^2)
    """

    __slots__ = ("field", "poly")

    def __init__(self, field: NumberField, poly: flint.fmpq_poly) -> None:
        self.field = field
        self.poly = poly

    def _other(self, x: object) -> flint.fmpq_poly | flint.fmpq | int | None:
        """Return x in the form used for computing: a polynomial, a rational number, or None."""
        if type(x) is FieldElement:
            return x.poly if x.field is self.field or x.field == self.field else None
        if type(x) is int or type(x) is flint.fmpq:
            return x
        number = rational(x)
        return None if number is None else fmpq(number)

    # --- arithmetic ----------------------------------------------------------------------------

    def __add__(self, other: object) -> FieldElement:
        field = self.field
        if type(other) is FieldElement and other.field is field:
            return FieldElement(field, _add(self.poly, other.poly))
        y = self._other(other)
        return NotImplemented if y is None else FieldElement(field, self.poly + y)

    __radd__ = __add__

    def __sub__(self, other: object) -> FieldElement:
        field = self.field
        if type(other) is FieldElement and other.field is field:
            return FieldElement(field, _subtract(self.poly, other.poly))
        y = self._other(other)
        return NotImplemented if y is None else FieldElement(field, self.poly - y)

    def __rsub__(self, other: object) -> FieldElement:
        y = self._other(other)
        return NotImplemented if y is None else FieldElement(self.field, y - self.poly)

    def __neg__(self) -> FieldElement:
        return FieldElement(self.field, -self.poly)

    def __pos__(self) -> FieldElement:
        return self

    def __mul__(self, other: object) -> FieldElement:
        field = self.field
        if type(other) is FieldElement and (other.field is field or other.field == field):
            product = _multiply(self.poly, other.poly)
            return FieldElement(field, _remainder(product, field.polynomial))
        y = self._other(other)
        return NotImplemented if y is None else FieldElement(field, self.poly * y)

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> FieldElement:
        field = self.field
        if type(other) is FieldElement and (other.field is field or other.field == field):
            return self * field.inverse(other)
        y = self._other(other)
        return NotImplemented if y is None else self * field(y).inverse()

    def __rtruediv__(self, other: object) -> FieldElement:
        y = self._other(other)
        return NotImplemented if y is None else self.inverse() * y

    def __pow__(self, n: int) -> FieldElement:
        return self.field.power(self, operator.index(n))

    def inverse(self) -> FieldElement:
        """Return 1/self. Raises :class:`NotInvertibleError` for 0."""
        inverse: FieldElement = self.field.inverse(self)
        return inverse

    # --- identity ------------------------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        if type(other) is FieldElement:
            same = self.field is other.field or self.field == other.field
            return same and bool(self.poly == other.poly)
        number = rational(other)
        if number is None:
            return NotImplemented
        return bool(self.poly == flint.fmpq(number.numerator, number.denominator))

    def __hash__(self) -> int:
        if len(self.poly) > 1:  # integers are hashed five times as fast as rational numbers
            return hash((int(self.poly.denom()), *map(int, self.poly.numer().coeffs())))
        return hash(self.poly[0])  # as of the equal rational number

    def __bool__(self) -> bool:
        return bool(self.poly)

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, (self.field, [(int(c.p), int(c.q)) for c in self.poly.coeffs()])

    def __repr__(self) -> str:
        return self.field.text(self)

    def _repr_latex_(self) -> str:
        return f"${self.field.text(self, 'latex')}$"

    def _sympy_(self) -> sympy.Expr:
        return self.field.to_sympy(self, {})

    def as_surd(self) -> Surd | None:
        """Return the number as a sum of square roots, or None if its field contains no such sums."""
        found: Surd | None = self.field.as_surd(self)
        return found

    # --- what it is ----------------------------------------------------------------------------

    def is_rational(self) -> bool:
        """Return whether the number is rational."""
        return bool(self.poly.degree() < 1)

    def norm(self) -> flint.fmpq:
        """Return the norm down to ℚ, the product of the conjugates."""
        return self.field.polynomial.resultant(self.poly)

    def trace(self) -> flint.fmpq:
        """Return the trace down to ℚ, the sum of the conjugates."""
        return sum(
            (c * t for c, t in zip(self.poly.coeffs(), self.field.traces, strict=False)),
            flint.fmpq(0),
        )

    def minimal_polynomial(self) -> list[flint.fmpq]:
        """Return the coefficients of the minimal polynomial over ℚ, low degree first, monic."""
        return list(self.field.multiplication(self).minpoly().coeffs())

    def sqrt(self) -> FieldElement | None:
        """Return the principal square root in the field, or None if there is none."""
        root: FieldElement | None = self.field.sqrt(self)
        return root

    def sign(self, ordering: int = 0) -> int:
        """Return the sign at a real place, numbered from 0 in the order of the roots."""
        return self.field.sign(self, ordering)

    def complex(self, place: int | None = None, digits: int = 15) -> flint.acb:
        """Return the value at an infinite place, a complex ball of flint with ``digits`` correct digits.

        Places are numbered as in :meth:`NumberField.infinite_places`; the default is the embedding that the
        field's name suggests.

        >>> from hfield import ring
        >>> z = ring("QQ(zeta5)").gen.complex(digits=30)
        >>> z.real.str(20), z.imag.str(20)
        ('[0.30901699437494742410 +/- 2.30e-21]', '[0.95105651629515357212 +/- 3.57e-21]')
        """
        return self.field.embed(self, place, digits)


def _restore(field: NumberField, pairs: list[tuple[int, int]]) -> FieldElement:
    return FieldElement(field, flint.fmpq_poly([flint.fmpq(*pair) for pair in pairs]))


def coefficients(x: FieldElement) -> list[flint.fmpq]:
    """Return the coefficients of an element at 1, s, s² …, as many as the degree of the field."""
    found = x.poly.coeffs()
    return [*found, *[flint.fmpq(0)] * (x.field.degree - len(found))]
