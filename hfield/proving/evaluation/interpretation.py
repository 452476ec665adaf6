"""One evaluator for statements, over whatever the scalars are.

An :class:`Interpretation` says what scalars are and what a comparison means: elements of a ring and
truth values, numpy arrays of both, or polynomials and formulas about their zeros. The evaluator
walks the tree and multiplies quaternions by the one formula of :mod:`hfield.product`. Every value
comes with the condition under which it is defined.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from hfield.errors import NotInvertibleError
from hfield.product import Constants, conjugate, multiply, norm, trace
from hfield.proving.statements.printing import to_text
from hfield.rings.base import Ring
from hfield.syntax import (
    Binary,
    Call,
    Compare,
    Index,
    Logic,
    Name,
    Negate,
    Node,
    Not,
    Number,
    Power,
)

Value = tuple[Any, Any]  # a scalar or a tuple of four, and the condition under which it is defined


class Interpretation(ABC):
    """What numbers, names and comparisons mean.

    ``constants`` are the structure constants of the algebra, ``values`` the unknowns (scalars, or
    tuples of four) and the constants of the field by their texts; ``always`` is the condition that
    always holds.
    """

    constants: Constants
    values: Mapping[str, Any]
    zero: Any
    one: Any
    always: Any = True

    @abstractmethod
    def number(self, value: int | Fraction) -> Value:
        """Turn a literal into a scalar."""

    @abstractmethod
    def reciprocal(self, x: Any) -> Value:
        """Return 1/x and the condition under which there is one."""

    @abstractmethod
    def equal(self, differences: tuple[Any, ...], defined: Any) -> Any:
        """Return the truth of "defined, and all differences are 0"."""

    @abstractmethod
    def unequal(self, differences: tuple[Any, ...], defined: Any) -> Any:
        """Return the truth of "defined, and some difference is not 0"."""

    def both(self, x: Any, y: Any) -> Any:
        """Return the truth of "x and y", for conditions as for statements."""
        return x & y

    def either(self, x: Any, y: Any) -> Any:
        """Return the truth of "x or y"."""
        return x | y

    def negate(self, x: Any) -> Any:
        """Return the truth of "not x"."""
        return x ^ True

    # --- the evaluator ---------------------------------------------------------------------------

    def truth(self, node: Node) -> Any:
        """Evaluate a statement without quantifiers."""
        match node:
            case Compare(op, left, right):
                x, dx = self.term(left)
                y, dy = self.term(right)
                defined = self.both(dx, dy)
                if not (isinstance(x, tuple) or isinstance(y, tuple)):
                    differences: tuple[Any, ...] = (x - y,)
                else:
                    pairs = zip(self.embed(x), self.embed(y), strict=True)
                    differences = tuple(u - v for u, v in pairs)
                return (self.equal if op == "==" else self.unequal)(differences, defined)
            case Not(x):
                return self.negate(self.truth(x))
            # Where truth is plain, one side often settles it; arrays and formulas need both.
            case Logic("and", x, y):
                first = self.truth(x)
                return False if first is False else self.both(first, self.truth(y))
            case Logic("or", x, y):
                first = self.truth(x)
                return True if first is True else self.either(first, self.truth(y))
            case Logic("=>", x, y):
                first = self.truth(x)
                return True if first is False else self.either(self.negate(first), self.truth(y))
            case Logic("<=>", x, y):
                left, right = self.truth(x), self.truth(y)
                return self.both(
                    self.either(self.negate(left), right), self.either(left, self.negate(right))
                )
        raise AssertionError(node)

    def embed(self, x: Any) -> tuple[Any, ...]:
        """Return the coordinates of x, where a scalar s is s·e."""
        return x if isinstance(x, tuple) else (x, self.zero, self.zero, self.zero)

    def term(self, node: Node) -> Value:
        """Evaluate a term to a scalar or to a tuple of four, with the condition of being defined."""
        match node:
            case Number(value):
                return self.number(value)
            case Name(name):
                return self.name(name), self.always
            case Negate(operand):
                x, d = self.term(operand)
                return (tuple(-u for u in x) if isinstance(x, tuple) else -x), d
            case Binary(op, left, right):
                x, dx = self.term(left)
                y, dy = self.term(right)
                if op == "/":
                    y, inverse_defined = self.reciprocal(y)
                    dy = self.both(dy, inverse_defined)
                return self.binary(op, x, y), self.both(dx, dy)
            case Power(base, exponent):
                x, d = self.term(base)
                if exponent < 0:
                    x, inverse_defined = self.inverse(x)
                    d = self.both(d, inverse_defined)
                return self.power(x, abs(exponent)), d
            case Index(base, index):
                x, d = self.term(base)
                return self.embed(x)[index], d
            case Call(function, arguments) if function in _FUNCTIONS or function == "comm":
                return self.call(function, arguments)
        return self.values[to_text(node)], self.always

    def name(self, name: str) -> Any:
        """Return the value of a name; e, i, j, k are the basis."""
        if name in self.values:
            return self.values[name]
        zero, one = self.zero, self.one
        basis = {"e": 0, "i": 1, "j": 2, "k": 3}[name]
        return tuple(one if n == basis else zero for n in range(4))

    def binary(self, op: str, x: Any, y: Any) -> Any:
        """Return x + y, x − y or x·y of scalars and quaternions."""
        if isinstance(x, tuple) or isinstance(y, tuple):
            if op in "+-":
                pairs = zip(self.embed(x), self.embed(y), strict=True)
                return tuple(u + v if op == "+" else u - v for u, v in pairs)
            if not isinstance(x, tuple):
                return tuple(x * v for v in y)
            if not isinstance(y, tuple):
                return tuple(u * y for u in x)
            return multiply(self.constants, x, y)
        if op == "+":
            return x + y
        return x - y if op == "-" else x * y

    def power(self, x: Any, n: int) -> Any:
        """Return xⁿ for n ≥ 0."""
        result: Any = None
        while n:
            if n & 1:
                result = x if result is None else self.binary("*", result, x)
            n >>= 1
            if n:
                x = self.binary("*", x, x)
        return self.one if result is None else result

    def inverse(self, x: Any) -> Value:
        """Return the inverse of a scalar or a quaternion."""
        if not isinstance(x, tuple):
            return self.reciprocal(x)
        self.charge(x)
        factor, defined = self.reciprocal(norm(self.constants, x))
        bar = conjugate(self.constants, x)
        return tuple(u * factor for u in bar), defined

    def call(self, function: str, arguments: tuple[Node, ...]) -> Value:
        """Return the value of a function."""
        x, d = self.term(arguments[0])
        x = self.embed(x)
        if function == "inv":
            x, inverse_defined = self.inverse(x)
            return x, self.both(d, inverse_defined)
        if function == "comm":
            y, dy = self.term(arguments[1])
            y = self.embed(y)
            xy, yx = self.binary("*", x, y), self.binary("*", y, x)
            return tuple(u - v for u, v in zip(xy, yx, strict=True)), self.both(d, dy)
        if function == "norm":
            self.charge(x)
        return _FUNCTIONS[function](self, x), d

    def charge(self, x: Any) -> None:  # noqa: B027  an offer, not a duty
        """Called before x is multiplied by its conjugate; may refuse what would take too long."""


_FUNCTIONS: dict[str, Any] = {
    "conj": lambda self, q: conjugate(self.constants, q),
    "norm": lambda self, q: norm(self.constants, q),
    "trace": lambda self, q: trace(self.constants, q),
    "scalar": lambda self, q: q[0],
    "vector": lambda self, q: (self.zero, *q[1:]),
    "inv": None,
}


def bind(world: Interpretation, trees: Iterable[Node], values: Mapping[str, Any]) -> Any:
    """Give the names their values, and the structure constants theirs, which may depend on them.

    Returns the condition under which the structure constants are defined; elsewhere there is no
    algebra, and nothing that a statement could be about.
    """
    world.values = values
    (a, at), (t, tt), (b, bt) = map(world.term, trees)
    world.constants = Constants(a, t, b)
    return world.both(world.both(at, tt), bt)


class RingInterpretation(Interpretation):
    """Elements of a ring: a statement becomes true or false."""

    def __init__(self, ring: Ring) -> None:
        self.ring = ring
        self.zero, self.one = ring.zero, ring.one

    def number(self, value: int | Fraction) -> Value:
        """Return the literal in the ring; a denominator that is no unit leaves it undefined."""
        if isinstance(value, int):
            return self.ring(value), True
        x, defined = self.reciprocal(self.ring(value.denominator))
        return self.ring(value.numerator) * x, defined

    def reciprocal(self, x: Any) -> Value:
        """Return 1/x, if x is a unit."""
        try:
            return self.ring.inverse(x), True
        except NotInvertibleError:
            return self.zero, False

    def equal(self, differences: tuple[Any, ...], defined: Any) -> Any:
        """Compare exactly, in the ring."""
        return bool(defined) and all(self.ring.is_zero(d) for d in differences)

    def unequal(self, differences: tuple[Any, ...], defined: Any) -> Any:
        """Compare exactly, in the ring."""
        return bool(defined) and not all(self.ring.is_zero(d) for d in differences)


class PrimeInterpretation(Interpretation):
    """The prime field of a characteristic on Python's own numbers, for fast searches."""

    zero, one = 0, 1

    def __init__(self, p: int) -> None:
        self.p = p

    def number(self, value: int | Fraction) -> Value:
        """Return the literal; in characteristic p its denominator may be 0."""
        if not self.p or isinstance(value, int):
            return value, True
        x, defined = self.reciprocal(value.denominator)
        return value.numerator * x % self.p, defined

    def reciprocal(self, x: Any) -> Value:
        """Return 1/x unless x is 0."""
        if not self.p:
            return (Fraction(1) / x, True) if x else (0, False)
        x %= self.p
        return (pow(x, -1, self.p), True) if x else (0, False)

    def binary(self, op: str, x: Any, y: Any) -> Any:
        """Compute, and keep the numbers small in characteristic p."""
        z = super().binary(op, x, y)
        if not self.p:
            return z
        return tuple(u % self.p for u in z) if isinstance(z, tuple) else z % self.p

    def equal(self, differences: tuple[Any, ...], defined: Any) -> Any:
        """Compare modulo p."""
        return defined and not any(d % self.p if self.p else d for d in differences)

    def unequal(self, differences: tuple[Any, ...], defined: Any) -> Any:
        """Compare modulo p."""
        return defined and any(bool(d % self.p if self.p else d) for d in differences)
