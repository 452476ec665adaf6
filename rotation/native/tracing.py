"""A namespace whose arrays are symbols: run on them, a formula leaves behind its own program for LLVM.

A `Lanes` is one coordinate of eight rows, a vector of eight doubles. The operators and the functions here
add a line each to the program of the trace that runs, in LLVM's notation. Nothing is reordered, and nothing
fused but where a formula asks for `fma` or a program is `fused`, so programs round as numpy does, operation
by operation. Conditions select; only what is `rarely` needed is branched around.
"""

import math
import struct
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np

WIDTH = 8
_INFO = np.finfo(np.float64)
_LIMITS = SimpleNamespace(
    bits=64,
    eps=float(_INFO.eps),
    smallest_normal=float(_INFO.smallest_normal),
    max=float(_INFO.max),
)
float64 = np.dtype(np.float64)
float32 = np.dtype(np.float32)
nan = math.nan


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

    def value(self, kind: str, text: str) -> str:
        """Add a line that computes ``text``, and return the name of its result."""
        name = self.name()
        self.lines.append(f"{name} = {text}")
        return name

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
        bits = self.value("", f"bitcast {self.bits} {condition} to i{self.width}")
        return self.value("i1", f"icmp ne i{self.width} {bits}, 0")


class Lanes:
    """A number in each of eight rows, or a condition."""

    __slots__ = ("name", "program")
    shape = ()
    ndim = 0
    dtype = float64

    def __init__(self, program: Program, name: str) -> None:
        self.program, self.name = program, name

    def __array_namespace__(self, api_version: Any = None) -> Any:
        return _this()

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
        return Lanes(program, program.value(program.kind, line))

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
        return Lanes(program, program.value(self.kind, f"fneg {self.kind} {self.name}"))

    def _compared(self, how: str, other: Any) -> "Condition":
        program = self.program
        line = f"fcmp {how} {self.kind} {self.name}, {program.name_of(other)}"
        return Condition(program, program.value(program.bits, line))

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
        return Condition(self.program, self.program.value(self.kind, line))

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

    def __array_namespace__(self, api_version: Any = None) -> Any:
        return _this()

    def __getitem__(self, index: Any) -> Lanes:
        """Return the numbers at ``[...]``, ``[..., n]`` or ``[..., r, c]``."""
        if index is Ellipsis:
            return self.values[0]
        row = index[1] * self.shape[-1] if len(index) == 3 else 0
        found: Lanes = self.values[row + index[-1]]
        return found


def _this() -> Any:
    import rotation.native.tracing as this

    return this


def _program(*values: Any) -> Program:
    return next(v.program for v in values if isinstance(v, Lanes))


def _intrinsic(name: str, *values: Any) -> Lanes:
    program = _program(*values)
    kind = program.kind
    arguments = ", ".join(f"{kind} {program.name_of(v)}" for v in values)
    line = f"call {kind} @llvm.{name}.v{program.width}f64({arguments})"
    return Lanes(program, program.value(kind, line))


def _library(name: str, *values: Any) -> Lanes:
    """Call a function of the system's mathematics for each row."""
    program = _program(*values)
    kind = program.kind
    found = "poison"
    for n in range(program.width):
        numbers = [
            program.value("double", f"extractelement {kind} {program.name_of(v)}, i32 {n}")
            for v in values
        ]
        arguments = ", ".join(f"double {x}" for x in numbers)
        one = program.value("double", f"call double @rotation_{name}({arguments})")
        found = program.value(kind, f"insertelement {kind} {found}, double {one}, i32 {n}")
    return Lanes(program, found)


def abs(x: Lanes) -> Lanes:
    """Return the absolute values."""
    return _intrinsic("fabs", x)


def sqrt(x: Lanes) -> Lanes:
    """Return the square roots."""
    return _intrinsic("sqrt", x)


def fma(a: Any, b: Any, c: Any) -> Lanes:
    """Return ``a·b + c``, rounded once."""
    return _intrinsic("fma", a, b, c)


