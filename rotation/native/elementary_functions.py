"""Calls of what LLVM has for whole vectors, and of the system's mathematics, with their declarations."""

from collections.abc import Iterable
from typing import Any

from rotation.native.symbols import Lanes, Program

INTRINSICS = {"fabs": 1, "sqrt": 1, "fma": 3}  # how many arguments each has
LIBRARY = {"sin": 1, "cos": 1, "atan": 1, "atan2": 2, "fmod": 2}
_WORDS = {"double": "f64", "float": "f32"}


def intrinsic(name: str, *values: Any) -> Lanes:
    """Call a function that LLVM has for all rows at once."""
    program = _program(*values)
    kind = program.kind
    arguments = ", ".join(f"{kind} {program.name_of(v)}" for v in values)
    called = _intrinsic(name, program.number, program.width)
    return Lanes(program, program.value(f"call {kind} {called}({arguments})"))


def library(name: str, *values: Any) -> Lanes:
    """Call a function of the system's mathematics for each row."""
    program = _program(*values)
    kind = program.kind
    found = "poison"
    for n in range(program.width):
        numbers = [
            program.value(f"extractelement {kind} {program.name_of(v)}, i32 {n}") for v in values
        ]
        arguments = ", ".join(f"double {x}" for x in numbers)
        one = program.value(f"call double @rotation_{name}({arguments})")
        found = program.value(f"insertelement {kind} {found}, double {one}, i32 {n}")
    return Lanes(program, found)


def intrinsics(number: str, width: int) -> list[str]:
    """Return the declarations of LLVM's functions for vectors of ``width`` numbers."""
    kind = f"<{width} x {number}>"
    return [
        f"declare {kind} {_intrinsic(name, number, width)}({', '.join([kind] * n)})"
        for name, n in INTRINSICS.items()
    ]


def of_the_system(names: Iterable[str]) -> list[str]:
    """Return the declarations of functions of the system's mathematics."""
    return [
        f"declare double @rotation_{name}({', '.join(['double'] * LIBRARY[name])})"
        for name in names
    ]


def _program(*values: Any) -> Program:
    return next(v.program for v in values if isinstance(v, Lanes))


def _intrinsic(name: str, number: str, width: int) -> str:
    return f"@llvm.{name}.v{width}{_WORDS[number]}"
