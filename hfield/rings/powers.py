"""Powers by repeated squaring, which end before they fill the memory."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

from hfield.product import Arithmetic
from hfield.rings.growth import FEW, bits, check_growth, is_quick

if TYPE_CHECKING:
    from hfield.rings.flint_types import AnyPolynomial

M = TypeVar("M", bound=Arithmetic)


def polynomial_power(one: AnyPolynomial, x: AnyPolynomial, n: int) -> AnyPolynomial:
    """Return xⁿ for n ≥ 0, by the library's own power where the result is small enough for it."""
    return x**n if is_quick(x, n) else power(one, x, n)


def power(one: M, x: M, n: int) -> M:
    """Return xⁿ for n ≥ 0 by repeated squaring, for any multiplication with unit ``one``.

    Raises :class:`TooLargeError` where it would fill the memory; whatever stays small, such as a root of
    unity, has powers of any size.
    """
    result = one
    start = bits(x) if n > FEW else None
    while n:
        if n & 1:
            result = result * x
        n >>= 1
        if n:
            if start is not None:
                check_growth(start, x)
            x = x * x
    return result
