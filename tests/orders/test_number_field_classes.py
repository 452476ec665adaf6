"""Ideal classes of definite orders over totally real fields: known values, identities, other formulas."""

from collections import Counter
from fractions import Fraction
from itertools import product
from typing import Any

import flint
import pytest

from hfield import LatticeError, QuaternionAlgebra, ring
from hfield.errors import IndefiniteError, TooLargeError
from hfield.orders import brandt
from hfield.orders.basis import basis_of
from tests.subcases import subcases

# discriminant of K: polynomial, classes and types of the maximal order of discriminant 1, mass
KNOWN = {
    5: ("s^2-s-1", 1, 1, "1/60"), 8: ("s^2-2", 1, 1, "1/24"), 12: ("s^2-3", 2, 2, "1/12"),
    13: ("s^2-s-3", 1, 1, "1/12"), 17: ("s^2-s-4", 1, 1, "1/6"), 21: ("s^2-s-5", 2, 2, "1/6"),
    24: ("s^2-6", 3, 3, "1/4"), 28: ("s^2-7", 3, 3, "1/3"), 33: ("s^2-s-8", 3, 3, "1/2"),
    60: ("s^2-15", 8, 8, "2"), 69: ("s^2-s-17", 5, 5, "1"),
    725: ("s^4-s^3-3*s^2+s+1", 1, 1, "1/60"), 1125: ("s^4-s^3-4*s^2+4*s+1", 2, 2, "1/30"),
    1957: ("s^4-4*s^2-s+1", 1, 1, "1/12"), 2000: ("s^4-5*s^2+5", 3, 3, "1/12"),
    2304: ("s^4-4*s^2+1", 3, 3, "1/8"), 2777: ("s^4-s^3-4*s^2+s+2", 1, 1, "1/6"),
    4352: ("s^4-6*s^2-4*s+2", 4, 4, "1/3"),
}  # fmt: skip


def unramified(polynomial: str) -> QuaternionAlgebra:
    K = ring(f"QQ[s]/({polynomial})")
    return QuaternionAlgebra.from_ramification(K, K.real_places())


@pytest.mark.slow
@subcases("discriminant", KNOWN)
def test_known_class_numbers(discriminant: int) -> None:
    polynomial, classes, types, mass = KNOWN[discriminant]
    A = unramified(polynomial)
    assert A.ring.discriminant() == discriminant
    O = A.maximal_order()
    assert O.discriminant() == 1
    C = O.class_set()
    assert (len(C), C.type_number, C.mass) == (classes, types, Fraction(mass))
    assert sum(Fraction(1, I.left_order().unit_index()) for I in C) == C.mass


def icosians() -> QuaternionAlgebra:
    return QuaternionAlgebra("QQ(sqrt(5))", -1, -1)


