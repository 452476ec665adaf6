"""Certificates forged by understanding the checker; every one of them has to be rejected."""

import json
from typing import Any

import pytest

from hfield.checker.check import ExpectedClaim, check, check_text
from hfield.checker.rejection import Rejected
from tests.checker.cases import Certificate, about_field, certified, decided
from tests.checker.ring_data import (
    QQ,
    RR,
    data_of,
    finite,
    functions,
    generated,
    polynomials,
    quadratic,
)
from tests.subcases import subcases

IDENTITY = {"kind": "identity"}
NO_FACTS: dict[str, Any] = {"kind": "implication", "facts": []}


def rejects(data: Certificate, why: str, expected: ExpectedClaim | None = None) -> None:
    with pytest.raises(Rejected, match=why):
        check_text(json.dumps(data), expected)


def excluded(nonzero: str, cofactor: str, zero: tuple[str, ...] = ()) -> dict[str, Any]:
    """An item that claims: ``nonzero`` is 0, since cofactor·(1 − T1·nonzero) = 1."""
    step = {
        "step": "contradiction",
        "cofactors": [*("0" for _ in zero), cofactor],
        "denominator": 1,
    }
    return {
        "characteristic": 0,
        "zero": list(zero),
        "relations": [],
        "nonzero": [nonzero],
        "steps": [step],
    }


@subcases(
    ("statement", "field", "nonzero"),
    [
        ("s == s + 1", "ZZ", "1"),
        ("s == s + 1", None, "1"),
        ("q == 0", "GF(3)", "q[0]"),
        ("p*q == q*p", "QQ", "p[1]*q[2] - p[2]*q[1]"),
        ("s == 1", None, "s - 1"),
    ],
)
@subcases("times", [1, 255, 256, 257, 512])
def test_exponents_do_not_carry(
    statement: str, field: str | None, nonzero: str, times: int
) -> None:
    for variable in ("s", "T1", "q[3]"):
        carry = "*".join([f"{variable}**65536"] * times)
        for cofactor in (carry, f"1 - {carry}", f"1 + {carry}", f"{carry} - T1"):
            items = [excluded(nonzero, cofactor)]
            evidence = {**NO_FACTS, "items": items}
            rejects(certified(statement, field, "implication", evidence), ".")


@pytest.mark.slow
def test_a_mask_hides_no_degree() -> None:
    power = "((s*(s**16 + t))**256)**256"
    for text in (f"{power}*{power} == 0", f"({power} + t)**257 == t", "(s**65536 + t)**256 == t"):
        rejects(certified(text, None, "identity", IDENTITY), ".")


@subcases(
    ("algebra", "field", "statement"),
    [
        ("(1/0,-1|QQ)", "QQ", "1 == 2"),
        ("(1/0,-1|QQ)", "QQ", "q == q"),
        ("(-1,1/0|F)", None, "1 == 2"),
        ("(1/(a-a),-1|F)", None, "i*i == 0"),
        ("(1/(a**3-a),-1|GF(3))", "GF(3)", "1 == 2"),
        ("(1/(a**3-a),b|GF(3))", "GF(3)", "1 == 2"),
        ("(1/3,-1|GF(3))", "GF(3)", "q == q"),
        ("(1/(x**2+x+1),-1|GF(4))", "GF(4)", "q == 0"),
        ("[1,1/0|F)", None, "q == 0"),
        ("[1,1,1/0|F)", None, "q == 0"),
        ("(0**(-1),-1|QQ)", "QQ", "q == 0"),
        ("(1/2,-1|ZZ/4)", "ZZ/4", "0 == 1"),
        ("(1/(2*a),-1|ZZ/4)", "ZZ/4", "0 == 1"),
        ("(1/2,-1|ZZ)", "ZZ", "q == q"),
        ("(0.5,-1|GF(2))", "GF(2)", "0 == 1"),
        ("(1/(I**2+1),-1|QQ(I))", "QQ(I)", "0 == 1"),
    ],
)
def test_constants_that_exist_nowhere(algebra: str, field: str | None, statement: str) -> None:
    size = {"GF(3)": 3, "GF(4)": 4, "ZZ/4": 4, "GF(2)": 2}.get(field or "", 1)
    for evidence, method in (
        (IDENTITY, "identity"),
        ({**NO_FACTS, "items": []}, "implication"),
        *(({"kind": "exhaustion", "cases": size**n}, "exhaustion") for n in range(6)),
    ):
        rejects(certified(statement, field, method, evidence, algebra), ".")
        vacuous = {"kind": "unsatisfiable", "proof": evidence}
        data = certified(f"{statement} => 1 == 2", field, method, vacuous, algebra)
        rejects({**data, "verdict": "vacuous"}, ".")
    values = {
        name: ["0"] * (4 if name == "q" else 1) for name in "qab" if name in statement + algebra
    }
    for verdict in ("proved", "refuted"):
        witness = {"kind": "witness", "ring": data_of(field or "QQ"), "values": values}
        data = certified(statement, field, "counterexample", witness, algebra)
        rejects({**data, "verdict": verdict}, ".")


