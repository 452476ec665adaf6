"""A namespace of symbolic arrays that records a formula as a program for LLVM.

The functions here append lines to the program of their arguments, like the operators of `symbols`. In `fma` a
product and a sum are rounded once. Conditions select between two values; only the code in `rarely` is skipped
by a branch.
"""

import math
import sys
from collections.abc import Callable, Iterable, Sequence
from types import SimpleNamespace
from typing import TypeVar, cast

import numpy as np

from hfield.compiling.instructions import alike, vector
from rotation.array_types import Array, SymbolNamespace
from rotation.native import elementary
from rotation.native.pairs import PairLike
from rotation.native.symbols import LaneMask, Lanes, Rows, intrinsic, library

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
Number = Lanes | float
Values = TypeVar("Values")
NAMESPACE = cast(SymbolNamespace, sys.modules[__name__])
ROUND = 1.5 * 2.0**52  # a number added to it loses its fractional part


def as_arrays(lanes: Iterable[Lanes]) -> tuple[Array, ...]:
    """Return symbols, typed as arrays for formulas."""
    return cast("tuple[Array, ...]", tuple(lanes))


def as_lanes(values: Iterable[Array]) -> tuple[Lanes, ...]:
    """Return the results of a formula computed with symbols, typed as symbols."""
    return cast("tuple[Lanes, ...]", tuple(values))


def abs(x: Lanes) -> Lanes:
    """Return the absolute values."""
    return intrinsic("fabs", x)


def sqrt(x: Lanes) -> Lanes:
    """Return the square roots."""
    return intrinsic("sqrt", x)


def fma(a: Number, b: Number, c: Number) -> Lanes:
    """Return ``a·b + c``, rounded once."""
    return intrinsic("fma", a, b, c)


def copysign(x: Number, y: Lanes) -> Lanes:
    """Return ``x`` with the signs of ``y``."""
    return intrinsic("copysign", x, y)


def waves(a: Array, b: Array | None = None) -> tuple[PairLike, PairLike]:
    """Return sine and cosine of angles, or of pairs a + b as pairs."""
    return elementary.sine_and_cosine(NAMESPACE, a, b)


def sin(x: Array) -> Array:
    """Return the sines."""
    return waves(x)[0][0]


def cos(x: Array) -> Array:
    """Return the cosines."""
    return waves(x)[1][0]


def round(x: Lanes) -> Lanes:
    """Return the nearest integers of numbers below 2⁵¹; ties go to the even integer."""
    return (x + ROUND) - ROUND


def angle_of(y: Array, x: Array) -> PairLike:
    """Return the angles of the points (x, y) as pairs."""
    return elementary.angle_of(NAMESPACE, y, x)


def atan2(y: Array, x: Array) -> Array:
    """Return the angles of the points (x, y)."""
    return elementary.angle_of(NAMESPACE, y, x, pair=False)[0]


def remainder(x: Number, y: Number) -> Lanes:
    """Return ``x`` modulo ``y`` for nonnegative numbers."""
    return library("fmod", x, y)


def where(condition: LaneMask, yes: Number, no: Number) -> Lanes:
    """Return one of two values, row by row."""
    program = condition.program
    made = LaneMask if isinstance(yes, LaneMask) else Lanes
    kind = program.bits if made is LaneMask else program.kind
    a, b = program.name_of(yes), program.name_of(no)
    line = f"select {program.bits} {condition.name}, {kind} {a}, {kind} {b}"
    return made(program, program.value(line))


def maximum(x: Lanes, y: Number) -> Lanes:
    """Return the larger of two numbers."""
    return where(y > x, y, x)


def isfinite(x: Lanes | Rows) -> LaneMask | list[LaneMask]:
    """Return where numbers are finite; for `Rows`, as a list."""
    if isinstance(x, Rows):
        return [abs(v) < math.inf for v in x.values]
    return abs(x) < math.inf


def all(conditions: Sequence[LaneMask], axis: int | None = None) -> LaneMask:
    """Return where all conditions hold."""
    holds, *others = conditions
    for other in others:
        holds = holds & other
    return holds


def bit(x: Lanes, number: int) -> LaneMask:
    """Return where bit ``number`` of a double's memory is set."""
    program = x.program
    kind, chosen = vector("i64", program.width), alike("i64", 1 << number, program.width)
    bits = program.value(f"bitcast {x.kind} {x.name} to {kind}")
    found = program.value(f"and {kind} {bits}, {chosen}")
    return LaneMask(program, program.value(f"icmp ne {kind} {found}, zeroinitializer"))


def rarely(
    condition: LaneMask, compute: Callable[[], tuple[Lanes, ...]], usual: tuple[Lanes, ...]
) -> tuple[Lanes, ...]:
    """Return ``compute()`` if the condition holds in at least one row, else ``usual``."""
    return condition.program.rarely(condition.name, compute, usual)


def flag_if(condition: LaneMask) -> None:
    """Make the function return True if the condition holds in a row."""
    condition.program.conditions.append(condition.name)


def round_all(x: Lanes) -> None:
    """Disallow implicit fused multiply-adds from here on, because some differences must be exact."""
    x.program.flags = ""


def finfo(dtype: object) -> SimpleNamespace:
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


def broadcast_arrays(*values: Number) -> tuple[Number, ...]:
    """Return the values unchanged: numbers and rows can be combined directly."""
    return values


def stack(values: Iterable[Values], axis: int = 0) -> tuple[Values, ...]:
    """Return values, or tuples of them, as the tuple that the program writes to memory."""
    return tuple(values)
