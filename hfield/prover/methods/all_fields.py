"""Decide a quantifier-free statement over all fields at once."""

from collections.abc import Iterator
from dataclasses import replace

from hfield.checker.glossary import IDENTITY
from hfield.errors import TooLargeError
from hfield.evidence import Evidence, Kind
from hfield.fields.names import ring
from hfield.prover.attempts import Attempts
from hfield.prover.counterexamples.candidates import prime_search
from hfield.prover.decision import FIELDS, PROVED, REFUTED, Decision, undecided
from hfield.prover.definedness import algebra_exists
from hfield.prover.methods import one_field
from hfield.prover.methods.decisions import expanding, implied, scope_of_identity
from hfield.prover.methods.implications import Proof, prove_clauses
from hfield.prover.polynomials.expansion import Expanded, expand
from hfield.prover.polynomials.vanishing import prime_factors
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Statement, generators
from hfield.prover.steps import say

# Where a counterexample is looked for, in this order.
FIELDS_TRIED = (
    "QQ",
    "GF(2)",
    "GF(3)",
    "GF(5)",
    "GF(4)",
    "GF(7)",
    "GF(9)",
    "GF(8)",
    "QQ(I)",
    "QQ(sqrt(2))",
    "GF(2)(t)",
)
SHARE = 0.15  # of the time left, for each of them
CASES_TRIED = 150


def decide(problem: Problem) -> Decision:
    """Decide over all fields; a counterexample over any of them refutes the statement."""
    attempts = Attempts()
    x = attempts.answer(expand, problem)
    if x is not None:
        if not x.clauses:
            return _identity(problem.statement, x)
        if all(c.zeros for c in x.clauses) and not _quickly(problem):
            proof = attempts.answer(_proof, problem)
            if proof is not None:
                return proof
    found = attempts.answer(counterexample, problem)
    if found is not None:
        return found if x is None else _with_exceptions(problem, found)
    why = "it is too large to expand" if x is None else "ideal membership of the conclusion"
    tried = (f"counterexamples over {', '.join(FIELDS_TRIED)}", why)
    return undecided(*tried)


def _with_exceptions(problem: Problem, found: Decision) -> Decision:
    """Add to a refutation in characteristic p a step that says in which characteristics the
    statement holds.
    """
    p = ring((found.witness or {})["F"][0]).characteristic
    try:
        general = prove_clauses(problem.within(1.0), 0) if p else None
    except TooLargeError:
        return found
    primes = prime_factors(abs(general.denominator)) if general else None
    if primes is None:
        return found
    failing = [q for q in primes if not prove_clauses(problem.within(1.0), q)]
    where = " and ".join(map(str, failing))
    step = say("holds-but-perhaps" if len(failing) > 1 else "holds-but", p=where)
    return replace(found, steps=(*found.steps, step))


def _identity(statement: Statement, x: Expanded) -> Decision:
    steps = (expanding(x), say("all-zero", R="ℤ"))
    scope = scope_of_identity(statement, x)
    return Decision(PROVED, IDENTITY, steps=steps, scope=scope, evidence=Evidence(Kind.IDENTITY))


def _quickly(problem: Problem) -> bool:
    """Return whether a quick search finds a counterexample."""
    return any(prime_search(problem, p, CASES_TRIED) is not None for p in (0, 2, 3))


def _proof(problem: Problem) -> Decision | None:
    """Prove in characteristic 0, then in each characteristic by which the proof divides."""
    general = prove_clauses(problem.share(1 / 2), 0)
    primes = prime_factors(abs(general.denominator)) if general else None
    if general is None or primes is None:
        return None
    items = general.items
    for p in primes:
        special = prove_clauses(problem, p)
        if special is None:
            return None
        items += special.items
    decision = implied(Proof(items, 0, False), problem)
    return replace(decision, scope=FIELDS) if primes else decision


def counterexample(problem: Problem) -> Decision | None:
    """Search for a field over which the statement is refuted; the witness gives it as F."""
    for there in fields_tried(problem):
        if problem.is_late:
            return None
        decision = one_field.decide(there.share(SHARE, least=0.1))
        if decision.verdict == REFUTED:
            return refutation_over_all_fields(decision, there.ring.name)
    return None


def fields_tried(problem: Problem) -> Iterator[Problem]:
    """Yield the problem over each field in which counterexamples are searched for.

    These fields contain the structure constants, and none of their generators is an unknown of the statement.
    """
    statement = problem.statement
    for name in FIELDS_TRIED:
        there = problem.over(ring(name))
        clash = statement.exists and not generators(there.ring).isdisjoint(statement.sorts)
        if not clash and algebra_exists(there):
            yield there


def refutation_over_all_fields(decision: Decision, name: str) -> Decision:
    """Return a refutation over one field as one over all fields."""
    evidence = decision.evidence and decision.evidence.over(ring(name).data)
    return replace(decision, witness={**(decision.witness or {}), "F": [name]}, evidence=evidence)
