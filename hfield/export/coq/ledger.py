"""The universal theorems of the ledger: propositions that hold over all fields."""

from collections.abc import Callable, Iterator, Sequence

from hfield.errors import HFieldError
from hfield.export.coq.export import Export, Left
from hfield.export.coq.terms import NotCoveredError
from hfield.export.coq.theorem import Theorem, theorem
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import UNIVERSAL, Claim, Proposition
from hfield.ledger.propositions import Assertion, Equivalence, Every, Implication, Presented
from hfield.ledger.real_geometry import Analysis, Angles
from hfield.ledger.registry import claims
from hfield.ledger.scopes import InField, OnlyOver
from hfield.prover.decision import PROVED, REFUTED

# Claims that are not statements of the language, with the theorems of the file that state the same.
BY_HAND = {
    "C1.1.2-c": "centre, centre_in_char_2",
    "C1.1.3-a": "multilinear_maps_agree",
    "C1.1.3-b": "multilinear_maps_agree",
    "C1.1.3-c": "sum_in_the_last_argument",
    "C1.1.3-d": "curried_is_multilinear",
    "C1.1.3-e": "sum_in_the_last_argument",
    "C1.1.3-f": "multilinear_maps_agree",
}


def export_ledger(
    chosen: Sequence[Claim] = (), progress: Callable[[int, int, str], None] | None = None
) -> Export:
    """Export the chosen claims (by default all) that are proved for all fields.

    ``progress`` is called with the number of finished claims, their total, and the current claim.
    """
    theorems: list[Theorem] = []
    left: list[Left] = []
    by_hand: list[tuple[str, str]] = []
    wanted = chosen or claims()
    for done, claim in enumerate(wanted):
        if progress:
            progress(done, len(wanted), claim.id)
        found = list(_propositions(claim))
        if chosen and not found:
            left.append(Left(claim.id, claim.statement, "nothing in it is proved for all fields"))
        for number, (kind, part) in enumerate(found, 1):
            name = theorem_name(claim, kind, number if len(found) > 1 else 0)
            shown = f"{claim.id} {kind}".rstrip()
            try:
                theorems.append(_theorem(name, claim, part))
            except NoStatementError as error:
                if claim.id in BY_HAND:
                    by_hand.append((shown, BY_HAND[claim.id]))
                else:
                    left.append(Left(shown, part.text, str(error)))
            except HFieldError as error:
                left.append(Left(shown, part.text, str(error)))
    return Export(tuple(theorems), tuple(left), tuple(by_hand))


def theorem_name(claim: Claim, kind: str, number: int) -> str:
    """Return a Coq name for a claim, such as ``C1_3_1_y_corrected_2``."""
    base = claim.id.replace(".", "_").replace("-", "_")
    return "_".join(part for part in (base, kind, str(number or "")) if part)


def _propositions(claim: Claim) -> Iterator[tuple[str, Proposition]]:
    """Yield the propositions of a claim, as printed and as corrected."""
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
        case Angles():
            yield from _parts(proposition.core)
        case OnlyOver() | InField() | Analysis():  # about one field
            return
        case _:
            yield proposition


def _is_candidate(part: Proposition) -> bool:
    """Return whether a proposition is decided for all fields, in a form that a theorem can state."""
    decision = part.decide(None)
    if isinstance(part, Presented):
        return decision.verdict in (PROVED, REFUTED)
    return decision.verdict == PROVED and decision.scope is not None


def _theorem(name: str, claim: Claim, part: Proposition) -> Theorem:
    if not isinstance(part, Assertion | Presented):
        raise NoStatementError("this is not a statement of the language")
    decision = part.decide(None)
    data = certificate(part, decision, UNIVERSAL)
    if data is None:
        raise NotCoveredError("it has no certificate")
    name = f"{name}_fails" if decision.verdict == REFUTED else name
    return theorem(name, data, f"{claim.id}: ")


class NoStatementError(NotCoveredError):
    """A proposition cannot be translated because it is not in the language."""
