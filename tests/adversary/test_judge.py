"""The judge of forgeries sees: true claims are called true, false ones false, of every shape.

A campaign without breaks says nothing where its judge is blind.
"""

import json

import pytest

from hfield.checker.check import Established, check
from hfield.prover.prove import prove
from tests.adversary.forging.campaign import Forgery, _judged, false_claim
from tests.adversary.forging.targets import NO_FIELDS, NO_RINGS, TARGETS, Certificate, Target
from tests.adversary.forging.validity import why_valid
from tests.adversary.grammar import NotRead
from tests.adversary.ring_names import name_of
from tests.adversary.test_breaks import FILES
from tests.adversary.test_forgeries import pool
from tests.checker.ring_data import Data, data_of
from tests.subcases import subcases

WORDS = (
    ("division", "QQ", True), ("division", "GF(3)", False), ("division", "QQ(sqrt(-7))", True),
    ("level-above{1}", "GF(3)", True), ("level-above{2}", "GF(3)", False), ("formally-real", "QQ(I)", False),
    ("not-everywhere{s == 0}", None, True), ("every{1 == 1; 1 == 2}", "QQ", False),
    ("every{s == s; p*q == q*p}", "GF(3)", False), ("implies{1 == 2; s == 0}", "QQ", True),
    ("iff{1 == 1; 1 == 2}", "GF(5)", False), ("centre{2}", "GF(2)", True),
    ("over{GF(3); p*q == q*p}", None, False), ("over{GF(2); p*q == q*p}", None, True),
    ("modulus-law{*}", "GF(5)", False), ("basis{2; 1,0; 0,2}", "QQ", True),
    ("basis{2; 1,1; 1,1}", "QQ", False), ("angles{1 == 1; 1 == 2}", None, False),
    ("angles{1 == 1; 1 == 2}", "RR", False), ("angles{1 == 1; 1 == 2}", "GF(5)", True),
    ("every{angles{1 == 1; 1 == 2}; 1 == 1}", None, False), ("not-everywhere{2 == 0}", "GF(2)", False),
    ("not-everywhere{angles{1 == 1; 1 == 2}}", None, True), ("angles{2 == 0; 1 == 1}", "GF(2)", True),
)  # fmt: skip
# What the judge cannot see: for which s there is no y, no sample of y says; and what algebras there are.
UNSEEN = {
    "exists y: not (s*y == 1) and s*y == 1",
    "implies{x != 0; 2 == 0}",
    "angles{1 == 1; 1 == 1}",
    "associative(i, j, k): 1 == 2 => i == 0",
}
TRUE_WITH_BAD_EVIDENCE = {"s**2 == s", "s**3 == s", "s**6 == s**2"}


def established(
    statement: str, algebra: str, field: str | None, verdict: str, scope: str
) -> Established:
    return Established(statement, algebra, field, None, verdict, scope, ())


def said(data: Certificate, scope: str | None = None) -> str:
    """Return what the judge has against a claim, in the scope of its form if no other is given."""
    scope = scope or ("fields" if data["field"] is None else "field")
    parts = (data[name] for name in ("statement", "algebra", "field", "verdict"))
    return false_claim(data, established(*parts, scope))


@pytest.mark.slow
def test_what_is_true_is_called_true() -> None:
    for data in pool():
        assert said(data, check(data).scope) == "", data["statement"]


@pytest.mark.slow
def test_what_is_false_is_called_false() -> None:
    forged = [(t, None) for t in TARGETS] + list(FILES)
    blind = {t.statement for t, evidence in forged if not said(t.certificate(evidence))}
    assert blind <= UNSEEN | TRUE_WITH_BAD_EVIDENCE


