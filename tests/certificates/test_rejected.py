"""What does not establish its statement is rejected, and says why."""

import copy
import json
import random
from itertools import product
from typing import Any

import pytest

from hfield import QQ, H
from hfield.certificates.check import Pin, check, check_text
from hfield.certificates.rejection import Rejected
from tests.certificates.cases import Certificate, decided

IDENTITY = {
    "schema": "hfield-cert/1",
    "statement": "(p*q)*r == p*(q*r)",
    "algebra": "(-1,-1|QQ)",
    "field": "QQ",
    "verdict": "proved",
    "method": "identity",
    "assumes": [],
    "evidence": {"kind": "identity"},
}
WITNESS = {"p": ["0", "1", "0", "0"], "q": ["0", "0", "1", "0"]}


def with_(**changes: Any) -> Certificate:
    return {**copy.deepcopy(IDENTITY), **changes}


def rejects(data: Certificate, why: str, pin: Pin | None = None) -> None:
    with pytest.raises(Rejected, match=why):
        check_text(json.dumps(data), pin)


@pytest.mark.parametrize("key", list(IDENTITY))
def test_each_key_is_needed(key: str) -> None:
    data = {k: v for k, v in IDENTITY.items() if k != key}
    rejects(data, f"lacks the key '{key}'")


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"note": "true"}, "unknown key"),
        ({"schema": "hfield-cert/2"}, "schema"),
        ({"statement": ""}, "empty"),
        ({"statement": "p*q == q*p"}, "does not hold by expanding"),
        ({"statement": "p*q"}, "expected a statement"),
        ({"statement": "p*q == g"}, "means nothing"),
        ({"verdict": "refuted"}, "does not show that the statement is refuted"),
        ({"verdict": "vacuous"}, "does not show"),
        ({"verdict": "true"}, "verdict"),
        ({"method": "magic"}, "not that of the evidence"),
        ({"assumes": ["0 == 1"]}, "does not list exactly"),
        ({"field": "GF(3)"}, "not over the field"),
        ({"field": "GF(6)", "algebra": "(-1,-1|GF(6))"}, "no power of a prime"),
        ({"field": "GF(9, x^2-1)", "algebra": "(-1,-1|GF(9, x^2-1))"}, "reducible"),
        ({"field": "QQ(sqrt(8))", "algebra": "(-1,-1|QQ(sqrt(8)))"}, "squarefree"),
        ({"field": "RDF", "algebra": "(-1,-1|RDF)"}, "nothing is proved over floats"),
        ({"field": "QQQ", "algebra": "(-1,-1|QQQ)"}, "no ring"),
        ({"algebra": "(-1,-1|GF(3))"}, "not over the field"),
        ({"algebra": "-1,-1"}, "cannot be read"),
        ({"evidence": {}}, "kind"),
        ({"evidence": {"kind": "identity", "because": "clear"}}, "unknown key"),
        ({"evidence": {"kind": "trust"}}, "does not show"),
        ({"evidence": {"kind": "exhaustion", "cases": 10}}, "finite ring"),
    ],
)
def test_changed_certificates(changes: dict[str, Any], why: str) -> None:
    assert check(IDENTITY)
    rejects(with_(**changes), why)


def test_a_witness_must_refute() -> None:
    good = with_(
        statement="p*q == q*p",
        verdict="refuted",
        evidence={"kind": "witness", "field": "QQ", "values": WITNESS},
    )
    assert check(good)
    for values, why in (
        ({**WITNESS, "q": WITNESS["p"]}, "is true"),
        ({"p": WITNESS["p"]}, "lacks"),
        ({**WITNESS, "r": WITNESS["p"]}, "unknown key"),
        ({**WITNESS, "q": ["0", "0", "1"]}, "coordinates"),
        ({**WITNESS, "q": ["0", "0", "sqrt(2)", "0"]}, "no element"),
    ):
        rejects({**good, "evidence": {**good["evidence"], "values": values}}, why)
    other = {**good["evidence"], "field": "GF(3)"}
    rejects({**good, "evidence": other}, "not that of the certificate")
    over_gf_2 = {"algebra": "(-1,-1|GF(2))", "field": "GF(2)"}
    rejects({**good, **over_gf_2, "evidence": {**other, "field": "GF(2)"}}, "is true")


