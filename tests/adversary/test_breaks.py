"""What once broke: files that passed for false claims, and answers whose scope claimed too much."""

import json
from typing import Any

import pytest

from hfield.checker.check import Rejected, check, check_text
from hfield.prover.prove import prove
from tests.adversary.forging.targets import Target
from tests.adversary.judgement import judge
from tests.checker.ring_data import data_of
from tests.subcases import subcases

IDENTITY = {"kind": "identity"}
NOTHING = {"kind": "none exists", "proof": IDENTITY}
NEVER = {"kind": "witness", "ring": data_of("QQ"), "values": {}}
ZERO_RING = {
    "kind": "presentation",
    "characteristic": 0,
    "identity": True,
    "relations": [[[-1, ""]]],
    "goals": [[[1, "i"]]],
    "proofs": [{"cofactors": [[-1, "i", 0, ""]], "denominator": 1}],
}
EMPTY = {"kind": "implication", "facts": [], "items": []}


def over(field: str, evidence: dict[str, Any]) -> dict[str, Any]:
    return {**evidence, "ring": data_of(field)}


def place(values: dict[str, str], proof: dict[str, Any]) -> dict[str, Any]:
    return {"kind": "place", "values": {k: [v] for k, v in values.items()}, "proof": proof}


def part(verdict: str, evidence: dict[str, Any]) -> dict[str, Any]:
    return {"verdict": verdict, "evidence": evidence}


FILES = [
    # Over QQ(x) the bound unknown x was read as the generator.
    (Target("exists x: x == 0", None, "refuted"), over("QQ(x)", NOTHING)),
    (Target("exists t: t*t == t", None, "refuted"), over("GF(2)(t)", NOTHING)),
    (Target("exists x: x**2 == x", None, "refuted"), over("GF(9)", place({}, NOTHING))),
    # A letter of the algebra was put into the statement and not into the structure constants.
    (
        Target("exists s: i*i == x", None, "refuted", algebra="(x,-1|F)"),
        over("QQ(x)", place({"x": "0"}, NOTHING)),
    ),
    (
        Target("exists s: i*i == a", None, "refuted", algebra="(a,-1|F)"),
        over("QQ(t)", place({"a": "t"}, NOTHING)),
    ),
    # The algebra does not exist at a = 0.
    (
        Target("exists y: a*y == 1", "GF(3)", "refuted", algebra="(1/a,1|GF(3))"),
        place({"a": "0"}, NOTHING),
    ),
    (
        Target("exists y: a*y == 1", "QQ", "refuted", algebra="(a**-1,1|QQ)"),
        place({"a": "0"}, NOTHING),
    ),
    # The algebra exists nowhere.
    *(
        (Target("1 == 2", "QQ", verdict, algebra=algebra), evidence)
        for algebra in ("(1/0,-1|QQ)", "[1,1/(s-s)|QQ)", "(0/0,1|QQ)", "(0**-1,1|QQ)")
        for verdict, evidence in (
            ("proved", IDENTITY),
            ("proved", EMPTY),
            ("refuted", {"kind": "witness", "ring": data_of("QQ"), "values": {}}),
        )
    ),
    # "x != 0" is false over every field, and true of the generator of QQ(x).
    (
        Target("implies{x != 0; 2 == 0}", None, "refuted"),
        over(
            "QQ(x)",
            {
                "kind": "over",
                "evidence": {
                    "kind": "both",
                    "left": part("proved", IDENTITY),
                    "right": part(
                        "refuted", {"kind": "witness", "ring": data_of("QQ(x)"), "values": {}}
                    ),
                },
            },
        ),
    ),
    # A term that is not defined makes "not" true.
    *(
        (
            Target("exists y: not (y == y)", "GF(2)"),
            {"kind": "terms", "terms": {"y": term}, "proof": IDENTITY},
        )
        for term in ("0.5", "1/0", "0**-1", "norm(inv(0*e))", "1/(1 + 1)")
    ),
    # A count of cases that is not the count.
    (Target("s**2 == s", "GF(2)"), {"kind": "exhaustion", "cases": 0}),
    (Target("s**3 == s", "GF(3)"), {"kind": "exhaustion", "cases": 2}),
    (Target("s**6 == s**2", "GF(5)"), {"kind": "exhaustion", "cases": True}),
    # What is said of RR was not looked at over all fields.
    (Target("angles{1 == 1; 1 == 2}", None), IDENTITY),
    (
        Target("every{angles{1 == 1; 1 == 2}; 1 == 1}", None),
        {"kind": "parts", "parts": [part("proved", IDENTITY)] * 2},
    ),
    (
        Target("angles{1 == 1; 1 == 1}", None, "refuted"),
        over("QQ", {"kind": "over", "evidence": NEVER}),
    ),
    # Relations that leave no algebra other than 0.
    (Target("associative(i, j, k): 1 == 2 => i == 0", None), ZERO_RING),
]


