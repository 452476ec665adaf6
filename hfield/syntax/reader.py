"""Evaluate a syntax tree with the caller's numbers, names and functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Generic

from hfield.errors import NotationError, TooLargeError, shorten
from hfield.syntax.parser import parse
from hfield.syntax.products import Vocabulary
from hfield.syntax.spelling import foreign_function_hint, spell
from hfield.syntax.tree import (
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
)
from hfield.syntax.typed import reported_as_typed

if TYPE_CHECKING:
    from typing import Any

    from typing_extensions import TypeVar

    from hfield.core.product import SupportsArithmetic

    V = TypeVar("V", bound=SupportsArithmetic, default=Any)  # ``Reader`` alone: of any values
    T = TypeVar("T", default=object)
else:
    from typing import TypeVar

    V, T = TypeVar("V"), TypeVar("T")  # the values of terms, and of a function of trees

U = TypeVar("U")


class OfTrees(Generic[T]):
    """A function that receives its arguments as syntax trees, such as the cosine of an angle."""

    def __init__(self, call: Callable[..., T]) -> None:
        self.call = call

    def __call__(self, *trees: Node) -> T:
        """Return the value for arguments as trees."""
        return self.call(*trees)

    def then(self, change: Callable[[T], U]) -> OfTrees[U]:
        """Return the function with converted values, for instance from scalars to elements."""
        return OfTrees(lambda *trees: change(self.call(*trees)))


@dataclass(frozen=True)
class Reader(Generic[V]):
    """The protocol of readers: the values of numbers, names and functions.

    ``limit`` bounds the weight of a term (see :func:`weight`), so that no computation is started that would
    not end; ``what`` describes the text in error messages.
    """

    number: Callable[[int | Fraction], V]
    names: Mapping[str, V]
    functions: Mapping[str, Callable[..., V]]
    what: str
    limit: int = 20_000

    def read(self, text: str) -> V:
        """Parse and evaluate ``text``. Raises :class:`NotationError`, :class:`TooLargeError`."""
        node = parse(text)
        heavy = weight(node)
        if heavy > self.limit:
            raise TooLargeError(
                f"{shorten(text)!r} is too large to compute: its degree may reach {shorten(heavy, 20)}, "
                f"at most {self.limit} is tried; use smaller exponents"
            )
        return self.evaluate(node, text)

    def read_typed(self, text: str) -> V:
        """Read a text as typed by users: with mathematical signs, and products without a sign.

        Raises the same errors as :meth:`read`, with positions in the typed text.
        """
        typed = spell(text, Vocabulary.of_names(self.names, self.functions))
        with reported_as_typed(typed):
            return self.read(typed.text)

    def evaluate(self, node: Node, text: str = "") -> V:
        """Evaluate a term node; a statement (``==``, ``and`` …) raises an error."""
        match node:
            case Number(value):
                return self.number(value)
            case Name(name):
                if name in self.names:
                    return self.names[name]
                known = ", ".join(sorted(self.names)) or "none"
                mend = (
                    f"write {'*'.join(name)}"
                    if set(name) <= set(self.names)
                    else f"known names: {known}"
                )
                raise NotationError(
                    f"{name!r} means nothing in {self.what}; {mend}",
                    text,
                    node.position,
                )
            case Negate(operand):
                return -self.evaluate(operand, text)
            case Binary(op, left, right):
                x, y = self.evaluate(left, text), self.evaluate(right, text)
                if op == "+":
                    return x + y
                if op == "-":
                    return x - y
                return x * y if op == "*" else self.functions["/"](x, y)
            case Power(base, exponent):
                return self.functions["**"](self.evaluate(base, text), exponent)
            case Index(base, index):
                if "[]" in self.functions:
                    return self.functions["[]"](self.evaluate(base, text), index)
                raise NotationError(f"{self.what} has no coordinates", text, node.position)
            case Call(function, arguments):
                if function not in self.functions or not function.isidentifier():
                    known = ", ".join(sorted(f for f in self.functions if f.isidentifier()))
                    raise NotationError(
                        f"there is no function {function!r} in {self.what}{foreign_function_hint(function)}; "
                        f"known functions: {known or 'none'}",
                        text,
                        node.position,
                    )
                if isinstance(self.functions[function], OfTrees):
                    return self.functions[function](*arguments)
                values = [self.evaluate(x, text) for x in arguments]
                try:
                    return self.functions[function](*values)
                except TypeError as error:
                    if "positional argument" not in str(error):
                        raise
                    raise NotationError(
                        f"{function} does not take {len(values)} arguments", text, node.position
                    ) from None
        raise NotationError(
            f"expected an element of {self.what}, found a statement", text, node.position
        )


def weight(node: Node) -> int:
    """Return a bound for the size of a term's value: bits of numbers and degrees of names, powers
    expanded.
    """
    match node:
        case Number(value):
            return value.numerator.bit_length() + value.denominator.bit_length() - 1
        case Name():
            return 1
        case Negate(x) | Index(x, _) | Not(x) | Exists(_, x):
            return weight(x)
        case Binary("*" | "/", left, right):
            return weight(left) + weight(right)
        case Binary(_, left, right) | Compare(_, left, right) | Logic(_, left, right):
            return max(weight(left), weight(right)) + 1
        case Power(base, exponent):
            return weight(base) * max(abs(exponent), 1)
        case Call(_, arguments):
            return sum(weight(x) for x in arguments) * 2
    return 1
