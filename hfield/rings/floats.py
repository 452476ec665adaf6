"""Floats as a ring: RDF, the real numbers as far as float64 goes. It computes, but proves nothing."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from random import Random
from typing import TYPE_CHECKING, Any

from hfield.errors import CoercionError, NotInvertibleError, RingError, shorten
from hfield.rings.base import Known
from hfield.rings.expressions import is_of_sympy
from hfield.rings.printing import number_text
from hfield.rings.rational import rational, unwrap
from hfield.rings.values import ValueRing

if TYPE_CHECKING:
    import numpy as np
    import sympy


_FUNCTIONS: dict[str, Callable[..., float]] = {
    "sqrt": math.sqrt, "cbrt": math.cbrt, "cos": math.cos, "sin": math.sin, "tan": math.tan,
    "exp": math.exp, "log": math.log,
}  # fmt: skip


class Floats(ValueRing):
    """float64, without NaN and infinity; elements are Python floats, arrays numpy's.

    >>> RDF("1/3")
    0.3333333333333333
    """

    name = "RDF"
    characteristic = 0
    is_exact = False
    is_field = True
    parse_limit = 100_000

    def __reduce__(self) -> str:
        return self.name

    @property
    def data(self) -> dict[str, Any]:
        """The ring by its kind."""
        return {"kind": "floats"}

    def in_words(self) -> str:
        """Say what the ring is."""
        return "floating-point numbers, which are inexact"

    def __call__(self, x: Any) -> float:
        """Turn a real number into the nearest float, read a text.

        Raises :class:`CoercionError`; NaN and infinity are refused.
        """
        x = unwrap(x)
        if isinstance(x, str):
            if x.strip().lower().lstrip("+-−") in ("nan", "inf", "infinity"):
                return self._finite(float(x.replace("−", "-")))
            return self._finite(self.parse(x))
        number = rational(x)
        if number is not None:
            try:
                return self._finite(float(number))
            except OverflowError:
                raise self._not_finite(shorten(number_text(number))) from None
        if isinstance(x, float) or type(x).__name__ in (
            "float16",
            "float32",
            "float128",
            "longdouble",
        ):
            return self._finite(float(x))
        if is_of_sympy(x):
            value: float = self.foreign(x)
            return value
        raise self.refuse(x, "expected a real number or its text")

    def closed_form(self, x: sympy.Expr) -> float:
        """Return the nearest float to a real number of sympy."""
        value = x.evalf(20)
        if not value.is_Float and not value.is_Rational:
            raise self.refuse(x, "expected a real number")
        return self._finite(float(value))

    def generators(self) -> dict[str, float]:
        """Return nothing: π is a number."""
        return {}

    def to_sympy(self, x: float, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the same float."""
        import sympy

        return sympy.Float(float(x))

    def _finite(self, x: float) -> float:
        if not math.isfinite(x):
            raise self._not_finite(str(x))
        return x

    def _not_finite(self, shown: str) -> CoercionError:
        return CoercionError(f"{shown} is not an element of RDF: expected a finite float64")

    def inverse(self, x: float) -> float:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0 and where the result is not finite."""
        if x == 0:
            raise NotInvertibleError("cannot divide by 0 in RDF")
        if not math.isfinite(1.0 / x):
            raise NotInvertibleError(f"1/{x} is too large for RDF")
        return 1.0 / x

    def divide(self, x: float, y: float) -> float:
        """Return x/y, rounded once. Raises :class:`NotInvertibleError` for y = 0."""
        if y == 0:
            raise NotInvertibleError("cannot divide by 0 in RDF")
        return x / y

    def power(self, x: float, n: int) -> float:
        """Return xⁿ. Raises :class:`NotInvertibleError` for 0 to a negative power."""
        try:
            return float(x**n)
        except ZeroDivisionError:
            raise NotInvertibleError("cannot divide by 0 in RDF") from None
        except OverflowError:
            raise CoercionError(f"{x}**{n} is too large for RDF") from None

    def sqrt(self, x: float) -> float | None:
        """Return the root, rounded, or None for x < 0."""
        return math.sqrt(x) if x >= 0 else None

    @property
    def level(self) -> Known:
        """Not known: float arithmetic is no proof of anything."""
        return Known(None, "floats are rounded, so nothing about RDF is proved; RR is exact")

    def sign(self, x: float, ordering: int = 0) -> int:
        """Return the sign of the float. Raises :class:`RingError` for a second ordering."""
        if ordering:
            raise RingError(f"RDF has no ordering number {ordering}, only the usual one, 0")
        return int(x > 0) - int(x < 0)

    def names(self) -> dict[str, float]:
        """The constant pi."""
        return {"pi": math.pi}

    def functions(self) -> dict[str, Callable[..., float]]:
        """The usual functions, as in ``sqrt(2)/2`` and ``cos(pi/3)``."""
        return {name: _checked(name, f) for name, f in _FUNCTIONS.items()}

    def random(self, rng: Random) -> float:
        """Return a random float between −1 and 1; the same for the same seed."""
        return rng.uniform(-1.0, 1.0)

    def text(self, x: float, style: str = "plain") -> str:
        """Write the shortest text that reads back as the same float."""
        text = repr(float(x))
        mantissa, e, exponent = text.partition("e")
        if style == "latex" and e:
            return rf"{mantissa} \cdot 10^{{{int(exponent)}}}"
        return text.replace("-", "−") if style == "unicode" else text

    def array(self, values: object) -> np.ndarray:
        """Return a float64 array. Raises :class:`CoercionError` where an entry is not a finite real."""
        import numpy as np

        source = values if isinstance(values, np.ndarray) else np.asarray(values, dtype=object)
        if source.dtype == object:
            source = np.array([self(x) for x in source.ravel()], dtype=float).reshape(source.shape)
        if source.dtype.kind not in "iubf":
            raise CoercionError(f"an array of {source.dtype} is not an array of floats")
        out = np.asarray(source, dtype=np.float64)
        if not np.isfinite(out).all():
            where = tuple(int(n) for n in np.argwhere(~np.isfinite(out))[0])
            raise CoercionError(
                f"the array has {out[where]} at index {where}: expected finite float64 entries"
            )
        return out

    def array_units(self, values: object) -> Any:
        """Return a bool array: which entries are not 0."""
        return values != 0

    def array_inverse(self, values: np.ndarray) -> np.ndarray:
        """Invert an array of nonzero entries elementwise."""
        return 1.0 / values

    def scalar(self, x: Any) -> float:
        """Turn an entry of an array into a Python float."""
        return float(x)


def _checked(name: str, function: Callable[..., float]) -> Callable[..., float]:
    def call(x: float) -> float:
        try:
            return function(x)
        except (ValueError, OverflowError):
            raise CoercionError(f"{name}({x}) is not a finite real number") from None

    return call


RDF = Floats()
