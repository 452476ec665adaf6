"""Read integers and rational numbers of any library as elements of a ring."""

from __future__ import annotations

import numbers
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, TypeGuard

import flint

from hfield import syntax
from hfield.errors import NotationError, RingError, TooLargeError, shorten

if TYPE_CHECKING:
    import numpy as np


def rational(x: object) -> int | Fraction | None:
    """Return x as an int or a Fraction if it is an exact rational number; None for anything else.

    The numbers of Python (including ``Decimal``), numpy, gmpy2, sympy and flint are recognised. An element of
    a finite field is not: numpy would convert a galois scalar to its integer label, but a label is not a
    multiple of 1. Nor is a float, which is rational only by accident of rounding.
    """
    if isinstance(x, int):  # a bool counts as 0 or 1
        return int(x)
    if isinstance(x, flint.fmpz):
        return int(x)
    if isinstance(x, flint.fmpq):
        return reduced(Fraction(int(x.p), int(x.q)))
    if isinstance(x, Decimal):
        return reduced(Fraction(x)) if x.is_finite() else None
    if isinstance(x, numbers.Rational):
        return reduced(Fraction(int(x.numerator), int(x.denominator)))
    if is_plain_array(x) and x.ndim == 0:
        return rational(x.item())
    if getattr(getattr(x, "dtype", None), "kind", "") == "b" and getattr(x, "ndim", 1) == 0:
        return int(bool(x))  # numpy's own bool, which is no int
    return None


def whole_number(text: str) -> int | None:
    """Return the integer that ``+ - * ^`` form from literals, as in ``10^9+7``; None for any other text.

    Raises :class:`RingError` if it is too large to compute.
    """
    reader = syntax.Reader(_literal, {}, {"**": _power, "/": _no_quotient}, "integers")
    try:
        return int(reader.read(text))
    except TooLargeError:
        raise RingError(f"{shorten(text)} is too large; at most 4096 bits are taken") from None
    except NotationError:
        return None


def _literal(c: int | Fraction) -> int:
    if isinstance(c, Fraction):
        raise NotationError(f"{c} is not an integer")
    return c


def _power(x: int, n: int) -> int:
    if n < 0:
        raise NotationError(f"{x}^({n}) is not accepted as an integer")
    return int(x**n)


def _no_quotient(x: int, y: int) -> int:
    raise NotationError(f"{x}/{y} is not accepted as an integer")


def is_plain_array(x: object) -> TypeGuard[np.ndarray]:
    """Return whether x is a plain numpy array, not one of a library with its own arithmetic."""
    kind = type(x)
    return kind.__name__ in ("ndarray", "Objects") and hasattr(x, "dtype")


def unwrap(x: object) -> object:
    """Return the entry of a 0-dimensional array of numbers or ring elements, or x itself."""
    return x.item() if is_plain_array(x) and x.ndim == 0 else x


def reduced(x: Fraction) -> int | Fraction:
    """Return a Fraction as an int if it is an integer."""
    return x.numerator if x.denominator == 1 else x


def fmpq(x: int | Fraction) -> flint.fmpq:
    """Convert an int or a Fraction to a flint rational."""
    return flint.fmpq(x.numerator, x.denominator)
