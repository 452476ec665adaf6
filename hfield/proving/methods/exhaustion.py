"""Deciding over a finite ring by all cases."""

from hfield.certificates.glossary import EXHAUSTION
from hfield.errors import TooLargeError, UndecidedError
from hfield.evidence import Evidence, Kind
from hfield.proving.counterexamples.refuting import MANY, look
from hfield.proving.decision import FIELD, PROVED, Decision, undecided
from hfield.proving.evaluation.all_cases import counterexample
from hfield.proving.methods.decisions import refuted
from hfield.proving.polynomials.expansion import Expanded
from hfield.proving.problem import Problem
from hfield.proving.steps import say


def exhaust(problem: Problem, x: Expanded | None) -> Decision:
    """Decide over a finite ring by all cases; when they are too many, look at small places."""
    used = None if x is None else used_variables(x)
    try:
        found, cases = counterexample(problem, used)
    except (TooLargeError, UndecidedError) as error:
        found = look(problem, MANY)
        if found is not None:
            return refuted(problem, found)
        return undecided(str(error), f"{MANY} small places")
    if found is not None:
        return refuted(problem, found)
    steps = (say("each-case" if cases > 1 else "only-case", n=cases, R=problem.ring.name),)
    evidence = Evidence(Kind.EXHAUSTION, cases=cases)
    return Decision(PROVED, EXHAUSTION, steps=steps, scope=FIELD, evidence=evidence)


def used_variables(x: Expanded) -> frozenset[str]:
    """Return the coordinates that the clauses depend on."""
    polynomials = [p for c in x.clauses for p in (*c.zeros, *(g for goal in c.goals for g in goal))]
    degrees: list[int] = [0] * len(x.variables)
    for p in polynomials:
        degrees = [a + int(b) for a, b in zip(degrees, p.degrees(), strict=True)]
    return frozenset(name for name, d in zip(x.variables, degrees, strict=True) if d)
