"""Parse text to a syntax tree by precedence climbing, bounded in length, depth, height and digits."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import lru_cache
from typing import NoReturn

from hfield.errors import NotationError
from hfield.syntax.products import MAX_DEPTH
from hfield.syntax.spelling import MAX_LENGTH, NAMES_OF_FUNCTIONS
from hfield.syntax.tree import (
    ORDER,
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

MAX_HEIGHT = 400  # nodes of the tree; walking it takes one frame per level
MAX_DIGITS = 4_000

# Precedence of infix operators; operators of equal precedence associate to the left, except "=>".
BINDS = {"<=>": 1, "=>": 2, "or": 3, "and": 4, "==": 6, "!=": 6, "+": 7, "-": 7, "*": 8, "/": 8}
BINDS |= dict.fromkeys(ORDER, 6)
NOT, COMPARE, UNARY = 5, 6, 9

_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+(?![\w.]))?)"
    r"|(?P<name>[^\W\d]\w*)|(?P<op><=>|=>|==|!=|<=|>=|\*\*|[-+*/^()\[\],:<>]))",
    re.ASCII,  # only one way to write a digit or a name: characters that look alike are equal
)
_BLANKS = " \t\n\r\f\v"
_SPELLINGS = str.maketrans({"−": "-", "·": "*", "×": "*"})
_PREFIXES = ("exists", "not", "-", "+")
_WORDS = {"and", "or", "not", "exists"}
_MENDS = {
    "=": "write == for equality",
    "%": "there is no remainder here",
    "|": "the norm of q is norm(q)",
    "∀": "unknowns stand for all elements, without a sign",
    "{": "write parentheses ( )",
    "}": "write parentheses ( )",
    ";": "join statements by and",
}
_JOINS = {"implies": "=>", "then": "=>", "iff": "<=>"}
_COMMAND = re.compile(r"\\[A-Za-z]+")
_FOR_ALL = ("forall", "all", "every", "for")


@lru_cache(maxsize=1024)
def parse(text: str) -> Node:
    """Read a statement or a term. Raises :class:`NotationError` with the position of the error."""
    if len(text) > MAX_LENGTH:
        raise NotationError(
            f"the text has {len(text)} characters, more than the {MAX_LENGTH} that are read"
        )
    if not text.strip():
        raise NotationError("the text is empty; expected an expression such as (1+i)*j")
    parser = _TreeParser(text)
    node = parser.expression(0, 0)
    if parser.token:
        parser.fail(f"did not expect {parser.token!r} after a complete expression{parser.mend()}")
    return node


class _TreeParser:
    """The parser of one text; its methods consume tokens and return trees."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens = self._scan(text.translate(_SPELLINGS))
        self.index = -1
        self.heights: dict[int, int] = {}
        self.step()

    def _scan(self, text: str) -> list[tuple[str, str, int]]:
        """Return the kind, the text and the position of all tokens, with an empty one at the end."""
        tokens, position, end = [], 0, len(text.rstrip(_BLANKS))
        while position < end:
            m = _TOKEN.match(text, position)
            if m is None:
                position += len(text[position:]) - len(text[position:].lstrip(_BLANKS))
                bad = text[position]
                mend = _MENDS.get(bad, "expected a number, a name, an operator or a parenthesis")
                mend = "write an ordinary blank" if bad.isspace() else mend
                if command := _COMMAND.match(text, position):
                    bad, mend = command[0], "this command of LaTeX is not known here"
                raise NotationError(f"cannot read {bad!r}: {mend}", self.text, position)
            kind = m.lastgroup or ""
            tokens.append((kind, m[kind], m.start(kind)))
            position = m.end()
        return [*tokens, ("end", "", end)]

    # --- tokens --------------------------------------------------------------------------------

    def step(self) -> None:
        """Advance to the next token."""
        self.index += 1
        self.kind, self.token, self.position = self.tokens[self.index]

    def take(self, *expected: str) -> str:
        """Return the current token and advance, if it is one of ``expected``; else return ''."""
        token = self.token
        if token and token in expected:
            self.step()
            return token
        return ""

    def need(self, expected: str, why: str) -> None:
        if not self.take(expected):
            found = repr(self.token) if self.token else "the end of the text"
            self.fail(f"expected {expected!r} {why}, found {found}")

    def fail(self, message: str) -> NoReturn:
        raise NotationError(message, self.text, self.position)

    def mend(self) -> str:
        """Return the corrected text if a product sign is missing, as in ``2q``."""
        before = self.tokens[self.index - 1][1]
        if before in _FOR_ALL:
            return f": unknowns stand for all elements, write the statement without {before!r}"
        if before == "there":
            return ": write exists q: …"
        if before == "if":
            return ": write h => goal for “if h then goal”"
        if self.token in _JOINS:
            return f": write {_JOINS[self.token]}"
        if self.token == ",":
            return ": join statements by and"
        if before in NAMES_OF_FUNCTIONS and self.kind in ("name", "number"):
            return f": write {before}({self.token})"
        if (
            (self.kind != "name" and self.token != "(")
            or self.token in _WORDS
            or not (before[-1].isalnum() or before == ")")
        ):
            return ""
        units = set(self.token) <= set("ijk")  # 2ij is two products
        product = "*".join(self.token) if units else self.token
        return ": write " + (
            f"* before {product}" if ")" in before or product == "(" else f"{before}*{product}"
        )

    def grow(self, node: Node, *children: Node) -> Node:
        """Record the depth of the tree, and raise an error before recursion would overflow."""
        height = 1 + max((self.heights.get(id(child), 0) for child in children), default=0)
        if height > MAX_HEIGHT:
            self.fail(f"more than {MAX_HEIGHT} operations build on each other; write it in parts")
        self.heights[id(node)] = height
        return node

    # --- trees ---------------------------------------------------------------------------------

    def expression(self, strength: int, depth: int) -> Node:
        """Read operands joined by infix operators that bind more tightly than ``strength``."""
        if depth > MAX_DEPTH:
            self.fail(f"the expression nests deeper than {MAX_DEPTH} levels; write it in parts")
        left = self.prefix(strength, depth)
        while (binds := BINDS.get(self.token, 0)) > strength:
            position, op = self.position, self.token
            self.step()
            right = self.expression(binds - 1 if op == "=>" else binds, depth + 1)
            cls = Compare if binds == COMPARE else Binary if binds > COMPARE else Logic
            left = self.grow(cls(op, left, right, position=position), left, right)
            if binds == COMPARE and BINDS.get(self.token) == COMPARE:
                self.fail("a comparison with != does not chain: write a != b and b != c")
            if op == "<=>" and self.token == "<=>":
                self.fail("'<=>' does not chain: put one side in parentheses")
        return left

    def prefix(self, strength: int, depth: int) -> Node:
        """Read an operand with its prefix: exists, not, a sign."""
        position, op = self.position, self.take(*_PREFIXES)
        if not op:
            return self.power(depth)
        if op == "exists":
            if strength:
                self.fail("'exists' stands at the front of a statement or of a parenthesis")
            names = [self.name("after 'exists'")]
            while self.take(","):
                names.append(self.name("after ','"))
            self.need(":", "after the names of 'exists'")
            body = self.expression(0, depth + 1)
            return self.grow(Exists(tuple(names), body, position=position), body)
        if op == "not":
            if strength >= COMPARE:
                self.fail("'not' binds less tightly than what stands before it; use parentheses")
            operand = self.expression(NOT, depth + 1)
            return self.grow(Not(operand, position=position), operand)
        operand = self.expression(UNARY, depth + 1)
        return operand if op == "+" else self.grow(Negate(operand, position=position), operand)

    def name(self, where: str) -> str:
        if self.kind != "name" or self.token in _WORDS:
            self.fail(f"expected a name {where}")
        return self.take(self.token)

    def power(self, depth: int) -> Node:
        """Read an atom with its indices and its exponent."""
        node, position = self.atom(depth), self.position
        while self.take("["):
            if isinstance(node, Index):
                self.fail("a coordinate is a scalar and has no coordinates of its own")
            if self.token not in ("0", "1", "2", "3"):
                self.fail("a coordinate is q[0], q[1], q[2] or q[3]")
            node = self.grow(Index(node, int(self.take(self.token)), position=position), node)
            self.need("]", "after a coordinate's number")
        position = self.position
        if not self.take("**", "^"):
            return node
        node = self.grow(Power(node, self.exponent(), position=position), node)
        if self.token in ("**", "^"):
            self.fail("powers do not chain: an exponent is one integer literal")
        return node

    def exponent(self) -> int:
        opened = bool(self.take("("))
        sign = -1 if self.take("-") else 1
        if self.kind != "number" or not self.token.isdigit():
            conjugate = "; the conjugate of q is conj(q)" if self.token in ("*", "") else ""
            self.fail(f"an exponent must be an integer literal, such as **3 or **-1{conjugate}")
        value = sign * self.integer(self.take(self.token))
        if opened:
            if self.token != ")":
                self.fail("an exponent must be an integer literal, such as **3 or **(-1)")
            self.take(")")
        return value

    def integer(self, digits: str) -> int:
        if len(digits) > MAX_DIGITS:
            self.fail(f"a number of {len(digits)} digits; at most {MAX_DIGITS} are read")
        return int(digits)

    def atom(self, depth: int) -> Node:
        position, kind, token = self.position, self.kind, self.token
        if kind == "number":
            self.step()
            if token.isdigit():
                return Number(self.integer(token), position=position)
            digits, _, exponent = token.lower().partition("e")
            if len(digits) > MAX_DIGITS or len(exponent) > 4:
                self.fail("this decimal number is too large to be read exactly")
            return Number(Fraction(token), position=position)
        if kind == "name" and token not in _WORDS:
            self.step()
            if not self.take("("):
                return Name(token, position=position)
            arguments = [self.expression(0, depth + 1)]
            while self.take(","):
                arguments.append(self.expression(0, depth + 1))
            self.need(")", f"after the arguments of {token}")
            return self.grow(Call(token, tuple(arguments), position=position), *arguments)
        if self.take("("):
            node = self.expression(0, depth + 1)
            if self.token == ",":
                self.fail(
                    "parentheses hold one expression, or the four coordinates of a quaternion"
                )
            self.need(")", "to close a parenthesis")
            return node
        found = repr(token) if token else "the end of the text"
        before = self.tokens[self.index - 1][1] if self.index else ""
        conjugate = "; the conjugate of q is conj(q)" if before == "*" else ""
        self.fail(f"expected a number, a name or '(', found {found}{conjugate}")
