"""Explicit answers over quadratic fields: points on conics, common slots, isomorphisms, square roots."""

import itertools
import random

import flint
import pytest

from hfield.algebra.structure.elements.square_roots import square_roots
from hfield.core.factorisation import known_primes, remove
from hfield.core.primality import is_prime
from hfield.core.product import Constants, multiply
from hfield.errors import UndecidedError
from hfield.fields.names import ring
from hfield.fields.number_fields.conics import good_module, solve_conic_number_field
from hfield.fields.number_fields.given_symbols import common_slot, is_local_square
from hfield.fields.number_fields.integral_basis import coordinate_rows
from hfield.fields.number_fields.quadratic.residues import Inert, prime_at
from hfield.fields.number_fields.quadratic.symbols import hilbert_symbol_quadratic, pair
from hfield.fields.number_fields.symbols import candidates
from hfield.fields.quadratic_forms import (
    is_division,
    is_isomorphic,
    isomorphism,
    ramified_places,
    split,
)
from hfield.fields.quadratic_forms.minimal_conics import Conic
from tests.fields.algebra_cases import constants
from tests.subcases import first_quick, slow, subcases
from tests.thorough import cases

FIELDS = [2, 3, 5, 10, 17, -1, -3, -7, -23, -163]


def field(d: int):
    return ring(f"QQ(sqrt({d}))")


def number(F, rng: random.Random, size: int):
    while True:
        x = F(rng.randint(-size, size)) + F.gen * rng.randint(-size, size)
        if not F.is_zero(x):
            return x


def algebra(F, rng: random.Random, size: int, *, division: bool) -> Constants:
    """Return an algebra with coefficients up to the size that is a division algebra, or that splits."""
    while True:
        c = Constants(number(F, rng, size), F.zero, number(F, rng, size))
        if is_division(F, c) == division:
            return c


def other_basis(F, c: Constants, rng: random.Random) -> Constants:
    """Return the constants of the same algebra with respect to other generators, not so small ones."""
    while True:
        p, q = ([number(F, rng, 2) for _ in range(4)] for _ in range(2))
        i = (F.zero, *p[1:])
        j = [x - y for x, y in zip(multiply(c, i, q), multiply(c, q, i), strict=True)]
        d = Constants(multiply(c, i, i)[0], F.zero, multiply(c, j, j)[0])
        if not (F.is_zero(d.a) or F.is_zero(d.b)):
            return d


def point(F, a, b):
    """Return (x, y, z) with ``a·x² + b·y² = z²``."""
    return solve_conic_number_field(F, a, b)


@subcases("d", FIELDS)
@pytest.mark.parametrize("size", [300, slow(10**9)])
def test_conics_with_large_coefficients(d, size):
    F, rng = field(d), random.Random(d * size)
    for _ in range(cases(5)):
        c = algebra(F, rng, size, division=False)
        x, y, z = point(F, c.a, c.b)
        assert not all(map(F.is_zero, (x, y, z)))
        assert c.a * x * x + c.b * y * y == z * z
        s = split(F, c)
        assert s is not None
        assert s.to_matrix((F.zero, F.one, F.zero, F.zero)) == s.i


@pytest.mark.parametrize("d", [10007, -10007, 1000003, -999997, 99999989])
def test_conics_over_fields_of_large_discriminant(d):
    F, rng = field(d), random.Random(d)
    c = algebra(F, rng, 300, division=False)
    x, y, z = point(F, c.a, c.b)
    assert c.a * x * x + c.b * y * y == z * z
    assert any((x, y, z))


def test_conics_with_fractions_squares_and_one_rational_coefficient():
    F = field(-5)
    for a, b in itertools.permutations(("4/9", "-6+3*sqrt(-5)", "25*sqrt(-5)/7", "3/50"), 2):
        c = constants(F.name, a, 0, b)
        if not is_division(F, c):
            x, y, z = point(F, c.a, c.b)
            assert any((x, y, z))
            assert c.a * x * x + c.b * y * y == z * z


def test_primes_that_are_given_are_not_searched_for():
    F = field(2)
    # p and q split and 7 is a square modulo both, as they are one modulo 7; 7 splits too
    p, q = (
        next(n for n in itertools.count(10**k) if n % 56 == 1 and is_prime(n)) for k in (40, 41)
    )
    a, b = F(p * q), F(7)
    with pytest.raises(UndecidedError, match="no small factor"):
        point(F, a, b)
    with known_primes([p, q]):
        x, y, z = point(F, a, b)
    assert any((x, y, z))
    assert a * x * x + b * y * y == z * z


def test_rational_constants_over_a_field_of_any_discriminant():
    F = field(-(10**15) - 37)
    c = constants(F.name, 2, 0, 5)  # ramified over ℚ at 2 and 5, which do not split in F
    assert not ramified_places(F, c)
    assert split(F, c) is not None


@subcases("d", FIELDS)
def test_prime_ideals(d):
    F, rng = field(d), random.Random(d)
    for p in (2, 3, 5, 7, 163, 10**20 + 39):
        above = [prime_at(v) for v in F.primes_above(p)]
        for _ in range(10):
            x, y = (number(F, rng, 60) * rng.choice((1, p, p * p)) for _ in range(2))
            weights = [2 if isinstance(v, Inert) else 1 for v in above]
            total = sum(w * v.valuation(x) for w, v in zip(weights, above, strict=True))
            assert total == remove(int(F.norm(x)), p)[0]
            for v in above:
                assert v.valuation(x * y) == v.valuation(x) + v.valuation(y)
                assert (v.valuation(x) > 0) == (v.reduce(x) == 0)
                assert v.reduce(x * y) == v.multiply(v.reduce(x), v.reduce(y))
                assert v.reduce(x + y) == (v.reduce(x) + v.reduce(y)) % v.modulus
                assert v.reduce(v.lift(v.reduce(x))) == v.reduce(x)
        for v in above:
            assert (v.valuation(v.uniformiser), v.valuation(v.inverse_uniformiser)) == (1, -1)
            for u in above:
                if u is not v:
                    assert u.valuation(v.uniformiser) == 0
                    assert u.valuation(v.inverse_uniformiser) >= 0


