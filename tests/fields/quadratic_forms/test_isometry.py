"""Isomorphisms, splittings and square roots over ℚ with large constants: right, and short."""

import random
from fractions import Fraction

import pytest

from hfield import QuaternionAlgebra
from hfield.core.product import Constants, multiply
from hfield.errors import RingError, UndecidedError
from hfield.fields import QQ
from hfield.fields.rationals.embedding import traceless_root_rational
from hfield.fields.rationals.symbols import hilbert_symbol_q, ramified_places_q
from tests.subcases import slow
from tests.thorough import cases

P, Q, R = (
    10**29 + 319,
    10**29 + 631,
    10**39 + 3,
)  # tests/test_factorisation.py: no product is factored


def digits(numbers):
    parts = (x if isinstance(x, int | Fraction) else Fraction(str(x)) for x in numbers)
    return max(len(str(max(abs(x.numerator), x.denominator))) for x in parts)


def another_basis(rng, a, b):
    """Constants (c, d) of the same algebra: squares of two orthogonal pure quaternions picked at random."""
    while True:
        (x, y, z), (u, v, w) = ([rng.randint(-2, 2) for _ in range(3)] for _ in range(2))
        c = a * x * x + b * y * y - a * b * z * z
        pairing = a * x * u + b * y * v - a * b * z * w
        r, s, t = (c * m - pairing * n for m, n in ((u, x), (v, y), (w, z)))
        d = a * r * r + b * s * s - a * b * t * t
        if c and d:
            return c, d


def some_algebra(rng, bits, kind):
    a, b = (rng.choice((1, -1)) * rng.randrange(2 ** (bits - 1), 2**bits) for _ in range(2))
    return {
        "any": (a, b),
        "definite": (-abs(a), -abs(b)),
        "split": (a, rng.randrange(1, 9) ** 2 - a * rng.randrange(1, 9) ** 2),
        "isotropic": (a, -a),
        "square": (rng.randrange(2, 2 ** (bits // 2)) ** 2, b),
    }[kind]


@pytest.mark.parametrize("kind", ["any", "definite", "split", "isotropic", "square"])
@pytest.mark.parametrize("bits", [20, slow(40), slow(60)])
def test_isomorphisms_are_found_and_short(bits, kind):
    rng = random.Random(f"{bits}{kind}")
    for _ in range(cases(10)):
        a, b = some_algebra(rng, bits, kind)
        c, d = another_basis(rng, a, b)
        A, B = QuaternionAlgebra("QQ", a, b), QuaternionAlgebra("QQ", c, d)
        for source, target in ((A, B), (B, A)):
            phi = source.isomorphism(target)
            images = phi.images
            _, i, j, k = images
            x, y = source.constants.a, source.constants.b
            assert (i * i, j * j, i * j, j * i) == (target(x), target(y), k, -k)
            given = digits((a, b, c, d))
            assert digits([x for q in images for x in q.coordinates]) <= 3 * given


def test_the_lattice_is_unimodular_and_the_isometry_one():
    rng = random.Random(5)
    for _ in range(30):
        a, b = some_algebra(rng, 12, "any")
        if not ramified_places_q(a, b):
            continue
        c, d = another_basis(rng, a, b)
        A, B = QuaternionAlgebra("QQ", a, b), QuaternionAlgebra("QQ", c, d)
        p, q = (A(*(rng.randint(-9, 9) for _ in range(4))) for _ in range(2))
        phi = A.isomorphism(B)
        assert phi(p * q) == phi(p) * phi(q)
        assert phi(p).norm() == p.norm()
        assert phi.inverse()(phi(p)) == p


def test_with_t_and_denominators():
    A = QuaternionAlgebra("QQ", Fraction(-3, 7), Fraction(-1000003, 11), 5)
    B = QuaternionAlgebra("QQ", A.constants.a + QQ("25/4"), -1000003 * 11)
    phi = A.isomorphism(B)
    _, i, j, k = phi.images
    assert i * i == B(A.constants.a) + 5 * i
    assert j * i == 5 * j - k


@pytest.mark.slow
def test_primes_that_are_given_are_used():
    a, b = -P * Q, -7
    A, B = QuaternionAlgebra("QQ", a, b), QuaternionAlgebra("QQ", a * 10**4, b * 121)
    for question in (A.is_isomorphic, A.isomorphism):
        with pytest.raises(UndecidedError, match="with factors="):
            question(B)
        assert question(B, factors=[P, Q, R])
        with pytest.raises(RingError, match="is not a prime"):
            question(B, factors=[P * Q])
    n = next(n for n in range(5, 10**4) if not ramified_places_q(P * Q, n, [P, Q]))
    split = QuaternionAlgebra("QQ", P * Q, n)
    for question in (split.zero_norm_element, split.split):
        with pytest.raises(UndecidedError, match="with factors="):
            question()
        assert question(factors=[P, Q])
    assert split.zero_norm_element([P, Q]).norm() == 0
    assert not split.is_division_algebra(factors=[P, Q])
    for method in (A.ramified_places, A.discriminant, A.maximal_order):
        with pytest.raises(UndecidedError, match="with factors="):
            method()
        assert method(factors=[P, Q, R])
    with pytest.raises(UndecidedError) as caught:
        A(-1).square_roots()
    assert "factors=" not in str(caught.value)


def test_primes_of_one_constant_serve_for_the_others():
    A = QuaternionAlgebra("QQ", -P * Q, -R * P)
    B = QuaternionAlgebra("QQ", -P * Q * 4, -R * P * 9)
    assert A.is_isomorphic(B)
    assert A.isomorphism(B)
    assert not A.is_isomorphic(QuaternionAlgebra("QQ", -P * Q, R * P))


@pytest.mark.parametrize("bits", [20, 40, 60, 120])
def test_splittings_are_short(bits):
    rng = random.Random(bits)
    for _ in range(4):
        a, b = some_algebra(rng, bits, "split")
        A = QuaternionAlgebra("QQ", a, b)
        matrices = A.split()
        assert digits([x for m in matrices for row in m for x in row]) <= 4 * digits((a, b))
        q = A.zero_norm_element()
        assert q.norm() == 0
        assert digits(q.coordinates) <= 3 * digits((a, b))


def is_local_square(s, v):
    """Whether s is a square at v: whether its symbol with everything is 1."""
    if v == "inf":
        return s > 0
    others = (-1, 2, 5) if v == 2 else (v, *range(2, 40))
    return all(hilbert_symbol_q(s, n, v) == 1 for n in others)


@pytest.mark.slow
def test_square_roots_of_scalars_of_trace_0():
    rng = random.Random(3)
    seen = set()
    for n in range(120):
        bits = (3, 8, 20, 40)[n % 4]
        a, b, s = (rng.randrange(1, 2**bits) * rng.choice((1, -1)) for _ in range(3))
        places = ramified_places_q(a, b)
        if not places:
            continue
        c = Constants(QQ(a), QQ(0), QQ(b))
        root = traceless_root_rational(QQ, c, QQ(s))
        assert (root is None) == any(is_local_square(s, v) for v in places)
        seen.add(root is None)
        if root is not None:
            assert multiply(c, root, root) == (s, 0, 0, 0)
            assert digits(root) <= 8 * digits((a, b, s)) + 4
    assert seen == {True, False}