def test_levels_over_the_golden_field() -> None:
    A = icosians()
    K = A.ring
    P = K.primes_above(31)[0]
    (root,), elevens = K.primes_above(5), K.primes_above(11)
    C = A.eichler_order([(P, 1)]).class_set()
    assert len(C) == 2
    assert C.hecke_polynomial(root) == [-12, -4, 1]  # (x − 6)(x + 2)
    assert C.hecke_polynomial(K.gen) == [-12, -4, 1]
    inert = C.hecke_polynomial(7)  # (x − 50)(x − 2)
    assert inert == [100, -52, 1]
    assert [48, -16, 1] in [C.hecke_polynomial(Q) for Q in elevens]  # (x − 12)(x − 4)
    assert len(A.eichler_order(3).class_set()) == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "level"),
    [("QQ[s]/(s^2-15)", 7), ("QQ[s]/(s^2-3)", 11), ("QQ[s]/(s^3-s^2-2*s+1)", 13)],
)
def test_brandt_matrices(name: str, level: int) -> None:
    """They commute; rows sum to the numbers of ideals; the adjoint of T_P is T_P divided by P."""
    K = ring(name)
    finite = K.primes_above(2)[:1] if K.degree % 2 else []
    A = QuaternionAlgebra.from_ramification(K, [*K.real_places(), *finite])
    N = K.primes_above(level)[0]
    C = A.eichler_order([(N, 1)]).class_set()
    h = range(len(C))
    assert sum(Fraction(1, units) for units in C.units) == C.mass == C.order.mass()
    matrices = []
    for P in (P for p in (2, 3, 5, 7, 13) for P in K.primes_above(p) if K.ideal(P).norm() < 14):
        B, q = C.brandt_matrix(P), int(K.ideal(P).norm())
        ideals = 1 if P in finite else 2 * q + 1 if P == N else q + 1
        assert [sum(row) for row in B] == [ideals for _ in h]
        matrices.append(flint.fmpz_mat(B))
        if ideals == q + 1:
            times = [C.index(I * K.ideal(P)) for I in C]
            assert all(B[i][j] * C.units[j] == B[j][times[i]] * C.units[i] for i in h for j in h)
    assert all(S * T == T * S for S, T in product(matrices, repeat=2))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "level", "p"), [("s^2-5", 31, 2), ("s^2-5", 31, 5), ("s^2-10", 1, 2), ("s^2-10", 1, 3)]
)
def test_brandt_matrices_of_powers(name: str, level: int, p: int) -> None:
    """They count the ideals of that norm, listed; those of coprime ideals multiply."""
    A = unramified(name)
    K = A.ring
    O = A.eichler_order([(K.primes_above(level)[0], 1)] if level > 1 else 1)
    C, P = O.class_set(), K.ideal(K.primes_above(p)[0])
    for k in (2, 3):
        found = Counter(C.index(J.conjugate()) for J in O.ideals_of_norm(P**k))
        assert C.brandt_matrix(P**k)[0] == [found[j] for j in range(len(C))]
    Q = K.ideal(K.primes_above(7)[0])
    S, T = (flint.fmpz_mat(C.brandt_matrix(a)) for a in (P**2, Q))
    assert C.brandt_matrix(P**2 * Q) == (S * T).table()


@pytest.mark.parametrize(("name", "p"), [("s^2-5", 2), ("s^2-10", 3), ("s^2-3", 2)])
def test_powers_of_primes_of_the_level(name: str, p: int) -> None:
    """By the affine Weyl group, and by counting elements; so many rows as local ideals of that norm."""
    A = unramified(name)
    P = A.ring.primes_above(p)[0]
    C = A.eichler_order([(P, 1)]).class_set()
    q = P.p**P.f
    for e in (1, 2, 3) if q < 4 else (1, 2):
        B = flint.fmpz_mat(C.brandt_matrix(A.ring.ideal(P) ** e))
        assert B == brandt.by_elements(C._classes, A.ring.ideal(P) ** e)
        total = sum(q ** abs(e - 2 * b) for b in range(e + 1))
        total += sum(q ** abs(2 * b - e - 1) for b in range(1, e + 1))
        assert {sum(map(int, row)) for row in B.tolist()} == {total}


def test_a_newform_at_powers_of_its_level() -> None:
    """Of an elliptic curve over ℚ(√5) with multiplicative reduction at 31: a(Pᵉ) = a(P)ᵉ, a(P) = −1."""
    K: Any = ring("QQ(sqrt(5))")
    P = K.ideal(K.primes_above(31)[0])
    C = QuaternionAlgebra(K, -1, -1).eichler_order(P).class_set()
    for e in (1, 2, 3):
        (a, b), _ = matrix = C.brandt_matrix(P**e)
        trace = sum(matrix[n][n] for n in range(2))
        assert trace - (a + b) == (-1) ** e


def test_powers_where_the_order_is_neither_maximal_nor_of_prime_level() -> None:
    """The ideals x·O of one class, as lattices."""
    K: Any = ring("QQ(sqrt(5))")
    A, P = QuaternionAlgebra(K, -1, -1), K.ideal(2)
    C = A.order(["i", "j"]).class_set()
    assert len(C) == 1
    for e in (1, 2):
        found = {C.order.right_ideal([x]) for x in C.order.elements_of_norm(2**e)}
        assert C.brandt_matrix(P**e) == [[len(found)]]
    with pytest.raises(TooLargeError, match="counted by their elements"):
        C.brandt_matrix(P**9)


