"""Putting terms in the place of unknowns."""

from collections.abc import Mapping, Sequence

from hfield.syntax import (
    Binary,
    Call,
    Compare,
    Index,
    Logic,
    Name,
    Negate,
    Node,
    Not,
    Power,
    parse,
)


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
