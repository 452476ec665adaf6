"""The ledger as theorems of Coq: nothing that is proved for all fields is missing."""

import re

import pytest

from hfield.export.coq.ledger import BY_HAND, export_ledger, theorem_name
from hfield.ledger.propositions import Assertion
from hfield.ledger.registry import claims, find


@pytest.fixture(scope="module")
def export():
    """The theorems of what is proved by hand, and of a share of the other claims."""
    chosen = [c for n, c in enumerate(claims()) if c.id in {*BY_HAND, "C1.1.3-q"} or n % 8 == 0]
    return export_ledger(chosen)


@pytest.mark.slow
def test_everything_universal_is_exported():
    export = export_ledger()
    assert export.left == ()
    names = {t.name for t in export.theorems}
    for claim in claims():
        for kind, whole in (("", claim.as_printed), ("corrected", claim.corrected)):
            if isinstance(whole, Assertion) and whole.decide(None).verdict in ("proved", "vacuous"):
                assert theorem_name(claim, kind, 0) in names, claim.id
    assert {"C1_3_1_y_corrected_7", "C1_2_g", "C1_2_a_2_fails", "C1_1_2_b_2"} <= names
    assert len(names) == len(export.theorems) > 220


@pytest.mark.slow
def test_claims_in_words_are_proved_by_hand(export):
    stated = set(export.names)
    for claim, theorems in export.by_hand:
        assert claim.split()[0] in BY_HAND
        assert set(theorems.split(", ")) <= stated
    assert len(export.by_hand) == len(BY_HAND)


def test_every_theorem_is_in_the_last_command(export):
    assert len(set(export.names)) == len(export.names)
    listed = re.findall(r"let _ := @(\w+) in", export.text)
    assert tuple(listed) == export.names
    assert export.text.rstrip().endswith("Print Assumptions all_theorems.")
    for word in ("Axiom ", "Admitted", "Parameter ", "Conjecture ", "admit."):
        assert word not in export.text


def test_the_text_of_the_claim_stands_above_its_theorem(export):
    theorem = next(t for t in export.theorems if t.name == "C1_1_3_q")
    comment = "C1.1.3-q: (p*q)*r == p*(q*r), in (-1,-1|F) [proved, all fields]"
    assert str(theorem).startswith(
        f"(* {comment} *)\nTheorem C1_1_3_q :\n  every commutative ring R, "
    )


def test_claims_can_be_chosen():
    chosen = export_ledger([find("associativity"), find("impression"), find("modulus-chain")])
    assert [t.name for t in chosen.theorems] == ["C1_1_3_q", "C1_3_1_p_corrected"]
    assert [(x.name, x.reason) for x in chosen.left] == [
        ("C1.1.2-d", "nothing in it is proved for all fields")
    ]