def test_a_proof_of_something_weaker_is_no_proof() -> None:
    data = decided("norm(q) == 0 => q == 0", "QQ")
    weaker = decided("norm(q) == 0 => q[0] == 0", "QQ")
    rejects({**data, "evidence": weaker["evidence"]}, "not covered")
    general = decided("norm(p) == 0 => norm(p*q) == 0", "QQ")
    rejects({**general, "statement": "norm(p*q) == 0"}, "not covered")


def test_each_item_is_needed_and_multiplied_out() -> None:
    data = decided("p*q == 0 => p == 0 or q == 0", "QQ")
    items = data["evidence"]["items"]
    for n in range(len(items)):
        fewer = {**data["evidence"], "items": items[:n] + items[n + 1 :]}
        rejects({**data, "evidence": fewer}, "not covered")
    spoilt = copy.deepcopy(data)
    step = spoilt["evidence"]["items"][0]["steps"][0]
    step["cofactors"] = ["1" if c == "0" else c for c in step["cofactors"]]
    rejects(spoilt, "cofactors")
    rejects({**data, "evidence": {**data["evidence"], "facts": []}}, "fact")


def test_facts_are_verified() -> None:
    data = decided("norm(q) == 0 => q == 0", "QQ")
    for field in ("QQ(I)", "CC", "QQ(sqrt(-3))", "GF(3)", "QQ(sqrt(-5))"):
        moved = {**data, "field": field, "algebra": f"(-1,-1|{field})"}
        rejects(moved, "ordering|0 only at 0|does not list|is 0 at an element")
    ramified = decided("norm(q) == 0 => q == 0", "QQ", "(2,3|QQ)")
    split = {**ramified, "algebra": "(2,7|QQ)"}  # 2·1² + 7·1² = 3²
    rejects(split, "the polynomial of u has a root|valuation")


def test_denominators_may_not_vanish() -> None:
    data = decided("2*s == 0 => s == 0", "QQ")
    assert check(data)
    rejects({**data, "field": None, "algebra": "(-1,-1|F)"}, "divides by a number|not covered")
    rejects({**data, "field": "GF(2)", "algebra": "(-1,-1|GF(2))"}, "denominator is 0|not covered")


def test_exhaustion_is_repeated() -> None:
    data = decided("s**2 == 2 or s**2 == 3 or s**2 != 0 or s == 0", "GF(5)")
    cases = {**data, "method": "exhaustion", "evidence": {"kind": "exhaustion", "cases": 5}}
    assert check(cases)
    rejects({**cases, "statement": "s**2 == 2 or s**2 == 1 or s == 0"}, "false in one of the cases")
    rejects({**cases, "evidence": {"kind": "exhaustion", "cases": 4}}, "number of cases")


def test_terms_must_be_defined() -> None:
    # 1/s is not defined at s = 0, where "not (1/s == 1)" is true: that makes no y exist.
    evidence = {"kind": "terms", "terms": {"y": "1/s"}, "proof": {"kind": "identity"}}
    for conclusion in ("not (y == s*y + 1 + y - s*y - y)", "y*s == 1 => y == 1/s"):
        data = with_(statement=f"exists y: {conclusion}", evidence=evidence)
        rejects(data, "does not hold by expanding")
    data = with_(statement="s*s == 1 => (exists y: not (y != s))", evidence=evidence)
    rejects(data, "does not hold by expanding")


def test_presentations() -> None:
    from hfield.ledger.presented import Presented

    found = Presented(("i*j == k", "j*k == i"))
    decision = found.decide(None)
    data = with_(
        statement=found.statement,
        algebra="(-1,-1|F)",
        field=None,
        method="presentation",
        evidence=decision.evidence,
    )
    assert check(data)
    rejects(
        {**data, "statement": found.statement.replace("i, j", "e, i, j", 1)}, "e is the identity"
    )
    rejects({**data, "statement": found.statement.replace("=> i*j == k", "=> j*i == k")}, "goals")
    spoilt = copy.deepcopy(data)
    spoilt["evidence"]["proofs"][0]["cofactors"].pop()
    rejects(spoilt, "not the goal")
    spoilt = copy.deepcopy(data)
    spoilt["evidence"]["proofs"].pop()
    rejects(spoilt, "as many proofs")


