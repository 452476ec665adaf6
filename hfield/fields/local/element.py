"""Elements of local fields: an element of the global field, exact or known up to a power of the prime."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.core.product import Scalar
from hfield.errors import CoercionError, NotInvertibleError, UndecidedError
from hfield.fields.base.operators import Element

if TYPE_CHECKING:
    from hfield.fields.local.field import LocalField


class LocalElement(Element):
    """``value + O(πⁿ)``: all elements of the completion that differ from ``value`` by a multiple of πⁿ.

    ``precision`` is n, or None for the element ``value`` itself; ``value`` is an element of the global field,
    truncated at πⁿ, so that equal sets have equal parts. Immutable. ``==`` compares the sets; ``F.equal``
    decides whether two elements are equal, and raises :class:`UndecidedError` if too few digits are known.

    >>> from hfield import ring
    >>> F = ring("Qp(5)")
    >>> F("2 + O(5^4)") * F("10 + O(5^3)"), F("1 + O(5^3)") / 5
    (20+O(5^3), 1/5+O(5^2))
    """

    __slots__ = ("precision", "value")

    field: LocalField
    value: Scalar
    precision: int | None

    def __init__(self, field: LocalField, value: Scalar, precision: int | None = None) -> None:
        if precision is not None:
            value = field.truncated(value, precision)
        object.__setattr__(self, "field", field)
        object.__setattr__(self, "value", value)
        object.__setattr__(self, "precision", precision)

    @property
    def is_exact(self) -> bool:
        """Whether the element is known exactly."""
        return self.precision is None

    @property
    def has_value(self) -> bool:
        """Whether a nonzero digit is known, so that the element is not 0."""
        return not self.field.global_field.is_zero(self.value)

    def valuation(self) -> int:
        """Return the valuation at the prime. Raises :class:`UndecidedError` for O(πⁿ),
        CoercionError for 0.
        """
        if self.has_value:
            return self.field.order_of(self.value)
        if self.precision is None:
            raise CoercionError("0 has no valuation: every power of the prime divides it")
        raise UndecidedError(
            f"the valuation of {self} is not known, because all known digits are 0: more digits are needed, "
            f"up to {self.field.big_o(self.precision + 1)} at least"
        )

    def least_valuation(self) -> int | None:
        """Return a lower bound for the valuation at the prime, exact if a nonzero digit is known;
        None for 0.
        """
        return self.field.order_of(self.value) if self.has_value else self.precision

    def digits(self) -> int | None:
        """Return the relative precision: the number of known digits from the first nonzero digit on; None for
        exact elements.
        """
        return None if self.precision is None else self.precision - (self.least_valuation() or 0)

    def plus(self, other: LocalElement) -> LocalElement:
        """Return the set of all sums."""
        precision = _least(self.precision, other.precision)
        return LocalElement(self.field, self.value + other.value, precision)

    def __neg__(self) -> LocalElement:
        return LocalElement(self.field, -self.value, self.precision)

    def times(self, other: LocalElement) -> LocalElement:
        """Return the product, to the precision that the factors determine."""
        precision = None
        if not (self.is_exact and other.is_exact):
            # (x + O(πᵐ))·(y + O(πⁿ)) = xy + O(y·πᵐ) + O(x·πⁿ) + O(πᵐ⁺ⁿ)
            v, w = self.least_valuation(), other.least_valuation()
            precision = _least(_sum(self.precision, w), _sum(other.precision, v))
        return LocalElement(self.field, self.value * other.value, precision)

    def inverse(self) -> LocalElement:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0, UndecidedError for O(πⁿ), which may be 0."""
        if self.field.is_zero(self):
            raise NotInvertibleError(f"cannot divide by 0 in {self.field}")
        precision = None
        if self.precision is not None:
            precision = self.precision - 2 * self.field.order_of(self.value)
        return LocalElement(self.field, self.field.global_field.inverse(self.value), precision)

    def same(self, other: LocalElement) -> bool:
        """Return whether both have the same digits and the same precision."""
        equal: bool = self.field.global_field.equal(self.value, other.value)
        return equal and self.precision == other.precision


def _least(m: int | None, n: int | None) -> int | None:
    """Return the smaller of two numbers, where None means infinity."""
    return n if m is None else m if n is None else min(m, n)


def _sum(m: int | None, n: int | None) -> int | None:
    return None if m is None or n is None else m + n
