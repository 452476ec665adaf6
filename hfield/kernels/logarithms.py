"""GF(pⁿ), p odd and pⁿ ≤ 2¹⁶, by logarithms: for high degrees, where products of polynomials take longer.

A product is the entry of a table of powers at the sum of two logarithms; the entry of log 0 lies so high that
every sum with it points to a zero. The table holds digits in base p in fields of a word, wide enough for
the sum of a few, so sums are sums of words. A table of a few digits at a time turns a sum into a label.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np

from hfield.kernels.arithmetic import Code, raw_type
from hfield.kernels.extension_fields import OddExtension

TERMS = 5  # so many times p − 1 fits in a field: four products, and what makes their sum positive
INDEX_BITS = 12  # of the table that turns fields into labels; it stays in the nearest cache


class Logarithm(NamedTuple):
    """The name of a number's logarithm, which is that of an i64, or the number if it is known."""

    name: str


class Packed(NamedTuple):
    """The name of a sum of packed digits, and the least and greatest value of a digit."""

    name: str
    low: int
    high: int


Number = Logarithm | Packed


@dataclass(frozen=True)
class LogarithmicField(OddExtension):
    """The field by logarithms of labels; ``generator`` is the label of a primitive element."""

    generator: int

    vectorise = False

    @cached_property
    def width(self) -> int:
        """The bits of a field."""
        return (TERMS * (self.characteristic - 1)).bit_length()

    @cached_property
    def word(self) -> str:
        """The integers that hold packed digits."""
        return "i32" if self.width * self.degree <= 32 else "i64"

    @cached_property
    def group(self) -> int:
        """How many digits are turned into a part of the label at a time."""
        return max(1, INDEX_BITS // self.width)

    def tables(self) -> tuple[np.ndarray, ...]:
        """Return logarithms, packed powers, and labels of a group of fields."""
        return _tables(self)

    # --- in and out ----------------------------------------------------------------------------

    def load(self, code: Code, raw: str) -> Logarithm:
        """Read a label, as its logarithm."""
        return self._logarithm(code, raw)

    def store(self, code: Code, x: Number) -> str:
        """Write the label."""
        return self._label(code, x)

    def constant(self, code: Code, value: int) -> Logarithm:
        """Return the element with a label."""
        return Logarithm(str(int(self.tables()[0][value])))

    # --- + − × ---------------------------------------------------------------------------------

    def add(self, code: Code, x: Number, y: Number) -> Packed:
        """Return x + y."""
        x, y = self._fitting(code, x, y, 1)
        name = code.value(f"add {self.word} {x.name}, {y.name}")
        return Packed(name, x.low + y.low, x.high + y.high)

    def subtract(self, code: Code, x: Number, y: Number) -> Packed:
        """Return x − y."""
        x, y = self._fitting(code, x, y, -1)
        name = code.value(f"sub {self.word} {x.name}, {y.name}")
        return Packed(name, x.low - y.high, x.high - y.low)

    def multiply(self, code: Code, x: Number, y: Number) -> Packed:
        """Return x·y."""
        a, b = (
            z if isinstance(z, Logarithm) else self._logarithm(code, self._label(code, z))
            for z in (x, y)
        )
        # two steps from the table's beginning: the processor takes the second while it loads
        first = code.value(f"getelementptr {self.word}, ptr %table1, i64 {a.name}")
        return self._power(code, b.name, first)

    def negate(self, code: Code, x: Number) -> Packed:
        """Return −x."""
        return self.subtract(code, Packed("0", 0, 0), x)

    # --- forms ---------------------------------------------------------------------------------

    def _logarithm(self, code: Code, label: str) -> Logarithm:
        index = code.value(f"zext {raw_type(self.dtype)} {label} to i64")
        at = code.value(f"getelementptr i32, ptr %table0, i64 {index}")
        found = code.value(f"load i32, ptr {at}")
        return Logarithm(code.value(f"zext i32 {found} to i64"))

    def _power(self, code: Code, logarithm: str, start: str = "%table1") -> Packed:
        at = code.value(f"getelementptr {self.word}, ptr {start}, i64 {logarithm}")
        return Packed(code.value(f"load {self.word}, ptr {at}"), 0, self.characteristic - 1)

    def _packed(self, code: Code, x: Number) -> Packed:
        return self._power(code, x.name) if isinstance(x, Logarithm) else x

    def _fitting(self, code: Code, x: Number, y: Number, sign: int) -> tuple[Packed, Packed]:
        """Return both packed, and reduced where a digit of ``x ± y`` would not fit its field."""
        a, b = self._packed(code, x), self._packed(code, y)
        low, high = (b.low, b.high) if sign > 0 else (-b.high, -b.low)
        if self._bias(a.low + low) + a.high + high >= 1 << self.width:
            a, b = (
                self._power(code, self._logarithm(code, self._label(code, z)).name) for z in (a, b)
            )
        return a, b

    def _bias(self, low: int) -> int:
        """Return the multiple of p that makes digits from ``low`` on positive."""
        return -(low // self.characteristic) * self.characteristic if low < 0 else 0

    def _label(self, code: Code, x: Number) -> str:
        """Return the label: the sum of what a table says of each group of digits."""
        v, word = code.value, self.word
        x = self._packed(code, x)
        name, bias = x.name, self._bias(x.low)
        if bias:
            every = sum(bias << n * self.width for n in range(self.degree))
            name = v(f"add {word} {name}, {every}")
        kind, bits = raw_type(self.dtype), self.width * self.group
        label = ""
        for start in range(0, self.degree, self.group):
            index = v(f"lshr {word} {name}, {start * self.width}") if start else name
            if start + self.group < self.degree:
                index = v(f"and {word} {index}, {(1 << bits) - 1}")
            index = index if word == "i64" else v(f"zext i32 {index} to i64")
            place = v(f"add i64 {index}, {start // self.group << bits}") if start else index
            at = v(f"getelementptr {kind}, ptr %table2, i64 {place}")
            part = v(f"load {kind}, ptr {at}")
            label = v(f"add {kind} {label}, {part}") if start else part
        return label


@lru_cache(maxsize=64)
def _tables(field: LogarithmicField) -> tuple[np.ndarray, ...]:
    p, n, q = field.characteristic, field.degree, field.order
    digits = _powers(field)
    labels = digits @ p ** np.arange(n)
    if len(set(labels.tolist()) - {0}) != q - 1:
        raise ValueError(f"{field.generator} does not generate the units of the field")
    logarithms = np.full(q, 2 * (q - 1), np.uint32)
    logarithms[labels] = np.arange(q - 1)
    kind = np.uint32 if field.word == "i32" else np.uint64
    packed = (digits.astype(np.uint64) << (field.width * np.arange(n, dtype=np.uint64))).sum(axis=1)
    powers = np.zeros(4 * (q - 1) + 1, kind)
    powers[: q - 1] = powers[q - 1 : 2 * (q - 1)] = packed.astype(kind)
    index = np.arange(1 << field.width * field.group)
    fields = (index[:, None] >> field.width * np.arange(field.group)) % (1 << field.width) % p
    # for each group of digits, what it adds to the label; of digits beyond the last nothing is asked
    parts = [fields @ p ** (start + np.arange(field.group)) for start in range(0, n, field.group)]
    return logarithms, powers, np.concatenate(parts).astype(field.dtype)


def _powers(field: LogarithmicField) -> np.ndarray:
    """Return the digits of 1, g, g², …, as rows: the first half times a power of g is the second."""
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
    return found[: field.order - 1]
