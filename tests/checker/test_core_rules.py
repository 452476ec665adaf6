"""The core of the checker, rules of a field, multilinear maps, pins."""

from typing import Any

import pytest

from hfield.checker.budget import Budget
from hfield.checker.check import ExpectedClaim, check
from hfield.checker.glossary import COMMUTATIVE_RINGS
from hfield.checker.rejection import (
    Rejected,
)
from hfield.prover.prove import prove
from tests.checker.cases import about_field, certified
from tests.checker.hand_made import IDENTITY, direct, ends, implication, opposite, rejects
from tests.checker.ring_data import data_of
from tests.subcases import subcases

# --- rules of a field ----------------------------------------------------------------------------

NORM = {"form": "norm", "by": "ordering"}
SQUARES = {"form": "squares", "by": "ordering", "most": None, "positive": True}
ROOTS = {"form": "roots", "by": "factors"}


def form_step(kind: str, terms: list[str], cofactors: list[str], **more: Any) -> dict[str, Any]:
    return {"step": kind, "terms": terms, "cofactors": cofactors, "denominator": 1, **more}


@pytest.mark.parametrize("fact", [NORM, SQUARES, ROOTS])
def test_facts_are_about_a_field_that_is_named(fact: dict[str, Any]) -> None:
    for field in (None, "ZZ", "ZZ/6", "QQ[x]"):
        data = certified("q == q", field, "implication", implication([], [fact]))
        rejects(data, "facts are about a field that is named")


def test_a_norm_that_is_0_only_at_0() -> None:
    coordinates = [f"q[{n}]" for n in range(4)]
    norm = " + ".join(f"{c}**2" for c in coordinates)
    items = [
        opposite(
            [norm],
            [c],
            [
                form_step("norm", coordinates, ["1", "0"]),
                ends("0", "1", *("T1" if m == n else "0" for m in range(4))),
            ],
        )
        for n, c in enumerate(coordinates)
    ]
    data = certified("norm(q) == 0 => q == 0", "QQ", "implication", implication(items, [NORM]))
    assert check(data)
    named = [{**NORM, "algebra": "(-1,-1|QQ)"}]
    step = {**items[0]["steps"][0], "algebra": "(-1,-1|QQ)"}
    other = [{**item, "steps": [step, item["steps"][1]]} for item in items]
    assert check({**data, "evidence": implication(other, named)})
    for items_, facts in (
        (items, []),
        (items, [NORM, NORM]),
        (items, named),
        (other, [NORM]),
        (items, [{**NORM, "by": "trust"}]),
        (items, [{**NORM, "form": "form"}]),
        (items, [{"form": "norm"}]),
        (items, ["norm"]),
        (items, [NORM] * 33),
        (other, [{**NORM, "algebra": "(-1,-1|QQ(I))"}]),
        (other, [{**NORM, "algebra": "(a,-1|QQ)"}]),
        (other, [{**NORM, "algebra": "(1/0,-1|QQ)"}]),
        (other, [{**NORM, "algebra": "(-1,1|QQ)"}]),
        (items[:3], [NORM]),
    ):
        rejects({**data, "evidence": implication(items_, facts)}, ".")
    for change in (
        {"terms": coordinates[:3]},
        {"cofactors": ["1", "1"]},
        {"denominator": 0},
        {"terms": ["q[0]"] * 4},
    ):
        bad = {**items[0], "steps": [{**items[0]["steps"][0], **change}, items[0]["steps"][1]]}
        rejects({**data, "evidence": implication([bad, *items[1:]], [NORM])}, ".")
    # a constant that the statement does not speak of
    real = about_field(data, "RR")
    assert check(real)
    for algebra in ("(-sqrt(2),-1|RR)", "(-1,-sqrt(2)|RR)"):
        foreign = implication(other, [{**NORM, "algebra": algebra}])
        rejects({**real, "evidence": foreign}, "there is no function")
    for field in (None, "ZZ", "CC", "GF(3)", "QQ(I)"):
        rejects(about_field(data, field), ".")


