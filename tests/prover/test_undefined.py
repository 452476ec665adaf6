"""Undefined is never a value: structure constants that do not exist, and terms that do not."""

import pytest

from hfield.errors import NotationError
from hfield.prover.decide import decide
from hfield.prover.prove import prove
from tests.prover.small_rings import RINGS, truths
from tests.subcases import subcases

CONSTANTS = [
    ("a != 0", "(1/a,-1|QQ)", "proved"),
    ("a != 0", "(1/(1/a),1|F)", "proved"),
    ("a != 0", "(a**-2,1|QQ)", "proved"),
    ("a == 0 => i*i == 0", "(1/a,1|GF(3))", "vacuous"),
    ("a == 0 => i*i == 0", "(a,1|GF(3))", "proved"),
    ("1 == 2", "(1/0,-1|QQ)", "not-applicable"),
    ("1 == 1", "(1/0,-1|QQ)", "not-applicable"),
    ("exists s: s == s", "(1/0,-1|F)", "not-applicable"),
    ("p == p", "(1/2,-1|GF(4))", "not-applicable"),
    ("p == p", "(0.5,-1|GF(2))", "not-applicable"),
    ("p == p", "(1/2,1|ZZ)", "not-applicable"),
    ("p == p", "(1/(2*a),1|ZZ)", "not-applicable"),
    ("p == p", "(1/(a*a-a),1|GF(2))", "not-applicable"),
    ("p == p", "(1/(a*a-a),1|GF(3))", "proved"),
    ("a == 2", "(1/(a*a-a),1|GF(3))", "proved"),
    ("p == p", "(1/(a-a),1|F)", "not-applicable"),
    ("p == p", "(1/(a-a),1|QQ)", "not-applicable"),
    ("1 == 1", "(1/(x-x),1|QQ(x))", "not-applicable"),
    ("1 == 1", "(1/x,1|QQ(x))", "proved"),
    ("a == 0", "(a/(a*a+1),1|GF(2))", "proved"),
    ("a != 1", "(1/(a-1),b|F)", "proved"),
    ("2 != 0", "(1/2,b|F)", "proved"),
    ("2*q == 0 => q == 0", "(1/2,b|F)", "proved"),
    ("2*q == 0 => q == 0", "(a,b|F)", "refuted"),
    ("2*i*i == 1", "(0.5,1|F)", "proved"),
    ("a*a == 1", "(1/a,b|ZZ/4)", "proved"),
    ("a*a == 1", "(1/a,b|ZZ/5)", "refuted"),
    ("exists s: s*a == 1", "(1/a,b|F)", "proved"),
    ("exists s: s*a == 1", "(a,b|F)", "refuted"),
    ("a != 0 and b != 0", "(1/a,1/b|F)", "proved"),
    ("a**2 != 2", "(1/(a*a-2),1|RR)", "proved"),
    ("a != -b", "(1/(a+b),b|GF(3))", "proved"),
]


@subcases(("statement", "algebra", "verdict"), CONSTANTS)
def test_structure_constants_restrict_what_is_said(statement, algebra, verdict):
    assert decide(statement, algebra=algebra).verdict == verdict


def test_no_algebra_has_no_certificate_and_no_truth():
    answer = prove("1 == 2", algebra="(1/0,-1|QQ)")
    assert answer.certificate is None
    assert answer.exit_status == 3
    assert "there is no algebra (1/0,-1|QQ)" in str(answer)


def test_a_letter_is_given_and_nothing_binds_it():
    with pytest.raises(NotationError, match="a letter of the algebra"):
        decide("exists a: a*a == 2", algebra="(a,b|F)")


FINITE = {"Z/2": "GF(2)", "Z/3": "GF(3)", "Z/4": "ZZ/4", "Z/6": "ZZ/6", "GF(4)": "GF(4)"}
ALGEBRAS = [("1/a", "0", "-1"), ("1/(a-1)", "0", "b"), ("a/(a*a+1)", "0", "1"), ("1/a", "1/b", "2")]
STATEMENTS = [
    "a != 0",
    "i*i*a == 1",
    "a == 1 or a == -1",
    "a == 0 => 1 == 2",
    "i*i == 1 => a == 1",
    "1/a == 1/a",
    "a != 1 and b != 0",
    "exists s: s*a == 1",
    "exists s: s*(a - 1) == 1",
    "norm(i) == 0 => 1/norm(i) == 0",
    "not (inv(i) == inv(i))",
]


