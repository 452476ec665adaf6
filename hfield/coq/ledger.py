"""The universal theorems of the ledger: which propositions of a claim hold for all fields at once."""

from collections.abc import Iterable, Iterator

from hfield.coq.export import Export, Left, comment_text, theorem_of
from hfield.coq.facts import NoProofError
from hfield.coq.presented import counterexample, presented
from hfield.coq.theorems import Theorem
from hfield.errors import HFieldError
from hfield.ledger.claim import Claim, Proposition
from hfield.ledger.presented import RELATIONS, Presented
from hfield.ledger.propositions import Equivalence, Every, Implication, Statement
from hfield.ledger.registry import claims
from hfield.proving.decision import PROVED, REFUTED
from hfield.proving.prove import prove

# What is no statement of the language, but stands among the theorems proved by hand.
BY_HAND = {
    "C1.1.2-c": "centre and centre_in_char_2",
    "C1.1.3-a": "multilinear_maps_agree",
    "C1.1.3-b": "multilinear_maps_agree",
    "C1.1.3-c": "linear_maps_agree",
    "C1.1.3-d": "curried_is_multilinear",
    "C1.1.3-e": "sum_in_the_last_argument",
    "C1.1.3-f": "multilinear_maps_agree",
    "C1.4.1-a": "coordinates_are_unique",
    "C1.4.2-a": "coordinates_are_unique",
}


def export_ledger(chosen: Iterable[Claim] = ()) -> Export:
    """Export what is proved for all fields among the claims chosen, all of them by default."""
    theorems: list[Theorem] = []
    left: list[Left] = []
    for claim in tuple(chosen) or claims():
        found = list(_propositions(claim))
        for number, (kind, proposition) in enumerate(found, 1):
            name = theorem_name(claim, kind, number if len(found) > 1 else 0)
            try:
                theorems += _theorems(name, claim, proposition)
            except HFieldError as error:
                left.append(Left(claim.id + (f" {kind}" if kind else ""), proposition.text, str(error)))
    return Export(tuple(theorems), tuple(left))


def theorem_name(claim: Claim, kind: str, number: int) -> str:
    """Return a name for Coq, such as ``C1_3_1_y_corrected_2``."""
    base = claim.id.replace(".", "_").replace("-", "_")
    return "_".join(part for part in (base, kind, str(number or "")) if part)


def _propositions(claim: Claim) -> Iterator[tuple[str, Proposition]]:
    """Run through the propositions that a claim is made of, as printed and as corrected."""
    seen = set()
    for kind, whole in (("", claim.as_printed), ("corrected", claim.corrected)):
        for part in _parts(whole):
            if part.text not in seen and _is_candidate(part):
                yield kind, part
            seen.add(part.text)


def _parts(proposition: Proposition | None) -> Iterator[Proposition]:
    match proposition:
        case None:
            return
        case Every():
            for part in proposition.parts:
                yield from _parts(part)
        case Implication() | Equivalence() if proposition.everywhere:
            yield from _parts(proposition.everywhere)
        case _:
            yield proposition


def _is_candidate(part: Proposition) -> bool:
    """Tell whether a proposition is decided for all fields in a way that a theorem could state."""
    decision = part.decide(None)
    if isinstance(part, Presented):
        return decision.verdict in (PROVED, REFUTED)
    return decision.verdict == PROVED and decision.scope is not None


def _theorems(name: str, claim: Claim, part: Proposition) -> list[Theorem]:
    words = f"{claim.id}: "
    match part:
        case Statement():
            return [theorem_of(name, prove(part.formula, given=part.given), words)]
        case Presented():
            decision = part.decide(None)
            write = presented if decision.verdict == PROVED else counterexample
            if decision.verdict == REFUTED:
                name, words = f"{name}_fails", f"{words}refuted: "
            comment = comment_text(words + part.text)
            evidence = decision.evidence or {}
            return [write(name, comment, RELATIONS, part.goals, evidence)]
    by_hand = BY_HAND.get(claim.id)
    hint = f"; by hand: theorem {by_hand}" if by_hand else ""
    raise NoProofError(f"this is no statement of the language{hint}")
