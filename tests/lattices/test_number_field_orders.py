"""Orders and ideals over the integers of number fields: identities, brute force over residue fields."""

import pytest

from hfield import QuaternionAlgebra
from hfield.lattices.over_integers.lattices import IntegersOrder
from hfield.lattices.over_integers.orders import checked_ring

# class numbers 1 and more, algebras ramified at finite places and not
ALGEBRAS = ["(-1,-1|QQ(sqrt(5)))", "(-1,-3|QQ(sqrt(10)))", "(2,5|QQ(sqrt(-5)))",
            "(-1,-1|QQ[s]/(s^3-s^2-2*s+1))", "(-3,7|QQ(sqrt(-23)))",
            "(-1,-1|QQ[s]/(s^4-s^3-3*s^2+s+1))"]  # fmt: skip


def split_primes(A, *numbers):
    ramified = A.ramified_places()
    return [P for p in numbers for P in A.ring.primes_above(p) if P not in ramified]


@pytest.mark.parametrize("name", ALGEBRAS)
def test_eichler_orders(name: str) -> None:
    A = QuaternionAlgebra(name)
    M = A.maximal_order()
    P, Q = split_primes(A, 2, 3, 5, 7, 11)[:2]
    O = A.eichler_order([(P, 3), (Q, 1)])
    assert checked_ring(O) == O
    assert M >= O
    assert M.index(O) == O.level == A.ring.ideal(P) ** 3 * A.ring.ideal(Q)
    assert O.discriminant() == M.discriminant() * O.level
    assert O.norm_of_discriminant() == O.discriminant().norm()
    assert (O.local_index(P), O.local_index(Q)) == (3, 1)
    assert O.eichler_symbol(P) == O.eichler_symbol(Q) == 1
    assert O.is_eichler()
    assert not O.is_maximal()
    larger = O.maximal_overorder()
    assert larger.is_maximal()
    assert larger >= O
    assert O == A.eichler_order(O.level)


@pytest.mark.parametrize("name", ALGEBRAS)
def test_ideals_of_prime_norm_are_all_of_them(name: str) -> None:
    """Against all right ideals x·O + P·O with x modulo P, for orders of every Eichler symbol."""
    A = QuaternionAlgebra(name)
    P = min(A.ring.primes_above(2), key=lambda P: P.p**P.f)
    orders = [A.maximal_order(), A.order([x * 2 for x in A.maximal_order().basis])]
    if P in split_primes(A, 2):
        orders += [A.eichler_order([(P, 1)]), A.eichler_order([(P, 2)])]
    for O in orders:
        found = O.ideals_of_norm(A.ring.ideal(P), side="right")
        assert len(found) == len(set(found))
        for I in found:
            assert I.norm() == A.ring.ideal(P)
            assert I.right_order() == O
            assert I.is_invertible()
        if P.p**P.f == 2:
            assert set(found) == by_brute_force(O, P)


def by_brute_force(O: IntegersOrder, P: object) -> set:
    A = O.algebra
    prime = A.ring.ideal(P)
    residues: list = [A(0)]
    seen = O * prime
    for q in O.basis:
        if q not in seen:
            seen = A.lattice([*seen.basis, q])
            residues += [r + q for r in residues]
    out = set()
    for x in residues:
        I = O.right_ideal([x, *(prime * O).basis])
        if I.norm() == prime and O.index(I) == prime**2:
            out.add(I)
    return out
