"""Build statements from trees with Python functions.

>>> p, q = names("p q")
>>> equal(conj(p * q), conj(q) * conj(p)) == parse("conj(p*q) == conj(q)*conj(p)")
True
"""

from functools import reduce

from hfield.syntax.parser import parse
from hfield.syntax.tree import Call, Compare, Logic, Name, Node, Not, Operand, number


def names(text: str) -> tuple[Name, ...]:
    """Return the names in a text that are separated by blanks."""
    return tuple(map(Name, text.split()))


def conj(x: Node) -> Node:
    """Return ``conj(x)``."""
    return Call("conj", (x,))


def norm(x: Node) -> Node:
    """Return ``norm(x)``."""
    return Call("norm", (x,))


def inv(x: Node) -> Node:
    """Return ``inv(x)``."""
    return Call("inv", (x,))


def scalar(x: Node) -> Node:
    """Return ``scalar(x)``."""
    return Call("scalar", (x,))


def vector(x: Node) -> Node:
    """Return ``vector(x)``."""
    return Call("vector", (x,))


def comm(x: Node, y: Node) -> Node:
    """Return ``comm(x, y)``."""
    return Call("comm", (x, y))


def equal(x: Operand, y: Operand) -> Node:
    """Return ``x == y``."""
    return Compare("==", number(x), number(y))


def unequal(x: Operand, y: Operand) -> Node:
    """Return ``x != y``."""
    return Compare("!=", number(x), number(y))


def negation(x: Node) -> Node:
    """Return ``not x``."""
    return Not(x)


def both(*parts: Node | str) -> Node:
    """Return ``x and y and …``; parts may be texts."""
    return reduce(lambda x, y: Logic("and", x, y), map(statement, parts))


def either(*parts: Node | str) -> Node:
    """Return ``x or y or …``."""
    return reduce(lambda x, y: Logic("or", x, y), map(statement, parts))


def implies(*parts: Node | str) -> Node:
    """Return ``x => y => …``."""
    return reduce(lambda x, y: Logic("=>", y, x), map(statement, reversed(parts)))


def iff(x: Node | str, y: Node | str) -> Node:
    """Return ``x <=> y``."""
    return Logic("<=>", statement(x), statement(y))


def statement(text: Node | str) -> Node:
    """Return a text as a tree; return a tree unchanged."""
    return parse(text) if isinstance(text, str) else text
