"""Ideals of number fields: identities of Dedekind domains, on random ideals."""

from math import prod
from random import Random

import pytest

from hfield import ring
from hfield.errors import RingError

FIELDS = ["QQ[s]/(s^4-s-1)", "QQ[s]/(s^3-s^2-2*s-8)", "QQ[s]/(2*s^3+s+5)", "QQ[s]/(s^6-3*s+7)",
          "QQ(sqrt(5))", "QQ(I)", "QQ(sqrt(-23))", "QQ(sqrt(10))"]  # fmt: skip


@pytest.mark.parametrize("name", FIELDS)
def test_dedekind(name: str) -> None:
    """Norms multiply, inverses invert, sum times intersection is the product; so are primes."""
    K, rng = ring(name), Random(name)
    one = K.ideal(1)
    for _ in range(6):
        a = K.ideal([K.random(rng), K.random(rng) + 1])
        b = K.ideal(K.random(rng) + 2)
        assert (a * b).norm() == a.norm() * b.norm()
        assert a * a**-1 == one == a / a
        assert a**-2 * a**3 == a
        assert (a + b) * (a & b) == a * b
        assert K.ideal(list(a.generators)) == a == K.ideal(list(a.basis))
        assert hash(K.ideal(list(a.generators))) == hash(a)
        assert all(x in a for x in a.basis)
        assert all(x * y in a * b for x in a.basis for y in b.basis)
        total = one
        for P, e in a.factorisation():
            assert a.valuation(P) == e
            total = total * K.ideal(P) ** e
        assert total == a


def test_primes_as_ideals() -> None:
    """The primes above p, to their ramification indices, multiply to p, also where s is not an integer."""
    for name in FIELDS:
        K = ring(name)
        for p in (2, 3, 5, 23):
            total = K.ideal(1)
            for P in K.primes_above(p):
                assert K.ideal(P).norm() == P.p**P.f
                total = total * K.ideal(P) ** P.e
            assert total == K.ideal(p)


def test_what_is_refused() -> None:
    """The zero ideal; ideals of another field."""
    K, L = ring("QQ(sqrt(5))"), ring("QQ(sqrt(2))")
    with pytest.raises(RingError, match="nonzero"):
        K.ideal(0)
    with pytest.raises(RingError, match="nonzero"):
        K.ideal([])
    with pytest.raises(RingError, match="not of"):
        K.ideal(L.ideal(2))
    assert K.ideal(2) != L.ideal(2)


def test_the_valuation_at_a_prime_of_another_field_is_refused() -> None:
    a = ring("QQ(sqrt(2))").ideal(6)
    others = [*ring("QQ(sqrt(7))").primes_above(3), *ring("QQ[s]/(s^3-2)").primes_above(3)]
    for P in (*others, *ring("QQ(sqrt(2))").real_places(), 3):
        with pytest.raises(RingError, match="not a prime ideal of QQ\\(sqrt\\(2\\)\\)"):
            a.valuation(P)


@pytest.mark.parametrize("name", ["QQ(sqrt(5))", "QQ[s]/(s^2-5)", "QQ(sqrt(-7))", "QQ[s]/(s^3-2)"])
def test_a_prime_has_the_norm_of_its_ideal(name: str) -> None:
    K = ring(name)
    for p in (2, 3, 5, 7, 11, 31):
        above = K.primes_above(p)
        assert [P.norm() for P in above] == [K.ideal(P).norm() for P in above]
        assert prod(P.norm() ** P.e for P in above) == p**K.degree
