"""The core of the checker, cases, witnesses, existence, rings that are no fields, roots by theorems."""

from typing import Any

import pytest

from hfield.checker.check import check
from hfield.checker.check_result import CheckResult, together
from hfield.checker.evidence.existence import MAX_CASES
from hfield.checker.glossary import COMMUTATIVE_RINGS, FIELD, FIELDS
from hfield.checker.rejection import (
    Rejected,
)
from tests.checker.cases import about_field, certified
from tests.checker.hand_made import IDENTITY, direct, ends, implication, opposite, rejects
from tests.checker.ring_data import data_of
from tests.subcases import subcases

# --- exhaustion, witness, existence --------------------------------------------------------------


def test_exhaustion_of_many_cases_goes_by_clauses() -> None:
    data = certified("p*q == q*p", "GF(4)", "exhaustion", {"kind": "exhaustion", "cases": 4**8})
    assert check(data)
    rejects({**data, "statement": "p*q == q*p and norm(p) == 0"}, "false in one of the cases")
    data = certified(
        "p*q == 1 => q*p == 1", "GF(3)", "exhaustion", {"kind": "exhaustion", "cases": 3**8}
    )
    assert check(data)
    rejects({**data, "statement": "p*q == 1 => q*p == p"}, "false in one of the cases")
    rejects({**data, "evidence": {"kind": "exhaustion", "cases": 3**8 - 1}}, "number of cases")
    for field in ("GF(5003)", "QQ", "ZZ", "GF(9)(t)"):
        rejects(about_field(data, field), ".")
    rejects(about_field(data, None), "finite ring only")
    divides = certified(
        "s*y*t*z*x == 1 => 1/s == y*t*z*x",
        "ZZ/6",
        "exhaustion",
        {"kind": "exhaustion", "cases": 6**5},
    )
    assert check(divides)
    rejects({**divides, "statement": "s*y*t*z*x == 1 => 1/s == y*t*z"}, "false in one")


def test_exhaustion_of_what_exists() -> None:
    data = certified(
        "exists s: s*s == y or s*s == 2*y",
        "GF(3)",
        "exhaustion",
        {"kind": "exhaustion", "cases": 3},
    )
    assert check(data)
    rejects({**data, "statement": "exists s: s*s == y"}, "nothing exists")
    rejects({**data, "evidence": {"kind": "exhaustion", "cases": 9}}, "number of cases")
    where = {**data, "statement": "exists s: s*a == 1", "algebra": "(1/a,-1|GF(3))"}
    assert check(where)  # at a = 0 there is no algebra
    nowhere = {**data, "statement": "exists s: s == a", "algebra": "(1/(a**3-a),-1|GF(3))"}
    rejects(nowhere, "nowhere")


def test_witnesses() -> None:
    values = {"kind": "witness", "ring": data_of("QQ"), "values": {"s": ["2"]}}
    data = certified("exists s: s*s == 4", "QQ", "witness", values)
    assert check(data)
    rejects({**data, "statement": "exists s: s*s == 5"}, "false at the values")
    rejects({**data, "statement": "exists s: s*s == y"}, "no other unknowns")
    rejects(about_field(data, None), "only for one field")
    rejects({**data, "verdict": "refuted"}, "does not show")
    floats = {"kind": "witness", "ring": data_of("RDF"), "values": {"s": ["2"]}}
    false = certified("s*s == s", "RDF", "floats, exact on small integers", floats)
    assert check({**false, "verdict": "refuted"})
    rejects({**false, "verdict": "refuted", "method": "counterexample"}, "method")
    rejects({**false, "verdict": "proved"}, "nothing is proved over floats")
    for text in ("0.5", "9007199254740992", "1/2"):
        own = {**floats, "values": {"s": [text]}}
        rejects({**false, "verdict": "refuted", "evidence": own}, "float")
    rejects(
        {
            **certified("s == s", "QQ", "identity", {"kind": "unsatisfiable", "proof": IDENTITY}),
            "verdict": "vacuous",
        },
        "no hypotheses",
    )
    three = certified("s == 1 => s == 2 => s == 3 => q == 0", "QQ", "implication", {})
    item = direct(["s - 1", "s - 2", "s - 3"], "1", ["1", "-1", "0"])
    proof = {"kind": "unsatisfiable", "proof": implication([item])}
    assert check({**three, "verdict": "vacuous", "evidence": proof})


