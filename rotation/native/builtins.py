"""Compile the trace of a formula, in a loop over rows, to a builtin function of Python, with LLVM.

The function is like those of C extensions. It reads the addresses and lengths of numpy arrays from their
headers, whose layout is fixed by numpy's ABI. It lets numpy allocate the result and wraps this in an object.
So a call with one rotation takes less time than Python code needs to inspect the arrays. Long computations
release the interpreter lock.
"""

import ctypes
import os
import sys
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple, Protocol, TypeAlias, TypeVar, cast, overload

import numpy as np

from hfield.compiling import machine_code
from hfield.compiling.instructions import Code, module, vector
from rotation.array_types import Array
from rotation.native import tracing
from rotation.native.entry import (
    DATA,
    DTYPE,
    FLAGS,
    HEAD,
    KIND,
    LENGTHS,
    NDIM,
    USABLE,
    WRITEABLE,
    Entry,
    Shape,
    alike,
    product,
)
from rotation.native.symbols import LIBRARY, WIDTH, Lanes, RowFunction, Rows

AHEAD = 4  # blocks: their memory is prefetched for writing, so that it is not fetched twice
PREFETCHED_BLOCKS = 8  # blocks: their memory is prefetched for reading while numbers are computed
FREE = 2048  # rows for which it pays to free the interpreter lock
BYTES = {"double": 8, "float": 4}
NUMPY = {"PyArray_New": 93, "PyArray_Return": 76}  # the places in its table of functions
HALVES = vector("float", WIDTH)

K = TypeVar("K")


class BuiltinFunction(Protocol):
    """A compiled function of arrays; None if it computes nothing."""

    @overload
    def __call__(self, where: None, /, *arrays: object) -> Array | None: ...
    @overload
    def __call__(self, where: type[K], /, *arrays: object) -> K | None: ...
    @overload
    def __call__(self, where: Array, /, *arrays: object) -> bool | None: ...


Values: TypeAlias = "Lanes | float | tuple[Values, ...]"


_Known: Any = ctypes.py_object * 6


class _Method(ctypes.Structure):
    """CPython's PyMethodDef, followed by the data of an `Entry`."""

    _fields_ = (
        ("name", ctypes.c_char_p),
        ("address", ctypes.c_void_p),
        ("flags", ctypes.c_int),
        ("doc", ctypes.c_char_p),
        ("known", _Known),
    )


@cache
def available() -> bool:
    """Return whether this interpreter and its numpy have the memory layout that the machine code expects."""
    if sys.implementation.name != "cpython" or sys.maxsize < 2**62:
        return False
    if not machine_code.available():
        return False
    probe, number = np.zeros((3, 5)), 0.75

    def read(offset: int, kind: type[ctypes.c_size_t] | type[ctypes.c_int]) -> int:
        return int(kind.from_address(id(probe) + offset).value)

    address = probe.__array_interface__["data"][0]
    lengths = read(LENGTHS, ctypes.c_size_t)
    flags = USABLE | WRITEABLE
    return (
        read(KIND, ctypes.c_size_t) == id(np.ndarray)
        and read(DATA, ctypes.c_size_t) == address
        and read(NDIM, ctypes.c_int) == 2
        and [ctypes.c_ssize_t.from_address(lengths + 8 * n).value for n in (0, 1)] == [3, 5]
        and read(DTYPE, ctypes.c_size_t) == id(probe.dtype)
        and read(FLAGS, ctypes.c_int) & flags == flags
        and ctypes.c_double.from_address(id(number) + HEAD).value == number
    )


def _place(slot: object) -> int:
    """Return the offset in bytes of a slot in an object, from its descriptor."""
    described = ctypes.c_void_p.from_address(id(slot) + HEAD + 24).value or 0
    return int(ctypes.c_ssize_t.from_address(described + 16).value)


