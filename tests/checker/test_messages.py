"""A rejection names what is wrong: each thing of a certificate, put in the wrong type or left out."""

import copy
from collections.abc import Iterator
from typing import Any

import pytest

from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from tests.checker.cases import Certificate, certified
from tests.checker.ring_data import QQ, number
from tests.subcases import subcases

IDENTITY = {"kind": "identity"}
SQUARES = {"form": "squares", "by": "ordering", "most": None, "positive": True}
ROOTS = {"form": "roots", "by": "factors"}
BINARY = {"step": "binary form", "terms": ["s", "1"], "coefficients": ["1", "0", "1"]}
END = {"step": "contradiction", "cofactors": ["0", "1", "T1"], "denominator": 1}
CASES = {
    "step": "cases",
    "cofactors": ["1", "0"],
    "denominator": 1,
    "factors": ["s"],
    "powers": [2],
    "branches": [[END]],
}
FORM = {"step": "squares", "cofactors": ["1", "0"], "denominator": 1, "terms": ["s"]}
NORM = {"form": "norm", "by": "place", "place": number(7), "u": ["0"] * 4, "j": ["0"] * 4}
ROOT = {"step": "no root", "polynomial": "s", "cofactors": ["1", "0"], "denominator": 1}


def implication(**changes: Any) -> dict[str, Any]:
    item = {"characteristic": 0, "zero": ["s**2"], "relations": [], "nonzero": ["s"]}
    item["steps"] = [CASES]
    facts = changes.pop("facts", [])
    return {"kind": "implication", "facts": facts, "items": [{**item, **changes}]}


def direct() -> dict[str, Any]:
    item = {"characteristic": 0, "zero": ["s**2"], "relations": []}
    more = {"member": "s**2", "cofactors": ["1"], "denominator": 1}
    return {"kind": "implication", "facts": [], "items": [{**item, **more}]}


def at(values: Any) -> dict[str, Any]:
    return {"kind": "witness", "ring": QQ, "values": values}