def test_equivalence_and_index() -> None:
    A = unramified("s^2-15")  # class number 2, narrow class number 4
    K, O = A.ring, A.maximal_order()
    C = O.class_set()
    x = A(1, K.gen, 2, 1 - K.gen)
    for n, I in enumerate(C):
        assert C.index(x * I) == n
        answer = I.equivalence(x * I)
        assert answer
        assert answer.element * I == x * I
        for m, J in enumerate(C):
            assert bool(I.equivalence(J)) == (n == m)
        assert bool(I.is_principal()) == (n == 0)
    P = K.primes_above(2)[0]
    ideal = next(I for I in O.ideals_of_norm(P, "right"))
    assert "totally positive generator" in ideal.is_principal().reason  # P is not principal
    assert bool((C[0] * K.ideal(P)).is_principal()) == (C.index(C[0] * K.ideal(P)) == 0)


def test_left_ideals() -> None:
    O = unramified("s^2-7").maximal_order()
    ideals = O.ideals_of_norm(O.algebra.ring.primes_above(3)[0])
    assert [I.side for I in ideals] == ["left"] * 4
    for I in ideals:
        answer = ideals[0].equivalence(I)
        if answer:
            assert ideals[0] * answer.element == I
        else:
            assert answer.reason
    with pytest.raises(LatticeError, match="conjugate one first"):
        ideals[0].equivalence(ideals[0].conjugate())


@pytest.mark.parametrize(
    ("polynomial", "level", "types"),
    [("s^2-6", 1, 3), ("s^3-s^2-4*s+3", 1, 1), ("s^2-s-1", 22, 4)],
)
def test_isomorphisms_of_orders(polynomial: str, level: int, types: int) -> None:
    """Types by two-sided ideals are those of left orders, compared in pairs."""
    K = ring(f"QQ[s]/({polynomial})")
    finite = K.primes_above(3)[:1] if K.degree % 2 else []
    A = QuaternionAlgebra.from_ramification(K, [*K.real_places(), *finite])
    C = A.eichler_order(level).class_set()
    assert C.type_number == types
    orders = C.left_orders()
    x = A(2, K.gen, -1, 3)
    for n, O in enumerate(orders):
        moved = (x * O) * x.inverse()
        answer = O.isomorphism(moved)
        assert answer
        assert (answer.element * O) * answer.element.inverse() == moved
        for m, other in enumerate(orders):
            assert bool(O.isomorphism(other)) == (C.types[n] == C.types[m])


@pytest.mark.parametrize(
    ("polynomial", "group"),
    [("s^2-s-1", "A5"), ("s^2-2", "S4"), ("s^2-s-3", "A4"), ("s^2-s-4", "D3")],
)
def test_unit_groups(polynomial: str, group: str) -> None:
    assert unramified(polynomial).maximal_order().unit_group() == group


def test_other_orders() -> None:
    """An order that is neither maximal nor Eichler: masses and types against left orders in pairs."""
    A = icosians()
    O = A.order(["i", "j"])
    C = O.class_set()
    assert sum(Fraction(1, units) for units in C.units) == C.mass
    orders = C.left_orders()
    assert [order.unit_index() for order in orders] == C.units
    different = []
    for order in orders:
        if not any(order.isomorphism(other) for other in different):
            different.append(order)
    assert len(different) == C.type_number


@pytest.mark.parametrize(
    "name", ["QQ(sqrt(3))", "QQ(sqrt(15))", "QQ[s]/(s^3-s^2-4*s-1)", "QQ[s]/(s^4-6*s^2+4)"]
)
def test_strong_approximation_counts_classes_of_ideals_by_signs(name: str) -> None:
    K = ring(name)
    places = list(K.real_places())
    odd = list(K.primes_above(2)[:1])
    whole = QuaternionAlgebra.from_ramification(K, places + odd * (len(places) % 2))
    ambient = basis_of(whole)
    number = ambient.base.classes_modulo_signs(ambient).order
    assert number == K.narrow_class_group().order
    split = QuaternionAlgebra(K, 1, 1)
    assert split.class_number() == split.class_number(3) == K.class_group().order
    some = QuaternionAlgebra.from_ramification(K, places[:-1] + odd * ((len(places) - 1) % 2))
    between = some.class_number()
    assert K.narrow_class_group().order % between == between % K.class_group().order == 0
    with pytest.raises(IndefiniteError, match=f"the number of classes is {between}, and"):
        some.maximal_order().class_set()


