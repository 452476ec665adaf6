"""Quadratic fields in algebras: against splitting over them, symbols, and the equation itself."""

from random import Random

import pytest

from hfield import (
    CoercionError,
    H,
    HFieldError,
    QuaternionAlgebra,
    RingError,
    UndecidedError,
    hilbert_symbol,
    ring,
)


def over(primes):
    return QuaternionAlgebra.from_ramification("QQ", primes)


def is_root(found):
    x = found.element
    return x * x == x * found.trace - found.norm and bool(x.vector_part)


@pytest.mark.parametrize("primes", [(2, 3), (2, "inf"), (3, "inf"), (5, 7), (2, 3, 5, "inf"), ()])
def test_embeddings_over_the_rationals(primes):
    A = over(primes)
    for d in (-1, -2, -3, 2, 3, 5, -7, 6, -15, 21, -23):
        found = A.embed(d)
        field = ring(f"QQ(sqrt({d}))")
        assert bool(found) == A.change_ring(field).is_isomorphic(QuaternionAlgebra(field, 1, 1)), d
        if found:
            assert found.element**2 == d
        else:
            assert found.place in A.ramified_places()
            assert all(hilbert_symbol(d, n, found.place) == 1 for n in (-1, 2, 3, 5, 7))


def test_fields_embed():
    A = over((2, "inf"))
    L = ring("QQ[s]/(s^2-s+3)")
    x = A.embed(L).element
    assert x * x - x + 3 == 0
    assert A.embed(ring("QQ(I)")).element ** 2 == -1
    assert not A.embed(ring("QQ(sqrt(2))"))


@pytest.mark.parametrize("base", ["QQ(sqrt(2))", "QQ(I)"])
def test_relative_extensions_embed_where_they_split(base):
    K, rng, split = ring(base), Random(7), set()
    for _ in range(4):
        A = QuaternionAlgebra(K, rng.choice((-1, -3, 2)), K.gen * 2 + rng.randint(-3, 3))
        for d in (-1, -3, K.gen, K.gen - 5):
            if K.is_square(K(d)):
                continue
            found = A.embed([-K(d), 0, 1])
            split.add(bool(found))
            if found:
                assert is_root(found)
                assert found.element**2 == K(d)
            else:
                assert found.place in A.ramified_places()
                for b in (-1, 2, 3, K.gen, K.gen + 1):
                    assert not K(b) or hilbert_symbol(K(d), K(b), found.place) == 1
    assert split == {True, False}


@pytest.mark.parametrize(
    ("base", "name"),
    [
        ("QQ(sqrt(2))", "QQ(sqrt(2),I)"),
        ("QQ(sqrt(2))", "QQ(sqrt(2),sqrt(3))"),
        ("QQ(sqrt(2))", "QQ[s]/(s^4-2)"),
        ("QQ(sqrt(-3))", "QQ(zeta12)"),
        ("QQ[s]/(s^3-2)", "QQ[r]/(r^6+108)"),
    ],
)
def test_fields_above_number_fields(base, name):
    L, split = ring(name), set()
    for a, b in ((-1, -1), (-1, -7), (-1, 3)):
        A = QuaternionAlgebra(base, a, b)
        found = A.embed(name)
        assert bool(found) == A.change_ring(L).is_isomorphic(QuaternionAlgebra(L, 1, 1))
        split.add(bool(found))
        assert is_root(found) if found else found.place in A.ramified_places()
    assert True in split


@pytest.mark.parametrize("field", ["GF(2)(t)", "GF(4)(t)", "GF(8)(t)"])
def test_characteristic_2(field):
    F, rng, kinds = ring(field), Random(5), set()
    t, small = F.gen, [F.constant(c) for c in F.base.elements()]

    def random(degree):
        return sum((rng.choice(small) * t**n for n in range(degree + 1)), F.zero)

    for _ in range(25):
        a, m = (random(2) / (t + rng.choice(small)) for _ in range(2))
        b = random(3)
        if not b:
            continue
        A = QuaternionAlgebra(F, a, b, 1)
        try:
            found = A.embed([m, 1, 1])
        except RingError:  # y^2 + y + m has a root
            continue
        kinds.add(bool(found))
        if found:
            x = found.element
            assert x * x + x == m
        else:
            assert found.place in A.ramified_places()
        others = [t + c for c in small] + [t**3 + t + 1, t / (t + 1)]
        for place in A.ramified_places():
            prime = [] if str(place) == "inf" else [F(str(place))]
            splits = all(hilbert_symbol(m, y, place) == 1 for y in others + prime)
            assert splits <= (not found)
            if place == found.place:
                assert splits
    assert kinds == {True, False}


def test_every_way_to_name_an_extension():
    A = QuaternionAlgebra(-1, -3)
    P = A.polynomials("y")
    for given in ("x^2+x+1", "QQ(zeta3)", ring("QQ(zeta3)"), [1, 1, 1], P([1, 1, 1]), "i^2+i+1"):
        found = A.embed(given)
        assert is_root(found)
        assert found.trace**2 - 4 * found.norm == -3
    assert A.embed("-3").element ** 2 == A.embed(-3).element ** 2 == -3
    B = QuaternionAlgebra.from_text("[1,t|GF(2)(t))")
    assert B.embed("t+1").element ** 2 == B.ring("t+1")  # inseparable
    assert is_root(B.embed("GF(4)(t)"))
    assert is_root(B.embed("GF(2)(t)[y]/(y^2+y+1)"))
    assert B.embed("GF(2)(t)[y]/(y^2+y+t)").place in B.ramified_places()
    C = QuaternionAlgebra("GF(3)(t)", "t", 2)
    assert is_root(C.embed("GF(9)(t)"))
    assert C.embed("x^2+x+t").place in C.ramified_places()
    for field, L in (("GF(7)", "GF(49)"), ("GF(4)", "GF(16)"), ("GF(9)", "GF(81)"), ("RR", "CC")):
        D = QuaternionAlgebra(field, 1, -1, 1)
        assert is_root(D.embed(L))
    two = H("Qp(2)").embed(5)
    assert two.element.trace() == 0
    assert two.element.norm().value == 0 or two.element


def test_functions():
    A = QuaternionAlgebra("QQ(x)", -1, "x")
    assert is_root(A.embed("x"))
    assert str(A.embed("x+1").place) == "x"
    assert H("QQ(x)").embed(2).place is not None
    B = QuaternionAlgebra("QQ(x,y)", "x", "y")
    assert is_root(B.embed("x+y"))
    assert "residue forms" in B.embed("x*y").reason


def test_what_is_no_extension():
    A = H("QQ")
    for d in (
        4,
        0,
        "x^2-1",
        "x^3-2",
        "QQ(x)",
        "QQ[s]/(s^3-2)",
        ring("GF(9)"),
        "zz",
        "x^2+i",
        [1, 2],
    ):
        with pytest.raises(HFieldError, match=r"extension|square|root|degree 2|outside"):
            A.embed(d)
    with pytest.raises(RingError, match="square"):
        QuaternionAlgebra.from_text("[1,t|GF(2)(t))").embed("t^2")
    with pytest.raises(RingError, match="root"):
        QuaternionAlgebra.from_text("[1,t|GF(2)(t))").embed("x^2+x+t^2+t")
    with pytest.raises(CoercionError, match="not central simple"):
        H("GF(2)").embed(1)
    with pytest.raises(UndecidedError, match="inexact"):
        H("RDF").embed(-1)
