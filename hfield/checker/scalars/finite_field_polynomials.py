"""Polynomials over a finite field with the interface of integers.

They support the operators of Python's integers, so that the code for matrices, lattices and ideals works with
both. A Python integer is read as a constant. Every operation spends its cost from the budget.
"""

from collections.abc import Hashable, Sequence
from typing import final

from hfield.checker.budget import spend
from hfield.checker.scalars.finite import Finite


@final
class FiniteFieldPolynomial:
    """A polynomial over a finite field; ``coefficients`` are low degree first, with a nonzero last one."""

    __slots__ = ("base", "coefficients")

    def __init__(self, base: Finite[Hashable], coefficients: Sequence[Hashable]) -> None:
        end = len(coefficients)
        while end and coefficients[end - 1] == base.zero:
            end -= 1
        self.base, self.coefficients = base, tuple(coefficients[:end])

    @property
    def degree(self) -> int:
        """The degree, −1 for 0."""
        return len(self.coefficients) - 1

    @property
    def lead(self) -> Hashable:
        """The coefficient of the highest power."""
        return self.coefficients[-1]

    @property
    def to_normal(self) -> "FiniteFieldPolynomial":
        """The constant whose product with the polynomial is monic."""
        return FiniteFieldPolynomial(self.base, [self.base.need_inverse(self.lead)])

    def at(self, degree: int) -> Hashable:
        """Return the coefficient of a power."""
        return self.coefficients[degree] if degree <= self.degree else self.base.zero

    def bit_length(self) -> int:
        """Return the total number of bits of the coefficients."""
        return len(self.coefficients) * self.base.order.bit_length()

    def __bool__(self) -> bool:
        return bool(self.coefficients)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, FiniteFieldPolynomial) and self.coefficients == other.coefficients

    def __hash__(self) -> int:
        return hash(self.coefficients)

    def __abs__(self) -> int:
        """Return 1 + the degree, the size that division with remainder reduces."""
        return len(self.coefficients)

    def _spend(self, operations: int) -> None:
        """Spend the cost of operations on coefficients, which are lists in an extension field."""
        spend(2 + operations * (1 if self.base.order == self.base.characteristic else 4))

    def _same(self, x: "FiniteFieldPolynomial | int") -> "FiniteFieldPolynomial":
        return (
            x
            if isinstance(x, FiniteFieldPolynomial)
            else FiniteFieldPolynomial(self.base, [self.base.number(x)])
        )

    def __add__(self, other: "FiniteFieldPolynomial | int") -> "FiniteFieldPolynomial":
        base, x, y = self.base, self.coefficients, self._same(other).coefficients
        if len(x) < len(y):
            x, y = y, x
        self._spend(len(x))
        return FiniteFieldPolynomial(base, [*map(base.add, x, y), *x[len(y) :]])

    __radd__ = __add__

    def __neg__(self) -> "FiniteFieldPolynomial":
        self._spend(len(self.coefficients))
        return FiniteFieldPolynomial(self.base, [self.base.neg(c) for c in self.coefficients])

    def __sub__(self, other: "FiniteFieldPolynomial | int") -> "FiniteFieldPolynomial":
        return self + -self._same(other)

    def __mul__(self, other: "FiniteFieldPolynomial | int") -> "FiniteFieldPolynomial":
        base, x, y = self.base, self.coefficients, self._same(other).coefficients
        self._spend(len(x) * len(y))
        if not x or not y:
            return FiniteFieldPolynomial(base, ())
        out: list[Hashable] = [base.zero] * (len(x) + len(y) - 1)
        for m, c in enumerate(x):
            for n, d in enumerate(y, m):
                out[n] = base.add(out[n], base.mul(c, d))
        return FiniteFieldPolynomial(base, out)

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> "FiniteFieldPolynomial":
        found = self._same(1)
        for _ in range(exponent):
            found = found * self
        return found

    def __divmod__(
        self, other: "FiniteFieldPolynomial | int"
    ) -> tuple["FiniteFieldPolynomial", "FiniteFieldPolynomial"]:
        base, y = self.base, self._same(other).coefficients
        x: list[Hashable] = list(self.coefficients)
        shift = len(x) - len(y)
        if shift < 0:
            return FiniteFieldPolynomial(base, ()), self
        self._spend(3 + 2 * (shift + 1) * len(y))
        inverse, quotient = base.need_inverse(y[-1]), [base.zero] * (shift + 1)
        for n in range(shift, -1, -1):
            c = base.mul(x[n + len(y) - 1], inverse)
            if c != base.zero:
                quotient[n], c = c, base.neg(c)
                for m, d in enumerate(y, n):
                    x[m] = base.add(x[m], base.mul(c, d))
        return FiniteFieldPolynomial(base, quotient), FiniteFieldPolynomial(base, x[: len(y) - 1])

    def __floordiv__(self, other: "FiniteFieldPolynomial | int") -> "FiniteFieldPolynomial":
        return divmod(self, other)[0]

    def __rfloordiv__(self, other: int) -> "FiniteFieldPolynomial":
        return self._same(other) // self

    def __mod__(self, other: "FiniteFieldPolynomial") -> "FiniteFieldPolynomial":
        return divmod(self, other)[1]

    def gcd(self, *others: "FiniteFieldPolynomial | int") -> "FiniteFieldPolynomial":
        """Return the monic greatest common divisor."""
        found = self
        for other in map(self._same, others):
            x, y = other, found
            while y:
                x, y = y, x % y
            found = x
            if not found.degree:
                break
        return found * found.to_normal if found else found

    def ratio(self, other: "FiniteFieldPolynomial") -> "RationalFunction":
        """Return self/other."""
        return RationalFunction(self, other)


@final
class RationalFunction:
    """A quotient of polynomials in lowest terms, with a monic denominator."""

    def __init__(self, top: FiniteFieldPolynomial, below: FiniteFieldPolynomial) -> None:
        g = below.gcd(top)
        scale = below.to_normal
        self.numerator, self.denominator = top // g * scale, below // g * scale

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RationalFunction) and self._parts == other._parts

    def __hash__(self) -> int:
        return hash(self._parts)

    @property
    def _parts(self) -> tuple[FiniteFieldPolynomial, FiniteFieldPolynomial]:
        return self.numerator, self.denominator

    def __mul__(self, other: "RationalFunction") -> "RationalFunction":
        return RationalFunction(
            self.numerator * other.numerator, self.denominator * other.denominator
        )

    def __pow__(self, exponent: int) -> "RationalFunction":
        return RationalFunction(self.numerator**exponent, self.denominator**exponent)
