"""Decide existence without given values: find a witness, or prove that there is none.

In ℝ, ℂ and H(ℝ) roots exist by a theorem for all given values, although no term in these values describes
them.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from hfield.checker.glossary import (
    COMPLEX_ROOT,
    LINEAR_ALGEBRA,
    ODD_DEGREE,
    QUATERNION_ROOT,
    REAL_ROOTS,
    SIGN_CHANGE,
    WITNESS,
)
from hfield.errors import TooLargeError
from hfield.evidence import Evidence, Kind
from hfield.prover.attempts import Attempts
from hfield.prover.counterexamples.candidates import shown, true_place, witness_texts
from hfield.prover.decision import FIELD, PROVED, REFUTED, Decision
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.evaluation.searcher import Assignment, Searcher, lifted
from hfield.prover.existence.closed_equations import SolutionPlaces, closed_solutions
from hfield.prover.existence.linear_systems import linear_cases
from hfield.prover.methods import universal
from hfield.prover.polynomials.expansion import Symbolic
from hfield.prover.polynomials.recognition import polynomial_text
from hfield.prover.polynomials.vanishing import collected
from hfield.prover.problem import Problem
from hfield.prover.statements.language import BASIS, Sort
from hfield.prover.statements.trees import occurrences
from hfield.prover.steps import Step, say
from hfield.syntax import Binary, Compare, Name, Negate, Node, Not, Number, Power, parse

if TYPE_CHECKING:
    import flint


MAX_PLACES_TRIED = 400


def decide_closed(problem: Problem) -> Decision:
    """Decide over one ring whether there are values for all unknowns that make the statement true."""
    attempts, somewhere = Attempts(), problem.for_formula(problem.matrix)
    for search in (partial(true_place, somewhere, MAX_PLACES_TRIED), partial(_solved, somewhere)):
        found = attempts.answer(search)
        if found is not None:
            return _witnessed(problem, found)
    solutions = attempts.answer(closed_solutions, somewhere) or SolutionPlaces()
    found = attempts.answer(_true_at, somewhere, solutions.places)
    if found is not None:
        return _witnessed(problem, found)
    if problem.statement.exists:
        decision = attempts.answer(by_roots, problem)
        if decision is not None:
            return decision
    decision = attempts.decide([lambda: _by_contrary(problem)])
    if decision.verdict not in (PROVED, REFUTED) and solutions.none:
        steps = (say("none-solving", R=problem.ring.name),)
        return Decision(REFUTED, LINEAR_ALGEBRA, steps=steps)
    return decision


def _true_at(problem: Problem, places: Iterable[Assignment]) -> Assignment | None:
    """Return the first of some places at which the statement is true."""
    test = Searcher(problem, RingScalars(problem.ring), True).test
    return next(filter(test, places), None)


def _by_contrary(problem: Problem) -> Decision:
    """Decide whether the statement is false everywhere."""
    decision = universal.decide(problem.for_formula(Not(problem.matrix)))
    if decision.verdict == REFUTED:
        return replace(
            decision,
            verdict=PROVED,
            method=WITNESS,
            scope=FIELD,
            steps=(say("true-for", values=shown(decision.witness or {})),),
        )
    if decision.verdict == PROVED:
        evidence = Evidence(Kind.NONE_EXISTS, proof=decision.evidence)
        steps = (*decision.steps, say("none"))
        return replace(decision, verdict=REFUTED, scope=None, evidence=evidence, steps=steps)
    return decision


def _solved(problem: Problem) -> Assignment | None:
    """Find values that solve linear equations, by elimination."""
    statement = problem.statement
    if not problem.ring.is_exact:
        return None
    names = tuple(name for name, _ in statement.unknowns)
    sought = replace(statement, exists=names, hypotheses=(), conclusion=statement.node)
    try:
        cases, _ = linear_cases(problem.with_statement(sought))
    except TooLargeError:
        return None
    seeker = Searcher(problem, RingScalars(problem.ring), True)
    world = seeker.evaluator
    for case in cases:
        values = {name: world.term(parse(text)) for name, text in case.terms}
        if not all(defined for _, defined in values.values()):
            continue
        sorts = statement.sorts
        found = {
            name: x if sorts[name] is Sort.SCALAR else world.embed(x)
            for name, (x, _) in values.items()
        }
        if seeker.test(found):
            return found
    return None


def _witnessed(problem: Problem, found: Assignment) -> Decision:
    witness = witness_texts(problem.ring, lifted(problem.ring, found))
    return Decision(
        PROVED,
        WITNESS,
        witness=witness,
        steps=(say("true-for", values=shown(witness)),),
        scope=FIELD,
        evidence=Evidence(Kind.WITNESS, ring=problem.ring.data, values=witness),
    )


MAX_DEGREE = 200
MAX_COORDINATE = 2**40


def by_roots(problem: Problem) -> Decision | None:
    """Prove by a theorem that a root exists for all given values."""
    return _by_real_or_complex_root(problem) or _by_quaternion_root(problem)


def _by_real_or_complex_root(problem: Problem) -> Decision | None:
    """Prove ``exists s: f(s) == g(s)`` over RR and CC if a root exists for all given values."""
    field, statement = problem.field, problem.statement
    node = statement.conclusion
    if field is None or field.closure is None or len(statement.exists) != 1:
        return None
    name = statement.exists[0]
    if statement.sorts[name] is not Sort.SCALAR or statement.divides or problem.is_late:
        return None
    if not (isinstance(node, Compare) and node.op == "=="):
        return None
    try:
        world = Symbolic(problem)
        sides = [world.embed(world.term(side)[0]) for side in (node.left, node.right)]
        differences = [u - v for u, v in zip(*sides, strict=True)]
    except TooLargeError:
        return None
    left, at = [f for f in differences if f != 0], world.variables.index(name)
    if len(left) != 1 or not 1 <= left[0].degrees()[at] <= MAX_DEGREE:
        return None
    (f,) = left
    polynomial = polynomial_text(f, world.variables)
    by = _complex(f, at) if field.closure == "algebraically closed" else _real(f, at)
    if by is None:
        return None
    evidence, theorem, why = by
    return Decision(
        PROVED,
        WITNESS,
        steps=(
            say("as-polynomial", f=polynomial, x=name, why=why),
            say("so-root", theorem=theorem),
        ),
        scope=FIELD,
        assumes=(theorem,),
        evidence=evidence,
    )


Reason = tuple[Evidence, str, Step]  # evidence, theorem, words


def _complex(f: flint.fmpz_mpoly, at: int) -> Reason | None:
    lead = _coefficients(f, at)[-1]
    if not lead.is_constant():
        return None
    return Evidence(Kind.COMPLEX_ROOT), COMPLEX_ROOT, say("number-in-front")


def _real(f: flint.fmpz_mpoly, at: int) -> Reason | None:
    c = _coefficients(f, at)
    degree = len(c) - 1
    if degree % 2 and c[-1].is_constant():
        return Evidence(Kind.REAL_ROOT, by="odd degree"), ODD_DEGREE, say("odd-degree", n=degree)
    if degree == 2 and c[1] == 0 and c[2].is_constant():
        rest = -c[0] if int(c[2].leading_coefficient()) > 0 else c[0]
        if all(
            coefficient > 0 and not any(int(e) % 2 for e in m) for m, coefficient in rest.terms()
        ):
            words = say("square-minus-squares")
            return Evidence(Kind.REAL_ROOT, by="square"), REAL_ROOTS, words
    if all(x.is_constant() for x in c):
        ends = _sign_change([int(x.leading_coefficient()) if x != 0 else 0 for x in c])
        if ends is not None:
            words = say("both-signs", a=ends[0], b=ends[1])
            between = [str(n) for n in ends]
            evidence = Evidence(Kind.REAL_ROOT, by="sign change", between=between)
            return evidence, SIGN_CHANGE, words
    return None


def _coefficients(f: flint.fmpz_mpoly, at: int) -> list[flint.fmpz_mpoly]:
    """Return the coefficients of f as a polynomial in one of its variables."""
    found = {m[at]: c for m, c in collected(f, {at}).items()}
    return [found.get(n, f.context().constant(0)) for n in range(max(found) + 1)]


def _sign_change(c: list[int]) -> tuple[int, int] | None:
    """Return two integers at which Σ cₙ·xⁿ has opposite signs, or one of the values is 0."""
    places = [0]
    while places[-1] < MAX_COORDINATE:
        places.append(2 * places[-1] or 1)
    signs: dict[int, int] = {}
    for n in sorted({*places, *(-n for n in places), *range(-20, 21)}, key=abs):
        value = sum(a * n**k for k, a in enumerate(c))
        for m, sign in signs.items():
            if sign * value <= 0:
                return min(m, n), max(m, n)
        signs = {n: 1 if value > 0 else -1, **signs}
    return None


MAX_QUATERNION_DEGREE = 1_000


@dataclass(frozen=True)
class LeadingTerm:
    """The leading part of a polynomial: a bound for the degree, and whether it is a single nonzero
    monomial.
    """

    degree: int
    single: bool

    def __add__(self, other: LeadingTerm) -> LeadingTerm:
        if self.degree == other.degree:
            return LeadingTerm(self.degree, False)
        return self if self.degree > other.degree else other

    def __mul__(self, other: LeadingTerm) -> LeadingTerm:
        return LeadingTerm(self.degree + other.degree, self.single and other.single)


def _by_quaternion_root(problem: Problem) -> Decision | None:
    """Prove ``exists q: f(q) == g(q)`` in H(ℝ), if a single monomial has the highest degree."""
    field, statement = problem.field, problem.statement
    node = statement.conclusion
    if field is None or field.closure != "real closed" or not problem.setting.is_hamilton:
        return None
    if statement.divides:
        return None
    if len(statement.exists) != 1 or not (isinstance(node, Compare) and node.op == "=="):
        return None
    name = statement.exists[0]
    sides = [_top(side, name) for side in (node.left, node.right)]
    if statement.sorts[name] is not Sort.QUATERNION or None in sides:
        return None
    top = sum((side for side in sides if side is not None), LeadingTerm(-1, False))
    if not (1 <= top.degree <= MAX_QUATERNION_DEGREE and top.single):
        return None
    steps = (
        say("single-top", q=name, n=top.degree),
        say("so-root", theorem=QUATERNION_ROOT),
    )
    return Decision(
        PROVED,
        WITNESS,
        steps=steps,
        scope=FIELD,
        assumes=(QUATERNION_ROOT,),
        evidence=Evidence(Kind.QUATERNION_ROOT),
    )


def _top(node: Node, name: str) -> LeadingTerm | None:
    """Return the leading part of a term as a polynomial in the name, or None if it is not a polynomial."""
    if not occurrences(node, name):
        return LeadingTerm(0, _is_not_zero(node))
    match node:
        case Name():
            return LeadingTerm(1, True)
        case Negate(x):
            return _top(x, name)
        case Binary("+" | "-" | "*" as op, x, y):
            left, right = _top(x, name), _top(y, name)
            if left is None or right is None:
                return None
            return left * right if op == "*" else left + right
        case Power(x, n) if n >= 0:
            base = _top(x, name)
            return None if base is None else LeadingTerm(n * base.degree, base.single)
    return None


def _is_not_zero(node: Node) -> bool:
    """Return whether a term is certainly not 0 because it is a product of numbers and basis vectors."""
    match node:
        case Number(value):
            return value != 0
        case Name(name):
            return name in BASIS
        case Negate(x):
            return _is_not_zero(x)
        case Binary("*", x, y):
            return _is_not_zero(x) and _is_not_zero(y)
    return False
