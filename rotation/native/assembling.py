"""From a formula to a function of Python: its trace is put into a loop over rows, compiled by LLVM.

The function is a builtin, as those of extensions in C are: it reads the addresses and the lengths of
numpy's arrays from their headers, whose layout numpy's ABI fixes. It answers 0 when all is done; 1 where the
arrays are not such as it reads (C order, aligned, rows that fit); 2 when all is done and the formula had
something to `tell`. Long work frees the interpreter lock.
"""

import ctypes
import os
import sys
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from hfield.compiling import machine_code
from rotation.native import elementary_functions, tracing
from rotation.native.looping import DATA, FLAGS, FRAME, LENGTHS, NDIM, USABLE, loop
from rotation.native.symbols import WIDTH, Lanes, Program, Rows

AHEAD = 4  # blocks, whose memory is asked for to be written and so is not fetched twice

Function = Callable[..., int]


class _Method(ctypes.Structure):
    """CPython's PyMethodDef."""

    _fields_ = (
        ("name", ctypes.c_char_p),
        ("address", ctypes.c_void_p),
        ("flags", ctypes.c_int),
        ("doc", ctypes.c_char_p),
    )


@cache
def available() -> bool:
    """Tell whether this interpreter and its numpy are such as the machine code expects."""
    if sys.implementation.name != "cpython" or sys.maxsize < 2**62:
        return False
    if not machine_code.available():
        return False
    probe = np.zeros((3, 5))

    def read(offset: int, kind: Any) -> int:
        return int(kind.from_address(id(probe) + offset).value)

    address = probe.__array_interface__["data"][0]
    lengths = read(LENGTHS, ctypes.c_size_t)
    return (
        read(DATA, ctypes.c_size_t) == address
        and read(NDIM, ctypes.c_int) == 2
        and [ctypes.c_ssize_t.from_address(lengths + 8 * n).value for n in (0, 1)] == [3, 5]
        and read(FLAGS, ctypes.c_int) & USABLE == USABLE
    )


@cache
def introduce() -> None:
    """Make the functions of the system and of Python known to programs; the caller holds the lock."""
    system = ctypes.CDLL(None) if os.name == "posix" else ctypes.CDLL("ucrtbase")
    for name in elementary_functions.LIBRARY:
        machine_code.introduce(f"rotation_{name}", _address(getattr(system, name)))
    for name in ("PyLong_FromLong", "PyEval_SaveThread", "PyEval_RestoreThread"):
        machine_code.introduce(name, _address(getattr(ctypes.pythonapi, name)))
    if not machine_code.processor_has("fma") and "fma" in vars(tracing):
        del tracing.fma


def _address(function: Any) -> int:
    return ctypes.cast(function, ctypes.c_void_p).value or 0


def assembled(
    formula: Callable[..., Any],
    shapes: tuple[tuple[int, ...], ...],
    parameters: tuple[Any, ...],
    single: tuple[int, ...] = (),
) -> tuple[Function, tuple[int, ...]]:
    """Return the function ``f(*arrays, out)`` that fills ``out`` with ``formula(*arrays, *parameters)``.

    Second comes the shape of a row of ``out``.

    Parameters
    ----------
    shapes : tuple of shapes
        Of one row of each array.
    single : tuple of int
        Which of the arrays have but one row, the same for all rows of the others.
    """
    with machine_code.lock:
        introduce()
        text, row = _module(formula, shapes, parameters, single)
        address = machine_code.compiled(text, "entry")
    method = _Method(formula.__name__.encode(), address, 0x0080, None)  # METH_FASTCALL
    make = ctypes.pythonapi.PyCFunction_NewEx
    make.restype = ctypes.py_object
    make.argtypes = (ctypes.c_void_p, ctypes.py_object, ctypes.c_void_p)
    return make(ctypes.addressof(method), method, None), row  # it keeps its ``self`` alive


def _flat(values: Any) -> list[Any]:
    return [x for v in values for x in _flat(v)] if isinstance(values, tuple) else [values]


