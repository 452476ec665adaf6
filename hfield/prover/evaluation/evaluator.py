"""Turn a statement into a function of the values of its unknowns.

What each node is, which terms are quaternions and what a name means is settled once, so that a search
evaluates thousands of places at the cost of the arithmetic. It runs over any :class:`Scalars`, and uses the
product of :mod:`hfield.core.product`. A comparison with an undefined division is false.
"""

from collections.abc import Callable, Iterable, Mapping
from operator import itemgetter, sub
from typing import Any

from hfield.core.product import Constants, conjugate, trace
from hfield.prover.evaluation.scalars import Scalars, Value
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

Values = Mapping[str, Any]
Function = Callable[[Values], Any]
Term = tuple[bool, Function]  # whether it is a tuple of four, and its value


class UndefinedTermError(Exception):
    """A term has no value at this place."""


class Evaluator:
    """Evaluates statements in the algebra whose structure constants are ``trees``.

    ``sorts`` are the unknowns, ``fixed`` the values of the field's constants, by their texts. A truth value
    is whatever the scalars make of a comparison.
    """

    def __init__(
        self,
        scalars: Scalars,
        trees: Iterable[Node] = (),
        sorts: Mapping[str, Sort] | None = None,
        fixed: Values | None = None,
    ) -> None:
        self.scalars, self.sorts, self.fixed = scalars, sorts or {}, fixed or {}
        self.defined = scalars.always  # what the comparison that is being evaluated depends on
        self.partial = 0  # how many terms were read that need not be defined
        self.values: Values = {}
        self.constants = Constants(scalars.zero, scalars.zero, scalars.zero)
        self.structure = [self._term(tree)[1] for tree in trees]

    def bind(self, values: Values) -> Any:
        """Assign values to the unknowns, and to the structure constants, which may depend on them.

        Returns the condition under which the structure constants are defined; elsewhere there is no
        algebra, and nothing that a statement could be about.
        """
        self.values, self.defined = values, self.scalars.always
        try:
            self.constants = Constants(*(f(values) for f in self.structure))
        except UndefinedTermError:
            return False
        return self.defined

    def truth(self, node: Node) -> Any:
        """Evaluate a statement without quantifiers at the values that are bound."""
        return self.function(node)(self.values)

    def term(self, node: Node) -> Value:
        """Evaluate a term to a scalar or to a tuple of four, with the condition of being defined."""
        self.defined = self.scalars.always
        try:
            value = self._term(node)[1](self.values)
        except UndefinedTermError:
            return self.scalars.zero, False
        return value, self.defined

    def embed(self, x: Any) -> tuple[Any, ...]:
        """Return the coordinates of x, where a scalar s is s·e."""
        zero = self.scalars.zero
        return x if isinstance(x, tuple) else (x, zero, zero, zero)

    # --- statements ------------------------------------------------------------------------------

    def function(self, node: Node) -> Function:
        """Return the truth of a statement without quantifiers as a function of the unknowns' values."""
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

    def _joined(self, op: str, f: Function, g: Function) -> Function:
        """Join statements. Where truth is plain one side often settles it; arrays and formulas need both."""
        both, either, negate = self.scalars.both, self.scalars.either, self.scalars.negate

        def conjunction(v: Values) -> object:
            first = f(v)
            return False if first is False else both(first, g(v))

        def disjunction(v: Values) -> object:
            first = f(v)
            return True if first is True else either(first, g(v))

        def implication(v: Values) -> object:
            first = f(v)
            return True if first is False else either(negate(first), g(v))

        def equivalence(v: Values) -> object:
            first, second = f(v), g(v)
            return both(either(negate(first), second), either(first, negate(second)))

        return {"and": conjunction, "or": disjunction, "=>": implication, "<=>": equivalence}[op]

    def _comparison(self, node: Compare) -> Function:
        scalars = self.scalars
        always = scalars.always
        compared = scalars.equal if node.op == "==" else scalars.unequal
        if scalars.reflexive and node.left == node.right:
            return lambda v: compared((), always)
        partial = self.partial
        (four, f), (other, g) = left, right = self._term(node.left), self._term(node.right)
        if four or other:
            f, g = self._embedded(left), self._embedded(right)
        if partial == self.partial:  # nothing divides
            if four and node.right == Number(0):
                return lambda v: compared(f(v), always)
            if four or other:
                return lambda v: compared(map(sub, f(v), g(v)), always)
            return lambda v: compared((f(v) - g(v),), always)

        def compare_quaternions(v: Values) -> object:
            self.defined = always
            try:
                return compared(map(sub, f(v), g(v)), self.defined)
            except UndefinedTermError:
                return False

        def compare_scalars(v: Values) -> object:
            self.defined = always
            try:
                return compared((f(v) - g(v),), self.defined)
            except UndefinedTermError:
                return False

        return compare_quaternions if four or other else compare_scalars

    # --- terms -----------------------------------------------------------------------------------

    def _term(self, node: Node) -> Term:
        """Return the sort of a term, and the function that computes its value."""
        return _READERS[type(node)](self, node)

    def _number(self, node: Number) -> Term:
        """Return a literal, which may be undefined."""
        x, condition = self.scalars.number(node.value)
        if condition is self.scalars.always:
            return False, lambda v: x
        return False, self._noted(lambda _: (x, condition), lambda v: None)

    def _name(self, node: Name) -> Term:
        """Return the value of a name; e, i, j, k are the basis."""
        name = node.name
        if name in self.sorts:
            return self.sorts[name] is Sort.QUATERNION, itemgetter(name)
        if name in self.fixed:
            return False, self._fixed(name)
        zero, one = self.scalars.zero, self.scalars.one
        unit = tuple([one if name == basis else zero for basis in BASIS])
        return True, lambda v: unit

    def _fixed(self, text: str) -> Function:
        value = self.fixed[text]
        return lambda v: value

    def _negated(self, node: Negate) -> Term:
        four, f = self._term(node.operand)
        return four, (lambda v: tuple([-x for x in f(v)])) if four else (lambda v: -f(v))

    def _index(self, node: Index) -> Term:
        coordinates, index = self._embedded(self._term(node.base)), node.index
        return False, lambda v: coordinates(v)[index]

    def _embedded(self, term: Term) -> Function:
        """Return the coordinates of a term, where a scalar s is s·e."""
        four, f = term
        zero = self.scalars.zero
        return f if four else (lambda v: (f(v), zero, zero, zero))

    def _binary(self, node: Binary) -> Term:
        left, right = self._term(node.left), self._term(node.right)
        if node.op in "+-":
            return self._sum(node.op, left, right)
        if node.op == "/":
            right = False, self._noted(self.scalars.reciprocal, right[1])
        return self._product(left, right)

    def _sum(self, op: str, left: Term, right: Term) -> Term:
        (four, f), (other, g) = left, right
        if not (four or other):
            return False, (lambda v: f(v) + g(v)) if op == "+" else (lambda v: f(v) - g(v))
        f, g = self._embedded(left), self._embedded(right)
        if op == "+":
            return True, lambda v: tuple([x + y for x, y in zip(f(v), g(v), strict=True)])
        return True, lambda v: tuple(map(sub, f(v), g(v)))

    def _product(self, left: Term, right: Term) -> Term:
        (four, f), (other, g) = left, right
        if four and other:
            multiply = self.scalars.multiply
            return True, lambda v: multiply(self.constants, f(v), g(v))
        scale, times = self.scalars.scale, self.scalars.times
        if four:
            return True, lambda v: scale(f(v), g(v))
        if other:
            return True, lambda v: scale(g(v), f(v))
        return False, lambda v: times(f(v), g(v))

    def _power(self, node: Power) -> Term:
        """Return a power by repeated squaring; a negative one is one of the inverse."""
        (four, f), exponent = self._term(node.base), node.exponent
        if exponent < 0:
            f = self._noted(self._inverse if four else self.scalars.reciprocal, f)
        one, multiply, times = self.scalars.one, self.scalars.multiply, self.scalars.times

        def power(v: Values) -> Any:
            x, n = f(v), abs(exponent)
            result: Any = None
            while n:
                if n & 1:
                    if result is None:
                        result = x
                    else:
                        result = multiply(self.constants, result, x) if four else times(result, x)
                n >>= 1
                if n:
                    x = multiply(self.constants, x, x) if four else times(x, x)
            return one if result is None else result

        return four and exponent != 0, power

    def _inverse(self, q: Any) -> Value:
        """Return the inverse of a quaternion."""
        factor, defined = self.scalars.reciprocal(self.scalars.norm(self.constants, q))
        return tuple([u * factor for u in conjugate(self.constants, q)]), defined

    def _call(self, node: Call) -> Term:
        """Return the value of a function of quaternions, or a constant of the field that is written so."""
        function = node.function
        if function not in RESULT:
            return False, self._fixed(to_text(node))
        arguments = [self._embedded(self._term(x)) for x in node.arguments]
        f, zero = arguments[0], self.scalars.zero
        if function == "conj":
            return True, lambda v: conjugate(self.constants, f(v))
        if function == "norm":
            norm = self.scalars.norm
            return False, lambda v: norm(self.constants, f(v))
        if function == "trace":
            return False, lambda v: trace(self.constants, f(v))
        if function == "scalar":
            return False, lambda v: f(v)[0]
        if function == "vector":
            return True, lambda v: (zero, *f(v)[1:])
        if function == "inv":
            return True, self._noted(self._inverse, f)
        g, multiply = arguments[1], self.scalars.multiply

        def commutator(v: Values) -> Any:
            p, q, c = f(v), g(v), self.constants
            return tuple(map(sub, multiply(c, p, q), multiply(c, q, p)))

        return True, commutator

    def _noted(self, of: Callable[[Any], Value], f: Function) -> Function:
        """Return ``of`` after ``f``, and note the condition under which it is defined."""
        always, together = self.scalars.always, self.scalars.together
        self.partial += 1

        def value(v: Values) -> Any:
            x, condition = of(f(v))
            if condition is False:
                raise UndefinedTermError
            if condition is not always:
                self.defined = together(self.defined, condition)
            return x

        return value


_READERS: dict[type[Node], Callable[[Evaluator, Any], Term]] = {
    Number: Evaluator._number,
    Name: Evaluator._name,
    Negate: Evaluator._negated,
    Binary: Evaluator._binary,
    Power: Evaluator._power,
    Index: Evaluator._index,
    Call: Evaluator._call,
}