def test_terms_and_cases() -> None:
    terms = {"kind": "terms", "terms": {"q": "inv(p)"}, "proof": implication([])}
    data = certified("norm(p) != 0 => (exists q: p*q == 1)", None, "witness", terms)
    assert check(data).scope == FIELDS
    for term in ("p", "q", "m", "norm(p)", "r"):
        rejects({**data, "evidence": {**terms, "terms": {"q": term}}}, ".")
    denied = {**data, "statement": "norm(p) != 0 => (exists q: not (p*q != 1))"}
    assert check(denied).scope == FIELDS
    denied["statement"] = "norm(p) == 0 or norm(p) == 1 => (exists q: not (p*q != q*p))"
    rejects(denied, "not covered")  # true where inv(p) is not defined, but that names no q
    scalar = {"kind": "terms", "terms": {"s": "p"}, "proof": IDENTITY}
    rejects(certified("exists s: s == p", None, "witness", scalar), "does not fit")
    linear = certified("exists s: y*s == y*t", "QQ", "witness", {})
    first = {
        "when": "y == 0",
        "terms": {"s": "0"},
        "proof": implication([direct(["y"], "t*y", ["t"])]),
    }
    second = {"when": "y != 0", "terms": {"s": "y*t/y"}, "proof": implication([])}
    cases = {"kind": "cases", "cases": [first, second], "cover": implication([])}
    assert check({**linear, "evidence": cases}).scope == FIELD
    rejects({**linear, "evidence": cases, "method": "implication"}, "not that of the evidence")
    given = {**linear, "statement": "t != 0 => (exists s: y*s == y*t)", "evidence": cases}
    assert check(given)
    for bad in (
        {**cases, "cases": [second]},
        {**cases, "cases": []},
        {**cases, "cases": [first, second] * MAX_CASES},
        {**cases, "cover": IDENTITY, "cases": [first]},
        {**cases, "cases": [{**first, "when": "s == 0"}, second]},
        {**cases, "cases": [{**first, "when": "z == 0"}, second]},
        {**cases, "cases": [{**first, "when": "exists x: x == y"}, second]},
        {**cases, "cases": [{**first, "when": "y"}, second]},
        {**cases, "cases": [{**first, "terms": {"s": "s"}}, second]},
        {**cases, "cases": [{**first, "terms": {}}, second]},
        {**cases, "cases": [first, {**second, "terms": {"s": "t + 1"}}]},
        {**cases, "cases": [{**first, "when": "y != 1"}, second]},
    ):
        rejects({**linear, "evidence": bad}, ".")


def test_places() -> None:
    inner = {"kind": "none exists", "proof": implication([])}
    place = {"kind": "place", "values": {"y": ["0"]}, "proof": inner}
    data = certified("exists s: s*y == 1", "QQ", "implication", place)
    data["verdict"] = "refuted"
    assert check(data)
    rejects({**data, "evidence": {**place, "values": {"y": ["1"]}}}, "not covered")
    rejects({**data, "evidence": {**place, "proof": implication([])}}, "none exists")
    rejects({**data, "evidence": inner}, "unknowns that are given")
    lettered = {**data, "statement": "exists s: s*a == b", "algebra": "(1/a,b|QQ)"}
    rejects({**lettered, "evidence": {**place, "values": {"a": ["0"], "b": ["1"]}}}, "nowhere")
    plain = {**data, "statement": "exists s: s*a == b", "algebra": "(a,b|QQ)"}
    assert check({**plain, "evidence": {**place, "values": {"a": ["0"], "b": ["1"]}}})
    whole = {"kind": "place", "values": {"p": ["0", "0", "0", "0"]}, "proof": inner}
    both = {**data, "statement": "exists q: q*p == 1", "evidence": whole}
    assert check(both)
    everywhere = {**about_field(both, None), "evidence": {**whole, "ring": data_of("GF(9)")}}
    assert check(everywhere).scope == FIELD