def test_sums_of_squares() -> None:
    steps = [
        form_step("squares", ["s", "y"], ["1", "0"], coefficients=[1, 2]),
        ends("0", "1", "T1", "0"),
    ]
    item = opposite(["s**2 + 2*y**2"], ["s"], steps)
    data = certified(
        "s**2 + 2*y**2 == 0 => s == 0", "QQ", "implication", implication([item], [SQUARES])
    )
    assert check(data)
    level = {"form": "squares", "by": "level", "most": 2, "positive": False}
    for fact in (
        level,
        {**level, "positive": True},
        {**SQUARES, "most": 1},
        {**SQUARES, "positive": False},
        {**SQUARES, "positive": 1},
        {**SQUARES, "by": "trust"},
        {**SQUARES, "most": 0},
    ):
        rejects({**data, "evidence": implication([item], [fact])}, ".")
    rejects({**data, "evidence": implication([item], [SQUARES, SQUARES])}, "twice")
    plain = [
        form_step("squares", ["s", "y"], ["1", "0"], coefficients=[1, 1]),
        ends("0", "1", "T1", "0"),
    ]
    plain_item = opposite(["s**2 + y**2"], ["s"], plain)
    two = certified(
        "s**2 + y**2 == 0 => s == 0", "GF(3)", "implication", implication([plain_item], [level])
    )
    assert check(two)
    for field in ("GF(5)", "QQ(I)", "CC", "GF(2)"):
        rejects(about_field(two, field), ".")
    three = implication([plain_item], [{**level, "most": 3}])
    rejects({**two, "evidence": three}, "may be 0")
    for coefficients in ([1], [0, 1], [1, -1], [1, 1, 1]):
        bad = [{**plain[0], "coefficients": coefficients}, plain[1]]
        evidence = implication([opposite(["s**2 + y**2"], ["s"], bad)], [level])
        rejects({**two, "evidence": evidence}, ".")


def test_forms_and_polynomials_without_roots() -> None:
    steps = [
        form_step("binary form", ["s", "y"], ["1", "0"], coefficients=["-2", "0", "1"]),
        ends("0", "1", "T1", "0"),
    ]
    item = opposite(["s**2 - 2*y**2"], ["s"], steps)
    data = certified("s**2 == 2*y**2 => s == 0", "QQ", "implication", implication([item], [ROOTS]))
    assert check(data)
    by_squares = implication([item], [{**ROOTS, "by": "squares"}])
    rejects({**data, "evidence": by_squares}, "decided by factors")
    for field in ("GF(5)", "GF(7)", "RR", "GF(2)", "QQ(sqrt(2))", "QQ(x)"):
        moved = about_field(data, field)
        rejects(moved, "decided by squares")
        if field in ("GF(5)", "QQ(x)"):
            assert check({**moved, "evidence": by_squares})
        else:
            rejects({**moved, "evidence": by_squares}, "may have one|is 0")
    rejects({**data, "evidence": implication([item])}, "not there")
    for change in (
        {"terms": ["s"]},
        {"coefficients": ["1", "1"]},
        {"coefficients": ["-2", "0", "0"]},
        {"coefficients": ["-4", "0", "1"]},
        {"coefficients": ["-2", "s", "1"]},
        {"coefficients": ["T1", "0", "1"]},
        {"coefficients": ["0"] * 65 + ["1"]},
    ):
        bad = opposite(["s**2 - 2*y**2"], ["s"], [{**steps[0], **change}, steps[1]])
        rejects({**data, "evidence": implication([bad], [ROOTS])}, ".")
    step = {"step": "no root", "polynomial": "s**2 - 3", "cofactors": ["1"], "denominator": 1}
    none = opposite(["s**2 - 3"], [], [step])
    data = certified("s**2 != 3", "QQ", "implication", implication([none], [ROOTS]))
    assert check(data)
    by_squares = implication([none], [{**ROOTS, "by": "squares"}])
    seven = {**about_field(data, "GF(7)"), "evidence": by_squares}
    assert check(seven)
    rejects(about_field(seven, "GF(11)"), "may have one")
    for polynomial in ("s**2 - 4", "s**2 - 3*y", "s**65 - 3", "3", "s**2 + 1"):
        bad = opposite(["s**2 - 3"], [], [{**step, "polynomial": polynomial}])
        rejects({**data, "evidence": implication([bad], [ROOTS])}, ".")
    rejects({**data, "evidence": implication([none], [{**ROOTS, "by": "trust"}])}, "by factors")
    cubic = certified("s**3 != 3", "GF(7)", "implication", {})
    bad = opposite(["s**3 - 3"], [], [{**step, "polynomial": "s**3 - 3"}])
    rejects({**cubic, "evidence": implication([bad], [{**ROOTS, "by": "squares"}])}, "may have one")


