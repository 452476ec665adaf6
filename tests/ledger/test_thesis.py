"""All claims of the thesis, decided: verdicts, certificates, twins that differ, errata as found by hand."""

import json
import re
from collections import Counter

import pytest

from hfield.checker.check import ExpectedClaim, check_text
from hfield.checker.glossary import METHODS, THEOREMS, UNCERTIFIED
from hfield.fields.names import ring
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import NO_FIELD, PANEL, UNIVERSAL, Claim, Computed, decide
from hfield.ledger.registry import claims, find
from tests.subcases import first_quick, subcases
from tests.thorough import part

PARTS = 12  # every part has each claim over one or two fields
CHECKABLE = [claim for claim in claims() if claim.checkable]
ROWS_OF_SECTION = {
    "0": 5,
    "1": 6, "1.1.1": 1, "1.1.2": 4, "1.1.3": 17, "1.2": 7, "1.3": 2, "1.3.1": 27,
    "1.4.1": 1, "1.4.2": 9, "1.4.3": 10, "1.4.4": 8,
    "2.1": 3, "2.1.1": 10, "2.1.2": 12, "2.1.3": 4,
    "2.2.1": 1, "2.2.2": 5, "2.2.3": 5, "2.2.4": 22, "2.2.5": 15,
    "3.1.1": 16, "3.1.2": 4, "3.2": 3, "3.2.1": 19,
    "3.3": 11, "3.4": 5, "3.4.1": 13, "3.4.2": 8, "3.4.3": 6, "3.4.4": 6, "3.5": 4, "4": 2,
}  # fmt: skip


def _ids(text: str) -> set[str]:
    return set(text.split())


NOT_CHECKABLE = _ids(
    """
    C1.1.2-d C1.3-b C1.4.4-h C2.2.4-a C2.2.5-0 C0-a C0-e C3.1.1-c C3.1.1-o C3.2-a C3.2-b C3.2-c
    C3.2.1-b C3.2.1-m C3.2.1-q C3.2.1-r C3.3-f C3.4-d C3.4-e C3.4.1-g C3.4.4-e C3.5-b C3.5-c C3.5-d
    C4-b
    """
)
# Worked out by hand from the thesis: what is wrong, where signs matter and where they do not (2 = 0).
SIGNS = _ids(
    """
    C0-d C1.3.1-l C1.3.1-m C1.3.1-p C1.4.3-d C1.4.3-e C1.4.3-g C2.1.1-f C2.1.2-a C2.1.2-b C2.1.2-d
    C2.1.2-e C2.1.2-i C2.1.2-j C2.2.4-l2 C2.2.4-p C2.2.5-l C3.4.2-a C3.4.4-a C3.4.4-a2
    """
)
EVERYWHERE = _ids(
    """
    C0-c C1.1.3-b C1.1.3-e C1.1.3-f C1.1.3-n C1.2-a C1.3.1-aa C1.4.2-a C1.4.4-d C1.4.4-e C2.1.1-b
    C2.1.2-h C2.1.3-b C2.2.2-a C2.2.4-b C2.2.4-d C2.2.4-g C2.2.4-n C2.2.4-q C2.2.5-a C2.2.5-f
    """
)
NO_ROOTS = {"C1.3.1-a"}  # a norm that is not a square
OF_NO_FIELD = _ids(
    """
    C2.1.1-i C3.1.1-a C3.1.1-h C3.2.1-f C3.2.1-l C3.2.1-o C3.3-j C3.3-k C3.4.1-j C3.4.2-f C3.4.3-b
    C3.4.3-c C3.4.3-d C3.4.4-d C3.5-a C4-a
    """
)
OVER_R_ALONE = {"C1.4.4-c", "C2.1-a", "C2.1.1-d", "C2.1.3-a"}


def test_the_rows() -> None:
    assert Counter(claim.section for claim in claims()) >= Counter(ROWS_OF_SECTION)
    for attribute in ("id", "name"):
        assert len({getattr(claim, attribute) for claim in claims()}) == len(claims())
    for claim in claims():
        assert re.fullmatch(r"[a-z0-9]+([-.][a-z0-9]+)*", claim.name), claim.name
        assert claim.statement
        assert claim.checkable or claim.note, f"{claim.id} must say why it cannot be checked"
        assert claim.fields in (PANEL, (NO_FIELD,))
    assert {claim.id for claim in claims() if not claim.checkable} == NOT_CHECKABLE


