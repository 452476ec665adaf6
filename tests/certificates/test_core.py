"""The core of the checker: each bound, each way to read, evaluate and cover, works and rejects."""

from fractions import Fraction
from typing import Any

import pytest

from hfield.certificates import check as checking
from hfield.certificates.check import Pin, check
from hfield.certificates.clauses import expand, without_factors
from hfield.certificates.evaluate import Evaluator, Quaternion, RingScalars
from hfield.certificates.existence import MAX_CASES
from hfield.certificates.finding import Finding, together
from hfield.certificates.glossary import COMMUTATIVE_RINGS, FIELD, FIELDS
from hfield.certificates.language import parse, substitute, walk
from hfield.certificates.over_field import Place
from hfield.certificates.polynomials import add, constant, multiply, variable
from hfield.certificates.rejection import (
    Rejected,
    a_list,
    a_text,
    an_integer,
    an_object,
    kind_of,
    one_line,
    shown,
    texts,
)
from hfield.certificates.scalars.fields import read_field
from hfield.certificates.statement import HAMILTON, Setting, read_setting, read_statement
from hfield.certificates.work import Work, bounded, charge
from hfield.proving.prove import prove
from tests.certificates.cases import Certificate, certified

IDENTITY = {"kind": "identity"}


def setting(algebra: str = "(-1,-1|F)", field: str | None = None) -> Setting:
    return read_setting(algebra, field)


def implication(items: list[Any], facts: list[Any] | None = None) -> dict[str, Any]:
    return {"kind": "implication", "facts": facts or [], "items": items}


def direct(zero: list[str], member: str, cofactors: list[str], d: int = 1, **more: Any) -> Any:
    item = {"characteristic": 0, "zero": zero, "relations": [], "member": member}
    return {**item, "cofactors": cofactors, "denominator": d, **more}


def opposite(zero: list[str], nonzero: list[str], steps: list[Any], **more: Any) -> Any:
    item = {"characteristic": 0, "zero": zero, "relations": [], "nonzero": nonzero, "steps": steps}
    return {**item, **more}


def ends(*cofactors: str, d: int = 1) -> dict[str, Any]:
    return {"step": "contradiction", "cofactors": list(cofactors), "denominator": d}


def rejects(data: Certificate, why: str) -> None:
    with pytest.raises(Rejected, match=why):
        check(data)


# --- JSON values ---------------------------------------------------------------------------------


def test_json_values_of_the_wrong_kind() -> None:
    assert an_object({"a": 1, "c": 2}, "a", "it", "b c") == {"a": 1, "c": 2}
    for value, keys in (([], "a"), ({}, "a"), ({"a": 1, "d": 1}, "a"), (None, "")):
        with pytest.raises(Rejected):
            an_object(value, keys, "it")
    for call, args in (
        (a_list, ((), "it")),
        (a_list, ([1], "it", 2)),
        (a_list, ([0] * 20_001, "it")),
        (a_text, (1, "it")),
        (a_text, ("abc", "it", 2)),
        (an_integer, (True, "it")),
        (an_integer, (1.0, "it")),
        (an_integer, (Fraction(1), "it")),
        (an_integer, (1 << 16_001, "it")),
        (an_integer, (0, "it", 1)),
        (texts, (["a", 1], "it")),
        (kind_of, ({"kind": 1},)),
        (kind_of, ("kind",)),
    ):
        with pytest.raises(Rejected):
            call(*args)
    assert an_integer(5, "it", 5) == 5
    assert shown("a\0b" * 100, 10) == "a?ba?ba?b…"
    assert shown([1]) == "[1]"
    assert one_line(" a\n \u2028b\u202e ") == "a b?"


def test_work_is_bounded() -> None:
    charge(10**9)  # outside nothing is counted
    with bounded():
        charge(10_000_000)
        with pytest.raises(Rejected, match="more work"):
            charge(1)


def test_nothing_but_rejected_leaves_the_checker(monkeypatch: pytest.MonkeyPatch) -> None:
    data = certified("q == q", "QQ", "identity", IDENTITY)
    for error in (RecursionError, MemoryError, ZeroDivisionError, OverflowError):

        def fails(*_: Any, error: type[Exception] = error) -> None:
            raise error

        monkeypatch.setattr(checking, "establish_any", fails)
        rejects(data, "nests|memory|evaluated")


