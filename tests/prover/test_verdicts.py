"""Statements with known verdicts, in one field and in all."""

import pytest

from hfield.prover.decide import decide
from hfield.prover.evaluation.evaluator import Evaluator
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.statements.language import Sort, read_statement
from hfield.prover.statements.setting import read_setting
from tests.prover.statements import DEPENDS, FALSE, FIELD_NAMES, FIELDS, UNIVERSAL
from tests.subcases import subcases

PANEL = [*FIELD_NAMES, "RR", "CC", "GF(5)", "GF(7)", "GF(8)", "GF(13)", "QQ(sqrt(2))", "QQ(x)"]
CLASH = {"QQ(x)": "x", "GF(2)(t)": "t"}  # their generators are scalar unknowns elsewhere


def true_at(statement, field, algebra, witness):
    """Evaluate a statement without quantifiers at a witness read back from its texts."""
    setting = read_setting(field, algebra)
    F = setting.field
    read = read_statement(statement, F, (), setting.letters, setting.constants)
    values = {text: F(text) for text in read.constants}
    for name, sort in read.unknowns:
        coordinates = tuple(F(text) for text in witness[name])
        values[name] = coordinates[0] if sort is Sort.SCALAR else coordinates
    fixed = {text: F(text) for text in read.constants}
    world = Evaluator(RingScalars(F), setting.trees, read.sorts, fixed)
    world.bind(values)
    hypotheses = all(world.truth(h) for h in read.hypotheses)
    return not hypotheses or world.truth(read.conclusion)


@subcases("statement", UNIVERSAL)
def test_universal_statements_are_proved_over_every_commutative_ring(statement):
    decision = decide(statement)
    assert (decision.verdict, decision.scope) == ("proved", "commutative rings")


@subcases("statement", FIELDS)
def test_statements_about_fields_are_proved_over_every_field(statement):
    decision = decide(statement)
    assert decision.verdict == "proved"
    assert decision.scope in ("fields", "reduced rings")


def test_true_statements_are_proved_over_each_field_of_the_panel():
    for field in PANEL:
        for statement in [*UNIVERSAL, *FIELDS]:
            if CLASH.get(field, "!") in statement.replace("exists", ""):
                continue
            decision = decide(statement, field)
            assert decision.verdict in ("proved", "vacuous"), (statement, field)
            assert decision.verdict == "proved" or "2 == 0" in statement


@subcases("statement", FALSE)
def test_false_statements_are_refuted_by_a_witness(statement):
    decision = decide(statement)
    assert decision.verdict == "refuted"
    if "exists" not in statement:
        assert not true_at(statement, decision.witness["F"][0], None, decision.witness)


def test_false_statements_are_refuted_over_fields_of_odd_characteristic():
    for field in ("QQ", "GF(3)", "GF(9)", "QQ(sqrt(-7))", "GF(13)"):
        for statement in FALSE:
            decision = decide(statement, field)
            assert decision.verdict == "refuted", (statement, field)
            if "exists" not in statement:
                assert not true_at(statement, field, None, decision.witness), (statement, field)


@subcases("statement", DEPENDS)
def test_statements_that_depend_on_the_field_are_distinguished(statement):
    for field in FIELD_NAMES:
        decision = decide(statement, field)
        expected = field in DEPENDS[statement]
        assert decision.verdict == ("proved" if expected else "refuted"), field
        if not expected and "exists" not in statement:
            assert not true_at(statement, field, None, decision.witness)


def test_scopes_say_where_a_proof_holds():
    assert decide("p*q == q*p", "GF(4)").scope == "characteristics [2]"
    assert decide("p*q == q*p", "QQ").scope == "characteristics [2]"
    assert decide("6*comm(p,q) == 0").scope == "characteristics [2, 3]"
    assert decide("q**4 == q**2", "GF(2)").scope == "field"
    assert decide("norm(q) == 0 => q == 0", "QQ").scope == "field"
    assert decide("(p*q)*r == p*(q*r)", "QQ").scope == "commutative rings"
    assert decide("s**2 == 0 => s == 0").scope == "reduced rings"
    assert decide("p*q == p", "QQ").scope is None


def test_small_witnesses_come_first():
    assert decide("p*q == q*p", "QQ").witness == {
        "p": ["0", "1", "0", "0"],
        "q": ["0", "0", "1", "0"],
    }
    assert decide("norm(q) == 0 => q == 0", "GF(2)").witness == {"q": ["1", "1", "0", "0"]}
    assert decide("q*inv(q) == e", "RR").witness == {"q": ["0", "0", "0", "0"]}


