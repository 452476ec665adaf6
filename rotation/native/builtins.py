"""A formula as a builtin function of Python: its trace is put into a loop over rows, compiled by LLVM.

The function is one as those of extensions in C are: it reads the addresses and the lengths of numpy's arrays
from their headers, whose layout numpy's ABI fixes. That is why it has a loop of its own: a call for one
rotation takes less time than Python needs to look at its arrays. It answers 0 when all is done; 1 where the
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
from hfield.compiling.instructions import Code, module, vector
from rotation.native import tracing
from rotation.native.symbols import LIBRARY, WIDTH, Lanes, Program, Rows

AHEAD = 4  # blocks, whose memory is asked for to be written and so is not fetched twice
FREE = 2048  # rows for which it pays to free the interpreter lock
_HEAD = object.__basicsize__
DATA, NDIM, LENGTHS, FLAGS = (_HEAD + n for n in (0, 8, 16, 48))  # where numpy's header has them
USABLE = 0x0001 | 0x0100  # C order, aligned
BYTES = {"double": 8, "float": 4}
HALVES = vector("float", WIDTH)

Function = Callable[..., int]
Shape = tuple[int, ...]


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
    for name in LIBRARY:
        machine_code.introduce(f"rotation_{name}", _address(getattr(system, name)))
    for name in ("PyLong_FromLong", "PyEval_SaveThread", "PyEval_RestoreThread"):
        machine_code.introduce(name, _address(getattr(ctypes.pythonapi, name)))
    if not machine_code.processor_has("fma") and "fma" in vars(tracing):
        del tracing.fma


def _address(function: Any) -> int:
    return ctypes.cast(function, ctypes.c_void_p).value or 0


def assembled(
    formula: Callable[..., Any],
    shapes: tuple[Shape, ...],
    parameters: tuple[Any, ...],
    single: tuple[int, ...],
    words: tuple[str, ...],
) -> tuple[Function, Shape, int]:
    """Return the function ``f(*arrays, out)`` that fills ``out`` with ``formula(*arrays, *parameters)``.

    Second comes the shape of a row of ``out``, third how many steps eight rows take.

    Parameters
    ----------
    shapes : tuple of shapes
        Of one row of each array.
    single : tuple of int
        Which of the arrays have but one row, the same for all rows of the others.
    words : tuple of str
        LLVM's word for the numbers of each array, and last of the result: ``double`` or ``float``. All is
        computed in double.
    """
    with machine_code.lock:
        introduce()
        block, row = _block(formula, shapes, parameters, single, words)
        sizes = [int(np.prod(shape)) for shape in (*shapes, row)]
        text = module(block, _elements(), _entry(sizes, single, words))
        address = machine_code.compiled(text, "entry")
    method = _Method(formula.__name__.encode(), address, 0x0080, None)  # METH_FASTCALL
    make = ctypes.pythonapi.PyCFunction_NewEx
    make.restype = ctypes.py_object
    make.argtypes = (ctypes.c_void_p, ctypes.py_object, ctypes.c_void_p)
    function = make(ctypes.addressof(method), method, None)  # it keeps its ``self`` alive
    return function, row, len(block.lines)


# --- eight rows ----------------------------------------------------------------------------------


def _block(
    formula: Any,
    shapes: tuple[Shape, ...],
    parameters: tuple[Any, ...],
    single: tuple[int, ...],
    words: tuple[str, ...],
) -> tuple[Program, Shape]:
    """Write the formula for eight rows in one piece; return that, and the shape of a row of the result."""
    pointers = ", ".join(f"ptr noalias %in{n}" for n in range(len(shapes)))
    program = Program(f"internal i1 @block({pointers}, ptr noalias %out) alwaysinline")
    arguments = []
    for number, shape in enumerate(shapes):
        size, pointer, word = int(np.prod(shape)), f"%in{number}", words[number]
        if number in single:
            numbers = (
                program.load(word, program.at(word, pointer, n), BYTES[word]) for n in range(size)
            )
            columns = [program.spread(word, x, WIDTH) for x in numbers]
        else:
            kind = vector(word, size * WIDTH)
            whole = program.load(kind, pointer, BYTES[word])
            columns = [
                program.shuffled(kind, whole, "poison", range(n, size * WIDTH, size))
                for n in range(size)
            ]
        if word == "float":
            columns = [program.value(f"fpext {HALVES} {x} to {program.kind}") for x in columns]
        rows = Rows(shape, [Lanes(program, x) for x in columns], np.dtype(f"f{BYTES[word]}"))
        arguments.append(rows)
    answer = formula(*arguments, *parameters)
    names = [program.name_of(r) for r in _flat(answer)]
    if words[-1] == "float":
        names = [program.value(f"fptrunc {program.kind} {x} to {HALVES}") for x in names]
    _store(program, names, words[-1])
    told = "false"
    for condition in program.told:
        told = program.value(f"or i1 {told}, {program.some(condition)}")
    program.end(f"i1 {told}")
    return program, _shape(answer)


def _flat(values: Any) -> list[Any]:
    return [x for v in values for x in _flat(v)] if isinstance(values, tuple) else [values]


def _shape(values: Any) -> Shape:
    return (len(values), *_shape(values[0])) if isinstance(values, tuple) else ()


def _store(program: Program, names: list[str], word: str) -> None:
    """Write the columns as rows, one after the other: eights of them by themselves, then the rest."""
    width, size, kind = len(names), BYTES[word], vector(word, WIDTH)
    whole = width - width % WIDTH if width >= WIDTH else 0
    if not whole:
        _store_few(program, names, word)
        return
    lines = width * size // 8
    for line in range(lines):
        program.ahead(program.at("[64 x i8]", "%out", AHEAD * lines + line), writing=True)
    for first in range(0, whole, WIDTH):
        for row, name in enumerate(_transposed(program, names[first : first + WIDTH], kind)):
            program.store(kind, name, program.at(word, "%out", row * width + first), size)
    for k in range(whole, width):
        for row in range(WIDTH):
            one = program.value(f"extractelement {kind} {names[k]}, i32 {row}")
            program.store(word, one, program.at(word, "%out", row * width + k), size)


def _transposed(program: Program, columns: list[str], kind: str) -> list[str]:
    """Return eight rows of eight columns, by exchanging halves, quarters and eighths."""
    v = list(columns)
    for d in (1, 2, 4):
        for i in range(WIDTH):
            if i & d:
                continue
            a, b = v[i], v[i + d]
            upper = (n + WIDTH - d if n & d else n for n in range(WIDTH))
            lower = (n + WIDTH if n & d else n + d for n in range(WIDTH))
            v[i], v[i + d] = (program.shuffled(kind, a, b, half) for half in (upper, lower))
    return v


def _store_few(program: Program, names: list[str], word: str) -> None:
    """Write fewer than eight columns in one piece."""
    width = len(names)
    parts = [(n, WIDTH) for n in names]
    while len(parts) > 1:  # joined in pairs; the last one may stay over
        joined = []
        for (a, length), (b, other) in zip(parts[::2], parts[1::2], strict=False):
            if other < length:
                filled = (n if n < other else 0 for n in range(length))
                b = program.shuffled(vector(word, other), b, "poison", filled)
            whole = program.shuffled(vector(word, length), a, b, range(length + other))
            joined.append((whole, length + other))
        if len(parts) % 2:
            joined.append(parts[-1])
        parts = joined
    ((whole, length),) = parts
    order = [c * WIDTH + r for r in range(WIDTH) for c in range(width)]
    kind = vector(word, length)
    program.store(kind, program.shuffled(kind, whole, "poison", order), "%out", BYTES[word])


# --- all rows ------------------------------------------------------------------------------------


def _elements() -> Code:
    """Write the function that tells how many numbers an array has."""
    code = Code("internal i64 @elements(ptr %array)")
    dimensions = code.load("i32", code.at("i8", "%array", NDIM))
    lengths = code.load("ptr", code.at("i8", "%array", LENGTHS))

    def length(i: str, size: str) -> list[str]:
        return [code.value(f"mul i64 {size}, {code.load('i64', code.at('i64', lengths, i))}")]

    count = code.value(f"sext i32 {dimensions} to i64")
    (size,) = code.loop("0", count, length, first=[("i64", "1")])
    code.end(f"i64 {size}")
    return code


def _entry(sizes: list[int], single: tuple[int, ...], words: tuple[str, ...]) -> Code:
    """Write the builtin: it reads the arrays' headers and runs through blocks of eight rows.

    The rows left over at the end go through a buffer, as does the one row of an array that is the same
    for all, but of those that always have one row: the block itself spreads them.
    """
    code = Code("ptr @entry(ptr %self, ptr %args, i64 %nargs)")
    v = code.value
    bytes_of = [n * BYTES[word] for n, word in zip(sizes, words, strict=True)]  # of one row
    arrays = code.entries("ptr", "%args", len(sizes))
    data = [code.load("ptr", code.at("i8", array, DATA)) for array in arrays]
    moving = [n for n in range(len(sizes) - 1) if n not in single]
    buffers = [code.room(vector(w, n * WIDTH)) for n, w in zip(sizes, words, strict=True)]
    counts = [
        v(f"sdiv i64 {code.once(f'call i64 @elements(ptr {array})')}, {size}")
        for array, size in zip(arrays, sizes, strict=True)
    ]
    bits = [code.load("i32", code.at("i8", array, FLAGS)) for array in arrays]
    usable = [v(f"icmp eq i32 {v(f'and i32 {b}, {USABLE}')}, {USABLE}") for b in bits]
    rows, good, moves = counts[-1], usable[-1], list[str]()
    for n in range(len(sizes) - 1):
        moves.append(v(f"icmp eq i64 {counts[n]}, {rows}"))
        one = v(f"icmp eq i64 {counts[n]}, 1")
        fits = one if n in single else v(f"or i1 {moves[n]}, {one}")
        good = v(f"and i1 {good}, {v(f'and i1 {fits}, {usable[n]}')}")
    fixed = [v(f"xor i1 {same}, true") for same in moves]

    def number(x: str) -> str:
        return f"ptr {code.call('ptr', 'PyLong_FromLong', ('i64', x))}"

    code.leave(v(f"xor i1 {good}, true"), lambda: number("1"))

    def spread(n: int, start: str) -> None:
        for row in range(WIDTH):
            code.copy(code.at("i8", buffers[n], row * bytes_of[n]), start, bytes_of[n])

    for n in moving:
        code.when(fixed[n], lambda n=n: spread(n, data[n]))  # type: ignore[misc]
    long = v(f"icmp sge i64 {rows}, {FREE}")
    (state,) = code.when(long, lambda: [("ptr", code.call("ptr", "PyEval_SaveThread"), "null")])

    def turn(i: str, told: str) -> list[str]:
        left = v(f"sub i64 {rows}, {i}")
        full = v(f"icmp sge i64 {left}, {WIDTH}")
        few = v(f"xor i1 {full}, true")
        here = [code.at("i8", data[n], v(f"mul i64 {i}, {bytes_of[n]}")) for n in moving]

        def filled(n: int, start: str) -> None:
            spread(n, start)  # so that no row of the buffer is what nobody wrote
            code.copy(buffers[n], start, v(f"mul i64 {left}, {bytes_of[n]}"))

        def partly() -> None:
            for n, start in zip(moving, here, strict=True):
                code.when(moves[n], lambda n=n, s=start: filled(n, s))  # type: ignore[misc]

        code.when(few, partly)
        sources = list(data[:-1])
        for n, start in zip(moving, here, strict=True):
            row = v(f"select i1 {full}, ptr {start}, ptr {buffers[n]}")
            sources[n] = v(f"select i1 {fixed[n]}, ptr {buffers[n]}, ptr {row}")
        there = code.at("i8", data[-1], v(f"mul i64 {i}, {bytes_of[-1]}"))
        target = v(f"select i1 {full}, ptr {there}, ptr {buffers[-1]}")
        given = ", ".join(f"ptr {x}" for x in (*sources, target))
        told = v(f"or i1 {told}, {code.once(f'call i1 @block({given})')}")
        code.when(few, lambda: code.copy(there, buffers[-1], v(f"mul i64 {left}, {bytes_of[-1]}")))
        return [told]

    (told,) = code.loop("0", rows, turn, WIDTH, [("i1", "false")])
    code.when(long, lambda: code.call("void", "PyEval_RestoreThread", ("ptr", state)))
    code.end(number(v(f"select i1 {told}, i64 2, i64 0")))
    return code
