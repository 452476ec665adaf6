import itertools
import random

import pytest

from hfield.algebra.structure.elements.properties import (
    characteristic_polynomial,
    conjugacy,
    is_idempotent,
    is_nilpotent,
    is_unit,
)
from hfield.algebra.structure.elements.square_roots import square_roots
from hfield.algebra.structure.elements.torsion import multiplicative_order
from hfield.core.product import multiply, norm, trace
from hfield.errors import NotInvertibleError, UndecidedError
from hfield.fields.names import ring
from tests.fields.algebra_cases import constants
from tests.subcases import subcases

SMALL = [
    ("GF(2)", 1, 0, 1),
    ("GF(2)", 1, 1, 1),
    ("GF(3)", -1, 0, -1),
    ("GF(3)", 0, 1, 2),
    ("GF(3)", 0, 0, 1),
    ("ZZ/4", -1, 0, -1),
    ("ZZ/6", 2, 1, 3),
]


def everything(R):
    return itertools.product(list(R.elements()), repeat=4)


def same(R, p, q):
    return all(R.equal(x, y) for x, y in zip(p, q, strict=True))


@pytest.mark.parametrize(("name", "a", "t", "b"), SMALL)
def test_nilpotents_and_units_by_exhaustion(name, a, t, b):
    R, c = ring(name), constants(name, a, t, b)
    rng = random.Random(1)
    one = (R.one, R.zero, R.zero, R.zero)
    everyone = list(everything(R))
    for q in rng.sample(everyone, min(81, len(everyone))):
        n0, n1, _ = characteristic_polynomial(R, c, q)
        square = multiply(c, q, q)
        assert same(
            R, [x + n1 * y for x, y in zip(square, q, strict=True)], [-n0, R.zero, R.zero, R.zero]
        )
        power = q
        for _ in range(6):
            power = multiply(c, power, power)
        assert is_nilpotent(R, c, q) == all(map(R.is_zero, power))
        assert is_idempotent(R, c, q) == same(R, square, q)
        if is_unit(R, c, q):
            order = multiplicative_order(R, c, q)
            power, n = q, 1
            while not same(R, power, one):
                power, n = multiply(c, power, q), n + 1
            assert order == n
        else:
            with pytest.raises(NotInvertibleError):
                multiplicative_order(R, c, q)


@pytest.mark.parametrize(("name", "a", "t", "b"), SMALL[:5])
def test_square_roots_and_conjugators_by_exhaustion(name, a, t, b):
    F, c = ring(name), constants(name, a, t, b)
    everyone = list(everything(F))
    key = lambda q: tuple(map(F.key, q))  # noqa: E731
    roots: dict = {}
    for q in everyone:
        roots.setdefault(key(multiply(c, q, q)), set()).add(key(q))
    units = [q for q in everyone if is_unit(F, c, q)]
    rng = random.Random(2)
    for q in everyone:
        try:
            found = square_roots(F, c, q)
        except UndecidedError:  # a degenerate algebra and a scalar
            continue
        expected = {key(x) for x in found.isolated}
        if found.quadric is not None:
            expected |= {
                key(x) for x in everyone if F.is_zero(trace(c, x)) and F.equal(norm(c, x), -q[0])
            }
        assert expected == roots.get(key(q), set())
    for q in rng.sample(everyone, 6):
        orbit = {key(multiply(c, multiply(c, u, q), inverse(F, c, u))) for u in units}
        for p in everyone:
            answer = conjugacy(F, c, q, p)
            assert bool(answer) == (key(p) in orbit)
            if answer.element is not None:
                x = answer.element
                assert same(F, multiply(c, x, q), multiply(c, p, x))
                assert is_unit(F, c, x)


def inverse(F, c, u):
    from hfield.core.product import conjugate

    scale = F.inverse(norm(c, u))
    return tuple(scale * x for x in conjugate(c, u))


