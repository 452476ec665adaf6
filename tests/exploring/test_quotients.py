"""Quotients by two-sided ideals: homomorphisms with the right kernel, by brute force where it is finite."""

import pytest

from hfield import H, QuaternionAlgebra
from hfield.errors import CoercionError, RingError
from tests.exploring.brute_force import FIELDS, Case


def check_homomorphism(A, B, phi) -> None:
    for p in A.basis:
        for q in A.basis:
            assert phi(p * q) == phi(p) * phi(q)
            assert phi(p + q) == phi(p) + phi(q)
    assert phi(1) == B.one
    assert B.is_associative()
    assert all(phi(phi.lift(x)) == x for x in B.basis)
    assert all(not phi(q) for q in phi.kernel.basis)
    assert B.dimension + phi.kernel.dimension == 4


@pytest.mark.parametrize("case", FIELDS, ids=str)
def test_quotients_by_brute_force(case: Case) -> None:
    A = case.algebra
    for ideal in A.two_sided_ideals()[:-1]:
        B, phi = A.quotient(ideal.basis)
        check_homomorphism(A, B, phi)
        assert set(phi.kernel.basis) == set(ideal.basis)
    B, phi = A.quotient(A.radical())
    everything = list(B.elements())
    assert {phi(q) for q in A.elements()} == set(everything)
    # no element other than 0 generates a nilpotent left ideal
    for x in everything:
        assert not x or any((y * x) * (y * x) for y in everything)


@pytest.mark.parametrize(
    ("text", "dimension"),
    [
        ("(-1,-1|QQ)", 4),
        ("(0,0|QQ)", 1),
        ("(0,4|QQ)", 2),
        ("(2,0|QQ)", 2),
        ("(0,-1|RR)", 2),
        ("(t,t|GF(2)(t))", 2),
        ("[1,0|GF(2)(t))", 2),
        ("(0,2|QQ(x))", 2),
    ],
)
def test_quotients_by_the_radical_over_infinite_fields(text: str, dimension: int) -> None:
    A = QuaternionAlgebra(text)
    B, phi = A.quotient(A.radical())
    check_homomorphism(A, B, phi)
    assert B.dimension == dimension
    if dimension < 4:
        assert B.is_commutative()


def test_the_ideal_that_elements_generate() -> None:
    A = QuaternionAlgebra("GF(5)", 1, 0)
    B, phi = A.quotient(["1 + i"])
    assert (B.dimension, phi("i")) == (1, -B.one)
    containing = [ideal for ideal in A.two_sided_ideals() if "1 + i" in ideal]
    assert phi.kernel in containing
    assert all(phi.kernel <= ideal and ideal >= phi.kernel for ideal in containing)
    assert A.two_sided_ideals()[0] < phi.kernel
    assert phi.kernel > A.two_sided_ideals()[0]
    assert not phi.kernel < phi.kernel
    assert "j ↦ 0" in repr(phi)


def test_what_is_refused() -> None:
    with pytest.raises(CoercionError, match="the quotient is 0"):
        H("QQ").quotient(["i + j"])
    with pytest.raises(RingError, match="change_ring"):
        H("ZZ/4").quotient([2])
