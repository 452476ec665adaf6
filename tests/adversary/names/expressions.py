"""Expressions in names of rings: read into trees, and worked out as polynomials or modulo one.

A tree is ``("number", c)``, ``("decimal", c)``, ``("name", x)``, ``("neg", x)``, ``("^", x, n)``, or
``(sign, x, y)`` for ``+ - * /``.
"""

import re
from collections.abc import Mapping
from fractions import Fraction
from typing import Any, NoReturn

import sympy

from tests.adversary.names.arithmetic import (
    QQ,
    Field,
    Poly,
    dense,
    negative,
    plus,
    powered,
    rational,
    remainder,
    times,
)

Tree = tuple[Any, ...]
NAME = "[A-Za-z][A-Za-z0-9_]*"
TOKEN = re.compile(
    rf"(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+(?![A-Za-z0-9_.]))?|{NAME}|[-+*/^()]"
)


class Refused(Exception):  # noqa: N818  it is an answer
    """The page allows no such name."""


class Unsure(Exception):  # noqa: N818
    """To tell what the name means takes more than is here."""


def refuse(why: str) -> NoReturn:
    """Say that there is no such name."""
    raise Refused(why)


def parsed(text: str) -> Tree:
    """Return the tree of an expression."""
    tokens = TOKEN.findall(text)
    if "".join(tokens) != text or not tokens:
        refuse("no expression")
    if len(tokens) > 500:
        raise Unsure("a long expression")
    reader = _Reader([*tokens, ""])
    tree = reader.total()
    if reader.token:
        refuse("the expression goes on")
    return tree


class _Reader:
    """One pass over the tokens, the last of which is empty."""

    def __init__(self, tokens: list[str]) -> None:
        self.tokens, self.at = tokens, 0

    @property
    def token(self) -> str:
        return self.tokens[self.at]

    def take(self) -> str:
        self.at += 1
        return self.tokens[self.at - 1]

    def total(self) -> Tree:
        left = self.product()
        while self.token in ("+", "-"):
            left = (self.take(), left, self.product())
        return left

    def product(self) -> Tree:
        left = self.signed()
        while self.token in ("*", "/"):
            left = (self.take(), left, self.signed())
        return left

    def signed(self) -> Tree:
        if self.token not in ("+", "-"):
            return self.power()
        sign = self.take()
        return ("neg", self.signed()) if sign == "-" else self.signed()

    def power(self) -> Tree:
        x = self.atom()
        if self.token != "^":
            return x
        self.take()
        x = ("^", x, self.exponent())
        return x if self.token != "^" else refuse("powers do not chain")

    def exponent(self) -> int:
        inside = self.token == "("
        self.at += inside
        minus = self.token == "-"
        self.at += minus
        digits = self.take()
        if not digits.isdigit() or (inside and self.take() != ")"):
            refuse("an exponent is a whole number")
        if len(digits) > 4:
            raise Unsure("a large exponent")
        return -int(digits) if minus else int(digits)

    def atom(self) -> Tree:
        token = self.take()
        if token == "(":
            x = self.total()
            return x if self.take() == ")" else refuse("a bracket is open")
        if re.match("[0-9.]", token):
            if len(token) > 30 or re.search("[eE][+-]?[0-9]{3}", token):
                raise Unsure("a long number")
            return ("number" if token.isdigit() else "decimal", Fraction(token))
        if re.match("[A-Za-z]", token) and self.token != "(":
            return ("name", token)
        refuse("an operand is missing, or a function is there")


def parts(tree: Tree) -> list[Tree]:
    """Return the tree and all trees in it."""
    return [tree, *(x for part in tree[1:] if isinstance(part, tuple) for x in parts(part))]


def names_in(tree: Tree) -> set[str]:
    """Return the names in a tree."""
    return {x[1] for x in parts(tree) if x[0] == "name"}


def worked_out(
    tree: Tree, names: Mapping[str, Poly], K: Field, modulus: Poly | None = None
) -> Poly:
    """Return the value, a polynomial over K, in which only constants divide; or one modulo another over ℚ."""

    def product(f: Poly, g: Poly) -> Poly:
        if len(f) + len(g) > 300:
            raise Unsure("a large degree")
        return times(K, f, g) if modulus is None else remainder(K, times(K, f, g), modulus)

    def inverse(f: Poly) -> Poly:
        if len(f) == 1:
            return (K.inverse(f[0]),)
        if not f or modulus is None:
            refuse("only constants divide, and not 0")
        return dense(sympy.invert(rational(f), rational(modulus)))

    def value(tree: Tree) -> Poly:
        kind, *operands = tree
        if kind in ("number", "decimal"):
            c = K.number(operands[0])
            return () if c == K.zero else (c,)
        if kind == "name":
            return names[operands[0]] if operands[0] in names else refuse("an unknown name")
        if kind == "^":
            f, n = value(operands[0]), operands[1]
            if n < 0 and modulus is None:
                refuse("no negative powers")
            return powered((K.one,), inverse(f) if n < 0 else f, abs(n), product)
        values = [value(x) for x in operands]
        if kind == "neg":
            return negative(K, values[0])
        f, g = values
        if kind in "+-":
            return plus(K, f, g if kind == "+" else negative(K, g))
        return product(f, inverse(g) if kind == "/" else g)

    try:
        return value(tree)
    except ZeroDivisionError:
        refuse("a division by 0")


def whole_number(text: str) -> int:
    """Return the integer that ``+ - * ^`` and parentheses make."""
    tree = parsed(text)
    if any(x[0] in ("/", "decimal", "name") or (x[0] == "^" and x[2] < 0) for x in parts(tree)):
        refuse("a whole number")
    return int(sum(worked_out(tree, {}, QQ)))


def rational_number(text: str) -> Fraction:
    """Return a rational number."""
    return sum(worked_out(parsed(text), {}, QQ, (Fraction(0), Fraction(1))), Fraction(0))
