"""Isomorphisms over number fields, checked, and maximal orders of algebras made from their ramification."""

import random
from itertools import takewhile

import flint
import pytest

from hfield import QuaternionAlgebra, ring
from hfield.core.primality import WORD, power_root, primes
from hfield.fields.number_fields import unimodular_lattice
from hfield.fields.number_fields.prime_ideals import primes_above
from hfield.fields.number_fields.symbols import candidates
from hfield.fields.number_fields.unimodular_lattice import unimodular_module
from tests.thorough import cases

FIELDS = [
    "QQ[s]/(s^4-5*s^2+5)", "QQ[s]/(s^5-s-1)", "QQ[s]/(s^6+2*s+2)", "QQ[s]/(s^8-2*s^7+4*s^5-4*s^4+3*s^2-2*s+1)"
]  # fmt: skip

# an overflow of floats, a norm that nobody factored and a division by infinity, each on the way to a map
HARD = [
    ("QQ[s]/(s^6+2*s+2)", "-3+3*s+3*s^2-s^3-2*s^4-s^5", "-3+3*s+s^2-2*s^3-s^4-s^5",
     "-5+31*s+38*s^2-26*s^3-10*s^4+23*s^5", "-3+5*s+9*s^2+20*s^3+20*s^4+2*s^5"),
    ("QQ[s]/(s^6+2*s+2)", "-2-s-2*s^2+2*s^3-2*s^4+3*s^5", "-s-3*s^2+3*s^4+s^5",
     "-86-138*s+69*s^2+250*s^3+125*s^4+8*s^5",
     "5992720+8971160*s+3204324*s^2-1323500*s^3-3702052*s^4-4014052*s^5"),
    ("QQ[s]/(s^6+2*s+2)", "3+3*s+3*s^2+2*s^3+s^4+3*s^5", "-2+s+3*s^2+s^3-2*s^4",
     "-487-729*s-236*s^2+171*s^3+373*s^4+379*s^5",
     "-115328-119600*s+86636*s^2+179676*s^3+138360*s^4+88056*s^5"),
    # 3*s^2+3*s^3 is real and negative at both complex places, on the branch cut of the square root
    ("QQ(zeta5)", "3-zeta5-3*zeta5^2", "3*zeta5^2+3*zeta5^3", "216-51*zeta5-407*zeta5^2-456*zeta5^3",
     "-69456-413208*zeta5-546216*zeta5^2-342408*zeta5^3"),
]  # fmt: skip


def isomorphic_pair(K, rng):
    """Constants of an algebra, and those that two orthogonal quaternions of trace 0 in it have."""

    def some():
        return sum((K.gen**n * rng.randint(-3, 3) for n in range(K.degree)), K.zero)

    A = QuaternionAlgebra(K, some() or K.one, some() or K.one)
    while True:
        i, r = A(0, some(), some(), some()), A(0, some(), some(), some())
        j = i * r - r * i
        if i.norm() and j.norm():
            return A, QuaternionAlgebra(K, -i.norm(), -j.norm())


def check(A, B):
    """A map is returned after its relations were multiplied out; here they are once more."""
    e, i, j, k = map(A.isomorphism(B), A.basis)
    a, b = A.constants.a, A.constants.b
    assert (i * i, j * j, i * j, j * i) == (B(a), B(b), k, -k)
    assert e == B(1)
    return i, j


@pytest.mark.slow
@pytest.mark.parametrize("name", FIELDS)
def test_random_pairs(name):
    K, rng = ring(name), random.Random(5)
    for _ in range(cases(5)):
        A, B = isomorphic_pair(K, rng)
        check(A, B)
        check(B, A)


@pytest.mark.slow
@pytest.mark.parametrize("case", HARD, ids=range(len(HARD)))
def test_pairs_that_were_refused(case, monkeypatch):
    """Nothing is factored but the norms of the constants, and images are about as long as these."""
    calls = []

    def watched(field, x):
        calls.append(x)
        return candidates(field, x)

    monkeypatch.setattr(unimodular_lattice, "candidates", watched)
    K, *numbers = ring(case[0]), *case[1:]
    a, b, p, q = map(K, numbers)
    A, B = QuaternionAlgebra(K, a, b), QuaternionAlgebra(K, p, q)
    images = check(A, B)
    assert set(calls) <= {a, b, p, q}
    digits = max(len(str(c)) for x in images for y in x.coordinates for c in y.poly.coeffs())
    assert digits < 100


@pytest.mark.slow
@pytest.mark.parametrize("name", ["QQ[s]/(s-1)", "QQ[s]/(s^2-s-1)", *FIELDS[:2], "QQ[s]/(s^4-2)"])
def test_modules_are_unimodular(name):
    """The trace of the bilinear form has the discriminant of the field to the sixth, times a scale."""
    K, rng = ring(name), random.Random(2)
    for _ in range(3):
        A, B = isomorphic_pair(K, rng)
        a, b, p, q = A.constants.a, A.constants.b, B.constants.a, B.constants.b
        form = [-a, -b, a * b, p, q, -p * q]
        bad = {2}.union(*(candidates(K, x) for x in (a, b, p, q)))
        basis = unimodular_module(K, form, sorted(bad))
        weighted = [[2 * f * x for f, x in zip(form, v, strict=True)] for v in basis]
        gram = flint.fmpq_mat(
            [
                [sum((x * y for x, y in zip(u, v, strict=True)), K.zero).trace() for v in basis]
                for u in weighted
            ]
        )
        ratio = abs(gram.det()) / flint.fmpq(abs(K.discriminant())) ** 6
        assert ratio.q == 1
        root, exact = power_root(int(ratio.p))
        assert ratio == 1 or exact % (12 * K.degree) == 0, root


@pytest.mark.slow
@pytest.mark.parametrize("name", [*FIELDS, "QQ[s]/(s^7-s^6-6*s^5+4*s^4+10*s^3-4*s^2-4*s+1)"])
def test_algebras_from_their_ramification_have_maximal_orders(name):
    """The primes that come along are small, unlike those asked for."""
    K, rng = ring(name), random.Random(3)
    small = [P for p in takewhile(lambda p: p < 30, primes()) for P in K.primes_above(p)]
    for size in (2, 6):
        places = rng.sample([*small, *K.real_places()], size)
        A = QuaternionAlgebra.from_ramification(K, places)
        assert set(A.ramified_places()) == set(places)
        assert max(p for x in A.constants if x for p in candidates(K, x)) < WORD
        assert A.maximal_order().is_maximal()


def test_large_primes_may_ramify():
    K = ring("QQ[s]/(s^4-5*s^2+5)")
    places = [primes_above(K, 10**20 + 39)[0], *K.primes_above(2)]
    A = QuaternionAlgebra.from_ramification(K, places)
    assert set(A.ramified_places()) == set(places)
    assert A.maximal_order().is_maximal()
