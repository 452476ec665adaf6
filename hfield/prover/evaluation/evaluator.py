"""Turn a statement into a function of the values of its unknowns.

The sort of each node and the meaning of each name are determined once, so a search that evaluates thousands
of points pays only for the arithmetic. The scalars can be any :class:`Scalars`; products use
:mod:`hfield.core.product`. A comparison with an undefined division is false.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from operator import itemgetter, sub
from typing import Generic, TypeAlias, TypeVar

from hfield.core.product import Constants, conjugate, trace
from hfield.prover.evaluation.scalars import C, Four, S, Scalars, T
from hfield.prover.statements.language import BASIS, RESULT, Sort
from hfield.prover.statements.printing import to_text
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

Values: TypeAlias = Mapping[str, S | tuple[S, ...]]
V = TypeVar("V")
Truth: TypeAlias = Callable[[Values[S]], T]


@dataclass(frozen=True)
class ScalarTerm(Generic[S]):
    """A term whose values are scalars."""

    value: Callable[[Values[S]], S]


@dataclass(frozen=True)
class QuaternionTerm(Generic[S]):
    """A term whose values are tuples of four scalars."""

    value: Callable[[Values[S]], Four[S]]


Term: TypeAlias = ScalarTerm[S] | QuaternionTerm[S]


class UndefinedTermError(Exception):
    """A term has no value at this point."""


class Evaluator(Generic[S, C, T]):
    """Evaluates statements in the algebra whose structure constants are ``trees``.

    ``sorts`` are the unknowns, ``fixed`` the values of the field's constants, by text. The type of a truth
    value is determined by the scalars.
    """

    def __init__(
        self,
        scalars: Scalars[S, C, T],
        trees: Iterable[Node] = (),
        sorts: Mapping[str, Sort] | None = None,
        fixed: Mapping[str, S] | None = None,
    ) -> None:
        self.scalars, self.sorts = scalars, sorts or {}
        self.fixed: Mapping[str, S] = fixed or {}
        self.defined = scalars.always  # the conditions of the comparison that is being evaluated
        self.partial = 0  # how many terms were read that need not be defined
        self.values: Values[S] = {}
        self.constants = Constants(scalars.zero, scalars.zero, scalars.zero)
        self.structure = [self._scalar(self._term(tree)) for tree in trees]

    def bind(self, values: Values[S]) -> C:
        """Assign values to the unknowns, and to the structure constants, which may depend on the unknowns.

        Return the condition under which the structure constants are defined. Where it is false there is no
        algebra, and the statement has no content.
        """
        self.values, self.defined = values, self.scalars.always
        try:
            self.constants = Constants(*(f(values) for f in self.structure))
        except UndefinedTermError:
            return self.scalars.never
        return self.defined

    def truth(self, node: Node) -> T:
        """Evaluate a quantifier-free statement at the current values."""
        return self.function(node)(self.values)

    def term(self, node: Node) -> tuple[S | Four[S], C]:
        """Evaluate a term to a scalar or a tuple of four, with the condition that it is defined."""
        self.defined = self.scalars.always
        try:
            value = self._term(node).value(self.values)
        except UndefinedTermError:
            return self.scalars.zero, self.scalars.never
        return value, self.defined

    def embed(self, x: S | Four[S]) -> Four[S]:
        """Return the coordinates of x; a scalar s counts as s·e."""
        zero = self.scalars.zero
        return x if isinstance(x, tuple) else (x, zero, zero, zero)

    # --- statements ------------------------------------------------------------------------------

    def function(self, node: Node) -> Truth[S, T]:
        """Return the truth of a quantifier-free statement as a function of the unknowns' values."""
        scalars = self.scalars
        match node:
            case Compare():
                return self._comparison(node)
            case Not(x):
                denied, negate = self.function(x), scalars.negate
                return lambda v: negate(denied(v))
            case Logic(op, x, y):
                return self._joined(op, self.function(x), self.function(y))
        raise AssertionError(node)

    def _joined(self, op: str, f: Truth[S, T], g: Truth[S, T]) -> Truth[S, T]:
        """Join statements. If truth values are plain, one side often decides; arrays and formulas
        need both.
        """
        both, either, negate = self.scalars.both, self.scalars.either, self.scalars.negate
        true, false = self.scalars.true, self.scalars.false

        def conjunction(v: Values[S]) -> T:
            first = f(v)
            return false if first is false else both(first, g(v))

        def disjunction(v: Values[S]) -> T:
            first = f(v)
            return true if first is true else either(first, g(v))

        def implication(v: Values[S]) -> T:
            first = f(v)
            return true if first is false else either(negate(first), g(v))

        def equivalence(v: Values[S]) -> T:
            first, second = f(v), g(v)
            return both(either(negate(first), second), either(first, negate(second)))

        return {"and": conjunction, "or": disjunction, "=>": implication, "<=>": equivalence}[op]

    def _comparison(self, node: Compare) -> Truth[S, T]:
        scalars = self.scalars
        always, false = scalars.always, scalars.false
        compared = scalars.equal if node.op == "==" else scalars.unequal
        if scalars.reflexive and node.left == node.right:
            return lambda v: compared((), always)
        partial = self.partial
        left, right = self._term(node.left), self._term(node.right)
        defined = partial == self.partial  # nothing divides
        if isinstance(left, ScalarTerm) and isinstance(right, ScalarTerm):
            return self._compared_scalars(compared, left.value, right.value, defined)
        p, q = self._embedded(left), self._embedded(right)
        if defined and isinstance(left, QuaternionTerm) and node.right == Number(0):
            return lambda v: compared(p(v), always)
        if defined:
            return lambda v: compared(map(sub, p(v), q(v)), always)

        def compare_quaternions(v: Values[S]) -> T:
            self.defined = always
            try:
                return compared(map(sub, p(v), q(v)), self.defined)
            except UndefinedTermError:
                return false

        return compare_quaternions

    def _compared_scalars(
        self,
        compared: Callable[[Iterable[S], C], T],
        f: Callable[[Values[S]], S],
        g: Callable[[Values[S]], S],
        defined: bool,
    ) -> Truth[S, T]:
        always, false = self.scalars.always, self.scalars.false
        if defined:
            return lambda v: compared((f(v) - g(v),), always)

        def compare_scalars(v: Values[S]) -> T:
            self.defined = always
            try:
                return compared((f(v) - g(v),), self.defined)
            except UndefinedTermError:
                return false

        return compare_scalars

    # --- terms -----------------------------------------------------------------------------------

    def _term(self, node: Node) -> Term[S]:
        """Return the sort of a term, and the function that computes its value."""
        match node:
            case Number():
                return self._number(node)
            case Name():
                return self._name(node)
            case Negate():
                return self._negated(node)
            case Binary():
                return self._binary(node)
            case Power():
                return self._power(node)
            case Index():
                return self._index(node)
            case Call():
                return self._call(node)
        raise AssertionError(node)

    def _number(self, node: Number) -> Term[S]:
        """Return a literal, which may be undefined."""
        x, condition = self.scalars.number(node.value)
        if condition is self.scalars.always:
            return ScalarTerm(lambda v: x)
        return ScalarTerm(self._noted(lambda v: (x, condition)))

    def _name(self, node: Name) -> Term[S]:
        """Return the value of a name; e, i, j, k are the basis."""
        name = node.name
        if name in self.sorts:
            four = self.sorts[name] is Sort.QUATERNION
            return QuaternionTerm(itemgetter(name)) if four else ScalarTerm(itemgetter(name))
        if name in self.fixed:
            return self._fixed(name)
        zero, one = self.scalars.zero, self.scalars.one
        a, b, c, d = [one if name == basis else zero for basis in BASIS]
        unit = (a, b, c, d)
        return QuaternionTerm(lambda v: unit)

    def _fixed(self, text: str) -> Term[S]:
        value = self.fixed[text]
        return ScalarTerm(lambda v: value)

    def _negated(self, node: Negate) -> Term[S]:
        term = self._term(node.operand)
        if isinstance(term, ScalarTerm):
            scalar = term.value
            return ScalarTerm(lambda v: -scalar(v))
        quaternion = term.value

        def negative(v: Values[S]) -> Four[S]:
            a, b, c, d = quaternion(v)
            return (-a, -b, -c, -d)

        return QuaternionTerm(negative)

    def _index(self, node: Index) -> Term[S]:
        coordinates, index = self._embedded(self._term(node.base)), node.index
        return ScalarTerm(lambda v: coordinates(v)[index])

    def _embedded(self, term: Term[S]) -> Callable[[Values[S]], Four[S]]:
        """Return the coordinates of a term; a scalar s counts as s·e."""
        if isinstance(term, QuaternionTerm):
            return term.value
        f, zero = term.value, self.scalars.zero
        return lambda v: (f(v), zero, zero, zero)

    @staticmethod
    def _scalar(term: Term[S]) -> Callable[[Values[S]], S]:
        """Return the value of a term that is a scalar by its place."""
        assert isinstance(term, ScalarTerm)
        return term.value

    def _binary(self, node: Binary) -> Term[S]:
        left, right = self._term(node.left), self._term(node.right)
        if node.op in "+-":
            return self._sum(node.op, left, right)
        if node.op == "/":
            below, reciprocal = self._scalar(right), self.scalars.reciprocal
            right = ScalarTerm(self._noted(lambda v: reciprocal(below(v))))
        return self._product(left, right)

    def _sum(self, op: str, left: Term[S], right: Term[S]) -> Term[S]:
        if isinstance(left, ScalarTerm) and isinstance(right, ScalarTerm):
            f, g = left.value, right.value
            return ScalarTerm((lambda v: f(v) + g(v)) if op == "+" else (lambda v: f(v) - g(v)))
        p, q = self._embedded(left), self._embedded(right)

        def added(v: Values[S]) -> Four[S]:
            (a, b, c, d), (w, x, y, z) = p(v), q(v)
            return (a + w, b + x, c + y, d + z)

        def subtracted(v: Values[S]) -> Four[S]:
            return difference(p(v), q(v))

        return QuaternionTerm(added if op == "+" else subtracted)

    def _product(self, left: Term[S], right: Term[S]) -> Term[S]:
        scale, times, multiply = self.scalars.scale, self.scalars.times, self.scalars.multiply
        if isinstance(left, ScalarTerm):
            f = left.value
            if isinstance(right, ScalarTerm):
                g = right.value
                return ScalarTerm(lambda v: times(f(v), g(v)))
            q = right.value
            return QuaternionTerm(lambda v: scale(q(v), f(v)))
        p = left.value
        if isinstance(right, ScalarTerm):
            g = right.value
            return QuaternionTerm(lambda v: scale(p(v), g(v)))
        q = right.value
        return QuaternionTerm(lambda v: multiply(self.constants, p(v), q(v)))

    def _power(self, node: Power) -> Term[S]:
        """Return a power by repeated squaring; a negative power is a power of the inverse."""
        term, exponent = self._term(node.base), node.exponent
        one, times, multiply = self.scalars.one, self.scalars.times, self.scalars.multiply
        if exponent == 0:  # of what has to be defined
            base: Callable[[Values[S]], S | Four[S]] = term.value
            return ScalarTerm(lambda v: (base(v), one)[1])
        if isinstance(term, ScalarTerm):
            f, reciprocal = term.value, self.scalars.reciprocal
            x = f if exponent > 0 else self._noted(lambda v: reciprocal(f(v)))
            return ScalarTerm(lambda v: power(x(v), abs(exponent), times))
        g = term.value
        q = g if exponent > 0 else self._noted(lambda v: self._inverse(g(v)))

        def product(x: Four[S], y: Four[S]) -> Four[S]:
            return multiply(self.constants, x, y)

        return QuaternionTerm(lambda v: power(q(v), abs(exponent), product))

    def _inverse(self, q: Four[S]) -> tuple[Four[S], C]:
        """Return the inverse of a quaternion."""
        factor, defined = self.scalars.reciprocal(self.scalars.norm(self.constants, q))
        w, x, y, z = conjugate(self.constants, q)
        return (w * factor, x * factor, y * factor, z * factor), defined

    def _call(self, node: Call) -> Term[S]:
        """Return the value of a function of quaternions, or of a constant of the field written as a call."""
        function = node.function
        if function not in RESULT:
            return self._fixed(to_text(node))
        arguments = [self._embedded(self._term(x)) for x in node.arguments]
        f, zero = arguments[0], self.scalars.zero
        if function == "conj":
            return QuaternionTerm(lambda v: conjugate(self.constants, f(v)))
        if function == "norm":
            norm = self.scalars.norm
            return ScalarTerm(lambda v: norm(self.constants, f(v)))
        if function == "trace":
            return ScalarTerm(lambda v: trace(self.constants, f(v)))
        if function == "scalar":
            return ScalarTerm(lambda v: f(v)[0])
        if function == "vector":
            return QuaternionTerm(lambda v: (zero, *f(v)[1:]))
        if function == "inv":
            return QuaternionTerm(self._noted(lambda v: self._inverse(f(v))))
        g, multiply = arguments[1], self.scalars.multiply

        def commutator(v: Values[S]) -> Four[S]:
            p, q, c = f(v), g(v), self.constants
            return difference(multiply(c, p, q), multiply(c, q, p))

        return QuaternionTerm(commutator)

    def _noted(self, of: Callable[[Values[S]], tuple[V, C]]) -> Callable[[Values[S]], V]:
        """Return the value, and note the condition under which it is defined."""
        always, never, together = self.scalars.always, self.scalars.never, self.scalars.together
        self.partial += 1

        def value(v: Values[S]) -> V:
            x, condition = of(v)
            if condition is never:
                raise UndefinedTermError
            if condition is not always:
                self.defined = together(self.defined, condition)
            return x

        return value


def difference(p: Four[S], q: Four[S]) -> Four[S]:
    """Return p − q."""
    (a, b, c, d), (w, x, y, z) = p, q
    return (a - w, b - x, c - y, d - z)


def power(x: V, n: int, times: Callable[[V, V], V]) -> V:
    """Return xⁿ for n > 0 by repeated squaring."""
    result: V | None = None
    while n:
        if n & 1:
            result = x if result is None else times(result, x)
        n >>= 1
        if n:
            x = times(x, x)
    assert result is not None
    return result
