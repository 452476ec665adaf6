"""Statements with moduli and comparisons: about an ordered field, in its real closure.

Their proofs are found over RR, and hold over every real closed field, so for all elements of every ordered
field. Elements of the field itself refute: rational numbers, which all ordered fields have, are tried first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from operator import mul
from random import Random
from typing import Any

from hfield.certificates.glossary import COUNTEREXAMPLE, FLOATS
from hfield.errors import HFieldError
from hfield.evidence import Evidence, Kind
from hfield.fields.names import ring
from hfield.proving.attempts import Attempts
from hfield.proving.counterexamples.candidates import by_weight, prime_scalars, shown, witness_texts
from hfield.proving.decision import (
    FIELD,
    ORDERED_FIELDS,
    PROVED,
    REFUTED,
    VACUOUS,
    Decision,
    undecided,
)
from hfield.proving.evaluation.evaluator import Evaluator, Term, Values
from hfield.proving.evaluation.scalars import Decided, RingScalars
from hfield.proving.evaluation.searcher import Assignment, lifted, read_back
from hfield.proving.problem import Problem
from hfield.proving.statements.language import Sort
from hfield.proving.statements.trees import walk_once
from hfield.proving.statements.words import ARGUMENTS
from hfield.proving.steps import say
from hfield.rings.base import Ring
from hfield.syntax import ORDER, Call, Compare, Node

SMALL, INTEGERS, FRACTIONS = 400, 400, 800  # places that are tried
HEAVIEST = 12
NEAR_ZERO = 1e-9

Found = dict[str, Any]


def decide(problem: Problem, tried: Callable[[Problem], Decision]) -> Decision:
    """Decide a statement with an order; ``tried`` decides what it says over RR."""
    field = problem.field
    reals = problem.over(ring("RR"))
    if field is not None and not field.is_exact:
        why = f"{field.name} is inexact, so nothing is decided by its order: decide over RR or QQ"
        return undecided(why, method=FLOATS)
    if field is not None and not field.is_field and problem.statement.divides:
        return undecided(f"a statement with an order that divides is decided over fields, not {field.name}")
    attempts = Attempts()
    for text in problem.statement.constants:
        if attempts.answer(reals.ring, text) is None:
            name = "" if field is None else field.name
            return undecided(f"{text} in {name} has several orderings, of which none is the usual one")
    found = attempts.answer(counterexample, problem, reals)
    if found is not None:
        return refuted(problem, found)
    decision = attempts.answer(tried, reals)
    if decision is None:
        return undecided(*attempts.refusals, "counterexamples of rational numbers")
    if decision.verdict in (PROVED, VACUOUS):
        scope = ORDERED_FIELDS if field is None else FIELD
        steps = decision.steps if field == reals.field else (say("real-closure"), *decision.steps)
        scope_shown = None if decision.scope is None and decision.verdict == VACUOUS else scope
        return replace(decision, scope=scope_shown, steps=steps)
    if decision.verdict == REFUTED and field != reals.field:
        own = _in_field(problem, decision)
        if own is None:
            return undecided("counterexamples of rational numbers", "sums of squares over RR")
        return refuted(problem, own)
    return decision


def refuted(problem: Problem, found: Assignment) -> Decision:
    """Return the refutation by elements of the field, or by rational numbers."""
    field = problem.field or ring("QQ")
    witness = witness_texts(field, found)
    steps = (say("false-at", F=field.name, values=shown(witness)) if witness else say("false"),)
    evidence = Evidence(Kind.WITNESS, ring=field.data, values=witness)
    if problem.field is None:
        witness = {**witness, "F": [field.name]}
    return Decision(REFUTED, COUNTEREXAMPLE, witness=witness, steps=steps, evidence=evidence)


def _in_field(problem: Problem, decision: Decision) -> Assignment | None:
    """Return the values of a counterexample over RR as elements of the field; None where they are not."""
    field = problem.field or ring("QQ")
    texts = {name: texts for name, texts in (decision.witness or {}).items()}
    own = {name: texts[name] for name, _ in _unknowns(problem) if name in texts}
    try:
        values = read_back(field, own)
        reals = read_back(ring("RR"), own)
    except HFieldError:
        return None
    return values if _Search(problem.over(ring("RR")), RingScalars(ring("RR"))).fails(reals) else None


def _unknowns(problem: Problem) -> tuple[tuple[str, Sort], ...]:
    """Return the unknowns of the statement before its words are written out."""
    read = problem.statement
    return tuple((name, sort) for name, sort in read.unknowns if name not in read.helpers)


def counterexample(problem: Problem, reals: Problem) -> Assignment | None:
    """Look for rational numbers at which the statement is false."""
    field = problem.field or ring("QQ")
    whole = not field.is_field
    exact = _Search(reals, RingScalars(reals.ring))
    assert problem.statement.ordered is not None
    irrational = problem.statement.constants or any(
        isinstance(n, Call) and n.function == "abs" for n in walk_once(problem.statement.ordered)
    )
    quick = _Search(reals, _Numbers() if irrational else RingScalars(ring("QQ")))
    for place in _places(problem, whole):
        if problem.is_late:
            return None
        if quick.fails(place if irrational else lifted(ring("QQ"), place)):
            there = lifted(reals.ring, place)
            if exact.fails(there):
                return lifted(field, place)
    return None


def _places(problem: Problem, whole: bool) -> Iterator[Assignment]:
    """Run through values of the unknowns: small integers, then larger ones, then fractions."""
    unknowns = _unknowns(problem)
    yield from islice(by_weight(unknowns, prime_scalars(0), HEAVIEST, problem.letters), SMALL)
    rng = Random(len(unknowns))

    def fraction() -> Fraction:
        return Fraction(rng.randint(-12, 12), rng.choice((1, 2, 3, 4, 10))) * rng.choice((1, 1, 9))

    for number, make in ((INTEGERS, lambda: rng.randint(-4, 4)), (FRACTIONS, fraction)):
        if whole and make is fraction:
            return
        for _ in range(number):
            yield {
                name: make() if sort is Sort.SCALAR else tuple(make() for _ in range(4))
                for name, sort in unknowns
            }


class _Numbers(Decided[float, bool]):
    """Floats, where what is nearly 0 counts as 0: they tell which places to look at exactly."""

    zero, one = 0.0, 1.0
    times = staticmethod(mul)  # type: ignore[assignment]

    def integer(self, n: int) -> float:
        """Return a float."""
        return float(n)

    def reciprocal(self, x: float) -> tuple[float, bool]:
        """Return 1/x unless x is 0."""
        return (1 / x, True) if x else (0.0, False)

    def equal(self, differences: Any, defined: bool) -> bool:
        """Compare approximately."""
        return defined and all(abs(d) < NEAR_ZERO for d in differences)

    def unequal(self, differences: Any, defined: bool) -> bool:
        """Compare approximately."""
        return defined and any(abs(d) >= NEAR_ZERO for d in differences)


class _Search(Evaluator):
    """Evaluates a statement with moduli and comparisons at places of RR, over exact numbers or floats."""

    def __init__(self, reals: Problem, scalars: RingScalars | _Numbers) -> None:
        read = reals.statement
        assert read.ordered is not None
        fixed: dict[str, Any] = {text: reals.ring(text) for text in read.constants}
        self.floats = isinstance(scalars, _Numbers)
        if self.floats:
            fixed = {text: float(ring("RDF")(text)) for text in fixed}
        self.number_field: Ring | None = None if isinstance(scalars, _Numbers) else scalars.ring
        super().__init__(scalars, reals.setting.trees, read.sorts, fixed)
        self.holds = self.function(read.ordered)

    def fails(self, place: Mapping[str, Any]) -> bool:
        """Tell whether the algebra exists at a place, and the statement is false there."""
        if self.floats:
            place = {
                name: tuple(map(float, x)) if isinstance(x, tuple) else float(x)
                for name, x in place.items()
            }
        try:
            return bool(self.bind(place)) and self.holds(place) is False
        except (HFieldError, OverflowError):
            return False

    def sign(self, x: Any) -> int:
        """Return the sign of a scalar."""
        if self.number_field is None:
            return 0 if abs(x) < NEAR_ZERO else 1 if x > 0 else -1
        return self.number_field.sign(x)

    def root(self, x: Any) -> Any:
        """Return the square root of a scalar that is not negative."""
        if self.number_field is None:
            return max(x, 0.0) ** 0.5
        found = self.number_field.sqrt(x)
        return found if found is None or self.sign(found) >= 0 else -found

    def _comparison(self, node: Compare) -> Callable[[Values], Any]:
        if node.op not in ORDER:
            return super()._comparison(node)
        difference = super()._comparison(Compare("==", node.left, node.right))
        (_, f), (_, g) = self._term(node.left), self._term(node.right)
        wanted = {">=": (0, 1), ">": (1,), "<=": (0, -1), "<": (-1,)}[node.op]
        exists = super()._comparison(Compare("!=", node.left, node.right))

        def compare(v: Values) -> bool:
            if difference(v):
                return 0 in wanted
            return bool(exists(v)) and self.sign(f(v) - g(v)) in wanted

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
