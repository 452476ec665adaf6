"""Write terms of the language in Coq's notation.

Coq reads the text, which follows the tree node by node, so that the theorem states what the statement says.
The data is the same tree, which Coq turns into that text by itself. The numerator is a polynomial to which
evidence may refer; it is used only to find hints.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TypeAlias

from hfield.core.product import Constants, conjugate, multiply, norm, trace
from hfield.errors import HFieldError, TooLargeError
from hfield.export.coq.cofactors import MismatchError, Numerator, Numerators
from hfield.prover.statements.language import Sort
from hfield.syntax import Binary, Call, Index, Name, Negate, Node, Number, Power, parse

MAX_SIZE = 200_000  # leaves of a coordinate once everything is unfolded
MAX_EXPONENT = 500
MAX_BITS = 2_000  # of a number
COORDINATES = ("re", "im", "jm", "km")
PLACES = ("at_e", "at_i", "at_j", "at_k")
HAMILTON = ("-1", "0", "-1")
ATOM, APPLICATION, PRODUCT, SUM = range(4)
Quadruple: TypeAlias = tuple[Numerator, Numerator, Numerator, Numerator]


class NotCoveredError(HFieldError, NotImplementedError):
    """A certificate is not translated; the message says what is not covered."""


@dataclass(frozen=True)
class Term:
    """A term of Coq, its data and its value: a numerator, or a tuple of four.

    ``conditions`` are the scalars that must have an inverse. ``size`` counts the leaves of a coordinate after
    unfolding all definitions. ``level`` is the precedence of the text, and ``closed`` is true if no unknown
    occurs.
    """

    text: str
    data: str
    value: Numerator | Quadruple
    size: int = 1
    conditions: tuple["Term", ...] = ()
    level: int = ATOM
    closed: bool = False

    @property
    def is_scalar(self) -> bool:
        """Whether this is a scalar rather than a quaternion."""
        return not isinstance(self.value, tuple)

    @property
    def scalar(self) -> Numerator:
        """The value of a scalar. Raises :class:`MismatchError` for a quaternion."""
        if isinstance(self.value, tuple):
            raise MismatchError(f"{self.text} is a quaternion, where a scalar is expected")
        return self.value

    @property
    def coordinates(self) -> Quadruple:
        """The coordinates of a quaternion. Raises :class:`MismatchError` for a scalar."""
        if not isinstance(self.value, tuple):
            raise MismatchError(f"{self.text} is a scalar, where a quaternion is expected")
        return self.value

    @property
    def inner(self) -> str:
        """The text as the argument of a function."""
        return self.within(ATOM)

    @property
    def argument(self) -> str:
        """The data as the argument of a function."""
        return f"({self.data})" if " " in self.data else self.data

    def within(self, level: int) -> str:
        """Return the text, in parentheses if its operators bind more loosely than ``level``."""
        return self.text if self.level <= level else f"({self.text})"


class Terms:
    """Translates the terms of one statement, in one algebra."""

    def __init__(
        self,
        unknowns: Sequence[tuple[str, Sort]],
        found: Sequence[tuple[str, Sort]],
        constants: Sequence[str],
    ) -> None:
        self.given, self.found = list(unknowns), list(found)
        atoms = []
        for name, sort in self.ordered:
            atoms += [name] if sort is Sort.SCALAR else [f"{name}[{n}]" for n in range(4)]
        self.numerators = Numerators(atoms)
        self.names = self._unknowns()
        # Letters are scalars whatever is found later; constants see the given unknowns only.
        parts = [self.term(parse(text)) for text in constants]
        self.constants = Constants(*(part.scalar for part in parts))
        self.defined = tuple({c.text: c for part in parts for c in part.conditions}.values())
        self.parts = parts
        shown = " ".join(part.inner for part in parts)
        self.algebra = "H" if tuple(constants) == HAMILTON else f"(Algebra {shown})"
        self.weight = 1 if self.algebra == "H" else max(part.size for part in parts)

    @property
    def ordered(self) -> list[tuple[str, Sort]]:
        """The unknowns: given ones before existential ones, quaternions first."""
        out: list[tuple[str, Sort]] = []
        for sort in (Sort.QUATERNION, Sort.SCALAR):
            for group in (self.given, self.found):
                out += [(name, s) for name, s in group if s is sort]
        return out

    def _unknowns(self) -> dict[str, Term]:
        n = self.numerators
        zero, one = n.number(0), n.number(1)
        out, counts = {}, {Sort.QUATERNION: 0, Sort.SCALAR: 0}
        for letter, place in zip("eijk", PLACES, strict=True):
            value = _quadruple(one if x == letter else zero for x in "eijk")
            out[letter] = Term(letter, f"QBasis {place}", value, closed=True)
        for name, sort in self.ordered:
            k = counts[sort]
            counts[sort] += 1
            if sort is Sort.SCALAR:
                out[name] = Term(name, f"SVar {k}", n.atom(name))
            else:
                value = _quadruple(n.atom(f"{name}[{m}]") for m in range(4))
                out[name] = Term(name, f"QVar {k}", value)
        return out

    def embed(self, x: Term) -> Term:
        """Return a scalar as a multiple of e."""
        if not x.is_scalar:
            return x
        zero = self.numerators.number(0)
        return _applied("embed", "QEmbed", x, (x.scalar, zero, zero, zero))

    def term(self, node: Node) -> Term:
        """Translate a term. Raises :class:`TooLargeError` if it would be too large to check."""
        out = self._term(node)
        if out.size > MAX_SIZE:
            raise TooLargeError(f"a term has more than {MAX_SIZE} leaves when it is unfolded")
        return out

    def _term(self, node: Node) -> Term:
        match node:
            case Number(value):
                return self.number(value)
            case Name(name) if name in self.names:
                return self.names[name]
            case Name(name):
                raise NotCoveredError(f"{name!r} names a constant of the field")
            case Negate(operand):
                x = self.term(operand)
                negative = -x.scalar if x.is_scalar else _quadruple(-u for u in x.coordinates)
                inner = x.within(APPLICATION)
                inner = f"({inner})" if inner in ("0", "1") else inner
                text = f"{'-' if x.is_scalar else '[-]'} {inner}"
                data = f"{'SNeg' if x.is_scalar else 'QNeg'} {x.argument}"
                return Term(text, data, negative, x.size, x.conditions, SUM, x.closed)
            case Binary(op, left, right):
                return self.binary(op, self.term(left), self.term(right))
            case Power(base, exponent):
                return self.power(self.term(base), exponent)
            case Index(base, index):
                return self.coordinate(self.term(base), index)
            case Call(
                "conj" | "norm" | "trace" | "inv" | "scalar" | "vector" | "comm" as f, arguments
            ):
                return self.call(f, [self.term(x) for x in arguments])
            case Call(function, _):
                raise NotCoveredError(f"{function}(...) is a constant of the field")
        raise AssertionError(node)

    def coordinate(self, x: Term, n: int) -> Term:
        """Return the coordinate number n."""
        x = self.embed(x)
        return _applied(COORDINATES[n], f"SCoordinate {PLACES[n]}", x, x.coordinates[n])

    def number(self, value: int | Fraction) -> Term:
        """Return a literal."""
        if isinstance(value, Fraction) and value.denominator != 1:
            return self.binary("/", self.number(value.numerator), self.number(value.denominator))
        n = int(value)
        if n.bit_length() > MAX_BITS:
            raise TooLargeError(f"a number has more than {MAX_BITS} bits")
        shown = str(n) if n >= 0 else f"({n})"
        text = str(n) if n in (0, 1) else f"num {shown}"
        level = ATOM if n in (0, 1) else APPLICATION
        own = self.numerators.number(n)
        return Term(
            text, f"SNum {shown}", own, max(2 * n.bit_length(), 1), level=level, closed=True
        )

    def binary(self, op: str, x: Term, y: Term) -> Term:
        """Return the sum, difference, product or quotient of two terms."""
        conditions = _joined(x, y)
        size, closed = x.size + y.size, x.closed and y.closed
        if op == "/":
            value, conditions = self.numerators.inverse(y.scalar), _joined(x, y, (y,))
            result = (
                x.scalar * value if x.is_scalar else _quadruple(u * value for u in x.coordinates)
            )
            data = f"{'SDiv' if x.is_scalar else 'QOver'} {x.argument} {y.argument}"
            sign = "/" if x.is_scalar else "[/]"
            return _infix(x, sign, y, data, result, size, conditions, closed)
        letter = {"+": "Add", "-": "Sub", "*": "Mul"}[op]
        if x.is_scalar and y.is_scalar:
            u, v = x.scalar, y.scalar
            value = {"+": u.__add__, "-": u.__sub__, "*": u.__mul__}[op](v)
            data = f"S{letter} {x.argument} {y.argument}"
            return _infix(x, op, y, data, value, size, conditions, closed)
        if op in "+-":
            x, y = self.embed(x), self.embed(y)
            pairs = zip(x.coordinates, y.coordinates, strict=True)
            sums = _quadruple(u + v if op == "+" else u - v for u, v in pairs)
            data = f"Q{letter} {x.argument} {y.argument}"
            return _infix(x, f"[{op}]", y, data, sums, size, conditions, closed)
        if x.is_scalar or y.is_scalar:
            s, q = (x, y) if x.is_scalar else (y, x)
            scaled = _quadruple(s.scalar * u for u in q.coordinates)
            data = f"QScale {s.argument} {q.argument}"
            return _infix(s, "[.]", q, data, scaled, size, conditions, closed)
        size = 5 * (size + 3 * self.weight)
        product = multiply(self.constants, x.coordinates, y.coordinates)
        data = f"QMul {x.argument} {y.argument}"
        return _infix(x, f"[*{self.algebra}]", y, data, product, size, conditions, closed)

    def power(self, x: Term, n: int) -> Term:
        """Return a power; the power with exponent 0 is 1."""
        if abs(n) > MAX_EXPONENT:
            raise TooLargeError(f"the exponent {n} is larger than {MAX_EXPONENT}")
        if n < 0:
            x, n = self.inverse(x), -n
        out = self.number(1) if x.is_scalar else self.names["e"]
        for m in range(n):
            out = x if m == 0 else self.binary("*", x, out)
            if out.size > MAX_SIZE:
                raise TooLargeError(f"the power {n} is too large to unfold")
        text = f"pow {x.inner} {n}" if x.is_scalar else f"qpow {self.algebra} {x.inner} {n}"
        data = f"{'SPow' if x.is_scalar else 'QPow'} {x.argument} {n}"
        return Term(text, data, out.value, out.size, x.conditions, APPLICATION, x.closed)

    def inverse(self, x: Term) -> Term:
        """Return the inverse of a scalar or a quaternion."""
        divisor = x if x.is_scalar else self.call("norm", [x])
        value = self.numerators.inverse(divisor.scalar)
        conditions = _joined(x, divisor, (divisor,))
        if x.is_scalar:
            made = _applied("inv", "SInv", x, value)
        else:
            bar = _quadruple(u * value for u in conjugate(self.constants, x.coordinates))
            size = divisor.size + 2 * x.size
            made = _applied(f"qinv {self.algebra}", "QInv", x, bar, size)
        return replace(made, conditions=conditions)

    def call(self, function: str, arguments: list[Term]) -> Term:
        """Return the value of a function of the language."""
        x, c = self.embed(arguments[0]), self.constants
        value: Numerator | Quadruple
        match function:
            case "inv":
                return self.inverse(x)
            case "scalar":
                return self.coordinate(x, 0)
            case "comm":
                y = self.embed(arguments[1])
                xy, yx = (self.binary("*", *pair) for pair in ((x, y), (y, x)))
                pairs = zip(xy.coordinates, yx.coordinates, strict=True)
                value = _quadruple(u - v for u, v in pairs)
                text = f"comm {self.algebra} {x.inner} {y.inner}"
                data, size = f"QComm {x.argument} {y.argument}", xy.size + yx.size
                closed = x.closed and y.closed
                return Term(text, data, value, size, _joined(x, y), APPLICATION, closed)
            case "vector":
                return _applied(
                    "vector", "QVector", x, (self.numerators.number(0), *x.coordinates[1:])
                )
            case "conj":
                value, size, data = conjugate(c, x.coordinates), x.size + 2 * self.weight, "QConj"
            case "trace":
                value, size, data = trace(c, x.coordinates), 3 * x.size + self.weight, "STrace"
            case _:
                value, size, data = norm(c, x.coordinates), 14 * (x.size + self.weight), "SNorm"
        return _applied(f"{function} {self.algebra}", data, x, value, size)


def _quadruple(parts: Iterable[Numerator]) -> Quadruple:
    w, x, y, z = parts
    return w, x, y, z


def _applied(
    function: str, data: str, x: Term, value: Numerator | Quadruple, size: int = 0
) -> Term:
    """Return the application of a function to one argument; the size defaults to the argument's."""
    text, data, size = f"{function} {x.inner}", f"{data} {x.argument}", size or x.size
    return Term(text, data, value, size, x.conditions, APPLICATION, x.closed)


def _infix(
    x: Term,
    sign: str,
    y: Term,
    data: str,
    value: Numerator | Quadruple,
    size: int,
    conditions: tuple[Term, ...],
    closed: bool,
) -> Term:
    """Join two terms; all operators associate to the left."""
    level = SUM if sign.strip("[]") in ("+", "-") else PRODUCT
    text = f"{x.within(level)} {sign} {y.within(level - 1)}"
    return Term(text, data, value, size, conditions, level, closed)


def _joined(x: Term, y: Term, more: tuple[Term, ...] = ()) -> tuple[Term, ...]:
    """Return the union of two lists of conditions, innermost first."""
    return tuple({c.text: c for c in (*x.conditions, *y.conditions, *more)}.values())