TERMS = {"kind": "terms", "terms": {"s": "t"}, "proof": IDENTITY}
CASE = {"when": "t == t", "terms": {"s": "t"}, "proof": IDENTITY}
PLACE = {"kind": "place", "values": {"t": ["2"]}, "proof": {"kind": "none exists", "proof": {}}}
THERE = {**PLACE, "ring": QQ}
BASE: dict[str, Certificate] = {
    "implication": certified("s**2 == 0 => s == 0", "QQ", "implication", implication()),
    "direct": certified("s**2 == 0 => s == 0", "QQ", "implication", direct()),
    "form": certified(
        "s**2 == 0 => s == 0",
        *("QQ", "implication"),
        implication(facts=[SQUARES], steps=[{**FORM, "coefficients": [1]}, END]),
    ),
    "binary": certified(
        "s**2 == 0 => s == 0",
        *("QQ", "implication"),
        implication(
            facts=[ROOTS],
            steps=[{**FORM, **BINARY}, END],
        ),
    ),
    "root": certified("s**2 == 0 => s == 0", "QQ", "implication", implication(steps=[ROOT])),
    "norm": certified("s**2 == 0 => s == 0", "QQ", "implication", implication(facts=[NORM])),
    "witness": {**certified("s == t", None, "identity", at({"s": ["1"], "t": ["0"]})), "verdict": "refuted"},
    "quaternion": {**certified("p == 0", "QQ", "identity", at({"p": ["1"] * 4})), "verdict": "refuted"},
    "terms": certified("exists s: s == t", "QQ", "witness", TERMS),
    "cases": certified(
        "exists s: s == t", "QQ", "witness", {"kind": "cases", "cases": [CASE], "cover": IDENTITY}
    ),
    "place": {**certified("exists s: s**2 == t", "QQ", "implication", PLACE), "verdict": "refuted"},
    "there": {**certified("exists s: s**2 == t", None, "implication", THERE), "verdict": "refuted"},
    "fractions": certified(
        "s == s", "ZZ", "identity", {"kind": "fractions", "ring": QQ, "proof": IDENTITY}
    ),
    "reduction": certified(
        "s**2 != 3", "ZZ", "exhaustion", {"kind": "reduction", "modulus": 4, "proof": IDENTITY}
    ),
    "finite": certified("s == s", "GF(4)", "identity", IDENTITY),
    "exhaustion": certified("s == s", "GF(2)", "exhaustion", {"kind": "exhaustion", "cases": 2}),
    "multilinear": certified(
        "p == p", "QQ", "multilinear", {"kind": "multilinear", "unknowns": ["p"],
     "tuples": [["e", [1, 0, 0, 0]]]}
    ),
    "parts": certified(
        "every{s == s}", "QQ", "identity", {"kind": "parts", "parts": [{"verdict": "proved",
     "evidence": IDENTITY}]}
    ),
}  # fmt: skip
ITEM = ("evidence", "items", 0)
STEP = (*ITEM, "steps", 0)
EVIDENCE = "the evidence"
# Where, whose keys must be complete under which name, and what the entries are called.
NAMED: list[tuple[str, tuple[Any, ...], str, dict[str, str]]] = [
    ("implication", (), "a certificate", {"statement": "statement must be a text",
     "algebra": "algebra must be a text", "assumes": "assumes must be a list",
     "ring": "the data of a ring must be an object", "field": "the data say QQ, and not '2.5'",
     "schema": "the schema must be"}),
    ("implication", ("ring",), "the data of a ring", {"kind": "the kind of a ring must be a text"}),
    ("finite", ("ring",), "the data of a ring", {"degree": "the degree must be an integer",
     "characteristic": "the characteristic must be an integer", "modulus": "a modulus must be a list"}),
    ("implication", ("evidence",), EVIDENCE, {"items": "items must be a list",
     "facts": "facts must be a list"}),
    ("implication", ITEM, "an item", {"zero": "zero must be a list",
     "relations": "relations must be a list", "characteristic": "a characteristic must be an integer",
     "nonzero": "nonzero must be a list", "steps": "steps must be a list"}),
    ("implication", STEP, "a step", {"cofactors": "cofactors must be a list",
     "factors": "factors must be a list", "powers": "powers must be a list",
     "branches": "branches must be a list", "denominator": "a denominator must be an integer"}),
    ("direct", ITEM, "an item", {"member": "member must be a text",
     "denominator": "a denominator must be an integer", "cofactors": "cofactors must be a list"}),
    ("form", STEP, "a step", {"terms": "terms must be a list",
     "coefficients": "coefficients must be a list"}),
    ("form", ("evidence", "facts", 0), "a fact", {"positive": "'positive' must be true or false",
     "by": "sums of squares in QQ may be 0"}),
    ("binary", STEP, "a step", {"terms": "terms must be a list",
     "coefficients": "coefficients must be a list"}),
    ("binary", (*STEP, "coefficients"), "",
     {0: "an entry of coefficients must be a text"}),  # type: ignore[dict-item]
    ("root", STEP, "a step", {"polynomial": "polynomial must be a text"}),
    ("norm", ("evidence", "facts", 0), "a fact about a norm", {"place": "a place must be an object",
     "u": "coordinates must be a list", "j": "coordinates must be a list"}),
    ("norm", ("evidence", "facts", 0, "place"), "a place", {"n": "a place must be an integer",
     "kind": "no place of the kind '2.5' is known of QQ"}),
    ("witness", ("evidence",), EVIDENCE, {"values": "the values must be an object",
     "ring": "the data of a ring must be an object"}),
    ("witness", ("evidence", "values"), "the values", {"s": "the values of s must be a list",
     "t": "the values of t must be a list"}),
    ("quaternion", ("evidence", "values"), "the values", {"p": "the values of p must be a list"}),
    ("terms", ("evidence",), EVIDENCE, {"terms": "the terms must be an object"}),
    ("terms", ("evidence", "terms"), "the terms", {"s": "the term for s must be a text"}),
    ("cases", ("evidence",), EVIDENCE, {"cases": "cases must be a list"}),
    ("cases", ("evidence", "cases", 0), "a case", {"when": "the condition of a case must be a text",
     "terms": "the terms must be an object"}),
    ("place", ("evidence",), EVIDENCE, {"values": "the values must be an object"}),
    ("there", ("evidence",), EVIDENCE, {"ring": "the data of a ring must be an object"}),
    ("place", ("evidence", "proof"), EVIDENCE, {}),
    ("fractions", ("evidence",), EVIDENCE, {"ring": "the data of a ring must be an object"}),
    ("reduction", ("evidence",), EVIDENCE, {"modulus": "the modulus must be an integer"}),
    ("exhaustion", ("evidence",), EVIDENCE, {"cases": "cases must be an integer"}),
    ("multilinear", ("evidence",), EVIDENCE, {"unknowns": "unknowns must be a list",
     "tuples": "tuples must be a list"}),
    ("multilinear", ("evidence", "tuples", 0), "",
     {1: "coordinates must be a list"}),  # type: ignore[dict-item]
    ("parts", ("evidence",), EVIDENCE, {"parts": "parts must be a list"}),
    ("parts", ("evidence", "parts", 0), "the evidence for a part", {}),
]  # fmt: skip


