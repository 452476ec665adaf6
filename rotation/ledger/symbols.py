"""Running the thesis's own functions on symbols: what they return becomes a formula to be proved.

A :class:`Symbol` is a scalar that writes down what is done to it. Handed to a function of
:mod:`rotation.thesis` in the place of a float, it comes back as a formula of the statement
language. So the ledger proves the code that runs, not a formula typed in beside it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import FunctionType
from typing import Any

from rotation import thesis

Vector = list["Symbol"]


@dataclass(frozen=True)
class Symbol:
    """A scalar that is a text of the statement language."""

    text: str

    def __add__(self, other: object) -> Symbol:
        return Symbol(f"({self.text} + {_text(other)})")

    def __radd__(self, other: object) -> Symbol:
        return Symbol(f"({_text(other)} + {self.text})")

    def __sub__(self, other: object) -> Symbol:
        return Symbol(f"({self.text} - {_text(other)})")

    def __rsub__(self, other: object) -> Symbol:
        return Symbol(f"({_text(other)} - {self.text})")

    def __mul__(self, other: object) -> Symbol:
        return Symbol(f"{self.text}*{_text(other)}")

    def __rmul__(self, other: object) -> Symbol:
        return Symbol(f"{_text(other)}*{self.text}")

    def __truediv__(self, other: object) -> Symbol:
        return Symbol(f"({self.text}/({_text(other)}))")

    def __neg__(self) -> Symbol:
        return Symbol(f"(-{self.text})")


def _text(value: object) -> str:
    return value.text if isinstance(value, Symbol) else repr(value)


def coordinates(unknown: str) -> Vector:
    """Return the coordinates of an unknown over i, j, k: an arbitrary point of space."""
    return [Symbol(f"{unknown}[{n}]") for n in (1, 2, 3)]


def scalar(unknown: str) -> Symbol:
    """Return the coordinate of an unknown over e."""
    return Symbol(f"{unknown}[0]")


def quaternion(a: object, v: Sequence[object]) -> str:
    """Return ``a + v`` as text, where ``v`` has three entries over i, j, k."""
    x, y, z = map(_text, v)
    return f"({_text(a)} + {x}*i + {y}*j + {z}*k)"


def point(v: Sequence[object]) -> str:
    """Return a list of three as the text of a quaternion without scalar part."""
    x, y, z = map(_text, v)
    return f"({x}*i + {y}*j + {z}*k)"


def read_as(values: Mapping[str, str]) -> Callable[[Symbol], Symbol]:
    """Return a function of one argument known at these texts only, such as a cosine."""
    return lambda argument: Symbol(values[argument.text])


def code(name: str, **read: Callable[[Symbol], Symbol]) -> Callable[..., Any]:
    """Return a function of :mod:`rotation.thesis`, with ``cos``, ``sin`` or ``sqrt`` read as given.

    It and all that it calls are the same compiled code; only those names mean something else.
    """
    names: dict[str, Any] = {**vars(thesis), **read}
    for key, value in vars(thesis).items():
        if isinstance(value, FunctionType) and value.__module__ == thesis.__name__:
            copy = FunctionType(value.__code__, names, key, value.__defaults__)
            copy.__kwdefaults__ = value.__kwdefaults__
            names[key] = copy
    function: Callable[..., Any] = names[name]
    return function


def equal(left: Sequence[object], right: Sequence[object]) -> str:
    """Return the equality of two lists, entry by entry. Raises ValueError for different lengths."""
    pairs = zip(left, right, strict=True)
    return " and ".join(f"{_text(x)} == {_text(y)}" for x, y in pairs)
