"""Ideals over ℤ and over the integers of number fields: one class, with one meaning of its methods."""

import math
import pickle
from fractions import Fraction
from random import Random

import pytest

from hfield import Ideal, QuaternionAlgebra, ring
from hfield.errors import IndefiniteError, LatticeError, UndecidedError
from hfield.fields.rationals.whole_numbers import square_root
from hfield.orders import conjugators

FIELDS = ("QQ", "QQ[s]/(s-1)", "QQ(sqrt(5))", "QQ(sqrt(3))")


def orders(field: str):
    """A maximal order, and one that is no Eichler order, of a totally definite algebra."""
    A = QuaternionAlgebra(ring(field), -1, -1)
    O = A.maximal_order()
    return O, A.order([3 * b for b in O.basis])


def element(A, rng):
    return A(*(rng.randint(-3, 3) for _ in range(3)), 1)


def ideal(O, p, side="left"):
    """An ideal that is not principal where there is one of a prime norm over p."""
    K = O.algebra.ring
    P = p if K.name == "QQ" else K.primes_above(p)[0]
    return O.ideals_of_norm(P, side)[0]


@pytest.mark.parametrize("field", FIELDS)
def test_arithmetic_gives_ideals(field: str) -> None:
    for O in orders(field):
        x = element(O.algebra, Random(1))
        I, J = ideal(O, 5), ideal(O, 7)
        for found in (I + J, I & J, 2 * I, I * 2, I / 3):
            assert type(found) is Ideal
            assert (found.side, found.order) == ("left", O)
        assert type(I + J.conjugate()) is not Ideal
        assert I * x == O.left_ideal([b * x for b in I.basis])
        assert (x * I).side == "left"
        assert x * I.conjugate() == (I * x.conjugate()).conjugate()
        assert I.conjugate() * J == O.algebra.lattice(
            [p * q for p in I.conjugate().basis for q in J.basis]
        )
        assert I.inverse() * I == I.right_order()
        J, m = (2 * I).primitive_part()
        assert (J, J.side, J.order) == (I, "left", O)
        assert m == 2
        with pytest.raises(LatticeError, match="integral"):
            (I / 2).primitive_part()
        again = pickle.loads(pickle.dumps(I))
        assert (again, again.side, again.order) == (I, I.side, O)


@pytest.mark.parametrize("field", FIELDS)
def test_two_sided_ideals(field: str) -> None:
    O = QuaternionAlgebra(ring(field), -1, -3).eichler_order(5)
    for p in (3, 5):
        P = O.two_sided_prime(p if field == "QQ" else O.algebra.ring.primes_above(p)[0])
        assert P.side == P.conjugate().side == (P & P).side == (3 * P).side == "two-sided"
        assert P.is_two_sided()
        assert P.left_order() == P.right_order() == O
        assert P.evidence["side"] == "two-sided"
        x = element(O.algebra, Random(p))
        answer = P.equivalence(P * x)
        assert P * answer.element == P * x
        right = O.right_ideal([x * b for b in P.basis])
        assert P.equivalence(right).element * P == right
        assert Ideal.like(O.algebra.lattice(P.basis), O, "two-sided") == P
    I = ideal(O, 7)
    with pytest.raises(LatticeError, match="not a two-sided ideal"):
        Ideal.like(I, O, "two-sided")
    assert (O.two_sided_ideal([2]) & I).side == "left"


@pytest.mark.parametrize("field", FIELDS)
def test_pushforward_and_pullback(field: str) -> None:
    for O in orders(field):
        I, J = ideal(O, 5), ideal(O, 7)
        found = I.pushforward(J)
        assert found.left_order() == I.right_order()
        assert found.norm() == J.norm()
        assert I * found == I & J
        assert I.pullback(found) == J
        with pytest.raises(LatticeError, match="coprime"):
            I.pushforward(I)
        with pytest.raises(LatticeError, match="coprime"):
            (I / 3).pushforward(J)


@pytest.mark.parametrize("field", FIELDS)
def test_equivalence_of_ideals_that_are_not_invertible(field: str) -> None:
    A = QuaternionAlgebra(ring(field), -1, -1)
    O = A.order(["i", "j"])
    I = O.left_ideal([2, "1 + i", "1 + j"])
    assert not I.is_invertible()
    x = element(A, Random(2))
    assert I * I.equivalence(I * x).element == I * x
    R = I.conjugate()
    assert R.equivalence(x * R).element * R == x * R
    no = I.is_principal()
    assert not no
    assert "square" in no.reason
    assert no.claim.verdict == "refuted"


@pytest.mark.parametrize("field", FIELDS)
def test_equivalence_of_lattices_that_are_invertible_over_no_order(field: str) -> None:
    A = QuaternionAlgebra(ring(field), -1, -1)
    O = A.order([3 * x for x in A.maximal_order().basis])
    D = O.dual()  # O is not a Gorenstein order
    I = O.left_ideal(D.basis)
    assert not I.is_invertible()
    x = element(A, Random(3))
    assert I * I.equivalence(I * x).element == I * x
    R = I.conjugate()
    assert R.equivalence(x * R).element * R == x * R


