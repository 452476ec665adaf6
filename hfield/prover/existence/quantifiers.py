"""Choose the method for an existential statement, or for contradictory hypotheses.

Existence is proved by terms, for all values or case by case, and refuted by values to which no case applies.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from hfield.checker.glossary import FLOATS, WITNESS
from hfield.errors import TooLargeError
from hfield.evidence import Evidence, Kind, is_complete
from hfield.fields.names import ring
from hfield.prover.attempts import Attempts, Method
from hfield.prover.counterexamples.candidates import prime_search, ring_search, true_place
from hfield.prover.decision import FIELD, FIELDS, PROVED, REFUTED, VACUOUS, Decision, undecided
from hfield.prover.evaluation.scalars import PrimeScalars, RingScalars, constant
from hfield.prover.evaluation.searcher import Searcher, read_back
from hfield.prover.existence.given_values import at_zero, by_places, refuted_at
from hfield.prover.existence.isolation import isolated, isolated_alone
from hfield.prover.existence.linear_systems import Case, linear_cases
from hfield.prover.existence.witness_terms import by_terms, combined, put_in
from hfield.prover.existence.witnesses import MAX_PLACES_TRIED, by_roots, decide_closed
from hfield.prover.methods import all_fields, universal
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Statement
from hfield.prover.statements.printing import to_text
from hfield.prover.statements.trees import FALSE, conjunction, implication, occurrences
from hfield.prover.steps import say
from hfield.syntax import Compare, Logic, Name, Node, Not, Number, parse


def vacuous(problem: Problem) -> Decision | None:
    """Return the decision "vacuous" if the hypotheses are proved unsatisfiable, else None."""
    node = conjunction(problem.statement.hypotheses)
    if true_place(problem.for_formula(node), MAX_PLACES_TRIED) is not None:
        return None
    names = (name for name, _ in problem.statement.unknowns)
    own = tuple(name for name in names if occurrences(node, name) or name in problem.letters)
    decision = universal.decide(problem.without_constants(Not(node), own))
    if decision.verdict != PROVED:
        return None
    evidence = Evidence(Kind.UNSATISFIABLE, proof=decision.evidence)
    steps = (*decision.steps, say("never-all"))
    # A conclusion with constants of the field is about this field only, whatever its hypotheses
    # are.
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
    # Digits that are not known are given, too.
    known = (field.is_known(constant(field, text)) for text in problem.statement.constants)
    is_closed = not problem.statement.given and all(known)
    return decide_closed(problem) if is_closed else _for_all_exists(problem)


def _over_all_fields(problem: Problem) -> Decision:
    """Decide over all fields: by terms that always work, or by a field without a witness."""
    attempts = Attempts()
    decision, place = _by_algebra(problem, attempts)
    if decision is None and place is None:
        decision = attempts.answer(by_zero_or_not, problem.share(1 / 3))
    if decision is not None:
        return decision
    unproved = None  # refuted somewhere, but without evidence: another field may have some
    for one, name in _at_fields(problem, place):
        if one is not None and one.verdict == REFUTED:
            if is_complete(one.evidence):
                return all_fields.refutation_over_all_fields(one, name)
            unproved = unproved or all_fields.refutation_over_all_fields(one, name)
    if unproved is not None:
        return unproved
    tried = ("terms in the unknowns", f"each of {', '.join(all_fields.FIELDS_TRIED)}")
    return undecided(*tried)


Place = Mapping[str, Sequence[str]]


def _at_fields(problem: Problem, place: Place | None) -> Iterator[tuple[Decision | None, str]]:
    """Decide over one field after another, first at a point found by linear algebra."""
    if place is not None:
        name = place["F"][0]
        yield Attempts().answer(refuted_at, problem.over(ring(name)), place), name
    for there in all_fields.fields_tried(problem):
        if problem.is_late:
            break
        yield Attempts().answer(decide, there.share(0.2, least=0.1)), there.ring.name


def _by_algebra(problem: Problem, attempts: Attempts) -> tuple[Decision | None, Place | None]:
    """Prove by terms and cases, or return a point at which linear algebra shows that there is no witness."""
    terms: Iterable[Method] = (
        lambda: by_isolating(problem),
        lambda: by_terms(problem.share(1 / 3)),
    )
    decision = attempts.first(terms)
    if decision is not None:
        return decision, None
    if problem.field is not None and not problem.field.is_field:
        return None, None
    return attempts.answer(by_linear_algebra, problem) or (None, None)


def _for_all_exists(problem: Problem) -> Decision:
    attempts = Attempts()
    decision, place = _by_algebra(problem, attempts)
    return attempts.decide(_at_places(problem, place)) if decision is None else decision


def _at_places(problem: Problem, place: Place | None) -> Iterator[Method]:
    """Yield the methods that try points, first one found by linear algebra."""
    if place is not None:
        yield lambda: refuted_at(problem, place)
    yield lambda: by_roots(problem)
    yield lambda: _by_what_serves_at_zero(problem)
    if problem.ring.is_field:
        yield lambda: by_zero_or_not(problem.share(1 / 4))
    yield lambda: by_places(problem)


def _by_what_serves_at_zero(problem: Problem) -> Decision | None:
    """Prove with the witnesses for given values 0."""
    found = at_zero(problem)
    return None if found is None else by_terms(problem, [found])


MAX_ISOLATED = 40
PLACES = 300
MAX_ZERO = 3


def by_isolating(problem: Problem) -> Decision | None:
    """Prove by terms that solve an equation for a sought unknown."""
    found = isolated(problem.statement)
    if not any(found.values()):
        return None
    texts = [found[name] or ["0"] for name in problem.statement.exists]
    return by_terms(problem, combined(texts, MAX_ISOLATED))


def by_linear_algebra(problem: Problem) -> tuple[Decision | None, Place | None]:
    """Decide by linear algebra: by a proof, or by a point to which no case applies."""
    try:
        cases, exact = linear_cases(problem.share(1 / 3))
    except TooLargeError:
        cases, exact = [], False
    cases = [*_isolated_cases(problem.statement), *cases]
    if not cases and not exact:
        return None, None
    names = problem.statement.exists  # their order may differ from that in which they are used
    found = by_terms(problem, [tuple(map(dict(case.terms).__getitem__, names)) for case in cases])
    if found is not None:
        return found, None
    try:
        chosen, cover = _covered(problem, cases)
        if cover.verdict != PROVED:
            return None, cover.witness if cover.verdict == REFUTED else None
        proofs = [_proof(problem, case) for case in chosen]
    except TooLargeError:
        return None, None
    return _put_together(problem, chosen, cover, proofs), None


def by_zero_or_not(problem: Problem) -> Decision | None:
    """Prove by two cases: a given value is 0 or not 0."""
    statement = problem.statement
    for name, _ in statement.given[:MAX_ZERO]:
        found: list[tuple[Case, Decision]] = []
        for op in ("==", "!="):
            when = Compare(op, Name(name), Number(0))
            hypotheses = (when, *statement.hypotheses)
            proof = by_terms(
                problem.with_statement(replace(statement, hypotheses=hypotheses)).share(1 / 3)
            )
            if proof is None or proof.evidence is None:
                break
            terms, evidence = proof.evidence["terms"], proof.evidence["proof"]
            assert isinstance(terms, dict)
            assert isinstance(evidence, Evidence)
            inside = replace(proof, evidence=evidence)
            found.append((Case(to_text(when), tuple(terms.items())), inside))
        else:
            cases = [case for case, _ in found]
            cover = universal.decide(_covering(problem, cases))
            if cover.verdict == PROVED:
                return _put_together(problem, cases, cover, [proof for _, proof in found])
    return None


def _isolated_cases(statement: Statement) -> Iterator[Case]:
    """Yield cases in which an equation is solved for one of several names."""
    for terms in isolated_alone(statement):
        own = tuple((name, terms[name]) for name in statement.exists)
        node = put_in(statement.conclusion, {name: parse(text) for name, text in own})
        yield Case(to_text(node), own)


def _covered(problem: Problem, cases: list[Case]) -> tuple[list[Case], Decision]:
    """Return several cases, with the decision that one of them always applies.

    If a point refutes this and another case applies there, that case is added; if no case applies there,
    nothing exists at that point.
    """
    chosen = _few(problem, cases)
    while True:
        cover = universal.decide(_covering(problem, chosen))
        if cover.verdict != REFUTED or cover.witness is None:
            return chosen, cover
        field = problem.field or ring(cover.witness["F"][0])
        place = read_back(field, cover.witness)
        world = RingScalars(field)
        found = [
            case
            for case in cases
            if case not in chosen and Searcher(_applies(problem, case), world, True).test(place)
        ]
        if not found:
            return chosen, cover
        chosen = [*chosen, min(found, key=_equations)]


def _equations(case: Case) -> int:
    """Return the number of equations that a case needs; fewer equations mean a more general case."""
    return case.when.count("==")


def _few(problem: Problem, cases: list[Case]) -> list[Case]:
    """Return some of the cases such that one of them applies at every point that was tested.

    Fewer cases make it easier to prove that they cover everything. If at some point no case applies, all
    cases are returned; nothing exists at that point.
    """
    field = problem.field
    applies = {case: _applies(problem, case) for case in cases}
    worlds: list[PrimeScalars | RingScalars] = []
    if not any(case.statement.constants for case in applies.values()):  # undefined modulo p
        worlds += map(PrimeScalars, (0, 2, 3) if field is None else (field.characteristic,))
    if field is not None:
        worlds.append(RingScalars(field))
    chosen: list[Case] = []
    for world in worlds:
        while len(chosen) < len(cases):
            left = _covering(problem, chosen)
            if isinstance(world, PrimeScalars):
                place = prime_search(left, world.p, PLACES)
            else:
                place = ring_search(left, PLACES)
            if place is None:
                break
            found = [
                case
                for case in cases
                if case not in chosen and Searcher(applies[case], world, True).test(place)
            ]
            if not found:
                return cases
            chosen.append(min(found, key=_equations))
    return chosen or cases[:1]


def _applies(problem: Problem, case: Case) -> Problem:
    """Return the problem whether a case always applies."""
    return _given(problem, parse(case.when))


def _covering(problem: Problem, cases: list[Case]) -> Problem:
    """Return the problem whether one of the cases always applies under the hypotheses."""
    node = parse(cases[0].when) if cases else FALSE
    for case in cases[1:]:
        node = Logic("or", node, parse(case.when))
    return _given(problem, implication(problem.statement.hypotheses, node))


def _given(problem: Problem, node: Node) -> Problem:
    """Return the problem of the given unknowns alone."""
    made = problem.without_constants(node, tuple(name for name, _ in problem.statement.given))
    return made.with_statement(replace(made.statement, compares_unequal=True))


def _proof(problem: Problem, case: Case) -> Decision:
    """Prove that the terms of a case are witnesses where the case applies."""
    terms = {name: parse(text) for name, text in case.terms}
    statement = problem.statement
    inside = implication(statement.hypotheses, put_in(statement.conclusion, terms))
    return universal.decide(_given(problem, Logic("=>", parse(case.when), inside)))


def _put_together(
    problem: Problem, cases: list[Case], cover: Decision, proofs: list[Decision]
) -> Decision | None:
    """Return the proof by cases, or None if some case is not proved."""
    if any(proof.verdict != PROVED for proof in proofs):
        return None
    cases_data = [
        {"when": case.when, "terms": dict(case.terms), "proof": proof.evidence}
        for case, proof in zip(cases, proofs, strict=True)
    ]
    steps = [
        say(
            "take-where",
            when=case.when,
            terms=", ".join(f"{name} = {term}" for name, term in case.terms),
        )
        for case in cases
    ]
    assumes = tuple(dict.fromkeys(a for d in (cover, *proofs) for a in d.assumes))
    return Decision(
        PROVED,
        WITNESS,
        steps=(*steps, say("always-one")),
        scope=FIELDS if problem.field is None else FIELD,
        assumes=assumes,
        evidence=Evidence(Kind.CASES, cases=cases_data, cover=cover.evidence),
    )
