"""Rational numbers as users get them: flint's, with the operations of Python's ints and Fractions.

Norms, traces and coordinates over ℚ belong to this class. Sums and products stay exact, ``%`` and ``//`` work
as for Fractions, and an integral value is accepted wherever Python takes an int.
"""

from __future__ import annotations

import math
import numbers
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from typing import Any, overload

from flint import fmpq, fmpz


class _OfFractions(type):
    """Metaclass of a class that can also be called with Fractions, as ``statistics.mean`` does.

    An ``__init__`` would do this too, but would make every norm slower.
    """

    def __call__(cls, *numbers: object) -> RationalNumber:
        made: RationalNumber = super().__call__(*map(_of_python, numbers))
        return made


class RationalNumber(fmpq, metaclass=_OfFractions):  # type: ignore[misc]  # flint has no types
    """A rational number; equality, hash and order are as for ints and Fractions.

    >>> from math import gcd, isqrt
    >>> from hfield import H
    >>> n = H("QQ")(1, 2, 3, 1).norm()
    >>> n, n % 4, n // 4, divmod(n, 4), pow(n, -1, 7), gcd(n, 6), isqrt(n)
    (15, 3, 3, (3, 3), 1, 3, 3)
    """

    __slots__ = ()

    @property
    def numerator(self) -> int:
        """The numerator, an int."""
        return int(self.p)

    @property
    def denominator(self) -> int:
        """The denominator, a positive int."""
        return int(self.q)

    @property
    def real(self) -> RationalNumber:
        """The number itself, as for every real number of Python."""
        return self

    @property
    def imag(self) -> int:
        """0, as for every real number of Python."""
        return 0

    def conjugate(self) -> RationalNumber:
        """Return the integer unchanged."""
        return self

    def as_integer_ratio(self) -> tuple[int, int]:
        """Return the numerator and the denominator."""
        return int(self.p), int(self.q)

    def is_integer(self) -> bool:
        """Return whether the number is integral."""
        return bool(self.q == 1)

    def __index__(self) -> int:
        if self.q != 1:
            raise TypeError(f"{self} is not an integer")
        return int(self.p)

    def __format__(self, specification: str) -> str:
        if specification and self.q == 1:
            return format(int(self.p), specification)
        if specification[-1:] in tuple("eEfFgG%"):
            return format(float(self), specification)
        return format(str(self), specification)

    def __reduce__(self) -> tuple[object, ...]:
        return RationalNumber, (int(self.p), int(self.q))

    # --- integral parts --------------------------------------------------------------------------

    def __floor__(self) -> int:
        return int(self.p // self.q)

    def __ceil__(self) -> int:
        return int(-(-self.p // self.q))

    def __trunc__(self) -> int:
        return int(self)

    def __round__(self, digits: int | None = None) -> int | Fraction:
        return round(Fraction(*self.as_integer_ratio()), digits)

    def __floordiv__(self, other: object) -> int:
        number = _rational(other)
        return NotImplemented if number is None else _floor(self, number)

    def __rfloordiv__(self, other: object) -> int:
        number = _rational(other)
        return NotImplemented if number is None else _floor(number, self)

    def __mod__(self, other: object) -> RationalNumber:
        number = _rational(other)
        return NotImplemented if number is None else _divmod(self, number)[1]

    def __rmod__(self, other: object) -> RationalNumber:
        number = _rational(other)
        return NotImplemented if number is None else _divmod(number, self)[1]

    def __divmod__(self, other: object) -> tuple[int, RationalNumber]:
        number = _rational(other)
        return NotImplemented if number is None else _divmod(self, number)

    def __rdivmod__(self, other: object) -> tuple[int, RationalNumber]:
        number = _rational(other)
        return NotImplemented if number is None else _divmod(number, self)

    # --- powers ----------------------------------------------------------------------------------

    @overload
    def __pow__(self, exponent: int | fmpq) -> RationalNumber: ...
    @overload
    def __pow__(self, exponent: int | fmpq, modulus: int) -> int: ...
    def __pow__(self, exponent: int | fmpq, modulus: int | None = None) -> int | RationalNumber:
        if modulus is not None:
            return pow(self.__index__(), exponent, modulus)
        number = _rational(exponent)
        if number is None:
            return NotImplemented
        return rational_number(fmpq.__pow__(self, rational_number(number).__index__()))

    def __rpow__(self, base: Any) -> Any:
        return NotImplemented if _rational(base) is None else base ** self.__index__()

    # --- sums and products, comparison -----------------------------------------------------------

    def _operation(name: str) -> Callable[[RationalNumber, object], RationalNumber]:  # noqa: N805
        """Return an operation of flint's class that also accepts Fractions and returns this class."""
        of_flint: Callable[[RationalNumber, object], RationalNumber] = getattr(fmpq, name)

        def operation(self: RationalNumber, other: object) -> RationalNumber:
            found = of_flint(self, _of_python(other))
            return rational_number(found) if type(found) is fmpq else found

        operation.__name__ = name
        return operation

    __add__, __radd__ = _operation("__add__"), _operation("__radd__")
    __sub__, __rsub__ = _operation("__sub__"), _operation("__rsub__")
    __mul__, __rmul__ = _operation("__mul__"), _operation("__rmul__")
    __truediv__, __rtruediv__ = _operation("__truediv__"), _operation("__rtruediv__")

    def _comparison(name: str) -> Callable[[RationalNumber, object], bool]:  # noqa: N805
        """Return a comparison that accepts Fractions and, with the same exactness, floats."""
        of_flint: Callable[[RationalNumber, object], bool] = getattr(fmpq, name)
        of_fractions: Callable[[Fraction, float], bool] = getattr(Fraction, name)

        def comparison(self: RationalNumber, other: object) -> bool:
            if isinstance(other, float):
                return of_fractions(Fraction(int(self.p), int(self.q)), other)
            return of_flint(self, _of_python(other))

        comparison.__name__ = name
        return comparison

    def __ne__(self, other: object) -> bool:
        equal = self.__eq__(other)
        return equal if equal is NotImplemented else not equal

    __eq__ = _comparison("__eq__")
    __lt__, __le__ = _comparison("__lt__"), _comparison("__le__")
    __gt__, __ge__ = _comparison("__gt__"), _comparison("__ge__")
    __hash__ = fmpq.__hash__
    del _operation, _comparison

    def __neg__(self) -> RationalNumber:
        return rational_number(-self.p, self.q)

    def __pos__(self) -> RationalNumber:
        return self

    def __abs__(self) -> RationalNumber:
        return rational_number(abs(self.p), self.q)


numbers.Rational.register(RationalNumber)
rational_number: Callable[..., RationalNumber] = partial(type.__call__, RationalNumber)
"""Make a rational number of one or two ints or numbers of flint."""
NOT_FRACTIONS = frozenset({RationalNumber, fmpq, fmpz, int})
"""Types that are not Fractions; the test for a Fraction takes longer for other types."""


def _of_python(x: object) -> object:
    """Return a Fraction as a flint rational, and anything else unchanged."""
    if type(x) not in NOT_FRACTIONS and isinstance(x, Fraction):
        return fmpq(int(x.numerator), int(x.denominator))  # of numpy, perhaps
    return x


def _rational(x: object) -> fmpq | None:
    """Return an int, a Fraction or a flint number as a flint rational; None for anything else."""
    if isinstance(x, fmpq):
        return x
    if isinstance(x, int | fmpz):
        return fmpq(x)
    return fmpq(int(x.numerator), int(x.denominator)) if isinstance(x, Fraction) else None


def _floor(x: fmpq, y: fmpq) -> int:
    if not y:
        raise ZeroDivisionError(f"division of {x} by 0")
    return math.floor(rational_number(fmpq.__truediv__(x, y)))


def _divmod(x: fmpq, y: fmpq) -> tuple[int, RationalNumber]:
    quotient = _floor(x, y)
    return quotient, rational_number(x - quotient * y)
