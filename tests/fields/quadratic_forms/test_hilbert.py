import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hfield.core.factorisation import factorise
from hfield.errors import CoercionError, NotationError, RingError, UndecidedError
from hfield.fields.quadratic_forms import hilbert_symbol
from hfield.fields.rationals.symbols import (
    discriminant_q,
    from_ramification_q,
    hilbert_symbol_q,
    place_of_q,
    ramified_places_q,
)
from tests.fields.algebra_cases import cases
from tests.subcases import subcases

nonzero = st.integers(-(10**6), 10**6).filter(bool)
rationals = st.builds(Fraction, nonzero, st.integers(1, 1000))


def test_symbols_agree_with_pari():
    for case in cases("hilbert"):
        a, b = Fraction(case["a"]), Fraction(case["b"])
        assert hilbert_symbol_q(a, b, case["place"]) == case["value"], case


def test_ramification_agrees_with_pari():
    for case in cases("ramification"):
        places = ramified_places_q(int(case["a"]), int(case["b"]))
        assert list(places) == case["ramified"], case
        assert discriminant_q(places) == case["discriminant"]


@given(rationals, rationals)
def test_the_symbol_is_minus_one_exactly_at_the_ramified_places(a, b):
    primes = {2, *factorise((a * b).numerator), *factorise((a * b).denominator)}
    primes |= {*factorise(a.numerator), *factorise(a.denominator)}
    symbols = {v: hilbert_symbol_q(a, b, v) for v in (*primes, "inf")}
    assert math.prod(symbols.values()) == 1
    assert {v for v, s in symbols.items() if s < 0} == set(ramified_places_q(a, b))


@given(nonzero, nonzero, nonzero, st.sampled_from([2, 3, 5, 7, 101, "inf"]))
def test_the_symbol_is_bilinear_and_symmetric(a, b, c, v):
    symbol = hilbert_symbol_q
    assert symbol(a, b * c, v) == symbol(a, b, v) * symbol(a, c, v)
    assert symbol(a, b, v) == symbol(b, a, v)
    assert symbol(a, -a, v) == 1


@pytest.mark.parametrize(
    "primes", [[], [2, 3], [2], [3], [5, 7, 11], [10**9 + 7, 10**9 + 9], [2, 3, 5, 7, 11]]
)
def test_from_ramification(primes):
    infinite = len(primes) % 2 == 1
    a, b = from_ramification_q(primes, infinite)
    assert ramified_places_q(a, b) == (*sorted(primes), *(["inf"] if infinite else []))


def test_from_ramification_with_many_primes():
    primes = [p for p in range(2, 120) if all(p % q for q in range(2, p))]
    a, b = from_ramification_q(primes, len(primes) % 2 == 1)
    assert [v for v in ramified_places_q(a, b) if v != "inf"] == primes


@pytest.mark.parametrize(
    ("primes", "infinite", "message"),
    [
        ([2], False, "even number"),
        ([2, 3], True, "even number"),
        ([2, 4], False, "not a place"),
        ([2, 2], False, "twice"),
        (["inf"], False, "denied, or named twice"),
    ],
)
def test_from_ramification_says_what_is_wrong(primes, infinite, message):
    with pytest.raises(RingError, match=message):
        from_ramification_q(primes, infinite)


def test_two_hundred_digits_with_known_factors():
    p, q, r = (2**n - 1 for n in (127, 521, 89))
    assert len(str(p * q)) > 190
    places = ramified_places_q(-p * q, 3 * r, factors=[p, q, r])
    assert math.prod(hilbert_symbol_q(-p * q, 3 * r, v) for v in (2, 3, p, q, r, "inf")) == 1
    assert set(places) == {
        v for v in (2, 3, p, q, r, "inf") if hilbert_symbol_q(-p * q, 3 * r, v) < 0
    }
    with pytest.raises(UndecidedError, match="composite"):
        ramified_places_q(-(2**521 - 1) * (2**607 - 1), 3)
    with pytest.raises(RingError, match="not a prime"):
        ramified_places_q(15, 3, factors=[15])


@subcases("place", [1, 0, 4, -3, 6, "x", None, 2.5, True, "2x", 10**40])
def test_places_that_are_none(place):
    with pytest.raises(RingError, match="not a place"):
        hilbert_symbol_q(2, 3, place)


def test_places_have_several_spellings():
    assert [place_of_q(v) for v in ("inf", "oo", "∞", -1, math.inf, " 7 ", 7)] == ["inf"] * 5 + [
        7,
        7,
    ]


def test_arguments_that_are_none():
    with pytest.raises(RingError, match="nonzero"):
        hilbert_symbol_q(0, 3, 5)
    with pytest.raises(CoercionError, match="rational"):
        hilbert_symbol_q(0.5, 3, 5)


def test_factorisations_multiply_out():
    awkward = [9973635480343987958685905367476122579200, 9503871113452443690581764571495410503624]
    p = 2**89 - 1
    for n in (*awkward, awkward[0] * awkward[1] * p * p, 2**300 * 3**5, 360360**12, p**3):
        found = factorise(n)
        assert math.prod(q**e for q, e in found.items()) == n
        assert factorise(-n, [2, p]) == found


def test_texts_of_rationals_are_read() -> None:
    for a, b, place in (("1/2", "-1", 2), ("-3/4", "5", "inf"), ("1/2", "3", 3)):
        assert hilbert_symbol(a, b, place) == hilbert_symbol(Fraction(a), Fraction(b), place)
    with pytest.raises(NotationError, match="sqrt"):
        hilbert_symbol("sqrt(2)", 3, 3)
