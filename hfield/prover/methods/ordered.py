"""Decide statements with moduli and comparisons, about ordered fields.

Proofs are found over RR. They hold over every real closed field, hence for all elements of every ordered
field. A counterexample has values in the field itself. Rational numbers, which every ordered field contains,
are tried first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from random import Random

from hfield.checker.glossary import COUNTEREXAMPLE, FLOATS
from hfield.errors import HFieldError
from hfield.evidence import Evidence, Kind
from hfield.fields.names import ring
from hfield.prover.attempts import Attempts
from hfield.prover.counterexamples.candidates import by_weight, prime_scalars, shown, witness_texts
from hfield.prover.decision import (
    FIELD,
    ORDERED_FIELDS,
    PROVED,
    REFUTED,
    VACUOUS,
    Decision,
    undecided,
)
from hfield.prover.evaluation.ordered import Numbers, OrderedEvaluator
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.evaluation.searcher import Assignment, lifted, read_back
from hfield.prover.polynomials.field_rules import SQUARES
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Sort
from hfield.prover.statements.trees import taken_apart, walk_once
from hfield.prover.steps import say
from hfield.syntax import Call

MAX_SMALL_PLACES, INTEGER_PLACES, FRACTION_PLACES = 400, 400, 800  # counterexamples tried
MAX_WEIGHT = 12
DESCENT_STARTS, DESCENT_STEPS = 4, 400  # of searches downhill
MAX_SQUARES = 12  # that a step shows


def decide(problem: Problem, tried: Callable[[Problem], Decision]) -> Decision:
    """Decide a statement with moduli or comparisons; ``tried`` decides it over RR."""
    field = problem.field
    reals = problem.over(ring("RR"))
    if field is not None and not field.is_exact:
        why = f"{field.name} is inexact, so its comparisons decide nothing: use RR or QQ"
        return undecided(why, method=FLOATS)
    if field is not None and not field.is_field and problem.statement.divides:
        return undecided(
            f"comparisons of quotients are decided over fields, and {field.name} is none"
        )
    attempts = Attempts()
    for text in problem.statement.constants:
        if attempts.answer(reals.ring, text) is None:
            name = "" if field is None else field.name
            return undecided(f"{name} has several orderings, and they differ at {text}")
    found = attempts.answer(counterexample, problem, reals)
    if found is not None:
        return refuted(problem, found)
    decision = attempts.answer(tried, reals)
    if decision is None:
        return undecided(*attempts.refusals, "counterexamples of rational numbers")
    if decision.verdict in (PROVED, VACUOUS):
        scope = ORDERED_FIELDS if field is None else FIELD
        steps = (*decision.steps, *_sums(decision))
        if field != reals.field:
            steps = (say("real-closure"), *steps)
        scope_shown = None if decision.scope is None and decision.verdict == VACUOUS else scope
        return replace(decision, scope=scope_shown, steps=steps)
    if decision.verdict == REFUTED and field != reals.field:
        own = _in_field(problem, decision)
        if own is None:
            return undecided("counterexamples of rational numbers", "sums of squares over RR")
        return refuted(problem, own)
    return decision


def _sums(decision: Decision) -> Iterator[str]:
    """Yield the sums of squares that the evidence shows to be 0; then every square is 0."""
    evidence = decision.evidence
    items = evidence.values.get("items") if evidence is not None else None
    for item in items if isinstance(items, list) else ():
        for step in item.get("steps", ()):
            terms = step.get("terms", ())
            if step["step"] == SQUARES and len(terms) <= MAX_SQUARES:
                pairs = zip(step["coefficients"], terms, strict=True)
                yield say("squares-vanish", sum=" + ".join(_square(c, text) for c, text in pairs))


def _square(coefficient: int, text: str) -> str:
    inside = text if text.isalnum() else f"({text})"
    return f"{inside}²" if coefficient == 1 else f"{coefficient}·{inside}²"


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
    """Return the values of a counterexample over RR as elements of the field, or None if they do not lie in
    it.
    """
    field = problem.field or ring("QQ")
    texts = decision.witness or {}
    own = {name: texts[name] for name, _ in _unknowns(problem) if name in texts}
    try:
        values = read_back(field, own)
        reals = read_back(ring("RR"), own)
    except HFieldError:
        return None
    there = problem.over(ring("RR"))
    return values if OrderedEvaluator(there, RingScalars(there.ring)).fails(reals) else None


def _unknowns(problem: Problem) -> tuple[tuple[str, Sort], ...]:
    """Return the unknowns of the statement as typed by the user."""
    read = problem.statement
    return tuple((name, sort) for name, sort in read.unknowns if name not in read.helpers)


def counterexample(problem: Problem, reals: Problem) -> Assignment | None:
    """Search for rational numbers at which the statement is false."""
    field = problem.field or ring("QQ")
    whole = not field.is_field
    exact = OrderedEvaluator(reals, RingScalars(reals.ring))
    assert problem.statement.ordered is not None
    irrational = problem.statement.constants or any(
        isinstance(n, Call) and n.function == "abs" for n in walk_once(problem.statement.ordered)
    )
    quick = (
        OrderedEvaluator(reals, Numbers())
        if irrational
        else OrderedEvaluator(reals, RingScalars(ring("QQ")))
    )
    for place in _places(problem, whole):
        if problem.is_late:
            return None
        numbers = lifted(ring("RDF" if irrational else "QQ"), place)
        if quick.fails(numbers) and exact.fails(lifted(reals.ring, place)):
            return lifted(field, place)
    floats = OrderedEvaluator(reals, Numbers())
    for place in () if whole else _downhill(problem, floats):
        if exact.fails(lifted(reals.ring, place)):
            return lifted(field, place)
    return None


def _downhill(problem: Problem, floats: OrderedEvaluator[float]) -> Iterator[Assignment]:
    """Search by descent for a point at which an expression claimed to be nonnegative is negative."""
    assert problem.statement.ordered is not None
    compared = floats.margins(taken_apart(problem.statement.ordered)[1])
    unknowns, rng = _unknowns(problem), Random(1)
    width = sum(sort.width for _, sort in unknowns)
    if not width:
        return

    def place(x: list[Fraction]) -> Assignment:
        rest = iter(x)
        return {
            name: next(rest) if sort is Sort.SCALAR else tuple(islice(rest, 4))
            for name, sort in unknowns
        }

    for margin in compared:
        for _ in range(DESCENT_STARTS):
            x = [Fraction(rng.randint(-8, 8), 4) for _ in range(width)]
            best, step = margin(lifted(ring("RDF"), place(x))), Fraction(1)
            for _ in range(DESCENT_STEPS):
                if problem.is_late:
                    return
                n = rng.randrange(width)
                y = [*x[:n], x[n] + rng.choice((step, -step)), *x[n + 1 :]]
                there = margin(lifted(ring("RDF"), place(y)))
                if there < best:
                    x, best = y, there
                    if best < 0:
                        yield place(x)
                        break
                elif not rng.randrange(width):
                    step = max(step / 2, Fraction(1, 64)) if rng.randrange(8) else Fraction(1)


def _places(problem: Problem, whole: bool) -> Iterator[Assignment]:
    """Yield values of the unknowns: small integers, then larger ones, then fractions."""
    unknowns = _unknowns(problem)
    yield from islice(
        by_weight(unknowns, prime_scalars(0), MAX_WEIGHT, problem.letters), MAX_SMALL_PLACES
    )
    rng = Random(len(unknowns))

    def fraction() -> Fraction:
        return Fraction(rng.randint(-12, 12), rng.choice((1, 2, 3, 4, 10))) * rng.choice((1, 1, 9))

    for number, make in ((INTEGER_PLACES, lambda: rng.randint(-4, 4)), (FRACTION_PLACES, fraction)):
        if whole and make is fraction:
            return
        for _ in range(number):
            yield {
                name: make() if sort is Sort.SCALAR else tuple(make() for _ in range(4))
                for name, sort in unknowns
            }
