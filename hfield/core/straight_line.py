"""The formulas of an algebra as straight-line programs.

A function of :mod:`hfield.core.product` is called with symbols that record the operations on them. Structure
constants that are 0, 1 or −1 are substituted: a = −1 becomes a sign, t = 0 disappears; and common
subexpressions are computed only once. All other constants are named inputs. The result is used by every
emitter: source text for Python, loops for a compiler, lines for a reader.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, NamedTuple, TypeVar

from hfield.core import product
from hfield.core.product import Constants, Coordinates, SupportsArithmetic
from hfield.syntax.brackets import outside

S = TypeVar("S", bound=SupportsArithmetic)
T = TypeVar("T")

ZERO, ONE, MINUS_ONE = "0", "1", "-1"
FIRST, SECOND = ("w1", "x1", "y1", "z1"), ("w2", "x2", "y2", "z2")
GENERAL = Constants("a", "t", "b")  # constants about which nothing is known


class ProgramStep(NamedTuple):
    """One operation: ``operation`` is ``+``, ``-``, ``*`` (two operands) or ``neg`` (one)."""

    name: str
    operation: str
    operands: tuple[str, ...]


@dataclass(frozen=True)
class Program:
    """A list of steps, each on inputs and on the results of earlier steps.

    ``inputs`` are the names that are read: coordinates ``w1 … z1`` (and ``w2 … z2`` of a second element) and
    those of the constants ``a, t, b`` that occur. ``outputs`` are names of steps or inputs, or ``"0"``.
    """

    inputs: tuple[str, ...]
    steps: tuple[ProgramStep, ...]
    outputs: tuple[str, ...]

    def evaluate(self, values: dict[str, S], zero: S) -> tuple[S, ...]:
        """Run the program on values with ``+ − ×``; the reference for all emitters."""
        known = {ZERO: zero, **values}
        for name, operation, operands in self.steps:
            x, *rest = (known[n] for n in operands)
            if operation == "neg":
                known[name] = -x
            elif operation == "*":
                known[name] = x * rest[0]
            else:
                known[name] = x + rest[0] if operation == "+" else x - rest[0]
        return tuple(known[n] for n in self.outputs)

    def expressions(
        self, write: Callable[[str, Sequence[str]], str]
    ) -> tuple[list[tuple[str, str]], list[str]]:
        """Return the program as nested expressions: assignments of shared subexpressions, and outputs.

        ``write(operation, operands)`` returns the text of one operation on texts of operands.
        """
        uses: dict[str, int] = {}
        for n in [n for step in self.steps for n in step.operands] + list(self.outputs):
            uses[n] = uses.get(n, 0) + 1
        texts: dict[str, str] = {}
        assigned = []
        for name, operation, operands in self.steps:
            text = write(operation, [texts.get(n, n) for n in operands])
            if uses.get(name, 0) > 1:
                assigned.append((name, text))
            else:
                texts[name] = text
        return assigned, [texts.get(n, n) for n in self.outputs]


class _Tape:
    """The tape on which symbols record their steps, without duplicates."""

    def __init__(self, characteristic: int) -> None:
        self.characteristic = characteristic
        self.steps: list[ProgramStep] = []
        self._known: dict[tuple[str, tuple[str, ...]], str] = {}

    def write(self, operation: str, *operands: str) -> str:
        commutes = operation in "+*"
        key = (operation, tuple(sorted(operands)) if commutes else operands)
        if key not in self._known:
            self._known[key] = f"s{len(self.steps) + 1}"
            self.steps.append(ProgramStep(self._known[key], operation, operands))
        return self._known[key]


class _Symbol:
    """An input or a result, possibly with a sign; ``+ − ×`` are recorded on the tape."""

    def __init__(self, tape: _Tape, name: str, negative: bool = False) -> None:
        self.tape, self.name = tape, name
        self.negative = negative and name != ZERO and tape.characteristic != 2

    def __neg__(self) -> _Symbol:
        return _Symbol(self.tape, self.name, not self.negative)

    def __add__(self, other: _Symbol) -> _Symbol:
        if ZERO in (self.name, other.name):
            return other if self.name == ZERO else self
        if self.name == other.name and (
            self.negative != other.negative or self.tape.characteristic == 2
        ):
            return _Symbol(self.tape, ZERO)
        if self.negative == other.negative:
            return _Symbol(self.tape, self.tape.write("+", self.name, other.name), self.negative)
        plus, minus = (other, self) if self.negative else (self, other)
        return _Symbol(self.tape, self.tape.write("-", plus.name, minus.name))

    def __sub__(self, other: _Symbol) -> _Symbol:
        return self + -other

    def __mul__(self, other: _Symbol) -> _Symbol:
        negative = self.negative != other.negative
        if ZERO in (self.name, other.name):
            return _Symbol(self.tape, ZERO)
        if ONE in (self.name, other.name):
            return _Symbol(self.tape, other.name if self.name == ONE else self.name, negative)
        return _Symbol(self.tape, self.tape.write("*", self.name, other.name), negative)

    def settled(self) -> str:
        """Return the name of the value, after recording its sign."""
        return self.tape.write("neg", self.name) if self.negative else self.name


class _Extended:
    """A polynomial in s whose coefficients are symbols, low degree first."""

    def __init__(self, parts: Sequence[_Symbol]) -> None:
        self.parts = tuple(parts)

    def __neg__(self) -> _Extended:
        return _Extended([-x for x in self.parts])

    def __add__(self, other: _Extended) -> _Extended:
        short, long = sorted((self.parts, other.parts), key=len)
        added = [x + y for x, y in zip(self.parts, other.parts, strict=False)]
        return _Extended([*added, *long[len(short) :]])

    def __sub__(self, other: _Extended) -> _Extended:
        return self + -other

    def __mul__(self, other: _Extended) -> _Extended:
        product = [_Symbol(x.tape, ZERO) for x in (*self.parts, *other.parts)][1:]
        for m, x in enumerate(self.parts):
            for n, y in enumerate(other.parts):
                product[m + n] = product[m + n] + x * y
        return _Extended(product)

    def reduced(self, relation: Sequence[_Symbol]) -> list[_Symbol]:
        """Return the coefficients after substituting ``sⁿ = Σ relation[k]·sᵏ`` from the highest
        power down.
        """
        parts = list(self.parts)
        while len(parts) > len(relation):
            top = parts.pop()
            for k, c in enumerate(relation, len(parts) - len(relation)):
                parts[k] = parts[k] + c * top
        return parts


def _adjoint(c: Constants[S], q: Coordinates[S]) -> tuple[S, ...]:
    """Return the conjugate and the norm, from which one division gives the inverse."""
    return (*product.conjugate(c, q), product.norm(c, q))


FORMULAS: dict[str, Callable[..., Any]] = {
    "product": product.multiply,
    "sum": lambda _, p, q: tuple(x + y for x, y in zip(p, q, strict=True)),
    "difference": lambda _, p, q: tuple(x - y for x, y in zip(p, q, strict=True)),
    "multiple": lambda _, p, q: tuple(x * q[0] for x in p),  # by the scalar part of q
    "negative": lambda _, p: tuple(-x for x in p),
    "conjugate": product.conjugate,
    "norm": product.norm,
    "trace": product.trace,
    "adjoint": _adjoint,
}
BINARY = {"product", "sum", "difference", "multiple"}


@lru_cache(maxsize=1024)
def specialise(formula: str, constants: Constants[str], characteristic: int = 0) -> Program:
    """Return the program of one of ``FORMULAS``, such as ``product`` or ``norm``.

    Each constant is ``"0"``, ``"1"``, ``"-1"`` or the name of an input. The adjoint is the conjugate and the
    norm, five outputs, from which one division gives the inverse. In characteristic 2 signs vanish and x + x
    is 0; other characteristics are not used.

    >>> specialise("norm", Constants("-1", "0", "-1")).steps[0]
    ProgramStep(name='s1', operation='*', operands=('w1', 'w1'))
    """
    tape = _Tape(characteristic)
    c = Constants(*(_constant(tape, name) for name in constants))
    operands = [[_Symbol(tape, name) for name in side] for side in _sides(formula)]
    return _program(tape, [x.settled() for x in _outputs(formula, c, operands)])


@lru_cache(maxsize=256)
def specialise_extension(
    formula: str, constants: tuple[tuple[str, ...], ...], relation: tuple[str, ...]
) -> Program:
    """Return the program over an extension ``R[s]`` of degree n on the coefficients of 1, s, …, sⁿ⁻¹.

    ``relation`` gives sⁿ. Constants and relation are given by n names each, as :func:`specialise` expects
    them, and :func:`parts` names the n inputs of a coordinate. Products are added before they are reduced.
    There are n outputs for each output of :func:`specialise`.

    >>> gauss = ("-1", "0"), ("0", "0"), ("-1", "0")
    >>> len(specialise_extension("product", gauss, ("-1", "0")).outputs)
    8
    """
    tape = _Tape(0)
    c = Constants(*(_Extended([_constant(tape, name) for name in names]) for names in constants))
    operands = [
        [_Extended([_Symbol(tape, part) for part in parts(name, len(relation))]) for name in side]
        for side in _sides(formula)
    ]
    power = [_constant(tape, name) for name in relation]
    values = [x.reduced(power) for x in _outputs(formula, c, operands)]
    return _program(tape, [part.settled() for value in values for part in value])


def parts(name: str, degree: int) -> tuple[str, ...]:
    """Return the names of the coefficients of a coordinate or constant: ``w1_0, w1_1, …``."""
    return (name,) if degree == 1 else tuple(f"{name}_{k}" for k in range(degree))


def _sides(formula: str) -> list[tuple[str, ...]]:
    return [FIRST, SECOND] if formula in BINARY else [FIRST]


def _outputs(formula: str, c: Constants[S], operands: Sequence[Sequence[S]]) -> tuple[S, ...]:
    made = FORMULAS[formula](c, *operands)
    return made if isinstance(made, tuple) else (made,)


def _constant(tape: _Tape, name: str) -> _Symbol:
    return _Symbol(tape, ONE, True) if name == MINUS_ONE else _Symbol(tape, name)


def _program(tape: _Tape, outputs: list[str]) -> Program:
    """Remove unused steps, such as factors of a term that was multiplied by 0."""
    used = dict.fromkeys(outputs)
    kept: list[ProgramStep] = []
    for step in reversed(tape.steps):
        if step.name in used:
            kept.insert(0, step)
            used.update(dict.fromkeys(step.operands))
    computed = {ZERO, *(step.name for step in kept)}
    inputs = sorted(n for n in used if n not in computed)
    return Program(tuple(inputs), tuple(kept), tuple(outputs))


def named(x: T, name: str, is_constant: Callable[[T, int], bool]) -> str:
    """Return x in the form that :func:`specialise` expects; ``is_constant(x, n)`` returns whether x = n·1."""
    return next((str(n) for n in (0, 1, -1) if is_constant(x, n)), name)


def pattern(constants: Constants[T], is_constant: Callable[[T, int], bool]) -> Constants[str]:
    """Return the constants as :func:`specialise` expects them; ``is_constant(x, n)`` means x = n·1."""
    pairs = zip(constants, GENERAL, strict=True)
    return Constants(*(named(x, name, is_constant) for x, name in pairs))


def arithmetic_text(operation: str, operands: Sequence[str]) -> str:
    """Write an operation in Python notation, with parentheses that keep the order of the steps."""
    if operation == "neg":
        return f"-{_closed(operands[0], ' ')}"
    left, right = operands
    if operation == "*":
        return f"{_closed(left, ' ')}*{_closed(right, ' *')}"
    return f"{left} {operation} {_closed(right, ' ')}"


def _closed(text: str, signs: str) -> str:
    """Parenthesise a text that begins with one of the signs or contains one outside parentheses."""
    if any(sign in signs or (sign == "-" and n == 0) for n, sign in outside(text)):
        return f"({text})"
    return text
