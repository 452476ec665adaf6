"""The rings RDF and CDF of real and complex float64 numbers. Computations in them prove nothing."""

from __future__ import annotations

import cmath
import math
from abc import abstractmethod
from collections.abc import Callable, Mapping
from random import Random
from typing import TYPE_CHECKING, ClassVar, SupportsComplex, SupportsFloat, TypeGuard, TypeVar

from hfield.core.product import Constants
from hfield.errors import CoercionError, NotInvertibleError, RingError, shorten
from hfield.fields.base.coercion import rational, unwrap
from hfield.fields.base.from_sympy import is_of_sympy
from hfield.fields.base.printing import Factor, number_text, sum_text
from hfield.fields.base.ring import Fact
from hfield.fields.base.storage.base import BatchStorage
from hfield.fields.base.value_ring import ValueRing

if TYPE_CHECKING:
    import numpy as np
    import sympy


_FUNCTIONS: dict[str, Callable[..., float]] = {
    "sqrt": math.sqrt, "cbrt": math.cbrt, "cos": math.cos, "sin": math.sin, "tan": math.tan,
    "exp": math.exp, "log": math.log,
}  # fmt: skip
REAL_TYPES = (
    "float16",
    "float32",
    "float128",
    "longdouble",
)  # of numpy, which need not be imported
N = TypeVar("N", float, complex)


class FloatingPoint(ValueRing[N]):
    """The common part of RDF and CDF: rounded finite numbers of ``dtype``, and numpy arrays."""

    characteristic = 0
    is_exact = False
    is_field = True
    parse_limit = 100_000
    dtype: ClassVar[str]
    kinds: ClassVar[str]  # of arrays of numpy that are read

    def __reduce__(self) -> str:
        return self.name

    @abstractmethod
    def __call__(self, x: object) -> N:
        """Convert a number to the nearest element; read a text. Raises :class:`CoercionError`."""

    @abstractmethod
    def is_finite(self, x: N) -> bool:
        """Return whether x is neither infinite nor NaN."""

    def generators(self) -> dict[str, N]:
        """Return nothing: all names stand for numbers."""
        return {}

    def finite(self, x: N) -> N:
        """Return x. Raises :class:`CoercionError` for NaN and infinity."""
        if not self.is_finite(x):
            raise self.not_finite(str(x))
        return x

    def not_finite(self, shown: str) -> CoercionError:
        """Return the error for a value that is not a finite number."""
        return CoercionError(f"{shown} is not an element of {self}: expected a finite {self.dtype}")

    def inverse(self, x: N) -> N:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0 and if the result is not finite."""
        inverse = self.divide(self.one, x)
        if not self.is_finite(inverse):
            raise NotInvertibleError(f"1/{self.text(x)} is too large for {self}")
        return inverse

    def divide(self, x: N, y: N) -> N:
        """Return x/y. Raises :class:`NotInvertibleError` for y = 0."""
        if y == 0:
            raise NotInvertibleError(f"cannot divide by 0 in {self}")
        quotient: N = x / y
        return quotient

    def power(self, x: N, n: int) -> N:
        """Return xⁿ. Raises :class:`NotInvertibleError` for 0 to a negative power."""
        try:
            return type(x)(x**n)
        except ZeroDivisionError:
            raise NotInvertibleError(f"cannot divide by 0 in {self}") from None
        except OverflowError:
            raise CoercionError(f"{self.text(x)}**{n} is too large for {self}") from None

    def array(self, values: object) -> np.ndarray:
        """Return an array of ``dtype``. Raises :class:`CoercionError` for entries that are not finite."""
        import numpy as np

        source = values if isinstance(values, np.ndarray) else np.asarray(values, dtype=object)
        if source.dtype == object:
            read = [self(x) for x in source.ravel()]
            source = np.array(read, dtype=self.dtype).reshape(source.shape)
        if source.dtype.kind not in self.kinds:
            raise CoercionError(
                f"an array of {source.dtype} is not an array of {self.dtype}, which {self} has"
            )
        out = np.asarray(source, dtype=self.dtype)
        if not np.isfinite(out).all():
            where = tuple(int(n) for n in np.argwhere(~np.isfinite(out))[0])
            raise CoercionError(
                f"the array has {out[where]} at index {where}: expected finite {self.dtype} entries"
            )
        return out

    def array_units(self, values: np.ndarray) -> np.ndarray:
        """Return a bool array that marks the nonzero entries."""
        units: np.ndarray = values != 0
        return units

    def array_inverse(self, values: np.ndarray) -> np.ndarray:
        """Invert an array of nonzero entries elementwise."""
        return 1.0 / values

    def array_storage(self, constants: Constants) -> BatchStorage:
        """Return the storage of an array of elements as one numpy array."""
        from hfield.fields.base.array_storage.floats import FloatArrays

        return FloatArrays(self, constants)


class Floats(FloatingPoint[float]):
    """float64 without NaN and infinity; elements are Python floats, arrays are numpy's.

    >>> RDF("1/3")
    0.3333333333333333
    """

    name = "RDF"
    dtype, kinds = "float64", "iubf"

    @property
    def data(self) -> dict[str, object]:
        """The kind of the ring, as JSON data."""
        return {"kind": "floats"}

    def in_words(self) -> str:
        """Return a description of the ring."""
        return "floating-point numbers, which are inexact"

    def is_finite(self, x: float) -> bool:
        """Return whether x is neither infinite nor NaN."""
        return math.isfinite(x)

    def __call__(self, x: object) -> float:
        """Convert a real number to the nearest float; read a text.

        Raises :class:`CoercionError`, also for NaN and infinity.
        """
        x = unwrap(x)
        if isinstance(x, str):
            if x.strip().lower().lstrip("+-−") in ("nan", "inf", "infinity"):
                return self.finite(float(x.replace("−", "-")))
            return self.finite(self.parse(x))
        number = rational(x)
        if number is not None:
            try:
                return self.finite(float(number))
            except OverflowError:
                raise self.not_finite(shorten(number_text(number))) from None
        if isinstance(x, float) or _is_real(x):
            return self.finite(float(x))
        if is_of_sympy(x):
            value: float = self.foreign(x)
            return value
        raise self.refuse(x, "expected a real number or its text")

    def closed_form(self, x: sympy.Expr) -> float:
        """Return the float nearest to a real sympy number."""
        value = x.evalf(20)
        if not value.is_Float and not value.is_Rational:
            raise self.refuse(x, "expected a real number")
        return self.finite(float(value))

    def to_sympy(self, x: float, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the same float."""
        import sympy

        return sympy.Float(float(x))

    def sqrt(self, x: float) -> float | None:
        """Return the root, rounded, or None for x < 0."""
        return math.sqrt(x) if x >= 0 else None

    @property
    def level(self) -> Fact:
        """Not known: float arithmetic proves nothing."""
        return Fact(None, "floats are rounded, so nothing about RDF is proved; RR is exact")

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
        return {name: _checked(name, f, "real") for name, f in _FUNCTIONS.items()}

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

    def scalar(self, x: SupportsFloat) -> float:
        """Convert an entry of an array to a Python float."""
        return float(x)


