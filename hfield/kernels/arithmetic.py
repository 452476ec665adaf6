"""What a loop asks of an arithmetic: how a number is read, computed with, and written."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    import numpy as np


class Code:
    """Lines in LLVM's notation, each value computed once."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.flags: list[str] = []  # values of type i64: not 0 where the loop has to be told of
        self._known: dict[str, str] = {}

    def value(self, text: str) -> str:
        """Return the name of what ``text`` computes; the same text is the same value."""
        name = self._known.get(text)
        if name is None:
            name = self._known[text] = f"%v{len(self._known)}"
            self.lines.append(f"{name} = {text}")
        return name


class Arithmetic(Protocol):
    """The numbers of a ring in a loop. What stands for one, a payload, is the arithmetic's own affair.

    An arithmetic is immutable and hashable: equal ones make equal loops. ``vectorise``: whether the loop is
    to run over several elements at a time; ``literal``: whether structure constants are written into
    the loop, which then serves one algebra, and not read by it.
    """

    @property
    def dtype(self) -> str: ...  # noqa: D102
    @property
    def declarations(self) -> tuple[str, ...]: ...  # noqa: D102
    @property
    def vectorise(self) -> bool: ...  # noqa: D102
    @property
    def literal(self) -> bool: ...  # noqa: D102
    def tables(self) -> tuple[np.ndarray, ...]: ...  # noqa: D102
    def load(self, code: Code, raw: str) -> Any: ...  # noqa: D102
    def store(self, code: Code, x: Any) -> str: ...  # noqa: D102
    def constant(self, code: Code, value: int) -> Any: ...  # noqa: D102
    def add(self, code: Code, x: Any, y: Any) -> Any: ...  # noqa: D102
    def subtract(self, code: Code, x: Any, y: Any) -> Any: ...  # noqa: D102
    def multiply(self, code: Code, x: Any, y: Any) -> Any: ...  # noqa: D102
    def negate(self, code: Code, x: Any) -> Any: ...  # noqa: D102


@dataclass(frozen=True)
class Symbol:
    """A payload with ``+ − ×``: a program that is evaluated on symbols writes its own code."""

    arithmetic: Arithmetic
    code: Code
    payload: Any

    def _made(self, payload: Any) -> Symbol:
        return Symbol(self.arithmetic, self.code, payload)

    def __add__(self, other: Symbol) -> Symbol:
        return self._made(self.arithmetic.add(self.code, self.payload, other.payload))

    def __sub__(self, other: Symbol) -> Symbol:
        return self._made(self.arithmetic.subtract(self.code, self.payload, other.payload))

    def __mul__(self, other: Symbol) -> Symbol:
        return self._made(self.arithmetic.multiply(self.code, self.payload, other.payload))

    def __neg__(self) -> Symbol:
        return self._made(self.arithmetic.negate(self.code, self.payload))


def raw_type(dtype: str) -> str:
    """Return LLVM's name for integers of a numpy type such as ``u2``."""
    return f"i{8 * int(dtype[1])}"


def unsigned(largest: int) -> str:
    """Return the smallest numpy type of unsigned integers up to ``largest``."""
    return next(f"u{size}" for size in (1, 2, 4, 8) if largest < 1 << 8 * size)


def floating(x: float, word: str) -> str:
    """Write a number as LLVM's ``float`` or ``double``, exactly as it is rounded to that type."""
    if word == "float":
        (x,) = struct.unpack("<f", struct.pack("<f", x))
    return f"0x{struct.unpack('<Q', struct.pack('<d', x))[0]:016X}"
