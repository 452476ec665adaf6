"""The checker's own arithmetic agrees with that of the base rings."""

import random

import pytest

from hfield.certificates.rejection import Rejected
from hfield.certificates.scalars.fields import read_field
from hfield.rings import ring

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


@pytest.mark.parametrize("name", COMMUTATIVE_RINGS)
def test_arithmetic_agrees(name: str) -> None:
    F = ring(name)
    G = read_field(F.name)
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


NO_RINGS = (
    *("GF(1)", "GF(6)", "GF(9, x^2+2)", "GF(9, x^3+1)", "GF(16, (x^2+x+1)^2)", "QQ(sqrt(4))", ""),
    *(
        "QQ(i)",
        "GF(5)(e)",
        "QQ(sqrt(2))(x)",
        "ZZ/6[x]",
        "QQ[x,x]",
        "GF(4)(x)",
        "RR(x)",
        "ZZ/1",
        "GF()",
    ),
)


@pytest.mark.parametrize("name", NO_RINGS)
def test_what_is_no_ring(name: str) -> None:
    with pytest.raises(Rejected):
        read_field(name)