def test_roots_of_scalars():
    F, c = ring("QQ"), constants("QQ", -1, 0, -1)
    o = F.zero
    found = square_roots(F, c, (F(-3), o, o, o))
    assert not found.isolated
    assert found.quadric is not None
    assert same(F, multiply(c, found.quadric, found.quadric), (F(-3), o, o, o))
    assert square_roots(F, c, (F(-7), o, o, o)).quadric is None  # 7 is no sum of three squares
    four = square_roots(F, c, (F(4), o, o, o))
    assert len(four.isolated) == 2
    assert four.quadric is None
    assert not square_roots(F, c, (F(2), o, o, o))
    for constants_of, nilpotents in ((c, False), (constants("QQ", 2, 0, 7), True)):
        zero = square_roots(F, constants_of, (o, o, o, o))
        assert bool(zero.isolated) != nilpotents
        if zero.quadric is not None:
            assert same(F, multiply(constants_of, zero.quadric, zero.quadric), (o, o, o, o))
            assert not same(F, zero.quadric, (o, o, o, o))
    split = square_roots(F, constants("QQ", 1, 0, 7), (F(2), o, o, o))
    assert split.quadric is not None


def test_roots_of_squares_of_scalars_in_characteristic_2():
    """r + n with n² = 0: r alone in a division algebra, infinitely many elsewhere."""
    F = ring("GF(2)(t)")
    s, o = F("t^2+1"), F.zero
    found = square_roots(F, constants("GF(2)(t)", 1, 1, "t"), (s, o, o, o))
    assert (found.isolated, found.quadric) == (((F("t+1"), o, o, o),), None)
    for c in (constants("GF(2)(t)", 1, 1, 1), constants("GF(2)(t)", 1, 0, 1)):
        found = square_roots(F, c, (s, o, o, o))
        assert not found.isolated
        assert any(found.quadric[1:])
        assert same(F, multiply(c, found.quadric, found.quadric), (s, o, o, o))


@subcases(
    ("name", "a", "t", "b", "q", "order"),
    [
        ("QQ", -1, 0, -1, (0, 1, 0, 0), 4),
        ("QQ", -1, 0, -1, ("1/2", "1/2", "1/2", "1/2"), 6),
        ("QQ", -1, 0, -1, (1, 1, 0, 0), None),
        ("QQ", -1, 0, -1, ("3/5", "4/5", 0, 0), None),
        ("QQ(sqrt(2))", -1, 0, -1, ("sqrt(2)/2", "sqrt(2)/2", 0, 0), 8),
        ("QQ(sqrt(5))", -1, 0, -1, ("(1+sqrt(5))/4", "1/2", "(sqrt(5)-1)/4", 0), 10),
        ("RR", -1, 0, -1, (0, 1, 0, 0), 4),
        ("GF(9)", -1, 0, -1, ("x", 1, 0, 0), None),
        ("GF(1000003)", -1, 0, -1, (1, 2, 3, 4), None),
        ("GF(5)(t)", 2, 0, "t", (2, 0, 0, 0), 4),
        ("GF(5)(t)", 2, 0, "t", (1, 0, 1, 0), None),
        ("ZZ", -1, 0, -1, (0, 1, 0, 0), 4),
    ],
)
def test_orders(name, a, t, b, q, order):
    F, c = ring(name), constants(name, a, t, b)
    q = tuple(F(x) for x in q)
    found = multiplicative_order(F, c, q)
    if F.order is None:
        assert found == order
    else:
        assert found is not None
        assert (F.order**2 - 1) * F.characteristic % found == 0


def test_conjugate_rational_quaternions():
    F, c = ring("QQ"), constants("QQ", -1, 0, -1)
    p, q = ((F(0), F(3), F(0), F(0)), (F(0), F(1), F(2), F(2)))
    x = conjugacy(F, c, p, q).element
    assert x is not None
    assert same(F, multiply(c, x, p), multiply(c, q, x))
    assert "norms differ" in conjugacy(F, c, p, (F(0), F(1), F(1), F(0))).reason
    assert F.is_zero(trace(c, p))


def test_what_is_not_decided():
    c = constants("ZZ", -1, 0, -1)
    one = (ring("ZZ").one, *[ring("ZZ").zero] * 3)
    for question in (
        lambda: square_roots(ring("ZZ"), c, one),
        lambda: conjugacy(ring("ZZ"), c, one, one),
    ):
        with pytest.raises(UndecidedError, match="not a field"):
            question()