def test_constants_are_hypotheses_where_they_are_defined() -> None:
    items = {**NO_FACTS, "items": []}
    good = certified("a != 0", "QQ", "implication", items, "(1/a,-1|QQ)")
    assert check(good).verdict == "proved"
    rejects({**good, "algebra": "(a,-1|QQ)"}, "not covered")
    forged = certified("a == 0 => i*i == 0", "GF(3)", "identity", IDENTITY, "(1/a,1|GF(3))")
    unsatisfiable = {"kind": "unsatisfiable", "proof": items}
    assert check(
        {**forged, "verdict": "vacuous", "method": "implication", "evidence": unsatisfiable}
    )
    cases = {"kind": "exhaustion", "cases": 3}
    vacuous = {"kind": "unsatisfiable", "proof": cases}
    assert check({**forged, "verdict": "vacuous", "method": "exhaustion", "evidence": vacuous})
    at_zero = {"kind": "witness", "ring": data_of("QQ"), "values": {"a": ["0"]}}
    rejects({**good, "verdict": "refuted", "method": "witness", "evidence": at_zero}, "not defined")
    scope = check(certified("1 == 1", None, "identity", IDENTITY, "(1/2,-1|F)")).scope
    assert scope == "fields"


def test_what_exists_binds_is_no_generator() -> None:
    """Over QQ(x) the letter x is the generator, so "not x == 2" is true; that refutes nothing."""
    proof = {"kind": "implication", "facts": [], "items": []}
    for inner in (IDENTITY, proof):
        evidence = {"kind": "none exists", "ring": data_of("QQ(x)"), "proof": inner}
        data = certified("exists x: x == 2", None, "identity", evidence)
        rejects({**data, "verdict": "refuted", "method": "implication"}, "means an element")
    place = {"kind": "place", "ring": data_of("QQ(x)"), "values": {"y": ["0"]}}
    place["proof"] = {"kind": "none exists", "proof": proof}
    data = certified("exists x: x == y", None, "implication", place)
    rejects({**data, "verdict": "refuted"}, "means an element")
    both = {
        "left": {"verdict": "proved", "evidence": proof},
        "right": {
            "verdict": "refuted",
            "evidence": {"kind": "witness", "ring": data_of("QQ(x)"), "values": {}},
        },
    }
    evidence = {"kind": "over", "ring": data_of("QQ(x)"), "evidence": {"kind": "both", **both}}
    data = certified("implies{x != 2; 1 == 2}", None, "implication", evidence)
    rejects({**data, "verdict": "refuted"}, "means an element")


@pytest.mark.parametrize(
    ("said", "field"), [("sqrt(2)**2 == 3", "QQ(sqrt(2))"), ("x1 == 0", "QQ(x1)"), ("I == 1", "CC")]
)
def test_what_means_nothing_over_all_fields_fails_nowhere(said: str, field: str) -> None:
    """A number of one field is none of the others: nothing has been said of all of them."""
    witness = {"kind": "witness", "ring": data_of(field), "values": {}}
    evidence = {"kind": "over", "ring": data_of(field), "evidence": witness}
    for whole in (f"not-everywhere{{{said}}}", f"not-everywhere{{every{{s == s; {said}}}}}"):
        inside = {"kind": "part", "part": 1, "evidence": witness} if "every" in whole else witness
        rejects(certified(whole, None, "witness", {**evidence, "evidence": inside}), ".")
    here = certified(f"over{{{field}; {said}}}", None, "identity", witness)
    assert check({**here, "verdict": "refuted"}).verdict == "refuted"


