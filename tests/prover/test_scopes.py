"""A scope is a claim about all commutative rings of a kind: it is tried over rings that are no fields."""

import random
import re

import pytest

from hfield.prover.decide import decide
from tests.prover.small_rings import RINGS, holds
from tests.subcases import subcases
from tests.thorough import cases

# Equal over every commutative ring, so that "A + n·C == B" holds exactly where n·C is 0.
EQUAL = [
    ("s*y", "y*s"),
    ("norm(p)", "p*conj(p)"),
    ("p**2", "trace(p)*p - norm(p)"),
    ("(s + y)**2", "s**2 + 2*s*y + y**2"),
    ("conj(p)", "trace(p) - p"),
    ("comm(p, i)", "-comm(i, p)"),
    ("s", "s"),
]
PERTURBATIONS = ["s", "p", "comm(p, i)", "s*p", "s**2 - s", "p**2", "vector(p)", "1", "s*y", "y"]
HYPOTHESES = [
    "s != 0",
    "s == 0",
    "s**2 == 0",
    "norm(p) != 0",
    "norm(p) == 0",
    "s*y == 0",
    "s**2 == y**2",
    "not (s == 0)",
    "s == 0 or y == 0",
    "2 == 0",
    "4 == 0",
    "6*s == 0",
    "((s == 0) <=> (y == 0))",
    "s*y == 1",
    "p*p == 0",
]
GOALS = [
    "s == 0",
    "s == y",
    "s == 0 or y == 0",
    "p == 0",
    "norm(p) == 0",
    "s**2 == s",
    "p*i == i*p",
    "s*p == y*p",
    "2*s == 0",
]
ONE = ["s/s", "inv(s)*s", "p*inv(p)", "s**-1*s", "1", "3/3"]


def statements(seed, count):
    rng = random.Random(seed)
    pick = rng.choice
    for _ in range(count):
        a, b = pick(EQUAL)
        n = pick([2, 2, 3, 4, 6, 12])
        identity = f"{a} + {n}*({pick(PERTURBATIONS)}) == {b}"
        quotient = f"({pick(ONE)})*({a}) + {n}*({pick(PERTURBATIONS)}) == {b}"
        shape = rng.randrange(9)
        h, g = pick(HYPOTHESES), pick(GOALS)
        yield [
            identity,
            f"{identity} and {n}*({pick(PERTURBATIONS)}) == 0",
            f"{h} => {pick([identity, quotient])}",
            f"{h} => {g}",
            f"{h} => {pick(HYPOTHESES)} => {g}",
            f"{identity} or {pick([g, quotient])}",
            f"({h}) <=> ({pick([h, g, identity])})",
            f"not ({pick([identity, quotient])})",
            f"{pick(['s != 0', 'norm(p) != 0', 's*y == 1'])} => {quotient}",
        ][shape]


def claimed(decision):
    """The rings over which a decision claims the statement, and those over which it does not hold."""
    scope = decision.scope or ""
    listed = re.fullmatch(r"characteristics \[(.+)\]", scope)
    for ring in RINGS:
        if listed:
            primes = [int(p) for p in listed[1].split(",")]
            yield ring, ring.characteristic in primes
        elif decision.verdict != "refuted":
            kinds = {
                "commutative rings": True,
                "reduced rings": ring.is_reduced,
                "fields": ring.is_field,
            }
            yield ring, kinds.get(scope, False)


def wrong_claims(statement, field, most=20_000):
    decision = decide(statement, field, timeout=5)
    return [
        (statement, field, decision.verdict, decision.scope, ring.name)
        for ring, is_claimed in claimed(decision)
        if is_claimed and holds(statement, ring, most=most) is False
    ], decision


@pytest.mark.slow
@pytest.mark.parametrize("field", [None, "QQ", "GF(2)", "GF(3)", "GF(4)"])
def test_what_a_scope_claims_holds_over_every_ring_of_its_kind(field):
    wrong, scopes = [], set()
    for statement in dict.fromkeys(statements(f"{field}", cases(200))):
        found, decision = wrong_claims(statement, field)
        wrong += found
        scopes.add((decision.scope or "null")[:15])
    assert not wrong
    assert len(scopes) >= 3


KNOWN = [
    ("s != 0 => s/s + 2*s == 1", None, "refuted", None),
    ("s != 0 => s/s == 1", "GF(2)", "proved", "fields"),
    ("s != 0 => s/s + 2*s == 1", "GF(2)", "proved", "field"),
    ("s**2 == y**2 => s == y", "GF(2)", "proved", "field"),
    ("s**2 == y**2 => s == y", None, "refuted", None),
    ("s == 0 => 2*p == 0", None, "refuted", None),
    ("2*p == 0 or s == 1", None, "refuted", None),
    ("2*p == 0 and 6*s == 0", None, "refuted", "characteristics [2]"),
    ("2*p == 0 and 3*s == 0", None, "refuted", None),
    ("s == 0 => 2*p == 0", "GF(2)", "proved", "characteristics [2]"),
    ("s*y == 0 => s == 0 or y == 0", None, "proved", "fields"),
    ("s*y == 0 => s*p*y == 0", None, "proved", "commutative rings"),
    ("s**2 == 0 => s == 0", "GF(2)", "proved", "reduced rings"),
    ("exists u: u != 0 and 2*u == u", None, "refuted", None),
    ("i*i == a", None, "proved", "commutative rings"),
    ("a != 0", None, "proved", "fields"),
]
ALGEBRAS = {"i*i == a": "(a,b|F)", "a != 0": "(1/a,b|F)"}


@subcases(("statement", "field", "verdict", "scope"), KNOWN)
def test_scopes_that_are_known(statement, field, verdict, scope):
    decision = decide(statement, field, algebra=ALGEBRAS.get(statement))
    assert (decision.verdict, decision.scope) == (verdict, scope)


def test_where_it_holds_all_the_same_is_said_in_words():
    steps = decide("s != 0 => s/s + 2*s == 1").steps
    assert any("it holds over fields of characteristic 2" in step for step in steps)


def test_nothing_is_said_of_characteristics_without_the_algebra():
    steps = decide("i*j == j*i", algebra="(1/2,b|F)").steps
    assert not any("characteristic" in step for step in steps)
    steps = decide("3*i*j == 3*j*i", algebra="(1/2,b|F)").steps
    assert "it holds over fields of characteristic 3" in steps


@pytest.mark.parametrize("field", ["GF(8)", "QQ(x)"])
def test_a_vacuous_statement_with_constants_of_the_field_speaks_of_no_other(field):
    found = decide("b == 0 => x == 1", field, algebra=f"(a/b,b|{field})")
    assert (found.verdict, found.scope) == ("vacuous", "field")
    found = decide("b == 0 => s == 1", field, algebra=f"(a/b,b|{field})")
    assert (found.verdict, found.scope) == ("vacuous", "fields")
