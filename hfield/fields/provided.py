"""The list of all kinds of fields with their theories, for the registry; each is imported on first use.

A new kind of field with places needs an entry here.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.fields.base.registry import Registry, Theory

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.ring import E, Ring
    from hfield.fields.function_fields.ring import FunctionField
    from hfield.fields.number_fields.quadratic.ring import QuadraticField
    from hfield.fields.number_fields.ring import NumberField
    from hfield.fields.quadratic_forms.global_field import GlobalField
    from hfield.fields.rationals.ring import Rationals


def _rationals() -> type[GlobalField]:
    from hfield.fields.rationals.arithmetic import RationalArithmetic

    return RationalArithmetic


def _complete_rationals(field: Rationals, place: object) -> Ring:
    from hfield.fields.rationals.completions import completion_of_rationals

    return completion_of_rationals(field, place)


def _number_field() -> type[GlobalField]:
    from hfield.fields.number_fields.arithmetic import NumberFieldArithmetic

    return NumberFieldArithmetic


def _complete_number_field(field: NumberField, place: object) -> Ring:
    from hfield.fields.number_fields.completions import completion_of_number_field

    return completion_of_number_field(field, place)


def _read_number_field(name: str) -> Ring | None:
    if not name.startswith(("Q(", "Q[", "QQ(", "QQ[")):
        return None
    from hfield.fields.number_fields.names import read_number_field

    return read_number_field(name)


def _quadratic_field() -> type[GlobalField]:
    from hfield.fields.number_fields.quadratic.arithmetic import QuadraticArithmetic

    return QuadraticArithmetic


def _complete_quadratic(field: QuadraticField, place: object) -> Ring:
    from hfield.fields.number_fields.completions import completion_of_quadratic

    return completion_of_quadratic(field, place)


def _function_field() -> type[GlobalField]:
    from hfield.fields.function_fields.arithmetic import FunctionArithmetic

    return FunctionArithmetic


def _complete_function_field(field: FunctionField, place: object) -> Ring:
    from hfield.fields.function_fields.completions import completion_of_functions

    return completion_of_functions(field, place)


def _several_variables() -> type[GlobalField]:
    from hfield.fields.several_variables.arithmetic import SeveralArithmetic

    return SeveralArithmetic


def _local_field() -> type[GlobalField]:
    from hfield.fields.local.arithmetic import LocalArithmetic

    return LocalArithmetic


def _infinite_completion() -> type[GlobalField]:
    from hfield.fields.number_fields.infinite_arithmetic import InfiniteArithmetic

    return InfiniteArithmetic


class _Functions:
    """The single functions that rings need."""

    def rational_functions(self, base: Ring, variable: str) -> Ring:
        """Return the field of rational functions in one variable over a field."""
        from hfield.fields.base.ring import shared
        from hfield.fields.function_fields.ring import FunctionField

        return shared(FunctionField, base, variable)

    def cosine_and_sine(self, ring: Ring[E], angle: object, parts: int) -> tuple[E, E]:
        """Return the cosine and sine of an angle divided into equal parts, as elements of the ring."""
        from hfield.fields.circles.angles import cosine_and_sine_of

        return cosine_and_sine_of(ring, angle, parts)

    def rational_number(self, x: sympy.Expr) -> object | None:
        """Return the rational number that an expression without symbols represents, or None."""
        from hfield.fields.algebraic.closed_forms import from_sympy
        from hfield.fields.algebraic.surds import Surd

        value = from_sympy(x)
        return value.terms.get(1, 0) if isinstance(value, Surd) and value.is_rational() else None

    def algebraic_to_sympy(self, x: object) -> sympy.Expr | None:
        """Return an element of RR or CC as an expression; None for other values."""
        from hfield.fields.algebraic.closed_forms import to_sympy

        return to_sympy(x)

    def common_quadratic_field(self, *elements: object) -> Ring | None:
        """Return ℚ(√d) for sums of rational numbers and multiples of √d; None if all are rational."""
        from hfield.fields.number_fields.quadratic.ring import common_quadratic_field

        return common_quadratic_field(*elements)


def provide(registry: Registry) -> None:
    """Add the theories of all kinds of fields, and the functions that rings need, to a registry."""
    registry.add("rationals", Theory(_rationals, _complete_rationals))
    registry.add("number field", Theory(_number_field, _complete_number_field, _read_number_field))
    registry.add("quadratic field", Theory(_quadratic_field, _complete_quadratic))
    registry.add("function field", Theory(_function_field, _complete_function_field))
    registry.add("several variables", Theory(_several_variables))
    registry.add("local field", Theory(_local_field))
    registry.add("infinite completion", Theory(_infinite_completion))
    registry.functions = _Functions()
