"""A loop that reduces rows of numerators over a common row of denominators to lowest terms."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from hfield.compiling import machine_code
from hfield.compiling.calling import run
from hfield.compiling.instructions import Code, module
from hfield.compiling.memory import Rows

NUMERATORS = 4
_ROWS = NUMERATORS + 1


def lowest(rows: Rows) -> bool:
    """Divide rows of i64 (the last one nonzero denominators) by their greatest common divisors, in place.

    The denominators become positive. Returns False if some number is −2⁶³, whose negative does not fit into a
    word; then the rows are invalid.
    """
    n = rows[0].size
    if not n:
        return True
    return not run(_loop(), n, rows, (rows[0].itemsize,) * _ROWS)


@cache
def _loop() -> machine_code.Function:
    return machine_code.function(machine_code.compiled(module(_gcd(), _entry()), "entry"))


def _gcd() -> Code:
    """Write the greatest common divisor of g > 0 and x ≥ 0, by J. Stein's binary algorithm."""
    code = Code("internal i64 @gcd(i64 %g, i64 %x)")

    def zeros(x: str) -> str:
        return code.call("i64", "llvm.cttz.i64", ("i64", x), ("i1", "true"))

    def subtracted(u: str, v: str) -> tuple[str, Sequence[str]]:  # u is odd
        w = code.value(f"lshr i64 {v}, {zeros(v)}")
        less = code.value(f"icmp ult i64 {u}, {w}")
        least = code.value(f"select i1 {less}, i64 {u}, i64 {w}")
        most = code.value(f"select i1 {less}, i64 {w}, i64 {u}")
        rest = code.value(f"sub i64 {most}, {least}")
        return code.value(f"icmp ne i64 {rest}, 0"), (least, rest)

    def divided() -> list[tuple[str, str, str]]:
        shared = zeros(code.value("or i64 %g, %x"))  # the power of 2, which is put back
        odd = code.value(f"lshr i64 %g, {zeros('%g')}")
        least, _ = code.repeat([("i64", odd), ("i64", "%x")], subtracted)
        return [("i64", code.value(f"shl i64 {least}, {shared}"), "%g")]

    (found,) = code.when(code.value("icmp ne i64 %x, 0"), divided)
    code.end(f"i64 {found}")
    return code


def _entry() -> Code:
    """Write ``entry(n, addresses)``."""
    code = Code("i64 @entry(i64 %n, ptr %addresses)")
    rows = code.entries("ptr", "%addresses", _ROWS)

    def turn(i: str, flags: str) -> list[str]:
        places = [code.at("i64", row, i) for row in rows]
        numbers = [code.load("i64", place) for place in places]
        for x in numbers:
            least = code.value(f"icmp eq i64 {x}, {-(2**63)}")
            flags = code.value(f"or i64 {flags}, {code.value(f'zext i1 {least} to i64')}")

        def divide() -> None:
            *sizes, g = (
                code.call("i64", "llvm.abs.i64", ("i64", x), ("i1", "false")) for x in numbers
            )
            for size in sizes:
                g = code.once(f"call i64 @gcd(i64 {g}, i64 {size})")
            below = code.value(f"icmp slt i64 {numbers[-1]}, 0")
            by = code.value(f"select i1 {below}, i64 {code.value(f'sub i64 0, {g}')}, i64 {g}")

            def write() -> None:
                for x, place in zip(numbers, places, strict=True):
                    code.store("i64", code.value(f"sdiv i64 {x}, {by}"), place)

            code.when(code.value(f"icmp ne i64 {by}, 1"), write)

        code.when(code.value(f"icmp ne i64 {numbers[-1]}, 1"), divide)
        return [flags]

    (flags,) = code.loop("0", "%n", turn, first=[("i64", "0")])
    code.end(f"i64 {flags}")
    return code
