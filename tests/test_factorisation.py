"""Factorisation and primality, on numbers that other tests of primality take for primes."""

import math
import pickle
import random
from itertools import count

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from hfield.core.factorisation import (
    SIEVED_BITS,
    Unfactored,
    UnfactoredError,
    _related,
    factor,
    factorise,
    known_primes,
    remove,
)
from hfield.core.primality import PROVED_BITS, is_prime, power_root, prime_power
from hfield.errors import RingError, TooLargeError, UndecidedError
from tests.subcases import subcases

# Composite: Carmichael numbers, strong pseudoprimes to the first 12 and 13 primes (Sorenson and Webster),
# Arnault's to all bases below 307 (Math. Comp. 64, 1995) and Bleichenbacher's to all below 100.
P1 = int(
    "29674495668685510550154174642905332730771991799853043350995075531276838753171770199594238596428121188033664754218345562493168782883"
)
PSEUDOPRIMES = [
    561,
    1729,
    3215031751,
    56052361,
    9746347772161,
    1436697831295441,
    60977817398996785,
    341550071728321,
    3825123056546413051,
    318665857834031151167461,
    3317044064679887385961981,
    68528663395046912244223605902738356719751082784386681071,
    (2**61 - 1) * 3317044064679887385961981,
    P1 * (313 * (P1 - 1) + 1) * (353 * (P1 - 1) + 1),
]
PRIMES = [2, 3, 2**61 - 1, 2**89 - 1, 2**127 - 1, 10**40 + 121, 2**521 - 1, P1]

# Two primes of 30 digits each, and one of 40: nobody here factors a product of two of them.
P, Q, R = 10**29 + 319, 10**29 + 631, 10**39 + 3


def slow_prime(n):
    return n > 1 and all(n % d for d in range(2, math.isqrt(n) + 1))


def test_the_constants_are_what_they_are_taken_for():
    assert all(map(is_prime, (P, Q, R)))
    assert (P * Q).bit_length() > SIEVED_BITS


@subcases("n", PSEUDOPRIMES)
def test_no_pseudoprime_passes(n):
    assert not is_prime(n)
    found = factor(n)
    assert n not in found.primes
    assert math.prod(p**e for p, e in found.primes.items()) * getattr(found.rest, "value", 1) == n
    assert prime_power(n) is None
    with pytest.raises(RingError, match="is not a prime"), known_primes([n]):
        pass


@pytest.mark.parametrize("n", PRIMES)
def test_primes_pass(n):
    assert is_prime(n)
    assert factorise(n) == {n: 1}
    assert factorise(-(n**3)) == {n: 3}
    assert prime_power(n**5) == (n, 5)


def test_small_numbers():
    assert [n for n in range(-3, 3000) if is_prime(n)] == [n for n in range(3000) if slow_prime(n)]
    assert factorise(1) == factorise(-1) == {}


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(2, 10**14), min_size=1, max_size=4), st.integers(1, 3))
@example([3043148024355], 1)  # FLINT names 129763 before 91967
def test_products_come_apart(numbers, exponent):
    n = math.prod(numbers) ** exponent
    primes = factorise(n)
    assert math.prod(p**e for p, e in primes.items()) == n
    assert list(primes) == sorted(primes)
    assert all(map(is_prime, primes))


# ψ₁₃, the least strong pseudoprime to the first 13 bases (Sorenson and Webster 2017); one of 99 bits; and
# products (r·t + 1)(s·t + 1) of primes, of 91 to 176 bits.
@pytest.mark.parametrize(
    ("p", "q"),
    [
        (1287836182261, 2575672364521),
        (531099297693901, 1062198595387801),
        *(
            (r * t + 1, s * t + 1)
            for r, s, t in ((2, 1, 10**13 + 6300), (3, 2, 10**15), (63, 1, 10**14), (7, 4, 10**25))
            for t in [next(n for n in count(t, 2) if is_prime(r * n + 1) and is_prime(s * n + 1))]
        ),
    ],
)
def test_what_passes_for_a_prime_to_many_bases_comes_apart(p, q):
    assert _related(p * q) in (p, q)
    assert factorise(p * q) == {p: 1, q: 1}


def test_a_prime_that_flint_lists_twice_is_counted_once():
    n = 9973635480343987958685905367476122579200  # flint gives 8941 as two factors of exponent 1
    assert factorise(n)[8941] == 2
    assert math.prod(p**e for p, e in factorise(n).items()) == n
    assert factorise(2**30 * 1099514321351**2 * 16777259) == {2: 30, 1099514321351: 2, 16777259: 1}


@pytest.mark.parametrize(
    ("n", "primes", "rest"),
    [
        (P * Q, {}, P * Q),
        (12 * P * P * Q, {2: 2, 3: 1}, P * P * Q),
        (7**4 * (P * Q) ** 2, {7: 4}, (P * Q) ** 2),
        (1000003 * (P * R) ** 3, {1000003: 1}, (P * R) ** 3),
        (P * P, {P: 2}, None),
        (10 * P**3, {2: 1, 5: 1, P: 3}, None),
        (P * 10**12, {2: 12, 5: 12, P: 1}, None),
    ],
)
def test_what_is_not_factored_is_no_number(n, primes, rest):
    found = factor(n)
    assert dict(found.primes) == primes
    assert found.rest == (None if rest is None else Unfactored(rest))
    if rest is None:
        assert factorise(n) == primes
        return
    with pytest.raises(TypeError):
        found.rest * 2
    with pytest.raises(TypeError):
        int(found.rest)
    with pytest.raises(UnfactoredError, match="is composite and has no small factor") as caught:
        found.complete()
    assert caught.value.rest == found.rest
    assert isinstance(caught.value, UndecidedError)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def test_known_primes_are_used_and_asked_for():
    assert factorise(P * Q * 4, [P]) == {2: 2, P: 1, Q: 1}
    with known_primes({P: 1}):
        assert factorise(P**2 * Q) == {P: 2, Q: 1}
        with known_primes(None, "--other"), pytest.raises(UnfactoredError, match="factors="):
            factorise(R * Q)
        with known_primes([R]):
            assert factorise(P * Q * R * R) == {P: 1, Q: 1, R: 2}
    with pytest.raises(UnfactoredError) as caught:
        factorise(P * Q)
    assert "factors" not in str(caught.value)
    with known_primes(None, "--factors"), pytest.raises(UnfactoredError, match="--factors"):
        factorise(P * Q)
    for wrong in (P * Q, 0, -3, 1, "x", 2.5, None, P + 0.5):
        with pytest.raises(RingError, match="is not a prime"), known_primes([wrong]):
            pass


def test_too_long_to_be_proved():
    n = 2**1279 - 1  # a prime of Mersenne
    assert n.bit_length() > PROVED_BITS
    with pytest.raises(TooLargeError, match="1024 bits"):
        is_prime(n)
    assert factor(6 * n).rest == Unfactored(n)
    with pytest.raises(UnfactoredError, match="not proved prime"):
        factorise(n)
    assert not is_prime(2**1277 - 1)
    with pytest.raises(TooLargeError):
        is_prime(3**9000 + 2)
    assert factorise(3**9000 * 7) == {3: 9000, 7: 1}
    assert "too long" in str(factor(3**9000 + 2).rest)


def test_roots_and_valuations():
    rng = random.Random(1)
    for _ in range(200):
        p, k = rng.randrange(2, 10**6), rng.randrange(1, 9)
        r, n = power_root(p**k)
        assert r**n == p**k
        assert n % k == 0
        m = rng.randrange(1, 10**9)
        v, u = remove(m * p**k, p)
        assert u * p**v == m * p**k
        assert u % p
