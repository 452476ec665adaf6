"""The syntax tree: what the parser makes and what rings, algebras and the prover read."""

from dataclasses import dataclass, field
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Node:
    """A place in the tree; ``position`` is the offset in the text and does not count in ``==``."""

    position: int = field(default=0, compare=False, kw_only=True)


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
