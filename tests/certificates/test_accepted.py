"""Every certificate that is given is accepted, and pinned to what it is about."""

import json

import pytest

from hfield.certificates.check import Pin, check, check_text
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import decide
from hfield.ledger.registry import claims
from hfield.proving.decision import PROVED, REFUTED, VACUOUS
from tests.certificates.cases import ALGEBRAS, FIELDS, STATEMENTS, certificates, decided


def test_certificates_of_prove_are_accepted() -> None:
    found = certificates()
    assert len(found) > 0.95 * (len(STATEMENTS) * len(FIELDS) + len(ALGEBRAS))
    for data in found:
        pin = Pin((data["statement"],), data["field"], data["algebra"])
        established = check_text(json.dumps(data), pin)
        assert established.verdict == data["verdict"]


def test_the_whole_panel_is_certified_and_accepted() -> None:
    chapter_1 = [c for c in claims() if c.checkable and type(c).__module__.startswith("hfield")]
    rows = 0
    for claim in (c for c in chapter_1 if c.id.startswith("C1")):
        for field in claim.fields:
            row = decide(claim, field)
            pairs = ((claim.as_printed, row.as_printed), (claim.corrected, row.as_corrected))
            for proposition, decision in pairs:
                if decision is None or decision.verdict not in (PROVED, REFUTED, VACUOUS):
                    continue
                data = certificate(proposition, decision, field)
                assert data is not None, (claim.id, field)
                assert proposition is not None
                check(data, Pin((proposition.statement,), data["field"]))
                rows += 1
    assert rows > 1_500


@pytest.mark.parametrize(
    ("statement", "field", "scope"),
    [
        ("(p*q)*r == p*(q*r)", None, "commutative rings"),
        ("p*q == e => q*p == e", None, "commutative rings"),
        ("norm(q) != 0 => q*inv(q) == e", None, "fields"),
        ("p*q == q*p", "GF(2)", "field"),
    ],
)
def test_scope_of_what_is_established(statement: str, field: str | None, scope: str) -> None:
    established = check(decided(statement, field))
    assert (established.verdict, established.scope) == ("proved", scope)


@pytest.mark.parametrize(
    "algebra",
    [
        "[1,t|GF(2)(t))",
        "[x/t,t+1|GF(4)(t))",
        "(-1,-1|QQ(sqrt(-7)))",
        "(x,3|QQ(x))",
        "(-1,1+sqrt(3)|QQ(sqrt(3)))",
    ],
)
def test_nothing_about_an_algebra_is_assumed(algebra: str) -> None:
    data = decided("norm(q) == 0 => q == 0", None, algebra)
    assert data["assumes"] == []
    assert check(data).verdict == "proved"


def test_blanks_and_parentheses_do_not_matter_to_a_pin() -> None:
    data = decided("(p*q)*r == p*(q*r)", "GF(9)")
    assert check(data, Pin((" p*q * r==(p*(q*r))",), "GF(9)"))
