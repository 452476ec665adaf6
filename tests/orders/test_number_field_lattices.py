"""Lattices over the integers of number fields: identities, and the known masses of maximal orders."""

from fractions import Fraction

import pytest

from hfield import LatticeError, QuaternionAlgebra


@pytest.mark.parametrize("field", ["QQ(sqrt(5))", "QQ(sqrt(-5))", "QQ(sqrt(10))", "QQ[s]/(s^3-2)"])
def test_the_identities_of_ideals(field):
    A = QuaternionAlgebra(field, -1, -1)
    O = A.maximal_order()
    I = O.right_ideal([3, A(1, 1, 1, 0)])
    left = I.left_order()
    assert I.right_order() == O
    assert I * I.inverse() == left
    assert I.inverse() * I == O
    assert I * O == I
    assert I + O == O
    assert (I & O) == I
    assert left.index(I) == I.norm() ** 2 == O.index(I)
    assert left.index(O) == 1
    assert O.index(left) * left.index(O) == 1
    assert I.conjugate().norm() == I.norm()
    assert I.conjugate() != I
    assert all(b in I for b in I.basis)
    assert 1 not in I
    both = I & O.right_ideal([2])
    assert both.norm() == I.norm() * 4
    with pytest.raises(LatticeError):
        A.lattice([0, 1])


# The masses 2^(1-n)·|ζ(-1)|·h of fields where a maximal order has one class
@pytest.mark.parametrize("d", [5, 2, 13])
def test_units_of_orders_of_class_number_one(d):
    A = QuaternionAlgebra(f"QQ(sqrt({d}))", -1, -1)
    O = A.maximal_order()
    assert O.discriminant() == A.ring.ideal(1)
    assert Fraction(1, O.unit_index()) == A.ring.zeta_minus_one() / 2


def test_units_of_an_indefinite_order_are_refused():
    with pytest.raises(LatticeError, match="totally definite"):
        QuaternionAlgebra("QQ(sqrt(5))", -1, 1).maximal_order().unit_index()


def test_units_where_a_totally_positive_unit_is_no_square():
    # over QQ(√3) there are two classes of mass 1/12 together, each with an even group of units
    A = QuaternionAlgebra("QQ(sqrt(3))", -1, -1)
    O = A.maximal_order()
    classes = A.ring.zeta_minus_one() / 2
    assert O.discriminant() == A.ring.ideal(1)
    assert classes == Fraction(1, 12)
    assert O.unit_index() == 24


def test_norms_are_generated_by_sums_too():
    # N(1 + i) = 0 and N(3i) = −9, but N(1 + 4i) = −15
    A = QuaternionAlgebra("QQ(sqrt(2))", 1, -1)
    vectors = [A(1, 1, 0, 0), A(0, 3, 0, 0), A(0, 0, 3, 0), A(0, 0, 0, 3)]
    assert A.lattice(vectors).norm() == A.ring.ideal(3)
