"""The protocol of arithmetics in loops: read a number, compute with it, write it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic

if TYPE_CHECKING:
    from typing import Any

    import numpy as np
    from typing_extensions import TypeVar

    from hfield.compiling.instructions import Code

    P = TypeVar("P", default=Any)  # ``Arithmetic`` alone: its payloads are not type-checked
else:
    from typing import TypeVar

    P = TypeVar("P")  # what stands for a number while the loop is written


class Arithmetic(ABC, Generic[P]):
    """The arithmetic of a ring in a compiled loop, on payloads of its own type.

    An arithmetic is immutable and hashable: equal arithmetics make equal loops. ``vectorise`` says whether
    the loop processes several elements at a time. ``literal`` says whether structure constants are written
    into the loop, which then works for one algebra only, instead of being read by it. ``waits_for_memory``
    says whether little is computed per byte, so that large results should bypass the caches. ``lanes`` is the
    number of elements in one value of the loop.
    """

    vectorise = True
    lanes = 1
    literal = False
    waits_for_memory = False

    @property
    @abstractmethod
    def dtype(self) -> str:
        """The type of the rows that are read, such as ``u2``."""

    @property
    def result(self) -> str:
        """The type of the rows that are written."""
        return self.dtype

    def tables(self) -> tuple[np.ndarray, ...]:
        """Return the lookup tables, which the loop calls ``%table0``, ``%table1``, …"""
        return ()

    @abstractmethod
    def load(self, code: Code, raw: str) -> P:
        """Read a number of a row."""

    @abstractmethod
    def store(self, code: Code, x: P) -> str:
        """Return the value to write into a row."""

    @abstractmethod
    def constant(self, code: Code, value: int) -> P:
        """Return an integer that is known at compile time."""

    @abstractmethod
    def add(self, code: Code, x: P, y: P) -> P:
        """Return x + y."""

    @abstractmethod
    def subtract(self, code: Code, x: P, y: P) -> P:
        """Return x − y."""

    @abstractmethod
    def multiply(self, code: Code, x: P, y: P) -> P:
        """Return x·y."""

    @abstractmethod
    def negate(self, code: Code, x: P) -> P:
        """Return −x."""


@dataclass(frozen=True)
class Symbol(Generic[P]):
    """A payload with ``+ − ×``: evaluating a program on symbols emits its code."""

    arithmetic: Arithmetic[P]
    code: Code
    payload: P

    def _made(self, payload: P) -> Symbol[P]:
        return Symbol(self.arithmetic, self.code, payload)

    def __add__(self, other: Symbol[P]) -> Symbol[P]:
        return self._made(self.arithmetic.add(self.code, self.payload, other.payload))

    def __sub__(self, other: Symbol[P]) -> Symbol[P]:
        return self._made(self.arithmetic.subtract(self.code, self.payload, other.payload))

    def __mul__(self, other: Symbol[P]) -> Symbol[P]:
        return self._made(self.arithmetic.multiply(self.code, self.payload, other.payload))

    def __neg__(self) -> Symbol[P]:
        return self._made(self.arithmetic.negate(self.code, self.payload))


def unsigned(largest: int) -> str:
    """Return the smallest numpy type of unsigned integers up to ``largest``."""
    return next(f"u{size}" for size in (1, 2, 4, 8) if largest < 1 << 8 * size)
