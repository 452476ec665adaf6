"""Integers of 8 to 64 bits: without checks for small operands, else with overflow checks.

`SmallWholeNumbers` computes without checks and reports an operand that was too large for its bounds; the
bounds of the results decide the width in which they are written. `CheckedWholeNumbers` checks after each
operation, and reports overflow.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from hfield.compiling.arithmetic import Arithmetic
from hfield.compiling.arithmetics.residues import Bounded
from hfield.compiling.instructions import Code, raw_type

WORD = 2**63


class TooWideError(ArithmeticError):
    """Numbers that do not fit into a word."""


def holds(dtype: str) -> int:
    """Return the largest number M in a row of this type; the least is −M, or −M − 1 for 64 bits."""
    return (1 << 8 * int(dtype[1]) - 1) - 1


@dataclass(frozen=True)
class SmallWholeNumbers(Arithmetic[Bounded]):
    """Integers of absolute value at most 2^bits, small enough that no result overflows 64 bits.

    They are read from rows of ``dtype``, and written to rows of ``result``, which holds every result.
    """

    bits: int
    dtype: str = "i8"
    result: str = "i8"

    literal = True
    waits_for_memory = True

    def load(self, code: Code, raw: str) -> Bounded:
        """Load a number, and flag it if it is too large."""
        most = (1 << self.bits) - 1
        if self.dtype != "i8":
            raw = code.value(f"sext {raw_type(self.dtype)} {raw} to i64")
            if most == holds(self.dtype):
                return Bounded(raw, -most, most)
        sign = code.value(f"ashr i64 {raw}, 63")
        size = code.value(f"xor i64 {raw}, {sign}")
        code.conditions.append(code.value(f"lshr i64 {size}, {self.bits}"))
        return Bounded(raw, -most - 1, most)

    def store(self, code: Code, x: Bounded) -> str:
        """Write a number."""
        if self.result == "i8":
            return x.name
        if x.size > holds(self.result):
            raise TooWideError
        return code.value(f"trunc i64 {x.name} to {raw_type(self.result)}")

    def constant(self, code: Code, value: int) -> Bounded:
        """Return a number known at compile time."""
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
class CheckedWholeNumbers(Arithmetic[str]):
    """Integers of 64 bits with overflow checks."""

    dtype = "i8"
    vectorise = False
    literal = True

    def load(self, code: Code, raw: str) -> str:
        """Read a number."""
        return raw

    def store(self, code: Code, x: str) -> str:
        """Write a number."""
        return x

    def constant(self, code: Code, value: int) -> str:
        """Return a number known at compile time."""
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
        name = f"llvm.{operation}.with.overflow.i64"
        both = code.call("{i64, i1}", name, ("i64", x), ("i64", y))
        over = code.value(f"extractvalue {{i64, i1}} {both}, 1")
        code.conditions.append(code.value(f"zext i1 {over} to i64"))
        return code.value(f"extractvalue {{i64, i1}} {both}, 0")


def widest(
    fits: Callable[[SmallWholeNumbers], object], dtype: str = "i8"
) -> SmallWholeNumbers | None:
    """Return the arithmetic with the widest operands that fit, and among these with the narrowest results.

    ``fits`` raises TooWideError for an arithmetic that does not fit.
    """

    def first(candidates: Iterable[SmallWholeNumbers]) -> SmallWholeNumbers | None:
        for arithmetic in candidates:
            with contextlib.suppress(TooWideError):
                fits(arithmetic)
                return arithmetic
        return None

    found = first(SmallWholeNumbers(n, dtype) for n in range(8 * int(dtype[1]) - 1, -1, -1))
    if found is None:
        return None
    return first(SmallWholeNumbers(found.bits, dtype, f"i{size}") for size in (1, 2, 4, 8))