# --- rings that are no fields, roots by theorems ---------------------------------------------------


def test_what_another_ring_shows() -> None:
    item = opposite(["2*s"], ["s"], [ends("T1", "2", d=2)])
    inner = implication([item])
    data = certified("2*s == 0 => s == 0", "ZZ", "implication", {})
    there = {"kind": "fractions", "ring": data_of("QQ"), "proof": inner}
    assert check({**data, "evidence": there}).scope == FIELD
    poly = about_field(data, "ZZ[x]")
    assert check({**poly, "evidence": {**there, "ring": data_of("QQ(x)")}})
    mod_5 = about_field(data, "GF(5)[x]")
    assert check({**mod_5, "evidence": {**there, "ring": data_of("GF(5)(x)")}})
    for field, ring in (
        ("QQ(x)", "ZZ"),
        ("QQ", "ZZ[x]"),
        ("QQ(t)", "ZZ[x]"),
        ("GF(3)(x)", "GF(5)[x]"),
        ("QQ", "ZZ/6"),
        ("QQ", "GF(5)"),
        ("RR", "ZZ"),
        ("QQ", "RDF"),
    ):
        rejects({**about_field(data, ring), "evidence": {**there, "ring": data_of(field)}}, ".")
    rejects({**data, "statement": "2*s == 2 => 1/s == 1", "evidence": there}, "without division")
    cases = {"kind": "exhaustion", "cases": 2}
    reduced = {"kind": "reduction", "modulus": 2, "proof": cases}
    none = certified(
        "exists s: 2*s == 1", "ZZ", "exhaustion", {"kind": "none exists", "proof": reduced}
    )
    none["verdict"] = "refuted"
    assert check(none)
    over_6 = about_field(none, "ZZ/6")
    assert check(over_6)
    for bad in (
        about_field(none, "ZZ/9"),
        about_field(none, "QQ"),
        {**none, "statement": "exists s: 3*s == 1"},
        {**none, "statement": "exists s: 2*s == 1 or s != s + 2"},
        {**none, "statement": "exists s: 2*s == 1/1"},
        {**none, "evidence": {"kind": "none exists", "proof": {**reduced, "modulus": 1}}},
    ):
        rejects(bad, ".")
    goal = certified("s*s == s => s == 0 or s == 1", "ZZ", "exhaustion", reduced)
    rejects(goal, "no common zero")


