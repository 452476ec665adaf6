"""What the checker asks of a ring: a dozen operations on plain, hashable values."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from hfield.certificates.language import Tree, parse
from hfield.certificates.rejection import reject, shown

MAX_EXPONENT = 10_000


class Ring(ABC):
    """A commutative ring. ``order`` is None if it is infinite."""

    name: str
    characteristic: int
    order: int | None = None
    is_field: bool = False
    is_integral: bool = False  # known to have no zero divisors, though it may be no field
    zero: Any
    one: Any

    @abstractmethod
    def number(self, n: int) -> Any:
        """Return n·1."""

    @abstractmethod
    def add(self, x: Any, y: Any) -> Any:
        """Return x + y."""

    @abstractmethod
    def neg(self, x: Any) -> Any:
        """Return −x."""

    @abstractmethod
    def mul(self, x: Any, y: Any) -> Any:
        """Return x·y."""

    @abstractmethod
    def inverse(self, x: Any) -> Any:
        """Return 1/x, None for what is no unit."""

    @property
    def is_domain(self) -> bool:
        """Whether a product is 0 only where a factor is."""
        return self.is_field or self.is_integral

    def is_zero(self, x: Any) -> bool:
        """Tell whether x is 0."""
        return bool(x == self.zero)

    def constant(self, tree: Tree) -> Any:
        """Return the element that a name or a call names, None if it names none."""
        return None

    def elements(self) -> Iterator[Any]:
        """Run through all elements of a finite ring."""
        reject(f"{self.name} has infinitely many elements")

    def sign(self, x: Any) -> int | None:
        """Return the sign of x in an ordering of the field; None where there is none."""
        return None

    def signs(self, x: Any) -> tuple[int | None, ...]:
        """Return the signs of x in several orderings of the field."""
        return (self.sign(x),)

    def equal(self, x: Any, y: Any) -> bool:
        """Tell whether x = y."""
        return self.is_zero(self.add(x, self.neg(y)))

    def power(self, x: Any, n: int) -> Any:
        """Return xⁿ for n ≥ 0."""
        result = self.one
        while n:
            if n & 1:
                result = self.mul(result, x)
            n >>= 1
            if n:
                x = self.mul(x, x)
        return result

    def fraction(self, value: int | Fraction) -> Any:
        """Return the value of a literal, None where its denominator is no unit."""
        if isinstance(value, int):
            return self.number(value)
        below = self.inverse(self.number(value.denominator))
        return None if below is None else self.mul(self.number(value.numerator), below)

    def read(self, text: str) -> Any:
        """Read an element from its text."""
        return self.value(parse(text), text)

    def value(self, tree: Tree, text: str) -> Any:
        """Evaluate a term that names an element."""
        kind, result = tree[0], None
        if kind == "num":
            result = self.fraction(tree[1])
        elif kind == "neg":
            result = self.neg(self.value(tree[1], text))
        elif kind in ("+", "-", "*", "/"):
            x, y = (self.value(t, text) for t in tree[1:])
            if kind == "/":
                y = self.inverse(y)
            if y is not None:
                y = self.neg(y) if kind == "-" else y
                result = self.add(x, y) if kind in "+-" else self.mul(x, y)
        elif kind == "pow":
            x = self.value(tree[1], text)
            if abs(tree[2]) > MAX_EXPONENT:
                reject(f"the exponent in {shown(text)!r} is too large")
            x = self.inverse(x) if tree[2] < 0 else x
            result = None if x is None else self.power(x, abs(tree[2]))
        elif kind in ("name", "call"):
            result = self.constant(tree)
        if result is None:
            reject(f"{shown(text)!r} is no element of {self.name}")
        return result