@pytest.mark.parametrize("constants", ALGEBRAS)
def test_small_rings_agree_with_all_cases(constants):
    for ring in (r for r in RINGS if r.name in FINITE):
        a, t, b = constants
        for statement in STATEMENTS:
            algebra = f"[{a},{b},{t}|{FINITE[ring.name]})"
            if "b" not in (*algebra,) and "b" in statement:
                continue
            true, given, defined = truths(statement, ring, constants)
            if not defined.any():
                expected = "not-applicable"
            elif not (given & defined).any():
                expected = "vacuous"
            else:
                expected = "proved" if (true | ~defined).all() else "refuted"
            assert decide(statement, algebra=algebra).verdict == expected, (statement, algebra)


TERMS = [
    ("1/0 == 1", None, "refuted"),
    ("1/0 != 1", None, "refuted"),
    ("not (1/0 == 1)", None, "proved"),
    ("s/0 == s/0", None, "refuted"),
    ("inv(0) == inv(0)", "QQ", "refuted"),
    ("(1/0)**0 == 1", "QQ", "refuted"),
    ("0*(1/0) == 0", "QQ", "refuted"),
    ("0**-1 == 0**-1", "GF(5)", "refuted"),
    ("0.1 == 0.1", None, "refuted"),
    ("0.1 == 0.1", "GF(5)", "refuted"),
    ("0.1 == 0.1", "GF(3)", "proved"),
    ("0.5 == 0.5", "ZZ", "refuted"),
    ("0.5 == 0.5", "ZZ/9", "proved"),
    ("not (0.5 == 0.5)", "ZZ/4", "proved"),
    ("2**-1 == 2**-1", "ZZ", "refuted"),
    ("1/0 == 1 => 1 == 2", "QQ", "vacuous"),
    ("s == 2 => s/s == 1", "ZZ", "refuted"),
    ("s == -1 => s/s == 1", "ZZ", None),
    ("exists s: 1/s == 1/s", "ZZ/6", "proved"),
    ("exists s: 1/(2*s) == 1/(2*s)", "ZZ/6", "refuted"),
    # no element is listed where nothing is unknown
    ("not (1/1000003 == 1/1000003)", "ZZ/1000036000099", "proved"),
    # 101 divides 0, and only far from 0 that shows
    ("t != 0 => 1/t == 1/t", "ZZ/10403", "refuted"),
    ("t == 0 or 1/t == 1/t", "ZZ/10201", "refuted"),
    ("(t == 0 => 1 == 2) => t/t == 1", "ZZ/10403", "refuted"),
    ("t == 0 or 1/t == 1/t", "ZZ/10007", "proved"),
]


@subcases(("statement", "field", "verdict"), TERMS)
def test_terms_that_are_undefined_make_a_comparison_false(statement, field, verdict):
    decision = decide(statement, field)
    assert decision.verdict == verdict or (verdict is None and decision.verdict != "refuted")


@pytest.mark.parametrize(
    "statement",
    [
        "s*t == s*t or 1/2 == 1/2",
        "1/(t - t + 2) == 5 or s*s != 1",
        "2/1 == 1 => s == s",
        "s/s == 2 => y == 1",
    ],
)
def test_what_is_divided_by_tells_the_checker_which_cases_there_are(statement):
    assert prove(statement, "ZZ/9").certificate is not None


@subcases("text", ["inv(b)", "conj(b)", "norm(b)", "comm(a,b)", "a[1]", "norm(2)"])
@subcases("field", ["F", "QQ", "ZZ"])
def test_structure_constants_are_made_of_scalars(text, field):
    with pytest.raises(NotationError, match="is about quaternions"):
        decide("p*p == 3", algebra=f"({text},-1|{field})")


@pytest.mark.parametrize("statement", ["O(2^3) == 0", "s == 0 => s == O(2^3)", "1/O(2) == 1/O(4)"])
def test_digits_that_are_not_known_leave_a_statement_undecided(statement):
    found = decide(statement, "Qp(2)")
    assert found.verdict == "undecided"
    assert found.tried
