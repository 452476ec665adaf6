"""The judge judged: laws that hold in every ring, sentences that do not, what is undefined, what is read."""

import random

import pytest

from tests.adversary.falsify import counterexample, is_true, one_place, sampled, true_at
from tests.adversary.grammar import NotRead, read
from tests.adversary.meaning import read_algebra, read_claim
from tests.adversary.scalars import named, value_of
from tests.adversary.small_rings import galois, rings
from tests.adversary.statement_generator import cases
from tests.subcases import subcases

LAWS = (
    "(p*q)*r == p*(q*r)",
    "conj(p*q) == conj(q)*conj(p)",
    "norm(p*q) == norm(p)*norm(q)",
    "q**2 - trace(q)*q + norm(q) == 0",
    "comm(comm(p,q)**2, r) == 0",
    "q == q[0] + q[1]*i + q[2]*j + q[3]*k",
    "i*i == a + c*i and j*j == b and i*j == k and j*i == c*j - k",
    "s != s + 1",
)


@pytest.mark.parametrize("law", LAWS)
def test_laws_hold_in_every_algebra_over_every_ring(law: str) -> None:
    claim = read_claim(law, "[a,b,c|F)")
    assert counterexample(claim, rings(), random.Random(0), 60) is None


@subcases(
    ("statement", "true_over", "false_over"),
    [
        ("q*j == j*q", {"GF(2)", "F2[e]/e^2"}, {"GF(3)", "Z/4", "GF(2) x GF(3)"}),
        ("s*y == 0 => s == 0 or y == 0", {"GF(2)", "GF(9)"}, {"GF(2) x GF(2)", "Z/4", "F3[e]/e^2"}),
        ("s**2 == 0 => s == 0", {"GF(2) x GF(4)", "GF(5)"}, {"Z/4", "Z/8", "GF(4)[e]/e^2"}),
        ("s != 0 => s/s + 2*s == 1", {"GF(2)", "GF(8)"}, {"GF(2) x GF(2)", "F2[e]/e^2"}),
        ("s**2 == s", {"GF(2)", "GF(2) x GF(2) x GF(2)"}, {"GF(3)", "GF(4)"}),
        ("1/s == 1/s or s == 0", {"GF(7)", "GF(16)"}, {"Z/4", "GF(2) x GF(3)"}),
        ("0.5 == 0.5", {"GF(3)", "Z/9"}, {"GF(2)", "Z/4", "GF(2) x GF(3)"}),
        ("not (inv(0*e) == inv(0*e))", {"GF(2)", "Z/4"}, set()),
        ("exists q: q != 0 and norm(q) == 0", {"GF(2)", "GF(3)"}, set()),
        ("exists z: z**2 == 2", {"GF(2)", "GF(7)"}, {"GF(3)", "GF(5)", "Z/4"}),
        ("s != 0 => (exists z: s*z == 1)", {"GF(4)", "GF(9)"}, {"Z/4", "GF(2) x GF(2)"}),
    ],
)
def test_where_statements_are_true(
    statement: str, true_over: set[str], false_over: set[str]
) -> None:
    by_name = {ring.name: ring for ring in rings()}
    claim = read_claim(statement, None)
    for name in (*true_over, *false_over):
        assert is_true(claim, by_name[name]) == (name in true_over), name


def test_an_algebra_whose_constants_are_undefined_is_not_spoken_of() -> None:
    claim = read_claim("a != 0", "(1/a,-1|GF(3))")
    assert is_true(claim, galois(3))
    assert true_at(claim, one_place(galois(3)), {"a": one_place(galois(3)).zero}) is None
    assert is_true(read_claim("a != 0", "(a,-1|GF(3))"), galois(3)) is False


def test_constants_of_a_field_and_unknowns_of_the_same_name() -> None:
    field = galois(9)
    assert is_true(
        read_claim("x**2 == x + 1", None, one_place(field)), field
    )  # Conway: x² + 2x + 2
    assert is_true(read_claim("x**2 == x + 1", None), field) is False


def test_numbers_and_functions() -> None:
    for name, text, other in (
        ("RR", "sqrt(2)*sqrt(3)", "sqrt(6)"),
        ("CC", "I*I", "-1"),
        ("QQ(sqrt(-7))", "sqrt(-7)**2", "-7"),
        ("QQ(x)", "(x**2 - 1)/(x - 1)", "x + 1"),
        ("GF(2)(t)", "(t + 1)**2", "t**2 + 1"),
        ("RR", "root(2,3)**3", "2"),
    ):
        s = named(name)
        x, y = value_of(read(text), s), value_of(read(other), s)
        assert s.is_zero(s.add(x, s.neg(y))), (name, text)
    assert named("RR").constant(("call", "sqrt", (("minus", ("number", 2)),))) is None
    assert named("QQ(sqrt(2))").constant(read("sqrt(3)")) is None
    assert sampled(
        read_claim("s**2 != 1", None, named("QQ(x)")), named("QQ(x)"), random.Random(0), 90
    )


def test_the_grammar() -> None:
    assert read("a => b => c") == ("=>", ("name", "a"), ("=>", ("name", "b"), ("name", "c")))
    assert read("-q**2") == ("minus", ("power", ("name", "q"), 2))
    assert read("p − q·r") == read("p - q*r")
    assert read("not p == q and r == s") == ("and", ("not", read("p == q")), read("r == s"))
    assert read("q^(-2)") == ("power", ("name", "q"), -2)
    for text in ("p ==", "(p", "ｑ == 0", "s == ٣", "p q", "q**s"):
        with pytest.raises((NotRead, ValueError)):
            read(text)
    assert read_algebra("[1,2,3|F)") == (("number", 1), ("number", 3), ("number", 2))


def test_the_generator_draws_every_shape_and_the_same_again() -> None:
    drawn = cases(3, 400)
    assert drawn == cases(3, 400)
    assert len({c.shape for c in drawn}) == 9
    text = " ".join(c.statement for c in drawn)
    for part in (
        "<=>",
        "=>",
        "or",
        "not",
        "exists",
        "inv(",
        "**-1",
        "comm(",
        "[2]",
        "1/2",
        "/",
        "!=",
    ):
        assert part in text, part
    for case in drawn:
        read(case.statement)
    assert {None, "QQ", "GF(9)", "ZZ/6"} <= {c.field for c in drawn}


def test_what_is_made_to_be_true_is_true() -> None:
    for n, case in enumerate(c for c in cases(4, 300) if c.true):
        ring = None if case.field is None else named(case.field)
        if ring is None:
            claim = read_claim(case.statement, case.algebra)
            assert counterexample(claim, rings(), random.Random(n), 20) is None, case
