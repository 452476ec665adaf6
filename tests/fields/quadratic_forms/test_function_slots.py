"""Explicit answers over GF(q)(t): common slots, isomorphisms of division algebras, square roots."""

import random

import pytest

from hfield.algebra.structure.elements.square_roots import square_roots
from hfield.core.product import Constants, multiply, norm, trace
from hfield.fields.function_fields.common_slots import common_slot_functions
from hfield.fields.names import ring
from hfield.fields.quadratic_forms import is_division, isomorphism, ramified_places
from hfield.fields.quadratic_forms.normal_forms import discriminant
from hfield.fields.quadratic_forms.ramification import hilbert_symbol
from tests.fields.algebra_cases import constants
from tests.subcases import subcases
from tests.thorough import quick_part

ODD = ["GF(3)(t)", "GF(5)(t)", "GF(9)(t)", "GF(1000003)(t)"]
EVEN = ["GF(2)(t)", "GF(4)(t)", "GF(8)(t)"]


def polynomial(F, rng: random.Random, degree: int):
    x = F.zero
    for _ in range(degree + 1):
        x = x * F.gen + F.constant(F.base.random(rng))
    return x


def division_algebra(F, rng: random.Random, degree: int) -> Constants:
    t = F.one if F.characteristic == 2 else F.zero
    while True:
        a, b, den = (polynomial(F, rng, rng.randint(0, degree)) for _ in range(3))
        if not F.is_zero(den):
            c = Constants(F.divide(a, den), t, b)
            if not F.is_zero(discriminant(F, c)) and is_division(F, c):
                return c


def other_generators(F, c: Constants, rng: random.Random, degree: int) -> Constants:
    """Return the constants of the same algebra with respect to random generators."""
    while True:
        i, u = ([polynomial(F, rng, degree) for _ in range(4)] for _ in range(2))
        j = [x - y for x, y in zip(multiply(c, u, i), multiply(c, i, u), strict=True)]
        d = Constants(F.zero - norm(c, i), trace(c, i), multiply(c, j, j)[0])
        if not F.is_zero(discriminant(F, d)):
            return d


@pytest.mark.slow
@subcases("name", ODD + EVEN)
@subcases("degree", [2, 6])
def test_isomorphisms_of_division_algebras(name, degree):
    F, rng = ring(name), random.Random(f"{name}{degree}")
    for _ in range(3):
        c = division_algebra(F, rng, degree)
        d = other_generators(F, c, rng, 2)
        m = isomorphism(F, c, d)
        assert m is not None
        p, q = (tuple(F.random(rng) for _ in range(4)) for _ in range(2))
        assert m(multiply(c, p, q)) == multiply(d, m(p), m(q))
        assert m.inverse(m(q)) == q


@pytest.mark.parametrize("name", ODD)
def test_common_slots(name):
    F, rng = ring(name), random.Random(name)
    for _ in range(4):
        c = division_algebra(F, rng, 5)
        i = [F.zero, *(polynomial(F, rng, 3) for _ in range(3))]
        square = multiply(c, i, i)[0]
        e = common_slot_functions(F, c, [c.a, square])
        for x in (c.a, square):
            assert ramified_places(F, Constants(x, F.zero, e)) == ramified_places(F, c)


@pytest.mark.parametrize("name", ODD)
def test_square_roots_of_scalars(name):
    """There is one exactly where the scalar is not a square at a ramified place: it splits nothing there."""
    F, rng = ring(name), random.Random(name)
    found = []
    for _ in quick_part(range(12)):
        c = division_algebra(F, rng, 2)
        s = polynomial(F, rng, 3)
        if F.sqrt(s) is not None:
            continue
        x = square_roots(F, c, (s, F.zero, F.zero, F.zero)).quadric
        found.append(x is not None)
        if x is not None:
            assert multiply(c, x, x) == (s, F.zero, F.zero, F.zero)
            assert F.is_zero(trace(c, x))
        else:
            assert any(is_local_square(F, s, v, rng) for v in ramified_places(F, c))
    assert len(set(found)) == 2


def is_local_square(F, s, v, rng: random.Random) -> bool:
    """Tell by symbols with random elements, the place being one of few that s and they have in common."""
    return all(hilbert_symbol(s, polynomial(F, rng, 6) + F.gen**7, v) == 1 for _ in range(40))


@pytest.mark.parametrize("name", EVEN)
def test_every_element_is_a_square_in_even_characteristic(name):
    F, rng = ring(name), random.Random(name)
    for number in range(10):
        c = division_algebra(F, rng, 3) if number % 2 else constants(name, 0, "t", "t^2")
        s = F.random(rng)
        found = square_roots(F, c, (s, F.zero, F.zero, F.zero))
        x = found.quadric or found.isolated[0]
        assert multiply(c, x, x) == (s, F.zero, F.zero, F.zero)
        assert F.is_zero(trace(c, x))


def test_no_common_slot():
    F = ring("GF(5)(t)")
    c = constants("GF(5)(t)", 2, 0, "t")
    assert list(map(str, ramified_places(F, c))) == ["t", "inf"]
    assert common_slot_functions(F, c, [F("t+1")]) is None  # a square at t
    assert common_slot_functions(F, c, [F("t^2+2")]) is None  # a square at infinity
    assert common_slot_functions(F, c, [F("2*(t+1)^2")]) is not None
