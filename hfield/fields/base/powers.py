"""Powers by repeated squaring, with a limit on the size of the result in bits."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, TypeVar

from hfield.core.product import SupportsArithmetic
from hfield.errors import TooLargeError

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.flint_types import AnyPolynomial, Coefficient

M = TypeVar("M", bound=SupportsArithmetic)

MAX_UNCHECKED_POWER = 16  # powers up to this one are computed without a check of the size
MAX_BITS = 1 << 20
QUICK_BITS = 1 << 16
TIMES = 8  # as much as this a value may grow in any case
COEFFICIENT = 4  # bits that one counts for at least, even a 0
BITS_OF_NODE = 1_000  # bits that a node of a symbolic expression counts for

# Polynomials over finite rings: nobody need look at their coefficients.
_OVER_FINITE = ("nmod_poly", "fmpz_mod_poly", "fq_default_poly")
# What our own elements are made of; their rings are no part of their size.
_INSIDE = ("num", "den", "coefficients", "poly", "terms", "value", "_stored")


def bits(x: object) -> int:
    """Return the approximate size in bits of a number, a polynomial, an element, or a sequence of these.

    >>> bits((2**100, 7))
    104
    """
    if isinstance(x, int):
        return x.bit_length()
    if isinstance(x, Fraction):
        return x.numerator.bit_length() + x.denominator.bit_length()
    if isinstance(x, (tuple, list)):
        return sum(map(bits, x))
    if isinstance(x, Mapping):
        return sum(map(bits, x.values()))
    if hasattr(x, "nbytes") and hasattr(x, "dtype") and hasattr(x, "flat"):
        return sum(map(bits, x.flat)) if x.dtype == object else 8 * int(x.nbytes)
    if type(x).__module__.startswith("flint"):
        return _flint_bits(x)
    inside = [getattr(x, name) for name in _INSIDE if hasattr(x, name)]
    if inside:
        return sum(map(bits, inside))
    return _symbolic_bits(x.expr) if hasattr(x, "expr") else 1


def _flint_bits(x: Coefficient | AnyPolynomial) -> int:
    if hasattr(x, "monoms"):
        exponents = sum(int(n).bit_length() for exponents in x.monoms() for n in exponents)
        return exponents + _bits_of_alike(x.coeffs())
    if type(x).__name__ in _OVER_FINITE:
        return (1 + COEFFICIENT) * len(x)
    if hasattr(x, "coeffs"):
        coefficients = x.coeffs()
        return _bits_of_alike(coefficients) + COEFFICIENT * len(coefficients)
    return _bits_of_alike([x])


def _bits_of_alike(numbers: list[Coefficient]) -> int:
    """Return the bits of numbers of one flint type; elements of a finite ring count 1 each."""
    if numbers and isinstance(numbers[0], int):
        return sum(map(int.bit_length, numbers))
    if numbers and hasattr(numbers[0], "height_bits"):
        return sum(int(x.height_bits()) for x in numbers)
    if numbers and hasattr(numbers[0], "q"):
        return sum(int(x.p.height_bits()) + int(x.q.height_bits()) for x in numbers)
    return len(numbers)


def _symbolic_bits(expr: sympy.Expr) -> int:
    from sympy import preorder_traversal

    parts = list(preorder_traversal(expr))
    return BITS_OF_NODE * len(parts) + sum(
        bits(int(x.p)) + bits(int(x.q)) for x in parts if x.is_Rational
    )


def is_quick(x: object, n: int) -> bool:
    """Return whether the polynomial xⁿ is small: its degree and its coefficients are below
    QUICK_BITS bits.
    """
    return n <= MAX_UNCHECKED_POWER or bits(x) * n <= QUICK_BITS


def check_growth(start: int, power: object) -> None:
    """Raise :class:`TooLargeError` if a power grows too large; ``start`` is the size of the base in bits."""
    reached = bits(power)
    if reached > MAX_BITS and reached > TIMES * start:
        raise TooLargeError(
            f"the power is too large: a square on the way to it has {reached} bits, and none with more "
            f"than {MAX_BITS} is squared again; use a smaller exponent, or a finite ring such as ZZ/n"
        )


def polynomial_power(one: AnyPolynomial, x: AnyPolynomial, n: int) -> AnyPolynomial:
    """Return xⁿ for n ≥ 0, by the library's own power if the result is small enough for it."""
    return x**n if is_quick(x, n) else power(one, x, n)


def power(one: M, x: M, n: int) -> M:
    """Return xⁿ for n ≥ 0 by repeated squaring, for any multiplication with identity ``one``.

    Raises :class:`TooLargeError` if the result would fill the memory. Exponents of any size are allowed if
    the powers stay small, as for a root of unity.
    """
    result = one
    start = bits(x) if n > MAX_UNCHECKED_POWER else None
    while n:
        if n & 1:
            result = result * x
        n >>= 1
        if n:
            if start is not None:
                check_growth(start, x)
            x = x * x
    return result
