"""The scalars of an evaluation: elements of a ring, or Python numbers for its prime field.

The evaluator needs only this interface, so arrays and polynomials can be used as well (``all_cases``,
``expansion``). A value that may be undefined comes with the condition that it is defined.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache
from operator import and_, mul, or_, xor
from typing import TYPE_CHECKING, Generic, TypeAlias, TypeVar

from hfield.core.product import Constants, Scalar, SupportsArithmetic, multiply, norm
from hfield.errors import NotInvertibleError, UndecidedError
from hfield.fields.base.coercion import fmpq
from hfield.fields.base.ring import Ring

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Rational

S = TypeVar("S", bound=SupportsArithmetic)  # a scalar
C = TypeVar("C")  # a condition: where a value is defined
T = TypeVar("T")  # a truth

Four: TypeAlias = tuple[S, S, S, S]
_ONE = fmpq(1)  # flint's fractions are several times as fast as Python's


class Scalars(ABC, Generic[S, C, T]):
    """Scalars with Python's ``+`` and ``-``, and truth values.

    ``always`` and ``never`` are the conditions that hold everywhere and nowhere.
    """

    zero: S
    one: S
    always: C
    never: C
    true: T
    false: T
    reflexive = False  # whether a term is itself, so that this need not be evaluated

    @abstractmethod
    def number(self, value: int | Fraction) -> tuple[S, C]:
        """Convert a literal to a scalar."""

    @abstractmethod
    def reciprocal(self, x: S) -> tuple[S, C]:
        """Return 1/x and the condition that it exists."""

    @abstractmethod
    def equal(self, differences: Iterable[S], defined: C) -> T:
        """Return the truth of "defined, and all differences are 0"."""

    @abstractmethod
    def unequal(self, differences: Iterable[S], defined: C) -> T:
        """Return the truth of "defined, and some difference is not 0"."""

    @abstractmethod
    def together(self, x: C, y: C) -> C:
        """Return the conjunction of two conditions."""

    @abstractmethod
    def both(self, x: T, y: T) -> T:
        """Return the truth of "x and y"."""

    @abstractmethod
    def either(self, x: T, y: T) -> T:
        """Return the truth of "x or y"."""

    @abstractmethod
    def negate(self, x: T) -> T:
        """Return the truth of "not x"."""

    # --- what may be overridden ------------------------------------------------------------------

    def times(self, x: S, y: S) -> S:
        """Return the product of two scalars."""
        return x * y

    def scale(self, q: Four[S], s: S) -> Four[S]:
        """Return a quaternion times a scalar."""
        a, b, c, d = q
        return a * s, b * s, c * s, d * s

    def multiply(self, constants: Constants[S], p: Four[S], q: Four[S]) -> Four[S]:
        """Return the product of two quaternions."""
        return multiply(constants, p, q)

    def norm(self, constants: Constants[S], q: Four[S]) -> S:
        """Return the norm of a quaternion."""
        return norm(constants, q)


class Decided(Scalars[S, bool | T, bool | T]):
    """Scalars with a decidable test for 0; truth values are Python's, or numpy arrays."""

    always = true = True
    never = false = False
    together = both = staticmethod(and_)  # type: ignore[assignment]
    either = staticmethod(or_)  # type: ignore[assignment]

    def negate(self, x: bool | T) -> bool | T:
        """Return the truth of "not x"."""
        return xor(x, True)  # type: ignore[no-any-return]

    @abstractmethod
    def integer(self, n: int) -> S:
        """Return an integer as a scalar."""

    def number(self, value: int | Fraction) -> tuple[S, bool | T]:
        """Return a literal; it is undefined if its denominator is not invertible."""
        if isinstance(value, int):
            return self.integer(value), self.always
        x, defined = self.reciprocal(self.integer(value.denominator))
        return self.times(self.integer(value.numerator), x), defined


def some_nonzero(ring: Ring, elements: Iterable[Scalar]) -> bool:
    """Return whether some element is not 0. Raises UndecidedError if that is not known."""
    doubt: UndecidedError | None = None
    for x in elements:
        try:
            if not ring.is_zero(x):
                return True
        except UndecidedError as error:  # another element may decide
            doubt = doubt or error
    if doubt is not None:
        raise doubt
    return False


