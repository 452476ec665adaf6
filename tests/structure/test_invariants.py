import random

import pytest
from structure_cases import constants

from hfield.errors import UndecidedError
from hfield.product import multiply, norm
from hfield.rings import ring
from hfield.structure.commutators import basis_of
from hfield.structure.elements import is_nilpotent
from hfield.structure.invariants import derivations, is_central_simple, radical, to_opposite

ALGEBRAS = [
    ("QQ", -1, 0, -1, 0, 3),
    ("QQ", 2, 0, 0, 2, None),
    ("QQ", 0, 0, 0, 3, None),
    ("QQ", "-1/4", 1, 3, 2, None),
    ("GF(2)", 1, 1, 1, 0, 3),
    ("GF(2)", 1, 0, 1, 3, None),
    ("GF(2)", 1, 1, 0, 2, None),
    ("GF(4)", "x", 0, "x+1", 3, None),
    ("GF(9)", 0, 0, "x", 2, None),
    ("GF(2)(t)", "t", 0, "t+1", 2, None),
    ("GF(2)(t)", "t^2", 0, 1, 3, None),
    ("GF(4)(t)", "t", 1, "x", 0, 3),
    ("RR", "sqrt(2)", 0, 0, 2, None),
]


@pytest.mark.parametrize(("name", "a", "t", "b", "size", "outer"), ALGEBRAS)
def test_the_radical_is_a_nilpotent_ideal(name, a, t, b, size, outer):
    F, c = ring(name), constants(name, a, t, b)
    basis = radical(F, c)
    assert len(basis) == size
    assert is_central_simple(F, c) == (size == 0)
    rng = random.Random(1)
    for q in basis:
        for u in (*basis_of(F), tuple(F.random(rng) for _ in range(4))):
            assert is_nilpotent(F, c, multiply(c, u, q))
            assert is_nilpotent(F, c, multiply(c, q, u))
    total = [sum((x[n] for x in basis[1:]), basis[0][n]) if basis else F.zero for n in range(4)]
    assert F.is_zero(norm(c, tuple(total)))


@pytest.mark.parametrize(("name", "a", "t", "b", "size", "outer"), ALGEBRAS[:10])
def test_derivations_satisfy_leibniz(name, a, t, b, size, outer):
    F, c = ring(name), constants(name, a, t, b)
    found = derivations(F, c)
    assert outer is None or len(found) == outer
    rng = random.Random(2)
    p, q = (tuple(F.random(rng) for _ in range(4)) for _ in range(2))

    def apply(matrix, v):
        return [
            sum((x * y for x, y in zip(row[1:], v[1:], strict=True)), row[0] * v[0])
            for row in matrix
        ]

    for d in found:
        left = apply(d, multiply(c, p, q))
        terms = zip(
            multiply(c, tuple(apply(d, p)), q), multiply(c, p, tuple(apply(d, q))), strict=True
        )
        assert all(F.equal(x, y + z) for x, (y, z) in zip(left, terms, strict=True))
        assert all(F.is_zero(row[0]) for row in d)  # D(1) = 0


@pytest.mark.parametrize(("name", "a", "t", "b", "size", "outer"), ALGEBRAS)
def test_the_opposite_algebra(name, a, t, b, size, outer):
    F, c = ring(name), constants(name, a, t, b)
    rng = random.Random(3)
    p, q = (tuple(F.random(rng) for _ in range(4)) for _ in range(2))
    left, right = (
        to_opposite(c, multiply(c, p, q)),
        multiply(c, to_opposite(c, q), to_opposite(c, p)),
    )
    assert all(F.equal(x, y) for x, y in zip(left, right, strict=True))
    assert all(F.equal(x, y) for x, y in zip(to_opposite(c, to_opposite(c, q)), q, strict=True))


def test_rings_that_are_not_fields():
    with pytest.raises(UndecidedError, match="not a field"):
        radical(ring("ZZ"), constants("ZZ", -1, 0, -1))
    assert not is_central_simple(ring("ZZ"), constants("ZZ", -1, 0, -1))
    assert len(derivations(ring("ZZ"), constants("ZZ", -1, 0, -1))) == 3
