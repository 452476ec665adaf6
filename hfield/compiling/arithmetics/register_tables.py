"""GF(pⁿ), n > 1 and pⁿ ≤ 256, 64 elements at a time, by logarithm tables in registers.

The instruction vpermi2b of AVX-512 VBMI looks up 64 bytes at once in a table of 128 bytes, and two such
instructions do so in a table of 256. The tables contain the logarithms of labels, and the digits of powers; a
byte contains as many digits as leave space for the sum of a few.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from hfield.compiling.arithmetics.logarithms import TERMS, ByLogarithms, Logarithm, Packed, powers
from hfield.compiling.instructions import Code, alike, raw_type, vector

PROCESSOR = "avx512vbmi"
LANES = 64
ORDER = 256  # the largest that labels of a byte allow
HALF = ORDER // 2  # bytes that one instruction looks up in
LOG_ZERO = ORDER - 1
VECTOR = raw_type("u1", LANES)
MASK = vector("i1", LANES)
LOOK_UP = "llvm.x86.avx512.vpermi2var.qi.512"


@dataclass(frozen=True)
class RegisterField(ByLogarithms):
    """The field for odd p, with base-p digits in one to three bytes."""

    lanes = LANES
    word = VECTOR

    @property
    def capacity(self) -> int:
        """The number of values that a digit of a sum may have."""
        return TERMS * (self.characteristic - 1) + 1

    @property
    def group(self) -> int:
        """The number of digits in a byte, which are looked up in one step."""
        return 2 if self.capacity**2 <= HALF else 1

    def tables(self) -> tuple[np.ndarray, ...]:
        """Return tables: logarithms, digits of powers in bytes, and the part of the label of each byte."""
        return _tables(self)

    def constant(self, code: Code, value: int) -> Logarithm:
        """Return the element with a label."""
        return Logarithm(_all(int(self.tables()[0][value])))

    def biased(self, code: Code, words: tuple[str, ...], bias: int) -> tuple[str, ...]:
        """Add a number to every digit."""
        every = _all(sum(bias * self.capacity**n for n in range(self.group)))
        return tuple(code.value(f"add {VECTOR} {word}, {every}") for word in words)

    def logarithm(self, code: Code, label: str) -> Logarithm:
        """Return the logarithm of a label, by table."""
        return Logarithm(_found(code, "%table0", 0, label))

    def power(self, code: Code, *logarithms: Logarithm) -> Packed:
        """Return the digits, by table; the last entry is that of log 0."""
        index = logarithms[0].name
        for other in logarithms[1:]:
            index = self._product(code, index, other.name)
        starts = range(0, len(self.tables()[1]), ORDER)
        words = tuple(_found(code, "%table1", start, index) for start in starts)
        return Packed(words, 0, self.characteristic - 1)

    def label(self, code: Code, words: tuple[str, ...]) -> str:
        """Return the label of a sum: the sum of table entries, one for each byte."""
        label = ""
        for n, word in enumerate(words):
            part = _half_found(code, "%table2", n * HALF, word)
            label = code.value(f"add {VECTOR} {label}, {part}") if n else part
        return label

    def _product(self, code: Code, x: str, y: str) -> str:
        """Return the sum of two logarithms modulo q − 1, or log 0 if one of them is log 0."""
        v, units, log_zero = code.value, _all(self.order - 1), _all(LOG_ZERO)
        gap = v(f"sub {VECTOR} {units}, {y}")
        beyond, below = v(f"sub {VECTOR} {x}, {gap}"), v(f"icmp ult {VECTOR} {x}, {gap}")
        wrapped = v(f"add {VECTOR} {beyond}, {units}")
        total = v(f"select {MASK} {below}, {VECTOR} {wrapped}, {VECTOR} {beyond}")
        zeros = [v(f"icmp eq {VECTOR} {z}, {log_zero}") for z in (x, y)]
        zero = v(f"or {MASK} {zeros[0]}, {zeros[1]}")
        return v(f"select {MASK} {zero}, {VECTOR} {log_zero}, {VECTOR} {total}")


@dataclass(frozen=True)
class BinaryRegisterField(RegisterField):
    """The field for p = 2, with the label itself in a byte: sums are exclusive ors."""

    capacity = 2

    @property
    def group(self) -> int:
        """The number of digits in a byte: all."""
        return self.degree

    def power(self, code: Code, *logarithms: Logarithm) -> Packed:
        """Return the label, by table; sums of labels need no reduction."""
        return Packed(super().power(code, *logarithms).words, 0, 0)

    def label(self, code: Code, words: tuple[str, ...]) -> str:
        """Return the label."""
        return words[0]

    def _together(self, code: Code, operation: str, x: Packed, y: Packed) -> tuple[str, ...]:
        return super()._together(code, "xor", x, y)


def _found(code: Code, table: str, start: int, index: str) -> str:
    """Look up bytes in a table of 256 bytes."""
    low, high = (_half_found(code, table, start + n * HALF, index) for n in (0, 1))
    upper = code.value(f"icmp slt {VECTOR} {index}, zeroinitializer")
    return code.value(f"select {MASK} {upper}, {VECTOR} {high}, {VECTOR} {low}")


def _half_found(code: Code, table: str, start: int, index: str) -> str:
    """Look up bytes in a table of 128 bytes, by the lower seven bits of the index."""
    parts = []
    for place in (start, start + LANES):
        parts.append(code.load(VECTOR, code.at("i8", table, place), 1))
    return code.call(VECTOR, LOOK_UP, (VECTOR, parts[0]), (VECTOR, index), (VECTOR, parts[1]))


def _all(value: int) -> str:
    return alike("i8", value, LANES)


@lru_cache(maxsize=64)
def _tables(field: RegisterField) -> tuple[np.ndarray, ...]:
    p, n, q, group = field.characteristic, field.degree, field.order, field.group
    digits = np.zeros((ORDER, n + -n % group), np.int64)
    digits[: q - 1, :n] = powers(field)
    logarithms = np.full(ORDER, LOG_ZERO)
    logarithms[digits[: q - 1, :n] @ p ** np.arange(n)] = np.arange(q - 1)
    weights = field.capacity ** np.arange(group)
    packed = digits.reshape(ORDER, -1, group) @ weights
    fields = np.arange(HALF)[:, None] // weights % field.capacity % p
    parts = [fields @ p ** (start + np.arange(group)) for start in range(0, n, group)]
    return logarithms.astype("u1"), _bytes(packed.T), _bytes(parts)


def _bytes(tables: Iterable[np.ndarray]) -> np.ndarray:
    return np.concatenate(list(tables)).astype("u1")
