import itertools

import pytest
from structure_cases import cases, constants

from hfield.errors import CoercionError, NotFiniteError, TooLargeError
from hfield.rings import ring
from hfield.structure.counts import count
from hfield.structure.exhaust import confirm, tally

UP_TO_32 = [2, 3, 4, 5, 7, 8, 9, 11, 13, 16, 17, 19, 23, 25, 27, 29, 31, 32]


def test_formulas_agree_with_gap():
    for case in cases("finite_counts"):
        F, c = ring(case["ring"]), constants(case["ring"], case["a"], case["t"], case["b"])
        assert count(F, c, "elements").value == case["elements"]
        assert count(F, c, "norm").value == case["norm_zero"], case
        assert count(F, c, "nilpotent").value == case["nilpotent"], case
        assert count(F, c, "idempotent").value == case["idempotent"], case
        assert count(F, c, "units").value == case["unit"], case
        assert count(F, c, "square roots").value == case["sqrt_one"], case
        assert count(F, c, "square roots", -1).value == case["sqrt_minus_one"], case


@pytest.mark.parametrize("q", [2, 3, 4, 5, 8, 9])
def test_every_kind_of_algebra_is_confirmed_by_exhaustion(q):
    F = ring(f"GF({q})")
    some = list(itertools.islice(F.elements(), 3 if q > 4 else q))
    for a, t, b in itertools.product(some, repeat=3):
        confirm(F, constants(F.name, a, t, b))


def test_hamilton_up_to_32():
    for q in UP_TO_32:
        found = confirm(ring(f"GF({q})"), constants(f"GF({q})", -1, 0, -1))
        assert found.norms["0"] == (q**3 if q % 2 == 0 else q**3 + q**2 - q)


def test_residue_rings_are_counted_too():
    R, c = ring("ZZ/4"), constants("ZZ/4", -1, 0, -1)
    found = tally(R, c)
    assert found.elements == 256
    assert sum(found.norms.values()) == 256
    assert found.units == found.norms["1"] + found.norms["3"] == 128
    assert found.nilpotent == 128  # a local ring: what is no unit is nilpotent
    six = tally(ring("ZZ/6"), constants("ZZ/6", -1, 0, -1))
    assert six.units == 8 * 48  # units modulo 2 times units modulo 3
    assert six.idempotent == 2 * 14


def test_formulas_are_texts():
    c = constants("GF(9)", -1, 0, -1)
    assert count(ring("GF(9)"), c, "norm") == (801, "q^3+q^2-q")
    assert count(ring("GF(9)"), c, "units").formula == "q^4-(q^3+q^2-q)"
    big = ring("GF(101^5)")
    assert count(big, constants(big.name, -1, 0, -1), "norm").value > 10**30


def test_what_cannot_be_counted():
    with pytest.raises(NotFiniteError, match="not a finite field"):
        count(ring("QQ"), constants("QQ", -1, 0, -1), "norm")
    with pytest.raises(NotFiniteError, match="infinite"):
        tally(ring("QQ"), constants("QQ", -1, 0, -1))
    with pytest.raises(CoercionError, match="no count of 'zeros'"):
        count(ring("GF(3)"), constants("GF(3)", -1, 0, -1), "zeros")
    with pytest.raises(TooLargeError, match="formulas"):
        tally(ring("GF(101)"), constants("GF(101)", -1, 0, -1))
