"""Rational functions as elements: a numerator and a denominator, both polynomials of flint."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from hfield.rings.base import polynomial_power
from hfield.rings.operators import Element

if TYPE_CHECKING:
    from hfield.rings.flint_types import Polynomial, SparsePolynomial
    from hfield.rings.functions import FunctionField
    from hfield.rings.several_variables import RationalFunctions


class Quotient(Element):
    """An immutable rational function: two flint polynomials in lowest terms, ``den`` monic."""

    __slots__ = ("den", "num")

    num: Any
    den: Any

    def __init__(
        self,
        field: FunctionField | RationalFunctions,
        num: Polynomial | SparsePolynomial,
        den: Polynomial | SparsePolynomial,
    ) -> None:
        object.__setattr__(self, "field", field)
        object.__setattr__(self, "num", num)
        object.__setattr__(self, "den", den)

    def plus(self, other: Quotient) -> Quotient:
        """Return the sum."""
        if self.den == other.den:
            if self.field.is_one(self.den):
                return Quotient(self.field, self.num + other.num, self.den)
            return self.quotient(self.num + other.num, self.den)
        # What can cancel divides what the denominators have in common (Henrici, J. ACM 3, 1956).
        common = self.den.gcd(other.den)
        if self.field.is_one(common):
            num = self.num * other.den + other.num * self.den
            return Quotient(self.field, num, self.den * other.den)
        rest = self.den // common
        num = self.num * (other.den // common) + other.num * rest
        num, den = self._cancelled(num, common)
        return Quotient(self.field, num, rest * (other.den // common) * den)

    def __neg__(self) -> Quotient:
        return Quotient(self.field, -self.num, self.den)

    def times(self, other: Quotient) -> Quotient:
        """Return the product."""
        if self.field.is_one(self.den) and self.field.is_one(other.den):
            return Quotient(self.field, self.num * other.num, self.den)
        first, below = self._cancelled(self.num, other.den)
        second, den = self._cancelled(other.num, self.den)
        return Quotient(self.field, first * second, below * den)

    def _cancelled(self, num: Any, den: Any) -> tuple[Any, Any]:
        """Return num and den, which is monic, without what they have in common."""
        if self.field.is_one(den):
            return num, den
        common = num.gcd(den)
        return (num, den) if self.field.is_one(common) else (num // common, den // common)

    def quotient(
        self, num: Polynomial | SparsePolynomial, den: Polynomial | SparsePolynomial
    ) -> Quotient:
        """Return num/den in lowest terms."""
        reduced: Quotient = self.field.quotient(num, den)
        return reduced

    def __pow__(self, n: int) -> Quotient:
        base = self if n >= 0 else self.field.inverse(self)
        one = self.field.one.num
        num, den = (polynomial_power(one, x, abs(n)) for x in (base.num, base.den))
        return Quotient(self.field, num, den)

    def same(self, other: Quotient) -> bool:
        """Tell whether both are the same function."""
        return bool(self.num == other.num and self.den == other.den)
