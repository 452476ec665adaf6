"""Functions of float quaternions: modulus, polar form, exponential, logarithm, root and power.

A batch is computed in blocks that fit the processor's cache; a single element is a block of one. As in
:mod:`.analysis`, q = w + v with tr(v) = 0, v² = s and φ = √|s|. Then ``f(q) = even + odd·v`` with scalars
``even`` and ``odd`` that depend on f. The errors, in units of 2⁻⁵², are listed in docs/reference/algebras.md;
scripts/measure_float_functions.py measures them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from hfield.algebra.structure.elements.undefined_values import NO_POLAR_FORM, no_value
from hfield.compiling import machine_code, memory
from hfield.compiling.arithmetic import Symbol
from hfield.compiling.arithmetics import doubles
from hfield.compiling.calling import ArrayProgram
from hfield.compiling.memory import Rows
from hfield.core.product import Constants, Coordinates, norm
from hfield.core.straight_line import FIRST
from hfield.errors import NoSolutionError
from hfield.fields.base.array_storage.floats import MIN_COMPILED

if TYPE_CHECKING:
    from hfield.fields.base.ring import Ring

Array: TypeAlias = npt.NDArray[np.float64]
Number: TypeAlias = Any  # a float, or an array of floats
HAMILTON = Constants(-1.0, 0.0, -1.0)
BLOCK_SIZE = 8192  # quaternions
SAFE_NORMS = 1e-290, 1e290  # between these, sums of squares have no underflow and overflow


class FloatFunction(NamedTuple):
    """A function f that is real where it is defined on the real line; elsewhere it returns NaN.

    ``slope`` is f′. ``circular`` maps w, φ > 0 and φ² to the real part of f(w + iφ) and its imaginary part
    divided by φ.
    """

    noun: str
    real: Callable[[Number], Number]
    slope: Callable[[Number], Number]
    circular: Callable[[Number, Number, Number], tuple[Number, Number]]


# --- what every function is made of -------------------------------------------------------------------
# ``Number`` is a block of numbers or a float; functions of numpy take both, and give both the same values.


def parts(c: Constants, q: Sequence[Number]) -> tuple[Number, Number | None, Number]:
    """Return w, half the trace of i times x (None if it is 0), and s."""
    a, t, b = c
    w, x, y, z = q
    if c == HAMILTON:
        return w, None, -(x * x + y * y + z * z)
    middle, shifted = t / 2 * x, y + t / 2 * z
    square = (a + t * t / 4) * (x * x - b * z * z) + b * shifted * shifted
    return w + middle, middle, square


def _any(flags: bool | np.ndarray) -> bool:
    return flags if isinstance(flags, bool) else bool(flags.any())


def _is_safe(total: Number) -> bool:
    """Return whether sums of squares were computed without underflow or overflow."""
    if isinstance(total, float):
        return SAFE_NORMS[0] < total < SAFE_NORMS[1]
    return bool(SAFE_NORMS[0] < total.min(initial=1.0) and total.max(initial=1.0) < SAFE_NORMS[1])


def _length(w: Number, phi: Number, square: Number) -> Number:
    """Return √(w² + φ²), given φ²."""
    total = w * w + square
    return np.sqrt(total) if _is_safe(total) else np.hypot(w, phi)


def _even_and_odd(f: FloatFunction, c: Constants, q: Sequence[Number]) -> tuple[Number, ...]:
    """Return the result of :func:`parts`, ``even`` and ``odd``; the latter are not finite if there is no
    value.
    """
    w, middle, s = parts(c, q)
    if isinstance(s, float):
        return w, middle, s, *_of_one(f, w, s, not any(q[1:]))
    phi = np.sqrt(np.abs(s))
    even, odd = f.circular(w, phi, -s)
    rest = ~(s < 0)
    if rest.any():
        flat, scalar = s == 0, ~(q[1].astype(bool) | q[2].astype(bool) | q[3].astype(bool))
        plus, minus = f.real(w + phi), f.real(w - phi)
        even = np.where(rest, (plus + minus) / 2, even)
        odd = np.where(rest, (plus - minus) / (2 * phi), odd)
        odd = np.where(flat, np.where(scalar, 0.0, f.slope(w)), odd)
        even = np.where(flat, f.real(w), even)
    return w, middle, s, even, odd


def _of_one(f: FloatFunction, w: float, s: float, is_scalar: bool) -> tuple[Number, Number]:
    phi = math.sqrt(abs(s))
    if s < 0:
        return f.circular(w, phi, -s)
    if s == 0:
        return f.real(w), 0.0 if is_scalar else f.slope(w)
    plus, minus = f.real(w + phi), f.real(w - phi)
    return (plus + minus) / 2, (plus - minus) / (2 * phi)


def _compiled(kernel: ArrayProgram, c: Constants, q: Coordinates) -> Rows | None:
    """Compute a batch in Hamilton's algebra by a compiled loop; None if the loop does not apply."""
    if c != HAMILTON or q[0].size < MIN_COMPILED or not machine_code.available():
        return None
    rows, flagged = kernel(tuple(q))
    return None if flagged else rows


