"""Degenerate algebras: compared with an explicit map, and square roots of scalars in them."""

import random

import pytest

from hfield.algebra.structure.elements.square_roots import square_roots
from hfield.core.product import Constants, multiply, norm, trace
from hfield.fields.function_fields.artin_schreier import artin_schreier
from hfield.fields.names import ring
from hfield.fields.quadratic_forms import is_isomorphic, isomorphism
from hfield.fields.quadratic_forms.normal_forms import discriminant
from tests.fields.algebra_cases import constants
from tests.subcases import subcases


@subcases(
    ("name", "one", "other", "answer"),
    [
        ("QQ", (0, 0, 3), (0, 0, 12), True),
        ("QQ", (0, 0, 3), (12, 0, 0), True),
        ("QQ", (2, 0, 0), (0, 0, 8), True),
        ("QQ", (2, 0, 0), (1, 2, 0), True),
        ("QQ", (2, 0, 0), (-1, 2, 0), False),
        ("QQ", (0, 0, 0), (-1, 2, 0), True),
        ("RR", (2, 0, 0), (3, 0, 0), True),
        ("RR", (2, 0, 0), (-3, 0, 0), False),
        ("GF(5)(t)", ("t", 0, 0), (0, 0, "t^3"), True),
        ("GF(5)(t)", ("t", 0, 0), (0, 0, "2*t"), False),
        ("QQ(sqrt(5))", ("sqrt(5)", 0, 0), (0, 0, "2*sqrt(5)"), False),
        ("GF(2)", (1, 0, 1), (0, 0, 1), True),
        ("GF(4)", ("x", 1, 0), (1, 1, 0), False),
        ("GF(4)", ("x", 1, 0), ("x+1", 1, 0), True),
        ("GF(4)", ("x", 1, 0), ("1", 0, 0), False),
        ("GF(2)(t)", ("t", 1, 0), ("t^2", 1, 0), True),
        ("GF(2)(t)", ("t", 1, 0), ("t+1", 1, 0), False),
        ("GF(2)(t)", ("t", 1, 0), ("t^4+t^2", "t", 0), False),
        ("GF(2)(t)", ("t", 1, 0), ("t^4", "t", 0), True),
        ("GF(2)(t)", ("t^3", "t", 0), ("t^2/(t+1)^2+t^2/(t+1)+t^3", "t", 0), True),
        ("GF(4)(t)", ("t", 0, "x"), (0, 0, "t+1"), True),
        ("GF(4)(t)", ("x*t^2", 0, "t^3"), ("t^3+x", 0, "t^5+t"), True),
        ("GF(4)(t)", ("x*t^2", 0, "t^4"), (0, 0, 0), True),
        ("GF(4)(t)", ("x*t^2", 0, "t^4"), ("t", 0, 0), False),
    ],
)
def test_degenerate_algebras_are_compared(name, one, other, answer):
    F = ring(name)
    c, d = constants(name, *one), constants(name, *other)
    rng = random.Random(1)
    for source, target in ((c, d), (d, c)):
        assert is_isomorphic(F, source, target) == answer
        m = isomorphism(F, source, target)
        assert (m is not None) == answer
        if m is not None:
            p, q = (tuple(F(rng.randint(-3, 3)) for _ in range(4)) for _ in range(2))
            product = m(multiply(source, p, q))
            assert all(
                F.equal(x, y) for x, y in zip(product, multiply(target, m(p), m(q)), strict=True)
            )
            assert all(F.equal(x, y) for x, y in zip(m.inverse(m(q)), q, strict=True))


@pytest.mark.parametrize("name", ["QQ", "GF(3)", "GF(4)", "GF(3)(t)", "GF(2)(t)", "GF(8)(t)"])
def test_isomorphisms_between_random_presentations(name):
    F, rng = ring(name), random.Random(name)
    for number in range(40):
        c = Constants(F.random(rng), F.zero if number % 2 else F.random(rng), F.zero)
        if F.characteristic == 2 and F.is_zero(c.t):
            c = Constants(c.a, c.t, F.random(rng))
        if not F.is_zero(discriminant(F, c)):
            continue
        x, s = F.random(rng), F.random(rng)
        if F.is_zero(s):
            continue
        # s·i + x with its conjugate instead of i; then j scaled
        i = (x, s, F.zero, F.zero)
        d = Constants(F.zero - norm(c, i), trace(c, i), s * s * c.b)
        if F.characteristic == 2 and F.is_zero(c.t):
            d = Constants(c.b, F.zero, c.a + x * x)
        m = isomorphism(F, c, d)
        assert m is not None
        assert len(set(map(str, m.images))) == 4


@subcases(
    ("name", "a", "t", "b", "s", "some"),
    [
        ("QQ", 2, 0, 0, 8, True),
        ("QQ", 2, 0, 0, 3, False),
        ("QQ", 0, 0, 3, 12, True),
        ("QQ", 1, 2, 0, 18, True),
        ("QQ", 0, 0, 0, 2, False),
        ("GF(3)(t)", "t", 0, 0, "t^3", True),
        ("GF(3)(t)", "t", 0, 0, "2*t", False),
        ("GF(2)(t)", "t", 1, 0, "t", False),
        ("GF(2)(t)", "t", 0, 1, "t^3+1", True),
        ("GF(2)(t)", 1, 0, "t/(t+1)", "t^3+1", True),
        ("GF(2)(t)", 1, 0, "t^2", "t", False),
    ],
)
def test_roots_of_scalars(name, a, t, b, s, some):
    F, c = ring(name), constants(name, a, t, b)
    scalar = (F(s), F.zero, F.zero, F.zero)
    x = square_roots(F, c, scalar).quadric
    assert (x is not None) == some
    if x is not None:
        assert multiply(c, x, x) == scalar
        assert F.is_zero(trace(c, x))


@pytest.mark.parametrize("name", ["GF(2)(t)", "GF(4)(t)", "GF(8)(t)"])
def test_artin_schreier(name):
    F, rng = ring(name), random.Random(name)
    solved = 0
    for _ in range(60):
        y, z = F.random(rng), F.random(rng)
        found = artin_schreier(F, y * y + y)
        assert found in (y, y + 1)
        found = artin_schreier(F, z)
        assert found is None or found * found + found == z
        solved += found is not None
    assert solved < 30