class OrderedScalars(Decided[S, bool]):
    """Scalars that may have signs and square roots."""

    @abstractmethod
    def constant(self, text: str) -> S:
        """Return the scalar that a text names."""

    @abstractmethod
    def sign(self, x: S) -> int:
        """Return the sign of a scalar."""

    @abstractmethod
    def root(self, x: S) -> S:
        """Return the square root of a nonnegative scalar. Raises HFieldError if it is not known."""


class RingScalars(OrderedScalars[Scalar]):
    """Scalars in a ring; a statement evaluates to true or false."""

    times = staticmethod(mul)  # type: ignore[assignment]
    multiply = staticmethod(multiply)  # type: ignore[assignment]
    norm = staticmethod(norm)  # type: ignore[assignment]

    def __init__(self, ring: Ring) -> None:
        self.ring = ring
        self.zero, self.one = ring.zero, ring.one

    def integer(self, n: int) -> Scalar:
        """Return n·1."""
        x: Scalar = self.ring(n)
        return x

    def constant(self, text: str) -> Scalar:
        """Return the element that a text names."""
        return constant(self.ring, text)

    def sign(self, x: Scalar) -> int:
        """Return the sign of an element of an ordered ring."""
        return self.ring.sign(x)

    def root(self, x: Scalar) -> Scalar:
        """Return the square root that is not negative."""
        found: Scalar | None = self.ring.sqrt(x)
        if found is None:
            raise UndecidedError(f"a square root in {self.ring.name} is not known")
        return found if self.sign(found) >= 0 else -found

    def reciprocal(self, x: Scalar) -> tuple[Scalar, bool]:
        """Return 1/x, if x is a unit."""
        try:
            return self.ring.inverse(x), True
        except NotInvertibleError:
            return self.zero, False

    def equal(self, differences: Iterable[Scalar], defined: bool) -> bool:
        """Compare exactly, in the ring."""
        return not self.unequal(differences, defined)

    def unequal(self, differences: Iterable[Scalar], defined: bool) -> bool:
        """Compare exactly, in the ring. Raises UndecidedError if that is not known."""
        return some_nonzero(self.ring, differences)


class PrimeScalars(Decided["Rational", bool]):
    """The prime field of a characteristic in Python's numbers, for fast searches."""

    zero, one = 0, 1

    def __init__(self, p: int) -> None:
        self.p = p
        if not p:
            self.times = mul  # type: ignore[method-assign, assignment]
            self.multiply = multiply  # type: ignore[method-assign, assignment]

    def integer(self, n: int) -> Rational:
        """Return the integer unchanged."""
        return n

    def reciprocal(self, x: Rational) -> tuple[Rational, bool]:
        """Return 1/x unless x is 0."""
        if not self.p:
            return (_ONE / x, True) if x else (0, False)
        n = int(x) % self.p
        return (pow(n, -1, self.p), True) if n else (0, False)

    def times(self, x: Rational, y: Rational) -> Rational:
        """Return the product reduced modulo p."""
        return x * y % self.p

    def multiply(
        self, constants: Constants, p: Four[Rational], q: Four[Rational]
    ) -> Four[Rational]:
        """Return the product with coordinates reduced modulo p."""
        modulus = self.p
        return tuple([x % modulus for x in multiply(constants, p, q)])

    def equal(self, differences: Iterable[Rational], defined: bool) -> bool:
        """Compare modulo p."""
        return not self.unequal(differences, defined)

    def unequal(self, differences: Iterable[Rational], defined: bool) -> bool:
        """Compare modulo p."""
        p = self.p
        if not p:
            return any(differences)
        return any([d % p for d in differences])  # noqa: C419 (four at most: no generator)


@lru_cache(maxsize=1024)
def constant(field: Ring, text: str) -> Scalar:
    """Return the element of the field given by a text."""
    x: Scalar = field(text)
    return x
