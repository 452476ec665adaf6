"""Elements of local fields: an element of the global field, exact or known up to a power of the prime."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from hfield.errors import CoercionError, NotInvertibleError, UndecidedError
from hfield.rings.rational import rational

if TYPE_CHECKING:
    from hfield.rings.local.field import LocalField


class LocalElement:
    """``value + O(πⁿ)``: all elements of the completion that differ from ``value`` by a multiple of πⁿ.

    ``precision`` is n, or None for the element ``value`` itself; ``value`` is an element of the global field,
    cut off at πⁿ, so that equal sets have equal parts. Immutable; ``==`` compares the sets, while ``F.equal``
    decides whether two elements are equal, and says so where too few digits are known.

    >>> from hfield import ring
    >>> F = ring("Qp(5)")
    >>> F("2 + O(5^4)") * F("10 + O(5^3)"), F("1 + O(5^3)") / 5
    (20+O(5^3), 1/5+O(5^2))
    """

    __slots__ = ("field", "precision", "value")

    field: LocalField
    value: Any
    precision: int | None

    def __init__(self, field: LocalField, value: Any, precision: int | None = None) -> None:
        if precision is not None:
            value = field.truncated(value, precision)
        object.__setattr__(self, "field", field)
        object.__setattr__(self, "value", value)
        object.__setattr__(self, "precision", precision)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("elements of local fields are immutable")

    @property
    def is_exact(self) -> bool:
        """Whether this is one element, known exactly."""
        return self.precision is None

    @property
    def has_value(self) -> bool:
        """Whether some digit that is not 0 is known, so that this is not 0."""
        return not self.field.global_field.is_zero(self.value)

    def valuation(self) -> int:
        """Return the order at the prime. Raises :class:`UndecidedError` for O(πⁿ), CoercionError for 0."""
        if self.has_value:
            return self.field.order_of(self.value)
        if self.precision is None:
            raise CoercionError("0 has no valuation: every power of the prime divides it")
        raise UndecidedError(
            f"the valuation of {self} is not known, all known digits being 0: more digits are needed, up to "
            f"{self.field.big_o(self.precision + 1)} at least"
        )

    def least_valuation(self) -> int | None:
        """Return a lower bound of the order at the prime, exact where a digit is known; None for 0."""
        return self.field.order_of(self.value) if self.has_value else self.precision

    def digits(self) -> int | None:
        """Return how many digits are known from the first that is not 0; None for all of them."""
        return None if self.precision is None else self.precision - (self.least_valuation() or 0)

    def _other(self, other: object) -> LocalElement | None:
        """Return ``other`` as an element of the same field, or None if it cannot mix in."""
        if type(other) is LocalElement:
            if other.field is self.field or other.field == self.field:
                return other
            raise CoercionError(
                f"cannot mix elements of {self.field} and {other.field}; convert one explicitly"
            )
        number = rational(other)
        return None if number is None else self.field(number)

    def __add__(self, other: object) -> LocalElement:
        o = self._other(other)
        if o is None:
            return NotImplemented
        if o is self:  # one number, twice: 2x is known to as many digits as x
            return self * 2
        return LocalElement(self.field, self.value + o.value, _least(self.precision, o.precision))

    __radd__ = __add__

    def __neg__(self) -> LocalElement:
        return LocalElement(self.field, -self.value, self.precision)

    def __pos__(self) -> LocalElement:
        return self

    def __sub__(self, other: object) -> LocalElement:
        o = self._other(other)
        return NotImplemented if o is None else self + -o

    def __rsub__(self, other: object) -> LocalElement:
        return -self + other

    def __mul__(self, other: object) -> LocalElement:
        o = self._other(other)
        if o is None:
            return NotImplemented
        precision = None
        if not (self.is_exact and o.is_exact):
            # (x + O(πᵐ))·(y + O(πⁿ)) = xy + O(y·πᵐ) + O(x·πⁿ) + O(πᵐ⁺ⁿ)
            v, w = self.least_valuation(), o.least_valuation()
            precision = _least(_sum(self.precision, w), _sum(o.precision, v))
        return LocalElement(self.field, self.value * o.value, precision)

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> LocalElement:
        o = self._other(other)
        return NotImplemented if o is None else self * o.inverse()

    def __rtruediv__(self, other: object) -> LocalElement:
        return self.inverse() * other

    def inverse(self) -> LocalElement:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0, and for O(πⁿ), which may be 0."""
        if not self.has_value:
            why = "" if self.is_exact else ", which may be 0: none of its digits but zeros is known"
            raise NotInvertibleError(f"cannot divide by {self} in {self.field}{why}")
        precision = None
        if self.precision is not None:
            precision = self.precision - 2 * self.field.order_of(self.value)
        return LocalElement(self.field, self.field.inverse_of(self.value, precision), precision)

    def __pow__(self, n: int) -> LocalElement:
        result: LocalElement = self.field.power(self, n)
        return result

    def __eq__(self, other: object) -> bool:
        if isinstance(other, LocalElement) and other.field != self.field:
            return False
        o = self._other(other)
        if o is None:
            return NotImplemented
        same: bool = self.field.global_field.equal(self.value, o.value)
        return same and self.precision == o.precision

    def __hash__(self) -> int:
        return hash(self.field.key(self))

    def __repr__(self) -> str:
        return self.field.text(self)

    def __reduce__(self) -> tuple[object, ...]:
        return self.field, (self.field.text(self),)


def _least(m: int | None, n: int | None) -> int | None:
    """Return the lesser of two, None being infinite."""
    return n if m is None else m if n is None else min(m, n)


def _sum(m: int | None, n: int | None) -> int | None:
    return None if m is None or n is None else m + n
