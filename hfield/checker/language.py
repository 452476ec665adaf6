"""The checker's own parser of statements, for the grammar of docs/reference/language.md.

A tree is a tuple that begins with its kind: ``("num", 3)``, ``("name", "q")``, ``("neg", x)``, ``("+", x,
y)`` and likewise for ``- * / == != >= > <= < and or => <=>``, ``("pow", x, 3)``, ``("index", x, 0)``,
``("call", "norm", (x,))``, ``("not", x)``, ``("exists", ("q",), x)``. Two texts have the same meaning if
their trees are equal.
"""

import re
from collections.abc import Callable
from fractions import Fraction
from typing import Literal, NoReturn, TypeAlias

from hfield.checker.budget import spend
from hfield.checker.rejection import MAX_DIGITS, reject, shown

Operator = Literal["+", "-", "*", "/", "==", "!=", ">=", ">", "<=", "<", "and", "or", "=>", "<=>"]
NumberTree = tuple[Literal["num"], int | Fraction]
NameTree = tuple[Literal["name"], str]
Unary = tuple[Literal["neg", "not"], "Tree"]
Binary = tuple[Operator, "Tree", "Tree"]
Indexed = tuple[Literal["pow", "index"], "Tree", int]
Call = tuple[Literal["call"], str, tuple["Tree", ...]]
Exists = tuple[Literal["exists"], tuple[str, ...], "Tree"]
Tree: TypeAlias = NumberTree | NameTree | Unary | Binary | Indexed | Call | Exists
Meaning = tuple[object, ...]
"""What a statement of any kind says, to be compared: a tree, or a word and what its braces contain."""

MAX_LENGTH, MAX_DEPTH, MAX_HEIGHT = 20_000, 100, 200
ORDER: tuple[Literal[">="], Literal[">"], Literal["<="], Literal["<"]] = (">=", ">", "<=", "<")
BINDS: dict[Operator, int] = {"<=>": 1, "=>": 2, "or": 3, "and": 4, "==": 6, "!=": 6}
BINDS |= {">=": 6, ">": 6, "<=": 6, "<": 6, "+": 7, "-": 7, "*": 8, "/": 8}
OPERATORS: dict[str, Operator] = {operator: operator for operator in BINDS}
NOT, COMPARE, SIGN = 5, 6, 9
WORDS = ("and", "or", "not", "exists")
# By the sorts of their values, q for quaternions and s for scalars; other calls are constants of a field.
FUNCTIONS = {"conj": "q", "inv": "q", "vector": "q", "comm": "q", "norm": "s", "trace": "s"} | {
    "scalar": "s"
}
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+(?![A-Za-z0-9_.]))?)"
    r"|(?P<name>[A-Za-z_][A-Za-z0-9_]*)|(?P<sign><=>|=>|==|!=|<=|>=|\*\*|[-+*/^()\[\],:<>]))",
    re.ASCII,  # likewise blanks: every character that looks like a blank is one
)
BLANKS = " \t\n\r\f\v"


def parse(text: str) -> Tree:
    """Read a statement or a term."""
    if len(text) > MAX_LENGTH:
        reject(f"a text of {len(text)} characters; at most {MAX_LENGTH} are read")
    spend(10 + 2 * len(text))
    parser = _Parser(text)
    tree = parser.infix(0)
    if parser.word:
        parser.fail("the expression goes on where it should have ended")
    level, height = [tree], 0
    while level:
        level, height = [x for node in level for x in children(node)], height + 1
        if height > MAX_HEIGHT:
            reject(f"{shown(text)!r} is more than {MAX_HEIGHT} operations high")
    return tree


def walk(tree: Tree) -> list[Tree]:
    """Return the tree and all its subtrees."""
    out, stack = [], [tree]
    while stack:
        node = stack.pop()
        out.append(node)
        stack.extend(children(node))
    spend(len(out))
    return out


def children(tree: Tree) -> tuple[Tree, ...]:
    """Return the immediate subtrees of ``tree``."""
    if tree[0] == "call":
        return tree[2]
    if tree[0] == "exists":
        return (tree[2],)
    return tuple(x for x in tree[1:] if isinstance(x, tuple))


def with_parts(tree: Tree, change: Callable[[Tree], Tree]) -> Tree:
    """Return the tree with the trees directly in it changed."""
    if tree[0] == "num" or tree[0] == "name":
        return tree
    if tree[0] == "call":
        return ("call", tree[1], tuple(map(change, tree[2])))
    if tree[0] == "exists":
        return ("exists", tree[1], change(tree[2]))
    if tree[0] == "neg" or tree[0] == "not":
        return (tree[0], change(tree[1]))
    if tree[0] == "pow" or tree[0] == "index":
        return (tree[0], change(tree[1]), tree[2])
    return (tree[0], change(tree[1]), change(tree[2]))


def substitute(tree: Tree, values: dict[str, Tree]) -> Tree:
    """Substitute trees for names; ``tree`` must not contain ``exists``."""
    spend(1)
    if tree[0] == "name":
        return values.get(tree[1], tree)
    return with_parts(tree, lambda x: substitute(x, values))


CLOSING = {"(": ")", "[": "]", "{": "}"}


