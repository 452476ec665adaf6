"""The one formula against Cayley and Dickson's doubling, over all rings of order up to 16."""

import random

import pytest

from hfield.core.product import Constants, conjugate, multiply, norm, trace
from tests.adversary.meaning import World
from tests.adversary.scalars import Integers, Residues

RINGS = (*(Residues(n) for n in (2, 3, 4, 8, 9, 12)), Integers())


class Element:
    """An element that knows + − × of its ring and nothing else."""

    def __init__(self, ring, value):
        self.ring, self.value = ring, value

    def __add__(self, other):
        return Element(self.ring, self.ring.add(self.value, other.value))

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        return Element(self.ring, self.ring.mul(self.value, other.value))

    def __neg__(self):
        return Element(self.ring, self.ring.neg(self.value))


@pytest.mark.parametrize("ring", RINGS, ids=lambda r: f"{type(r).__name__}{getattr(r, 'n', '')}")
def test_product_conjugate_norm_and_trace(ring):
    rng = random.Random(0)
    for _ in range(60):
        a, t, b = (ring.some(rng) for _ in "atb")
        p, q = (tuple(ring.some(rng) for _ in range(4)) for _ in "pq")
        c = Constants(*(Element(ring, x) for x in (a, t, b)))
        u, v = (tuple(Element(ring, x) for x in r) for r in (p, q))
        names = (("name", "a"), ("name", "t"), ("name", "b"))
        world = World(ring, names, {"a": a, "t": t, "b": b})
        assert [x.value for x in multiply(c, u, v)] == list(world.times(p, q))
        assert [x.value for x in conjugate(c, u)] == list(world.conjugate(p))
        assert norm(c, u).value == world.norm(p)
        assert trace(c, u).value == ring.add(p[0], world.conjugate(p)[0])
