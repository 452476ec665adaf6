"""Walking through syntax trees, and putting terms in the place of unknowns."""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from hfield.syntax import (
    Binary,
    Call,
    Compare,
    Exists,
    Index,
    Logic,
    Name,
    Negate,
    Node,
    Not,
    Number,
    Power,
    parse,
)


def children(node: Node) -> tuple[Node, ...]:
    """Return the nodes directly below ``node``."""
    match node:
        case Negate(x) | Not(x) | Power(x, _) | Index(x, _) | Exists(_, x):
            return (x,)
        case Binary(_, x, y) | Compare(_, x, y) | Logic(_, x, y):
            return (x, y)
        case Call(_, arguments):
            return arguments
    return ()


def tree_depth(node: Node) -> int:
    """Return how many nodes are above each other at most."""
    depth, level = 0, [node]
    while level:
        depth, level = depth + 1, [child for n in level for child in children(n)]
    return depth


def walk(node: Node) -> Iterator[Node]:
    """Run through ``node`` and all nodes below it."""
    stack = [node]
    while stack:
        n = stack.pop()
        yield n
        stack.extend(reversed(children(n)))


def occurrences(node: Node, name: str) -> int:
    """Return how often a name stands in a tree."""
    return sum(isinstance(n, Name) and n.name == name for n in walk(node))


def divides_in(node: Node) -> bool:
    """Tell whether something in a tree may be undefined: a quotient, an inverse, a decimal."""
    for n in walk(node):
        match n:
            case Number(Fraction()) | Binary("/", _, _) | Call("inv", _):
                return True
            case Power(_, exponent) if exponent < 0:
                return True
    return False


def substitute(node: Node, terms: Mapping[str, Node]) -> Node:
    """Return ``node`` with each name in ``terms`` replaced."""
    match node:
        case Name(name):
            return terms.get(name, node)
        case Negate(x):
            return Negate(substitute(x, terms))
        case Not(x):
            return Not(substitute(x, terms))
        case Power(x, n):
            return Power(substitute(x, terms), n)
        case Index(x, n):
            return Index(substitute(x, terms), n)
        case Binary(op, x, y):
            return Binary(op, substitute(x, terms), substitute(y, terms))
        case Compare(op, x, y):
            return Compare(op, substitute(x, terms), substitute(y, terms))
        case Logic(op, x, y):
            return Logic(op, substitute(x, terms), substitute(y, terms))
        case Call(function, arguments):
            return Call(function, tuple(substitute(x, terms) for x in arguments))
    return node


def quaternion_node(coordinates: Sequence[str]) -> Node:
    """Return the tree of ``c0 + c1·i + c2·j + c3·k`` for the texts of the coordinates, or of a scalar."""
    if len(coordinates) == 1:
        return parse(coordinates[0])
    parts = [f"({c})*{unit}" for c, unit in zip(coordinates, "eijk", strict=True) if c != "0"]
    return parse(" + ".join(parts) or "0*e")
