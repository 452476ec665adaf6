"""Rows of numerators over one row of denominators, put in lowest terms by a loop of its own."""

from __future__ import annotations

from functools import cache

from hfield.compiling import machine_code
from hfield.compiling.calling import Rows, run

NUMERATORS = 4
_ROWS = NUMERATORS + 1


def lowest(rows: Rows) -> bool:
    """Divide rows of i64, the last of which are denominators ≠ 0, by what they share, in place.

    The denominators become positive. False if some number is −2⁶³, whose negative no word holds; the rows
    are spoilt then.
    """
    n = rows[0].size
    if not n:
        return True
    return not run(_loop(), n, rows, (rows[0].itemsize,) * _ROWS)


@cache
def _loop() -> machine_code.Function:
    return machine_code.function(machine_code.compiled(_text(), "entry"))


def _text() -> str:
    """Write ``entry(n, addresses)``, after J. Stein's binary algorithm for the greatest common divisor."""
    names = [f"r{n}" for n in range(_ROWS)]
    lines = [
        "declare i64 @llvm.cttz.i64(i64, i1)",
        "declare i64 @llvm.abs.i64(i64, i1)",
        # g > 0 is odd after shifting; the power of 2 that both share is put back
        "define internal i64 @gcd(i64 %g, i64 %x) {",
        "start:",
        "%none = icmp eq i64 %x, 0",
        "br i1 %none, label %alone, label %begin",
        "alone:",
        "ret i64 %g",
        "begin:",
        "%both = or i64 %g, %x",
        "%shared = call i64 @llvm.cttz.i64(i64 %both, i1 true)",
        "%zg = call i64 @llvm.cttz.i64(i64 %g, i1 true)",
        "%odd = lshr i64 %g, %zg",
        "br label %step",
        "step:",
        "%u = phi i64 [ %odd, %begin ], [ %least, %step ]",
        "%v = phi i64 [ %x, %begin ], [ %rest, %step ]",
        "%zv = call i64 @llvm.cttz.i64(i64 %v, i1 true)",
        "%w = lshr i64 %v, %zv",
        "%less = icmp ult i64 %u, %w",
        "%least = select i1 %less, i64 %u, i64 %w",
        "%most = select i1 %less, i64 %w, i64 %u",
        "%rest = sub i64 %most, %least",
        "%done = icmp eq i64 %rest, 0",
        "br i1 %done, label %end, label %step",
        "end:",
        "%found = shl i64 %least, %shared",
        "ret i64 %found",
        "}",
        "define i64 @entry(i64 %n, ptr %addresses) {",
        "start:",
    ]
    for n, name in enumerate(names):
        lines += [
            f"%at{n} = getelementptr ptr, ptr %addresses, i64 {n}",
            f"%{name} = load ptr, ptr %at{n}",
        ]
    lines += [
        "br label %body",
        "body:",
        "%i = phi i64 [ 0, %start ], [ %next, %more ]",
        "%told = phi i64 [ 0, %start ], [ %tells, %more ]",
    ]
    told = "%told"
    for n, name in enumerate(names):
        lines += [
            f"%p{n} = getelementptr i64, ptr %{name}, i64 %i",
            f"%x{n} = load i64, ptr %p{n}",
            f"%least{n} = icmp eq i64 %x{n}, {-(2**63)}",
            f"%flag{n} = zext i1 %least{n} to i64",
            f"%told{n} = or i64 {told}, %flag{n}",
        ]
        told = f"%told{n}"
    last = NUMERATORS
    lines += [
        f"%simple = icmp eq i64 %x{last}, 1",
        "br i1 %simple, label %more, label %divide",
        "divide:",
        f"%g{last} = call i64 @llvm.abs.i64(i64 %x{last}, i1 false)",
    ]
    for n in range(NUMERATORS):
        lines += [
            f"%a{n} = call i64 @llvm.abs.i64(i64 %x{n}, i1 false)",
            f"%g{n} = call i64 @gcd(i64 %g{last if n == 0 else n - 1}, i64 %a{n})",
        ]
    lines += [
        f"%below = icmp slt i64 %x{last}, 0",
        f"%negated = sub i64 0, %g{NUMERATORS - 1}",
        f"%by = select i1 %below, i64 %negated, i64 %g{NUMERATORS - 1}",
        "%one = icmp eq i64 %by, 1",
        "br i1 %one, label %more, label %write",
        "write:",
    ]
    for n in range(_ROWS):
        lines += [f"%q{n} = sdiv i64 %x{n}, %by", f"store i64 %q{n}, ptr %p{n}"]
    lines += [
        "br label %more",
        "more:",
        f"%tells = phi i64 [ {told}, %body ], [ {told}, %divide ], [ {told}, %write ]",
        "%next = add nuw nsw i64 %i, 1",
        "%again = icmp slt i64 %next, %n",
        "br i1 %again, label %body, label %end",
        "end:",
        "ret i64 %tells",
        "}",
    ]
    return "\n".join(lines) + "\n"