# --- reading -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        *("q" * 20_001 + " == q", "(" * 101 + "q" + ")" * 101 + " == q", "q == " + "+".join(["q"] * 202)),
        *("q == (exists p: p == q)", "p == not q", "q**s == q", "q**(2 == q", "q**2**2 == q", "q[0][1] == 0"),
        *("q[4] == 0", "q[0 == 0", "q**" + "9" * 4_001 + " == q", "q == " + "9" * 4_001, "q == 1e99999"),
        *("q ==", "== q", "q == q)", "exists and: q == q", "exists 2: q == q", "exists q q == q", "q = q"),
        *("comm(p == q", "p == q == r", "(p == q <=> q == p <=> p == q)", "q == $"),
        # Trees that are no statements.
        *("q", "p == q + (p == q)", "(p == q) == q", "q/p == q", "norm(p, q) == 0", "comm(p) == 0", "f(q) == 0"),  # noqa: E501
        *("exists q, q: q == p", "q == p => (exists q: q == p)", "exists e: e == 0", "exists m: q == q", "m == 0"),  # noqa: E501
        *("exists q: exists q: q == 0", "not (exists q: q == 0)", "q**10001 == 0", "1 + (exists q: q == q) == 0"),  # noqa: E501
    ],
)  # fmt: skip
def test_texts_that_are_no_statements(text: str) -> None:
    rejects(certified(text, None, "identity", IDENTITY), ".")


def test_trees() -> None:
    with pytest.raises(Rejected, match="characters"):
        parse("q" * 20_001)
    assert parse("exists p, q: -p[0]**(-2) == 1.5") == (
        "exists",
        ("p", "q"),
        ("==", ("neg", ("pow", ("index", ("name", "p"), 0), -2)), ("num", Fraction(3, 2))),
    )
    tree = parse("comm(p, q)[1] + 2*p == q")
    assert len(walk(tree)) == 10
    put = substitute(tree, {"p": ("name", "r"), "comm": ("name", "s")})
    assert put == parse("comm(r, q)[1] + 2*r == q")
    assert parse("p => q == q => r == r")[2][0] == "=>"


@pytest.mark.parametrize(
    ("algebra", "field"),
    [
        ("(norm(a),-1|F)", None),
        ("(sqrt(2),-1|F)", None),
        ("(sqrt(2),-1|QQ)", "QQ"),
        ("(a[0],-1|F)", None),
        ("(" + "+".join(["a"] * 120) + ",-1|F)", None),
        ("(aa,-1|F)", None),
        ("(e,-1|F)", None),
        ("(A,-1|F)", None),
        ("(a,b,c|F)", None),
        ("[a|F)", None),
        ("(a,b|QQ)", None),
        ("(a,b|F)x", None),
        ("(a == b,1|F)", None),
    ],
)
def test_algebras_that_are_none(algebra: str, field: str | None) -> None:
    with pytest.raises(Rejected):
        read_setting(algebra, field)


def test_an_algebra_with_three_constants() -> None:
    here = setting("[a, b, s + 1|F)")
    assert here.letters == ("a", "s", "b")
    statement = read_statement("i*i == a + (s + 1)*i and j*j == b and k*i == -a*j", here)
    assert statement.unknowns == (("a", "s"), ("s", "s"), ("b", "s"))
    assert (
        check(certified("i*i == a + (s+1)*i", None, "identity", IDENTITY, "[a,b,s+1|F)")).scope
        == COMMUTATIVE_RINGS
    )
    assert (
        check(certified("k*k == -a*b", None, "identity", IDENTITY, "[a,b|F)")).verdict == "proved"
    )


# --- evaluation ----------------------------------------------------------------------------------


def test_evaluation_over_a_ring() -> None:
    ring = read_field("ZZ/6")
    evaluator = Evaluator(RingScalars(ring), HAMILTON, {("name", "q"): Quaternion((1, 2, 3, 4))})

    def value(text: str) -> Any:
        evaluator.needed = ()
        found, conditions = evaluator.value(parse(text)), evaluator.needed
        return (tuple(found) if isinstance(found, Quaternion) else found), len(conditions)

    assert value("norm(q) + trace(q) + scalar(q)") == ((0 + 2 + 1) % 6, 0)
    assert value("vector(q)") == ((0, 2, 3, 4), 0)
    assert value("conj(q)") == ((1, 4, 3, 2), 0)
    assert value("comm(i, j)") == ((0, 0, 0, 2), 0)
    assert value("q*2 - 2*q + 5/5") == ((1, 0, 0, 0), 0)
    assert value("q**0 + q[1]") == (3, 0)
    assert value("inv(q)")[1] == 1  # its norm is 0
    assert value("5**(-1)") == (5, 0)
    assert value("0.5")[1] == value("1/3")[1] == value("q**(-1)")[1] == 1
    assert value("inv(i + j - j)") == ((0, 5, 0, 0), 0)
    for text in ("r", "exists", "s"):
        with pytest.raises(Rejected, match="no value"):
            evaluator.value(("name", text))
    for tree in (("call", "sin", (("num", 1),)), ("==", ("num", 1), ("num", 1))):
        with pytest.raises(Rejected):
            evaluator.value(tree)
    with pytest.raises(Rejected, match="cannot be evaluated"):
        evaluator.truth(("num", 1))
    with pytest.raises(Rejected, match="exponent"):
        evaluator.value(("pow", ("num", 1), 10_001))


