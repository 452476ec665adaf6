from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from structure_cases import cases

from hfield.errors import CoercionError, NotFiniteError, NotInvertibleError
from hfield.product import Constants, multiply, norm
from hfield.structure.hilbert import discriminant_q, ramified_places_q
from hfield.structure.hurwitz import (
    HAMILTON,
    divide,
    four_squares,
    gcd,
    is_hurwitz,
    lipschitz_associate,
    nearest,
)
from hfield.structure.orders import hurwitz_order, lipschitz_order, maximal_order
from tests.steps import steps


def test_lipschitz_and_hurwitz():
    lipschitz, hurwitz = lipschitz_order(HAMILTON), hurwitz_order(HAMILTON)
    assert (lipschitz.discriminant, hurwitz.discriminant) == (4, 2)
    assert (len(lipschitz.units()), len(hurwitz.units())) == (8, 24)
    half = Fraction(1, 2)
    assert (half, half, -half, half) in hurwitz
    assert (half, half, -half, half) not in lipschitz
    assert (half, 0, 0, half) not in hurwitz
    units = set(hurwitz.units())
    assert {multiply(HAMILTON, u, v) for u in units for v in units} == units


def test_maximal_orders_have_the_discriminant_of_the_algebra():
    for case in cases("ramification")[::4]:
        order = maximal_order(Constants(int(case["a"]), 0, int(case["b"])))
        assert order.discriminant == case["discriminant"], case
        assert order.is_order


nonzero = st.builds(Fraction, st.integers(-60, 60).filter(bool), st.integers(1, 12))


@given(nonzero, st.integers(-3, 3), nonzero)
@settings(deadline=None)
def test_maximal_orders_of_any_constants(a, t, b):
    if t * t + 4 * a == 0:
        return
    order = maximal_order(Constants(a, t, b))
    assert order.discriminant == discriminant_q(ramified_places_q(a + Fraction(t * t, 4), b))
    assert order.is_order


@pytest.mark.parametrize(
    ("a", "b", "units"), [(-1, -1, 24), (-1, -3, 12), (-2, -5, 6), (-1, -7, 4), (-1, -11, 4)]
)
def test_units_of_definite_maximal_orders(a, b, units):
    order = maximal_order(Constants(a, 0, b))
    found = order.units()
    assert len(found) in {units, 6, 4, 2}  # an order of another class may have fewer
    assert all(norm(order.constants, u) == 1 and u in order for u in found)
    assert (a, b) not in {(-1, -1), (-1, -3)} or len(found) == units  # class number one


def test_units_where_the_coefficients_are_large():
    order = maximal_order(Constants(-(2**521 - 1), 0, -3))
    assert len(order.units()) == 12
    assert steps(order.units) < 100_000


def test_what_has_no_orders_or_infinitely_many_units():
    with pytest.raises(NotFiniteError, match="indefinite"):
        maximal_order(Constants(2, 0, 3)).units()
    with pytest.raises(CoercionError, match="degenerate"):
        maximal_order(Constants(0, 0, 3))
    with pytest.raises(CoercionError, match="integers"):
        lipschitz_order(Constants(Fraction(1, 2), 0, 3))
    with pytest.raises(CoercionError, match="Hurwitz"):
        hurwitz_order(Constants(-1, 0, -2))


hurwitz_numbers = st.tuples(*[st.integers(-40, 40)] * 4, st.booleans()).map(
    lambda v: tuple(Fraction(2 * x + v[4], 2) for x in v[:4])
)


@given(hurwitz_numbers, hurwitz_numbers.filter(any), st.sampled_from(["left", "right"]))
def test_division_with_remainder(a, b, side):
    q, r = divide(a, b, side)
    product = multiply(HAMILTON, q, b) if side == "right" else multiply(HAMILTON, b, q)
    assert tuple(x + y for x, y in zip(product, r, strict=True)) == a
    assert is_hurwitz(q)
    assert is_hurwitz(r)
    assert 2 * norm(HAMILTON, r) <= norm(HAMILTON, b)


@given(hurwitz_numbers.filter(any), hurwitz_numbers.filter(any), hurwitz_numbers.filter(any))
def test_common_divisors(a, b, d):
    p, q = multiply(HAMILTON, a, d), multiply(HAMILTON, b, d)
    g = gcd(p, q)
    for multiple in (p, q):
        assert not any(divide(multiple, g)[1])
    assert norm(HAMILTON, g) % norm(HAMILTON, d) == 0
    assert all(x.denominator == 1 for x in lipschitz_associate(g))


def test_hurwitz_errors():
    half = Fraction(1, 2)
    with pytest.raises(CoercionError, match="Hurwitz"):
        gcd((half, 0, 0, 0), (1, 0, 0, 0))
    with pytest.raises(NotInvertibleError):
        divide((1, 0, 0, 0), (0, 0, 0, 0))
    assert nearest((half, half, half, Fraction(2, 5))) == (half, half, half, half)


def test_four_squares():
    for n in (*range(300), 2**61, 3**40, 7 * 4**20, 10**30 + 7):
        squares = four_squares(n)
        assert sum(x * x for x in squares) == n
        assert tuple(sorted(squares, reverse=True)) == squares
    for n in (10**60 + 7, 10**60 - 1, 8 * (10**59 + 9)):
        assert sum(x * x for x in four_squares(n)) == n
        assert steps(lambda n=n: four_squares(n)) < 100_000
    for wrong in (-1, 1.5):
        with pytest.raises(CoercionError, match="integer ≥ 0"):
            four_squares(wrong)
