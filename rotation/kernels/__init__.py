"""The loops that rotate many points, and the threads that share them.

Every function takes arrays with the components last, in any strides, whose batches broadcast to that
of ``out``; ``out`` may be the points themselves. Nothing is checked here but zero axes and zero
quaternions, which only the loop itself can see cheaply. A loop is compiled, in some hundredths of a
second, for the way its arrays lie in memory, when first asked for.
"""

import ctypes
from functools import cache
from typing import Any

import numpy as np

from hfield.compiling import machine_code
from hfield.compiling.memory import in_one_piece
from hfield.compiling.threads import share
from rotation.arrays import Array
from rotation.kernels import twins
from rotation.kernels.strides import parameters, plan
from rotation.native import builtins
from rotation.native.strided_loop import Operand, Way, strided_loop
from rotation.pool import threads

__all__ = ["axis_angle", "contains_zero", "cumulative", "euler", "one", "quaternions", "threads"]

# Below this many points for each thread, waking one takes longer than its part of the work.
LIGHT, HEAVY = 100_000, 8_000

Kind = tuple[int, str, int, int]
_NUMBERS = {"d": "double", "f": "float"}
_announce = machine_code.Announcer(
    "rotation: compiling a loop for many points, once on this machine "
    "(rotation.warm_up() does it beforehand)"
)


def one(points: Array, matrix: Array, out: Array) -> None:
    """Rotate all points by one matrix ``(3, 3)``."""
    entries = matrix.astype(points.dtype).reshape(9)
    _run(("one",), LIGHT, (points, entries), out)


def axis_angle(points: Array, axis: Array, angle: Array, out: Array, degrees: bool = False) -> bool:
    """Rotate points about their own axes by their own angles; tell whether an axis was zero."""
    axis, angle = parameters(points, axis, angle)
    single = out.dtype == np.float32
    return _run(("axis_angle", degrees, single), HEAVY, (points, axis, angle[..., None]), out)


def quaternions(points: Array, q: Array, out: Array) -> bool:
    """Rotate points by their own quaternions of any length; tell whether one was zero."""
    single = out.dtype == np.float32
    return _run(("quaternions", single), HEAVY, (points, *parameters(points, q)), out)


def euler(
    points: Array,
    angles: Array,
    axes: tuple[int, ...],
    backward: bool,
    out: Array,
    degrees: bool = False,
) -> None:
    """Rotate points about coordinate axes, in that order, by their own angles ``(…, len(axes))``.

    The first axis takes the last of the angles if ``backward``, else the first.
    """
    _run(("euler", axes, backward, degrees), HEAVY, (points, *parameters(points, angles)), out)


def contains_zero(array: Array) -> bool:
    """Tell whether a row has all its components zero."""
    return _run(("contains_zero",), LIGHT, (array,), None)


def cumulative(q: Array) -> Array:
    """Return ``q[0]``, ``q[1]·q[0]``, ``q[2]·q[1]·q[0]``, … for ``q`` of shape ``(N, 4)``, normalised.

    The running product is kept in twice the precision, so errors do not add up over its length.
    """
    with machine_code.lock:
        from rotation.kernels import chains

    return chains.cumulative(np.ascontiguousarray(q, np.float64))


def _run(name: tuple[Any, ...], grain: int, read: tuple[Array, ...], out: Array | None) -> bool:
    operands = read if out is None else (*read, out)
    batch = operands[-1].shape[:-1]
    if operands[-1].size == 0:
        return False
    made = plan(batch, operands) or plan(
        batch, tuple(in_one_piece(a, (*batch, a.shape[-1])) for a in operands)
    )
    if made is None:
        raise AssertionError("arrays in one piece have constant strides")
    kinds = tuple(
        (a.shape[-1], a.dtype.char, s[0], s[2])
        for a, s in zip(made.operands, made.strides, strict=True)
    )
    kernel = _kernel(name, kinds, out is not None)
    if kernel is None:
        return twins.run(name, read, out)
    table = (ctypes.c_int64 * (2 + 4 * len(operands)))(made.outer, made.inner, *made.table)
    pieces = made.outer * made.inner // grain + 1
    alive = (made.operands, table)
    answer = share(kernel, pieces, alive, ctypes.addressof(table))
    if out is not None and made.operands[-1] is not out:
        out[...] = made.operands[-1]
    return answer


@cache
def _kernel(
    name: tuple[Any, ...], kinds: tuple[Kind, ...], writes: bool
) -> machine_code.Function | None:
    """Return the loop of a kernel, or None where there can be no machine code.

    ``kinds`` are, operand by operand, how many components there are, numpy's letter for their type, and
    the strides in bytes from one component to the next and from one row to the next.
    """
    if not machine_code.available():
        return None
    operands = [_operand(*kind) for kind in kinds]
    if writes and operands[-1].way is Way.SAME:  # a batch of one
        operands[-1] = operands[-1]._replace(way=Way.STRIDED)
    return _loop(name, tuple(operands), writes)


@cache
def _loop(
    name: tuple[Any, ...], operands: tuple[Operand, ...], writes: bool
) -> machine_code.Function:
    with machine_code.lock:
        from rotation.kernels import formulas

        builtins.register_symbols()
        found = formulas.kernel(*name)
        number = operands[0].number if name[0] == "one" else "double"
        text = strided_loop(found.fast, found.careful, operands, int(writes), number)
        return machine_code.function(machine_code.compiled(text, "entry", announce=_announce))


def _operand(width: int, letter: str, component: int, row: int) -> Operand:
    operand = Operand(width, _NUMBERS[letter], Way.STRIDED)
    size = operand.size
    if row == 0:
        way = Way.SAME
    elif row == width * size and (component == size or width == 1):
        way = Way.SIDE_BY_SIDE
    elif row == size:
        way = Way.COLUMNS
    else:
        way = Way.STRIDED
    return operand._replace(way=way)
