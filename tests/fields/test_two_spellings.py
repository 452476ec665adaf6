"""Whatever QQ(sqrt(d)) can do, QQ[s]/(s^2-d) can, and the answers agree."""

from itertools import islice
from random import Random

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.algebra.embedding import embedding
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ring import NumberField
from tests.fields.general_fields import moved, place_of
from tests.subcases import share_quick

FIELDS = (5, 2, -5, -23, 13, -1, 10, 17, -7)


def spellings(d: int) -> tuple[NumberField, NumberField]:
    """Return the field by its square root and by its polynomial."""
    return ring("QQ(I)" if d == -1 else f"QQ(sqrt({d}))"), ring(f"QQ[s]/(s^2-({d}))")


def test_both_have_the_same_public_names() -> None:
    F, K = spellings(5)
    names = [{name for name in dir(x) if not name.startswith("_")} for x in (F, K)]
    assert isinstance(F, type(K))
    assert names[1] <= names[0]
    P, Q = (x.primes_above(11)[0] for x in (F, K))
    assert {n for n in dir(Q) if not n.startswith("_")} <= {*dir(P)}
    v, w = (x.real_places()[0] for x in (F, K))
    assert {n for n in dir(w) if not n.startswith("_")} <= {*dir(v)}


@pytest.mark.parametrize("d", share_quick(FIELDS, 4))
def test_elements_primes_and_groups_agree(d: int) -> None:
    F, K = spellings(d)
    there, back, rng = embedding(F, K), embedding(K, F), Random(d)
    for _ in range(5):
        x, y = F.random(rng), F.random(rng)
        assert isinstance(x, FieldElement)
        assert back(there(x)) == x
        assert there(x * y) == there(x) * there(y)
        assert (F.norm(x), F.trace(x)) == (K.norm(there(x)), K.trace(there(x)))
        assert F.embed(x).overlaps(K.embed(there(x)))
        assert x.minimal_polynomial() == there(x).minimal_polynomial()
        assert F(F.text(x)) == x
    for p in (2, 3, 5, 11):
        for P in F.primes_above(p):
            Q = place_of(K, P)
            assert (P.norm(), P.e, P.f) == (Q.norm(), Q.e, Q.f)
            assert P.residue_field.order == P.norm()
            assert P.reduce(F.gen) ** 2 == P.residue_field(F.d)
            assert F.ideal(str(P)) == F.ideal(P)
            assert bool(F.ideal(P).is_principal()) == bool(K.ideal(Q).is_principal())
    assert F.discriminant() == K.discriminant()
    assert F.signature == K.signature
    assert F.class_group().invariants == K.class_group().invariants
    assert F.unit_group().torsion_order == K.unit_group().torsion_order
    for u in F.unit_group().generators:
        assert abs(K.norm(moved(K, u))) == 1


@pytest.mark.parametrize("d", [5, 2])
def test_orders_over_both_agree(d: int) -> None:
    classes = []
    for K in spellings(d):
        order = QuaternionAlgebra(K, -1, -1).maximal_order()
        C = order.class_set()
        classes.append(
            (len(C), C.mass, str(order.discriminant().norm()), len(order.units_modulo_scalars()))
        )
    assert classes[0] == classes[1]


@pytest.mark.parametrize("d", [5, -7, 2])
def test_places_agree(d: int) -> None:
    F, K = spellings(d)
    rng = Random(d)
    for v in islice(F.places(), 8):
        w = place_of(K, v)
        for _ in range(5):
            a, b = (F.random(rng) or F.one for _ in range(2))
            A, B = QuaternionAlgebra(F, a, b), QuaternionAlgebra(K, moved(K, a), moved(K, b))
            assert (v in A.ramified_places()) == (w in B.ramified_places())
            assert A.is_division_algebra() == B.is_division_algebra()