def test_comparisons_with_undefined_sides_are_false() -> None:
    ring = read_field("QQ")
    evaluator = Evaluator(RingScalars(ring), HAMILTON, {})
    for text, truth in (
        ("1/0 == 1/0", False),
        ("1/0 != 1/0", False),
        ("not (1/0 == 1)", True),
        ("1/0 == 0 => 1 == 2", True),
        ("1/0 == 0 <=> inv(0*e) == 0", True),
        ("1 == 1 <=> 1/0 != 1", False),
        ("0 == 1 or 0*(1/0) == 0", False),
        ("2/2 == 1 and 4**(-1) == 0.25", True),
    ):
        assert evaluator.truth(parse(text)) is truth, text
        data = certified(text, "QQ", "identity", IDENTITY)
        if truth:
            assert check(data).verdict == "proved"
        else:
            rejects(data, "does not hold")


# --- clauses and places --------------------------------------------------------------------------


def test_clauses() -> None:
    here = setting()
    x = expand(read_statement("s == y and norm(q) == 0 => s/y == 1 or q != q", here), here)
    assert len(x.factors) == 1
    everywhere = Place(x, None)
    assert not all(map(everywhere.is_trivial, x.clauses))
    assert Place(x, None, 5).same(constant(5)) == frozenset()
    assert Place(x, read_field("QQ")).same(multiply(constant(-6), variable(0))) == frozenset(
        variable(0).items()
    )
    f = multiply(variable(0), multiply(variable(0), variable(1)))
    assert without_factors(f, [variable(0), constant(1)]) == variable(1)
    assert without_factors({}, [variable(0)]) == {}
    assert without_factors(add(f, constant(1)), [variable(0)]) == add(f, constant(1))
    wide = " and ".join(f"(s == {n} or y == {n} <=> t == {n})" for n in range(9))
    for text in (
        " or ".join(f"({wide})" for _ in range(4)),
        " and ".join(f"s != {n}" for n in range(180))
        + " or "
        + " and ".join(f"y != {n}" for n in range(9)),
    ):
        rejects(certified(text, None, "identity", IDENTITY), "clauses|not hold|more work")


def test_fractions_are_those_of_the_field() -> None:
    for text in (
        "s != 0 and y != 0 and s*y != 0 => 1/s + 1/y == (s + y)/(s*y)",
        "s != 0 => 1/(1/s) == s",
        "s != 0 => 1/s - 1/s == 0",
        "norm(q) != 0 => 1/(norm(q)/2) == 2/norm(q) or 2 == 0",
        "s != 0 => 1/s/s == s**(-2)",
        "s != 0 and y != 0 and s*s != 0 and s*s*y != 0 => 1/s/y + 1/(s*s) == (s + y)/(s*s*y)",
        "0.5 + 0.5 == 1 or 2 == 0",
        "1/1 == 1 and 0/1 == 0",
    ):
        for field in ("QQ", "GF(4)", "GF(9)", "QQ(x)"):
            evidence = implication([])
            found = check(certified(text, field, "implication", evidence))
            assert found.verdict == "proved", (text, field)
    rejects(certified("1/s == 1/s", "QQ", "implication", implication([])), "not covered")
    rejects(certified("s != 0 => 1/s == s", "QQ", "implication", implication([])), "not covered")


# --- implications --------------------------------------------------------------------------------


def test_direct_items() -> None:
    data = certified("s*y == 1 => s*y*t == t", None, "implication", implication([]))
    item = direct(["s*y - 1"], "s*t*y - t", ["t"])
    good = {**data, "evidence": implication([item])}
    assert check(good).scope == COMMUTATIVE_RINGS
    for field in ("ZZ", "ZZ/6", "GF(2)", "QQ[x,y]", "ZZ[x]", "GF(4)"):
        if field not in ("QQ[x,y]",):
            assert check({**good, "field": field, "algebra": f"(-1,-1|{field})"}).scope == FIELD
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


