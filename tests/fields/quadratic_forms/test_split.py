import random

import pytest

from hfield.core.product import Constants, multiply, norm
from hfield.errors import CoercionError, MixedParentsError, UndecidedError
from hfield.fields.names import ring
from hfield.fields.quadratic_forms.isomorphisms.isomorphic import (
    is_isomorphic,
    isomorphism,
    same_parent,
)
from hfield.fields.quadratic_forms.isomorphisms.splitting import (
    CoordinateSplitting,
    division_or_splitting,
    product,
    split,
)
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm
from hfield.fields.quadratic_forms.normal_forms import discriminant
from tests.fields.algebra_cases import constants
from tests.subcases import subcases

SPLIT = [
    ("QQ", 1, 0, 7),
    ("QQ", 5, 1, -1),
    ("QQ", 2, 0, 7),
    ("QQ", "3/4", 1, "1/5"),
    ("GF(2)", 1, 1, 1),
    ("GF(8)", "x", "x+1", "x^2"),
    ("GF(7)", -1, 0, -1),
    ("GF(9)", "x", 1, "x"),
    ("GF(1000003)", 2, 1, 5),
    ("RR", "sqrt(2)", 0, -5),
    ("CC", "I", 0, 3),
    ("QQ(I)", -1, 0, -1),
    ("QQ(sqrt(2))", "sqrt(2)", 0, 3),
    ("QQ(sqrt(-3))", 2, 1, 5),
    ("GF(4)(t)", 1, 1, "t"),
    ("GF(5)(t)", "t", 0, "1-t"),
    ("QQ(x)", "x", 0, "x+1/4-x^2"),
]


@subcases(("name", "a", "t", "b"), SPLIT)
def test_a_splitting_is_an_isomorphism(name, a, t, b):
    F, c = ring(name), constants(name, a, t, b)
    s = split(F, c) if (name, a) != ("QQ(x)", "x") else None
    if s is None:
        assert zero_free(F, c)
        return
    rng = random.Random(1)
    p, q = (tuple(F.random(rng) for _ in range(4)) for _ in range(2))
    left, right = product(s.to_matrix(p), s.to_matrix(q)), s.to_matrix(multiply(c, p, q))
    assert all(F.equal(left[r][k], right[r][k]) for r in (0, 1) for k in (0, 1))
    (u, v), (w, x) = s.to_matrix(q)
    assert F.equal(u * x - v * w, norm(c, q))  # the determinant is the reduced norm
    assert all(F.equal(x, y) for x, y in zip(s.from_matrix(s.to_matrix(q)), q, strict=True))
    assert s.to_matrix(s.from_matrix([[1, 2], [3, 4]])) == tuple(
        tuple(F(x) for x in row) for row in ((1, 2), (3, 4))
    )
    with pytest.raises(CoercionError, match="2 × 2"):
        s.from_matrix([[1, 2, 3], [4, 5, 6]])


def zero_free(F, c):
    return isinstance(division_or_splitting(F, c), ZeroNorm)


def test_no_splitting():
    assert split(ring("QQ"), constants("QQ", -1, 0, -1)) is None
    answer = division_or_splitting(ring("QQ"), constants("QQ", 2, 0, 3))
    assert isinstance(answer, ZeroNorm)
    assert answer.places == (2, 3)
    with pytest.raises(CoercionError, match="degenerate"):
        split(ring("QQ"), constants("QQ", 0, 0, 3))
    with pytest.raises(UndecidedError, match="fields only"):
        split(ring("ZZ"), constants("ZZ", 1, 0, 3))
    assert isinstance(
        division_or_splitting(ring("GF(3)"), constants("GF(3)", -1, 0, -1)), CoordinateSplitting
    )


