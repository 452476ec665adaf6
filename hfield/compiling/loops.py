"""A straight-line program in an arithmetic, put into a loop over the rows of arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from hfield.compiling import lanes, streaming
from hfield.compiling.arithmetic import Arithmetic, Code, Symbol, raw_type
from hfield.straight_line import ONE, Program


class Operand(NamedTuple):
    """The rows of one operand by their names in the program; ``single``: one element for all."""

    names: tuple[str, ...]
    single: bool


def written(
    program: Program,
    arithmetic: Arithmetic,
    operands: tuple[Operand, ...],
    literals: Mapping[str, int],
) -> tuple[Code, list[str]]:
    """Write the inside of the loop; return it, and the names of the results to be stored.

    ``literals`` are the program's other inputs, known beforehand.
    """
    code = Code()

    def symbol(payload: object) -> Symbol:
        return Symbol(arithmetic, code, payload)

    known = {name: symbol(arithmetic.constant(code, x)) for name, x in literals.items()}
    known[ONE] = symbol(arithmetic.constant(code, 1))
    for operand in operands:
        for name in operand.names:
            if name in program.inputs:
                raw = lanes.read(code, arithmetic, name, operand.single)
                known[name] = symbol(arithmetic.load(code, raw))
    results = program.evaluate(known, symbol(arithmetic.constant(code, 0)))
    return code, [arithmetic.store(code, x.payload) for x in results]


def module(
    program: Program,
    arithmetic: Arithmetic,
    operands: tuple[Operand, ...],
    literals: Mapping[str, int],
    streamed: bool = False,
) -> str:
    """Write the function ``entry(n, addresses)`` that runs the program over n elements.

    The addresses are those of the rows of the operands, of the arithmetic's tables, and of the rows of
    the results. It returns the flags of all elements, one or the other bit set where one had to tell.
    Where it is ``streamed`` the results are written past the caches.
    """
    code, results = written(program, arithmetic, operands, literals)
    kind = raw_type(arithmetic.result)
    tables = [f"table{n}" for n in range(len(arithmetic.tables()))]
    outputs = [f"out{n}" for n in range(len(results))]
    pointers = [*(name for operand in operands for name in operand.names), *tables, *outputs]
    for name, result in zip(outputs, results, strict=True):
        lanes.write(code, arithmetic, name, result)
    told = "%told"
    for n, flag in enumerate(code.flags):
        code.lines.append(f"%told{n} = or i64 {told}, {flag}")
        told = f"%told{n}"
    signature = ", ".join(f"ptr noalias %{name}" for name in pointers)
    lines = [
        *arithmetic.declarations,
        *lanes.declarations(arithmetic),
        f"define internal i64 @loop(i64 %n, {signature}) noinline {{",
        "start:",
        "%some = icmp sgt i64 %n, 0",
        "br i1 %some, label %body, label %end",
        "body:",
        "%i = phi i64 [ 0, %start ], [ %next, %body ]",
        f"%told = phi i64 [ 0, %start ], [ {told}, %body ]",
        *code.lines,
        f"%next = add nuw nsw i64 %i, {arithmetic.lanes}",
        "%more = icmp slt i64 %next, %n",
        f"br i1 %more, label %body, label %end{'' if arithmetic.vectorise else ', !llvm.loop !0'}",
        "end:",
        f"%all = phi i64 [ 0, %start ], [ {told}, %body ]",
        "ret i64 %all",
        "}",
    ]
    if streamed:
        moving = [name for operand in operands if not operand.single for name in operand.names]
        read = raw_type(arithmetic.dtype)
        lines.append(streaming.entry(pointers, moving, outputs, read, kind))
    else:
        lines.append("define i64 @entry(i64 %n, ptr %addresses) {")
        for n, name in enumerate(pointers):
            lines.append(f"%at{n} = getelementptr ptr, ptr %addresses, i64 {n}")
            lines.append(f"%{name} = load ptr, ptr %at{n}")
        passed = ", ".join(f"ptr %{name}" for name in pointers)
        lines += [f"%flags = call i64 @loop(i64 %n, {passed})", "ret i64 %flags", "}"]
    lines += ["!0 = distinct !{!0, !1}", '!1 = !{!"llvm.loop.vectorize.enable", i1 false}']
    return "\n".join(lines) + "\n"
