"""Integers in 64 bits: quickly where the operands are small enough, else with every overflow noticed.

`SmallWholeNumbers` computes without a check and tells when an operand was too large for its bounds;
`CheckedWholeNumbers` asks after each operation, and tells when one overflowed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from hfield.kernels.arithmetic import Code
from hfield.kernels.residues import Bounded

if TYPE_CHECKING:
    import numpy as np


WORD = 2**63


class TooWideError(ArithmeticError):
    """Numbers that a word does not hold."""


@dataclass(frozen=True)
class SmallWholeNumbers:
    """Whole numbers from −2^bits to 2^bits − 1, with which nothing that is computed leaves the word."""

    bits: int

    dtype = "i8"
    declarations = ()
    vectorise = True
    literal = True

    def tables(self) -> tuple[np.ndarray, ...]:
        """Return nothing: no tables are needed."""
        return ()

    def load(self, code: Code, raw: str) -> Bounded:
        """Read a number, and tell if it is too large."""
        sign = code.value(f"ashr i64 {raw}, 63")
        size = code.value(f"xor i64 {raw}, {sign}")
        code.flags.append(code.value(f"lshr i64 {size}, {self.bits}"))
        return Bounded(raw, -(1 << self.bits), (1 << self.bits) - 1)

    def store(self, code: Code, x: Bounded) -> str:
        """Write a number."""
        return x.name

    def constant(self, code: Code, value: int) -> Bounded:
        """Return a number known beforehand."""
        return _within(Bounded(str(value), value, value))

    def add(self, code: Code, x: Bounded, y: Bounded) -> Bounded:
        """Return x + y."""
        return self._result(code, "add", x, y, (x.low + y.low, x.high + y.high))

    def subtract(self, code: Code, x: Bounded, y: Bounded) -> Bounded:
        """Return x − y."""
        return self._result(code, "sub", x, y, (x.low - y.high, x.high - y.low))

    def multiply(self, code: Code, x: Bounded, y: Bounded) -> Bounded:
        """Return x·y."""
        corners = [u * v for u in (x.low, x.high) for v in (y.low, y.high)]
        return self._result(code, "mul", x, y, (min(corners), max(corners)))

    def negate(self, code: Code, x: Bounded) -> Bounded:
        """Return −x."""
        return self.subtract(code, Bounded("0", 0, 0), x)

    def _result(
        self, code: Code, operation: str, x: Bounded, y: Bounded, bounds: tuple[int, int]
    ) -> Bounded:
        name = code.value(f"{operation} i64 {x.name}, {y.name}")
        return _within(Bounded(name, *bounds))


def _within(x: Bounded) -> Bounded:
    if not -WORD <= x.low <= x.high < WORD:
        raise TooWideError
    return x


@dataclass(frozen=True)
class CheckedWholeNumbers:
    """Whole numbers of 64 bits; every operation tells if it overflows."""

    dtype = "i8"
    vectorise = False
    literal = True

    @property
    def declarations(self) -> tuple[str, ...]:
        """The operations with overflow."""
        names = ("sadd", "ssub", "smul")
        return tuple(f"declare {{i64, i1}} @llvm.{n}.with.overflow.i64(i64, i64)" for n in names)

    def tables(self) -> tuple[np.ndarray, ...]:
        """Return nothing: no tables are needed."""
        return ()

    def load(self, code: Code, raw: str) -> str:
        """Read a number."""
        return raw

    def store(self, code: Code, x: str) -> str:
        """Write a number."""
        return x

    def constant(self, code: Code, value: int) -> str:
        """Return a number known beforehand."""
        if not -WORD <= value < WORD:
            raise TooWideError
        return str(value)

    def add(self, code: Code, x: str, y: str) -> str:
        """Return x + y."""
        return self._checked(code, "sadd", x, y)

    def subtract(self, code: Code, x: str, y: str) -> str:
        """Return x − y."""
        return self._checked(code, "ssub", x, y)

    def multiply(self, code: Code, x: str, y: str) -> str:
        """Return x·y."""
        return self._checked(code, "smul", x, y)

    def negate(self, code: Code, x: str) -> str:
        """Return −x."""
        return self._checked(code, "ssub", "0", x)

    def _checked(self, code: Code, operation: str, x: str, y: str) -> str:
        call = f"call {{i64, i1}} @llvm.{operation}.with.overflow.i64(i64 {x}, i64 {y})"
        both = code.value(call)
        over = code.value(f"extractvalue {{i64, i1}} {both}, 1")
        code.flags.append(code.value(f"zext i1 {over} to i64"))
        return code.value(f"extractvalue {{i64, i1}} {both}, 0")


def widest(fits: Callable[[SmallWholeNumbers], object]) -> SmallWholeNumbers | None:
    """Return the arithmetic with the widest operands with which ``fits`` raises no TooWideError."""
    for bits in range(63, -1, -1):
        try:
            fits(SmallWholeNumbers(bits))
        except TooWideError:
            continue
        return SmallWholeNumbers(bits)
    return None
