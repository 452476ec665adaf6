"""Write loops over rows of arrays in LLVM's notation: a straight-line program in an arithmetic.

An iteration reads the next numbers of each row (one, or as many as the arithmetic processes at once) and
writes as many. Large results may bypass the caches: an ordinary store first reads its cache line of 64 bytes,
so each written byte is transferred twice. With streaming the loop fills blocks that stay in the cache, and
whole lines of them are copied out by LLVM's non-temporal stores. That pays off if memory is the bottleneck,
if the result fits into no cache, and if its pages have been used before; a newly cleared page is already in
the cache and would be written out twice.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from hfield.compiling.arithmetic import Arithmetic, Symbol
from hfield.compiling.arithmetics.doubles import FloatFormula
from hfield.compiling.instructions import Code, module, raw_type, vector
from hfield.core.straight_line import ONE, Program

BLOCK = 512  # elements that are written past the caches together
LINE = "<8 x i64>"
NOT_VECTORISED = ", !llvm.loop !0"
NOTES = [
    "!0 = distinct !{!0, !1}",
    '!1 = !{!"llvm.loop.vectorize.enable", i1 false}',
    "!2 = !{i32 1}",
]


class Operand(NamedTuple):
    """The rows of one operand, by their names in the program; ``single`` means one element for all."""

    names: tuple[str, ...]
    single: bool


def emit_body(
    code: Code,
    program: Program | FloatFormula,
    arithmetic: Arithmetic,
    operands: tuple[Operand, ...],
    literals: Mapping[str, int],
    i: str = "%i",
) -> list[str]:
    """Write one iteration of the loop; return the names of the results to be stored.

    ``literals`` are the other inputs of the program, known at compile time.
    """

    def symbol(payload: object) -> Symbol:
        return Symbol(arithmetic, code, payload)

    known = {name: symbol(arithmetic.constant(code, x)) for name, x in literals.items()}
    known[ONE] = symbol(arithmetic.constant(code, 1))
    for operand in operands:
        for name in operand.names:
            if name in program.inputs:
                raw = _read(code, arithmetic, name, "0" if operand.single else i)
                known[name] = symbol(arithmetic.load(code, raw))
    results = program.evaluate(known, symbol(arithmetic.constant(code, 0)))
    return [arithmetic.store(code, x.payload) for x in results]


def emit_loop(
    program: Program | FloatFormula,
    arithmetic: Arithmetic,
    operands: tuple[Operand, ...],
    literals: Mapping[str, int],
    streamed: bool = False,
) -> str:
    """Write the function ``entry(n, addresses)`` that runs the program over n elements.

    The addresses are those of the rows of the operands, of the arithmetic's tables, and of the rows of the
    results. It returns the flags of all elements combined; either bit is set if some element reported it. If
    ``streamed``, the results bypass the caches.
    """
    rows = [name for operand in operands for name in operand.names]
    tables = [f"table{n}" for n in range(len(arithmetic.tables()))]
    outputs = [f"out{n}" for n in range(len(program.outputs))]
    pointers = [*rows, *tables, *outputs]
    signature = ", ".join(f"ptr noalias %{name}" for name in pointers)
    code = Code(f"internal i64 @loop(i64 %n, {signature}) noinline")

    def turn(i: str, flags: str) -> list[str]:
        results = emit_body(code, program, arithmetic, operands, literals, i)
        for name, result in zip(outputs, results, strict=True):
            _write(code, arithmetic, name, i, result)
        for condition in code.conditions:
            flags = code.value(f"or i64 {flags}, {condition}")
        return [flags]

    marks = "" if arithmetic.vectorise else NOT_VECTORISED
    (flags,) = code.loop("0", "%n", turn, arithmetic.lanes, [("i64", "0")], marks)
    code.end(f"i64 {flags}")
    entry = Code("i64 @entry(i64 %n, ptr %addresses)")
    places = dict(zip(pointers, entry.entries("ptr", "%addresses", len(pointers)), strict=True))
    if not streamed:
        entry.end(f"i64 {_call(entry, '%n', places)}")
        return module(code, entry, notes=NOTES)
    moving = [name for operand in operands if not operand.single for name in operand.names]
    _stream(entry, arithmetic, places, moving, outputs)
    return module(code, _copy(), entry, notes=NOTES)


def _call(entry: Code, length: str, places: Mapping[str, str]) -> str:
    return entry.once(
        f"call i64 @loop(i64 {length}, {', '.join(f'ptr {x}' for x in places.values())})"
    )


# --- the next numbers of a row -------------------------------------------------------------------


def _read(code: Code, arithmetic: Arithmetic, row: str, i: str) -> str:
    """Load the next numbers of a row; a row of one number is broadcast to every lane."""
    lanes, kind = arithmetic.lanes, raw_type(arithmetic.dtype)
    at = code.at(kind, f"%{row}", i)
    if lanes == 1:
        return code.load(kind, at)
    if i == "0":
        return code.spread(kind, code.load(kind, at), lanes)
    whole = vector(kind, lanes)
    there = (vector("i1", lanes), _there(code, lanes, i))
    name = f"llvm.masked.load.v{lanes}{kind}.p0"
    return code.call(whole, name, ("ptr", at), ("i32", "1"), there, (whole, "zeroinitializer"))


def _write(code: Code, arithmetic: Arithmetic, row: str, i: str, result: str) -> None:
    """Store the next numbers of a row."""
    lanes, kind = arithmetic.lanes, raw_type(arithmetic.result)
    at = code.at(kind, f"%{row}", i)
    if lanes == 1:
        code.store(kind, result, at)
        return
    there = (vector("i1", lanes), _there(code, lanes, i))
    name = f"llvm.masked.store.v{lanes}{kind}.p0"
    code.call("void", name, (vector(kind, lanes), result), ("ptr", at), ("i32", "1"), there)


def _there(code: Code, lanes: int, i: str) -> str:
    """Return a mask of the lanes in use; the last iteration may have fewer."""
    left = code.value(f"sub i64 %n, {i}")
    count = code.call("i64", "llvm.umin.i64", ("i64", left), ("i64", str(lanes)))
    counts = code.spread("i8", code.value(f"trunc i64 {count} to i8"), lanes)
    numbers = ", ".join(f"i8 {n}" for n in range(lanes))
    return code.value(f"icmp ult {vector('i8', lanes)} <{numbers}>, {counts}")


# --- past the caches -----------------------------------------------------------------------------


def _stream(
    entry: Code,
    arithmetic: Arithmetic,
    places: Mapping[str, str],
    moving: list[str],
    outputs: list[str],
) -> None:
    """Emit the calls of the loop, block by block, and the copy of its output.

    The ``moving`` rows have an element for each iteration; the others are constant.
    """
    read, kind = raw_type(arithmetic.dtype), raw_type(arithmetic.result)
    near = {name: entry.allocate(f"[{BLOCK} x {kind}]") for name in outputs}

    def block(i: str, flags: str) -> list[str]:
        left = entry.value(f"sub i64 %n, {i}")
        length = entry.call("i64", "llvm.umin.i64", ("i64", left), ("i64", str(BLOCK)))
        here = {name: entry.at(read, places[name], i) for name in moving}
        flags = entry.value(f"or i64 {flags}, {_call(entry, length, {**places, **here, **near})}")
        size = entry.value(f"mul i64 {length}, {int(kind[1:]) // 8}")
        for name in outputs:
            to = entry.at(kind, places[name], i)
            entry.do(f"call void @copy(ptr {to}, ptr {near[name]}, i64 {size})")
        return [flags]

    (flags,) = entry.loop("0", "%n", block, BLOCK, [("i64", "0")])
    entry.do("fence seq_cst")  # another thread sees such stores after it only
    entry.end(f"i64 {flags}")


def _copy() -> Code:
    """Write the function that copies bytes, in whole lines of 64 that bypass the caches."""
    code = Code("internal void @copy(ptr noalias %to, ptr noalias %from, i64 %bytes) noinline")
    below = code.value(f"sub i64 0, {code.value('ptrtoint ptr %to to i64')}")
    gap = code.value(f"and i64 {below}, 63")
    first = code.call("i64", "llvm.umin.i64", ("i64", gap), ("i64", "%bytes"))
    code.copy("%to", "%from", first)
    rest = code.value(f"sub i64 %bytes, {first}")
    last = code.value(f"add i64 {first}, {code.value(f'and i64 {rest}, -64')}")

    def line(i: str) -> None:
        bits = code.load(LINE, code.at("i8", "%from", i), 1)
        code.store(LINE, bits, code.at("i8", "%to", i), 64, ", !nontemporal !2")

    code.loop(first, last, line, 64)
    left = code.value(f"sub i64 %bytes, {last}")
    code.copy(code.at("i8", "%to", last), code.at("i8", "%from", last), left)
    code.end()
    return code