def place(data: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        data = data[key]
    return data


def spoilt() -> Iterator[tuple[Certificate, str]]:
    """Run through certificates with one thing wrong, and what the rejection has to begin with."""
    for name, path, parent, entries in NAMED:
        for key, said in entries.items():
            data = copy.deepcopy(BASE[name])
            place(data, path)[key] = 2.5
            yield data, said
        if parent:
            for key in place(BASE[name], path):
                if key in ("kind", "step", "form") or (key, parent) == ("schema", "a certificate"):
                    continue
                data = copy.deepcopy(BASE[name])
                del place(data, path)[key]
                if key not in ("by", "member", "positive") or parent == "a certificate":
                    yield data, f"{parent} lacks the key {key!r}"
            data = copy.deepcopy(BASE[name])
            place(data, path)["more"] = 1
            yield data, f"{parent} has an unknown key 'more'"


@subcases("n", range(len(list(spoilt()))))
def test_a_rejection_names_what_is_wrong(n: int) -> None:
    data, said = list(spoilt())[n]
    with pytest.raises(Rejected) as caught:
        check(data)
    assert str(caught.value).startswith(said)


POLYNOMIALS = [
    ("implication", (*ITEM, "zero"), "a polynomial of 'zero'"),
    ("implication", (*ITEM, "relations"), "a relation"),
    ("implication", (*ITEM, "nonzero"), "a polynomial of 'nonzero'"),
    ("implication", (*STEP, "cofactors"), "a cofactor"),
    ("implication", (*STEP, "factors"), "a factor"),
    ("direct", (*ITEM, "cofactors"), "a cofactor"),
    ("form", (*STEP, "terms"), "a term"),
]


@pytest.mark.parametrize(("name", "path", "what"), POLYNOMIALS)
def test_a_rejected_polynomial_is_named(name: str, path: tuple[Any, ...], what: str) -> None:
    for text, said in (
        ("s**", "is not a polynomial"),
        ("u[0]", "speaks of 'u[0]'"),
        ("9" * 4001, "has"),
    ):
        data = copy.deepcopy(BASE[name])
        place(data, path)[:1] = [text]
        with pytest.raises(Rejected) as caught:
            check(data)
        expected = f"a number in {what}" if said == "has" else f"{what} {said}"
        assert str(caught.value).startswith(expected)
    data = copy.deepcopy(BASE[name])
    place(data, path)[:1] = [3]
    with pytest.raises(Rejected, match="must be a text"):
        check(data)
