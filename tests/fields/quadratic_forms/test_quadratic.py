import itertools
import random
from fractions import Fraction

import pytest

from hfield.core.product import norm
from hfield.errors import CoercionError, RingError, UndecidedError
from hfield.fields import RR
from hfield.fields.names import ring
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.quadratic.symbols import (
    hilbert_symbol_quadratic,
    ramified_places_quadratic,
)
from hfield.fields.quadratic_forms import hilbert_symbol, is_division, zero_norm
from hfield.fields.quadratic_forms.ramification import place, places, ramified_places
from tests.fields.algebra_cases import cases, constants
from tests.subcases import subcases


def test_division_agrees_with_pari():
    for case in cases("quadratic_division"):
        c = constants(case["ring"], case["a"], 0, case["b"])
        assert is_division(ring(case["ring"]), c) == case["division"], case


@subcases("d", [-1, -2, -3, -5, -7, -15, 2, 3, 5, 17, 33, 30])
def test_symbols_multiply_to_one_and_split_algebras_have_zero_divisors(d):
    F = ring(f"QQ(sqrt({d}))")
    rng = random.Random(d)
    for _ in range(15):
        a, b = F(rng.randint(-9, 9)) + F.gen * rng.randint(-3, 3), F.random(rng)
        if F.is_zero(a) or F.is_zero(b):
            continue
        c = constants(F.name, a, 0, b)
        ramified = ramified_places(F, c)
        assert len(ramified) % 2 == 0
        assert all(hilbert_symbol(a, b, v) == -1 for v in ramified)
        answer = zero_norm(F, c)
        assert bool(answer) == (not ramified) == (not is_division(F, c))
        if answer.element is not None:
            assert F.is_zero(norm(c, answer.element))


def test_a_rational_algebra_ramifies_where_its_places_do_not_split_it():
    # (2, 5 | ℚ) ramifies at 2 and 5; √−1 splits it at 2 and not at 5, which splits in ℚ(i)
    F = ring("QQ(I)")
    assert [str(v) for v in ramified_places(F, constants("QQ(I)", 2, 0, 5))] == [
        "(5, I-2)",
        "(5, I-3)",
    ]
    assert not is_division(ring("QQ(sqrt(2))"), constants("QQ(sqrt(2))", 2, 0, 5))


def test_every_place_reads_back():
    for name in ("QQ", "QQ(I)", "QQ(sqrt(17))", "QQ(sqrt(-7))", "GF(2)(t)", "GF(9)(t)"):
        F = ring(name)
        listed = list(itertools.islice(places(F), 12))
        assert [place(F, str(v)) for v in listed] == listed
        assert [place(F, v) for v in listed] == listed
        assert len(set(listed)) == 12


@pytest.mark.parametrize("text", ["6", "1", "x", "(7, sqrt(2)-1)", "7", "inf", "", "-1", 4])
def test_what_is_no_place_of_a_real_field(text):
    # 7 splits in ℚ(√2), and there are two real places: such a text names no single place
    with pytest.raises(RingError, match="place"):
        place(ring("QQ(sqrt(2))"), text)


def test_symbols_of_surds_find_their_field():
    F = ring("QQ(sqrt(2))")
    assert hilbert_symbol(F.gen, -1, "inf-") == -1
    assert hilbert_symbol(F.gen, -1, "inf+") == 1
    assert hilbert_symbol(-1, -1, place(F, "inf+")) == -1
    with pytest.raises(RingError, match="no common"):
        hilbert_symbol(RR("sqrt(2)"), RR("sqrt(3)"), 5)
    assert hilbert_symbol(RR("sqrt(2)"), -1, "inf-") == -1
    with pytest.raises(CoercionError, match="different rings do not mix"):
        hilbert_symbol(F.gen, ring("QQ(sqrt(3))").gen, 5)
    with pytest.raises(RingError, match="nonzero"):
        hilbert_symbol(F.gen, 0, "inf+")


def test_no_places_elsewhere():
    with pytest.raises(UndecidedError, match="not a global field"):
        next(places(ring("RR")))
    with pytest.raises(RingError, match="not a global field"):
        place(ring("RR"), "inf")


def test_the_lone_place_above_two_goes_by_the_product_formula():
    x = (Fraction(-1), Fraction(0))
    assert hilbert_symbol_quadratic(QuadraticField(-3), x, x, "2") == 1
    assert [str(v) for v in ramified_places_quadratic(QuadraticField(5), x, x)] == ["inf+", "inf-"]
