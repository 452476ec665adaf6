"""Operators of elements that know their field, and fields that have such elements."""

from __future__ import annotations

from abc import abstractmethod
from typing import TYPE_CHECKING, Self

from hfield.errors import CoercionError
from hfield.fields.base.coercion import rational, unwrap
from hfield.fields.base.from_sympy import is_of_sympy
from hfield.fields.base.ring import E, Ring
from hfield.sympy_printing import PrintedBySympy

if TYPE_CHECKING:
    import sympy


class Element(PrintedBySympy):
    """An immutable element of ``field``. Its operators accept elements of the same field and numbers.

    Subclasses define :meth:`plus`, ``-x``, :meth:`times` and :meth:`same`.
    """

    __slots__ = ("field",)

    field: Ring

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"elements of {self.field} are immutable")

    @abstractmethod
    def plus(self, other: Self) -> Self:
        """Return the sum with an element of the same field."""

    @abstractmethod
    def __neg__(self) -> Self: ...

    @abstractmethod
    def times(self, other: Self) -> Self:
        """Return the product with an element of the same field."""

    @abstractmethod
    def same(self, other: Self) -> bool:
        """Return whether an element of the same field is equal to this one."""

    def _repr_latex_(self) -> str:
        """Show the element in a notebook."""
        return f"${self.field.text(self, 'latex')}$"

    def _sympy_(self) -> sympy.Expr:
        found: sympy.Expr = self.field.to_sympy(self, {})
        return found

    def coerced(self, other: object) -> Self | None:
        """Return ``other`` as an element of the same field; None if it cannot be read as one.

        Raises :class:`CoercionError` for an element of another field.
        """
        if type(other) is type(self):
            if other.field is self.field or other.field == self.field:
                return other
            raise CoercionError(
                f"cannot mix elements of {self.field} and {other.field}; convert one explicitly"
            )
        number = rational(other)
        return None if number is None else self.field(number)

    def __add__(self, other: object) -> Self:
        o = self.coerced(other)
        return NotImplemented if o is None else self.plus(o)

    __radd__ = __add__

    def __pos__(self) -> Self:
        return self

    def __sub__(self, other: object) -> Self:
        o = self.coerced(other)
        return NotImplemented if o is None else self.plus(-o)

    def __rsub__(self, other: object) -> Self:
        return -self + other

    def __mul__(self, other: object) -> Self:
        o = self.coerced(other)
        return NotImplemented if o is None else self.times(o)

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Self:
        o = self.coerced(other)
        return NotImplemented if o is None else self.times(self.field.inverse(o))

    def __rtruediv__(self, other: object) -> Self:
        result: Self = self.field.inverse(self) * other
        return result

    def __pow__(self, n: int) -> Self:
        result: Self = self.field.power(self, n)
        return result

    def __eq__(self, other: object) -> bool:
        if type(other) is type(self) and other.field != self.field:
            return False
        o = self.coerced(other)
        return NotImplemented if o is None else self.same(o)

    def __hash__(self) -> int:
        return hash(self.field.key(self))

    def __repr__(self) -> str:
        return str(self.field.text(self))

    def __reduce__(self) -> tuple[object, ...]:
        return self.field, (self.field.text(self),)


class Overfield(Ring[E]):
    """A field that contains a given ring; its elements are :class:`~hfield.fields.base.operators.Element`.

    Subclasses define :meth:`from_below`.
    """

    is_field = True

    @abstractmethod
    def from_below(self, x: object) -> E:
        """Convert a value that the ring below reads to an element of the field. Raises
        :class:`CoercionError`.
        """

    def __call__(self, x: object) -> E:
        """Convert an element, a value of the ring below, or a text to an element.

        Raises :class:`CoercionError`.
        """
        x = unwrap(x)
        if isinstance(x, Element) and (x.field is self or x.field == self):
            return x  # type: ignore[return-value]  # a field has elements of one class
        if isinstance(x, str):
            return self.parse(x)
        if is_of_sympy(x):
            return self.foreign(x)
        try:
            return self.from_below(x)
        except CoercionError:
            raise self.refuse(x) from None
