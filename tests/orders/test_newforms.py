"""Newforms by Brandt matrices: against PARI over ℚ, known dimensions and forms over number fields."""

import importlib.util

import pytest

from hfield import LatticeError, QuaternionAlgebra, ring
from tests.subcases import first_quick

PRIMES = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37]


# the minimal polynomials of the coefficients of each Galois orbit
ORBITS = """
(N, k, primes) -> my(minimal(c) = Vecrev(if(type(c) == "t_POLMOD", minpoly(c), x - c)));
apply(f -> apply(p -> minimal(mfcoef(f, p)), primes), mfeigenbasis(mfinit([N, k], 0)))
"""


def orbits(level: int, weight: int, primes: list[int]) -> list[list[list[int]]]:
    """The minimal polynomials of the coefficients of each Galois orbit of newforms, by PARI."""
    from cypari import pari

    found = pari(f"({ORBITS.replace(chr(10), ' ')})({level}, {weight}, {primes})")
    return sorted([[int(c) for c in f] for f in form] for form in found)


@pytest.mark.skipif(importlib.util.find_spec("cypari") is None, reason="needs PARI")
@pytest.mark.parametrize(
    ("discriminant", "level"),
    first_quick(
        [(37, 1), (11, 9), (3, 22), (5, 8), (17, 6), (30, 7), (42, 5), (3, 49), (2, 81)], 5
    ),
)
def test_against_pari(discriminant: int, level: int) -> None:
    """Eigenvalues at all primes, those of the level too, and so the signs of Atkin and Lehner."""
    C = QuaternionAlgebra(discriminant).eichler_order(level).class_set()
    expected = orbits(discriminant * level, 2, PRIMES)
    forms = C.newforms()
    assert C.new_dimension() == sum(f.degree for f in forms)
    assert sorted([f.minimal_polynomial(p) for p in PRIMES] for f in forms) == expected


def test_orbits_of_level_389() -> None:
    """The first elliptic curve of rank 2, and the eigenvalues of a whole orbit in its field."""
    forms = QuaternionAlgebra(389).maximal_order().class_set().newforms()
    assert [f.degree for f in forms] == [1, 2, 3, 6, 20]
    assert [f.signs[389] for f in forms] == [-1, 1, 1, 1, -1]
    assert forms[0].eigenvalues(6) == {2: -2, 3: -2, 5: -3, 7: -5, 11: -4, 13: -3}
    f = forms[2]
    assert f.field.polynomial.coeffs() == [1, -3, -1, 1]
    for p in (2, 3, 5, 101):
        a = f.eigenvalue(p)
        assert a.trace() == f.trace(p)
        assert [int(c) for c in a.minimal_polynomial()] == f.minimal_polynomial(p)


def test_known_spaces_over_the_golden_field() -> None:
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    K = A.ring
    known = [(31, 1, 1), (124, 3, 1), (341, 7, 5), (1364, 31, 15)]
    P31 = K.primes_above(31)[0]
    for P11 in K.primes_above(11):
        found = []
        for norm, *_ in known:
            pairs = [
                (P, 1)
                for P, q in ((K.primes_above(2)[0], 4), (P11, 11), (P31, 31))
                if norm % q == 0
            ]
            C = A.eichler_order(pairs).class_set()
            found.append((norm, C.cusp_dimension(), C.new_dimension()))
        assert found == known
        assert len(C) == 32
    # the curve of conductor norm 31: reductions counted by hand
    (f,) = A.eichler_order([(P31, 1)]).class_set().newforms()
    assert (f[2], f[K.primes_above(5)[0]], f[3], f[7]) == (-3, -2, 2, 2)
    assert {f[P] for P in K.primes_above(11)} == {4, -4}
    assert f.eigenvalues(2) == {K.primes_above(2)[0]: -3, K.primes_above(5)[0]: -2}


def test_signs_at_the_level_agree_with_ideals_of_that_norm() -> None:
    """All invertible ideals of norm P | N are those of U_P, those of its conjugate, and the two-sided one."""
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    P = A.ring.primes_above(31)[0]
    C = A.eichler_order([(P, 1)]).class_set()
    (f,) = C.newforms()
    B = C.brandt_matrix(P)
    assert sum(B[0]) == 63
    assert B[0][0] + B[1][1] == 63 + 2 * f[P] + f.signs[P]


@pytest.mark.slow
def test_class_number_two() -> None:
    """Over ℚ(√10), class number 2: new dimensions do not depend on the algebra (Jacquet and Langlands)."""
    K = ring("QQ(sqrt(10))")
    P, Q = K.primes_above(2)[0], K.primes_above(3)[0]
    split = QuaternionAlgebra.from_ramification(K, K.real_places())
    ramified = QuaternionAlgebra.from_ramification(K, [*K.real_places(), P, Q])
    over = split.eichler_order([(P, 1), (Q, 1)]).class_set()
    other = ramified.maximal_order().class_set()
    assert over.new_dimension() == other.new_dimension() > 0
    mine, its = over.newforms(), other.newforms()
    primes = [P, Q, *K.primes_above(5), *K.primes_above(3), *K.primes_above(7)]
    assert sorted([f[P] for P in primes] for f in mine) == sorted(
        [f[P] for P in primes] for f in its
    )


def test_other_orders_have_no_level() -> None:
    C = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).order(["i", "j"]).class_set()
    with pytest.raises(LatticeError, match="Eichler"):
        C.newforms()
    C = QuaternionAlgebra("QQ", -1, -1).order(["i", "j"]).class_set()
    with pytest.raises(LatticeError, match="Eichler"):
        C.cusp_dimension()
