"""Statements made into functions, for searches that evaluate one at thousands of places.

What ``interpretation`` finds by walking the tree at each place is settled once here:
what each node is, which terms are quaternions, what a name means. What is left at a place is the
arithmetic. A term that is undefined there stops its comparison, which is false then.
"""

from collections.abc import Callable, Mapping
from fractions import Fraction
from operator import itemgetter, not_
from typing import Any

from hfield.product import conjugate, multiply, norm, trace
from hfield.proving.evaluation.interpretation import PrimeInterpretation, RingInterpretation
from hfield.proving.statements.language import RESULT, Sort, Statement
from hfield.proving.statements.printing import to_text
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

Values = Mapping[str, Any]
Truth = Callable[[Values], bool]
Function = Callable[[Values], Any]
World = PrimeInterpretation | RingInterpretation
Term = tuple[bool, Function]  # whether it is a tuple of four, and its value

BASIS = {"e": 0, "i": 1, "j": 2, "k": 3}


class _UndefinedError(Exception):
    """A term has no value at this place."""


def compile_statement(statement: Statement, world: World, fixed: Values) -> Truth:
    """Return what tells whether hypotheses ⇒ conclusion is true, given the unknowns' values.

    ``world`` is a ring or a prime field, whose structure constants are set; ``fixed`` are the values
    of the field's constants.
    """
    compiler = _Compiler(world, statement.sorts, fixed)
    hypotheses = [compiler.truth(h) for h in statement.hypotheses]
    conclusion = compiler.truth(statement.conclusion)

    def holds(values: Values) -> bool:
        for hypothesis in hypotheses:
            if not hypothesis(values):
                return True
        return conclusion(values)

    return holds


