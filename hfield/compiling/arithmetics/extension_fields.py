"""GF(pⁿ), p odd: base-p digits as residues in a floating word, polynomial products, one reduction.

A label is ``Σ dᵢ·pⁱ`` for the element ``Σ dᵢ·xⁱ``, as in galois. The digits are multiplied and added without
reduction as long as the word can hold them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, reduce

from hfield.compiling.arithmetic import Arithmetic, P, unsigned
from hfield.compiling.arithmetics.residues import LIMITS, Bounded, ResidueArithmetic
from hfield.compiling.instructions import Code, raw_type

Digits = tuple[Bounded, ...]


@dataclass(frozen=True)
class OddExtension(Arithmetic[P]):
    """GF(pⁿ) modulo the monic polynomial with these coefficients, low degree first; pⁿ ≤ 2³²."""

    characteristic: int
    coefficients: tuple[int, ...]

    @property
    def degree(self) -> int:
        """The degree n of the field."""
        return len(self.coefficients) - 1

    @property
    def order(self) -> int:
        """The number of elements."""
        return int(self.characteristic**self.degree)

    @property
    def dtype(self) -> str:
        """The smallest unsigned integer type that holds every label."""
        return unsigned(self.order - 1)


@dataclass(frozen=True)
class PolynomialArithmetic(OddExtension[Digits]):
    """The field by products of polynomials whose digits are residues."""

    @cached_property
    def digits(self) -> ResidueArithmetic:
        """The arithmetic of the digits, in the smaller type if labels and sums of four products fit
        into it.
        """
        largest = max(self.order, 8 * self.degree * self.characteristic**2)
        return ResidueArithmetic(
            self.characteristic, "float" if largest < LIMITS["float"] else "double"
        )

    def load(self, code: Code, raw: str) -> Digits:
        """Read a label."""
        low, word = self.digits, self.digits.word
        rest = Bounded(
            code.value(f"uitofp {raw_type(self.dtype)} {raw} to {word}"), 0, self.order - 1
        )
        found = []
        for n in range(self.degree - 1):
            quotient, digit = low.divided(code, rest)
            found.append(Bounded(digit, 0, self.characteristic - 1))
            rest = Bounded(quotient, 0, self.characteristic ** (self.degree - n - 1) - 1)
        return (*found, rest)

    def store(self, code: Code, x: Digits) -> str:
        """Reduce and write the label."""
        word = self.digits.word
        digits = [d.name for d in self._reduced(code, x)]
        p = self.digits.number(self.characteristic)
        label = digits.pop()
        while digits:
            label = code.value(f"fmul contract {word} {label}, {p}")
            label = code.value(f"fadd contract {word} {label}, {digits.pop()}")
        return code.value(f"fptoui {word} {label} to {raw_type(self.dtype)}")

    def constant(self, code: Code, value: int) -> Digits:
        """Return the element with a label."""
        found = []
        for _ in range(self.degree):
            value, digit = divmod(value, self.characteristic)
            found.append(self.digits.constant(code, digit))
        return tuple(found)

    def add(self, code: Code, x: Digits, y: Digits) -> Digits:
        """Return x + y."""
        return self._together(code, x, y, self.digits.add)

    def subtract(self, code: Code, x: Digits, y: Digits) -> Digits:
        """Return x − y."""
        return self._together(code, x, y, self.digits.subtract)

    def negate(self, code: Code, x: Digits) -> Digits:
        """Return −x."""
        return tuple(self.digits.negate(code, d) for d in x)

    def multiply(self, code: Code, x: Digits, y: Digits) -> Digits:
        """Return x·y, a polynomial of twice the degree."""
        low = self.digits
        x, y = self._reduced(code, x), self._reduced(code, y)
        found = []
        for n in range(len(x) + len(y) - 1):
            terms = [
                low.multiply(code, x[m], y[n - m]) for m in range(len(x)) if 0 <= n - m < len(y)
            ]
            found.append(reduce(lambda s, term: low.add(code, s, term), terms))
        return tuple(found)

    def _together(
        self,
        code: Code,
        x: Digits,
        y: Digits,
        operation: Callable[[Code, Bounded, Bounded], Bounded],
    ) -> Digits:
        zero = self.digits.constant(code, 0)
        length = max(len(x), len(y))
        x, y = (z + (zero,) * (length - len(z)) for z in (x, y))
        return tuple(operation(code, a, b) for a, b in zip(x, y, strict=True))

    def _reduced(self, code: Code, x: Digits) -> Digits:
        """Substitute powers of degree ≥ n modulo the polynomial, then reduce the digits."""
        low, n = self.digits, self.degree
        digits = list(x[:n])
        for high, power in zip(x[n:], self._powers, strict=False):
            high = low.reduced(code, high)
            for m, c in enumerate(power):
                if c:
                    term = low.multiply(code, high, low.constant(code, c))
                    digits[m] = low.add(code, digits[m], term)
        return tuple(low.reduced(code, d) for d in digits)

    @cached_property
    def _powers(self) -> list[list[int]]:
        """The digits of xⁿ, xⁿ⁺¹, …, x²ⁿ⁻²."""
        p, n = self.characteristic, self.degree
        found = [[-c % p for c in self.coefficients[:n]]]
        while len(found) < n - 1:
            *lower, top = found[-1]
            shifted = [0, *lower]
            found.append([(s + top * c) % p for s, c in zip(shifted, found[0], strict=True)])
        return found
