from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hfield.algebra.structure.hurwitz import (
    HAMILTON,
    divide,
    four_squares,
    gcd,
    is_hurwitz,
    lipschitz_associate,
    nearest,
)
from hfield.core.product import multiply, norm
from hfield.errors import CoercionError, NotInvertibleError
from tests.steps import steps

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
