"""Roots of polynomials over H(RR), by Eilenberg and Niven: a single monomial of the highest degree."""

import pytest

from hfield.checker.check import check
from hfield.checker.glossary import QUATERNION_ROOT
from hfield.checker.rejection import Rejected
from tests.checker.cases import Certificate, about_field, certified
from tests.subcases import subcases


def about(statement: str) -> Certificate:
    data = certified(statement, "RR", "witness", {"kind": "quaternion root"})
    return {**data, "assumes": [QUATERNION_ROOT]}


NO_SINGLE = "no single monomial has the highest degree"
SHAPE = "a root is that of one equation in one quaternion"


@subcases(
    "equation",
    [
        *("q == r", "q*q == r", "r == q*q", "q**2*i*q + p*q*r + s*q == 1", "-(i*q*j)**2 - q**3 == p"),
        *("2*q == i*q*q", "(q + p)*(q - r) == 0", "(q + 1)**3 == q**2", "(-i)*q - p == 0"),
        *("q**1000 == 1", "q*q**0 == p", "(q*q - q)**2*k == (p*q)**3", "q*(2*(-3)*e) == s"),
        *("q - q + q**2 == p", "q*(-1) == norm(p)*i"),
    ],
)  # fmt: skip
def test_what_has_a_root(equation: str) -> None:
    found = check(about(f"exists q: {equation}"))
    assert found.theorems == (QUATERNION_ROOT,)
    assert found.scope == "field"
    assert check(about(f"p == 1 => (exists q: {equation})"))
    with pytest.raises(Rejected, match="exactly what the evidence cites"):
        check({**about(f"exists q: {equation}"), "assumes": []})


@subcases(
    ("statement", "why"),
    [
        # i·q − q·i = 1 has no solution, and neither has 0 = 1 or p·q = 1 at p = 0.
        ("exists q: i*q - q*i == 1", NO_SINGLE),
        ("exists q: q - q == 1", NO_SINGLE),
        ("exists q: q == q + 1", NO_SINGLE),
        ("exists q: q**2 - q*q == 1 - q**2 + q*q", NO_SINGLE),
        ("exists q: q**0 == 2", NO_SINGLE),
        ("exists q: p*q == 1", NO_SINGLE),
        ("exists q: (p*q)**2 == 1", NO_SINGLE),
        ("exists q: 0*q == 1", NO_SINGLE),
        ("exists q: (-0)*q == 1", NO_SINGLE),
        ("exists q: (2 - 2)*q == 1", NO_SINGLE),
        ("exists q: (i*0)*q == 1", NO_SINGLE),
        ("exists q: (0*i)*q == 1", NO_SINGLE),
        ("exists q: s*q == 1", NO_SINGLE),
        ("exists q: p[0]*q*q + q == 1", NO_SINGLE),
        ("exists q: p == 1", NO_SINGLE),
        ("exists q: 1 == 2", NO_SINGLE),
        ("exists q: (i*q - q*i)*q == 1", NO_SINGLE),
        ("exists q: q**1001 == 1", NO_SINGLE),
        ("exists q: (q**100)**100 == 1", NO_SINGLE),
        ("exists q: conj(q)*q == -1", "no polynomial in it"),
        ("exists q: q[0]*e == i", "no polynomial in it"),
        ("exists q: norm(q)*q == i", "no polynomial in it"),
        ("exists q: comm(q, i) == 1", "no polynomial in it"),
        ("exists q: q != q", "a root is that of one equation"),
        ("exists q: not (q == q)", "a root is that of one equation"),
        ("exists q: q == 1 and q == 2", "a root is that of one equation"),
        ("exists q: q == 1 or q == 2", "a root is that of one equation"),
        ("exists q, r: q == 1", SHAPE),
        ("exists s: s*q == 1", SHAPE),
        ("exists q: q**2/2 == 1", SHAPE),
        ("exists q: 0.5*q == 1", SHAPE),
        ("exists q: q*inv(p) == 1", SHAPE),
        ("exists q: q**(-1) == 0", SHAPE),
    ],
)
def test_what_may_have_none(statement: str, why: str) -> None:
    with pytest.raises(Rejected) as caught:
        check(about(statement))
    assert why in str(caught.value)


def test_it_is_a_theorem_about_hamiltons_quaternions() -> None:
    data = about("exists q: q*q == i")
    for field in ("QQ", "CC", "QQ(sqrt(2))", None):
        other = about_field(data, field)
        with pytest.raises(Rejected, match="have roots over RR"):
            check(other)
    for algebra in ("(1,-1|RR)", "(-1,-2|RR)", "[-1,-1|RR)", "(a,b|RR)"):
        with pytest.raises(Rejected, match="have roots over RR"):
            check({**data, "algebra": algebra})
    with pytest.raises(Rejected, match="unknown key 'by'"):
        check({**data, "evidence": {"kind": "quaternion root", "by": "degree"}})
    for verdict in ("refuted", "vacuous"):
        with pytest.raises(Rejected, match="does not show that the statement is"):
            check({**data, "verdict": verdict})
    with pytest.raises(Rejected, match="does not show that the statement is"):
        check({**data, "statement": "q*q == i"})
