"""The core of the checker, implications: each way to cover the clauses works, all else is rejected."""

from typing import Any

from hfield.checker.check import check
from hfield.checker.glossary import COMMUTATIVE_RINGS, FIELD, FIELDS
from tests.checker.cases import about_field, certified
from tests.checker.hand_made import direct, ends, implication, opposite, rejects

# --- implications --------------------------------------------------------------------------------


def test_direct_items() -> None:
    data = certified("s*y == 1 => s*y*t == t", None, "implication", implication([]))
    item = direct(["s*y - 1"], "s*t*y - t", ["t"])
    good = {**data, "evidence": implication([item])}
    assert check(good).scope == COMMUTATIVE_RINGS
    for field in ("ZZ", "ZZ/6", "GF(2)", "QQ[x,y]", "ZZ[x]", "GF(4)"):
        if field not in ("QQ[x,y]",):
            assert check(about_field(good, field)).scope == FIELD
    for bad in (
        {**item, "cofactors": []},
        {**item, "cofactors": ["t + 1"]},
        {**item, "cofactors": ["t", "0"]},
        {**item, "denominator": 2},
        {**item, "denominator": 0},
        {**item, "zero": ["s*y"]},
        {**item, "zero": []},
        {**item, "member": "s*t"},
        {**item, "member": "0", "cofactors": ["0"]},
        {**item, "characteristic": 4},
        {**item, "characteristic": 3},
        {**item, "characteristic": -1},
        {**item, "relations": ["1"], "cofactors": ["t", "0"]},
        {**item, "steps": []},
    ):
        rejects({**data, "evidence": implication([bad])}, ".")


def test_items_of_a_characteristic_are_multiplied_out_modulo_it() -> None:
    data = certified("s*y == 1 => s*y*t == t", "GF(3)", "implication", implication([]))
    for cofactor, is_right in (("t", True), ("t + 3", True), ("t + 1", False), ("0", False)):
        item = direct(["s*y - 1"], "s*t*y - t", [cofactor], characteristic=3)
        own = {**data, "evidence": implication([item])}
        if is_right:
            assert check(own)
        else:
            rejects(own, "is not what it should be")


def test_a_hypothesis_that_is_a_contradiction() -> None:
    item = direct(["s", "s - 1"], "1", ["1", "-1"])
    data = certified("s == 0 and s == 1 => p == q", None, "implication", implication([item]))
    assert check(data).scope == COMMUTATIVE_RINGS
    twice = direct(["s", "s - 2"], "2", ["1", "-1"])
    rejects({**data, "evidence": implication([twice])}, "not covered")
    over_q = certified("s == 0 and s == 2 => p == q", "QQ", "implication", implication([twice]))
    assert check(over_q)
    rejects(about_field(over_q, "GF(2)"), "not covered")


def test_primes_that_are_divided_by_are_covered_again() -> None:
    text = "2*s == 0 => s == 0 or 2 == 0"
    zero = ["2*s"]
    once = direct(zero, "s", ["1"], d=2)
    assert check(certified(text, None, "implication", implication([once]))).scope == FIELDS
    rejects(
        certified("2*s == 0 => s == 0", None, "implication", implication([once])),
        "not covered|divides",
    )
    big = 10007
    text = f"{big}*s == 0 => s == 0 or y == {big}*t + y"
    once = direct([f"{big}*s"], "s", ["1"], d=big)
    rejects(certified(text, None, "implication", implication([once])), "divides by a number")
    own = direct([f"{big}*s"], "0", ["0"], characteristic=big)
    assert check(certified(text, None, "implication", implication([once, own]))).scope == FIELDS


def test_contradictions_and_cases() -> None:
    item = opposite(["s*y"], ["s", "y"], [ends("T1*T2", "1", "s*T1")])
    data = certified("s*y == 0 => s == 0 or y == 0", None, "implication", implication([item]))
    assert check(data).scope == FIELDS
    for field in ("ZZ", "QQ", "GF(4)", "ZZ[x]", "ZZ/7"):
        assert check(about_field(data, field))
    rejects(about_field(data, "ZZ/6"), "not covered")
    branches = [[ends("0", "1", "0", "T1")], [ends("0", "0", "1", "T2")]]
    step: dict[str, Any] = {
        "step": "cases",
        "factors": ["s", "y"],
        "powers": [1, 1],
        "branches": branches,
    }
    step |= {"cofactors": ["1", "0", "0"], "denominator": 1}
    cased = opposite(["s*y"], ["s", "y"], [step])
    assert check({**data, "evidence": implication([cased])})
    deep: Any = [ends("0")]
    for _ in range(10):
        deep = [{**step, "factors": ["s"], "powers": [1], "branches": [deep]}]
    for steps in (
        [],
        [step, step],
        [{**step, "powers": [1]}],
        [{**step, "powers": [1, 65]}],
        [{**step, "powers": [0, 1]}],
        [{**step, "branches": branches[:1]}],
        [{**step, "branches": [branches[0], []]}],
        [{**step, "factors": ["s", "1"]}],
        [{**step, "step": "trust"}],
        ["steps"],
        [ends("1", "0", "0")],
        [ends("T1*T2", "1", "s*T1"), ends("T1*T2", "1", "s*T1")],
        deep,
    ):
        bad = opposite(["s*y"], ["s", "y"], steps)
        rejects({**data, "evidence": implication([bad])}, ".")
    rejects({**data, "evidence": implication([{**item, "nonzero": ["s"]}])}, ".")
    nest: Any = [ends("T1*T2", "1", "s*T1", *("0",) * 10)]
    for n in range(10):
        own = {**step, "factors": ["s*y"], "powers": [1], "branches": [nest]}
        nest = [{**own, "cofactors": ["1", "0", "0", *("0",) * (9 - n)]}]
    rejects({**data, "evidence": implication([opposite(["s*y"], ["s", "y"], nest)])}, "too deeply")
    many = " or ".join(f"(s == {n} and y == {n})" for n in range(10))
    rejects(
        certified(f"s*y == 0 => {many}", None, "implication", implication([item])),
        "branches|not covered",
    )


def test_constants_that_are_not_0_may_be_divided_by() -> None:
    steps = [ends("T1*T2", "1", "x*T1")]
    item = opposite(["x*s"], ["x", "s"], steps)
    data = certified("x*s == 0 => s == 0", "QQ(x)", "implication", implication([item]))
    assert check(data)
    everywhere = about_field(data, None)
    rejects(everywhere, "not covered")
    related = direct(["s - x"], "s**2 + 1", ["s + x", "1"], relations=["x**2 + 1"])
    fits = certified("s == x => s**2 == -1", "GF(9, x^2+1)", "implication", implication([related]))
    assert check(fits)
    for relation in ("x**2", "s", "x - x + 1", "x**2 + 1 + s - s - 1"):
        rejects(
            {**fits, "evidence": implication([{**related, "relations": [relation]}])}, "relation"
        )
    trivial = certified(
        "s == x => s**2 == -1", "GF(9, x^2+x+2)", "implication", implication([related])
    )
    rejects(trivial, "relation")
