"""The syntax tree: what the parser makes and what rings, algebras and the prover read."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import TypeAlias

Operand: TypeAlias = "Node | int | float | Fraction"


@dataclass(frozen=True, slots=True)
class Node:
    """A place in the tree; ``position`` is the offset in the text and does not count in ``==``.

    Trees are also made by ``+ - * / **``, ``-x`` and ``x[n]``, on trees and numbers; ``==`` asks whether two
    trees are the same, :func:`hfield.syntax.equal` makes the statement.

    >>> p, q = Name("p"), Name("q")
    >>> p * (q + 1) == Binary("*", p, Binary("+", q, Number(1)))
    True
    """

    position: int = field(default=0, compare=False, kw_only=True)

    def __add__(self, other: Operand) -> Node:
        return Binary("+", self, number(other))

    def __radd__(self, other: Operand) -> Node:
        return Binary("+", number(other), self)

    def __sub__(self, other: Operand) -> Node:
        return Binary("-", self, number(other))

    def __rsub__(self, other: Operand) -> Node:
        return Binary("-", number(other), self)

    def __mul__(self, other: Operand) -> Node:
        return Binary("*", self, number(other))

    def __rmul__(self, other: Operand) -> Node:
        return Binary("*", number(other), self)

    def __truediv__(self, other: Operand) -> Node:
        return Binary("/", self, number(other))

    def __rtruediv__(self, other: Operand) -> Node:
        return Binary("/", number(other), self)

    def __pow__(self, exponent: int) -> Node:
        return Power(self, exponent)

    def __neg__(self) -> Node:
        return Negate(self)

    def __getitem__(self, index: int) -> Node:
        if not 0 <= index <= 3:
            raise IndexError(f"a quaternion has the coordinates 0 to 3, not {index}")
        return Index(self, index)


def number(value: Operand) -> Node:
    """Return a number as a tree, as the parser reads its text; a tree is returned as it is.

    >>> number(-2)
    Negate(position=0, operand=Number(position=0, value=2))
    """
    if isinstance(value, Node):
        return value
    if value < 0:
        return Negate(number(-value))
    if isinstance(value, int):
        return Number(value)
    return Number(Fraction(str(value)))


@dataclass(frozen=True, slots=True)
class Number(Node):
    """A literal: an int, or a Fraction where it was written with a decimal point."""

    value: int | Fraction


@dataclass(frozen=True, slots=True)
class Name(Node):
    """A name, whose meaning the reader of the tree decides."""

    name: str


@dataclass(frozen=True, slots=True)
class Negate(Node):
    """``-operand``."""

    operand: Node


@dataclass(frozen=True, slots=True)
class Binary(Node):
    """``left op right`` with op one of ``+ - * /``."""

    op: str
    left: Node
    right: Node


@dataclass(frozen=True, slots=True)
class Power(Node):
    """``base ** exponent``."""

    base: Node
    exponent: int


@dataclass(frozen=True, slots=True)
class Call(Node):
    """``function(arguments)``."""

    function: str
    arguments: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Index(Node):
    """``base[index]``, a coordinate."""

    base: Node
    index: int


@dataclass(frozen=True, slots=True)
class Compare(Node):
    """``left op right`` with op ``==`` or ``!=``."""

    op: str
    left: Node
    right: Node


@dataclass(frozen=True, slots=True)
class Not(Node):
    """``not operand``."""

    operand: Node


@dataclass(frozen=True, slots=True)
class Logic(Node):
    """``left op right`` with op one of ``and or => <=>``."""

    op: str
    left: Node
    right: Node


@dataclass(frozen=True, slots=True)
class Exists(Node):
    """``exists names: body``."""

    names: tuple[str, ...]
    body: Node
