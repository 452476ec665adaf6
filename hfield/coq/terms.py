"""Terms of the language in Coq's notation, each with its value as polynomials.

The text is what Coq reads: it follows the tree node by node, so that the theorem says what the
statement says. The value only serves to find the proof. A divisor d brings a variable of its own
for ``inv d``, which the equation ``d·inv d = 1`` ties to d where d is known not to be 0.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import Ordering, fmpz_mpoly_ctx

from hfield.errors import TooLargeError
from hfield.product import Constants, conjugate, multiply, norm, trace
from hfield.proving.statements.language import Sort, Statement
from hfield.proving.statements.trees import walk
from hfield.syntax import Binary, Call, Compare, Index, Name, Negate, Node, Number, Power, parse

MAX_SIZE = 50_000  # leaves of a coordinate once everything is unfolded, as Coq has to read it
MAX_EXPONENT = 500
MAX_BITS = 2_000  # of a number
MAX_TERMS = 200_000  # of the polynomials multiplied here
SPARE = 12  # inverses beyond those of divisors: of what the proof finds not to be 0
COORDINATES = ("re", "im", "jm", "km")
HAMILTON = ("-1", "0", "-1")
ATOM, APPLICATION, PRODUCT, SUM = range(4)


@dataclass(frozen=True)
class Term:
    """A term of Coq, its value (a polynomial, or a tuple of four), and where it has one.

    ``conditions`` are the scalars that must not be 0. ``size`` counts the leaves of a coordinate
    when all definitions are unfolded, ``level`` tells how loosely the text binds.
    """

    text: str
    value: Any
    size: int = 1
    conditions: tuple["Term", ...] = ()
    level: int = ATOM

    @property
    def is_scalar(self) -> bool:
        """Whether this is a scalar, and no quaternion."""
        return not isinstance(self.value, tuple)

    @property
    def inner(self) -> str:
        """The text as the argument of a function."""
        return self.within(ATOM)

    def within(self, level: int) -> str:
        """Return the text, in parentheses if it binds more loosely than ``level``."""
        return self.text if self.level <= level else f"({self.text})"


class Terms:
    """Translates the terms of one statement, in one algebra."""

    def __init__(self, statement: Statement, constants: Sequence[str]) -> None:
        nodes = [n for h in (*statement.hypotheses, statement.conclusion) for n in walk(h)]
        divisors = sum(isinstance(n, Binary | Call | Power | Number | Compare) for n in nodes)
        self.atoms: list[str] = []
        for name, sort in statement.unknowns:
            self.atoms += [name] if sort is Sort.SCALAR else [f"{c} {name}" for c in COORDINATES]
        self.known = len(self.atoms)
        self.inverses: dict[str, int] = {}
        self.room = self.known + min(divisors, 40) + SPARE
        self.context = fmpz_mpoly_ctx.get([f"v{n}" for n in range(self.room)], Ordering.degrevlex)
        self.gens = self.context.gens()
        self.names = self._unknowns(statement)
        parts = [self.term(parse(text)) for text in constants]
        if any(part.conditions for part in parts):
            raise TooLargeError("structure constants that divide are not exported")
        self.constants = Constants(*(part.value for part in parts))
        shown = " ".join(part.inner for part in parts)
        self.algebra = "H" if tuple(constants) == HAMILTON else f"(Algebra {shown})"
        self.weight = max(part.size for part in parts)

    def _unknowns(self, statement: Statement) -> dict[str, Term]:
        out, at = {}, 0
        for name, sort in statement.unknowns:
            width = 1 if sort is Sort.SCALAR else 4
            value = self.gens[at] if width == 1 else tuple(self.gens[at : at + 4])
            out[name] = Term(name, value)
            at += width
        zero, one = self.integer(0), self.integer(1)
        for n, name in enumerate("eijk"):
            coordinates = tuple(one if m == n else zero for m in range(4))
            out[name] = Term(name, coordinates)
        return out

    def integer(self, n: int) -> Any:
        """Return an integer as a polynomial."""
        return self.context.constant(n)

    def inverse_of(self, d: Term) -> Any:
        """Return the variable that stands for ``inv d``. Raises TooLargeError when there is none left."""
        if d.text not in self.inverses:
            if len(self.atoms) == self.room:
                raise TooLargeError("too many things are divided by, or found not to be 0")
            self.inverses[d.text] = len(self.atoms)
            self.atoms.append(f"inv {d.inner}")
        return self.gens[self.inverses[d.text]]

    def embed(self, x: Term) -> Term:
        """Return a scalar as a multiple of e."""
        if not x.is_scalar:
            return x
        zero = self.integer(0)
        value = (x.value, zero, zero, zero)
        return Term(f"embed {x.inner}", value, x.size, x.conditions, APPLICATION)

    def term(self, node: Node) -> Term:
        """Translate a term. Raises :class:`TooLargeError` for what would be too large to check."""
        out = self._term(node)
        if out.size > MAX_SIZE:
            raise TooLargeError(f"a term has more than {MAX_SIZE} leaves when it is unfolded")
        return out

    def _term(self, node: Node) -> Term:
        match node:
            case Number(value):
                return self.number(value)
            case Name(name):
                return self.names[name]
            case Negate(operand):
                x = self.term(operand)
                negative = -x.value if x.is_scalar else tuple(-u for u in x.value)
                inner = x.within(APPLICATION)
                inner = f"({inner})" if inner in ("0", "1") else inner
                text = f"{'-' if x.is_scalar else '[-]'} {inner}"
                return Term(text, negative, x.size, x.conditions, SUM)
            case Binary(op, left, right):
                return self.binary(op, self.term(left), self.term(right))
            case Power(base, exponent):
                return self.power(self.term(base), exponent)
            case Index(base, index):
                return self.coordinate(self.term(base), index)
            case Call(function, arguments):
                return self.call(function, [self.term(x) for x in arguments])
        raise AssertionError(node)

    def coordinate(self, x: Term, n: int) -> Term:
        """Return the coordinate number n."""
        x = self.embed(x)
        text = f"{COORDINATES[n]} {x.inner}"
        return Term(text, x.value[n], x.size, x.conditions, APPLICATION)

    def number(self, value: int | Fraction) -> Term:
        """Return a literal."""
        if isinstance(value, Fraction) and value.denominator != 1:
            return self.binary("/", self.number(value.numerator), self.number(value.denominator))
        n = int(value)
        if n.bit_length() > MAX_BITS:
            raise TooLargeError(f"a number has more than {MAX_BITS} bits")
        text = str(n) if n in (0, 1) else f"num {n}" if n > 0 else f"num ({n})"
        level = ATOM if n in (0, 1) else APPLICATION
        return Term(text, self.integer(n), max(2 * n.bit_length(), 1), level=level)

    def binary(self, op: str, x: Term, y: Term) -> Term:
        """Return a sum, difference, product or quotient."""
        conditions = _joined(x, y)
        size = x.size + y.size
        if op == "/":
            value, conditions = self.inverse_of(y), _joined(x, y, (y,))
            result = x.value * value if x.is_scalar else tuple(u * value for u in x.value)
            return _infix(x, "/" if x.is_scalar else "[/]", y, result, size, conditions)
        if x.is_scalar and y.is_scalar:
            self._bound(x, y, op)
            value = {"+": x.value.__add__, "-": x.value.__sub__, "*": x.value.__mul__}[op](y.value)
            return _infix(x, op, y, value, size, conditions)
        if op in "+-":
            x, y = self.embed(x), self.embed(y)
            pairs = zip(x.value, y.value, strict=True)
            sums = tuple(u + v if op == "+" else u - v for u, v in pairs)
            return _infix(x, f"[{op}]", y, sums, size, conditions)
        self._bound(x, y, op)
        if x.is_scalar or y.is_scalar:
            s, q = (x, y) if x.is_scalar else (y, x)
            return _infix(s, "[.]", q, tuple(s.value * u for u in q.value), size, conditions)
        size = 5 * (size + 3 * self.weight)
        product = multiply(self.constants, x.value, y.value)
        return _infix(x, f"[*{self.algebra}]", y, product, size, conditions)

    def _bound(self, x: Term, y: Term, op: str) -> None:
        if op == "*" and _length(x) * _length(y) > MAX_TERMS:
            raise TooLargeError(f"a product has more than {MAX_TERMS} terms")

    def power(self, x: Term, n: int) -> Term:
        """Return a power; the zeroth is 1."""
        if abs(n) > MAX_EXPONENT:
            raise TooLargeError(f"the exponent {n} is larger than {MAX_EXPONENT}")
        if n < 0:
            x, n = self.inverse(x), -n
        one = self.number(1) if x.is_scalar else self.names["e"]
        out = Term(one.text, one.value, conditions=x.conditions)
        for m in range(n):
            out = x if m == 0 else self.binary("*", x, out)
            if out.size > MAX_SIZE:
                raise TooLargeError(f"the power {n} is too large to unfold")
        text = f"pow {x.inner} {n}" if x.is_scalar else f"qpow {self.algebra} {x.inner} {n}"
        return Term(text, out.value, out.size, out.conditions, APPLICATION)

    def inverse(self, x: Term) -> Term:
        """Return the inverse of a scalar or a quaternion."""
        divisor = x if x.is_scalar else self.call("norm", [x])
        value = self.inverse_of(divisor)
        conditions = _joined(x, divisor, (divisor,))
        if x.is_scalar:
            return Term(f"inv {x.inner}", value, x.size, conditions, APPLICATION)
        bar = tuple(u * value for u in conjugate(self.constants, x.value))
        size = divisor.size + 2 * x.size
        return Term(f"qinv {self.algebra} {x.inner}", bar, size, conditions, APPLICATION)

    def call(self, function: str, arguments: list[Term]) -> Term:
        """Return the value of a function of the language."""
        x, c = self.embed(arguments[0]), self.constants
        match function:
            case "inv":
                return self.inverse(x)
            case "scalar":
                return self.coordinate(x, 0)
            case "comm":
                y = self.embed(arguments[1])
                xy, yx = (self.binary("*", *pair) for pair in ((x, y), (y, x)))
                value = tuple(u - v for u, v in zip(xy.value, yx.value, strict=True))
                text, size = f"{x.inner} {y.inner}", xy.size + yx.size
                return self._applied("comm", text, value, size, _joined(x, y))
            case "vector":
                text, value = f"vector {x.inner}", (self.integer(0), *x.value[1:])
                return Term(text, value, x.size, x.conditions, APPLICATION)
            case "conj":
                value, size = conjugate(c, x.value), x.size + 2 * self.weight
            case "trace":
                value, size = trace(c, x.value), 3 * x.size + self.weight
            case _:
                self._bound(x, x, "*")
                value, size = norm(c, x.value), 14 * (x.size + self.weight)
        return self._applied(function, x.inner, value, size, x.conditions)

    def _applied(
        self, function: str, text: str, value: Any, size: int, conditions: tuple[Term, ...]
    ) -> Term:
        return Term(f"{function} {self.algebra} {text}", value, size, conditions, APPLICATION)


def _infix(
    x: Term, sign: str, y: Term, value: Any, size: int, conditions: tuple[Term, ...]
) -> Term:
    """Join two terms; all operators associate to the left."""
    level = SUM if sign.strip("[]") in ("+", "-") else PRODUCT
    text = f"{x.within(level)} {sign} {y.within(level - 1)}"
    return Term(text, value, size, conditions, level)


def _length(x: Term) -> int:
    return len(x.value) if x.is_scalar else sum(map(len, x.value))


def _joined(x: Term, y: Term, more: tuple[Term, ...] = ()) -> tuple[Term, ...]:
    """Return the conditions of both, each once, the deepest first."""
    return tuple({c.text: c for c in (*x.conditions, *y.conditions, *more)}.values())
