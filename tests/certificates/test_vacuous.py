"""What is true because its hypotheses never are is called vacuous, by prover and checker."""

import pytest

from hfield import prove
from hfield.certificates.check import Rejected, check

NEVER = [
    ("a == 0 => i*i == 0", "(1/a,1|GF(3))"),
    ("a == 0 => i*i == 0", "(1/a,1|F)"),
    ("1 == 0 => p*q == q*p", "(-1,-1|QQ)"),
    ("s != s => p == q", "(-1,-1|F)"),
    ("not (s == s) => p == q", "(-1,-1|ZZ)"),
    ("s**4 != s => p == q", "(-1,-1|GF(4))"),
    ("1 == 0 => (exists s: s*s == 2)", "(-1,-1|QQ)"),
    ("s != s => (exists u: u*p == 2)", "(-1,-1|GF(3))"),
]


@pytest.mark.parametrize(("statement", "algebra"), NEVER)
def test_it_is_said_to_be_vacuous(statement, algebra):
    decision = prove(statement, algebra=algebra)
    assert decision.verdict == "vacuous"
    assert check(decision.certificate).verdict == "vacuous"
    assert "vacuous" in str(check(decision.certificate)).splitlines()[0]


@pytest.mark.parametrize(("statement", "algebra"), NEVER)
def test_it_is_not_proved(statement, algebra):
    own = prove(statement, algebra=algebra).certificate
    evidences = [
        ("identity", {"kind": "identity"}),
        ("exhaustion", {"kind": "exhaustion", "cases": 3}),
    ]
    if "exists" in statement:
        terms = {"u" if "u" in statement else "s": "1"}
        proof = {"kind": "terms", "terms": terms, "proof": {"kind": "identity"}}
        evidences = [("witness", proof)]
    for method, evidence in evidences:
        with pytest.raises(Rejected, match=r"vacuous and not proved|number of cases|finite"):
            check({**own, "verdict": "proved", "method": method, "evidence": evidence})
        whole = {**own, "statement": f"every{{{statement}; s == s}}", "verdict": "proved"}
        both = [{"verdict": "proved", "evidence": e} for e in (evidence, {"kind": "identity"})]
        with pytest.raises(Rejected):
            check({**whole, "method": method, "evidence": {"kind": "parts", "parts": both}})


def test_hypotheses_that_hold_somewhere_are_none_of_the_checkers_business():
    for statement, algebra in (
        ("s == 0 => s*s == 0", "(-1,-1|GF(3))"),
        ("a == 1 => i*i == 1", "(1/a,1|F)"),
        ("s*s == s => s**3 == s", "(-1,-1|QQ)"),
        ("s*s == 2 => p == p", "(-1,-1|F)"),
    ):
        decision = prove(statement, algebra=algebra)
        assert decision.verdict == "proved"
        assert check(decision.certificate).verdict == "proved"
