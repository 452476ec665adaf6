"""Norms, traces and coordinates over ℚ have the operations of ints and Fractions."""

import math
import numbers
import operator
import pickle
import statistics
from fractions import Fraction

import flint
import numpy as np
import pytest

from hfield import QQ, CoercionError, H, QuaternionAlgebra, ring
from hfield.fields.rationals.rational_numbers import RationalNumber

VALUES = [Fraction(n, d) for n in (-7, -2, 0, 1, 3, 12) for d in (1, 2, 5)]
BINARY = [
    operator.add, operator.sub, operator.mul, operator.truediv, operator.floordiv, operator.mod, divmod,
    operator.eq, operator.ne, operator.lt, operator.le, operator.gt, operator.ge,
]  # fmt: skip


def outcome(f, *arguments):
    """Return what a function returns, or the type of its error."""
    try:
        return f(*arguments)
    except (ZeroDivisionError, TypeError, ValueError) as error:
        return type(error)


@pytest.mark.parametrize("f", BINARY, ids=lambda f: f.__name__)
def test_operations_are_those_of_fractions(f) -> None:
    for x in VALUES:
        for y in VALUES:
            expected = outcome(f, x, y)
            left, right = (
                RationalNumber(*x.as_integer_ratio()),
                RationalNumber(*y.as_integer_ratio()),
            )
            others = [y, right, *([int(y)] if y.denominator == 1 else [])]
            for other in others:
                assert outcome(f, left, other) == expected, (f, x, other)
            for other in [x, *([int(x)] if x.denominator == 1 else [])]:
                assert outcome(f, other, right) == expected, (f, other, y)


@pytest.mark.parametrize(
    "f",
    [hash, int, float, abs, bool, round, math.floor, math.ceil, math.trunc, Fraction, operator.neg,
     operator.pos, lambda x: x**3, lambda x: x.as_integer_ratio(), lambda x: (x.numerator, x.denominator)],
)  # fmt: skip
def test_functions_are_those_of_fractions(f) -> None:
    for x in VALUES:
        own = RationalNumber(x.numerator, x.denominator)
        assert f(own) == f(x)
        assert pickle.loads(pickle.dumps(own)) == x


@pytest.mark.parametrize(
    "f",
    [operator.index, lambda n: pow(n, -1, 11), lambda n: pow(n, 5, 11), lambda n: math.gcd(n, 12), math.isqrt,
     lambda n: 2**n, lambda n: [*range(n)], lambda n: "abcdefghijklmnop"[n], lambda n: f"{n:x}",
     lambda n: {15: "found"}[n], lambda n: n % 2, lambda n: n.is_integer()],
)  # fmt: skip
def test_an_integral_one_serves_as_an_int(f) -> None:
    assert f(RationalNumber(15)) == (True if f(RationalNumber(15)) is True else f(15))


@pytest.mark.parametrize("f", [operator.index, lambda x: pow(x, -1, 7), lambda x: 2**x, range])
def test_a_fraction_does_not(f) -> None:
    with pytest.raises(TypeError, match="7/2 is not an integer"):
        f(RationalNumber(7, 2))


@pytest.mark.parametrize(
    "f", [operator.eq, operator.ne, operator.lt, operator.le, operator.gt, operator.ge]
)
def test_floats_are_compared_exactly(f) -> None:
    floats = [-1.0, 0.0, -0.0, 0.2, 0.5, 3.0, math.inf, -math.inf, math.nan]
    for x in VALUES:
        own = RationalNumber(x.numerator, x.denominator)
        for y in floats:
            assert (f(own, y), f(y, own)) == (f(x, y), f(y, x)), (x, y)


def test_real_numbers_of_python_are_complex() -> None:
    x = RationalNumber(7, 2)
    assert isinstance(x, numbers.Rational)
    assert (x.real, x.imag, x.conjugate()) == (x, 0, x)


def test_numbers_of_numpy_within_fractions() -> None:
    three = Fraction(np.int64(3))  # its numerator stays numpy's
    x = RationalNumber(7, 2)
    assert RationalNumber(3) == three
    assert x + three == three + x == Fraction(13, 2)
    assert x // three == 1


def test_what_users_get_is_of_this_kind() -> None:
    A = QuaternionAlgebra("QQ", -1, -11)
    q = A("1/2 + i")
    ideal = A.maximal_order().random_ideal(15, seed=1)
    for x in (
        q.norm(),
        q.trace(),
        *q.coordinates,
        ideal.norm(),
        (ideal / 2).norm(),
        ideal.gram_matrix()[0][1],
    ):
        assert isinstance(x, RationalNumber)
        assert x % 1 == Fraction(x) % 1
        assert QQ(x) == x
        assert x * q == q * Fraction(x)
    assert isinstance(H("QQ")(1, 1, 0, 0).norm() * 2 / 3, RationalNumber)


@pytest.mark.parametrize("n", [RationalNumber(2), np.int64(2), flint.fmpz(2)])
def test_integers_of_other_kinds_are_exponents(n) -> None:
    q, K = H("QQ")(1, 2, 3, 4), ring("QQ(sqrt(-5))")
    ideal = K.ideal(2, "1+sqrt(-5)")
    for x in (q, K.gen, ideal):
        assert x**n == x**2 == x * x
    with pytest.raises(CoercionError, match="is not a number"):
        q ** "2"
    with pytest.raises(TypeError):
        K.gen ** Fraction(1, 2)


def test_means_and_formats_of_norms():
    norms = [H(QQ)(1, 2, 3, 4).norm(), H(QQ)("1/2").norm()]
    assert statistics.mean(norms) == Fraction(121, 8)
    assert type(RationalNumber(Fraction(1, 3))) is RationalNumber
    assert f"{norms[0]:.1f} {norms[0] / 7:.3f} {norms[1]:>5}" == "30.0 4.286   1/4"