def value(ring: Ring, c: Constants, q: Coordinates, f: FloatFunction) -> Coordinates:
    """Return f(q), elementwise on arrays. Raises :class:`NoSolutionError` where f has no value."""
    constants = Constants(*map(float, c))
    if f is SQRT and is_batch(q):
        found = _compiled(ROOT, constants, q)
        if found is not None:
            w, x, y, z = found
            return w, x, y, z

    def rows(part: Sequence[Number]) -> tuple[Iterable[Number], Number]:
        _, middle, _, even, odd = _even_and_odd(f, constants, part)
        first = even if middle is None else even - odd * middle
        return (first, odd * part[1], odd * part[2], odd * part[3]), even + odd

    out, wrong = _in_blocks(rows, q, 4)
    if wrong is not None:
        raise _error(ring, q, wrong, f.noun)
    w, x, y, z = out
    return w, x, y, z


def _in_blocks(
    rows: Callable[[Sequence[Number]], tuple[Iterable[Number], Number]], q: Coordinates, count: int
) -> tuple[Iterable[Number], np.ndarray | None]:
    """Apply a function to a single element, or to a batch block by block.

    The function returns rows and a test value. The second result marks the entries whose test value is not
    finite; it is None if there are none.
    """
    with np.errstate(all="ignore"):
        if not is_batch(q):
            found, sure = rows(q)
            return [*map(float, found)], None if np.isfinite(sure) else np.ones(1, bool)
        flat = [np.ravel(x) for x in q]
        size = flat[0].size
        out, _ = memory.block((count, size), "f8")
        wrong = []
        for start in range(0, size, BLOCK_SIZE):
            part = slice(start, start + BLOCK_SIZE)
            found, sure = rows([x[part] for x in flat])
            for row, numbers in zip(out, found, strict=True):
                row[part] = numbers
            if not np.isfinite(sure.sum()):
                wrong += [start + n for n in np.flatnonzero(~np.isfinite(sure))]
    shape = q[0].shape
    flags = None
    if wrong:
        flags = np.zeros(size, bool)
        flags[wrong] = True
        flags = flags.reshape(shape)
    return out.reshape(count, *shape), flags


def is_batch(q: Coordinates) -> bool:
    """Return whether coordinates are arrays."""
    return hasattr(q[0], "shape")


def _error(ring: Ring, q: Coordinates, wrong: Array, noun: str) -> NoSolutionError:
    """Return the error for the first entry without a value."""
    where = tuple(int(n[0]) for n in wrong.nonzero()) if is_batch(q) else ()
    shown = ", ".join(ring.text(x[where] if is_batch(q) else x) for x in q)
    at = f" at index {where}" if is_batch(q) else ""
    return NoSolutionError(no_value(shown, noun, at))


# --- the functions ------------------------------------------------------------------------------------


def _exp(w: Number, phi: Number, square: Number) -> tuple[Number, Number]:
    length = np.exp(w)
    return length * np.cos(phi), length * (np.sin(phi) / phi)


def _log(w: Number, phi: Number, square: Number) -> tuple[Number, Number]:
    total = w * w + square
    real = np.log1p((w - 1) * (w + 1) + square) / 2  # of total − 1, accurate also if that is small
    far = total < 0.5
    if _any(far):
        real = np.where(far, np.log(total) / 2, real)
    if not _is_safe(total):
        right = (SAFE_NORMS[0] < total) & (total < SAFE_NORMS[1])
        real = np.where(right, real, np.log(np.hypot(w, phi)))
    return real, np.arctan2(phi, w) / phi


def _sqrt(w: Number, phi: Number, square: Number) -> tuple[Number, Number]:
    larger = np.sqrt((_length(w, phi, square) + np.abs(w)) / 2)
    behind = w < 0
    even = np.where(behind, phi / (2 * larger), larger) if _any(behind) else larger
    return even, 0.5 / even