def split(text: str, separator: str) -> list[str]:
    """Split a text at the separators outside brackets."""
    parts, closing = [""], list[str]()
    for char in text:
        if char == separator and not closing:
            parts.append("")
            continue
        parts[-1] += char
        if char in CLOSING:
            closing.append(CLOSING[char])
        elif char in ")]}" and (not closing or closing.pop() != char):
            reject(f"the brackets of {shown(text)!r} do not match")
    if closing:
        reject(f"the brackets of {shown(text)!r} do not match")
    return parts


class _Parser:
    """A parser by precedence climbing."""

    def __init__(self, text: str) -> None:
        self.text, self.at, self.depth = text, 0, 0
        self.words: list[tuple[str, str]] = []
        clean = text.translate({0x2212: "-", 0xB7: "*", 0xD7: "*"})
        position, end = 0, len(clean.rstrip(BLANKS))
        while position < end:
            match = _TOKEN.match(clean, position)
            if match is None:
                reject(f"cannot read {shown(text)!r} from character {position + 1} on")
            kind = match.lastgroup or ""
            self.words.append((kind, match[kind]))
            position = match.end()

    @property
    def word(self) -> str:
        """The next word, '' at the end."""
        return self.words[self.at][1] if self.at < len(self.words) else ""

    @property
    def kind(self) -> str:
        """The kind of the next word."""
        return self.words[self.at][0] if self.at < len(self.words) else "end"

    def fail(self, why: str) -> NoReturn:
        """Reject the text."""
        reject(f"cannot read {shown(self.text)!r} at {shown(self.word) or 'its end'!r}: {why}")

    def next(self, *expected: str) -> str:
        """Consume the next word if it is one of the expected ones, else return ''."""
        word = self.word
        if word and word in expected:
            self.at += 1
            return word
        return ""

    def need(self, word: str) -> None:
        """Consume this word, or reject the text."""
        if not self.next(word):
            self.fail(f"expected {word!r}")

    def infix(self, strength: int) -> Tree:
        """Read operands joined by operators that bind more tightly than ``strength``."""
        if self.depth > MAX_DEPTH:
            self.fail(f"it is more than {MAX_DEPTH} levels deep")
        self.depth += 1
        left = self.prefix(strength)
        while (operator := OPERATORS.get(self.word)) and BINDS[operator] > strength:
            self.next(operator)
            binds = BINDS[operator]
            left = operator, left, self.infix(binds - (operator == "=>"))
            next_operator = OPERATORS.get(self.word)
            chains = next_operator is not None and BINDS[next_operator] == binds
            if chains and (binds == COMPARE or operator == "<=>"):
                self.fail(f"{operator!r} does not chain")
        self.depth -= 1
        return left

    def prefix(self, strength: int) -> Tree:
        """Read an operand with its prefix operators."""
        word = self.next("exists", "not", "-", "+")
        if not word:
            return self.power()
        if word == "exists":
            if strength:
                self.fail("'exists' stands in front")
            names = [self.name()]
            while self.next(","):
                names.append(self.name())
            self.need(":")
            return "exists", tuple(names), self.infix(0)
        if word == "not":
            if strength >= COMPARE:
                self.fail("'not' needs parentheses here")
            return "not", self.infix(NOT)
        body = self.infix(SIGN)
        return body if word == "+" else ("neg", body)

    def name(self) -> str:
        """Read a name."""
        if self.kind != "name" or self.word in WORDS:
            self.fail("expected a name")
        return self.next(self.word)

    def power(self) -> Tree:
        """Read an atom with its index and exponent."""
        tree = self.atom()
        if self.next("["):
            place = self.next("0", "1", "2", "3")
            if not place:
                self.fail("expected a coordinate 0, 1, 2 or 3")
            self.need("]")
            if tree[0] == "index":
                self.fail("a coordinate has no coordinates of its own")
            tree = "index", tree, int(place)
        if self.next("**", "^"):
            opened = self.next("(")
            sign = -1 if self.next("-") else 1
            if self.kind != "number" or not self.word.isdigit():
                self.fail("expected an integer exponent")
            exponent = sign * self.integer(self.next(self.word))
            if opened:
                self.need(")")
            tree = "pow", tree, exponent
        if self.word in ("**", "^", "["):
            self.fail("powers and coordinates do not chain")
        return tree

    def integer(self, digits: str) -> int:
        """Return the number, unless it has too many digits."""
        if len(digits) > MAX_DIGITS:
            self.fail(f"a number has more than {MAX_DIGITS} digits")
        return int(digits)

    def atom(self) -> Tree:
        """Read a number, a name, a call or a parenthesis."""
        if self.kind == "number":
            word = self.next(self.word)
            if word.isdigit():
                return "num", self.integer(word)
            digits, _, exponent = word.lower().partition("e")
            if len(digits) > MAX_DIGITS or len(exponent) > 4:
                self.fail("a number is too large")
            spend(abs(int(exponent or 0)) // 50)
            return "num", Fraction(word)
        if self.kind == "name" and self.word not in WORDS:
            name = self.name()
            if not self.next("("):
                return "name", name
            arguments = [self.infix(0)]
            while self.next(","):
                arguments.append(self.infix(0))
            self.need(")")
            return "call", name, tuple(arguments)
        if self.next("("):
            inside = self.infix(0)
            self.need(")")
            return inside
        self.fail("expected a number, a name or a parenthesis")
