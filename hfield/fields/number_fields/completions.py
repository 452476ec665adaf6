"""The completions of number fields, including quadratic ones: extensions of ℚ_p, ℝ and ℂ.

In ℝ and ℂ, the known elements are those of the number field.
"""

from __future__ import annotations

from collections.abc import Hashable
from functools import cached_property
from typing import TYPE_CHECKING

from hfield.core.product import Scalar
from hfield.errors import UndecidedError, shorten
from hfield.fields.algebraic.ring import CC, RR
from hfield.fields.base.operators import Element
from hfield.fields.base.printing import SUBSCRIPTS, blackboard
from hfield.fields.base.ring import INFINITY, Fact, Ring
from hfield.fields.local.completion import Completion
from hfield.fields.local.field import LocalField
from hfield.fields.number_fields.places import RealPlace, place_of_number_field
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.quadratic.places import QuadraticPrime
from hfield.fields.number_fields.quadratic.residues import prime_at
from hfield.fields.number_fields.residues import local_place

if TYPE_CHECKING:
    from hfield.fields.base.finite_places import FinitePlace
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.quadratic.ring import QuadraticField
    from hfield.fields.number_fields.ring import NumberField


class EmbeddedElement(Element):
    """An immutable element ``value`` of a number field, as a real or complex number."""

    __slots__ = ("value",)

    field: InfiniteCompletion
    value: FieldElement

    def __init__(self, field: InfiniteCompletion, value: Scalar) -> None:
        object.__setattr__(self, "field", field)
        object.__setattr__(self, "value", value)

    def plus(self, other: EmbeddedElement) -> EmbeddedElement:
        """Return the sum."""
        return EmbeddedElement(self.field, self.value + other.value)

    def __neg__(self) -> EmbeddedElement:
        return EmbeddedElement(self.field, -self.value)

    def times(self, other: EmbeddedElement) -> EmbeddedElement:
        """Return the product."""
        return EmbeddedElement(self.field, self.value * other.value)

    def same(self, other: EmbeddedElement) -> bool:
        """Return whether both are the same number."""
        return bool(self.value == other.value)


class InfiniteCompletion(Completion[EmbeddedElement]):
    """ℝ or ℂ as the completion of a number field; its known elements are those of the field, exact.

    RR and CC do not record the image of a field's generator; here the place determines it.
    """

    theory = "infinite completion"

    def exact(self, value: Scalar) -> EmbeddedElement:
        """Return an element of the number field."""
        return EmbeddedElement(self, value)

    def is_zero(self, x: EmbeddedElement) -> bool:
        """Return whether x is 0."""
        return self.global_field.is_zero(x.value)

    def inverse(self, x: EmbeddedElement) -> EmbeddedElement:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0."""
        return self.exact(self.global_field.inverse(x.value))

    def key(self, x: EmbeddedElement) -> Hashable:
        """Return the key of x in the number field."""
        return self.global_field.key(x.value)

    def text(self, x: EmbeddedElement, style: str = "plain") -> str:
        """Write x as in the number field."""
        return self.global_field.text(x.value, style)

    def sqrt(self, x: EmbeddedElement) -> EmbeddedElement | None:
        """Return a square root, the positive one in ℝ; None if there is none.

        Raises :class:`UndecidedError` for a root that is not in the number field, and so has no
        representation here.
        """
        if not self.is_square(x):
            return None
        root = self.global_field.sqrt(x.value)
        if root is None:
            raise UndecidedError(
                f"{shorten(self.text(x))} is a square in {shorten(self.name)}, but of no element of "
                f"{shorten(self.global_field.name)}, and others have no names here"
            )
        return self.principal(self.exact(root))

    def is_square(self, x: EmbeddedElement) -> bool:
        """Return whether x is a square."""
        return True

    def principal(self, y: EmbeddedElement) -> EmbeddedElement:
        """Return y or −y."""
        return y


class RealCompletion(InfiniteCompletion):
    """ℝ, as the completion of a number field at a real place.

    >>> from hfield import ring
    >>> L = ring("QQ(sqrt(2))").completion("inf-")
    >>> L, L.sign(L("1+sqrt(2)")), L.sqrt(L(2))
    (QQ(sqrt(2))_inf-, -1, -sqrt(2))
    """

    place: RealPlace

    @property
    def level(self) -> Fact:
        """∞: squares of real numbers are not negative."""
        return Fact(INFINITY, "squares of real numbers are not negative")

    @property
    def orderings(self) -> Fact:
        """One: the ordering of the real numbers."""
        return Fact(1, "the positive real numbers are the squares")

    def sign(self, x: EmbeddedElement, ordering: int = 0) -> int:
        """Return the sign of x at the place."""
        self.check_ordering(ordering)
        return int(self.place.sign(x.value)) if not self.is_zero(x) else 0

    def is_square(self, x: EmbeddedElement) -> bool:
        """Return whether x is nonnegative."""
        return self.sign(x) >= 0

    def principal(self, y: EmbeddedElement) -> EmbeddedElement:
        """Return the positive one of y and −y."""
        return -y if self.sign(y) < 0 else y


class ComplexCompletion(InfiniteCompletion):
    """ℂ, as the completion of a number field at a complex place."""

    @cached_property
    def level(self) -> Fact:
        """1: −1 is a square."""
        return Fact(1, "−1 is a square in ℂ")

    def minus_one_as_squares(self) -> tuple[EmbeddedElement, ...]:
        """Return a square root of −1 if the number field has one."""
        root = self.global_field.sqrt(self.global_field(-1))
        return () if root is None else (self.exact(root),)


def infinite_completion(field: Ring, place: Hashable, is_real: bool) -> InfiniteCompletion:
    """Return the completion at a real or a complex place of a number field."""
    where = f"the completion of {field.in_words()} at {place}"
    kind, line = (RealCompletion, "ℝ") if is_real else (ComplexCompletion, "ℂ")
    return kind(f"{field}_{place}", f"{line}, {where}", field, place)


def completion_of_quadratic(field: QuadraticField, place: object) -> Ring:
    """Return the completion of ℚ(√d): an extension of ℚ_p, RR or CC; at ``inf-``, ℝ with negative √d."""
    v = place_of_number_field(field, place)
    if isinstance(v, QuadraticPrime):
        return _at_prime_ideal(field, v, prime_at(v))
    if not isinstance(v, RealPlace):
        return CC
    # RR reads √d as the positive root
    return RR if v.index else infinite_completion(field, v, is_real=True)


def completion_of_number_field(field: NumberField, place: object) -> Ring:
    """Return the completion of a number field: an extension of ℚ_p, ℝ or ℂ."""
    v = place_of_number_field(field, place)
    if isinstance(v, PrimeIdeal):
        return _at_prime_ideal(field, v, local_place(v))
    return infinite_completion(field, v, isinstance(v, RealPlace))


def _at_prime_ideal(field: Ring, v: PrimeIdeal, residues: FinitePlace) -> LocalField:
    """Return the completion at a prime ideal with ``p``, ``e`` and ``f``."""
    below = f"ℚ{str(v.p).translate(SUBSCRIPTS)}"
    size = f"of degree {v.e * v.f} over {below}" if v.e * v.f > 1 else f"which is {below}"
    name = v.short_name
    words = f"the completion of {blackboard(field.name)} at {name}, {size}"
    text = name if name.startswith("(") else f"({name})"
    return LocalField(f"{field}_{text}", words, field, v, residues)
