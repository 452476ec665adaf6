"""Tensor products: against ramification, symbols, and the elements themselves."""

from itertools import combinations
from random import Random

import pytest

from hfield import (
    CoercionError,
    H,
    MixedParentsError,
    QuaternionAlgebra,
    ring,
)
from hfield.structure.norm_forms.residue_forms import no_zero


def over(primes):
    return QuaternionAlgebra.from_ramification("QQ", primes)


PAIRS = list(combinations([(2, 3), (2, 5), (3, 5), (7, "inf"), (), (2, "inf")], 2))


@pytest.mark.parametrize(("one", "other"), PAIRS)
def test_products_over_the_rationals(one, other):
    A, B = over(one), over(other)
    T = A.tensor(B)
    assert set(T.brauer_class) == set(one) ^ set(other)
    assert T.index == (1 if set(one) == set(other) else 2)
    a, x, y = T.common_slot
    assert x.algebra == A
    assert y.algebra == B
    assert x * x == a
    assert y * y == a
    assert x.trace() == y.trace() == 0


def test_products_elsewhere():
    A = H("GF(7)")
    assert (A.tensor(A).index, A.tensor(A).brauer_class) == (1, ())
    K = ring("QQ(sqrt(5))")
    T = H(K).tensor(QuaternionAlgebra(K, -1, -3))
    assert T.index in (1, 2)
    assert set(T.brauer_class) == set(H(K).ramified_places()) ^ set(T.second.ramified_places())
    R = H("RR").tensor(H("RR"))
    assert R.index == 1
    F = ring("QQ(x,y)")
    T = QuaternionAlgebra(F, "x", "y").tensor(QuaternionAlgebra(F, "x", "y+1"))
    a, x, y = T.common_slot
    assert T.index == 2
    assert x * x == a
    assert y * y == a
    S = QuaternionAlgebra("GF(3)(t)", "t", "t+1").tensor(QuaternionAlgebra("GF(3)(t)", "t", "-1"))
    assert S.index == 2
    assert S.common_slot[1] ** 2 == S.common_slot[0]


def test_what_is_refused():
    with pytest.raises(MixedParentsError):
        H("QQ").tensor(H("GF(3)"))
    with pytest.raises(CoercionError, match="not central simple"):
        H("GF(2)").tensor(H("GF(2)"))


@pytest.mark.parametrize(
    ("one", "other", "index"),
    [
        ((-1, "x"), (-3, "y"), 4),
        ((2, "x"), (3, "y"), 4),
        (("x", "y"), ("x+1", "y+1"), 4),
        ((-1, "x"), (-1, "y"), 2),
        (("x", "y"), ("x", "y"), 1),
    ],
)
def test_the_index_over_functions_of_two_variables(one, other, index):
    T = QuaternionAlgebra("QQ(x,y)", *one).tensor(QuaternionAlgebra("QQ(x,y)", *other))
    assert T.index == index
    if index == 4:
        assert T.common_slot is None
        assert "residue forms" in T.reason


def test_residue_forms_never_deny_a_zero():
    F, rng = ring("QQ(x,y)"), Random(3)
    entries = [F(t) for t in ("1", "-1", "2", "x", "y", "x+1", "x*y", "x-y", "y^2+1")]
    shown = 0
    for _ in range(60):
        form = [rng.choice(entries) * rng.choice((1, -1, 3)) for _ in range(rng.choice((3, 4, 5)))]
        reason = no_zero(F, form)
        shown += reason is not None
        # a form that represents what its last coefficient takes away has a zero
        v = [F(rng.choice(("0", "1", "x", "y-1"))) for _ in form]
        value = sum((c * x * x for c, x in zip(form, v, strict=True)), F.zero)
        if not F.is_zero(value):
            assert no_zero(F, [*form, -value]) is None
    assert shown > 10


def test_slots_exist_over_the_rationals_however_many_places_ramify():
    A, B = over((2, 3, 5, 7, 11, 13)), over((17, 19, 23, 29, 31, "inf"))
    a, x, y = A.tensor(B).common_slot
    assert (x * x, y * y) == (a, a)
