"""Completions of global fields: an algebra is a division algebra in one exactly where it ramifies."""

import pickle
from itertools import islice
from random import Random

import pytest

from hfield import QuaternionAlgebra, hilbert_symbol, ring
from hfield.errors import CoercionError, RingError, UndecidedError
from tests.subcases import subcases

FIELDS = (
    "QQ", "QQ(I)", "QQ(sqrt(2))", "QQ(sqrt(5))", "QQ(sqrt(-7))", "QQ[s]/(s^2+s+1)", "QQ[s]/(s^3-2)",
    "QQ[s]/(s^3-3*s-1)", "QQ[s]/(s^3-s^2-2*s-8)", "QQ(root(2,3))", "QQ(root(2,4))",
    "QQ(zeta5)", "QQ(zeta8)", "QQ(zeta7)+", "QQ(sqrt(2),sqrt(3))", "QQ(sqrt(2),I)", "QQ[s]/(s^4-s-1)",
    "QQ[s]/(s^4-16*s^2+4)", "QQ[s]/(s^5-s-1)", "QQ(zeta11)+", "QQ[s]/(s^6-2*s^3+2)", "QQ[s]/(s^10-2)",
    "GF(2)(t)", "GF(3)(t)", "GF(4)(t)", "GF(9)(t)",
)  # fmt: skip


@pytest.mark.slow
@subcases("name", FIELDS)
def test_a_completion_tells_where_an_algebra_ramifies(name):
    K, rng = ring(name), Random(name)
    divisions = 0
    for _ in range(5):
        a, b = (K.random(rng) for _ in "ab")
        if K.is_zero(a) or K.is_zero(b):
            continue
        A = QuaternionAlgebra(K, a, b, int(K.characteristic == 2))
        ramified = A.ramified_places()
        infinite = K.infinite_places() if hasattr(K, "infinite_places") else ()
        for v in {*ramified, *infinite, *islice(K.places(), 4)}:
            L = K.completion(v)
            assert A.change_ring(L).is_division_algebra() == (v in ramified)
            q = A(1, a, 0, b)
            assert q.change_ring(L).norm() == L(q.norm())
            divisions += v in ramified
    assert divisions


REAL = ("QQ(sqrt(2))", "QQ(root(2,4))", "QQ(zeta11)+", "QQ[s]/(s^5-s-1)", "QQ[s]/(s^3-3*s-1)")


@pytest.mark.parametrize("name", REAL)
def test_at_a_real_place_signs_are_those_of_the_place(name):
    K, rng = ring(name), Random(3)
    for v in K.real_places():
        L = K.completion(v)
        for _ in range(10):
            x, y = (K.random(rng) for _ in "xy")
            assert L.sign(L(x)) == v.sign(x)
            if K.is_zero(x):
                continue
            assert L.is_square(L(x)) == (v.sign(x) > 0)
            square = L(x * x)
            assert L.sign(L.sqrt(square)) == 1
            assert L.sqrt(square) ** 2 == square
            if str(L) != "RR" and v.sign(x) > 0 and K.sqrt(x) is None:
                with pytest.raises(UndecidedError, match="is a square in"):
                    L.sqrt(L(x))
            if not K.is_zero(y):
                assert hilbert_symbol(x, y, v) == (-1 if v.sign(x) < 0 and v.sign(y) < 0 else 1)


@subcases("name", FIELDS[:-4])
def test_infinite_completions_are_read_back(name):
    K = ring(name)
    for v in islice(K.places(), 2):
        L = K.completion(v)
        assert ring(str(L)) == L == K.completion(str(v))
        assert pickle.loads(pickle.dumps(L)) == L
        x = L("1/2") * L.gen if L.gen_name and str(L) != "CC" else L("1/2")
        assert L(L.text(x)) == x


def test_what_is_not_in_the_number_field_is_undecided():
    L = ring("QQ[x]/(x^3-2)").completion("inf0")
    A = QuaternionAlgebra(L, "x+1", -1)
    assert not A.is_division_algebra()
    with pytest.raises(UndecidedError, match="only elements of that field have names"):
        A.zero_norm_element()
    assert QuaternionAlgebra(L, "x", -1).zero_norm_element().norm() == 0
    D = QuaternionAlgebra(L, -1, -1)
    assert D.is_isomorphic(QuaternionAlgebra(L, "-x", "-3"))
    f = QuaternionAlgebra(L, -4, "-x^2").isomorphism(D)
    i, j = (
        f(QuaternionAlgebra(L, -4, "-x^2").basis[1]),
        f(QuaternionAlgebra(L, -4, "-x^2").basis[2]),
    )
    assert (i * i, j * j) == (-4, D("-x^2"))
    assert list(D("-x^2").square_roots())
    with pytest.raises(UndecidedError, match="2 is a square"):
        D("2").square_roots()


def test_elements_and_places_of_other_fields_are_refused():
    K = ring("QQ[x]/(x^3-2)")
    L, M = (K.completion(v) for v in K.infinite_places())
    with pytest.raises(CoercionError, match="inf0 and"):
        L("x") + M("x")
    with pytest.raises(CoercionError):
        L(ring("QQ(zeta5)").gen)
    with pytest.raises(RingError, match="has one place, inf0"):
        hilbert_symbol(L(-1), L(-1), "inf1")
    with pytest.raises(RingError, match="not a single place"):
        K.completion("inf2")
    assert hilbert_symbol(L(-1), L("-x"), None) == -1
    assert hilbert_symbol(M(-1), M("-x"), "inf1") == 1