@cache
def register_symbols() -> None:
    """Register functions of the system and of Python for compiled programs; the caller must hold the lock."""
    system = ctypes.CDLL(None) if os.name == "posix" else ctypes.CDLL("ucrtbase")
    for name in LIBRARY:
        machine_code.register_symbols(f"rotation_{name}", _address(getattr(system, name)))
    python = ("PyBool_FromLong", "PyType_GenericAlloc", "Py_IncRef", "Py_DecRef")
    for name in (*python, "PyEval_SaveThread", "PyEval_RestoreThread"):
        machine_code.register_symbols(name, _address(getattr(ctypes.pythonapi, name)))
    opened = ctypes.pythonapi.PyCapsule_GetPointer
    opened.restype, opened.argtypes = ctypes.c_void_p, (ctypes.py_object, ctypes.c_char_p)
    table = opened(np._core._multiarray_umath._ARRAY_API, None)  # type: ignore[attr-defined]
    for name, number in NUMPY.items():
        address = ctypes.c_void_p.from_address(table + 8 * number).value
        machine_code.register_symbols(name, address or 0)
    if not machine_code.processor_has("fma") and "fma" in vars(tracing):
        del tracing.fma


def _address(function: Any) -> int:
    return ctypes.cast(function, ctypes.c_void_p).value or 0


def compile_builtin(
    formula: Callable[..., Array],
    shapes: tuple[Shape, ...],
    parameters: tuple[object, ...],
    single: tuple[int, ...],
    words: tuple[str, ...],
    slot: object,
) -> tuple[BuiltinFunction, Shape, int]:
    """Return a function ``f(where, *arrays)`` that computes ``formula(*arrays, *parameters)``.

    ``where`` is None for a new array, an array to be filled, or a class for a new object that holds the
    result read-only. For None and for a class, the function returns None instead of a result in three cases:
    an array is unsuitable, the result has more than `MUCH` numbers, or the formula flagged a row. Suitable
    arrays are numpy's, of the given types, in C order and aligned, each with the same batch or with one row
    and no batch; a Python float counts as an array without axes. An array ``where`` is filled whatever its
    size, and the function returns whether a row was flagged.

    The other results are the shape of a row of the result, and the number of steps for eight rows.

    Parameters
    ----------
    shapes : tuple of shapes
        Of one row of each array.
    single : tuple of int
        Which of the arrays have but one row, the same for all rows of the others.
    words : tuple of str
        LLVM's word for the numbers of each array, and last of the result: ``double`` or ``float``. All is
        computed in double.
    slot : descriptor
        What holds the array in an object of a class.
    """
    with machine_code.lock:
        register_symbols()
        block, row = _block(formula, shapes, parameters, single, words)
        whole = (*shapes, row)
        moving = [n for n in range(len(shapes)) if n not in single]
        entry = Entry(whole, moving, words, _place(slot))
        text = module(block, product(), alike(), _rows(whole, moving, words), entry)
        address = machine_code.compiled(text, "entry")
    one = np.zeros(())  # represents a Python float, whose number is stored elsewhere
    things = (np.ndarray, float, None, one, np.dtype(np.float64), np.dtype(np.float32))
    name = formula.__name__.encode()
    method = _Method(name, address, 0x0080, None, _Known(*things))  # METH_FASTCALL
    make = ctypes.pythonapi.PyCFunction_NewEx
    make.restype = ctypes.py_object
    make.argtypes = (ctypes.c_void_p, ctypes.py_object, ctypes.c_void_p)
    own = np.frombuffer(method, np.uint8)  # type: ignore[call-overload]  # programs read arrays
    function = make(ctypes.addressof(method), own, None)  # it keeps its ``self`` alive
    return function, row, len(block.lines)


# --- eight rows ----------------------------------------------------------------------------------