@pytest.mark.parametrize("field", FIELDS[:3])
def test_equivalence_and_the_keys_of_class_sets(field: str) -> None:
    O = QuaternionAlgebra(ring(field), -1, -31).maximal_order()
    K = O.algebra.ring
    some = (3, 5, 11) if field == "QQ" else (K.primes_above(p)[0] for p in (3, 5, 11))
    ideals = [I for P in some for I in O.ideals_of_norm(P)[::3]]
    C, answers = O.class_set(), set()
    numbers = [C.index(I.conjugate()) for I in ideals]
    for I, m in zip(ideals, numbers, strict=True):
        for J, n in zip(ideals, numbers, strict=True):
            answer = I.equivalence(J)
            assert bool(answer) == (m == n)
            assert not answer or I * answer.element == J
            assert answer or answer.reason
            answers.add(bool(answer))
    assert answers == {True, False}


@pytest.mark.parametrize("field", ["QQ", "QQ[s]/(s-1)", "QQ(sqrt(5))"])
def test_indefinite_orders_are_isomorphic_with_the_element(field: str) -> None:
    if field == "QQ(sqrt(5))":
        K = ring(field)
        A = QuaternionAlgebra.from_ramification(K, [K.real_places()[0], K.primes_above(11)[0]])
    else:
        A = QuaternionAlgebra(ring(field), -1, 3)
    O = A.eichler_order(5) if field != "QQ(sqrt(5))" else A.maximal_order()
    x = element(A, Random(3))
    for order in (O, A.order([3 * b for b in O.basis])):
        moved = (x * order * x.inverse()).left_order()
        answer = order.isomorphism(moved)
        assert answer
        if answer.element is not None:
            y = answer.element
            assert y * order * y.inverse() == moved
        assert order.isomorphism(order).element == 1
        assert not order.isomorphism(A.order([2 * b for b in O.basis]))
        assert order.isomorphism(A.order([2 * b for b in O.basis])).claim.verdict == "refuted"
        assert order.unit_group() == "infinite"


@pytest.mark.parametrize("field", ["QQ", "QQ(sqrt(5))"])
def test_conductors_tell_indefinite_orders_apart(field: str) -> None:
    K = ring(field)
    A = QuaternionAlgebra.from_ramification(
        K, (5, 11) if field == "QQ" else [K.real_places()[0], K.primes_above(11)[0]]
    )
    O, P = A.order([2 * b for b in A.maximal_order().basis]), A.eichler_order(8)
    assert O.discriminant() == P.discriminant()
    answer = O.isomorphism(P)
    assert not answer
    assert "conductors" in answer.reason
    assert answer.certificate is None
    assert "tell them apart" in answer.why_no_certificate


def test_certificates_of_answers_in_indefinite_algebras() -> None:
    seen = set()
    for field, a, b in (("QQ", -1, 3), ("QQ(sqrt(10))", "sqrt(10)", -1), ("QQ(sqrt(10))", -1, 3)):
        O = QuaternionAlgebra(field, a, b).maximal_order()
        for p in (5, 7, 13):
            answer = ideal(O, p).is_principal()
            kind = (bool(answer), answer.element is not None)
            assert (answer.certificate is not None) == (answer.element is not None)
            assert (answer.theorem is not None) == (kind == (True, False))
            assert kind != (True, False) or "strong approximation" in answer.why_no_certificate
            seen.add(kind)
    assert len(seen) == 3


def test_isomorphisms_that_norms_of_ideals_decide_are_refused() -> None:
    """Over ℚ(√10) there are two classes of ideals, and two-sided ideals would have to be looked at."""
    A = QuaternionAlgebra("QQ(sqrt(10))", -1, 3)
    O = A.maximal_order()
    I = O.classes_by_norm()[1]
    with pytest.raises(IndefiniteError, match="generator"):
        O.isomorphism(I.left_order())


def test_undecided_over_every_base() -> None:
    """Strong approximation tells nothing where the local units have not all norms."""
    for A in (QuaternionAlgebra("QQ(sqrt(2))", -1, 3), QuaternionAlgebra("QQ[s]/(s^2-7)", 3, 5)):
        O = A.order(["i", "4*j"])
        with pytest.raises(UndecidedError, match="Eichler symbols"):
            O.left_ideal([7]).equivalence(O.left_ideal([7 * A.basis[1]]))


@pytest.mark.parametrize("field", FIELDS[1:])
def test_methods_for_norms_that_are_numbers_are_refused(field: str) -> None:
    I = ideal(orders(field)[0], 5)
    with pytest.raises(LatticeError, match="over ZZ"):
        I.equivalent_of_prime_norm()
    with pytest.raises(LatticeError, match="over ZZ"):
        I.equivalent_of_power_norm(2)


def test_conjugators_over_the_integers_by_two_ways() -> None:
    """Reduced bases of ternary lattices, and images of two elements."""
    rng, answers = Random(4), set()
    for d in (11, 37, 23):
        O = QuaternionAlgebra(d).maximal_order()
        some = [I.right_order() for p in (2, 3) for I in O.ideals_of_norm(p)]
        for P in some:
            Q = rng.choice(some)
            found = [
                way(P.value, Q.value)[0]
                for way in (conjugators.conjugator, conjugators.by_two_images)
            ]
            assert (found[0] is None) == (found[1] is None)
            assert all(x is None or x * P * x.inverse() == Q for x in found)
            answers.add(found[0] is None)
    assert answers == {True, False}


def test_square_roots_of_rational_numbers() -> None:
    for n in range(-4, 40):
        for d in range(1, 10):
            x, found = Fraction(n, d), square_root(Fraction(n, d))
            assert found is None or found * found == x
            assert (found is not None) == (n >= 0 and math.isqrt(n * d) ** 2 == n * d)