EXP = FloatFunction("exponential within the range of floats", np.exp, np.exp, _exp)
LOG = FloatFunction("principal logarithm", np.log, np.reciprocal, _log)
SQRT = FloatFunction(
    "principal power with the exponent 0.5", np.sqrt, lambda w: 0.5 / np.sqrt(w), _sqrt
)


def power_function(exponent: float | Fraction) -> FloatFunction:
    """Return the principal power, ``exp(exponent·log q)``."""
    p = float(exponent)
    if p == 0.5:
        return SQRT

    def circular(w: Number, phi: Number, square: Number) -> tuple[Number, Number]:
        length, angle = np.power(_length(w, phi, square), p), p * np.arctan2(phi, w)
        return length * np.cos(angle), length * np.sin(angle) / phi

    return FloatFunction(
        f"principal power with the exponent {exponent}",
        lambda w: np.power(w, p),
        lambda w: p * np.power(w, p - 1),
        circular,
    )


def _root(w: Symbol, x: Symbol, y: Symbol, z: Symbol) -> tuple[Symbol, ...]:
    """Return the principal square root in Hamilton's algebra, by the method of :func:`_sqrt`."""
    half, square = doubles.constant(w, 0.5), x * x + y * y + z * z
    doubles.flag_unless_between(square, *SAFE_NORMS)
    total = w * w + square
    doubles.flag_unless_between(total, *SAFE_NORMS)
    larger = doubles.sqrt((doubles.sqrt(total) + doubles.absolute(w)) * half)
    behind = doubles.quotient(doubles.sqrt(square), larger + larger)
    even = doubles.where_negative(w, behind, larger)
    odd = doubles.quotient(half, even)
    return even, odd * x, odd * y, odd * z


def _length_of(w: Symbol, x: Symbol, y: Symbol, z: Symbol) -> tuple[Symbol, ...]:
    total = w * w + x * x + y * y + z * z
    doubles.flag_unless_between(total, *SAFE_NORMS)
    return (doubles.sqrt(total),)


ROOT, LENGTH = (
    ArrayProgram(doubles.FloatFormula(f, FIRST, outputs), doubles.Doubles(), (FIRST,), {})
    for f, outputs in ((_root, FIRST), (_length_of, ("length",)))
)


# --- modulus and polar form ---------------------------------------------------------------------------


def modulus(c: Constants, q: Coordinates) -> Number:
    """Return the nonnegative root of the norm. Raises :class:`NoSolutionError` where that is negative."""
    constants = Constants(*map(float, c))
    if not is_batch(q):
        square = float(norm(constants, q))
        if not _is_safe(square):
            return float(_scaled_modulus(constants, np.array(q)[:, None])[0])
        return math.sqrt(square)
    found = _compiled(LENGTH, constants, q)
    if found is not None:
        return found[0]
    with np.errstate(all="ignore"):
        square = norm(constants, q)
    return np.sqrt(square) if _is_safe(square) else _scaled_modulus(constants, np.stack(q))


def _scaled_modulus(c: Constants, q: Array) -> Array:
    """Return the moduli of quaternions, the columns of q, whose norms overflow or underflow."""
    scale = np.abs(q).max(axis=0)
    scale[scale == 0] = 1.0
    w, x, y, z = q / scale
    square: Array = norm(c, (w, x, y, z))
    if (square < 0).any():
        raise NoSolutionError("|q| = √N(q), and the norm is negative here")
    found: Array = scale * np.sqrt(square)
    return found


def polar(
    c: Constants, q: Coordinates, axis: Callable[[], Coordinates]
) -> tuple[Number, Coordinates, Number]:
    """Return modulus, axis and angle in [0, π]; ``axis`` is the axis for scalars.

    Raises :class:`NoSolutionError` if v is not 0 and v² is not negative.
    """
    constants = Constants(*map(float, c))

    def rows(part: Sequence[Number]) -> tuple[Iterable[Number], Number]:
        w, middle, s = parts(constants, part)
        v = [-middle if middle is not None else 0.0 * w, *part[1:]]
        scalar = (part[1] == 0) & (part[2] == 0) & (part[3] == 0)
        phi = np.sqrt(np.abs(s))
        v = [x / np.where(scalar, 1.0, phi) for x in v]
        if _any(scalar):
            v = [x + n * scalar for x, n in zip(v, axis(), strict=True)]
        return (*v, np.arctan2(phi, w)), np.where(scalar | (s < 0), 0.0, np.nan)

    out, wrong = _in_blocks(rows, q, 5)
    if wrong is not None:
        raise NoSolutionError(NO_POLAR_FORM)
    w, x, y, z, angle = out
    return modulus(c, q), (w, x, y, z), angle
