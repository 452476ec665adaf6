"""What is true because its hypotheses never are is called vacuous, by prover and checker."""

import pytest

from hfield import prove
from hfield.checker.check import Rejected, check
from hfield.fields.names import ring
from hfield.prover.methods.presentations import decide_presentation, presentation_text
from tests.checker.cases import certified

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


@pytest.mark.parametrize(
    ("relations", "field"),
    [
        (["1 == 2"], None),
        (["2 == 0"], "QQ"),
        (["i == j", "i == j + 1"], None),
        (["4 == 1"], "GF(5)"),
    ],
)
def test_relations_that_leave_no_algebra_are_vacuous(relations, field):
    statement = presentation_text(relations, ["i == 0"])
    decision = decide_presentation(relations, ["i == 0"], field=field)
    assert decision.verdict == "vacuous"
    data = decision.certificate(statement, f"(-1,-1|{field or 'F'})", field and ring(field))
    assert check(data).verdict == "vacuous"
    with pytest.raises(Rejected):  # nothing is shown of relations that hold somewhere
        check({**data, "statement": statement.replace(relations[0], "i == k", 1)})
    with pytest.raises(Rejected):
        check({**data, "statement": statement.replace("(i, j, k)", "(e, i, j, k)")})


@pytest.mark.parametrize(
    ("number", "field", "verdict"),
    [
        (-1, None, "vacuous"),
        (2, "QQ", "vacuous"),
        (2, None, "proved"),
        (2, "GF(2)", "proved"),
        (5, "GF(3)", "vacuous"),
    ],
)
def test_what_follows_from_a_number_that_is_0_is_proved_where_it_may_be(number, field, verdict):
    evidence = {
        "kind": "presentation",
        "characteristic": 0,
        "identity": True,
        "relations": [[[number, ""]]],
        "goals": [[[number, "i"]]],
        "proofs": [{"cofactors": [[1, "i", 0, ""]], "denominator": 1}],
    }
    statement = f"associative(i, j, k): {number} == 0 => {number}*i == 0"
    data = certified(statement, field, "presentation", evidence)
    if verdict == "proved":
        assert check(data).verdict == "proved"
    else:
        with pytest.raises(Rejected, match="vacuous and not proved"):
            check(data)


def test_relations_that_leave_algebras_of_characteristic_2_are_not_vacuous():
    relations, goals = ["i*i == 1", "i*j == j*i + 1", "j*j == j"], ["2*i == 0"]
    assert decide_presentation(relations, goals).verdict == "proved"
    assert decide_presentation(relations, goals, field="QQ").verdict == "vacuous"
    assert decide_presentation(relations, goals, field="GF(4)").verdict == "proved"