@pytest.mark.parametrize("d", [2, 5, 17, -1, -3, -7])
def test_a_good_lattice_is_a_module_of_least_discriminant(d):
    F, rng = field(d), random.Random(d)
    c = algebra(F, rng, 30, division=False)
    a, b = c.a * 36, c.b * 25 * (F.gen + 3) * (F.gen + 3)
    basis = good_module(F, [F.one, -a, -b], sorted({2} | candidates(F, a) | candidates(F, b)))
    o = F.zero
    conic = Conic((F.one, -a, -b, o, o, o), o, F.one)
    matrix = _matrix(F, basis)
    turned = _matrix(F, [[F.integral_basis()[1] * x for x in v] for v in basis])
    assert all(x.q == 1 for x in (turned * matrix.inv()).entries())
    # s the ideal of values: the half-discriminant 4ab, times the index squared, is the cube of s
    sums = [[x + y for x, y in zip(u, v, strict=True)] for u, v in itertools.combinations(basis, 2)]
    values = [conic.value(u) for u in (*basis, *sums)]
    least = _index(F, values)
    assert matrix.det() ** 2 * abs((4 * a * b).norm()) == least**3


def _matrix(K, vectors):
    rows = [coordinate_rows(K, v).entries() for v in vectors]
    return flint.fmpq_mat(6, 6, [u for row in rows for u in row])


def _index(K, values):
    """Return the norm of the ideal that some integers generate."""
    rows = coordinate_rows(K, [y for x in values for y in (x, K.integral_basis()[1] * x)])
    hermite = rows.numer_denom()[0].hnf()
    return abs(hermite[0, 0] * hermite[1, 1])


@subcases("d", FIELDS)
def test_common_slots(d):
    F, rng = field(d), random.Random(d)
    for _ in range(2):
        c = algebra(F, rng, 40, division=True)
        o = other_basis(F, c, rng)
        e = slot(F, c, [c.a, o.a])
        for x in (c.a, o.a):
            assert ramified_places(F, Constants(x, F.zero, e)) == ramified_places(F, c)


def slot(F, c, numbers):
    """Return an e such that each (x, e) is isomorphic to an algebra."""
    return common_slot(numbers, ramified_places(F, c))


def test_no_common_slot():
    # ℚ₅ contains a root of −1, so that no (−1, e) ramifies at a place above 5
    F = field(11)
    c = constants(F.name, 5, 0, 2)
    assert [v.p for v in ramified_places(F, c)] == [5, 5]
    with pytest.raises(UndecidedError, match="above 5"):
        slot(F, c, [F(-1)])


@pytest.mark.slow
@subcases("d", FIELDS)
@subcases("size", [20, 100])
def test_isomorphisms_of_division_algebras(d, size):
    F, rng = field(d), random.Random(d + size)
    for _ in range(cases(5)):
        c = algebra(F, rng, size, division=True)
        o = other_basis(F, c, rng)
        assert is_isomorphic(F, c, o)
        m = isomorphism(F, c, o)
        assert m is not None
        p, q = (tuple(number(F, rng, 9) for _ in range(4)) for _ in range(2))
        assert m(multiply(c, p, q)) == multiply(o, m(p), m(q))
        assert m.inverse(m(q)) == q


@pytest.mark.parametrize("d", first_quick([2, -7, 5, -1, -23], 2))
def test_square_roots_of_scalars_in_division_algebras(d):
    F, rng = field(d), random.Random(d)
    for _ in range(cases(10)):
        c = algebra(F, rng, 20, division=True)
        p = (F.zero, *(number(F, rng, 5) for _ in range(3)))
        s = multiply(c, p, p)[0]
        x = square_roots(F, c, (s, F.zero, F.zero, F.zero)).quadric
        assert x is not None
        assert multiply(c, x, x) == (s, F.zero, F.zero, F.zero)
        s = number(F, rng, 30)
        x = square_roots(F, c, (s, F.zero, F.zero, F.zero)).quadric
        assert (x is None) == any(is_local_square(v, s) for v in ramified_places(F, c))
        if x is not None:
            assert multiply(c, x, x) == (s, F.zero, F.zero, F.zero)


@pytest.mark.parametrize("d", [2, 3, 5, 6, 17, -1, -3, -7, 10])
def test_local_squares(d):
    # x is a square in a completion exactly when (x, y) = 1 for all y
    F, rng = field(d), random.Random(d)
    some = [number(F, rng, 60) for _ in range(25)]
    for p in (0, 2, 3, 5):
        for v in F.primes_above(p) if p else F.infinite_places():
            others = [pair(y) for z in some for y in (z, z * (p or 1), z * F.gen)]
            for _ in range(cases(20)):
                x = number(F, rng, 20) * F(rng.choice((1, 2, 4, 3, 9)))
                symbols = [hilbert_symbol_quadratic(F, pair(x), y, v) for y in others]
                assert is_local_square(v, x) == (min(symbols) == 1)
                assert is_local_square(v, x * x)


def test_norm_and_trace():
    F = field(13)
    w = F.integral_basis()[1]
    assert (F.trace(w), F.norm(w)) == (1, -3)