@subcases(
    ("text", "field", "evidence", "good"),
    [
        ("exists s: s**3 == 2", "RR", {"by": "odd degree"}, True),
        ("exists s: s**3 + y*s == norm(q)", "RR", {"by": "odd degree"}, True),
        ("exists s: y*s**3 == 2", "RR", {"by": "odd degree"}, False),
        ("exists s: s**2 == 2", "RR", {"by": "odd degree"}, False),
        ("exists s: s**3 == 2", "QQ", {"by": "odd degree"}, False),
        ("exists s: s**2 == 2", "RR", {"by": "square"}, True),
        ("exists s: -3*s**2 == -norm(q)", "RR", {"by": "square"}, True),
        ("exists s: s**2 == 0", "RR", {"by": "square"}, True),
        ("exists s: s**2 == -1", "RR", {"by": "square"}, False),
        ("exists s: s**2 + s == 1", "RR", {"by": "square"}, False),
        ("exists s: s**2 == y", "RR", {"by": "square"}, False),
        ("exists s: y*s**2 == 1", "RR", {"by": "square"}, False),
        ("exists s: s**4 == 3*s + 1", "RR", {"by": "sign change", "between": ["0", "2"]}, True),
        (
            "exists s: s**4 == 3*s + 1",
            "RR",
            {"by": "sign change", "between": ["-1/2", "1/2"]},
            True,
        ),
        ("exists s: s**4 == 3*s + 1", "RR", {"by": "sign change", "between": ["2", "3"]}, False),
        ("exists s: s**4 == y", "RR", {"by": "sign change", "between": ["2", "3"]}, False),
        ("exists s: s**4 == 2", "RR", {"by": "sign change", "between": ["1"]}, False),
        ("exists s: s**4 == 2", "RR", {"by": "trust"}, False),
        ("exists s: s**4 + y*s == p[1]", "CC", {}, True),
        ("exists s: y*s**4 == 1", "CC", {}, False),
        ("exists s: 0*s == 1", "CC", {}, False),
        ("exists s: s**2 == q", "CC", {}, False),
        ("exists s: s != 1", "CC", {}, False),
        ("exists s, t: s + t == 1", "CC", {}, False),
        ("exists s: 1/s == 1", "CC", {}, False),
        ("exists s: s == s", "CC", {}, False),
        ("exists q: q == 1", "CC", {}, False),
    ],
)
def test_roots_by_theorems(text: str, field: str, evidence: Any, good: bool) -> None:
    kind = "complex root" if field == "CC" else "real root"
    data = certified(text, field, "witness", {"kind": kind, **evidence})
    try:
        check(data)
    except Rejected as error:
        named = str(error).rpartition(": ")[2]
        if good:
            assert check({**data, "assumes": [named]}).theorems == (named,)
        else:
            with pytest.raises(Rejected):
                check({**data, "assumes": [named]})
    else:
        raise AssertionError("a theorem must be cited")


def test_findings() -> None:
    wide, narrow = (
        CheckResult(COMMUTATIVE_RINGS, "identity"),
        CheckResult(FIELD, "exhaustion").citing("a", "b", "a"),
    )
    both = together([wide, narrow, narrow])
    assert both == CheckResult(FIELD, "identity; exhaustion", ("a", "b"))
    assert wide.within(FIELDS).scope == FIELDS
    assert narrow.within(COMMUTATIVE_RINGS).scope == FIELD
    assert together([]).scope == COMMUTATIVE_RINGS
    assert narrow.by("witness") == CheckResult(FIELD, "witness", ("a", "b"))


@pytest.mark.parametrize(
    ("statement", "field", "algebra"),
    [
        ("s == 0 or (1/s)**2 == 1/s", "GF(2)", None),
        ("s == 0 or y == 0 or s/y == y/s", "GF(3)", None),
        ("q*conj(q) == norm(q)**2", "GF(2)", "(a/b,b|GF(2))"),
        ("norm(q) == 0 or inv(q) == conj(q)", "GF(2)", None),
    ],
)
def test_an_identity_of_fractions_holds_where_no_denominator_is_0(
    statement: str, field: str, algebra: str | None
) -> None:
    data = certified(statement, field, "identity", IDENTITY)
    data["algebra"] = algebra or data["algebra"]
    assert check(data)
    for other in ("GF(5)", "QQ"):
        moved = data["algebra"].replace(field, other)
        rejects({**about_field(data, other), "algebra": moved}, "expanding")
    _, _, last = statement.partition(" or ")
    if last:
        rejects({**data, "statement": last}, "expanding")


def test_every_coordinate_has_to_vanish() -> None:
    for first in ("(s**2 - s)*e", "s == 0 or (1/s - (1/s)**2)*e"):
        data = certified(f"{first} + (y**2 - y)*i == 0", "GF(2)", "identity", IDENTITY)
        assert check(data)
        rejects({**data, "statement": f"{first} + y*i == 0"}, "expanding")


@pytest.mark.parametrize(
    ("statement", "ring"), [("2*s == 0", "ZZ/4"), ("2*s == 0 or 3*s == 0", "ZZ/6")]
)
def test_where_zero_has_divisors_a_product_that_vanishes_shows_nothing(
    statement: str, ring: str
) -> None:
    rejects(certified(statement, ring, "identity", IDENTITY), "expanding")
