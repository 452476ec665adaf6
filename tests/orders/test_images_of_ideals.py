"""Images of ideals of a quadratic order under an embedding, in definite and indefinite orders."""

import pytest

from hfield import H, LatticeError, Order, QuaternionAlgebra, ring
from hfield.errors import HFieldError

ORDERS = [
    (QuaternionAlgebra("QQ", -1, -11).maximal_order(), -20),
    (QuaternionAlgebra("QQ", -1, -11).eichler_order(3), -23),
    (QuaternionAlgebra(6).maximal_order(), -24),
    (QuaternionAlgebra(6).eichler_order(5), 29),
    (QuaternionAlgebra("QQ", 1, 1).maximal_order(), -23),
]


@pytest.mark.parametrize(("O", "d"), ORDERS, ids=str)
def test_images_of_ideals(O: Order, d: int) -> None:
    """Norms, products and the intersection with the field are those of the ideals."""
    K, E = ring(f"QQ(sqrt({d}))"), O.embeddings(d)
    for x, y in ((K.gen, 3 + K.gen), ((5 - K.gen) / 3, 2 * K.gen)):
        assert E.image(x * y + y) == E.image(x) * E.image(y) + E.image(y)
        assert E.image(x).norm() == x.norm()
        assert E.image(x).trace() == x.trace()
    P, Q = K.primes_above(3)[0], K.primes_above(13)[-1]
    for a in (P, Q):
        I, J = E.ideal(a), E.ideal(a, side="right")
        assert (I.side, J.side) == ("left", "right")
        assert I.norm() == J.norm() == a.norm()
        assert I.is_invertible()
        assert I.left_order() == O == J.right_order()
        for x in (K.gen, K.gen + 1, K.gen - 1, K.gen + 2, K(3), K(13), K(2)):
            assert (E.image(x) in I) == K.ideal(a).contains(x)
    a, b = K.ideal(P), K.ideal(Q)
    product = O.left_ideal([x * E.image(y) for x in E.ideal(a).basis for y in b.basis])
    assert product == E.ideal(a * b)
    assert E.ideal([1]) == O
    assert E.ideal(K.ideal(K.gen)) == O.left_ideal([E.image(K.gen)])


def test_other_names_of_the_field() -> None:
    E = QuaternionAlgebra(6).maximal_order().embeddings(-24)
    K, L = ring("QQ(sqrt(-6))"), ring("QQ[s]/(s^2-2*s+25)")  # s = 1 + 2·√−6
    assert E.image(L.gen) == E.image(1 + 2 * K.gen)
    assert E.image((3, 2)) == 3 + 2 * E.element
    assert E.image(5) == 5
    assert E.ideal(L.primes_above(5)[0]).norm() == 5


def test_ideals_of_an_order_that_is_not_maximal() -> None:
    """7 splits in the order of discriminant −27: of the ideals (7, n + x) two are proper."""
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    E = O.embeddings(-27)
    root = 2 * E.element - E.element.trace()
    assert root**2 == -27
    norms = [E.ideal([7, (n, 1)]).norm() for n in range(7)]
    assert sorted(norms) == [1, 1, 1, 1, 1, 7, 7]


def test_over_a_number_field() -> None:
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    E = A.maximal_order().embeddings(-3)
    assert E.ideal([A.ring.gen, (1, 2)]).norm() == A.ring.ideal(1)  # N(1 + 2x) = 1 − 6 + 12 = 7
    assert E.ideal([7, (1, 2)]).norm() == A.ring.ideal(7)
    assert E.image((A.ring.gen, 0)) == A.ring.gen
    assert E.ideal([2]).norm() == A.ring.ideal(4)


def test_what_is_refused() -> None:
    O = QuaternionAlgebra(6).maximal_order()
    with pytest.raises(LatticeError, match="there is no embedding: 2 splits"):
        O.embeddings(-7).ideal([1])
    with pytest.raises(LatticeError, match="not in the field of √"):
        O.embeddings(-24).image(ring("QQ(sqrt(6))").gen)
    with pytest.raises(LatticeError, match="not in the field of √"):
        O.embeddings(-24).ideal(ring("QQ(sqrt(-5))").primes_above(3)[0])
    with pytest.raises(LatticeError, match="rank"):
        H("QQ").hurwitz_order().embeddings(-4).ideal([0])


@pytest.mark.parametrize("x", ["i", ("i", 1), (1, "1+j"), (1, 2, 3), (1,), 1.5])
def test_only_numbers_have_an_image(x: object) -> None:
    """An element of the algebra is none of the quadratic field."""
    O, d = ORDERS[0]
    with pytest.raises(HFieldError):
        O.embeddings(d).image(x)