def test_hypotheses_that_never_hold_make_a_statement_vacuous():
    assert decide("2 == 0 => p*q == q*p", "QQ").verdict == "vacuous"
    assert decide("2 == 0 => p*q == q*p").verdict == "proved"
    assert decide("norm(q) == -1 => q == 5", "RR").verdict == "vacuous"
    assert decide("s**2 == 2 => s == 5", "QQ").verdict == "vacuous"
    assert decide("s**2 == 2 => s == 5", "RR").verdict == "refuted"
    assert decide("s**2 == 2 => s == 5", "GF(3)").verdict == "vacuous"
    assert decide("q != q => 1 == 0").verdict == "vacuous"
    assert decide("p*q == e", "QQ", given=["p == 0", "p == 1"]).verdict == "vacuous"


ALGEBRAS = [
    ("norm(p*q) == norm(p)*norm(q)", "(a,b|F)", None, "proved"),
    ("norm(p*q) == norm(p)*norm(q)", "[a,b,t|F)", None, "proved"),
    ("(p*q)*r == p*(q*r)", "[a,b,t|F)", None, "proved"),
    ("conj(p*q) == conj(q)*conj(p)", "[a,b,t|F)", None, "proved"),
    ("q**2 - trace(q)*q + norm(q) == 0", "[a,b,t|F)", None, "proved"),
    ("i*i == a and j*j == b and i*j == k and j*i == -k", "(a,b|F)", None, "proved"),
    ("i*i == a + t*i and j*i == t*j - k", "[a,b,t|F)", None, "proved"),
    ("i*i == b", "(a,b|F)", None, "refuted"),
    ("p*q == q*p", "(a,b|F)", "QQ", "refuted"),
    ("p*q == q*p", "(a,b|F)", "GF(4)", "proved"),
    ("p*q == q*p", "[1,x|GF(4))", None, "refuted"),
    ("norm(q) == 0 => q == 0", "(-1,-3|QQ)", None, "proved"),
    ("norm(q) == 0 => q == 0", "(2,3|QQ)", None, "proved"),
    ("norm(q) == 0 => q == 0", "(1,3|QQ)", None, "refuted"),
    ("p*q == 0 => p == 0 or q == 0", "(-1/2,-3|QQ)", None, "proved"),
    ("q*conj(q) == norm(q)", "(-1/2,-3/7|QQ)", None, "proved"),
    ("norm(q) == 0 => q == 0", "[1,t|GF(2)(t))", None, "proved"),
    ("norm(q) == 0 => q == 0", "(x,-1|QQ(x))", None, "proved"),
    ("i**2 == x and norm(i) == -x", "(x,-1|QQ(x))", None, "proved"),
    ("norm(p*q) == norm(p)*norm(q)", "(1/x,x+1|QQ(x))", None, "proved"),
    ("a != 0 => norm(i) != 0", "(a,b|F)", None, "proved"),
    ("norm(i) != 0", "(a,b|F)", "QQ", "refuted"),
]


@subcases(("statement", "algebra", "field", "verdict"), ALGEBRAS)
def test_other_algebras(statement, algebra, field, verdict):
    decision = decide(statement, field, algebra=algebra)
    assert decision.verdict == verdict
    if verdict == "refuted":
        place = decision.witness.get("F", [field])[0]
        assert not true_at(statement, place, algebra, decision.witness)


def test_letters_are_nonzero_in_a_witness_where_possible():
    witness = decide("p*q == q*p", algebra="(a,b|F)").witness
    assert (witness["a"], witness["b"]) == (["-1"], ["-1"])


CONSTANTS = [
    ("x**2 == x + 1", "GF(9)", "proved"),
    ("x**2 == 2*x + 1", "GF(9)", "refuted"),
    ("x*q == q*x", "QQ(x)", "proved"),
    ("sqrt(2)**2 == 2", "QQ(sqrt(2))", "proved"),
    ("(sqrt(2)*q)**2 == 2*q**2", "RR", "proved"),
    ("sqrt(2)*sqrt(3)*q == sqrt(6)*q", "RR", "proved"),
    ("sqrt(2)*sqrt(3)*q == sqrt(5)*q", "RR", "refuted"),
    ("s**2 == 2 => s == sqrt(2) or s == -sqrt(2)", "QQ(sqrt(2))", "proved"),
    ("s**2 == 2 => s == sqrt(2)", "RR", "refuted"),
    ("s**2 == -1 => s == I or s == -I", "CC", "proved"),
    ("(e + I*i)*(e - I*i) == 0", "QQ(I)", "proved"),
    ("t*q == 0 => q == 0", "GF(2)(t)", None),
]