def test_a_hypothesis_that_is_a_contradiction() -> None:
    item = direct(["s", "s - 1"], "1", ["1", "-1"])
    data = certified("s == 0 and s == 1 => p == q", None, "implication", implication([item]))
    assert check(data).scope == COMMUTATIVE_RINGS
    twice = direct(["s", "s - 2"], "2", ["1", "-1"])
    rejects({**data, "evidence": implication([twice])}, "not covered")
    over_q = certified("s == 0 and s == 2 => p == q", "QQ", "implication", implication([twice]))
    assert check(over_q)
    rejects({**over_q, "field": "GF(2)", "algebra": "(-1,-1|GF(2))"}, "not covered")


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
        assert check({**data, "field": field, "algebra": f"(-1,-1|{field})"})
    rejects({**data, "field": "ZZ/6", "algebra": "(-1,-1|ZZ/6)"}, "not covered")
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
    everywhere = {**data, "field": None, "algebra": "(-1,-1|F)"}
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
        rejects({**data, "field": field, "algebra": f"(-1,-1|{field})"}, ".")
    rejects({**data, "field": None, "algebra": "(-1,-1|F)"}, "finite ring only")
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
    values = {"kind": "witness", "field": "QQ", "values": {"s": ["2"]}}
    data = certified("exists s: s*s == 4", "QQ", "witness", values)
    assert check(data)
    rejects({**data, "statement": "exists s: s*s == 5"}, "false for the values")
    rejects({**data, "statement": "exists s: s*s == y"}, "no other unknowns")
    rejects({**data, "field": None, "algebra": "(-1,-1|F)"}, "only for one field")
    rejects({**data, "verdict": "refuted"}, "does not show")
    floats = {"kind": "witness", "field": "RDF", "values": {"s": ["2"]}}
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
    rejects(denied, "may be undefined")
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
    everywhere = {
        **both,
        "field": None,
        "algebra": "(-1,-1|F)",
        "evidence": {**whole, "field": "GF(9)"},
    }
    assert check(everywhere).scope == FIELD


# --- rings that are no fields, roots by theorems ---------------------------------------------------


def test_what_another_ring_shows() -> None:
    item = opposite(["2*s"], ["s"], [ends("T1", "2", d=2)])
    inner = implication([item])
    data = certified("2*s == 0 => s == 0", "ZZ", "implication", {})
    there = {"kind": "fractions", "field": "QQ", "proof": inner}
    assert check({**data, "evidence": there}).scope == FIELD
    poly = {**data, "field": "ZZ[x]", "algebra": "(-1,-1|ZZ[x])"}
    assert check({**poly, "evidence": {**there, "field": "QQ(x)"}})
    mod_5 = {**data, "field": "GF(5)[x]", "algebra": "(-1,-1|GF(5)[x])"}
    assert check({**mod_5, "evidence": {**there, "field": "GF(5)(x)"}})
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
        bad = {
            **data,
            "field": ring,
            "algebra": f"(-1,-1|{ring})",
            "evidence": {**there, "field": field},
        }
        rejects(bad, ".")
    rejects({**data, "statement": "2*s == 2 => 1/s == 1", "evidence": there}, "without division")
    cases = {"kind": "exhaustion", "cases": 2}
    reduced = {"kind": "reduction", "modulus": 2, "proof": cases}
    none = certified(
        "exists s: 2*s == 1", "ZZ", "exhaustion", {"kind": "none exists", "proof": reduced}
    )
    none["verdict"] = "refuted"
    assert check(none)
    over_6 = {**none, "field": "ZZ/6", "algebra": "(-1,-1|ZZ/6)"}
    assert check(over_6)
    for bad in (
        {**none, "field": "ZZ/9", "algebra": "(-1,-1|ZZ/9)"},
        {**none, "field": "QQ", "algebra": "(-1,-1|QQ)"},
        {**none, "statement": "exists s: 3*s == 1"},
        {**none, "statement": "exists s: 2*s == 1 or s != s + 2"},
        {**none, "statement": "exists s: 2*s == 1/1"},
        {**none, "evidence": {"kind": "none exists", "proof": {**reduced, "modulus": 1}}},
    ):
        rejects(bad, ".")
    goal = certified("s*s == s => s == 0 or s == 1", "ZZ", "exhaustion", reduced)
    rejects(goal, "no common zero")


