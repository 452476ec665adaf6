"""The next numbers of a row read and written: one, or as many as the arithmetic computes with at once."""

from __future__ import annotations

from hfield.compiling.arithmetic import Arithmetic, Code, raw_type


def declarations(arithmetic: Arithmetic) -> tuple[str, ...]:
    """Declare what reads and writes those of several numbers that are there."""
    lanes = arithmetic.lanes
    if lanes == 1:
        return ()
    read, written = (raw_type(t, lanes) for t in (arithmetic.dtype, arithmetic.result))
    return (
        f"declare {read} {_masked('load', arithmetic.dtype, lanes)}(ptr, i32, <{lanes} x i1>, {read})",
        f"declare void {_masked('store', arithmetic.result, lanes)}({written}, ptr, i32, <{lanes} x i1>)",
        "declare i64 @llvm.umin.i64(i64, i64)",
    )


def read(code: Code, arithmetic: Arithmetic, row: str, single: bool) -> str:
    """Load the next numbers of a row; of a ``single`` number load that for each lane."""
    lanes, kind = arithmetic.lanes, raw_type(arithmetic.dtype)
    at = code.value(f"getelementptr {kind}, ptr %{row}, i64 {'0' if single else '%i'}")
    if lanes == 1:
        return code.value(f"load {kind}, ptr {at}")
    if single:
        return every(code, kind, code.value(f"load {kind}, ptr {at}"), lanes)
    vector = raw_type(arithmetic.dtype, lanes)
    asked = f"ptr {at}, i32 1, {_there(code, lanes)}, {vector} zeroinitializer"
    return code.value(f"call {vector} {_masked('load', arithmetic.dtype, lanes)}({asked})")


def write(code: Code, arithmetic: Arithmetic, row: str, result: str) -> None:
    """Store the next numbers of a row."""
    lanes, kind = arithmetic.lanes, raw_type(arithmetic.result)
    at = code.value(f"getelementptr {kind}, ptr %{row}, i64 %i")
    if lanes == 1:
        code.lines.append(f"store {kind} {result}, ptr {at}")
        return
    given = f"{raw_type(arithmetic.result, lanes)} {result}, ptr {at}, i32 1, {_there(code, lanes)}"
    code.lines.append(f"call void {_masked('store', arithmetic.result, lanes)}({given})")


def every(code: Code, kind: str, number: str, lanes: int) -> str:
    """Return the vector with a number in each lane."""
    vector = f"<{lanes} x {kind}>"
    first = code.value(f"insertelement {vector} poison, {kind} {number}, i32 0")
    places = f"<{lanes} x i32> zeroinitializer"
    return code.value(f"shufflevector {vector} {first}, {vector} poison, {places}")


def _there(code: Code, lanes: int) -> str:
    """Tell for each lane whether there is a number for it: the last turn may have fewer."""
    left = code.value("sub i64 %n, %i")
    count = code.value(f"call i64 @llvm.umin.i64(i64 {left}, i64 {lanes})")
    counts = every(code, "i8", code.value(f"trunc i64 {count} to i8"), lanes)
    numbers = ", ".join(f"i8 {n}" for n in range(lanes))
    mask = code.value(f"icmp ult <{lanes} x i8> <{numbers}>, {counts}")
    return f"<{lanes} x i1> {mask}"


def _masked(what: str, dtype: str, lanes: int) -> str:
    return f"@llvm.masked.{what}.v{lanes}{raw_type(dtype)}.p0"
