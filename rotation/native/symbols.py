"""Symbols for the numbers of a formula: operations on them emit LLVM code.

A `Lanes` is one coordinate of eight rows, a vector of eight numbers. Every operator appends a line of LLVM
code. Operations are not reordered, and are fused only in a program that is `fused`. So programs round like
numpy, operation by operation.
"""

from collections.abc import Callable, Iterable
from types import EllipsisType

import numpy as np

from hfield.compiling.instructions import Code, alike, floating, vector

WIDTH = 8
LIBRARY = ("sin", "cos", "atan2", "fmod")  # of the system
float64 = np.dtype(np.float64)
_WORDS = {"double": "f64", "float": "f32"}


class RowFunction(Code):
    """A function whose values are rows of numbers.

    Parameters
    ----------
    head : str
        The text before its body.
    number : str
        LLVM's word for the numbers that are computed with: ``double`` or ``float``.
    fused : bool
        Whether a product and a sum may be rounded in one step, if the processor supports it.
    width : int
        The number of rows that are processed together.
    """

    def __init__(
        self, head: str, number: str = "double", fused: bool = False, width: int = WIDTH
    ) -> None:
        super().__init__(head)
        self.number, self.width = number, width
        self.kind, self.bits = vector(number, width), vector("i1", width)
        self.flags = " contract" if fused else ""
        self.opposites: dict[str, str] = {}  # maps a value to the value of which it is the negative

    def constant(self, number: float) -> str:
        """Return a number in every row, exactly."""
        return alike(self.number, floating(number, "double"), self.width)

    def name_of(self, value: "Lanes | float") -> str:
        """Return the notation of a value: the name of lanes, or a number in every row."""
        return value.name if isinstance(value, Lanes) else self.constant(float(value))

    def some(self, condition: str) -> str:
        """Emit a test whether a condition holds in at least one row; return the name of its result."""
        bits = self.value(f"bitcast {self.bits} {condition} to i{self.width}")
        return self.value(f"icmp ne i{self.width} {bits}, 0")

    def rarely(
        self, condition: str, compute: Callable[[], Iterable["Lanes"]], usual: Iterable["Lanes"]
    ) -> "tuple[Lanes, ...]":
        """Emit a branch that is computed if the condition holds in at least one row."""
        before, self.conditions = self.conditions, []

        def computed() -> list[tuple[str, str, str]]:
            pairs = zip(compute(), usual, strict=True)
            values = [(self.kind, a.name, b.name) for a, b in pairs]
            return values + [(self.bits, t, "zeroinitializer") for t in self.conditions]

        found = self.when(self.some(condition), computed, rarely=True)
        count = len(found) - len(self.conditions)
        self.conditions = [*before, *found[count:]]
        return tuple(Lanes(self, name) for name in found[:count])


