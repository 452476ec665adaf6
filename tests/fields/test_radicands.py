"""Square roots of integers that are large, or that nobody factors: the laws, and ball arithmetic."""

import math
import random

import flint
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from hfield.errors import CoercionError, NotInvertibleError, RingError, TooLargeError
from hfield.fields.algebraic.radicands import independent, odd, product, ratio, reduced
from hfield.fields.algebraic.ring import CC, RR
from hfield.fields.algebraic.surds import Surd
from hfield.fields.names import ring
from tests.subcases import subcases
from tests.thorough import cases

# Primes of 30 and 40 digits: a product of two is not factored (see tests/test_factorisation.py).
P, Q, R, S = 10**29 + 319, 10**29 + 631, 10**39 + 3, 10**39 + 391
BITS = 4000

PRIMES = st.sampled_from([2, 3, 5, 7, 1000003, 16777259, 1099514321351, P, Q, R, S])
RADICANDS = st.builds(math.prod, st.lists(PRIMES, max_size=5)).flatmap(
    lambda n: st.sampled_from([n, -n])
)


def approximate(x, tree):
    """Whether x is what the function ``tree`` gives in flint's complex balls."""
    with flint.ctx.workprec(BITS):
        return abs(x.ball(BITS) - tree()) < flint.arb(2) ** (-BITS // 4)


def root(n):
    return flint.acb(n).sqrt()


@pytest.mark.slow
@settings(max_examples=cases(120), deadline=None)
@given(RADICANDS, RADICANDS)
@example(2 * 1099514321351**2 * R, R)  # nobody finds the square in m, but in m/n
def test_roots_multiply(m, n):
    x, y = CC.sqrt(CC(m)), CC.sqrt(CC(n))
    assert x * x == m
    assert approximate(x, lambda: root(m))
    assert approximate(x * y, lambda: root(m) * root(n))
    assert x * y * x * y == m * n
    together = CC.sqrt(CC(m * n))
    assert together == (-(x * y) if m < 0 and n < 0 else x * y)
    assert hash(together) == hash(-(x * y) if m < 0 and n < 0 else x * y)
    assert (x == y) == (m == n)
    assert (x - y == 0) == (m == n)
    assert (x + y).is_rational() == (math.isqrt(abs(m * n)) ** 2 == m * n and x.is_rational())
    assert x + y == 0 or (x + y) * CC.inverse(x + y) == 1


@settings(max_examples=cases(120), deadline=None)
@given(st.lists(st.tuples(st.integers(-9, 9), RADICANDS), min_size=1, max_size=3))
def test_sums_and_inverses(terms):
    x = sum((CC(c) * CC.sqrt(CC(n)) for c, n in terms), CC(0))

    def tree():
        return sum((c * root(n) for c, n in terms), flint.acb(0))

    assert approximate(x, tree)
    with flint.ctx.workprec(BITS):
        assert (x == 0) == bool(abs(tree()) < flint.arb(2) ** (-BITS // 4))
    if x == 0:
        with pytest.raises(NotInvertibleError):
            CC.inverse(x)
    else:
        y = CC.inverse(x)
        assert x * y == 1
        assert approximate(y, lambda: 1 / tree())


@settings(max_examples=cases(120), deadline=None)
@given(
    st.sampled_from([2, -1, -7, 1000003, -16777259, 10**40 + 121, 6 * 1099514321351]),
    st.integers(-(10**40), 10**40),
    st.integers(-(10**40), 10**40),
    st.sampled_from([1, 2, 12, 10**12 + 39, P]),
)
def test_squares_in_quadratic_fields_have_their_roots(d, a, b, denominator):
    F = ring(f"QQ(sqrt({d}))")
    x = (a + b * F.gen) * F.inverse(F(denominator))
    y = F.sqrt(x * x)
    assert y in (x, -x)
    near = F.sqrt(x * x + 1)
    assert near is None or near * near == x * x + 1
    assert F.sqrt(x * x * d) in (x * F.gen, -x * F.gen)
    if x != 0:
        assert F.sqrt(x * x * 11) is None


def test_a_square_root_is_not_lost_or_invented():
    F = ring("QQ(sqrt(1000003))")
    x = F("10**20+1+(10**20+3)*sqrt(1000003)")
    assert F.sqrt(x * x) == x
    rng = random.Random(4)
    for _ in range(
        300
    ):  # against norms: a square has a norm that is one, and a half of its trace …
        a, b = rng.randrange(-99, 99), rng.randrange(-99, 99)
        y = F(a) + F(b) * F.gen
        found = F.sqrt(y)
        squares = {(u * u + 1000003 * v * v, 2 * u * v) for u in range(12) for v in (-1, 0, 1)}
        assert (found is not None) == ((a, b) in squares)


@subcases("p", [1099514321351, P, R, 10**60 + 7])
@subcases("q", [2, 16777259, Q, 3 * S])
def test_a_square_under_a_root_comes_out(p, q):
    assert RR(f"sqrt({p * p * q})") == p * RR(f"sqrt({q})")
    assert RR(f"sqrt({2**30 * p * p * q})") == 2**15 * p * RR(f"sqrt({q})")
    assert RR(f"sqrt({p * p * q})") != p * RR(f"sqrt({q})") + RR(1) / RR(10**200)
    assert RR(f"sqrt({p * p * q})*sqrt({q})") == p * q
    assert (RR(f"sqrt({p * p * q})") / RR(f"sqrt({q})")).is_rational()
    assert RR(f"sqrt({p * q})*sqrt({p})") == p * RR(f"sqrt({q})")
    assert RR(f"1/(sqrt({p * q})+sqrt({p})+1)*(sqrt({p * q})+sqrt({p})+1)") == 1
    assert {RR(f"sqrt({p * p * q})"): 1}[p * RR(f"sqrt({q})")] == 1


def test_nested_roots_of_large_numbers():
    x = RR(f"sqrt({P * Q})+sqrt({R})")
    assert RR.sqrt(x * x) == x
    y = CC(f"sqrt({-P * Q})+{S}")
    assert CC.sqrt(y * y) == y
    assert RR.sqrt(RR((P * Q) ** 2)) == P * Q
    assert RR(f"sqrt({P * Q + 1})") != RR(f"sqrt({P * Q})")
    assert RR(RR(f"sqrt({P * Q * Q * R})").text()) == Q * RR(f"sqrt({P * R})")


def test_fields_of_roots_are_known_or_refused():
    big = 10**60 + 7
    F = ring(f"QQ(sqrt({big}))")
    assert F(RR(f"sqrt({big * P * P})")) == P * F.gen
    assert F(f"sqrt({big * (P * Q) ** 2})") == P * Q * F.gen
    with pytest.raises(CoercionError):
        F(RR(f"sqrt({P * Q})"))
    with pytest.raises(RingError, match="composite and has no small factor"):
        ring(f"QQ(sqrt({P * Q}))")
    assert ring(f"QQ(sqrt({7 * (P * Q) ** 2}))") == ring("QQ(sqrt(7))")
    with pytest.raises(RingError, match="is a square"):
        ring(f"QQ(sqrt({(P * Q) ** 2}))")


@settings(max_examples=cases(200), deadline=None)
@given(RADICANDS, RADICANDS)
def test_square_classes(m, n):
    s, f = reduced(m)
    assert s * s * f == m
    assert (f == 1) == (m > 0 and math.isqrt(m) ** 2 == m)
    same = m * n > 0 and math.isqrt(m * n) ** 2 == m * n
    found = ratio(m, n)
    assert (found is not None) == same
    if found:
        u, v = found
        assert u * u * n == v * v * m
    c, r = product(reduced(m)[1], reduced(n)[1])
    assert c * c * r == reduced(m)[1] * reduced(n)[1]
    assert (abs(r) == 1) == (math.isqrt(abs(m * n)) ** 2 == abs(m * n))


@settings(max_examples=cases(120), deadline=None)
@given(st.lists(RADICANDS, max_size=4))
def test_independent_numbers_generate_the_classes(radicands):
    base = independent(frozenset(radicands))
    assert all(math.gcd(x, y) == 1 for i, x in enumerate(base) for y in base[:i])
    assert all(math.isqrt(b) ** 2 != b for b in base)
    for n in radicands:
        rest = abs(n) * math.prod(b for b in base if odd(abs(n), b))
        assert math.isqrt(rest) ** 2 == rest


def test_short_radicands_stay_canonical():
    assert RR("sqrt(12)").terms == {3: flint.fmpq(2)}
    assert isinstance(RR("sqrt(8)*sqrt(3)"), Surd)
    assert RR("sqrt(8)*sqrt(3)").terms == {6: flint.fmpq(2)}


def test_a_root_of_many_long_roots_is_refused_and_not_factored():
    """Sympy tried to factor what is under them: that took for ever, or an OverflowError passed through."""
    x = RR(f"sqrt({4 * P * Q * R})") - RR(f"sqrt({P**3 * S})") + RR(f"sqrt({5 * Q * R * S})")
    with pytest.raises(TooLargeError, match="root of a sum"):
        RR.sqrt(x * x)
