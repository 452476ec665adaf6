"""Powers that would not end are refused, whatever the ring; what stays small has powers of any size."""

from fractions import Fraction

import numpy as np
import pytest

from hfield import H, ring
from hfield.errors import TooLargeError
from hfield.fields.base.powers import bits
from tests.subcases import first_quick, slow, subcases

HUGE = 10**30
INFINITE = (
    *("QQ", "ZZ", "RR", "CC", "QQ(sqrt(2))", "QQ(I)", "QQ(zeta5)", "QQ[x]/(x^3-2)", "QQ(x)"),
    *("QQ(sqrt(2), sqrt(3))", "Qp(5)", "ZZ[a,b]", "QQ[x]", "QQ(x,y)"),
)
FUNCTIONS = ("GF(2)(t)", "GF(9)(t)", "GF(5)[x]", "GF(3)(t)[u]/(u^2-t^3+t)")


@pytest.mark.slow
@subcases("field", INFINITE)
def test_powers_of_what_grows_are_refused(field):
    A = H(ring(field))
    for q in (A(2, 1, 0, 3), A(np.array([1, 2]), 0, 1, 3)):
        with pytest.raises(TooLargeError, match="too large"):
            q**HUGE
    with pytest.raises(TooLargeError, match="too large"):
        A.ring.power(A.ring(3), HUGE)


@pytest.mark.parametrize(
    "field", first_quick(["QQ", "QQ(I)", "RR", "QQ(zeta5)", "QQ(x)", "Qp(5)"], 2)
)
def test_negative_and_nested_powers_are_refused(field):
    A = H(ring(field))
    with pytest.raises(TooLargeError):
        A(2, 1, 0, 3) ** -HUGE
    with pytest.raises(TooLargeError):
        ((A(2, 1, 0, 0) ** 1000) ** 1000) ** 1000


@pytest.mark.parametrize(
    "field", first_quick(["QQ(x)", "QQ(x,y)", "ZZ[a,b]", "QQ[x]", *FUNCTIONS], 5)
)
def test_powers_of_a_variable_are_refused(field):
    F = ring(field)
    *_, t = F.names().values()
    for x in (t + 1, t * t + t + 1):
        with pytest.raises(TooLargeError):
            F.power(x, HUGE)


@subcases("field", [*INFINITE, *FUNCTIONS, "ZZ/6", "GF(7)", "GF(9)", "GF(2^64)"])
def test_powers_of_what_stays_small_are_computed(field):
    A = H(ring(field))
    i = A.basis[1]
    assert i ** (HUGE + 3) == -i == i ** -(HUGE + 1)
    assert A.ring.power(A.ring(-1), HUGE + 1) == A.ring(-1)
    assert (A(np.array([0, 0]), 1, 0, 0) ** HUGE == 1).all()


@pytest.mark.parametrize(
    "field", ["QQ", slow("RR"), "QQ(zeta5)", "QQ(x)", "QQ(x,y)", "QQ[x]", "GF(2)(t)"]
)
def test_powers_agree_with_products(field):
    F = ring(field)
    x = next(iter(F.names().values()), F(3)) + 1
    one = F.one
    product = one
    for n in range(20):
        assert F.equal(F.power(x, n), product)
        product = product * x
    q = H(F)(x, 1, 0, x)
    assert (q**20) * (q**17) == q**37


def test_a_nilpotent_part_grows_slowly():
    from hfield import QuaternionAlgebra

    A = QuaternionAlgebra(ring("QQ"), 0, 0)
    assert A(1, 1, 0, 0) ** HUGE == A(1, HUGE, 0, 0)


def test_long_powers_are_computed():
    q = H("QQ")(2, 1, 0, 0)
    assert (q**20_000).norm() == 5**20_000
    F = ring("GF(2)(t)")
    assert F.power(F.gen, 100_000).num.degree() == 100_000


def test_bits_of_a_sum_of_roots_count_its_numbers():
    R = ring("RR")
    assert bits(R(2) ** 400) > 400
    assert bits(R("root(2,3)") * 2**400) > 400


def test_a_fraction_takes_the_bits_of_both_its_parts():
    assert bits(Fraction(2**10, 3)) == 11 + 2 == bits(Fraction(3, 2**10))


def test_a_polynomial_takes_the_bits_of_all_its_exponents():
    assert bits(ring("ZZ[a,b]")("a*b**1000")) == 1 + 10 + 1
