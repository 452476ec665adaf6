"""Chapter 2, decided: every row has a verdict, every twin changes one, every correction holds."""

from collections import Counter

import pytest

from hfield.certificates.check import Pin, check
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import NO_FIELD, PANEL, UNIVERSAL, Claim, decide
from hfield.ledger.registry import claims, find
from hfield.proving.decision import PROVED, REFUTED, VACUOUS
from hfield.rings import ring

CHAPTER = [claim for claim in claims() if claim.id.startswith("C2")]
CHECKABLE = [claim for claim in CHAPTER if claim.checkable]
ROWS_OF_SECTION = {
    "2.1": 3, "2.1.1": 10, "2.1.2": 12, "2.1.3": 4,
    "2.2.1": 1, "2.2.2": 5, "2.2.3": 5, "2.2.4": 22, "2.2.5": 15,
}  # fmt: skip
# Worked out by hand from the thesis: what is wrong over ℝ, and what of it holds where 2 = 0.
WRONG_SIGN = {
    *("C2.1.1-f", "C2.1.2-a", "C2.1.2-b", "C2.1.2-d", "C2.1.2-e", "C2.1.2-i", "C2.1.2-j"),
    *("C2.2.4-l2", "C2.2.4-p", "C2.2.5-l"),
}
WRONG_EVERYWHERE = {
    *("C2.1.1-b", "C2.1.2-h", "C2.1.3-b", "C2.2.2-a", "C2.2.4-b", "C2.2.4-d", "C2.2.4-g"),
    *("C2.2.4-n", "C2.2.4-q", "C2.2.5-a", "C2.2.5-f"),
}
WRONG_OVER_R_ALONE = {"C2.1-a", "C2.1.1-d", "C2.1.3-a"}


def test_all_77_rows_are_there() -> None:
    assert Counter(claim.section for claim in CHAPTER) == ROWS_OF_SECTION
    names = [claim.name for claim in claims()]
    assert len(set(names)) == len(names)
    for claim in CHAPTER:
        assert claim.statement
        assert claim.checkable or claim.note, f"{claim.id} must say why it cannot be checked"
    assert [c.id for c in CHAPTER if not c.checkable] == ["C2.2.4-a", "C2.2.5-0"]
    fieldless = [c.id for c in CHAPTER if c.fields == (NO_FIELD,)]
    assert fieldless == ["C2.1.1-h", "C2.1.1-i", "C2.1.2-f", "C2.1.2-g"]


@pytest.mark.parametrize("claim", CHECKABLE, ids=lambda claim: claim.id)
def test_decided_and_certified_over_the_panel(claim: Claim) -> None:
    rows = {field: decide(claim, field) for field in claim.fields}
    for field, row in rows.items():
        assert row.settled, (field, row.as_printed, row.as_corrected)
        if row.as_printed.verdict == REFUTED:
            assert row.as_printed.witness is not None, f"refuted over {field} without a witness"
            assert row.as_corrected is not None, f"refuted over {field} without a correction"
            assert row.as_corrected.verdict in (PROVED, VACUOUS)
        pairs = ((claim.as_printed, row.as_printed), (claim.corrected, row.as_corrected))
        for proposition, decision in pairs:
            if proposition is None or decision is None or decision.verdict == "not-applicable":
                continue
            data = certificate(proposition, decision, field)
            assert data is not None, field
            check(data, Pin((proposition.statement,), data["field"]))
            assert bool(data["assumes"]) == bool(decision.assumes), field
    if UNIVERSAL in rows and rows[UNIVERSAL].as_printed.verdict == PROVED:
        assert all(row.as_printed.verdict != REFUTED for row in rows.values())


@pytest.mark.parametrize("claim", CHECKABLE, ids=lambda claim: claim.id)
def test_the_spoilt_twin_changes_the_verdict(claim: Claim) -> None:
    assert claim.spoilt is not None
    assert claim.as_printed is not None
    for field in claim.fields:
        base = None if field in (UNIVERSAL, NO_FIELD) else ring(field)
        verdicts = claim.as_printed.decide(base).verdict, claim.spoilt.decide(base).verdict
        if "undecided" not in verdicts and verdicts[0] != verdicts[1]:
            return
    pytest.fail(f"the twin of {claim.id} has the same verdict in every column")


def refuted(field: str) -> set[str]:
    rows = (decide(claim, field) for claim in CHECKABLE if field in claim.fields)
    return {row.claim.id for row in rows if row.as_printed.verdict == REFUTED}


def test_the_errata() -> None:
    assert refuted("QQ") == WRONG_SIGN | WRONG_EVERYWHERE
    assert refuted("RR") == WRONG_SIGN | WRONG_EVERYWHERE | WRONG_OVER_R_ALONE
    assert refuted("GF(2)(t)") == WRONG_EVERYWHERE
    assert refuted(NO_FIELD) == {"C2.1.1-i"}


@pytest.mark.parametrize("field", [name for name in PANEL if name != UNIVERSAL])
def test_witnesses_are_texts_that_the_field_reads(field: str) -> None:
    for claim in CHECKABLE:
        if field in claim.fields:
            for values in (decide(claim, field).as_printed.witness or {}).values():
                for text in values:
                    ring(field)(text)


def test_what_analysis_lends_is_cited_over_r_alone() -> None:
    theorem = find("theorem-5")
    over_r = decide(theorem, "RR").as_printed
    assert any("circle" in text for text in over_r.assumes)
    data = certificate(theorem.as_printed, over_r, "RR")
    assert data is not None
    assert any("square in RR" in text for text in data["assumes"])
    assert decide(theorem, "QQ").as_printed.assumes == ()
    assert any("odd degree" in text for text in decide(find("lemma-2"), "RR").as_printed.assumes)
    assert decide(find("lemma-2"), "QQ").as_printed.verdict == "not-applicable"


def test_the_point_that_does_not_exist() -> None:
    row = decide(find("letter-t-sides"), NO_FIELD)
    assert row.as_printed.witness == {"F": ["QQ"], "s": ["8"]}
