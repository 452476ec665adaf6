"""The ledger's statements over GF(2) and GF(3), case by case, by an evaluator that is not the prover."""

import pytest

from hfield.fields import GF
from hfield.ledger.propositions import Assertion, Every
from hfield.ledger.registry import claims
from tests.adversary.falsify import is_true
from tests.adversary.meaning import read_claim
from tests.adversary.small_rings import galois
from tests.thorough import cases

CASES = cases(10**6)
CASES_LATER = cases(2 * 10**5)  # for the chapters after the first, which have longer statements


def statements(proposition):
    """The statements that a proposition is made of."""
    if isinstance(proposition, Assertion):
        return [proposition.statement]
    parts = proposition.parts if isinstance(proposition, Every) else ()
    return [text for part in parts for text in statements(part)]


MOST = {
    text: CASES if claim.id.startswith("C1") else CASES_LATER
    for claim in reversed(claims())
    for proposition in (claim.as_printed, claim.corrected, claim.spoilt)
    for text in statements(proposition)
}


@pytest.mark.slow
@pytest.mark.parametrize("p", [2, 3])
def test_every_case_agrees_with_the_verdict(p):
    tried = 0
    for text, most in MOST.items():
        true = is_true(read_claim(text, None), galois(p), most)
        if true is None:
            continue
        verdict = Assertion(text).decide(GF(p)).verdict
        assert (verdict in ("proved", "vacuous")) == true, text
        tried += 1
    assert tried > 100