@subcases(("statement", "field", "verdict"), CONSTANTS)
def test_constants_of_the_field(statement, field, verdict):
    decision = decide(statement, field)
    if verdict is None:  # a limit that is known: a transcendental constant is not inverted
        assert decision.verdict in ("proved", "undecided")
    else:
        assert decision.verdict == verdict


def test_rings_that_are_no_fields():
    assert decide("2*q == 0 => q == 0", "ZZ").verdict == "proved"
    assert decide("p*q == 0 => p == 0 or q == 0", "ZZ/6").verdict == "refuted"
    assert decide("6*q == 0", "ZZ/6").verdict == "proved"
    assert decide("s**3 == s", "ZZ/6").verdict == "proved"
    assert decide("s**2 == s", "ZZ/6").verdict == "refuted"
    assert decide("s**2 == 0 => s == 0", "ZZ/6").verdict == "proved"
    assert decide("s**2 == 0 => s == 0", "ZZ/4").verdict == "refuted"
    assert decide("(p*q)*r == p*(q*r)", "ZZ[a,b,c]").verdict == "proved"
    assert decide("inv(q)*q == e or norm(q) == 2", "ZZ").verdict == "refuted"


def test_inexact_rings_prove_nothing():
    assert decide("(p*q)*r == p*(q*r)", "RDF").verdict == "undecided"
    assert decide("p*q == q*p", "RDF").verdict == "refuted"


def test_undecided_says_what_was_tried():
    decision = decide("exists s: s**2 + y*s == norm(q)", "RR", timeout=5)
    assert decision.verdict == "undecided"
    assert decision.tried
    assert decision.evidence is None


def test_given_hypotheses_are_put_in_front():
    assert decide("q*p == e", given=["p*q == e"]).verdict == "proved"
    assert decide("p == 0 or q == 0", "QQ", given=["p*q == 0"]).verdict == "proved"
    assert decide("exists r: q*r == e", "GF(5)", given=["norm(q) != 0"]).verdict == "proved"


def test_existence_in_other_algebras():
    assert decide("exists q: q**2 == a", algebra="(a,b|F)").verdict == "proved"
    assert decide("exists q: q != 0 and norm(q) == 0", algebra="(a,b|F)").verdict == "refuted"
    assert (
        decide("exists q: q != 0 and norm(q) == 0", "GF(3)", algebra="(a,b|F)").verdict == "proved"
    )
    assert decide("exists q: q*p == a", "QQ", algebra="(a,b|F)").verdict == "refuted"
    assert decide("exists r: r*q == e or norm(q) == 0", "GF(2)(t)").verdict == "proved"
    over_ring = decide("exists u: k == 0 and t != scalar(i)", "QQ[x,y]", algebra="[a,b,t|F)")
    assert over_ring.verdict in ("refuted", "undecided")


def test_what_exists_may_depend_on_nothing_that_is_given():
    decision = decide("exists q: comm(p, p) == 0 and trace(q) == 9", "QQ")
    assert decision.verdict == "proved"
    assert decide("exists q: q*p == p*q and q != 0", None).verdict == "proved"
    assert decide("exists p: p[1] == norm(q)").verdict == "proved"
    assert decide("exists q: q*q == p", "GF(3)").verdict == "refuted"
    assert decide("exists s: s*s == y", "GF(4)").verdict == "proved"
    assert decide("exists s: s*s == y", "QQ").verdict == "refuted"


@pytest.mark.parametrize("algebra", ["(-1/2,-3|F)", "(a/2,-3|F)"])
def test_no_counterexample_in_a_field_without_the_constants(algebra):
    """1/2 does not exist in characteristic 2, so GF(2) refutes nothing here; in (a,-3|F) it does."""
    assert decide("2*q != 0 or q == 0", algebra=algebra).verdict == "proved"
    assert decide("2*q != 0 or q == 0", algebra="(a,-3|F)").witness["F"] == ["GF(2)"]
    assert decide("norm(q) == 0 => q == 0", algebra=algebra).witness["F"] != ["GF(2)"]
