"""What does not establish its statement is rejected, and says why."""

import copy
import json
import random
from itertools import product
from typing import Any

import pytest

from hfield import QQ, H
from hfield.checker.check import ExpectedClaim, check, check_text
from hfield.checker.rejection import Rejected
from tests.checker.cases import Certificate, about_field, decided
from tests.checker.ring_data import QQ as QQ_DATA
from tests.checker.ring_data import (
    RDF,
    Data,
    completion,
    cyclotomic,
    data_of,
    finite,
    functions,
    generated,
    multiquadratic,
    polynomials,
    quadratic,
    residues,
    root_field,
)
from tests.subcases import subcases
from tests.thorough import cases

IDENTITY = {
    "schema": "hfield-cert/2",
    "statement": "(p*q)*r == p*(q*r)",
    "algebra": "(-1,-1|QQ)",
    "field": "QQ",
    "ring": {"kind": "rationals"},
    "verdict": "proved",
    "method": "identity",
    "assumes": [],
    "evidence": {"kind": "identity"},
}
WITNESS = {"p": ["0", "1", "0", "0"], "q": ["0", "0", "1", "0"]}


def nested(depth: int) -> Data:
    ring: Data = RDF
    for _ in range(depth):
        ring = completion(ring, {})
    return ring


LARGE: list[Data] = [
    *(finite(2**521 - 1), finite(2, 600), finite(2, 65), finite(2, 3, [1] * 30_000)),
    *(
        residues(10**3999),
        quadratic(2 * 10**9 + 14),
        quadratic(-(10**3999)),
        multiquadratic(*range(2, 99)),
    ),
    *(root_field(2, 41), cyclotomic(401), cyclotomic(10**9), generated([1] * 60)),
    *(generated([*[10**3000] * 5, 1]), functions(QQ_DATA, "x" * 101), nested(100)),
    *(polynomials(QQ_DATA, *(f"x{n}" for n in range(65))), nested(3)),
]


def over(ring: Data) -> Certificate:
    """Return the keys of a certificate that say its field."""
    data = about_field({}, ring)
    return {key: data[key] for key in ("field", "ring", "algebra")}


def with_(**changes: Any) -> Certificate:
    return {**copy.deepcopy(IDENTITY), **changes}


def rejects(data: Certificate, why: str, expected: ExpectedClaim | None = None) -> None:
    with pytest.raises(Rejected, match=why):
        check_text(json.dumps(data), expected)


@pytest.mark.parametrize("key", list(IDENTITY))
def test_each_key_is_needed(key: str) -> None:
    data = {k: v for k, v in IDENTITY.items() if k != key}
    rejects(data, "the schema must be" if key == "schema" else f"lacks the key '{key}'")


@subcases(
    ("changes", "why"),
    [
        ({"note": "true"}, "unknown key"),
        *(({"schema": name}, "schema") for name in ("hfield-cert/3", "hfield-cert", 2, None, [])),
        ({"statement": ""}, "empty"),
        ({"statement": "p*q == q*p"}, "does not hold by expanding"),
        ({"statement": "p*q"}, "expected a statement"),
        ({"statement": "p*q == g"}, "means nothing"),
        ({"verdict": "refuted"}, "does not show that the statement is refuted"),
        ({"verdict": "vacuous"}, "does not show"),
        ({"verdict": "true"}, "verdict"),
        ({"method": "magic"}, "not that of the evidence"),
        ({"assumes": ["0 == 1"]}, "does not list exactly"),
        ({"field": "GF(3)"}, "the data say QQ, and not 'GF"),
        ({"field": "GF(3)", "algebra": "(-1,-1|GF(3))"}, "the data say QQ, and not 'GF"),
        ({"field": None, "algebra": "(-1,-1|F)"}, "the data say QQ, and not 'None'"),
        ({"ring": None}, "the data say all fields, and not 'QQ'"),
        ({"ring": finite(3)}, "the data say GF.3., and not 'QQ'"),
        ({"ring": finite(3), "field": "GF(3)"}, "none over GF.3."),
        ({"ring": "QQ"}, "the data of a ring must be an object"),
        ({"ring": {"kind": "QQ"}}, "rings of the kind 'QQ' are not known here"),
        ({"ring": {**QQ_DATA, "n": 2}}, "unknown key"),
        (over(finite(6)), "not a prime number"),
        (over(finite(3, 2, [2, 0, 1])), "reducible"),
        (over(quadratic(8)), "squarefree"),
        (over(RDF), "nothing is proved over floats"),
        ({"algebra": "(-1,-1|GF(3))"}, "none over QQ"),
        ({"algebra": "-1,-1"}, "none over QQ"),
        ({"algebra": "(-1|QQ)"}, "cannot be read"),
        ({"evidence": {}}, "kind"),
        ({"evidence": {"kind": "identity", "because": "clear"}}, "unknown key"),
        ({"evidence": {"kind": "trust"}}, "does not show"),
        ({"evidence": {"kind": "exhaustion", "cases": 10}}, "finite ring"),
    ],
)
def test_changed_certificates(changes: dict[str, Any], why: str) -> None:
    assert check(IDENTITY)
    rejects(with_(**changes), why)