def test_too_many_choices_and_clauses() -> None:
    many = " or ".join(f"(s == {n} and y == {n})" for n in range(10))
    item = opposite(["s*y"], [f"s - {n}" for n in range(10)], [ends(*("0",) * 11)])
    rejects(certified(f"s*y == 0 => {many}", None, "implication", implication([item])), ".")
    other_place = direct(["s"], "s", ["1"], characteristic=3)
    rejects(
        certified("s == 0 => s == 0 or 1 == 0", "GF(5)", "implication", implication([other_place])),
        "another characteristic",
    )
    unknown = opposite(["s"], ["s"], [{**ends("T1", "1"), "step": "trust"}])
    rejects(
        certified("s == 0 => s == y", None, "implication", implication([unknown])), "no known kind"
    )
    composite = direct(["s"], "s", ["1"], characteristic=6)
    rejects(
        certified("s == 0 => s == 0 or 1 == 0", "QQ", "implication", implication([composite])),
        "prime",
    )
    single = opposite(["t**2"], ["t"], [ends("T1**2", "1 + T1*t")])
    text = "t*t == 0 => q == 0 or q == 1 or q == i or q == j or t == 0"
    assert check(certified(text, None, "implication", implication([single])))
    wider = text.replace(" or t == 0", " or q == k or t == 0")
    rejects(certified(wider, None, "implication", implication([single])), "too many branches")
    parts = [" and ".join(f"s != {n + 150 * m}" for n in range(150)) for m in range(8)]
    groups = " and ".join(f"({part})" for part in parts)
    rejects(certified(groups, None, "identity", IDENTITY), "too many clauses")


def test_how_far_a_verdict_reaches() -> None:
    data = certified("q == q", "QQ", "identity", IDENTITY)
    assert str(check(data)).startswith("proved over QQ\n")
    inside = certified("over{GF(2); p*q == q*p}", None, "identity", IDENTITY)
    assert check(inside).where == "as it stands"
    witness = {"kind": "witness", "ring": data_of("GF(3)"), "values": {"s": ["2"]}}
    false = certified("s == 1", None, "identity", witness)
    assert check({**false, "verdict": "refuted"}).where == "as a statement on all fields"


# --- multilinear maps, pins -------------------------------------------------------------------------


def test_multilinear_maps() -> None:
    tuples = [[x, [int(x == u) for u in "eijk"]] for x in "eijk"]
    evidence = {"kind": "multilinear", "unknowns": ["q"], "tuples": tuples}
    data = certified("vector(q) + scalar(q)*e - 0 == -(-q)", None, "multilinear", evidence)
    assert check(data).scope == COMMUTATIVE_RINGS
    for statement in (
        "q == q => q == q",
        "q != q",
        "s*q == q*s",
        "q == q + 1",
        "norm(q) == norm(q)",
        "q*q == q*q",
        "0*q/1 == q",
        "e == e",
    ):
        rejects({**data, "statement": statement}, ".")
    for bad in (
        {**evidence, "unknowns": ["p"]},
        {**evidence, "tuples": tuples[:3]},
        {**evidence, "tuples": [*tuples[:3], tuples[0]]},
        {**evidence, "tuples": [*tuples[:3], ["m", [0, 0, 0, 1]]]},
        {**evidence, "tuples": [*tuples[:3], ["k", [0, 0, 0, 1, 0]]]},
        {**evidence, "tuples": [*tuples[:3], ["k", [0, 0, 1, 1]]]},
        {**evidence, "tuples": [*tuples[:3], "k"]},
    ):
        rejects({**data, "evidence": bad}, ".")
    rejects({**data, "algebra": "(a,b|F)"}, ".")
    wide = "*".join(["(p + q)"] * 7)
    rejects(
        {**data, "statement": f"{wide} == q", "evidence": {**evidence, "unknowns": ["p", "q"]}}, "."
    )
    letters = ["p", "q", "r", "u", "v"]
    degrees = "*".join([f"({'*'.join(['(p + q + r + u + v)'] * 4)})"] * 2)  # 70 times 70
    rejects(
        {**data, "statement": f"{degrees} == p", "evidence": {**evidence, "unknowns": letters}},
        "too many degrees",
    )
    commutator = {**evidence, "tuples": [[x, [0, 0, 0, 0]] for x in "eijk"]}
    assert check(
        {**data, "statement": "comm(q, e) == conj(q)*0 + trace(q)*0", "evidence": commutator}
    )