def test_fields_that_are_none() -> None:
    witness = {"kind": "witness", "values": {"s": ["2"]}}
    for field in ("ZZ", "ZZ/6", "ZZ[x]", "RDF"):
        there = witness | {"ring": data_of(field)}
        data = certified("s*s == s => s == 0 or s == 1", None, "witness", there)
        rejects({**data, "verdict": "refuted"}, "is not a field")
        none = {"kind": "none exists", "ring": data_of(field), "proof": IDENTITY}
        data = certified("exists s: 2*s == 1", None, "identity", none)
        rejects({**data, "verdict": "refuted"}, "is not a field")
        over = {"kind": "over", "ring": data_of(field), "evidence": {"kind": "count"}}
        data = certified("basis{1; 1,0}", None, "count", over)
        rejects({**data, "verdict": "refuted"}, ".")
    for p, why in ((1, "at least 2"), (0, "at least 2"), (6, "not a prime"), (561, "not a prime")):
        rejects(certified("1 == 1", finite(p), "identity", IDENTITY), why)
    rejects(certified("1 == 1", finite(3215031751), "identity", IDENTITY), "not a prime number")
    # a modulus with a root, two that are squares, and others of the wrong degree or characteristic
    for p, degree, modulus, why in (
        (3, 2, [2, 0, 1], "is reducible"),
        (5, 2, [1, 0, 1], "is reducible"),
        (2, 2, [0, 0, 1], "is reducible"),
        (2, 4, [1, 0, 1, 0, 1], "is reducible"),
        (3, 2, [2, 0, 0, 1], "is monic, of the degree 2"),
        (3, 2, [1, 0, 3], "is monic, of the degree 2"),
        (3, 2, [2], "is monic, of the degree 2"),
        (2, 2, [0, 1], "is monic, of the degree 2"),
    ):
        rejects(certified("1 == 1", finite(p, degree, modulus), "identity", IDENTITY), why)
    for d in (0, 1, 12, -4):
        rejects(certified("1 == 1", quadratic(d), "identity", IDENTITY), "of a squarefree number")
    rejects(certified("1 == 1", quadratic("x"), "identity", IDENTITY), "must be an integer")


def test_nothing_is_proved_over_floats() -> None:
    words = list("eijk")
    tuples = {"kind": "basis tuples", "tuples": [words]}
    for statement, evidence, method in (
        ("determined-by{all; 1}", tuples, "basis tuples"),
        ("curried-linear{1}", {"kind": "identity"}, "identity"),
        ("q == q", {"kind": "identity"}, "identity"),
        ("basis{1; 1}", {"kind": "determinant"}, "determinant"),
    ):
        assert check(certified(statement, "QQ", method, evidence))
        rejects(certified(statement, "RDF", method, evidence), "over floats")
        rejects(certified(f"over{{RDF; {statement}}}", "QQ", method, evidence), "over floats")


def test_nothing_is_refuted_over_floats_by_a_proof() -> None:
    evidence = {"kind": "none exists", "proof": IDENTITY}
    data = certified("exists s: s != s", "RDF", "identity", evidence)
    rejects({**data, "verdict": "refuted"}, "over floats")
    constant = certified("sqrt(2)**2 == 2", "RR", "identity", IDENTITY)
    assert check(constant)
    rejects({**constant, "statement": "sqrt(2) == 2"}, "does not hold")


def test_names_that_collide() -> None:
    step = {"step": "contradiction", "cofactors": ["1"], "denominator": 1}
    item = {"characteristic": 0, "zero": [], "relations": [], "nonzero": ["s"], "steps": [step]}
    evidence = {**NO_FACTS, "items": [item]}
    rejects(certified("T1*s == 0", "QQ(T1)", "implication", evidence), "same name")
    for name in ("i", "e", "and", "I", "ｓ", "sα", "sqrt", "norm", "", "x-1", "2x", "x y"):
        for ring in (functions(QQ, name), polynomials(QQ, name), generated([1, 0, 1], name)):
            rejects(certified("1 == 1", ring, "identity", IDENTITY), "cannot name a variable")
    for ring, why in (
        (functions(RR, "t"), "over QQ, a number field or a finite field"),
        (polynomials(QQ, "x", "x"), "comes twice"),
        (functions(data_of("GF(4)"), "x"), "already means an element"),
        (functions(QQ, 5), "must be a text"),
    ):
        rejects(certified("1 == 1", ring, "identity", IDENTITY), why)


