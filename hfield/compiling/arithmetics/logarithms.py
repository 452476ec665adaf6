"""GF(pⁿ), p odd and pⁿ ≤ 2¹⁶, by logarithms: for high degrees, where polynomial products take longer.

A product is the entry at the sum of two logarithms in a table of powers. The table holds base-p digits in bit
fields of a word, wide enough for sums of several digits, so sums of elements are sums of words. A table for a
few digits at a time converts a sum to a label.
"""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np

from hfield.compiling.arithmetics.extension_fields import OddExtension
from hfield.compiling.instructions import Code, raw_type

TERMS = 5  # multiples of p − 1 that fit into a field: four products, and one that makes the sum positive
INDEX_BITS = 12  # of the table that turns fields into labels; it stays in the nearest cache


class Logarithm(NamedTuple):
    """A logarithm: the name of a value, or a known number."""

    name: str


class Packed(NamedTuple):
    """The names of the words of a sum of packed digits, with bounds of the digits."""

    words: tuple[str, ...]
    low: int
    high: int


Number = Logarithm | Packed


@dataclass(frozen=True)
class ByLogarithms(OddExtension[Number]):
    """The field by logarithms of labels; ``generator`` is the label of a primitive element."""

    generator: int

    vectorise = False

    @property
    @abstractmethod
    def word(self) -> str:
        """LLVM's name of the integer type of packed digits."""

    @property
    @abstractmethod
    def capacity(self) -> int:
        """The number of values that a digit of a sum may have."""

    @abstractmethod
    def biased(self, code: Code, words: tuple[str, ...], bias: int) -> tuple[str, ...]:
        """Add a number to every digit."""

    @abstractmethod
    def logarithm(self, code: Code, label: str) -> Logarithm:
        """Return the logarithm of a label, by table."""

    @abstractmethod
    def power(self, code: Code, *logarithms: Logarithm) -> Packed:
        """Return the digits of the element with the sum of one or two logarithms, by table."""

    @abstractmethod
    def label(self, code: Code, words: tuple[str, ...]) -> str:
        """Return the label of a sum without negative digits, by table."""

    # --- in and out ----------------------------------------------------------------------------

    def load(self, code: Code, raw: str) -> Logarithm:
        """Read a label, as its logarithm."""
        return self.logarithm(code, raw)

    def store(self, code: Code, x: Number) -> str:
        """Write the label: the sum of table entries, one for each group of digits."""
        x = self._packed(code, x)
        bias = self._bias(x.low)
        return self.label(code, self.biased(code, x.words, bias) if bias else x.words)

    # --- + − × ---------------------------------------------------------------------------------

    def add(self, code: Code, x: Number, y: Number) -> Packed:
        """Return x + y."""
        x, y = self._fitting(code, x, y, 1)
        return Packed(self._together(code, "add", x, y), x.low + y.low, x.high + y.high)

    def subtract(self, code: Code, x: Number, y: Number) -> Packed:
        """Return x − y."""
        x, y = self._fitting(code, x, y, -1)
        return Packed(self._together(code, "sub", x, y), x.low - y.high, x.high - y.low)

    def multiply(self, code: Code, x: Number, y: Number) -> Packed:
        """Return x·y."""
        factors = (z if isinstance(z, Logarithm) else self._read(code, z) for z in (x, y))
        return self.power(code, *factors)

    def negate(self, code: Code, x: Number) -> Packed:
        """Return −x."""
        x = self._packed(code, x)
        zero = Packed(("zeroinitializer",) * len(x.words), 0, 0)  # of a number, or of a vector
        return self.subtract(code, zero, x)

    # --- forms ---------------------------------------------------------------------------------

    def _together(self, code: Code, operation: str, x: Packed, y: Packed) -> tuple[str, ...]:
        pairs = zip(x.words, y.words, strict=True)
        return tuple(code.value(f"{operation} {self.word} {a}, {b}") for a, b in pairs)

    def _packed(self, code: Code, x: Number) -> Packed:
        return self.power(code, x) if isinstance(x, Logarithm) else x

    def _read(self, code: Code, x: Packed) -> Logarithm:
        return self.logarithm(code, self.store(code, x))

    def _fitting(self, code: Code, x: Number, y: Number, sign: int) -> tuple[Packed, Packed]:
        """Return both operands packed, reduced if a digit of ``x ± y`` would not fit into its bit field."""
        a, b = self._packed(code, x), self._packed(code, y)
        low, high = (b.low, b.high) if sign > 0 else (-b.high, -b.low)
        if self._bias(a.low + low) + a.high + high >= self.capacity:
            a, b = (self.power(code, self._read(code, z)) for z in (a, b))
        return a, b

    def _bias(self, low: int) -> int:
        """Return the multiple of p that makes digits from ``low`` upwards positive."""
        return -(low // self.characteristic) * self.characteristic if low < 0 else 0


@dataclass(frozen=True)
class LogarithmicField(ByLogarithms):
    """The field by tables in memory, one element at a time."""

    @cached_property
    def width(self) -> int:
        """The number of bits of a bit field."""
        return (TERMS * (self.characteristic - 1)).bit_length()

    @property
    def capacity(self) -> int:
        """The number of values that a digit of a sum may have."""
        return 1 << self.width

    @cached_property
    def word(self) -> str:
        """The integers that hold packed digits."""
        return "i32" if self.width * self.degree <= 32 else "i64"

    @cached_property
    def group(self) -> int:
        """The number of digits converted to a part of the label in one lookup."""
        return max(1, INDEX_BITS // self.width)

    def tables(self) -> tuple[np.ndarray, ...]:
        """Return the tables of logarithms, packed powers, and labels of groups of bit fields."""
        return _tables(self)

    def constant(self, code: Code, value: int) -> Logarithm:
        """Return the element with a label."""
        return Logarithm(str(int(self.tables()[0][value])))

    def biased(self, code: Code, words: tuple[str, ...], bias: int) -> tuple[str, ...]:
        """Add a number to every digit."""
        every = sum(bias << n * self.width for n in range(self.degree))
        return (code.value(f"add {self.word} {words[0]}, {every}"),)

    def logarithm(self, code: Code, label: str) -> Logarithm:
        """Return the logarithm of a label, by table."""
        index = code.value(f"zext {raw_type(self.dtype)} {label} to i64")
        found = code.load("i32", code.at("i32", "%table0", index))
        return Logarithm(code.value(f"zext i32 {found} to i64"))

    def power(self, code: Code, *logarithms: Logarithm) -> Packed:
        """Return the digits, by table; log 0 is so large that every sum with it gives 0."""
        # two steps from the table's beginning: the processor takes the second while it loads
        at = "%table1"
        for logarithm in logarithms:
            at = code.at(self.word, at, logarithm.name)
        return Packed((code.load(self.word, at),), 0, self.characteristic - 1)

    def label(self, code: Code, words: tuple[str, ...]) -> str:
        """Return the label of a sum: the sum of table entries, one for each group of digits."""
        v, word, (name,) = code.value, self.word, words
        kind, bits = raw_type(self.dtype), self.width * self.group
        label = ""
        for start in range(0, self.degree, self.group):
            index = v(f"lshr {word} {name}, {start * self.width}") if start else name
            if start + self.group < self.degree:
                index = v(f"and {word} {index}, {(1 << bits) - 1}")
            index = index if word == "i64" else v(f"zext i32 {index} to i64")
            place = v(f"add i64 {index}, {start // self.group << bits}") if start else index
            part = code.load(kind, code.at(kind, "%table2", place))
            label = v(f"add {kind} {label}, {part}") if start else part
        return label


@lru_cache(maxsize=64)
def _tables(field: LogarithmicField) -> tuple[np.ndarray, ...]:
    p, n, q = field.characteristic, field.degree, field.order
    digits = powers(field)
    logarithms = np.full(q, 2 * (q - 1), np.uint32)
    logarithms[digits @ p ** np.arange(n)] = np.arange(q - 1)
    kind = np.uint32 if field.word == "i32" else np.uint64
    packed = (digits.astype(np.uint64) << (field.width * np.arange(n, dtype=np.uint64))).sum(axis=1)
    table = np.zeros(4 * (q - 1) + 1, kind)
    table[: q - 1] = table[q - 1 : 2 * (q - 1)] = packed.astype(kind)
    index = np.arange(1 << field.width * field.group)
    fields = (index[:, None] >> field.width * np.arange(field.group)) % (1 << field.width) % p
    # for each group of digits, its contribution to the label; digits beyond the last contribute
    # nothing
    parts = [fields @ p ** (start + np.arange(field.group)) for start in range(0, n, field.group)]
    return logarithms, table, np.concatenate(parts).astype(field.dtype)


def powers(field: ByLogarithms) -> np.ndarray:
    """Return the digits of 1, g, g², …, the units of the field, as rows of shape (q − 1, n).

    The second half is the first half times a power of g. Raises ValueError if g does not generate the units.
    """
    p, n = field.characteristic, field.degree
    shift = np.zeros((n, n), np.int64)  # rows times this: times x
    shift[np.arange(n - 1), np.arange(1, n)] = 1
    shift[n - 1] = [-c % p for c in field.coefficients[:n]]
    step, power, rest = np.zeros((n, n), np.int64), np.eye(n, dtype=np.int64), field.generator
    for _ in range(n):
        rest, digit = divmod(rest, p)
        step, power = (step + digit * power) % p, power @ shift % p
    found = np.eye(n, dtype=np.int64)[:1]
    while len(found) < field.order - 1:
        found = np.concatenate([found, found @ step % p])
        step = step @ step % p
    found = found[: field.order - 1]
    if len(set((found @ p ** np.arange(n)).tolist()) - {0}) != field.order - 1:
        raise ValueError(f"{field.generator} does not generate the units of the field")
    return found