def _block(
    formula: Callable[..., Array],
    shapes: tuple[Shape, ...],
    parameters: tuple[object, ...],
    single: tuple[int, ...],
    words: tuple[str, ...],
) -> tuple[RowFunction, Shape]:
    """Write the formula for eight rows as a single block; return the block and the shape of a row of the
    result.
    """
    pointers = ", ".join(f"ptr noalias %in{n}" for n in range(len(shapes)))
    program = RowFunction(f"internal i1 @block({pointers}, ptr noalias %out) alwaysinline")
    for n, (shape, word) in enumerate(zip(shapes, words, strict=False)):
        if n not in single:
            size = int(np.prod(shape)) * BYTES[word]
            _ask_ahead(program, f"%in{n}", size, PREFETCHED_BLOCKS)
    prefetches = len(program.lines)
    arguments, parted = [], list[_Parted]()
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
            parted.append(_Parted(word, whole, columns))
        if word == "float":
            columns = [program.value(f"fpext {HALVES} {x} to {program.kind}") for x in columns]
        rows = Rows(shape, [Lanes(program, x) for x in columns], np.dtype(f"f{BYTES[word]}"))
        arguments.append(rows)
    answer = cast(Values, formula(*arguments, *parameters))  # of symbols, symbols
    names = [program.name_of(r) for r in _flat(answer)]
    if words[-1] == "float":
        names = [program.value(f"fptrunc {program.kind} {x} to {HALVES}") for x in names]
    moved = next(filter(None, (_rearranged(program, p, names) for p in parted)), None)
    if moved is not None and len(names) < WIDTH:
        del program.lines[:prefetches]  # so fast that they would take a tenth of its time
        _store_rows(program, moved, len(names), words[-1])
    else:
        _store(program, names, words[-1])
    flag = "false"
    for condition in program.conditions:
        flag = program.value(f"or i1 {flag}, {program.some(condition)}")
    program.end(f"i1 {flag}")
    return program, _shape(answer)


class _Parted(NamedTuple):
    """Eight rows of an array: one vector of all their numbers, and the columns into which it is split."""

    word: str
    whole: str
    columns: list[str]


def _rearranged(program: RowFunction, rows: _Parted, names: list[str]) -> str | None:
    """Return eight rows of values that are columns of an array or their negatives, else None.

    Numbers change places and signs within the single vector, without splitting it into columns.
    """
    own = [program.opposites.get(name, name) for name in names]
    if rows.word != "double" or not set(own) <= set(rows.columns):
        return None
    width = len(rows.columns)
    size = width * WIDTH
    kind = vector("double", size)
    negative = program.value(f"fneg {kind} {rows.whole}") if own != names else "poison"
    places = (
        row * width + rows.columns.index(o) + (size if o != name else 0)
        for row in range(WIDTH)
        for o, name in zip(own, names, strict=True)
    )
    return program.shuffled(kind, rows.whole, negative, places)