@subcases(
    ("statement", "field", "verdict", "values", "right"),
    [
        ("p*q == q*p", "QQ", "refuted", {"p": "0 1 0 0", "q": "0 0 1 0"}, True),
        ("p*q == q*p", "QQ", "refuted", {"p": "0 1 0 0", "q": "0 2 0 0"}, False),
        ("p*q == q*p", "GF(3)", "refuted", {"p": "0 1 0 0", "q": "0 0 1 0"}, True),
        ("p*q == q*p", None, "refuted", {"p": "0 1 0 0", "q": "0 0 1 0"}, True),
        ("s**2 != 2", "QQ(sqrt(2))", "refuted", {"s": "sqrt(2)"}, True),
        ("s**2 != 2", "QQ(sqrt(2))", "refuted", {"s": "1"}, False),
        ("exists s: s**2 == 4", "QQ", "proved", {"s": "-2"}, True),
        ("exists s: s**2 == 4", "QQ", "proved", {"s": "1"}, False),
        ("exists q: q*q == -1", "QQ(x)", "proved", {"q": "0 0 1 0"}, True),
        ("exists q: q*q == -1", "QQ(x)", "proved", {"q": "0 x 1 0"}, False),
    ],
)
def test_witnesses_are_evaluated(
    statement: str, field: str | None, verdict: str, values: dict[str, str], right: bool
) -> None:
    texts = {name: text.split() for name, text in values.items()}
    evidence = {"kind": "witness", "ring": data_of(field or "GF(3)"), "values": texts}
    assert (not said(Target(statement, field, verdict).certificate(evidence))) is right


@subcases("field", NO_FIELDS)
def test_there_is_no_such_ring(field: str) -> None:
    assert said(Target("s == s", field).certificate(None)).startswith("there is no ring")


@subcases(("name", "data"), NO_RINGS)
def test_these_are_the_data_of_no_ring(name: str, data: Data) -> None:
    assert said(Target("s == s", name).certificate(None, ring=data))
    with pytest.raises(NotRead):
        name_of(data)


@pytest.mark.parametrize(
    "name", ["QQ", "GF(9)", "GF(9, x^2+1)", "QQ(I)", "ZZ/6", "GF(4)(t)", "QQ[x,y]", "RDF"]
)
def test_data_that_are_not_those_of_the_name(name: str) -> None:
    data = data_of(name)
    assert name_of(data) == name
    for other in ("QQ(x)", "GF(3)", "ZZ"):
        claim = Target("s == s", other).certificate(None, ring=data)
        assert said(claim) == f"the data are not those of {other!r}"


@subcases(("statement", "field", "truth"), WORDS)
def test_words(statement: str, field: str | None, truth: bool) -> None:
    proved, refuted = (
        said(Target(statement, field, verdict).certificate(None))
        for verdict in ("proved", "refuted")
    )
    assert (proved == "") is truth
    if field is not None:  # what is refuted over all fields may be true over those that are tried
        assert (refuted == "") is not truth


def test_a_true_claim_turned_round_is_false() -> None:
    for data in pool():
        other = {"proved": "refuted", "refuted": "proved", "vacuous": "refuted"}[data["verdict"]]
        assert said({**data, "verdict": other}), (other, data["statement"], data["field"])


def test_a_fact_that_says_less_is_valid_where_steps_use_no_more() -> None:
    genuine = prove("q**2 == -e => trace(q) == 0", "QQ(sqrt(-7))").certificate
    assert genuine is not None
    weaker = json.loads(json.dumps(genuine))
    fact = weaker["evidence"]["facts"][0]
    assert fact["most"] == 4
    for most in (1, 2, 3, 4, 5):
        fact["most"] = most
        assert bool(why_valid(weaker, genuine)) is (most in (2, 3, 4)), most


def test_a_number_serves_in_place_of_what_is_not_0() -> None:
    genuine = prove("q**2 == q => q == 0 or q == e", "GF(4)").certificate
    assert genuine is not None
    for number, right in (("1", True), ("3", True), ("2", False), ("q[0]", False)):
        other = json.loads(json.dumps(genuine))
        (item,) = (x for x in other["evidence"]["items"] if x["nonzero"] == ["q[2]", "q[2]"])
        item["nonzero"][1] = number
        assert bool(why_valid(other, genuine)) is right, number


def test_a_campaign_reports_what_passes() -> None:
    true = next(d for d in pool() if d["verdict"] == "proved" and d["field"] == "QQ")
    false = {**true, "statement": "p*q == q*p"}
    shown = established(false["statement"], false["algebra"], "QQ", "proved", "field")
    for made in (
        Forgery("evidence", json.dumps(false), target=Target("p*q == q*p")),
        Forgery("mutants", json.dumps(false), original=true),
        Forgery("wholes", json.dumps(false)),
    ):
        assert _judged(made, shown, 0)
    assert not _judged(Forgery("mutants", json.dumps(true), original=true), shown, 0)
