"""The checker's own arithmetic agrees with that of the base rings."""

import random

import pytest

from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.fields.names import ring
from tests.checker import ring_data as data
from tests.subcases import subcases

COMMUTATIVE_RINGS = (
    *("QQ", "ZZ", "ZZ/12", "GF(13)", "GF(4)", "GF(9)", "GF(9, x^2+1)", "GF(2^8)", "GF(125)"),
    *(
        "QQ(I)",
        "QQ(sqrt(2))",
        "QQ(sqrt(-7))",
        "QQ(x)",
        "GF(2)(t)",
        "GF(5)(t)",
        "GF(4)(t)",
        "QQ[x,y]",
    ),
)


@subcases("name", COMMUTATIVE_RINGS)
def test_arithmetic_agrees(name: str) -> None:
    F = ring(name)
    G = read_ring(F.data)
    assert G.name == F.name
    rng = random.Random(1)
    for _ in range(40):
        x, y = F.random(rng), F.random(rng)
        u, v = G.read(F.text(x)), G.read(F.text(y))
        assert G.equal(G.add(u, v), G.read(F.text(x + y)))
        assert G.equal(G.mul(u, G.neg(v)), G.read(F.text(F.zero - x * y)))
        assert G.is_zero(u) == F.is_zero(x)
        inverse = G.inverse(u)
        assert (inverse is not None) == F.is_unit(x)
        if inverse is not None:
            assert G.equal(inverse, G.read(F.text(F.inverse(x))))
    assert (G.characteristic, G.order, G.is_field) == (F.characteristic, F.order, F.is_field)


GF4, NOTHING = data.finite(2, 2, [1, 1, 1]), {"kind": ""}
NO_RINGS = (
    (data.finite(1), "at least 2"),
    (data.finite(6), "not a prime number"),
    (data.finite(3, 2, [2, 0, 1]), "reducible"),
    (data.finite(3, 2, [1, 0, 0, 1]), "is monic, of the degree 2"),
    (data.finite(2, 4, [1, 0, 1, 0, 1]), "reducible"),
    (data.quadratic(4), "squarefree"),
    (data.functions(data.QQ, "i"), "cannot name a variable"),
    (data.functions(data.finite(5), "e"), "cannot name a variable"),
    (data.functions(data.RR, "x"), "over QQ, a number field or a finite field"),
    (data.functions(GF4, "x"), "already means an element"),
    (data.polynomials(data.residues(6), "x"), "over ZZ, QQ, a number field or GF"),
    (data.polynomials(data.QQ, "x", "x"), "comes twice"),
    (data.polynomials(data.QQ), "has 0 entries"),
    (data.residues(1), "at least 2"),
    (data.finite(None), "must be an integer"),
    (NOTHING, "are not known here"),
    ({}, "the kind of a ring must be a text"),
)


@subcases(("ring", "why"), NO_RINGS)
def test_what_is_no_ring(ring: data.Data, why: str) -> None:
    with pytest.raises(Rejected, match=why):
        read_ring(ring)
