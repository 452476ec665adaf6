"""Text to syntax tree, by recursive descent; bounded in length, depth and digits."""

import re
from collections.abc import Callable, Iterator
from fractions import Fraction

from hfield.errors import NotationError
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

MAX_LENGTH = 20_000
MAX_DEPTH = 200
MAX_DIGITS = 4_000

_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+(?![\w.]))?)"
    r"|(?P<name>[^\W\d]\w*)|(?P<op><=>|=>|==|!=|\*\*|[-+*/^()\[\],:]))"
)
_SPELLINGS = str.maketrans({"−": "-", "·": "*", "×": "*"})
_WORDS = {"and", "or", "not", "exists"}
_MENDS = {
    "=": "write == for equality",
    "<": "there is no order here: only == and != compare",
    ">": "there is no order here: only == and != compare",
    "%": "there is no remainder here",
    "{": "write parentheses ( )",
    "}": "write parentheses ( )",
}


def parse(text: str) -> Node:
    """Read a statement or a term. Raises :class:`NotationError` with the position of the fault."""
    if len(text) > MAX_LENGTH:
        raise NotationError(
            f"the text has {len(text)} characters, more than the {MAX_LENGTH} that are read"
        )
    if not text.strip():
        raise NotationError("the text is empty; expected an expression such as (1+i)*j")
    parser = _Parser(text)
    node = parser.statement(0)
    if parser.token:
        parser.fail(f"did not expect {parser.token!r} after a complete expression")
    return node