def test_pins_of_any_field() -> None:
    data = certified("q == q", "QQ", "identity", IDENTITY)
    assert check(data, ExpectedClaim(("p == p", "q == q"), any_field=True))
    assert ExpectedClaim(("q == q",)).readable()
    with pytest.raises(Rejected):
        ExpectedClaim(("q == ",)).readable()
    with pytest.raises(Rejected, match="about QQ, not about all fields"):
        check(data, ExpectedClaim(("q == q",)))
    with pytest.raises(Rejected, match="another statement"):
        check(data, ExpectedClaim(("p == p",), any_field=True))


def test_an_unknown_of_a_pin_is_no_element_of_a_field_that_it_does_not_name() -> None:
    """Over GF(9) the x of "x*s == s" is the generator: that is no proof for all x."""
    statement = "x**2 == x + 1"
    data = certified(statement, "GF(9)", "identity", IDENTITY)
    assert check(data, ExpectedClaim((statement,), "GF(9)")).verdict == "proved"
    assert check(data, ExpectedClaim((statement,), data_of("GF(9)"))).verdict == "proved"
    with pytest.raises(Rejected, match="x is an unknown of the statement"):
        check(data, ExpectedClaim((statement,), any_field=True))
    with pytest.raises(Rejected, match=r"about GF.9., not about GF.9, x.2.1."):
        check(data, ExpectedClaim((statement,), data_of("GF(9, x^2+1)")))
    for name in ("GF(3^2)", "GF( 9)", "GF(9,x^2+2*x+2)"):
        with pytest.raises(Rejected, match="this is about GF"):
            check(data, ExpectedClaim((statement,), name))


def test_the_number_of_cases() -> None:
    """It is that of all values, or of those of the coordinates on which the clauses depend."""
    for statement, field, right in (
        ("s**3 == s", "GF(3)", (3,)),
        ("s**3 == s and q == q", "GF(3)", (3, 3**5)),
        ("s*t == t*s", "GF(2)", (1, 4)),
        ("s*s == 1 => 1/s == s", "ZZ/8", (8,)),
        ("p*q == 1 => q*p == 1", "GF(3)", (3**8,)),
    ):
        for power in range(9):
            cases = int(field.strip("GFZ/()")) ** power
            data = certified(statement, field, "exhaustion", {"kind": "exhaustion", "cases": cases})
            if cases in right:
                assert check(data)
            else:
                rejects(data, "number of cases")


REFUTED = [
    ("s*s == s", "QQ", "identity"),
    ("s*s == s and s == 1", "GF(5)", "identity"),
    ("not (s != 0 or s != 1)", "GF(5)", "identity"),
    ("s == 0 or s == 1", "QQ", "identity"),
    ("s == 0 or s == 1", "GF(5)", "counterexample"),
    ("s != 0 => s == 1", "QQ", "identity"),
    ("s != 0 => s == 1", "GF(5)", "counterexample"),
    ("s != 2", "QQ", "witness"),
    ("s != 2 or s + 1 != 3", "GF(5)", "witness"),
    ("s == 2 => s != 2", "QQ", "witness"),
    ("s == 2 => s + 1 != 3", "GF(5)", "witness"),
    ("s == 2 => not (s + 1 == 3)", "QQ", "witness"),
    ("s != 2 and s != 3", "QQ", "witness"),
    ("s != 2 and s != 3", "GF(5)", "counterexample"),
    ("s == 2 => s == 3", "QQ", "counterexample"),
    ("s == 1 <=> s == 2", "QQ", "counterexample"),
]


@subcases(("statement", "field", "method"), REFUTED)
def test_a_refutation_is_named_by_what_is_refuted(statement: str, field: str, method: str) -> None:
    answer = prove(statement, field)
    assert answer.verdict == "refuted"
    assert answer.to_json()["method"] == method
    witness = {"kind": "witness", "ring": data_of(field), "values": answer.to_json()["witness"]}
    for name in ("identity", "witness", "counterexample", "exhaustion"):
        data = {**certified(statement, field, name, witness), "verdict": "refuted"}
        if name == method:
            assert check(data)
        else:
            rejects(data, "not that of the evidence")


def test_comparing_many_clauses_with_many_items_is_work() -> None:
    clauses = [f"(s == 0 => s*t == {n}*s)" for n in range(20)]
    items = [direct(["s"], f"s*t - {n}*s", [f"t - {n}"]) for n in range(20)]
    items += [direct(["s + 1"], "s + 1", ["1"])] * 400
    data = certified(" and ".join(clauses), None, "implication", implication(items))
    assert check(data)
    assert check({**data, "evidence": implication(items[:20])}, budget=Budget(0.06))
    with pytest.raises(Rejected, match="more work"):
        check(data, budget=Budget(0.06))
