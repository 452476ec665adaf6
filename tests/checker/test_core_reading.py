"""The core of the checker, JSON values, statements, terms: each bound, each way to read and evaluate."""

from fractions import Fraction
from typing import Any

import pytest

from hfield.checker import check as checking
from hfield.checker.budget import Budget, bounded, spend
from hfield.checker.check import check
from hfield.checker.clauses import expand, without_factors
from hfield.checker.evaluate import Evaluator, Quaternion, RingScalars
from hfield.checker.glossary import COMMUTATIVE_RINGS
from hfield.checker.language import parse, substitute, walk
from hfield.checker.over_field import EvaluationContext
from hfield.checker.polynomials import add, constant, multiply, variable
from hfield.checker.rejection import (
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
from hfield.checker.statement import HAMILTON, read_statement
from tests.checker.cases import certified
from tests.checker.hand_made import (
    IDENTITY,
    implication,
    rejects,
    setting,
)
from tests.checker.ring_data import read_field
from tests.subcases import subcases

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
    assert shown(1 << 20_000) == "a number of 20001 bits"
    assert one_line(" a\n \u2028b\u202e ") == "a b?"


def test_work_is_bounded() -> None:
    spend(10**9)  # outside nothing is counted
    with bounded() as work:
        spend(10_000_000)
        with pytest.raises(Rejected, match=r"more work .* 10 million units; .* --work N"):
            spend(1)
    assert work.spent == 10_000_001
    with bounded(Budget(0.5)), pytest.raises(Rejected, match=r"0\.5 million units"):
        spend(500_001)


def test_nothing_but_rejected_leaves_the_checker(monkeypatch: pytest.MonkeyPatch) -> None:
    data = certified("q == q", "QQ", "identity", IDENTITY)
    for error in (RecursionError, MemoryError, ZeroDivisionError, OverflowError):

        def fails(*_: Any, error: type[Exception] = error) -> None:
            raise error

        monkeypatch.setattr(checking, "establish_any", fails)
        rejects(data, "nests|memory|evaluated")


# --- reading -------------------------------------------------------------------------------------


@subcases(
    "text",
    [
        *("q" * 20_001 + " == q", "(" * 101 + "q" + ")" * 101 + " == q", "q == " + "+".join(["q"] * 202)),
        *("q == (exists p: p == q)", "p == not q", "q**s == q", "q**(2 == q", "q**2**2 == q", "q[0][1] == 0"),
        *("q == q\u00a0", "\u00a0q == q", "q\u2003== q", "q == q\x1c"),
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


@subcases("name", ["call", "name", "num", "neg", "pow", "index"])
def test_names_that_exists_binds_are_no_trees(name: str) -> None:
    """A tuple of names may begin like a tree."""
    bound = f"(exists {name}, x: 0 == 0)"
    for text in (
        f"dot(1, {bound}) == 1",
        f"1 + {bound} >= 0",
        f"abs({bound}) == 1",
        f"matrix({bound}, 1, 1, 1) == 1",
    ):
        rejects(
            certified(text, "QQ", "identity", IDENTITY),
            "expected a term|cannot have both|compares scalars",
        )
    data = certified(f"exists {name}, x: 0 == 0", "QQ", "identity", IDENTITY)
    rejects(data, "cannot bind")
    rejects({**data, "algebra": "table(e; 1 = e: e|QQ)"}, "cannot bind")


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


@subcases(
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
        setting(algebra, field)


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
        ("(1/0 == 0 => 1 == 2) and 1 == 1", True),  # alone it is vacuous
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
    everywhere = EvaluationContext(x, None)
    assert not all(map(everywhere.is_trivial, x.clauses))
    assert EvaluationContext(x, None, 5).same(constant(5)) == frozenset()
    assert EvaluationContext(x, read_field("QQ")).same(
        multiply(constant(-6), variable(0))
    ) == frozenset(variable(0).items())
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
