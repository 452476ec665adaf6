"""Lemma 1: multilinear maps on tuples of basis vectors."""

import pytest

from hfield.errors import NotationError
from hfield.proving.multilinear import decide_multilinear

TRUE = [
    "(p*q)*r == p*(q*r)",
    "conj(p*q) == conj(q)*conj(p)",
    "trace(p*q) == trace(q*p)",
    "comm(p,q) == p*q - q*p",
    "trace(p*q*r) == trace(q*r*p)",
]
FALSE = ["p*q == q*p", "(p*q)*r == p*(r*q)", "conj(p*q) == conj(p)*conj(q)", "vector(p)*q == p*q"]


@pytest.mark.parametrize("statement", TRUE)
def test_true_ones_have_a_line_for_every_tuple(statement):
    decision = decide_multilinear(statement)
    assert decision.verdict == "proved"
    assert decision.scope == "commutative rings"
    unknowns = len(decision.evidence["unknowns"])
    words = {word for word, _ in decision.evidence["tuples"]}
    assert len(words) == len(decision.steps) == 4**unknowns


@pytest.mark.parametrize("statement", FALSE)
def test_false_ones_have_a_tuple(statement):
    decision = decide_multilinear(statement, "QQ")
    assert decision.verdict == "refuted"
    assert all(sorted(v) == ["0", "0", "0", "1"] for v in decision.witness.values())
    assert decide_multilinear(statement).witness["F"] == ["QQ"]


def test_characteristic_and_algebra():
    assert decide_multilinear("p*q == q*p", "GF(4)").scope == "characteristics [2]"
    assert decide_multilinear("p*q == q*p", "GF(3)").verdict == "refuted"
    assert decide_multilinear("(p*q)*r == p*(q*r)", algebra="(2,-3|QQ)").verdict == "proved"


@pytest.mark.parametrize(
    "statement",
    ["p*p == p", "norm(p*q) == 0", "p*q == p", "s*p == p*s", "p*q == q*p => p == q", "inv(p) == q"],
)
def test_what_is_not_multilinear_is_refused(statement):
    with pytest.raises(NotationError):
        decide_multilinear(statement)
