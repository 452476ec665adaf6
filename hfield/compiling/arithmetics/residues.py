"""Residues modulo n ≤ 2³²: products and sums stay unreduced while they fit into a word, then are reduced
once.

The value that represents a residue has known bounds. If a sum or a product could overflow the word, the
operand with the wider bounds is reduced first; so the product of Hamilton's quaternions needs one reduction
per coordinate. The words are ``float`` (24 bits), ``double`` (53 bits) and ``i64``. A reduction multiplies by
a rounded 1/n. For floating words ``⌊(x + ½)/n⌋`` is then exact: x + ½ is at least 1/2 away from every
multiple of n, and while |x| stays below the limits here three roundings change ``(x + ½)/n`` by less than
1/(2n).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from hfield.compiling.arithmetic import Arithmetic, unsigned
from hfield.compiling.instructions import Code, floating, raw_type

LIMITS = {"float": 2**20, "double": 2**49, "i64": 2**63}
_OPERATIONS = {
    "float": ("fadd contract", "fsub contract", "fmul contract"),
    "double": ("fadd contract", "fsub contract", "fmul contract"),
    "i64": ("add", "sub", "mul"),
}


class Bounded(NamedTuple):
    """A value of the loop, with the least and greatest integer that it may be."""

    name: str
    low: int
    high: int

    @property
    def size(self) -> int:
        """The greatest absolute value."""
        return max(-self.low, self.high)


@dataclass(frozen=True)
class ResidueArithmetic(Arithmetic[Bounded]):
    """The ring ℤ/n; residues are read and written as 0 … n − 1."""

    modulus: int
    word: str

    @classmethod
    def modulo(cls, n: int) -> ResidueArithmetic:
        """Return the arithmetic modulo n, in the fastest word type."""
        return cls(n, "float" if n <= 1 << 8 else "double" if n <= 1 << 23 else "i64")

    @property
    def dtype(self) -> str:
        """The smallest unsigned integer type that holds n − 1."""
        return unsigned(self.modulus - 1)

    # --- in and out ----------------------------------------------------------------------------

    def load(self, code: Code, raw: str) -> Bounded:
        """Load a residue; for a large modulus, as the representative nearest to 0, so that products fit."""
        kind, n = raw_type(self.dtype), self.modulus
        if self.word != "i64":
            return Bounded(code.value(f"uitofp {kind} {raw} to {self.word}"), 0, n - 1)
        x = code.value(f"zext {kind} {raw} to i64")
        upper = code.value(f"icmp ugt i64 {x}, {n // 2}")
        shift = code.value(f"select i1 {upper}, i64 {n}, i64 0")
        return Bounded(code.value(f"sub i64 {x}, {shift}"), n // 2 - n + 1, n // 2)

    def store(self, code: Code, x: Bounded) -> str:
        """Reduce and write."""
        name = self.reduced(code, x).name
        how = "trunc" if self.word == "i64" else "fptoui"
        return code.value(f"{how} {self.word} {name} to {raw_type(self.dtype)}")

    def constant(self, code: Code, value: int) -> Bounded:
        """Return a residue known at compile time."""
        n = self.modulus
        value = (value + n // 2) % n - n // 2
        return Bounded(self.number(value), value, value)

    def number(self, value: float) -> str:
        """Write a number of this word type."""
        return str(value) if self.word == "i64" else floating(value, self.word)

    # --- + − × ---------------------------------------------------------------------------------

    def add(self, code: Code, x: Bounded, y: Bounded) -> Bounded:
        """Return x + y."""
        x, y = self._fitting(code, x, y, lambda x, y: x.size + y.size)
        return self._result(code, 0, x, y, x.low + y.low, x.high + y.high)

    def subtract(self, code: Code, x: Bounded, y: Bounded) -> Bounded:
        """Return x − y."""
        x, y = self._fitting(code, x, y, lambda x, y: x.size + y.size)
        return self._result(code, 1, x, y, x.low - y.high, x.high - y.low)

    def multiply(self, code: Code, x: Bounded, y: Bounded) -> Bounded:
        """Return x·y."""
        x, y = self._fitting(code, x, y, lambda x, y: x.size * y.size)
        corners = [u * v for u in (x.low, x.high) for v in (y.low, y.high)]
        return self._result(code, 2, x, y, min(corners), max(corners))

    def negate(self, code: Code, x: Bounded) -> Bounded:
        """Return −x."""
        return self.subtract(code, Bounded(self.number(0), 0, 0), x)

    def _result(
        self, code: Code, which: int, x: Bounded, y: Bounded, low: int, high: int
    ) -> Bounded:
        line = f"{_OPERATIONS[self.word][which]} {self.word} {x.name}, {y.name}"
        return Bounded(code.value(line), low, high)

    def _fitting(
        self, code: Code, x: Bounded, y: Bounded, size: Callable[[Bounded, Bounded], int]
    ) -> tuple[Bounded, Bounded]:
        """Reduce the operands, the wider one first, until the result fits the word."""
        while size(x, y) >= LIMITS[self.word]:
            same = x is y
            if x.size >= y.size:
                x = self.reduced(code, x, centred=self.word == "i64")
                y = x if same else y
            else:
                y = self.reduced(code, y, centred=self.word == "i64")
        return x, y

    # --- reducing ------------------------------------------------------------------------------

    def reduced(self, code: Code, x: Bounded, centred: bool = False) -> Bounded:
        """Return the residue between 0 and n − 1, or if ``centred`` one of absolute value at most n/2."""
        most = self.modulus // 2 + self.modulus // 512 + 1
        low, high = (-most, most) if centred else (0, self.modulus - 1)
        if low <= x.low and x.high <= high:
            return x
        if self.word == "i64":
            return self._reduced_integer(code, x, centred)
        rest = self.divided(code, x)[1]
        return Bounded(rest, 0, self.modulus - 1)

    def divided(self, code: Code, x: Bounded) -> tuple[str, str]:
        """Return quotient and remainder of a floating word divided by n."""
        v, word, n = code.value, self.word, self.modulus
        near = v(f"fmul contract {word} {x.name}, {floating(1 / n, word)}")
        near = v(f"fadd contract {word} {near}, {floating(0.5 / n, word)}")
        quotient = _floor(code, word, near)
        whole = v(f"fmul contract {word} {quotient}, {floating(n, word)}")
        return quotient, v(f"fsub contract {word} {x.name}, {whole}")

    def _reduced_integer(self, code: Code, x: Bounded, centred: bool) -> Bounded:
        """Subtract n times the quotient from floating division, which is off by at most 1."""
        v, n = code.value, self.modulus
        near = v(f"sitofp i64 {x.name} to double")
        near = v(f"fmul double {near}, {floating(1 / n, 'double')}")
        if centred:
            near = v(f"fadd double {near}, {floating(0.5, 'double')}")
        quotient = v(f"fptosi double {_floor(code, 'double', near)} to i64")
        whole = v(f"mul i64 {quotient}, {n}")
        rest = v(f"sub i64 {x.name}, {whole}")
        if centred:
            most = (
                n // 2 + n // 512 + 1
            )  # if the quotient is near a half, it may be rounded either way
            return Bounded(rest, -most, most)
        for below, limit, sign in (("slt", 0, "add"), ("sge", n, "sub")):
            off = v(f"icmp {below} i64 {rest}, {limit}")
            shift = v(f"select i1 {off}, i64 {n}, i64 0")
            rest = v(f"{sign} i64 {rest}, {shift}")
        return Bounded(rest, 0, n - 1)


def _floor(code: Code, word: str, x: str) -> str:
    return code.call(word, f"llvm.floor.{'f32' if word == 'float' else 'f64'}", (word, x))