class _Compiler:
    """Makes functions of nodes; scalars are whatever ``world`` has, with Python's operators."""

    def __init__(self, world: World, sorts: Mapping[str, Sort], fixed: Values) -> None:
        self.world, self.sorts, self.fixed = world, sorts, fixed
        self.p = world.p if isinstance(world, PrimeInterpretation) else 0

    # --- statements ------------------------------------------------------------------------------

    def truth(self, node: Node) -> Truth:
        """Return the truth of a statement without quantifiers."""
        match node:
            case Compare(op, left, right):
                return self.compare(op, self.term(left), self.term(right))
            case Not(x):
                denied = self.truth(x)
                return lambda v: not denied(v)
            case Logic(op, x, y):
                f, g = self.truth(x), self.truth(y)
                if op == "and":
                    return lambda v: f(v) and g(v)
                if op == "or":
                    return lambda v: f(v) or g(v)
                return (lambda v: not f(v) or g(v)) if op == "=>" else (lambda v: f(v) is g(v))
        raise AssertionError(node)

    def compare(self, op: str, left: Term, right: Term) -> Truth:
        """Return the truth of an equality, or of its contrary; false where a side is undefined."""
        is_zero, equal = self.zero_test(), op == "=="
        if left[0] or right[0]:
            four, other = self.embedded(left), self.embedded(right)

            def compare_quaternions(v: Values) -> bool:
                try:
                    pairs = zip(four(v), other(v), strict=True)
                except _UndefinedError:
                    return False
                return all(is_zero(x - y) for x, y in pairs) is equal

            return compare_quaternions
        f, g = left[1], right[1]

        def compare_scalars(v: Values) -> bool:
            try:
                difference = f(v) - g(v)
            except _UndefinedError:
                return False
            return bool(is_zero(difference)) is equal

        return compare_scalars

    def zero_test(self) -> Callable[[Any], bool]:
        """Return what tells whether a scalar is 0."""
        p = self.p
        if p:
            return lambda x: not x % p
        return self.world.ring.is_zero if isinstance(self.world, RingInterpretation) else not_

    # --- terms -----------------------------------------------------------------------------------

    def term(self, node: Node) -> Term:
        """Return what the value of a term is, and what computes it."""
        match node:
            case Number(value):
                return False, self.number(value)
            case Name(name):
                return self.name(name)
            case Negate(operand):
                four, of = self.term(operand)
                return four, (lambda v: tuple(-x for x in of(v))) if four else (lambda v: -of(v))
            case Binary(op, left, right):
                x, y = self.term(left), self.term(right)
                return self.binary(
                    op, x, (False, self.defined(self.world.reciprocal, y[1])) if op == "/" else y
                )
            case Power(base, exponent):
                return self.power(self.term(base), exponent)
            case Index(base, index):
                coordinates = self.embedded(self.term(base))
                return False, lambda v: coordinates(v)[index]
            case Call(function, arguments) if function in RESULT:
                return self.call(function, [self.term(x) for x in arguments])
        value = self.fixed[to_text(node)]
        return False, lambda v: value

    def number(self, value: int | Fraction) -> Function:
        """Return a literal, which may be undefined."""
        x, defined = self.world.number(value)
        return (lambda v: x) if defined else _undefined

    def name(self, name: str) -> Term:
        """Return the value of a name; e, i, j, k are the basis."""
        if name in self.sorts:
            return self.sorts[name] is Sort.QUATERNION, itemgetter(name)
        if name in self.fixed:
            constant = self.fixed[name]
            return False, lambda v: constant
        zero, one = self.world.zero, self.world.one
        unit = tuple(one if n == BASIS[name] else zero for n in range(4))
        return True, lambda v: unit

    def embedded(self, term: Term) -> Function:
        """Return the coordinates of a term, where a scalar s is s·e."""
        four, f = term
        zero = self.world.zero
        return f if four else (lambda v: (f(v), zero, zero, zero))

    def binary(self, op: str, left: Term, right: Term) -> Term:
        """Return a sum, a difference or a product; a quotient comes as a product."""
        (four, f), (other, g) = left, right
        if op == "+":
            if not (four or other):
                return False, lambda v: f(v) + g(v)
            f, g = self.embedded(left), self.embedded(right)
            return True, lambda v: tuple(x + y for x, y in zip(f(v), g(v), strict=True))
        if op == "-":
            if not (four or other):
                return False, lambda v: f(v) - g(v)
            f, g = self.embedded(left), self.embedded(right)
            return True, lambda v: tuple(x - y for x, y in zip(f(v), g(v), strict=True))
        if four and other:
            return True, self.product(f, g)
        if four:
            return True, lambda v: _scaled(f(v), g(v))
        if other:
            return True, lambda v: _scaled(g(v), f(v))
        return False, lambda v: f(v) * g(v)

    def product(self, f: Function, g: Function) -> Function:
        """Return a product of quaternions, in characteristic p of numbers below p."""
        constants, p = self.world.constants, self.p
        if p:
            return lambda v: tuple(x % p for x in multiply(constants, f(v), g(v)))
        return lambda v: multiply(constants, f(v), g(v))

    def power(self, base: Term, exponent: int) -> Term:
        """Return a power; a negative one is one of the inverse."""
        four, f = base
        if exponent < 0:
            f = self.defined(self.world.inverse if four else self.world.reciprocal, f)
        raised, n = self.world.power, abs(exponent)
        return four and n > 0, lambda v: raised(f(v), n)

    def call(self, function: str, arguments: list[Term]) -> Term:
        """Return the value of a function."""
        f, constants = self.embedded(arguments[0]), self.world.constants
        if function == "conj":
            return True, lambda v: conjugate(constants, f(v))
        if function == "norm":
            return False, lambda v: norm(constants, f(v))
        if function == "trace":
            return False, lambda v: trace(constants, f(v))
        if function == "scalar":
            return False, lambda v: f(v)[0]
        if function == "vector":
            zero = self.world.zero
            return True, lambda v: (zero, *f(v)[1:])
        if function == "inv":
            return True, self.defined(self.world.inverse, f)
        g = self.embedded(arguments[1])
        return self.binary("-", (True, self.product(f, g)), (True, self.product(g, f)))

    def defined(self, of_world: Callable[[Any], tuple[Any, bool]], f: Function) -> Function:
        """Return ``of_world`` after ``f``, where it is defined: an inverse or a reciprocal."""

        def value(v: Values) -> Any:
            x, defined = of_world(f(v))
            if not defined:
                raise _UndefinedError
            return x

        return value


def _undefined(values: Values) -> Any:
    raise _UndefinedError


def _scaled(q: Any, s: Any) -> Any:
    a, b, c, d = q
    return a * s, b * s, c * s, d * s
