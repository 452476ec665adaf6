"""Rational functions as elements: a numerator and a denominator, both polynomials of flint."""

from __future__ import annotations

from typing import Any

from hfield.errors import CoercionError
from hfield.rings.base import polynomial_power
from hfield.rings.rational import rational


class Quotient:
    """An immutable rational function: two flint polynomials in lowest terms, ``den`` monic."""

    __slots__ = ("den", "field", "num")

    field: Any  # the FunctionField, which stands above this room
    num: Any
    den: Any

    def __init__(self, field: Any, num: Any, den: Any) -> None:
        object.__setattr__(self, "field", field)
        object.__setattr__(self, "num", num)
        object.__setattr__(self, "den", den)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("rational functions are immutable")

    def _other(self, other: Any) -> Any:
        """Return ``other`` as a quotient of the same field, or None if it cannot mix in."""
        if type(other) is Quotient:
            if other.field is self.field or other.field == self.field:
                return other
            raise CoercionError(
                f"cannot mix elements of {self.field} and {other.field}; convert one explicitly"
            )
        number = rational(other)
        return None if number is None else self.field(number)

    def __add__(self, other: Any) -> Any:
        o = self._other(other)
        if o is None:
            return NotImplemented
        if self.den == o.den:
            if self.field.is_one(self.den):
                return Quotient(self.field, self.num + o.num, self.den)
            return self.field.quotient(self.num + o.num, self.den)
        return self.field.quotient(self.num * o.den + o.num * self.den, self.den * o.den)

    __radd__ = __add__

    def __neg__(self) -> Quotient:
        return Quotient(self.field, -self.num, self.den)

    def __pos__(self) -> Quotient:
        return self

    def __sub__(self, other: Any) -> Any:
        o = self._other(other)
        return NotImplemented if o is None else self + -o

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        o = self._other(other)
        if o is None:
            return NotImplemented
        if self.field.is_one(self.den) and self.field.is_one(o.den):
            return Quotient(self.field, self.num * o.num, self.den)
        return self.field.quotient(self.num * o.num, self.den * o.den)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        o = self._other(other)
        return NotImplemented if o is None else self * self.field.inverse(o)

    def __rtruediv__(self, other: Any) -> Any:
        return self.field.inverse(self) * other

    def __pow__(self, n: int) -> Quotient:
        base = self if n >= 0 else self.field.inverse(self)
        one = self.field.one.num
        num, den = (polynomial_power(one, x, abs(n)) for x in (base.num, base.den))
        return Quotient(self.field, num, den)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Quotient) and other.field != self.field:
            return False
        o = self._other(other)
        if o is None:
            return NotImplemented
        return bool(self.num == o.num and self.den == o.den)

    def __hash__(self) -> int:
        return hash(self.field.key(self))

    def __repr__(self) -> str:
        return str(self.field.text(self))

    def __reduce__(self) -> Any:
        return self.field, (self.field.text(self),)
