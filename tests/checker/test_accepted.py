"""Every certificate that is given is accepted, and pinned to what it is about."""

import json

import pytest

from hfield.checker.check import ExpectedClaim, check, check_text
from hfield.checker.glossary import KULIKOV, THEOREMS
from hfield.checker.rejection import Rejected
from tests.checker.cases import (
    ALGEBRAS,
    FIELDS,
    STATEMENTS,
    certificates,
    certified,
    decided,
)


@pytest.mark.slow
def test_certificates_of_prove_are_accepted() -> None:
    found = certificates()
    assert len(found) > 0.95 * (len(STATEMENTS) * len(FIELDS) + len(ALGEBRAS))
    for data in found:
        expected = ExpectedClaim((data["statement"],), data["field"], data["algebra"])
        established = check_text(json.dumps(data), expected)
        assert established.verdict == data["verdict"]


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


def test_what_is_cited_stands_in_assumes(monkeypatch: pytest.MonkeyPatch) -> None:
    data = certified("modulus-law{*}", "QQ(sqrt(-7))", "choice of roots", {"kind": "pure subgroup"})
    established = check({**data, "assumes": [KULIKOV]})
    assert (established.theorems, established.assumptions) == ((KULIKOV,), ())
    assert f"cites the theorem: {KULIKOV}" in established.lines()
    monkeypatch.delitem(THEOREMS, KULIKOV)  # what is not listed is an assumption
    established = check({**data, "assumes": [KULIKOV]})
    assert (established.theorems, established.assumptions) == ((), (KULIKOV,))
    assert f"assumes, unproved: {KULIKOV}" in established.lines()
    for assumes in ([], [KULIKOV, KULIKOV], [KULIKOV, "0 == 1"]):
        with pytest.raises(Rejected, match="exactly"):
            check({**data, "assumes": assumes})
    assert check(decided("norm(q) == 0 => q == 0", "QQ(sqrt(-7))")).assumes == ()


def test_each_fact_is_printed_on_a_line_of_its_own() -> None:
    """A long statement is shown whole, and blanks in it make no lines."""
    text = "p*q == q*p" + " \n" * 150 + " or 0 == 0"
    established = check(certified(text, "QQ", "identity", {"kind": "identity"}))
    assert established.lines() == [
        "proved over QQ",
        "statement: p*q == q*p or 0 == 0",
        "field: QQ, the rational numbers",
        "algebra: (-1,-1|QQ)",
    ]
    everywhere = check(certified(text, None, "identity", {"kind": "identity"}))
    assert everywhere.lines()[:3:2] == ["proved over all commutative rings", "field: all"]


def test_vacuous_parts_are_said() -> None:
    never = "norm(q) == 1 and norm(q) == 2 => p == q"
    proof = decided(never, "QQ")["evidence"]
    parts = [
        {"verdict": "proved", "evidence": {"kind": "identity"}},
        {"verdict": "vacuous", "evidence": proof},
    ]
    evidence = {"kind": "parts", "parts": parts}
    data = certified(f"every{{q == q; {never}}}", "QQ", "identity; implication", evidence)
    established = check(data)
    assert established.vacuous == (never,)
    assert f"vacuous part: {never}" in established.lines()
    alone = {"kind": "parts", "parts": parts[1:]}
    data = certified(f"every{{{never}}}", "QQ", "implication", alone)
    with pytest.raises(Rejected, match="vacuous and not proved"):
        check(data)
    assert check({**data, "verdict": "vacuous"}).verdict == "vacuous"
    with pytest.raises(Rejected):
        check({**data, "verdict": "vacuous", "evidence": evidence})


def test_blanks_and_parentheses_do_not_matter_to_a_pin() -> None:
    data = decided("(p*q)*r == p*(q*r)", "GF(9)")
    assert check(data, ExpectedClaim((" p*q * r==(p*(q*r))",), "GF(9)"))