def _ask_ahead(
    program: RowFunction, start: str, size: int, blocks: int, writing: bool = False
) -> None:
    """Prefetch the memory of eight rows of that many bytes, several blocks of eight ahead."""
    lines = -(-size * WIDTH // 64)
    for line in range(lines):
        program.ahead(program.at("[64 x i8]", start, blocks * lines + line), writing)


def _flat(values: Values) -> list[Lanes | float]:
    return [x for v in values for x in _flat(v)] if isinstance(values, tuple) else [values]


def _shape(values: Values) -> Shape:
    return (len(values), *_shape(values[0])) if isinstance(values, tuple) else ()


def _store(program: RowFunction, names: list[str], word: str) -> None:
    """Emit the stores of columns as rows: blocks of eight, then the remaining columns."""
    width, size, kind = len(names), BYTES[word], vector(word, WIDTH)
    whole = width - width % WIDTH if width >= WIDTH else 0
    if not whole:
        _store_few(program, names, word)
        return
    _ask_ahead(program, "%out", width * size, AHEAD, writing=True)
    for first in range(0, whole, WIDTH):
        for row, name in enumerate(_transposed(program, names[first : first + WIDTH], kind)):
            program.store(kind, name, program.at(word, "%out", row * width + first), size)
    for k in range(whole, width):
        for row in range(WIDTH):
            one = program.value(f"extractelement {kind} {names[k]}, i32 {row}")
            program.store(word, one, program.at(word, "%out", row * width + k), size)


def _transposed(program: RowFunction, columns: list[str], kind: str) -> list[str]:
    """Return the transpose of eight columns, by exchanging halves, quarters and eighths."""
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


def _store_few(program: RowFunction, names: list[str], word: str) -> None:
    """Write fewer than eight columns as rows, joining them in pairs."""
    width = len(names)
    parts = [(n, WIDTH) for n in names]
    while len(parts) > 1:  # the last one may stay over
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
    rows = program.shuffled(vector(word, length), whole, "poison", order)
    _store_rows(program, rows, width, word)


def _store_rows(program: RowFunction, rows: str, width: int, word: str) -> None:
    """Write eight rows stored in one vector, in pieces of 16 bytes, numpy's minimal alignment.

    Copying in pieces that cross the end of a cache line takes twice as long, so LLVM must not merge the
    pieces.
    """
    length, few = width * WIDTH, 16 // BYTES[word]
    kind = vector(word, length)
    for n in range(0, length, few):
        piece = program.shuffled(kind, rows, "poison", range(n, n + few))
        place = program.at(word, "%out", n)
        program.do(f"store volatile {vector(word, few)} {piece}, ptr {place}, align {BYTES[word]}")


# --- all rows ------------------------------------------------------------------------------------


def _rows(shapes: tuple[Shape, ...], moving: list[int], words: tuple[str, ...]) -> Code:
    """Write the function that processes blocks of eight rows; it returns whether a row was flagged.

    Its arguments are the number of rows; for each array the address of its numbers and whether it has one row
    for all; and the address of the result. The remaining rows at the end go through a buffer, and so does the
    single row of an array that is shared by all rows. Arrays that always have one row are broadcast by the
    block itself.
    """
    sizes = [int(np.prod(shape)) for shape in shapes]
    bytes_of = [n * BYTES[word] for n, word in zip(sizes, words, strict=True)]  # of one row
    given = "".join(f", ptr %in{n}, i1 %one{n}" for n in range(len(sizes) - 1))
    code = Code(f"internal i1 @rows(i64 %count{given}, ptr %out)")
    v = code.value
    buffers = [code.allocate(vector(w, n * WIDTH)) for n, w in zip(sizes, words, strict=True)]

    def spread(n: int, start: str) -> None:
        for row in range(WIDTH):
            code.copy(code.at("i8", buffers[n], row * bytes_of[n]), start, bytes_of[n])

    for n in moving:
        code.when(f"%one{n}", lambda n=n: spread(n, f"%in{n}"))  # type: ignore[misc]
    long = v(f"icmp sge i64 %count, {FREE}")
    (state,) = code.when(long, lambda: [("ptr", code.call("ptr", "PyEval_SaveThread"), "null")])

    def turn(i: str, flag: str) -> list[str]:
        left = v(f"sub i64 %count, {i}")
        full = v(f"icmp sge i64 {left}, {WIDTH}")
        few = v(f"xor i1 {full}, true")
        here = [code.at("i8", f"%in{n}", v(f"mul i64 {i}, {bytes_of[n]}")) for n in moving]

        def filled(n: int, start: str) -> None:
            spread(n, start)  # so that no row of the buffer is uninitialised
            code.copy(buffers[n], start, v(f"mul i64 {left}, {bytes_of[n]}"))

        def partly() -> None:
            for n, start in zip(moving, here, strict=True):
                moves = v(f"xor i1 %one{n}, true")
                code.when(moves, lambda n=n, s=start: filled(n, s))  # type: ignore[misc]

        code.when(few, partly)
        sources = [f"%in{n}" for n in range(len(sizes) - 1)]
        for n, start in zip(moving, here, strict=True):
            row = v(f"select i1 {full}, ptr {start}, ptr {buffers[n]}")
            sources[n] = v(f"select i1 %one{n}, ptr {buffers[n]}, ptr {row}")
        there = code.at("i8", "%out", v(f"mul i64 {i}, {bytes_of[-1]}"))
        target = v(f"select i1 {full}, ptr {there}, ptr {buffers[-1]}")
        passed = ", ".join(f"ptr {x}" for x in (*sources, target))
        flag = v(f"or i1 {flag}, {code.once(f'call i1 @block({passed})')}")
        code.when(few, lambda: code.copy(there, buffers[-1], v(f"mul i64 {left}, {bytes_of[-1]}")))
        return [flag]

    (flag,) = code.loop("0", "%count", turn, WIDTH, [("i1", "false")])

    def restore() -> None:
        code.call("void", "PyEval_RestoreThread", ("ptr", state))

    code.when(long, restore)
    code.end(f"i1 {flag}")
    return code