@pytest.mark.parametrize("claim", CHECKABLE, ids=lambda claim: claim.id)
def test_decided(claim: Claim) -> None:
    rows = {field: decide(claim, field) for field in claim.fields}
    for field, row in rows.items():
        assert row.settled, (field, row.as_printed, row.as_corrected)
    # A universal proof covers every column.
    if UNIVERSAL in rows and rows[UNIVERSAL].as_printed.verdict == "proved":
        assert all(row.as_printed.verdict != "refuted" for row in rows.values())


@pytest.mark.parametrize("start", first_quick(part(range(PARTS), 4), 1))
@subcases(("n", "claim"), list(enumerate(CHECKABLE)))
def test_certificates(n: int, claim: Claim, start: int) -> None:
    """In each part a claim over some of its fields, the next claim over others."""
    for field in claim.fields[(n + start) % PARTS :: PARTS]:
        row = decide(claim, field)
        if row.as_printed.verdict == "refuted":
            assert row.as_printed.witness is not None, f"refuted over {field} without a witness"
            assert row.as_corrected is not None, f"refuted over {field} without a correction"
        for proposition, decision in (
            (claim.as_printed, row.as_printed),
            (claim.corrected, row.as_corrected),
        ):
            if proposition is None or decision is None:
                continue
            assert set(decision.method.split("; ")) <= {*METHODS, *UNCERTIFIED}, decision.method
            assert set(decision.assumes) <= THEOREMS.keys()
            data = certificate(proposition, decision, field)
            if isinstance(proposition, Computed) or decision.verdict == "not-applicable":
                assert data is None
                continue
            assert data is not None, f"no certificate over {field}"
            assert (data["method"], data["assumes"]) == (decision.method, list(decision.assumes))
            pin = ExpectedClaim((proposition.statement,), data["field"])
            assert check_text(json.dumps(data), pin).verdict == decision.verdict
        if field not in (UNIVERSAL, NO_FIELD):
            for name, values in (row.as_printed.witness or {}).items():
                assert name == "F" or [ring(field)(text) for text in values]


@pytest.mark.slow
@subcases("claim", CHECKABLE)
def test_the_spoilt_twin_changes_the_verdict(claim: Claim) -> None:
    assert claim.spoilt is not None
    assert claim.as_printed is not None
    for field in claim.fields:
        base = None if field in (UNIVERSAL, NO_FIELD) else ring(field)
        verdicts = claim.as_printed.decide(base).verdict, claim.spoilt.decide(base).verdict
        if "undecided" not in verdicts and verdicts[0] != verdicts[1]:
            return
    pytest.fail(f"the twin of {claim.id} has the same verdict in every column")


@pytest.mark.parametrize(
    ("field", "wrong"),
    [
        ("QQ", SIGNS | EVERYWHERE | NO_ROOTS),
        ("GF(4)", EVERYWHERE),
        ("GF(2)(t)", EVERYWHERE),
        ("RR", SIGNS | EVERYWHERE | OVER_R_ALONE),
        (NO_FIELD, OF_NO_FIELD),
    ],
)
def test_the_errata(field: str, wrong: set[str]) -> None:
    rows = [decide(claim, field) for claim in CHECKABLE if field in claim.fields]
    assert {row.claim.id for row in rows if row.as_printed.verdict == "refuted"} == wrong


def test_a_claim_of_no_field_names_the_field_of_its_witness() -> None:
    row = decide(find("zero-norms"), NO_FIELD)
    assert row.as_printed.verdict == "proved"
    assert row.as_printed.witness is not None
    assert row.as_printed.witness["F"] == ["CC"]
    assert decide(find("letter-t-sides"), NO_FIELD).as_printed.witness == {"F": ["QQ"], "s": ["8"]}


def test_what_analysis_lends_is_cited_over_r_alone() -> None:
    theorem = find("theorem-5")
    over_r = decide(theorem, "RR").as_printed
    assert any("circle" in text for text in over_r.assumes)
    assert decide(theorem, "QQ").as_printed.assumes == ()
    assert any("odd degree" in text for text in decide(find("lemma-2"), "RR").as_printed.assumes)
    assert decide(find("lemma-2"), "QQ").as_printed.verdict == "not-applicable"


def test_unknown_claims_get_a_suggestion() -> None:
    with pytest.raises(LookupError, match="theorem-1"):
        find("theorem1")