@pytest.mark.parametrize(
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
        Finding(COMMUTATIVE_RINGS, "identity"),
        Finding(FIELD, "exhaustion").citing("a", "b", "a"),
    )
    both = together([wide, narrow, narrow])
    assert both == Finding(FIELD, "identity; exhaustion", ("a", "b"))
    assert wide.within(FIELDS).scope == FIELDS
    assert narrow.within(COMMUTATIVE_RINGS).scope == FIELD
    assert together([]).scope == COMMUTATIVE_RINGS
    assert narrow.by("witness") == Finding(FIELD, "witness", ("a", "b"))


# --- rules of a field ----------------------------------------------------------------------------

NORM = {"form": "norm", "by": "ordering"}
SQUARES = {"form": "squares", "by": "ordering", "most": None, "positive": True}
ROOTS = {"form": "roots", "by": "factors"}


def form_step(kind: str, terms: list[str], cofactors: list[str], **more: Any) -> dict[str, Any]:
    return {"step": kind, "terms": terms, "cofactors": cofactors, "denominator": 1, **more}


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
    real = {**data, "field": "RR", "algebra": "(-1,-1|RR)"}
    assert check(real)
    for algebra in ("(-sqrt(2),-1|RR)", "(-1,-sqrt(2)|RR)"):
        foreign = implication(other, [{**NORM, "algebra": algebra}])
        rejects({**real, "evidence": foreign}, "there is no function")
    for field in (None, "ZZ", "CC", "GF(3)", "QQ(I)"):
        rejects({**data, "field": field, "algebra": f"(-1,-1|{field or 'F'})"}, ".")


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
        rejects({**two, "field": field, "algebra": f"(-1,-1|{field})"}, ".")
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
    rejects({**data, "evidence": by_squares}, "told by factors")
    for field in ("GF(5)", "GF(7)", "RR", "GF(2)", "QQ(sqrt(2))", "QQ(x)"):
        moved = {**data, "field": field, "algebra": f"(-1,-1|{field})"}
        rejects(moved, "told by squares")
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
    seven = {**data, "field": "GF(7)", "algebra": "(-1,-1|GF(7))", "evidence": by_squares}
    assert check(seven)
    rejects({**seven, "field": "GF(11)", "algebra": "(-1,-1|GF(11))"}, "may have one")
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
    elsewhere = direct(["s"], "s", ["1"], characteristic=3)
    rejects(
        certified("s == 0 => s == 0 or 1 == 0", "GF(5)", "implication", implication([elsewhere])),
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
    witness = {"kind": "witness", "field": "GF(3)", "values": {"s": ["2"]}}
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
    assert check(data, Pin(("p == p", "q == q"), any_field=True))
    assert Pin(("q == q",)).readable()
    with pytest.raises(Rejected):
        Pin(("q == ",)).readable()
    with pytest.raises(Rejected, match="about QQ, not about all fields"):
        check(data, Pin(("q == q",)))
    with pytest.raises(Rejected, match="another statement"):
        check(data, Pin(("p == p",), any_field=True))


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


@pytest.mark.parametrize(("statement", "field", "method"), REFUTED)
def test_a_refutation_is_named_by_what_is_refuted(statement: str, field: str, method: str) -> None:
    answer = prove(statement, field)
    assert answer.verdict == "refuted"
    assert answer.to_json()["method"] == method
    witness = {"kind": "witness", "field": field, "values": answer.to_json()["witness"]}
    for name in ("identity", "witness", "counterexample", "exhaustion"):
        data = {**certified(statement, field, name, witness), "verdict": "refuted"}
        if name == method:
            assert check(data)
        else:
            rejects(data, "not that of the evidence")


def test_comparing_many_clauses_with_many_items_is_work(monkeypatch: pytest.MonkeyPatch) -> None:
    clauses = [f"(s == 0 => s*t == {n}*s)" for n in range(20)]
    items = [direct(["s"], f"s*t - {n}*s", [f"t - {n}"]) for n in range(20)]
    items += [direct(["s + 1"], "s + 1", ["1"])] * 400
    data = certified(" and ".join(clauses), None, "implication", implication(items))
    assert check(data)
    monkeypatch.setattr(Work.__init__, "__defaults__", (60_000,))
    assert check({**data, "evidence": implication(items[:20])})
    rejects(data, "more work")