@pytest.mark.parametrize("number", [f"{7 * 10**3000}/{10**2999 + 1}", "1e9999"])
def test_a_number_that_is_too_long_for_a_message(number: str) -> None:
    text = f"s == sqrt({number})"
    why = "bits is not taken apart|too long to be shown is not taken"
    rejects(with_(**over({"kind": "reals"}), statement=text), why)


@pytest.mark.parametrize("name", ["zeta5", "zeta_8"])
@pytest.mark.parametrize("base", [QQ_DATA, {"kind": "integers"}])
def test_polynomials_in_a_root_of_unity_read_as_the_ring_that_it_generates(
    base: Data, name: str
) -> None:
    for ring in (polynomials(base, name), polynomials(base, "x", name)):
        with pytest.raises(Rejected, match=f"reads as the ring that the number {name} generates"):
            check({**IDENTITY, "ring": ring})
    functions_of_it = over(functions(QQ_DATA, name))
    assert check(with_(**functions_of_it)).field == f"Frac(QQ[{name}])"


@pytest.mark.parametrize(
    ("ring", "description"),
    [
        (polynomials({"kind": "integers"}, "sqrt2"), "ZZ[sqrt2], the polynomials in sqrt2 over ℤ"),
        (
            functions(QQ_DATA, "zeta5"),
            "Frac(QQ[zeta5]), the rational functions in zeta5 over ℚ",
        ),
    ],
)
def test_the_ring_that_a_statement_names_is_described(ring: Data, description: str) -> None:
    name, variable = description.split(",")[0], ring["variables"][0]
    evidence = {"kind": "witness", "ring": ring, "values": {}}
    said = f"over{{{name}; {variable}**10 == {variable}**5}}"
    for statement, part in ((said, evidence), (f"every{{{said}; 1 == 1}}", None)):
        shown: Data = part or {"kind": "part", "part": 0, "evidence": evidence}
        wrapped = {"kind": "rings", "rings": [ring], "evidence": shown}
        nowhere = with_(field=None, ring=None, algebra="(-1,-1|F)", verdict="refuted")
        found = check({**nowhere, "statement": statement, "evidence": wrapped})
        assert f"names the ring: {description}" in found.lines()


def test_a_witness_must_refute() -> None:
    good = with_(
        statement="p*q == q*p",
        verdict="refuted",
        evidence={"kind": "witness", "ring": data_of("QQ"), "values": WITNESS},
    )
    assert check(good)
    for values, why in (
        ({**WITNESS, "q": WITNESS["p"]}, "is true"),
        ({"p": WITNESS["p"]}, "lacks"),
        ({**WITNESS, "r": WITNESS["p"]}, "unknown key"),
        ({**WITNESS, "q": ["0", "0", "1"]}, "coordinates"),
        ({**WITNESS, "q": ["0", "0", "sqrt(2)", "0"]}, "not an element"),
    ):
        rejects({**good, "evidence": {**good["evidence"], "values": values}}, why)
    other = {**good["evidence"], "ring": finite(3)}
    rejects({**good, "evidence": other}, "not that of the certificate")
    rejects({**about_field(good, "GF(2)"), "evidence": {**other, "ring": finite(2)}}, "is true")


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
        moved = about_field(data, field)
        rejects(moved, "ordering|0 only at 0|does not list|is 0 at an element")
    ramified = decided("norm(q) == 0 => q == 0", "QQ", "(2,3|QQ)")
    split = {**ramified, "algebra": "(2,7|QQ)"}  # 2·1² + 7·1² = 3²
    rejects(split, "the polynomial of u has a root|valuation")


def test_denominators_may_not_vanish() -> None:
    data = decided("2*s == 0 => s == 0", "QQ")
    assert check(data)
    rejects(about_field(data, None), "divides by a number|not covered")
    rejects(about_field(data, "GF(2)"), "denominator is 0|not covered")


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
    from hfield.ledger.propositions import Presented

    found = Presented(("i*j == k", "j*k == i"))
    decision = found.decide(None)
    data = with_(
        statement=found.statement,
        algebra="(-1,-1|F)",
        field=None,
        ring=None,
        method="presentation",
        evidence=decision.evidence.to_json(),
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


@pytest.mark.slow
@subcases(
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
        *(json.dumps(with_(ring=ring)) for ring in LARGE),
    ],
)
def test_hostile_files(text: str) -> None:
    with pytest.raises(Rejected):
        check_text(text)


def test_random_bytes_and_wrong_types() -> None:
    rng = random.Random(5)
    values = [None, True, -1, 10**30, "", "q", [], [[]], {}, {"kind": []}, ["9" * 4_001]]
    data = decided("p*q == 0 => p == 0 or q == 0", "QQ")
    for _ in range(cases(500)):
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
    rejects(data, "another statement", ExpectedClaim(("p*(q*r) == (p*q)*r",), "QQ"))
    rejects(data, "not about GF", ExpectedClaim((statement,), "GF(3)"))
    rejects(data, "not about all fields", ExpectedClaim((statement,)))
    other = decided(statement, "QQ", "(-1,-3|QQ)")
    rejects(other, "algebra", ExpectedClaim((statement,), "QQ"))
    assert check(other, ExpectedClaim((statement,), "QQ", "(-1,-3|QQ)"))
    everywhere = decided(statement, None)
    rejects(everywhere, "about all fields, not about QQ", ExpectedClaim((statement,), "QQ"))
