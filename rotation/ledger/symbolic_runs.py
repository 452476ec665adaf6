"""Run the thesis's functions on terms, so that their results are formulas that can be proved.

With terms of the statement language as arguments in place of floats, a function of :mod:`rotation.thesis`
returns terms. So the ledger proves the code that runs, not a formula copied from it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import FunctionType
from typing import Any

from hfield.syntax import Node, Operand, both, names, number, parse
from hfield.syntax import equal as same
from rotation import thesis

Vector = list[Node]


def coordinates(unknown: str) -> Vector:
    """Return the coordinates of an unknown over i, j, k: an arbitrary point of space."""
    (name,) = names(unknown)
    return [name[n] for n in (1, 2, 3)]


def scalar(unknown: str) -> Node:
    """Return the coordinate of an unknown over e."""
    (name,) = names(unknown)
    return name[0]


def point(v: Sequence[Operand]) -> Node:
    """Return a list of three terms as a pure quaternion."""
    x, y, z = (number(c) * unit for c, unit in zip(v, names("i j k"), strict=True))
    return x + y + z


def quaternion(a: Operand, v: Sequence[Operand]) -> Node:
    """Return ``a + v``, where ``v`` has three entries over i, j, k."""
    x, y, z = (number(c) * unit for c, unit in zip(v, names("i j k"), strict=True))
    return number(a) + x + y + z


def read_as(values: Mapping[str, str]) -> Callable[[Node], Node]:
    """Return a function of one argument with values only at these terms, such as a cosine."""
    table = {parse(argument): parse(value) for argument, value in values.items()}
    return lambda argument: table[argument]


def code(name: str, **read: Callable[[Node], Node]) -> Callable[..., Any]:
    """Return a function of :mod:`rotation.thesis`, with ``cos``, ``sin`` or ``sqrt`` replaced.

    The function and all functions that it calls are the same compiled code; only these names have another
    meaning.
    """
    names: dict[str, Any] = {**vars(thesis), **read}
    for key, value in vars(thesis).items():
        if isinstance(value, FunctionType) and value.__module__ == thesis.__name__:
            copy = FunctionType(value.__code__, names, key, value.__defaults__)
            copy.__kwdefaults__ = value.__kwdefaults__
            names[key] = copy
    function: Callable[..., Any] = names[name]
    return function


def equal(left: Sequence[Operand], right: Sequence[Operand]) -> Node:
    """Return the equality of two lists, entry by entry. Raises ValueError for different lengths."""
    return both(*(same(x, y) for x, y in zip(left, right, strict=True)))
