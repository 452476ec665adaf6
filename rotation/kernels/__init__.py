"""The loops that rotate many points, and the threads that share them.

Every function takes arrays with the components last, with any strides; their batches broadcast to that of
``out``, which may be the points themselves. Only zero axes and zero quaternions are checked here, because the
loop detects them at no cost. A loop is compiled for the memory layout of its arrays on first use, which takes
some hundredths of a second.
"""

import ctypes
from functools import cache

import numpy as np

from hfield.compiling import machine_code
from hfield.compiling.memory import address, in_one_piece
from hfield.compiling.threads import share
from rotation.array_types import Array
from rotation.kernels import numpy_kernels
from rotation.kernels.numpy_kernels import Name
from rotation.kernels.strides import walk
from rotation.native import builtins
from rotation.native.strided_loop import OperandLayout, RowLayout, strided_loop
from rotation.thread_count import threads

__all__ = ["axis_angle", "contains_zero", "cumulative", "euler", "one", "quaternions", "threads"]

# With fewer points per thread, waking a thread takes longer than its share of the work.
LIGHT, HEAVY = 100_000, 8_000

Kind = tuple[int, str, int, int]
_NUMBERS = {"d": "double", "f": "float"}
_announce = machine_code.Announcer(
    "rotation: compiling a loop for many points, once on this machine "
    "(rotation.warm_up() does it beforehand)"
)


def one(points: Array, matrix: Array, out: Array) -> None:
    """Rotate all points by one matrix ``(3, 3)``."""
    _run(("one",), LIGHT, points, matrix.astype(points.dtype).reshape(9), out=out)


def axis_angle(points: Array, axis: Array, angle: Array, out: Array, degrees: bool = False) -> bool:
    """Rotate points about individual axes by individual angles; return whether an axis was zero."""
    name = ("axis_angle", degrees, out.dtype == np.float32)
    return _run(name, HEAVY, points, axis, angle[..., None], out=out)


def quaternions(points: Array, q: Array, out: Array) -> bool:
    """Rotate points by individual quaternions of any length; return whether one was zero."""
    return _run(("quaternions", out.dtype == np.float32), HEAVY, points, q, out=out)


def euler(
    points: Array,
    angles: Array,
    axes: tuple[int, ...],
    backward: bool,
    out: Array,
    degrees: bool = False,
) -> None:
    """Rotate points about coordinate axes, in that order, by individual angles ``(…, len(axes))``.

    The first axis takes the last angle if ``backward``, else the first.
    """
    _run(("euler", axes, backward, degrees), HEAVY, points, angles, out=out)


def contains_zero(array: Array) -> bool:
    """Return whether a row has only zero components."""
    return _run(("contains_zero",), LIGHT, array)


def cumulative(q: Array) -> Array:
    """Return ``q[0]``, ``q[1]·q[0]``, ``q[2]·q[1]·q[0]``, … for ``q`` of shape ``(N, 4)``, normalised.

    The running product is kept in twice the precision, so errors do not accumulate over its length.
    """
    with machine_code.lock:
        from rotation.kernels import chains

    return chains.cumulative(np.ascontiguousarray(q, np.float64))


def _run(
    name: Name, grain: int, points: Array, *parameters: Array, out: Array | None = None
) -> bool:
    """Run a kernel on points and parameters of one type: float64 if any of them is float64."""
    target = points if out is None else out
    batch = target.shape[:-1]
    if target.size == 0:
        return False
    kind = np.result_type(points, *parameters)
    parameters = tuple(a.astype(kind, copy=False) for a in parameters)
    arrays = (points, *parameters) if out is None else (points, *parameters, out)
    way = None
    if all(a.flags.aligned for a in arrays):
        way = walk(batch, tuple((a.shape, a.strides) for a in arrays))
    if way is None:
        arrays = tuple(in_one_piece(a, (*batch, a.shape[-1])) for a in arrays)
        way = walk(batch, tuple((a.shape, a.strides) for a in arrays))
    if way is None:
        raise AssertionError("arrays in one piece have constant strides")
    table, kinds = [way.outer, way.inner], list[Kind]()
    for a, strides in zip(arrays, way.strides, strict=True):
        table += (address(a), *strides)
        kinds.append((a.shape[-1], a.dtype.char, strides[0], strides[2]))
    kernel = _kernel(name, tuple(kinds), out is not None)
    if kernel is None:
        return numpy_kernels.run(name, (points, *parameters), out)
    words = (ctypes.c_int64 * len(table))(*table)
    pieces = way.outer * way.inner // grain + 1
    answer = share(kernel, pieces, (arrays, words), ctypes.addressof(words))
    if out is not None and arrays[-1] is not out:
        out[...] = arrays[-1]
    return answer


@cache
def _kernel(name: Name, kinds: tuple[Kind, ...], writes: bool) -> machine_code.Function | None:
    """Return the loop of a kernel, or None if machine code is not available.

    ``kinds`` lists for each operand the number of components, numpy's letter for the type, and the strides in
    bytes between components and between rows.
    """
    if not machine_code.available():
        return None
    operands = [_operand(*kind) for kind in kinds]
    if writes and operands[-1].way is RowLayout.SAME:  # a batch of one
        operands[-1] = operands[-1]._replace(way=RowLayout.STRIDED)
    return _loop(name, tuple(operands), writes)


@cache
def _loop(name: Name, operands: tuple[OperandLayout, ...], writes: bool) -> machine_code.Function:
    with machine_code.lock:
        from rotation.kernels import formulas

        builtins.register_symbols()
        found = formulas.kernel(*name)
        number = operands[0].number if name[0] == "one" else "double"
        text = strided_loop(found.fast, found.careful, operands, int(writes), number)
        return machine_code.function(machine_code.compiled(text, "entry", announce=_announce))


def _operand(width: int, letter: str, component: int, row: int) -> OperandLayout:
    operand = OperandLayout(width, _NUMBERS[letter], RowLayout.STRIDED)
    size = operand.size
    if row == 0:
        way = RowLayout.SAME
    elif row == width * size and (component == size or width == 1):
        way = RowLayout.SIDE_BY_SIDE
    elif row == size:
        way = RowLayout.COLUMNS
    else:
        way = RowLayout.STRIDED
    return operand._replace(way=way)