def _module(
    formula: Any,
    shapes: tuple[tuple[int, ...], ...],
    parameters: tuple[Any, ...],
    single: tuple[int, ...],
) -> tuple[str, tuple[int, ...]]:
    """Write the whole program, the loop over blocks of eight rows with the formula in it; and its shape."""
    sizes = [int(np.prod(shape)) for shape in shapes]
    program = Program()
    arguments = []
    for number, (shape, size) in enumerate(zip(shapes, sizes, strict=True)):
        if number in single:
            columns = [_spread(program, f"%in{number}", n) for n in range(size)]
            arguments.append(Rows(shape, [Lanes(program, name) for name in columns]))
            continue
        kind = f"<{size * WIDTH} x double>"
        whole = program.value(f"load {kind}, ptr %in{number}, align 8")
        columns = [
            program.shuffled(kind, whole, "poison", range(n, size * WIDTH, size))
            for n in range(size)
        ]
        arguments.append(Rows(shape, [Lanes(program, name) for name in columns]))
    answer = formula(*arguments, *parameters)
    results = _flat(answer)
    width = len(results)
    names = [program.name_of(r) for r in results]
    _store(program, names)
    said = "i1 false"
    if program.told:
        bits = f"<{WIDTH} x i1>"
        some = program.told[0]
        for other in program.told[1:]:
            some = program.value(f"or {bits} {some}, {other}")
        said = "i1 " + program.some(some)
    inner = "\n".join(program.lines)
    pointers = ", ".join(f"ptr noalias %in{n}" for n in range(len(sizes)))
    text = "\n".join(
        [
            *elementary_functions.of_the_system(elementary_functions.LIBRARY),
            "declare void @llvm.prefetch.p0(ptr, i32, i32, i32)",
            *elementary_functions.intrinsics("double", WIDTH),
            FRAME,
            f"define internal i1 @block({pointers}, ptr noalias %out) alwaysinline {{",
            "start:",
            inner,
            f"ret {said}",
            "}",
            loop(sizes, width, single),
        ]
    )
    return text, _shape(answer)


def _spread(program: Program, pointer: str, n: int) -> str:
    """Add the reading of one number into every row."""
    at = program.value(f"getelementptr double, ptr {pointer}, i64 {n}")
    return program.spread(at, "double", 8)


def _shape(values: Any) -> tuple[int, ...]:
    return (len(values), *_shape(values[0])) if isinstance(values, tuple) else ()


def _store(program: Program, names: list[str]) -> None:
    """Write the columns as rows, one after the other: eights of them by themselves, then the rest."""
    width = len(names)
    whole = width - width % WIDTH if width >= WIDTH else 0
    if whole:
        for line in range(width):
            place = AHEAD * width + line
            at = program.value(f"getelementptr {program.kind}, ptr %out, i64 {place}")
            program.lines.append(f"call void @llvm.prefetch.p0(ptr {at}, i32 1, i32 3, i32 1)")
    for first in range(0, whole, WIDTH):
        for row, name in enumerate(_transposed(program, names[first : first + WIDTH])):
            at = program.value(f"getelementptr double, ptr %out, i64 {row * width + first}")
            program.lines.append(f"store {program.kind} {name}, ptr {at}, align 8")
    if not whole:
        _store_few(program, names)
        return
    for k in range(whole, width):
        for row in range(WIDTH):
            at = program.value(f"getelementptr double, ptr %out, i64 {row * width + k}")
            one = program.value(f"extractelement {program.kind} {names[k]}, i32 {row}")
            program.lines.append(f"store double {one}, ptr {at}, align 8")


def _transposed(program: Program, columns: list[str]) -> list[str]:
    """Return eight rows of eight columns, by exchanging halves, quarters and eighths."""
    v, kind = list(columns), program.kind
    for d in (1, 2, 4):
        for i in range(WIDTH):
            if i & d:
                continue
            a, b = v[i], v[i + d]
            upper = (n + WIDTH - d if n & d else n for n in range(WIDTH))
            lower = (n + WIDTH if n & d else n + d for n in range(WIDTH))
            v[i], v[i + d] = (program.shuffled(kind, a, b, half) for half in (upper, lower))
    return v


def _store_few(program: Program, names: list[str]) -> None:
    """Write fewer than eight columns in one piece."""
    width = len(names)
    parts = [(f"<{WIDTH} x double>", n, WIDTH) for n in names]
    while len(parts) > 1:  # joined in pairs; the last one may stay over
        joined = []
        for (_, a, length), (_, b, other) in zip(parts[::2], parts[1::2], strict=False):
            kind = f"<{length} x double>"
            if other < length:
                filled = (n if n < other else 0 for n in range(length))
                b = program.shuffled(f"<{other} x double>", b, "poison", filled)
            whole = program.shuffled(kind, a, b, range(length + other))
            joined.append((f"<{length + other} x double>", whole, length + other))
        if len(parts) % 2:
            joined.append(parts[-1])
        parts = joined
    ((kind, whole, length),) = parts
    order = [c * WIDTH + r for r in range(WIDTH) for c in range(width)]
    rows = program.shuffled(kind, whole, "poison", order)
    program.lines.append(f"store {kind} {rows}, ptr %out, align 8")
