"""The checker's own arithmetic agrees with that of the base rings."""

import random

import pytest

from hfield.certificates.places import cited_for_norm
from hfield.certificates.rejection import Rejected
from hfield.certificates.scalars.fields import read_field
from hfield.product import Constants
from hfield.rings import ring
from hfield.structure import zero_norm

RINGS = (
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


@pytest.mark.parametrize("name", RINGS)
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


@pytest.mark.parametrize(
    ("field", "root"),
    [("QQ", ""), ("QQ(sqrt(-7))", "sqrt(-7)"), ("QQ(sqrt(2))", "sqrt(2)"), ("QQ(I)", "I")],
)
def test_reasons_for_anisotropic_norms(field: str, root: str) -> None:
    """What the structure room gives as reason is verified; at a split algebra no reason is."""
    F = ring(field)
    rng = random.Random(2)
    primes = ["2", "3", "5", "7", "11", "13"]
    split = (
        [f"({p}, {root}-{n})" for p in (2, 3, 5, 7, 11) for n in range(1, p + 2)] if root else []
    )
    for _ in range(25):
        texts = [str(rng.choice([-1, 1]) * rng.randint(1, 30)) for _ in range(2)]
        if root and rng.random() < 0.5:
            texts[0] += f"+{rng.randint(1, 4)}*{root}"
        a, b = (F(text) for text in texts)
        algebra = f"({F.text(a)},{F.text(b)}|{field})"
        answer = zero_norm(F, Constants(a, F.zero, b))
        if answer.element is None:
            places = [str(place) for place in answer.places]
            assert cited_for_norm(algebra, field, answer.method, places) == ()
            continue
        reasons = [("ordering", []), ("level", [])]
        reasons += [("ramified places", [place]) for place in primes + split]
        for by, places in reasons:
            try:
                cited = cited_for_norm(algebra, field, by, places)
            except Rejected:
                continue
            assert cited != ()
