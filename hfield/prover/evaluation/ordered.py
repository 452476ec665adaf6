"""Evaluate statements with moduli and comparisons over RR, exactly or in floats."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from math import inf
from operator import mul
from typing import Any

from hfield.errors import HFieldError
from hfield.fields.base.ring import Ring
from hfield.fields.names import ring
from hfield.prover.evaluation.evaluator import (
    Evaluator,
    Function,
    Term,
    UndefinedTermError,
    Values,
)
from hfield.prover.evaluation.scalars import Decided, RingScalars
from hfield.prover.problem import Problem
from hfield.prover.statements.trees import walk_once
from hfield.prover.statements.words import ARGUMENTS
from hfield.syntax import ORDER, Call, Compare, Node

NEAR_ZERO = 1e-9
SIGNS = {">=": (0, 1), ">": (1,), "<=": (0, -1), "<": (-1,)}


class Numbers(Decided[float, bool]):
    """Floats, with values near 0 rounded to 0, to choose points for exact evaluation."""

    zero, one = 0.0, 1.0
    times = staticmethod(mul)  # type: ignore[assignment]

    def integer(self, n: int) -> float:
        """Return a float."""
        return float(n)

    def reciprocal(self, x: float) -> tuple[float, bool]:
        """Return 1/x unless x is 0."""
        return (1 / x, True) if x else (0.0, False)

    def equal(self, differences: Iterable[float], defined: bool) -> bool:
        """Compare approximately."""
        return not self.unequal(differences, defined)

    def unequal(self, differences: Iterable[float], defined: bool) -> bool:
        """Compare approximately."""
        return any(abs(d) >= NEAR_ZERO for d in differences)


class OrderedEvaluator(Evaluator):
    """Evaluates the statement of a problem over ``scalars``: floats, or elements of an ordered ring."""

    def __init__(self, problem: Problem, scalars: RingScalars | Numbers) -> None:
        read = problem.statement
        assert read.ordered is not None
        self.ring: Ring | None = None if isinstance(scalars, Numbers) else scalars.ring
        field = self.ring or ring("RDF")
        fixed = {text: field(text) for text in read.constants}
        super().__init__(scalars, problem.setting.trees, read.sorts, fixed)
        self.holds = self.function(read.ordered)

    def fails(self, place: Mapping[str, Any]) -> bool:
        """Return whether the algebra exists at a point, and the statement is false there."""
        try:
            return bool(self.bind(place)) and self.holds(place) is False
        except (HFieldError, OverflowError):
            return False

    def margins(self, node: Node) -> list[Callable[[Values], float]]:
        """Return functions of float places that are negative where a comparison is false."""
        out: list[Callable[[Values], float]] = []
        for part in walk_once(node):
            if isinstance(part, Compare) and part.op in ORDER:
                sides = part.left, part.right
                (_, f), (_, g) = map(self._term, sides if part.op in (">=", ">") else sides[::-1])
                out.append(partial(self._difference, f, g))
        return out

    def _difference(self, f: Function, g: Function, place: Values) -> float:
        try:
            return float(f(place) - g(place)) if self.bind(place) else inf
        except (HFieldError, UndefinedTermError, ArithmeticError):
            return inf

    def sign(self, x: Any) -> int:
        """Return the sign of a scalar."""
        if self.ring is None:
            return 0 if abs(x) < NEAR_ZERO else 1 if x > 0 else -1
        return self.ring.sign(x)

    def root(self, x: Any) -> Any:
        """Return the square root of a scalar that is not negative. Raises HFieldError if not known."""
        if self.ring is None:
            return max(x, 0.0) ** 0.5
        found: Any = self.ring.sqrt(x)
        return found if self.sign(found) >= 0 else -found

    def _comparison(self, node: Compare) -> Callable[[Values], Any]:
        if node.op not in ORDER:
            return super()._comparison(node)
        equal, unequal = (
            super(OrderedEvaluator, self)._comparison(Compare(op, node.left, node.right))
            for op in ("==", "!=")
        )
        (_, f), (_, g), signs = self._term(node.left), self._term(node.right), SIGNS[node.op]

        def compare(v: Values) -> bool:
            if equal(v):
                return 0 in signs
            return bool(unequal(v)) and self.sign(f(v) - g(v)) in signs

        return compare

    def _term(self, node: Node) -> Term:
        if not isinstance(node, Call) or node.function not in ARGUMENTS:
            return super()._term(node)
        parts = [self._embedded(self._term(x)) for x in node.arguments]
        scalars, f = self.scalars, parts[0]
        if node.function == "abs":
            return False, lambda v: self.root(scalars.norm(self.constants, f(v)))
        g, zero = parts[1], scalars.zero

        def product(v: Values) -> Any:
            p, q = ((zero, *h(v)[1:]) for h in (f, g))
            return scalars.multiply(self.constants, p, q)

        if node.function == "dot":
            return False, lambda v: -product(v)[0]
        return True, lambda v: (zero, *product(v)[1:])


__all__ = ["Numbers", "OrderedEvaluator"]
