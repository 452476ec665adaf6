"""Symbols for the numbers of a formula, and the program of LLVM that operations on them write down.

A `Lanes` is one coordinate of eight rows, a vector of eight numbers. Every operator adds a line to the
program, in LLVM's notation. Nothing is reordered, and nothing fused but where a program is `fused`, so
programs round as numpy does, operation by operation.
"""

import struct
from collections.abc import Iterable
from typing import Any

import numpy as np

WIDTH = 8
float64 = np.dtype(np.float64)


class Program:
    """The lines that a formula has written so far.

    Parameters
    ----------
    number : str
        LLVM's word for the numbers that are computed with: ``double`` or ``float``.
    fused : bool
        Whether a product and a sum may be rounded at once, where the processor does that.
    width : int
        How many rows go together.
    """

    def __init__(self, number: str = "double", fused: bool = False, width: int = WIDTH) -> None:
        self.number, self.width = number, width
        self.kind, self.bits = f"<{width} x {number}>", f"<{width} x i1>"
        self.flags = " contract" if fused else ""
        self.lines: list[str] = []
        self.label = "start"
        self.count = 0
        self.told: list[str] = []

    def name(self) -> str:
        """Return a name that nothing has yet."""
        self.count += 1
        return f"%v{self.count}"

    def value(self, text: str) -> str:
        """Add a line that computes ``text``, and return the name of its result."""
        name = self.name()
        self.lines.append(f"{name} = {text}")
        return name

    def shuffled(self, kind: str, a: str, b: str, places: Iterable[int]) -> str:
        """Add a line that gathers numbers from two vectors of one kind, by their places in both."""
        numbers = list(places)
        mask = ", ".join(f"i32 {n}" for n in numbers)
        return self.value(f"shufflevector {kind} {a}, {kind} {b}, <{len(numbers)} x i32> <{mask}>")

    def spread(self, place: str, number: str, size: int) -> str:
        """Add the reading of one number of ``size`` bytes into every row."""
        kind = f"<{self.width} x {number}>"
        one = self.value(f"load {number}, ptr {place}, align {size}")
        first = self.value(f"insertelement {kind} poison, {number} {one}, i32 0")
        zeros = f"<{self.width} x i32> zeroinitializer"
        return self.value(f"shufflevector {kind} {first}, {kind} poison, {zeros}")

    def begin(self, label: str) -> None:
        """Begin a block of code that may be jumped to."""
        self.lines.append(f"{label}:")
        self.label = label

    def constant(self, number: float) -> str:
        """Return a number in every row, exactly."""
        text = f"{self.number} 0x{struct.unpack('<Q', struct.pack('<d', number))[0]:016X}"
        return "<" + ", ".join([text] * self.width) + ">"

    def name_of(self, value: Any) -> str:
        """Return how a value is written: lanes by their name, a number in every row."""
        return value.name if isinstance(value, Lanes) else self.constant(float(value))

    def some(self, condition: str) -> str:
        """Add lines that find whether a condition holds in a row at least; return their result's name."""
        bits = self.value(f"bitcast {self.bits} {condition} to i{self.width}")
        return self.value(f"icmp ne i{self.width} {bits}, 0")


class Lanes:
    """A number in each of eight rows, or a condition."""

    __slots__ = ("name", "program")
    shape = ()
    ndim = 0
    dtype = float64

    def __init__(self, program: Program, name: str) -> None:
        self.program, self.name = program, name

    @property
    def kind(self) -> str:
        """LLVM's word for what this is."""
        return self.program.kind

    def _with(self, operation: str, other: Any, swapped: bool = False) -> "Lanes":
        if not isinstance(other, Lanes | float | int):
            return NotImplemented  # type: ignore[no-any-return]
        program = self.program
        a, b = self.name, program.name_of(other)
        if swapped:
            a, b = b, a
        line = f"{operation}{program.flags} {program.kind} {a}, {b}"
        return Lanes(program, program.value(line))

    def __add__(self, other: Any) -> "Lanes":
        return self._with("fadd", other)

    def __radd__(self, other: Any) -> "Lanes":
        return self._with("fadd", other, True)

    def __sub__(self, other: Any) -> "Lanes":
        return self._with("fsub", other)

    def __rsub__(self, other: Any) -> "Lanes":
        return self._with("fsub", other, True)

    def __mul__(self, other: Any) -> "Lanes":
        return self._with("fmul", other)

    def __rmul__(self, other: Any) -> "Lanes":
        return self._with("fmul", other, True)

    def __truediv__(self, other: Any) -> "Lanes":
        return self._with("fdiv", other)

    def __rtruediv__(self, other: Any) -> "Lanes":
        return self._with("fdiv", other, True)

    def __neg__(self) -> "Lanes":
        program = self.program
        return Lanes(program, program.value(f"fneg {self.kind} {self.name}"))

    def _compared(self, how: str, other: Any) -> "Condition":
        program = self.program
        line = f"fcmp {how} {self.kind} {self.name}, {program.name_of(other)}"
        return Condition(program, program.value(line))

    def __lt__(self, other: Any) -> "Condition":
        return self._compared("olt", other)

    def __le__(self, other: Any) -> "Condition":
        return self._compared("ole", other)

    def __gt__(self, other: Any) -> "Condition":
        return self._compared("ogt", other)

    def __ge__(self, other: Any) -> "Condition":
        return self._compared("oge", other)

    def __eq__(self, other: Any) -> "Condition":  # type: ignore[override]
        return self._compared("oeq", other)

    def __ne__(self, other: Any) -> "Condition":  # type: ignore[override]
        return self._compared("une", other)

    __hash__ = None  # type: ignore[assignment]


class Condition(Lanes):
    """What holds or does not in each of eight rows."""

    __slots__ = ()

    @property
    def kind(self) -> str:
        """LLVM's word for what this is."""
        return self.program.bits

    def _bits(self, operation: str, other: str) -> "Condition":
        line = f"{operation} {self.kind} {self.name}, {other}"
        return Condition(self.program, self.program.value(line))

    def __and__(self, other: "Condition") -> "Condition":
        return self._bits("and", other.name)

    def __or__(self, other: "Condition") -> "Condition":
        return self._bits("or", other.name)

    def __invert__(self) -> "Condition":
        return self._bits("xor", "<" + ", ".join(["i1 true"] * self.program.width) + ">")


class Rows:
    """Eight rows of an array: what a formula takes for its argument."""

    def __init__(self, shape: tuple[int, ...], values: list[Lanes]) -> None:
        self.shape, self.values = shape, values
        self.ndim = len(shape)
        self.dtype = float64

    def __getitem__(self, index: Any) -> Lanes:
        """Return the numbers at ``[...]``, ``[..., n]`` or ``[..., r, c]``."""
        if index is Ellipsis:
            return self.values[0]
        row = index[1] * self.shape[-1] if len(index) == 3 else 0
        found: Lanes = self.values[row + index[-1]]
        return found