def test_lists_of_tuples_must_be_complete() -> None:
    basis = dict(zip("eijk", H(QQ).basis, strict=True))
    tuples = [
        [x + y + z, [int(c) for c in (basis[x] * basis[y] * basis[z]).coordinates]]
        for x, y, z in product("eijk", repeat=3)
    ]
    evidence = {"kind": "multilinear", "unknowns": ["p", "q", "r"], "tuples": tuples}
    data = with_(method="multilinear", evidence=evidence)
    assert check(data)
    for n in (0, 17, 63):
        spoilt = copy.deepcopy(data)
        del spoilt["evidence"]["tuples"][n]
        rejects(spoilt, "not complete")
        doubled = copy.deepcopy(data)
        doubled["evidence"]["tuples"][n] = doubled["evidence"]["tuples"][n - 1]
        rejects(doubled, "twice")
        wrong = copy.deepcopy(data)
        wrong["evidence"]["tuples"][n][1][0] += 1
        rejects(wrong, "not what the list says")
    rejects({**data, "statement": "(p*q)*r*p == p*(q*r)*p"}, "not linear")


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "null",
        "{",
        '{"schema": NaN}',
        '{"schema": 1e400}',
        '{"schema": "a", "schema": "b"}',
        "[" * 100_000,
        '{"a":' * 5_000 + "1" + "}" * 5_000,
        json.dumps(with_(evidence={"kind": "exhaustion", "cases": 1})).replace(
            "1}", "1" * 9_000 + "}"
        ),
        json.dumps(with_(statement="(" * 5_000 + "q" + ")" * 5_000 + " == q")),
        json.dumps(with_(statement="(q**9999)**9999 == q")),
        json.dumps(with_(statement="((p*q*r*u*v*w)**30)**30 == 0")),
        json.dumps(with_(statement=" and ".join(["(p == q <=> q == p)"] * 200))),
        json.dumps(with_(statement=f"q == {'9' * 5_000}")),
        json.dumps(with_(field=f"GF({2**521 - 1})", algebra=f"(-1,-1|GF({2**521 - 1}))")),
    ],
)
def test_hostile_files(text: str) -> None:
    with pytest.raises(Rejected):
        check_text(text)


def test_random_bytes_and_wrong_types() -> None:
    rng = random.Random(5)
    values = [None, True, -1, 10**30, "", "q", [], [[]], {}, {"kind": []}, ["9" * 4_001]]
    data = decided("p*q == 0 => p == 0 or q == 0", "QQ")
    for _ in range(300):
        spoilt = copy.deepcopy(data)
        spoilt[rng.choice(list(data))] = rng.choice(values)
        item = rng.choice(data["evidence"]["items"])
        items = [{**item, rng.choice(list(item)): rng.choice(values)}]
        for evil in (spoilt, {**data, "evidence": {**data["evidence"], "items": items}}):
            if evil == data:
                continue
            with pytest.raises(Rejected):
                check_text(json.dumps(evil))


def test_pins() -> None:
    data = decided("(p*q)*r == p*(q*r)", "QQ")
    statement = data["statement"]
    rejects(data, "another statement", Pin(("p*(q*r) == (p*q)*r",), "QQ"))
    rejects(data, "not about GF", Pin((statement,), "GF(3)"))
    rejects(data, "not about all fields", Pin((statement,)))
    other = decided(statement, "QQ", "(-1,-3|QQ)")
    rejects(other, "algebra", Pin((statement,), "QQ"))
    assert check(other, Pin((statement,), "QQ", "(-1,-3|QQ)"))
    everywhere = decided(statement, None)
    rejects(everywhere, "about all fields, not about QQ", Pin((statement,), "QQ"))
