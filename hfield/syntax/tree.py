"""The syntax tree that the parser makes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cache
from operator import attrgetter
from typing import Any, ClassVar, TypeAlias

ORDER = (">=", ">", "<=", "<")
"""The comparisons of scalars over ordered fields."""

Operand: TypeAlias = "Node | int | float | Fraction"


@dataclass(frozen=True, slots=True)
class Node:
    """A node of the tree; ``position`` is the offset in the text and is ignored by ``==``.

    Trees can also be built by ``+ - * / **``, ``-x`` and ``x[n]`` from trees and numbers. ``==`` compares two
    trees; :func:`hfield.syntax.equal` builds the statement of equality.

    >>> p, q = Name("p"), Name("q")
    >>> p * (q + 1) == Binary("*", p, Binary("+", q, Number(1)))
    True

    ``below`` names the fields of a node that contain other nodes, in the order of the text.
    """

    below: ClassVar[tuple[str, ...]] = ()
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
    """Return a number as a tree, as the parser reads its text; return a tree unchanged.

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
    """A literal: an int, or a Fraction if it was written with a decimal point."""

    value: int | Fraction


@dataclass(frozen=True, slots=True)
class Name(Node):
    """A name, whose meaning is decided by the reader of the tree."""

    name: str


@dataclass(frozen=True, slots=True)
class Negate(Node):
    """``-operand``."""

    below = ("operand",)
    operand: Node


@dataclass(frozen=True, slots=True)
class Binary(Node):
    """``left op right`` with op one of ``+ - * /``."""

    below = ("left", "right")
    op: str
    left: Node
    right: Node


@dataclass(frozen=True, slots=True)
class Power(Node):
    """``base ** exponent``."""

    below = ("base",)
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

    below = ("base",)
    base: Node
    index: int


@dataclass(frozen=True, slots=True)
class Compare(Node):
    """``left op right`` with op ``==`` or ``!=``, or one of ``>= > <= <``."""

    below = ("left", "right")
    op: str
    left: Node
    right: Node


@dataclass(frozen=True, slots=True)
class Not(Node):
    """``not operand``."""

    below = ("operand",)
    operand: Node


@dataclass(frozen=True, slots=True)
class Logic(Node):
    """``left op right`` with op one of ``and or => <=>``."""

    below = ("left", "right")
    op: str
    left: Node
    right: Node


@dataclass(frozen=True, slots=True)
class Exists(Node):
    """``exists names: body``."""

    below = ("body",)
    names: tuple[str, ...]
    body: Node


def children(node: Node) -> tuple[Node, ...]:
    """Return the nodes directly below ``node``.

    >>> from hfield.syntax import parse
    >>> len(children(parse("p*q == 1")))
    2
    """
    return node.arguments if isinstance(node, Call) else _nodes_in(node.below)(node)


@cache
def _nodes_in(fields: tuple[str, ...]) -> Callable[[Node], tuple[Node, ...]]:
    """Return a function that finds the nodes in some fields, because trees are walked often."""
    if not fields:
        return lambda node: ()
    if len(fields) > 1:
        find_all: Callable[[Node], tuple[Node, ...]] = attrgetter(*fields)
        return find_all
    find: Callable[[Node], Node] = attrgetter(fields[0])
    return lambda node: (find(node),)


def rebuild(node: Node, parts: Sequence[Node]) -> Node:
    """Return a copy of ``node`` with other children, as many as :func:`children` returns."""
    if isinstance(node, Call):
        return replace(node, arguments=tuple(parts))
    changes: dict[str, Any] = dict(zip(node.below, parts, strict=True))
    return replace(node, **changes) if changes else node