class Lanes:
    """A number in each of eight rows, or a condition."""

    __slots__ = ("name", "program")
    shape = ()
    ndim = 0
    dtype = float64

    def __init__(self, program: RowFunction, name: str) -> None:
        self.program, self.name = program, name

    @property
    def kind(self) -> str:
        """LLVM's type of the value."""
        return self.program.kind

    def _with(self, operation: str, other: "Lanes | float", swapped: bool = False) -> "Lanes":
        if not isinstance(other, Lanes | float | int):
            return NotImplemented
        if not isinstance(other, Lanes):
            if (
                type(other) is int and other == 0 and operation != "fdiv"
            ):  # an exact zero, not a float
                if operation == "fmul":
                    return 0  # type: ignore[return-value]
                return -self if swapped and operation == "fsub" else self
            if operation == "fmul" and other == -1.0:
                return -self
        program = self.program
        a, b = self.name, program.name_of(other)
        if swapped:
            a, b = b, a
        line = f"{operation}{program.flags} {program.kind} {a}, {b}"
        return Lanes(program, program.value(line))

    def __add__(self, other: "Lanes | float") -> "Lanes":
        return self._with("fadd", other)

    def __radd__(self, other: "Lanes | float") -> "Lanes":
        return self._with("fadd", other, True)

    def __sub__(self, other: "Lanes | float") -> "Lanes":
        return self._with("fsub", other)

    def __rsub__(self, other: "Lanes | float") -> "Lanes":
        return self._with("fsub", other, True)

    def __mul__(self, other: "Lanes | float") -> "Lanes":
        return self._with("fmul", other)

    def __rmul__(self, other: "Lanes | float") -> "Lanes":
        return self._with("fmul", other, True)

    def __truediv__(self, other: "Lanes | float") -> "Lanes":
        return self._with("fdiv", other)

    def __rtruediv__(self, other: "Lanes | float") -> "Lanes":
        return self._with("fdiv", other, True)

    def __neg__(self) -> "Lanes":
        program = self.program
        name = program.value(f"fneg {self.kind} {self.name}")
        program.opposites[name] = self.name
        return Lanes(program, name)

    def _compared(self, how: str, other: "Lanes | float") -> "LaneMask":
        program = self.program
        line = f"fcmp {how} {self.kind} {self.name}, {program.name_of(other)}"
        return LaneMask(program, program.value(line))

    def __lt__(self, other: "Lanes | float") -> "LaneMask":
        return self._compared("olt", other)

    def __le__(self, other: "Lanes | float") -> "LaneMask":
        return self._compared("ole", other)

    def __gt__(self, other: "Lanes | float") -> "LaneMask":
        return self._compared("ogt", other)

    def __ge__(self, other: "Lanes | float") -> "LaneMask":
        return self._compared("oge", other)

    def __eq__(self, other: "Lanes | float") -> "LaneMask":  # type: ignore[override]
        return self._compared("oeq", other)

    def __ne__(self, other: "Lanes | float") -> "LaneMask":  # type: ignore[override]
        return self._compared("une", other)

    __hash__ = None  # type: ignore[assignment]


class LaneMask(Lanes):
    """A condition in each of eight rows."""

    __slots__ = ()

    @property
    def kind(self) -> str:
        """LLVM's type of the value."""
        return self.program.bits

    def _bits(self, operation: str, other: str) -> "LaneMask":
        line = f"{operation} {self.kind} {self.name}, {other}"
        return LaneMask(self.program, self.program.value(line))

    def __and__(self, other: "LaneMask") -> "LaneMask":
        return self._bits("and", other.name)

    def __or__(self, other: "LaneMask") -> "LaneMask":
        return self._bits("or", other.name)

    def __invert__(self) -> "LaneMask":
        return self._bits("xor", alike("i1", "true", self.program.width))


# of a number, of one in a vector, of one in a matrix
Index = EllipsisType | tuple[EllipsisType, int] | tuple[EllipsisType, int, int]


class Rows:
    """Eight rows of an array as the argument of a formula, with their stored type."""

    def __init__(
        self, shape: tuple[int, ...], values: list[Lanes], dtype: np.dtype[np.floating] = float64
    ) -> None:
        self.shape, self.values = shape, values
        self.ndim = len(shape)
        self.dtype = dtype

    def __getitem__(self, index: Index) -> Lanes:
        """Return the numbers at ``[...]``, ``[..., n]`` or ``[..., r, c]``."""
        if not isinstance(index, tuple):
            return self.values[0]
        row = index[1] * self.shape[-1] if len(index) == 3 else 0
        found: Lanes = self.values[row + index[-1]]
        return found


def intrinsic(name: str, *values: "Lanes | float") -> Lanes:
    """Call an LLVM intrinsic on all rows."""
    program = _program(*values)
    called = f"llvm.{name}.v{program.width}{_WORDS[program.number]}"
    arguments = ((program.kind, program.name_of(v)) for v in values)
    return Lanes(program, program.call(program.kind, called, *arguments))


def library(name: str, *values: "Lanes | float") -> Lanes:
    """Call a function of the system's math library on each row."""
    program = _program(*values)
    kind = program.kind
    found = "poison"
    for n in range(program.width):
        numbers = [
            program.value(f"extractelement {kind} {program.name_of(v)}, i32 {n}") for v in values
        ]
        one = program.call("double", f"rotation_{name}", *(("double", x) for x in numbers))
        found = program.value(f"insertelement {kind} {found}, double {one}, i32 {n}")
    return Lanes(program, found)


def _program(*values: "Lanes | float") -> RowFunction:
    return next(v.program for v in values if isinstance(v, Lanes))