@pytest.mark.parametrize(
    ("key", "values"),
    [
        ("statement", ["ｐ*q == q*p", "q == q == q", "q == q\0", "q == q;", "٣ == 3", "q == q #", "²*q == q"]),  # noqa: E501
        ("field", ["Q Q", "QQ ", " QQ", "QQ\n", "ＱＱ", "QQ(", "ZZ", "Q", "F", "GF(3)", "", " ", None, []]),
        ("algebra", ["(-1,-1|QQ", "(-1,-1|QQ )", "(-1,-1| QQ)", "(-1,-1|Q)", "(-1,-1|F)"]),
        ("algebra", ["(-1 -1|QQ)", "(1 2,-1|QQ)", "(-1,-1,0|QQ)", "[-1|QQ)", "(q,-1|QQ)"]),
    ],
)  # fmt: skip
def test_texts_that_are_nearly_read(key: str, values: list[str]) -> None:
    data = certified("q == q", "QQ", "identity", IDENTITY)
    assert check(data)
    for value in values:
        rejects({**data, key: value}, ".")


def test_methods_are_those_of_the_evidence() -> None:
    data = certified("q == q", "GF(2)", "identity", IDENTITY)
    for method in (
        "exhaustion",
        "implication",
        "Smith form",
        "",
        "identity; exhaustion",
        "identity;",
        "Identity",
    ):
        rejects({**data, "method": method}, "not that of the evidence")
    tried = {**data, "evidence": {"kind": "exhaustion", "cases": 16}}
    rejects(tried, "not that of the evidence: exhaustion")
    assert check({**tried, "method": "exhaustion"})
    for cases in (0, 1.0, True, 15, 32, -1, "16"):
        rejects(
            {**tried, "method": "exhaustion", "evidence": {"kind": "exhaustion", "cases": cases}},
            ".",
        )


def test_evidence_for_something_else() -> None:
    data = decided("p*q == 0 => p == 0 or q == 0", "QQ")
    for field in ("GF(3)", "QQ(I)", "CC", "ZZ/6", "GF(2)(t)", "QQ(sqrt(-3))"):
        rejects(about_field(data, field), ".")
    rejects({**data, "algebra": "(1,-1|QQ)"}, ".")
    rejects(about_field(data, None), ".")
    for verdict in ("refuted", "vacuous"):
        rejects({**data, "verdict": verdict}, ".")
    for statement in (
        "p*q == 0 => p == 0",
        "p*q == 0 => p == 0 and q == 0",
        "p*q == 1 => p == 0 or q == 0",
    ):
        rejects({**data, "statement": statement}, ".")


def test_an_assumption_is_not_a_theorem() -> None:
    data = certified("q == q", "QQ", "identity", IDENTITY)
    rejects({**data, "assumes": ["every number is a square in CC"]}, "exactly")
    rejects({**data, "assumes": [""]}, "exactly")


@subcases(
    "statement",
    [
        "p*q == q*p or 0 == 1",
        "s == t",
        "exists q: q*p == e",
        "not (q == q)",
        "q*inv(q) == e",
        "s/s == 1",
        "0**(-1) == 0**(-1)",
        "s != s",
        "1/s == 1/s",
    ],
)
@subcases("field", [None, "QQ", "GF(2)", "ZZ/6", "ZZ"])
def test_false_statements_and_every_plain_evidence(statement: str, field: str | None) -> None:
    if field == "GF(2)" and statement.startswith("p*q"):
        return
    proof = {**NO_FACTS, "items": []}
    kinds: list[tuple[Any, str]] = [(IDENTITY, "identity"), (proof, "implication")]
    kinds += [({"kind": "exhaustion", "cases": n}, "exhaustion") for n in (1, 2, 6, 16, 256, 1296)]
    for evidence, method in list(kinds):
        kinds.append(({"kind": "terms", "terms": {"q": "inv(p)"}, "proof": evidence}, method))
        case = {"when": "p == p", "terms": {"q": "inv(p)"}, "proof": evidence}
        kinds.append(({"kind": "cases", "cases": [case], "cover": IDENTITY}, method))
    for evidence, method in kinds:
        rejects(certified(statement, field, method, evidence), ".")