def sin(x: Lanes) -> Lanes:
    """Return the sines."""
    return _library("sin", x)


def cos(x: Lanes) -> Lanes:
    """Return the cosines."""
    return _library("cos", x)


def atan2(y: Any, x: Any) -> Lanes:
    """Return the angles of the points (x, y)."""
    return _library("atan2", y, x)


def remainder(x: Any, y: Any) -> Lanes:
    """Return ``x`` modulo ``y`` for numbers that are not negative."""
    return _library("fmod", x, y)


def where(condition: Condition, yes: Any, no: Any) -> Any:
    """Return one of two values, row by row."""
    program = condition.program
    made = Condition if isinstance(yes, Condition) else Lanes
    kind = program.bits if made is Condition else program.kind
    a, b = program.name_of(yes), program.name_of(no)
    line = f"select {program.bits} {condition.name}, {kind} {a}, {kind} {b}"
    return made(program, program.value(kind, line))


def atan(x: Any) -> Lanes:
    """Return the arc tangents."""
    return _library("atan", x)


def maximum(x: Lanes, y: Any) -> Lanes:
    """Return the larger of two numbers."""
    larger: Lanes = where(y > x, y, x)
    return larger


def isfinite(x: Any) -> Any:
    """Return where numbers are finite; for `Rows` a list of that."""
    if isinstance(x, Rows):
        return [isfinite(v) for v in x.values]
    return abs(x) < math.inf


def all(conditions: list[Condition], axis: Any = None) -> Condition:
    """Return where all conditions hold."""
    holds, *others = conditions
    for other in others:
        holds = holds & other
    return holds


def bit(x: Lanes, number: int) -> Condition:
    """Return where bit ``number`` of a double's memory is set."""
    program = x.program
    kind = f"<{program.width} x i64>"
    chosen = "<" + ", ".join([f"i64 {1 << number}"] * program.width) + ">"
    bits = program.value(kind, f"bitcast {x.kind} {x.name} to {kind}")
    found = program.value(kind, f"and {kind} {bits}, {chosen}")
    return Condition(
        program, program.value(program.bits, f"icmp ne {kind} {found}, zeroinitializer")
    )


def rarely(condition: Condition, compute: Callable[[], Any], usual: tuple[Lanes, ...]) -> Any:
    """Return ``compute()`` where the condition holds in one of the rows at least, else ``usual``."""
    program = condition.program
    some = program.some(condition.name)
    before, number, told = program.label, program.count, program.told
    program.told = []
    program.lines.append(f"br i1 {some}, label %rare{number}, label %join{number}")
    program.begin(f"rare{number}")
    computed = compute()
    after = program.label
    program.lines.append(f"br label %join{number}")
    program.begin(f"join{number}")

    def joined(kind: str, there: str, here: str) -> str:
        return program.value(kind, f"phi {kind} [ {there}, %{after} ], [ {here}, %{before} ]")

    program.told = [*told, *(joined(program.bits, t, "zeroinitializer") for t in program.told)]
    return tuple(
        Lanes(program, joined(program.kind, a.name, b.name))
        for a, b in zip(computed, usual, strict=True)
    )


def tell(condition: Condition) -> None:
    """Have the function say so at the end if the condition holds in a row."""
    condition.program.told.append(condition.name)


def finfo(dtype: Any) -> Any:
    """Return the limits of float64."""
    return _LIMITS


def full_like(values: Lanes, number: float) -> Lanes:
    """Return the number in every row."""
    return Lanes(values.program, values.program.constant(number))


def ones_like(values: Lanes) -> Lanes:
    """Return 1 in every row."""
    return full_like(values, 1.0)


def zeros_like(values: Lanes) -> Lanes:
    """Return 0 in every row."""
    return full_like(values, 0.0)


def broadcast_arrays(*values: Any) -> tuple[Any, ...]:
    """Return the values: numbers and rows go together as they are."""
    return values


def stack(values: Any, axis: int = 0) -> tuple[Any, ...]:
    """Return values, or tuples of them, as the tuple that the program writes to memory."""
    return tuple(values)
