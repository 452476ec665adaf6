"""Statements that a textbook decides: forms, roots, embeddings, contradictions modulo a number."""

import pytest

from hfield.prover.decide import decide
from hfield.prover.prove import prove
from tests.subcases import subcases

FORMS = [
    ("s**2 == 2*y**2 => s == 0", "QQ", "proved"),
    ("s**2 == 2*y**2 => s == 0 and y == 0", "QQ", "proved"),
    ("s**2 == 2*y**2 => s == 0", "RR", "refuted"),
    ("s**2 == 2*y**2 => s == 0", "GF(3)", "proved"),
    ("s**2 == 2*y**2 => s == 0", "GF(7)", "refuted"),
    ("s**2 == 4*y**2 => s == 0", "QQ", "refuted"),
    ("s**2 + s*y == y**2 => s == 0", "QQ", "proved"),
    ("s**2 + s*y == y**2 => s == 0", "QQ(sqrt(5))", "refuted"),
    ("s**3 == 2*y**3 => y == 0", "QQ", "proved"),
    ("s**3 == 8*y**3 => y == 0", "QQ", "refuted"),
    ("s**2 == sqrt(2)*y**2 => s == 0", "QQ(sqrt(2))", "proved"),
    ("s**2 == (3 + 2*sqrt(2))*y**2 => s == 0", "QQ(sqrt(2))", "refuted"),
    ("s**2 == x*y**2 => s == 0", "QQ(x)", "proved"),
    ("s**2 + y**2 == 3*z**2 => z == 0", "QQ", "proved"),
    ("s**2 + y**2 == 5*z**2 => z == 0", "QQ", "refuted"),
    ("s**2 + s*y + y**2 == 0 => s == 0", "RR", "proved"),
    ("s**2 + y**2 + z**2 == s*y => z == 0", "QQ", "proved"),
    ("(s - 3)**2 + (y + 5)**2 == 0 => s == 3", "QQ", "proved"),
    ("u**2 != 2", "QQ", "proved"),
    ("u**2 != 2", "RR", "refuted"),
]
PLACES = [
    ("inv(p+4) == inv(p+4)", "QQ"),
    ("inv(2*p - 3*i) == inv(2*p - 3*i)", "QQ(sqrt(2))"),
    ("inv(p - q + 9) == inv(p - q + 9)", "RR"),
    ("norm(3*p - 5*i + 11) != 0", "QQ"),
    ("1/(s**3 - 1331) == 1/(s**3 - 1331)", "QQ"),
    ("s**3 - 2*s != 115", "QQ"),
    ("q**2 == 0 => q == 0", "QQ(sqrt(-3))"),
]
CONSTANTS = [
    ("root(2,3) != 2", "RR"),
    ("root(2,3)*s == 2*s => s == 0", "RR"),
    ("cbrt(5)**3 == 5", "RR"),
    ("t**2 != t", "GF(2)(t)"),
    ("(t + 1)*q == 0 => q == 0", "GF(2)(t)"),
    ("(x - 1)*q == 0 => q == 0", "QQ(x)"),
    ("sqrt(2)*s == 2*s => s == 0", "RR"),
]
RINGS = [
    ("norm(q) == 0 => q == 0", "ZZ", "proved", "fractions"),
    ("p*q == 0 => p == 0 or q == 0", "ZZ[x]", "proved", "fractions"),
    ("s**2 == 0 => s == 0", "ZZ[a,b]", "proved", "implication"),
    ("2*q == 0 => q == 0", "QQ[x]", "proved", "implication"),
    ("exists s: s**2 == 2", "ZZ", "refuted", "none exists"),
    ("exists s: 2*s == 1", "ZZ", "refuted", "none exists"),
    ("s**2 + y**2 != 4*z + 3", "ZZ", "proved", "reduction"),
    ("2*p != i + j", "ZZ", "proved", "reduction"),
    ("6*s + 10*y != 5", "ZZ", "proved", "reduction"),
    ("norm(q) != 0 => (exists r: q*r == 1)", "ZZ", "refuted", "place"),
    ("0.5*q + 0.5*q == q", "QQ[x]", "proved", "fractions"),
]


@subcases(("statement", "field", "verdict"), FORMS)
def test_forms_that_are_zero_only_at_zero(statement, field, verdict):
    assert decide(statement, field).verdict == verdict


@pytest.mark.parametrize(("statement", "field"), PLACES)
def test_places_that_are_not_small(statement, field):
    assert decide(statement, field).verdict == "refuted"


@pytest.mark.parametrize(("statement", "field"), CONSTANTS)
def test_constants_of_the_field_are_distinguished(statement, field):
    assert decide(statement, field).verdict == "proved"


@subcases(("statement", "ring", "verdict", "kind"), RINGS)
def test_rings_that_are_no_fields(statement, ring, verdict, kind):
    decision = decide(statement, ring)
    assert (decision.verdict, decision.evidence.kind) == (verdict, kind)


@pytest.mark.parametrize(
    ("statement", "ring"),
    [
        ("s*y == 1 => s == 1", "ZZ"),
        ("s/2 == 1 => s == 2", "QQ[x]"),
        ("2*s == 2*y => s == y", "ZZ/4"),
        ("4*s == 2*y + 6", "ZZ"),
    ],
)
def test_embeddings_prove_no_more_than_holds(statement, ring):
    expected = {"QQ[x]": "proved"}.get(ring, "refuted")
    assert decide(statement, ring).verdict == expected


def test_long_numbers_are_no_obstacle():
    n = 12345678901234567890123
    assert decide(f"s*y == {n}*y => s == {n} or y == 0", "QQ").verdict == "proved"
    assert decide(f"s**3 != {10**21 + 7}**3", "QQ").witness == {"s": [str(10**21 + 7)]}


def test_what_has_no_certificate_says_why():
    answer = prove("not (1/0 == s)", "ZZ")
    assert answer.verdict == "proved"
    assert answer.certificate is None
    assert answer.why_no_certificate
    assert prove("p*q == q*p", "QQ").why_no_certificate is None
