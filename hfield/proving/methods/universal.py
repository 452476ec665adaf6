"""Deciding a statement without quantifiers, wherever the problem says: the choice of the method."""

from hfield.certificates.glossary import FLOATS
from hfield.proving.counterexamples.candidates import prime_search
from hfield.proving.counterexamples.refuting import FEW, lifted
from hfield.proving.decision import Decision, undecided
from hfield.proving.methods import all_fields, one_field, over_rings
from hfield.proving.methods.decisions import refuted
from hfield.proving.methods.exponents import by_exponents
from hfield.proving.polynomials.expansion import MAX_WEIGHT
from hfield.proving.problem import Problem


def decide(problem: Problem) -> Decision:
    """Decide over all fields, or over the ring that is named."""
    field = problem.field
    if problem.statement.weight > MAX_WEIGHT and (field is None or field.is_exact):
        found = by_exponents(problem)
        if found is not None:
            return found
    if field is None:
        return all_fields.decide(problem)
    if not field.is_exact:
        return _over_floats(problem)
    return one_field.decide(problem) if field.is_field else over_rings.decide(problem)


def _over_floats(problem: Problem) -> Decision:
    """Gather evidence over an inexact ring: small integers are exact there and may refute."""
    field, statement = problem.ring, problem.statement
    if not statement.divides and not statement.constants:
        found = prime_search(problem, 0, FEW)
        if found is not None:
            return refuted(problem, lifted(field, found))
    tried = (f"{field.name} is inexact, so nothing is proved there: decide over RR or QQ",)
    return undecided(*tried, method=FLOATS)
