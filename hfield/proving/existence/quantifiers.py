"""Statements that something exists, and hypotheses that nothing satisfies: which way is tried when."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from hfield.certificates.glossary import FLOATS
from hfield.evidence import Evidence, Kind, is_complete
from hfield.fields.names import ring
from hfield.proving.counterexamples.candidates import true_place
from hfield.proving.decision import (
    FIELD,
    PROVED,
    REFUTED,
    VACUOUS,
    Decision,
    undecided,
)
from hfield.proving.existence.case_distinction import (
    by_isolating,
    by_linear_algebra,
    by_zero_or_not,
)
from hfield.proving.existence.places import at_zero, by_places, refuted_at
from hfield.proving.existence.roots_by_theorem import by_roots
from hfield.proving.existence.witness_terms import by_terms
from hfield.proving.existence.witnesses import FEW, decide_closed
from hfield.proving.methods import all_fields, universal
from hfield.proving.problem import Problem
from hfield.proving.statements.trees import conjunction
from hfield.proving.steps import say
from hfield.syntax import Not


def vacuous(problem: Problem) -> Decision | None:
    """Return the decision "vacuous" if the hypotheses are proved unsatisfiable, else None."""
    node = conjunction(problem.statement.hypotheses)
    if true_place(problem.about(node), FEW) is not None:
        return None
    decision = universal.decide(problem.alone(Not(node)))
    if decision.verdict != PROVED:
        return None
    evidence = Evidence(Kind.UNSATISFIABLE, proof=decision.evidence)
    steps = (*decision.steps, say("never-all"))
    # A conclusion with constants of the field speaks of no other, whatever its hypotheses do.
    scope = FIELD if problem.statement.constants else decision.scope
    return replace(decision, verdict=VACUOUS, scope=scope, steps=steps, evidence=evidence)


def decide(problem: Problem) -> Decision:
    """Decide "for all the other unknowns there exist …"."""
    field = problem.field
    if field is None:
        return _over_all_fields(problem)
    if not field.is_exact:
        tried = (f"{field.name} is inexact, so nothing is proved there to exist, or not to",)
        return undecided(*tried, method=FLOATS)
    return _for_all_exists(problem) if problem.statement.given else decide_closed(problem)


def _over_all_fields(problem: Problem) -> Decision:
    """Decide over all fields: terms that serve everywhere, or a field where there is none."""
    decision, place = _by_algebra(problem)
    if decision is None and place is None:
        decision = by_zero_or_not(problem.share(1 / 3))
    if decision is not None:
        return decision
    unproved = None  # refuted somewhere, but without evidence: another field may have some
    for one, name in _at_fields(problem, place):
        if one is not None and one.verdict == REFUTED:
            if is_complete(one.evidence):
                return all_fields.elsewhere(one, name)
            unproved = unproved or all_fields.elsewhere(one, name)
    if unproved is not None:
        return unproved
    tried = ("terms in the unknowns", f"each of {', '.join(all_fields.FIELDS_TRIED)}")
    return undecided(*tried)


Place = dict[str, Sequence[str]]


def _at_fields(problem: Problem, place: Place | None) -> Iterator[tuple[Decision | None, str]]:
    """Decide over one field after the other, first at a place that linear algebra has found."""
    if place is not None:
        name = place["F"][0]
        yield refuted_at(problem.over(ring(name)), place), name
    for there in all_fields.fields_tried(problem):
        if problem.is_late:
            break
        yield decide(there.share(0.2, least=0.1)), there.ring.name


def _by_algebra(problem: Problem) -> tuple[Decision | None, Place | None]:
    """Prove by terms and cases, or return a place where linear algebra finds that there is none."""
    decision = by_isolating(problem) or by_terms(problem.share(1 / 3))
    if decision is not None:
        return decision, None
    if problem.field is not None and not problem.field.is_field:
        return None, None
    decision, cover = by_linear_algebra(problem)
    return decision, None if cover is None or cover.witness is None else dict(cover.witness)


def _for_all_exists(problem: Problem) -> Decision:
    decision, place = _by_algebra(problem)
    if decision is None and place is not None:
        decision = refuted_at(problem, place)
    if decision is None:
        decision = by_roots(problem)
    if decision is None:
        found = at_zero(problem)
        decision = None if found is None else by_terms(problem, [found])
    if decision is None and problem.ring.is_field:
        decision = by_zero_or_not(problem.share(1 / 4))
    return by_places(problem) if decision is None else decision
