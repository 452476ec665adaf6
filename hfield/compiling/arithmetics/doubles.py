"""64-bit floats in loops: operations are rounded one by one, in the order in which they are written."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from hfield.compiling.arithmetic import Arithmetic, Symbol
from hfield.compiling.instructions import Code, floating


@dataclass(frozen=True)
class Doubles(Arithmetic[str]):
    """Floats; a payload is the name of a ``double``."""

    dtype: str = "f8"

    waits_for_memory = True

    def load(self, code: Code, raw: str) -> str:
        """Read a float."""
        return code.value(f"bitcast i64 {raw} to double")

    def store(self, code: Code, x: str) -> str:
        """Return the bits of a float."""
        return code.value(f"bitcast double {x} to i64")

    def constant(self, code: Code, value: float) -> str:
        """Return a number known at compile time."""
        return floating(value, "double")

    def add(self, code: Code, x: str, y: str) -> str:
        """Return x + y."""
        return code.value(f"fadd double {x}, {y}")

    def subtract(self, code: Code, x: str, y: str) -> str:
        """Return x − y."""
        return code.value(f"fsub double {x}, {y}")

    def multiply(self, code: Code, x: str, y: str) -> str:
        """Return x·y."""
        return code.value(f"fmul double {x}, {y}")

    def negate(self, code: Code, x: str) -> str:
        """Return −x."""
        return code.value(f"fneg double {x}")


@dataclass(frozen=True)
class FloatFormula:
    """A function of floats that a loop evaluates on symbols, instead of a straight-line program."""

    function: Callable[..., tuple[Symbol[str], ...]]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

    def evaluate(self, values: dict[str, Symbol[str]], zero: Symbol[str]) -> Sequence[Symbol[str]]:
        """Return the results for inputs given by name."""
        return self.function(*(values[name] for name in self.inputs))


def _computed(x: Symbol[str], text: str) -> Symbol[str]:
    return Symbol(x.arithmetic, x.code, x.code.value(text))


def constant(x: Symbol[str], number: float) -> Symbol[str]:
    """Return a number as a symbol in the code of x."""
    return Symbol(x.arithmetic, x.code, floating(number, "double"))


def quotient(x: Symbol[str], y: Symbol[str]) -> Symbol[str]:
    """Return x/y."""
    return _computed(x, f"fdiv double {x.payload}, {y.payload}")


def sqrt(x: Symbol[str]) -> Symbol[str]:
    """Return the square root, NaN for x < 0."""
    found = x.code.call("double", "llvm.sqrt.f64", ("double", x.payload))
    return Symbol(x.arithmetic, x.code, found)


def absolute(x: Symbol[str]) -> Symbol[str]:
    """Return |x|."""
    found = x.code.call("double", "llvm.fabs.f64", ("double", x.payload))
    return Symbol(x.arithmetic, x.code, found)


def where_negative(x: Symbol[str], yes: Symbol[str], no: Symbol[str]) -> Symbol[str]:
    """Return ``yes`` where x < 0, else ``no``."""
    negative = x.code.value(f"fcmp olt double {x.payload}, 0.0")
    return _computed(x, f"select i1 {negative}, double {yes.payload}, double {no.payload}")


def flag_unless_between(x: Symbol[str], low: float, high: float) -> None:
    """Set the flag of the loop if x is not between two numbers."""
    code = x.code
    above, below = (
        code.value(f"fcmp {how} double {x.payload}, {floating(bound, 'double')}")
        for how, bound in (("ogt", low), ("olt", high))
    )
    inside = code.value(f"and i1 {above}, {below}")
    outside = code.value(f"xor i1 {inside}, true")
    code.conditions.append(code.value(f"zext i1 {outside} to i64"))
