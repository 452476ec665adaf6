"""Neighbours in coordinates, and the lattices by which classes are looked up, against lattices as values."""

from random import Random
from typing import Any

import pytest
from flint import fmpz_mat

from hfield import QuaternionAlgebra, ring
from hfield.orders import ideals_of_norm
from hfield.orders.class_keys import ClassKeys, SublatticeKeys
from hfield.orders.classes import Classes
from hfield.orders.lattice_values import (
    LatticeValue,
    discriminant,
    hermite_form,
    inverse,
    multiple,
    product,
)
from hfield.orders.neighbours import Neighbours
from tests.subcases import share_quick

ORDERS = [
    ("QQ", 11, 1), ("QQ", 37, 6), ("QQ", 2, 9), ("QQ[s]/(s-1)", 11, 3), ("QQ(sqrt(5))", -1, 7),
    ("QQ(sqrt(15))", -1, 1), ("QQ[s]/(s^3-s^2-2*s+1)", -1, 1), ("QQ[s]/(s^4-6*s^2-4*s+2)", -1, 1),
]  # fmt: skip


def order(name: str, number: int, level: int) -> LatticeValue:
    if name == "QQ":
        return QuaternionAlgebra(number).eichler_order(level).value
    K: Any = ring(name)
    if number > 0:
        a, t, b = QuaternionAlgebra(number).constants
        return QuaternionAlgebra(K, a, b, t).eichler_order(level).value
    return QuaternionAlgebra(K, -1, -1).eichler_order(level).value


def primes(O: LatticeValue) -> list[Any]:
    """Of each kind: split, inert and ramified, off the discriminant and in it."""
    return [P for p in (2, 3, 5, 7) for _, P in O.ambient.base.primes_above(p)][:5]


@pytest.mark.parametrize(("name", "number", "level"), share_quick(ORDERS, 3))
def test_neighbours_are_the_subideals(name: str, number: int, level: int) -> None:
    O = order(name, number, level)
    C = Classes(O)
    for P in primes(O):
        if O.ambient.base.absolute_norm(O.ambient.base.prime_ideal(P)) > 50:
            continue
        at = Neighbours(O, P)
        for n in range(min(len(C), 3)):
            I = C.lattice(n)
            around = SublatticeKeys(C.keys, I.matrix, I.den, C.norms[n])
            found = [
                hermite_form(O.ambient, I.den, M * I.matrix) for M in at.inside(around, C.norms[n])
            ]
            assert len(found) == len(set(found)) == len(at)
            assert set(found) == set(ideals_of_norm.subideals(O, I, P))


def test_both_kinds_of_primes_were_among_them() -> None:
    O = order("QQ", 37, 6)
    found = {O.ambient.base.valuation(discriminant(O), P) for P in primes(O)}
    assert found == {0, 1}
    O = order("QQ", 2, 9)
    assert {O.ambient.base.valuation(discriminant(O), P) for P in primes(O)} == {0, 1, 2}


@pytest.mark.parametrize(("name", "number", "level"), share_quick(ORDERS, 3))
def test_keys_are_lattices_of_the_class(name: str, number: int, level: int) -> None:
    """x⁻¹·I as a key is x⁻¹·I as a lattice; c·I has the keys of I; and other bases do not matter."""
    O = order(name, number, level)
    C, rng = Classes(O), Random(1)
    keys = ClassKeys(O)
    size = O.ambient.size
    for n in range(min(len(C), 4)):
        I = C.lattice(n)
        c = O.element([rng.randint(-5, 5) for _ in range(size)])
        moved = multiple(I, c, "left")
        assert C.class_of(moved) == n
        known = []
        for lattice in (I, moved):
            around = SublatticeKeys(keys, lattice.matrix, lattice.den, keys.norm_of(lattice.norm))
            basis = around.reduced(O.ambient.identity)
            found = around.representative(basis)
            assert found.units == C.units[n]
            known.append(set(found.keys))
            x = around.element([int(k == 0) for k in range(size)])
            whole = multiple(lattice, lattice.element(lattice.hnf[1][0]).inverse(), "left")
            key = keys.quotient(lattice.matrix, x)
            other = fmpz_mat([[int(k in (m, m - 1)) for k in range(size)] for m in range(size)])
            mixed = other * lattice.matrix  # another basis
            assert keys.quotient(mixed, x) == key
            table, den = (whole.rows * O.inverse_rows).numer_denom()
            h = table.hnf().tolist()
            kept = [int(c) for k, row in enumerate(h) if row[k] != den for c in row]
            assert key == (int(den), *kept)
        assert known[0] == known[1]


def test_norms_of_representatives() -> None:
    """ν·a is the norm of the lattice, and N(x)/ν a unit at the primes above p where x generates it there."""
    for name, number, level in ORDERS:
        O = order(name, number, level)
        C, base = Classes(O), O.ambient.base
        for n in range(min(len(C), 5)):
            norm = C.norms[n]
            ideal = C.keys.narrow.ideals[norm.number]
            assert base.principal(norm.element) * ideal == C.lattice(n).norm
            assert product(inverse(C.lattice(n)), C.lattice(n)) == O
            if ideal == base.one:
                x = C.local_norm(n, base.primes_above(2)[0][1])
                assert O.ambient.base.norm(x).p % 2
                assert O.ambient.base.norm(x).q % 2