@pytest.mark.parametrize(
    "name", ["QQ(sqrt(10))", "QQ(sqrt(15))", "QQ(sqrt(-23))", "QQ[s]/(s^3-4*s-1)"]
)
def test_classes_by_norm(name: str) -> None:
    """As many as are counted by signs, no two equivalent; those of x·I are the same; types of squares."""
    A = QuaternionAlgebra(name, -1, 3)
    O = A.maximal_order()
    C, K = O.classes_by_norm(), A.ring
    assert len(C) == A.class_number() == len(set(C)) == len(list(C))
    x = A(3, K.gen, 2, 1)
    assert K.ideal(x.norm()) != 1
    for n, I in enumerate(C):
        assert I.is_integral()
        assert I.right_order() == O
        assert C.index(I) == C.index(x * I) == n
        assert C[n] == I
    a = C.group.class_of
    squares = {a(K.ideal(I.norm()) ** 2) for I in C}
    moved = {a(K.ideal(P)) for P, _ in O.discriminant().factorisation()}
    assert (C.type_number == len(C)) == (len(squares | moved | {a(K.ideal(1))}) == 1)


def test_refusals_of_classes_by_norm() -> None:
    with pytest.raises(IndefiniteError, match="class_set"):
        icosians().maximal_order().classes_by_norm()
    with pytest.raises(IndefiniteError, match="Eichler symbol 0"):
        QuaternionAlgebra("QQ(sqrt(10))", -1, 3).order(["i", "2*j"]).classes_by_norm()


def test_class_numbers_of_definite_algebras_are_counted() -> None:
    A = icosians()
    assert A.class_number(A.ring("6 + sqrt(5)")) == 2


def test_refusals() -> None:
    with pytest.raises(IndefiniteError, match="the number of classes is 2, and"):
        QuaternionAlgebra("QQ(sqrt(-5))", -1, -1).maximal_order().class_set()
    with pytest.raises(IndefiniteError, match="split at an infinite place"):
        QuaternionAlgebra("QQ(sqrt(5))", 2, 3).maximal_order().class_set()
    C = icosians().maximal_order().class_set()
    with pytest.raises(LatticeError, match="not a prime ideal"):
        C.neighbours(11)
    with pytest.raises(LatticeError, match="ideal of integers"):
        C.brandt_matrix("1/2")
    with pytest.raises(LatticeError, match="right ideal"):
        C.index(C.order.left_ideal([2]))


@pytest.mark.parametrize("name", ["QQ(sqrt(5))", "QQ[s]/(s^3-s^2-2*s+1)", "QQ(sqrt(3))"])
def test_units_are_counted_by_short_elements(name: str) -> None:
    """As many give one lattice as the left order has units, which are enumerated alone."""
    several = set()
    for b, level in ((-1, 1), (-1, 7), (-3, 1)):
        C = QuaternionAlgebra(name, -1, b).eichler_order(level).class_set()
        assert sum(Fraction(1, u) for u in C.units) == C.mass
        assert C.units == [O.unit_index() for O in C.left_orders()]
        several |= set(C.units)
    assert max(several) > 1


@pytest.mark.parametrize("name", ["QQ(sqrt(-5))", "QQ(sqrt(-23))", "QQ(sqrt(10))"])
def test_strong_approximation_decides_where_no_element_is_sought(name):
    """Right ideals over CM fields, or split at two real places: as their norms are in the class group."""
    O = QuaternionAlgebra(name, 2, 3).maximal_order()
    K, C = O.algebra.ring, O.classes_by_norm()
    assert all(I.is_equivalent(J) == (I is J) for I in C for J in C)
    assert [bool(I.is_principal()) for I in C] == [True] + [False] * (len(C) - 1)
    assert [C.index(I * O.right_ideal([K(2)])) for I in C] == list(range(len(C)))
    for x in ("1 + i", "3 + j", "1 + i + 2*j + k"):
        principal = O.right_ideal([x])
        answer = principal.is_principal()
        assert (bool(answer), answer.element, answer.certificate) == (True, None, None)
