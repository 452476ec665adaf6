"""Ideals of GF(q)[t], fractional ones too, by their generators."""

import pickle
from fractions import Fraction

import pytest

from hfield import ring
from hfield.errors import CoercionError, HFieldError


@pytest.mark.parametrize("name", ["GF(2)(t)", "GF(3)(t)", "GF(9)(t)"])
def test_ideals_satisfy_their_laws(name: str) -> None:
    F = ring(name)
    q = F.base.order
    a, b, c = F.ideal("t*(t+1)"), F.ideal("(t+1)^2/t"), F.ideal("1/(t^2+t)")
    assert a + b == F.ideal("(t+1)/t")
    assert a & b == F.ideal("t*(t+1)^2")
    assert (a + b) * (a & b) == a * b
    assert a * a.inverse() == 1 == a * c
    assert a**-2 * a == c
    assert (a + b) + c == a + (b + c)
    assert [x.norm() for x in (a, b, c)] == [q**2, q, Fraction(1, q**2)]
    assert b.valuation("t") == -1
    assert (a.is_integral(), b.is_integral()) == (True, False)
    assert F("t^2+t") in a
    assert F("t") not in a
    assert 0 in b
    assert dict(b.factorisation()) == {F.ideal("t+1"): 2, F.ideal("t"): -1}
    for x in (a, b, c):
        assert F.ideal(str(x)) == x == pickle.loads(pickle.dumps(x))
        assert F.ideal(x.generator) == x
        assert x.generator.num.leading_coefficient() == 1
    P = next(v for v in F.places() if v.poly is not None)
    assert F.ideal(P).norm() == P.norm() == q


def test_other_values_are_refused() -> None:
    F = ring("GF(3)(t)")
    for x in (0, [], "u", ring("GF(5)(t)").ideal("t"), next(iter(F.places()))):
        with pytest.raises(HFieldError):
            F.ideal(x)
    with pytest.raises(CoercionError, match="q finite"):
        ring("QQ(t)").ideal("t")
