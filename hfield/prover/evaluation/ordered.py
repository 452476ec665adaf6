"""Evaluate statements with moduli and comparisons over RR, exactly or in floats."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from math import inf
from operator import mul

from hfield.errors import HFieldError
from hfield.fields.names import ring
from hfield.prover.evaluation.evaluator import (
    Evaluator,
    QuaternionTerm,
    ScalarTerm,
    Term,
    Truth,
    UndefinedTermError,
    Values,
)
from hfield.prover.evaluation.scalars import Four, OrderedScalars, S
from hfield.prover.problem import Problem
from hfield.prover.statements.trees import walk_once
from hfield.prover.statements.words import ARGUMENTS
from hfield.syntax import ORDER, Call, Compare, Node

NEAR_ZERO = 1e-9
SIGNS = {">=": (0, 1), ">": (1,), "<=": (0, -1), "<": (-1,)}


class Numbers(OrderedScalars[float]):
    """Floats, with values near 0 rounded to 0, to choose points for exact evaluation."""

    zero, one = 0.0, 1.0
    times = staticmethod(mul)  # type: ignore[assignment]

    def integer(self, n: int) -> float:
        """Return a float."""
        return float(n)

    def constant(self, text: str) -> float:
        """Return the float near the number that a text names."""
        return float(ring("RDF")(text))

    def sign(self, x: float) -> int:
        """Return the sign, 0 near 0."""
        return 0 if abs(x) < NEAR_ZERO else 1 if x > 0 else -1

    def root(self, x: float) -> float:
        """Return the square root, 0 for a negative number."""
        return float(max(x, 0.0) ** 0.5)

    def reciprocal(self, x: float) -> tuple[float, bool]:
        """Return 1/x unless x is 0."""
        return (1 / x, True) if x else (0.0, False)

    def equal(self, differences: Iterable[float], defined: bool) -> bool:
        """Compare approximately."""
        return not self.unequal(differences, defined)

    def unequal(self, differences: Iterable[float], defined: bool) -> bool:
        """Compare approximately."""
        return any(abs(d) >= NEAR_ZERO for d in differences)


class OrderedEvaluator(Evaluator[S, bool, bool]):
    """Evaluates the statement of a problem over ``scalars``: floats, or elements of an ordered ring."""

    def __init__(self, problem: Problem, scalars: OrderedScalars[S]) -> None:
        read = problem.statement
        assert read.ordered is not None
        self.sign, self.root = scalars.sign, scalars.root
        fixed = {text: scalars.constant(text) for text in read.constants}
        super().__init__(scalars, problem.setting.trees, read.sorts, fixed)
        self.holds = self.function(read.ordered)

    def fails(self, place: Values[S]) -> bool:
        """Return whether at a point the algebra exists and the statement is false."""
        try:
            return bool(self.bind(place)) and self.holds(place) is False
        except (HFieldError, OverflowError):
            return False

    def margins(
        self: OrderedEvaluator[float], node: Node
    ) -> list[Callable[[Values[float]], float]]:
        """Return functions of float points that are negative where a comparison is false."""
        out: list[Callable[[Values[float]], float]] = []
        for part in walk_once(node):
            if isinstance(part, Compare) and part.op in ORDER:
                sides = part.left, part.right
                terms = map(self._term, sides if part.op in (">=", ">") else sides[::-1])
                f, g = map(self._scalar, terms)
                out.append(partial(self._difference, f, g))
        return out

    def _difference(
        self: OrderedEvaluator[float],
        f: Callable[[Values[float]], float],
        g: Callable[[Values[float]], float],
        place: Values[float],
    ) -> float:
        try:
            return f(place) - g(place) if self.bind(place) else inf
        except (HFieldError, UndefinedTermError, ArithmeticError):
            return inf

    def _comparison(self, node: Compare) -> Truth[S, bool]:
        if node.op not in ORDER:
            return super()._comparison(node)
        equal, unequal = (
            super(OrderedEvaluator, self)._comparison(Compare(op, node.left, node.right))
            for op in ("==", "!=")
        )
        f, g = (self._scalar(self._term(side)) for side in (node.left, node.right))
        signs = SIGNS[node.op]

        def compare(v: Values[S]) -> bool:
            if equal(v):
                return 0 in signs
            return bool(unequal(v)) and self.sign(f(v) - g(v)) in signs

        return compare

    def _term(self, node: Node) -> Term[S]:
        if not isinstance(node, Call) or node.function not in ARGUMENTS:
            return super()._term(node)
        parts = [self._embedded(self._term(x)) for x in node.arguments]
        scalars, f = self.scalars, parts[0]
        if node.function == "abs":
            return ScalarTerm(lambda v: self.root(scalars.norm(self.constants, f(v))))
        g, zero = parts[1], scalars.zero

        def product(v: Values[S]) -> Four[S]:
            return scalars.multiply(self.constants, (zero, *f(v)[1:]), (zero, *g(v)[1:]))

        if node.function == "dot":
            return ScalarTerm(lambda v: -product(v)[0])
        return QuaternionTerm(lambda v: (zero, *product(v)[1:]))


__all__ = ["Numbers", "OrderedEvaluator"]