class _Parser:
    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens = list(self._scan(text.translate(_SPELLINGS)))
        self.index = 0

    def _scan(self, text: str) -> Iterator[tuple[str, str, int]]:
        position, end = 0, len(text.rstrip())
        while position < end:
            m = _TOKEN.match(text, position)
            if m is None:
                position += len(text[position:]) - len(text[position:].lstrip())
                bad = text[position]
                mend = _MENDS.get(bad, "expected a number, a name, an operator or a parenthesis")
                raise NotationError(f"cannot read {bad!r}: {mend}", self.text, position)
            kind = m.lastgroup or ""
            yield kind, m[kind], m.start(kind)
            position = m.end()

    @property
    def token(self) -> str:
        return self.tokens[self.index][1] if self.index < len(self.tokens) else ""

    @property
    def kind(self) -> str:
        return self.tokens[self.index][0] if self.index < len(self.tokens) else "end"

    @property
    def position(self) -> int:
        if self.index < len(self.tokens):
            return self.tokens[self.index][2]
        return len(self.text.rstrip())

    def take(self, *expected: str) -> str:
        """Return the current token and go on, if it is one of ``expected``; else return ''."""
        token = self.token
        if token and token in expected:
            self.index += 1
            return token
        return ""

    def need(self, expected: str, why: str) -> None:
        if not self.take(expected):
            found = repr(self.token) if self.token else "the end of the text"
            self.fail(f"expected {expected!r} {why}, found {found}")

    def fail(self, message: str) -> None:
        raise NotationError(message, self.text, self.position)

    def statement(self, depth: int) -> Node:
        position = self.position
        if depth > MAX_DEPTH:
            self.fail(f"the expression nests deeper than {MAX_DEPTH} levels; write it in parts")
        if not self.take("exists"):
            return self.iff(depth)
        names = [self.name("after 'exists'")]
        while self.take(","):
            names.append(self.name("after ','"))
        self.need(":", "after the names of 'exists'")
        return Exists(tuple(names), self.statement(depth + 1), position=position)

    def name(self, where: str) -> str:
        if self.kind != "name" or self.token in _WORDS:
            self.fail(f"expected a name {where}")
        return self.take(self.token)

    def iff(self, depth: int) -> Node:
        left, position = self.implies(depth), self.position
        if not self.take("<=>"):
            return left
        node = Logic("<=>", left, self.implies(depth), position=position)
        if self.token == "<=>":
            self.fail("'<=>' does not chain: put one side in parentheses")
        return node

    def implies(self, depth: int) -> Node:
        if depth > MAX_DEPTH:
            self.fail(f"the expression nests deeper than {MAX_DEPTH} levels; write it in parts")
        left, position = self.chain(depth, ("or",)), self.position
        if not self.take("=>"):
            return left
        return Logic("=>", left, self.implies(depth + 1), position=position)

    def chain(self, depth: int, ops: tuple[str, ...]) -> Node:
        """Read a left-associative chain of the operators ``ops``, for each of the four floors."""
        below: dict[str, Callable[[int], Node]] = {
            "or": lambda d: self.chain(d, ("and",)),
            "and": self.negation,
            "+": lambda d: self.chain(d, ("*", "/")),
            "*": self.unary,
        }
        operand = below[ops[0]]
        node, length = operand(depth), depth
        while True:
            position = self.position
            op = self.take(*ops)
            if not op:
                return node
            length += 1
            if length > 2 * MAX_DEPTH:
                self.fail(f"more than {2 * MAX_DEPTH} operands in a row; write it in parts")
            cls = Logic if op in ("and", "or") else Binary
            node = cls(op, node, operand(depth), position=position)

    def negation(self, depth: int) -> Node:
        position = self.position
        if depth > MAX_DEPTH:
            self.fail(f"the expression nests deeper than {MAX_DEPTH} levels; write it in parts")
        if self.take("not"):
            return Not(self.negation(depth + 1), position=position)
        return self.compare(depth)

    def compare(self, depth: int) -> Node:
        left, position = self.chain(depth, ("+", "-")), self.position
        op = self.take("==", "!=")
        if not op:
            return left
        node = Compare(op, left, self.chain(depth, ("+", "-")), position=position)
        if self.token in ("==", "!="):
            self.fail("comparisons do not chain: write a == b and b == c")
        return node

    def unary(self, depth: int) -> Node:
        position = self.position
        if depth > MAX_DEPTH:
            self.fail(f"the expression nests deeper than {MAX_DEPTH} levels; write it in parts")
        if self.take("-"):
            return Negate(self.unary(depth + 1), position=position)
        if self.take("+"):
            return self.unary(depth + 1)
        return self.power(depth)

    def power(self, depth: int) -> Node:
        base, position = self.postfix(depth), self.position
        if not self.take("**", "^"):
            return base
        node = Power(base, self.exponent(), position=position)
        if self.token in ("**", "^"):
            self.fail("powers do not chain: an exponent is one integer literal")
        return node

    def exponent(self) -> int:
        opened = bool(self.take("("))
        sign = -1 if self.take("-") else 1
        if self.kind != "number" or not self.token.isdigit():
            self.fail("an exponent must be an integer literal, such as **3 or **-1")
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

    def postfix(self, depth: int) -> Node:
        node, position = self.atom(depth), self.position
        while self.take("["):
            if self.token not in ("0", "1", "2", "3"):
                self.fail("a coordinate is q[0], q[1], q[2] or q[3]")
            node = Index(node, int(self.take(self.token)), position=position)
            self.need("]", "after a coordinate's number")
            if self.token == "[":
                self.fail("a coordinate is a scalar and has no coordinates of its own")
        return node

    def atom(self, depth: int) -> Node:
        position, kind, token = self.position, self.kind, self.token
        if kind == "number":
            self.take(token)
            if token.isdigit():
                return Number(self.integer(token), position=position)
            digits, _, exponent = token.lower().partition("e")
            if len(digits) > MAX_DIGITS or len(exponent) > 4:
                self.fail("this decimal number is too large to be read exactly")
            return Number(Fraction(token), position=position)
        if kind == "name" and token not in _WORDS:
            self.take(token)
            if not self.take("("):
                return Name(token, position=position)
            arguments = [self.statement(depth + 1)]
            while self.take(","):
                arguments.append(self.statement(depth + 1))
            self.need(")", f"after the arguments of {token}")
            return Call(token, tuple(arguments), position=position)
        if self.take("("):
            node = self.statement(depth + 1)
            self.need(")", "to close a parenthesis")
            return node
        found = repr(token) if token else "the end of the text"
        self.fail(f"expected a number, a name or '(', found {found}")
        raise AssertionError  # fail() does not return