@subcases(("target", "evidence"), FILES)
def test_the_file_is_rejected(target: Target, evidence: dict[str, Any]) -> None:
    for method in (
        "identity",
        "implication",
        "exhaustion",
        "counterexample",
        "witness",
        "presentation",
    ):
        with pytest.raises(Rejected) as caught:
            check(target.certificate(evidence, method))
        assert "the method" not in str(caught.value)


def test_generators_may_be_named_where_the_field_is() -> None:
    data = Target("exists s: s == x", "QQ(x)").certificate(
        {"kind": "terms", "terms": {"s": "x"}, "proof": IDENTITY}, "witness"
    )
    assert check(data).verdict == "proved"


@pytest.mark.parametrize(
    ("statement", "terms"),
    [
        ("exists y: s*y == 1 or s == 0", {"y": "1/s"}),
        ("exists u, z: u*s + z == s*u + 1", {"u": "s*i", "z": "1"}),
    ],
)
def test_terms_for_all_that_exists_binds(statement: str, terms: dict[str, str]) -> None:
    target = Target(statement, "QQ")
    evidence = {"kind": "terms", "terms": terms, "proof": IDENTITY}
    assert check(target.certificate(evidence, "witness")).scope == "field"
    for name in terms:
        less = {
            "kind": "terms",
            "terms": {n: terms[n] for n in terms if n != name},
            "proof": IDENTITY,
        }
        with pytest.raises(Rejected, match="lacks"):
            check(target.certificate(less, "witness"))


def test_an_element_shows_existence_over_its_field_alone() -> None:
    evidence = {"kind": "witness", "ring": data_of("QQ"), "values": {"y": ["2"]}}
    assert check(Target("exists y: y*y == 4").certificate(evidence, "witness")).scope == "field"
    with pytest.raises(Rejected):
        check(Target("exists y: y*y == 4", None).certificate(evidence, "witness"))


def test_a_text_that_does_not_end_is_read_once() -> None:
    """A million quotes with a backslash: by trying each as a beginning, this took days."""
    for text in ('"' + '\\"' * 1_000_000, '"' * 999_999, '{"a": "' + '\\"[' * 300_000):
        with pytest.raises(Rejected):
            check_text(text)
    assert check_text(json.dumps(Target("s == s").certificate(IDENTITY, "identity"))).verdict


SCOPES = [
    ("s != 0 => s/s + 2*s == 1", None, None),
    ("s != 0 => s/s + 2*s == 1", "GF(2)", None),
    ("s != 0 => s/s + 3*norm(q) == 1", "QQ", "(a,b|QQ)"),
    ("s**3 == s => s == 0 or s == 1", "GF(8)", "(1,1|GF(8))"),
    ("q**3 == 0 => q**2 == 0", "GF(8)", None),
    ("p**3 == 0 => p**2 == 0", "GF(2)(t)", "(-1,b**2|GF(2)(t))"),
    ("exists z: 2*z == 3", None, None),
    ("exists z: 12*z == 2", None, None),
    ("exists z: 0.2*z == 12", None, None),
    ("exists z: 1/2*z == 4", "GF(8)", None),
    ("exists q: 3*q == j and i*q != 0", None, None),
    ("exists q: inv(q) == a*q", "GF(2)", "(a,-1|GF(2))"),
    ("a == 0 => i*i == 0", "GF(3)", "(1/a,1|GF(3))"),
    ("a != 0", "QQ", "(1/a,-1|QQ)"),
    ("a**2 == 0 => q**0 == 0", None, "(1/a,-1|F)"),
    ("norm(k) == a**-1", None, "(a**-1,1|F)"),
    ("i*i == 1/a", "QQ(sqrt(-7))", "(1/a,-1|QQ(sqrt(-7)))"),
    ("2 == 0 => a == 0", None, "(-1,1/(a-1)|F)"),
    ("a**-1 == a**-1 or a == 0", "ZZ/12", "(1/a,-1|ZZ/12)"),
    ("q == q", "GF(2)", "(1/2,-1|GF(2))"),
    ("1 == 2", "QQ", "(1/0,-1|QQ)"),
    ("exists u, z: u*(k*k) + z == q", "ZZ/8", "(a,a|ZZ/8)"),
    ("exists p: p != 0 and norm(p) == 0", None, "(a/b,b|F)"),
]


@subcases(("statement", "field", "algebra"), SCOPES)
def test_the_answer_claims_no_more_than_is_so(
    statement: str, field: str | None, algebra: str | None
) -> None:
    answer = prove(statement, field, (), algebra)
    found = answer.to_json()
    for seed in range(3):
        assert judge(statement, field, found["algebra"], found, seed) == []
    if answer.certificate is not None:
        assert check(answer.certificate).verdict == answer.verdict