class ComplexFloats(FloatingPoint[complex]):
    """complex128 without NaN and infinity; elements are Python's complex numbers, arrays are numpy's.

    >>> CDF("1 + 2*I") / 2, CDF("sqrt(-2)")
    ((0.5+1j), 1.4142135623730951j)
    """

    name = "CDF"
    exact_ring = "CC"
    gen_name = "I"
    dtype, kinds = "complex128", "iubfc"

    @property
    def data(self) -> dict[str, object]:
        """The kind of the ring, as JSON data."""
        return {"kind": "complex floats"}

    def in_words(self) -> str:
        """Return a description of the ring."""
        return "complex floating-point numbers, which are inexact"

    @property
    def gen(self) -> complex:
        """The imaginary unit."""
        return 1j

    def is_finite(self, x: complex) -> bool:
        """Return whether x is neither infinite nor NaN."""
        return cmath.isfinite(x)

    def __call__(self, x: object) -> complex:
        """Convert a number to the nearest complex float; read a text.

        Raises :class:`CoercionError`, also for NaN and infinity.
        """
        x = unwrap(x)
        if isinstance(x, str):
            return self.finite(self.parse(x))
        if isinstance(x, complex) or _is_complex(x):
            return self.finite(complex(x))
        if is_of_sympy(x):
            value: complex = self.foreign(x)
            return value
        try:
            return complex(RDF(x))
        except CoercionError:
            raise self.refuse(x, "expected a number or its text") from None

    def closed_form(self, x: sympy.Expr) -> complex:
        """Return the complex float nearest to a sympy number."""
        value = x.evalf(20)
        if not value.is_number:
            raise self.refuse(x, "expected a number")
        return self.finite(complex(value))

    def to_sympy(self, x: complex, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the same number."""
        import sympy

        return sympy.Float(x.real) + sympy.I * sympy.Float(x.imag)

    def sqrt(self, x: complex) -> complex:
        """Return the principal root, rounded."""
        return cmath.sqrt(x + 0)  # −1 − 0i has the root −i, and −1 + 0i the principal one

    @property
    def level(self) -> Fact:
        """Not known: float arithmetic proves nothing."""
        return Fact(None, "floats are rounded, so nothing about CDF is proved; CC is exact")

    def names(self) -> dict[str, complex]:
        """The imaginary unit I and the constant pi."""
        return {"I": 1j, "pi": complex(math.pi)}

    def functions(self) -> dict[str, Callable[..., complex]]:
        """The usual functions with principal values, as in ``sqrt(-2)`` and ``exp(I*pi/3)``."""
        names = [name for name in _FUNCTIONS if name not in ("sqrt", "cbrt")]
        others = {name: _checked(name, getattr(cmath, name), "complex") for name in names}
        return {"sqrt": self.sqrt, **others}

    def random(self, rng: Random) -> complex:
        """Return a random number with parts between −1 and 1; the same for the same seed."""
        return complex(rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0))

    def text(self, x: complex, style: str = "plain") -> str:
        """Write x, such as ``0.5-2.0*I``, so that it reads back as the same number."""
        x = complex(x)
        real, imaginary = RDF.text(x.real, style), RDF.text(x.imag, style)
        if abs(x.imag) == 1:
            imaginary = imaginary.removesuffix(".0")  # I alone
        terms: list[tuple[str, list[Factor]]] = []
        if x.real:
            terms.append((real, []))
        if x.imag:
            terms.append((imaginary, [("I", 1)]))
        return sum_text(terms, style)

    def scalar(self, x: SupportsComplex) -> complex:
        """Convert an entry of an array to a Python number."""
        return complex(x)


def _is_real(x: object) -> TypeGuard[SupportsFloat]:
    return type(x).__name__ in REAL_TYPES


def _is_complex(x: object) -> TypeGuard[SupportsComplex]:
    return type(x).__name__ in ("complex64", "clongdouble")


def _checked(name: str, function: Callable[..., N], what: str) -> Callable[..., N]:
    def call(x: N) -> N:
        try:
            return function(x)
        except (ValueError, OverflowError):
            raise CoercionError(f"{name}({x}) is not a finite {what} number") from None

    return call


RDF = Floats()
CDF = ComplexFloats()
