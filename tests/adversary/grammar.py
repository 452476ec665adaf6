"""Statements to trees, by a reader of the judge's own.

It is written from the grammar in docs/reference/language.md alone and shares nothing with ``hfield.syntax``
nor with the checker's parser, so that a text which one of them takes for another statement is seen. A
tree is a tuple that begins with its kind: ``("number", value)``, ``("name", text)``,
``("call", function, arguments)``, ``("coordinate", x, n)``, ``("power", x, n)``, ``("minus", x)``,
``("not", x)``, ``("exists", names, x)`` and ``(operator, left, right)``.
"""

import re
from fractions import Fraction
from functools import lru_cache
from typing import Any

Tree = tuple[Any, ...]
TOKEN = re.compile(
    r"\s*(?:([0-9]+\.?[0-9]*(?:[eE][+-]?[0-9]+)?|\.[0-9]+(?:[eE][+-]?[0-9]+)?)"
    r"|([A-Za-z_][A-Za-z_0-9]*)|(<=>|=>|==|!=|\*\*|[-+*/^()\[\],:|]))"
)
SIGNS = str.maketrans({"−": "-", "·": "*", "×": "*"})


class NotRead(Exception):  # noqa: N818  it is an answer
    """The text is not in the language."""


class _Words:
    def __init__(self, text: str) -> None:
        self.words: list[str] = []
        text = text.translate(SIGNS).rstrip()
        at = 0
        while at < len(text):
            match = TOKEN.match(text, at)
            if match is None:
                raise NotRead(f"character {at} of {text!r}")
            self.words.append(match[1] or match[2] or match[3])
            at = match.end()
        self.words.append("")
        self.at = 0

    @property
    def here(self) -> str:
        return self.words[self.at]

    def take(self, *wanted: str) -> str:
        """Take the next word if it is one of those, else return ''."""
        word = self.here
        if word and (word in wanted or not wanted):
            self.at += 1
            return word
        return ""

    def need(self, word: str) -> None:
        if not self.take(word):
            raise NotRead(f"expected {word!r}, found {self.here!r}")


@lru_cache(maxsize=4096)
def read(text: str) -> Tree:
    """Read a statement or a term. Raises :class:`NotRead`."""
    words = _Words(text)
    tree = _statement(words)
    if words.here:
        raise NotRead(f"{words.here!r} is left over in {text!r}")
    return tree


def _statement(w: _Words) -> Tree:
    if w.take("exists"):
        names = [w.take()]
        while w.take(","):
            names.append(w.take())
        w.need(":")
        return ("exists", tuple(names), _statement(w))
    left = _implies(w)
    if w.take("<=>"):
        return ("<=>", left, _implies(w))
    return left


def _implies(w: _Words) -> Tree:
    left = _or(w)
    if w.take("=>"):
        return ("=>", left, _implies(w))
    return left


def _or(w: _Words) -> Tree:
    tree = _and(w)
    while w.take("or"):
        tree = ("or", tree, _and(w))
    return tree


def _and(w: _Words) -> Tree:
    tree = _not(w)
    while w.take("and"):
        tree = ("and", tree, _not(w))
    return tree


def _not(w: _Words) -> Tree:
    if w.take("not"):
        return ("not", _not(w))
    left = _sum(w)
    operator = w.take("==", "!=")
    return (operator, left, _sum(w)) if operator else left


def _sum(w: _Words) -> Tree:
    tree = _product(w)
    while operator := w.take("+", "-"):
        tree = (operator, tree, _product(w))
    return tree


def _product(w: _Words) -> Tree:
    tree = _unary(w)
    while operator := w.take("*", "/"):
        tree = (operator, tree, _unary(w))
    return tree


def _unary(w: _Words) -> Tree:
    if w.take("-"):
        return ("minus", _unary(w))
    if w.take("+"):
        return _unary(w)
    return _power(w)


def _power(w: _Words) -> Tree:
    tree = _atom(w)
    while w.take("["):
        digit = w.take("0", "1", "2", "3")
        w.need("]")
        tree = ("coordinate", tree, int(digit))
    if w.take("**", "^"):
        opened = w.take("(")
        sign = -1 if w.take("-") else 1
        tree = ("power", tree, sign * int(w.take()))
        if opened:
            w.need(")")
    return tree


def _atom(w: _Words) -> Tree:
    word = w.take()
    if word == "(":
        inside = _statement(w)
        w.need(")")
        return inside
    if not word:
        raise NotRead("it ends where a term should be")
    if word[0] in "0123456789.":
        return ("number", int(word) if word.isdigit() else Fraction(word))
    if not (word[0].isalpha() or word[0] == "_"):
        raise NotRead(f"unexpected {word!r}")
    if not w.take("("):
        return ("name", word)
    arguments = [_statement(w)]
    while w.take(","):
        arguments.append(_statement(w))
    w.need(")")
    return ("call", word, tuple(arguments))


def names_in(tree: Tree) -> set[str]:
    """Return all names in a tree, those that ``exists`` binds included."""
    found: set[str] = set()
    stack = [tree]
    while stack:
        node = stack.pop()
        if node[0] == "name":
            found.add(node[1])
        elif node[0] == "exists":
            found.update(node[1])
        parts = node[2] if node[0] == "call" else node[1:]
        stack.extend(x for x in parts if isinstance(x, tuple) and x and isinstance(x[0], str))
    return found