def another_presentation(F, c: Constants, rng: random.Random) -> Constants:
    """The constants of the same algebra with respect to other generators."""
    small = (F.zero, F.one, -F.one, F.one + F.one)
    while True:
        i = [rng.choice(small) for _ in range(4)]
        if F.characteristic == 2:
            i[1], middle = F.inverse(c.t), F.one  # trace 1
        else:
            i[0], middle = F.divide(-c.t * i[1], F(2)), F.zero  # trace 0
        p = [rng.choice(small) for _ in range(4)]
        j = [x - y for x, y in zip(multiply(c, i, p), multiply(c, p, i), strict=True)]
        d = Constants(multiply(c, i, i)[0] - middle * i[0], middle, multiply(c, j, j)[0])
        if not F.is_zero(discriminant(F, d)):
            return d


@pytest.mark.slow
@subcases(
    ("name", "a", "t", "b"),
    [
        *SPLIT[:-1],
        ("QQ", -1, 0, -1),
        ("QQ", 2, 0, 3),
        ("QQ", 3, 1, 5),
        ("RR", -2, 1, "-sqrt(3)"),
        ("QQ(sqrt(5))", -1, 0, -1),
        ("QQ(I)", "1+2*I", 0, 7),
        ("QQ(sqrt(-7))", -1, 0, -1),
        ("GF(5)(t)", 2, 0, "t"),
        ("GF(3)(t)", "t", 0, "t+1"),
        ("GF(2)(t)", 1, 1, "t"),
        ("GF(4)(t)", "x", 1, "t+1"),
        ("QQ(x)", "x", 0, "x-2"),
    ],
)
def test_isomorphic_presentations(name, a, t, b):
    F, c = ring(name), constants(name, a, t, b)
    rng = random.Random(2)
    for _ in range(3):
        d = another_presentation(F, c, rng)
        assert is_isomorphic(F, c, d)
        m = isomorphism(F, c, d)
        assert m is not None
        p, q = (tuple(F(rng.randint(-3, 3)) for _ in range(4)) for _ in range(2))
        image = m(multiply(c, p, q))
        assert all(F.equal(x, y) for x, y in zip(image, multiply(d, m(p), m(q)), strict=True))
        assert all(F.equal(x, y) for x, y in zip(m.inverse(m(q)), q, strict=True))


@subcases(
    ("name", "one", "other", "answer"),
    [
        ("QQ", (-1, 0, -1), (-2, 0, -5), False),
        ("QQ", (-1, 0, -1), (-1, 0, 1), False),
        ("QQ", (-1, 0, -1), (-1, 0, -2), True),
        ("QQ(x)", ("x", 0, "x-2"), ("x", 0, "x-3"), False),
        ("QQ(x)", (2, 0, 3), (5, 0, 3), False),
        ("QQ(x)", (2, 0, 3), (-1, 0, 3), True),
        ("QQ(x)", (2, 0, 3), ("2*(x^2+1)^2", 0, 3), True),
        ("GF(5)(t)", (2, 0, "t"), (2, 0, "t+1"), False),
        ("QQ(sqrt(5))", (-1, 0, -1), (-1, 0, "sqrt(5)"), False),
        ("RR", (-1, 0, -1), (1, 0, 1), False),
        ("QQ", (0, 0, 3), (0, 0, 12), True),
        ("QQ", (0, 0, 3), (5, 0, 0), False),
        ("QQ", (0, 0, 0), (5, 0, 0), False),
        ("QQ", (0, 0, 0), (-1, 2, 0), True),
        ("QQ", (0, 0, 3), (-1, 0, -1), False),
        ("GF(2)", (1, 0, 1), (1, 1, 1), False),
    ],
)
def test_is_isomorphic(name, one, other, answer):
    F = ring(name)
    c, d = constants(name, *one), constants(name, *other)
    assert is_isomorphic(F, c, d) == answer
    assert is_isomorphic(F, d, c) == answer
    if not answer:
        assert isomorphism(F, c, d) is None


def test_what_is_not_compared():
    with pytest.raises(UndecidedError, match="fields only"):
        is_isomorphic(ring("ZZ"), constants("ZZ", 1, 0, 1), constants("ZZ", 0, 0, 1))
    with pytest.raises(MixedParentsError, match="GF\\(5\\)"):
        same_parent(ring("GF(5)"), ring("GF(7)"))
    same_parent(ring("GF(5)"), ring("GF(5)"))
