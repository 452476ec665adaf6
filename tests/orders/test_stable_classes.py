"""Stable classes, suborders over ℤ, the search for Hermite orders: brute force, identities, known counts."""

import importlib.util
from collections import Counter
from fractions import Fraction
from itertools import product
from pathlib import Path
from random import Random
from typing import Any

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.fields.number_fields.symbols import square_class
from tests.subcases import first_quick, subcases

SPEC = importlib.util.spec_from_file_location(
    "try_definite_orders", Path(__file__).parents[2] / "scripts" / "try_definite_orders.py"
)
assert SPEC
assert SPEC.loader
search = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(search)


@subcases("polynomial", ["s^2-2", "s^2-s-1", "s^2-17", "s^3-s^2-2*s+1", "s^4-4*s^2+1", "s^3-2"])
@subcases("p", [2, 3])
def test_square_classes(polynomial: str, p: int) -> None:
    """A homomorphism onto all digits, and 0 for squares: so its kernel are the squares."""
    K: Any = ring(f"QQ[s]/({polynomial})")
    rng, basis = Random(1), K.integral_basis()
    for P in K.primes_above(p):
        Q = QuaternionAlgebra(K, -1, -1).maximal_order().value.ambient.base.prime(P)
        size = Q.e * Q.f + 1 if p == 2 else 1
        units = [x for x in (sum(rng.randrange(-9, 10) * b for b in basis) for _ in range(60)) if x]
        units = [x for x in map(Q.field, units) if not Q.valuation(x)]
        classes = [square_class(Q, x) for x in units]
        for x, c in zip(units, classes, strict=True):
            assert square_class(Q, x * x) == 0
            assert square_class(Q, x * units[0]) == c ^ classes[0]
        seen: set[int] = {0}
        for c in classes:
            seen |= {c ^ d for d in seen}
        assert seen == set(range(2**size))


def agree(O: Any) -> None:
    """As many stable classes as are said, all of one mass, those of a Hermite order's own with one class."""
    C = O.class_set()
    units = [u // 2 for u in C.unit_counts] if O.algebra.ring.name == "QQ" else C.units
    stable, number = C.stable_classes(), O.stable_class_number()
    masses: Counter[int] = Counter()
    for n, u in zip(stable, units, strict=True):
        masses[n] += Fraction(1, u)  # type: ignore[assignment]
    assert dict(masses) == dict.fromkeys(range(number), C.mass / number)
    assert C.has_cancellation() == (len(C) == number)
    assert O.is_hermite() == (stable.count(0) == 1)
    assert stable[C.index(O.right_ideal([1]))] == 0


FIELDS = [
    "QQ",
    "QQ(sqrt(2))",
    "QQ(sqrt(5))",
    "QQ(sqrt(3))",
    "QQ(sqrt(17))",
    "QQ[s]/(s^3-s^2-2*s+1)",
]


@pytest.mark.parametrize("name", first_quick(FIELDS, 1))
def test_stable_classes(name: str) -> None:
    """Of orders of all kinds, at primes above 2 and others."""
    A, rng = QuaternionAlgebra(name, -1, -1), Random(1)
    M = A.maximal_order()
    for p in (2, 3) if A.ring.name != "QQ" else (2, 3, 2):
        P = p if name == "QQ" else A.ring.primes_above(p)[0]
        O = M
        while O.mass() < 3 and search.norm(P) < 10:
            found = O.suborders(P) + O.suborders(P, 2)
            O = rng.choice(found) if found else O
            if not found or O.mass() > 16:
                break
            agree(O)
    agree(A.eichler_order(7))


@pytest.mark.parametrize("d", [6, 15, 21])
def test_stable_classes_of_maximal_orders(d: int) -> None:
    agree(QuaternionAlgebra(f"QQ(sqrt({d}))", -1, -1).maximal_order())


@pytest.mark.parametrize("p", first_quick([2, 3], 1))
def test_suborders_over_the_rationals(p: int) -> None:
    """All sublattices of index p or p² in Hermite normal form that are rings with 1."""
    A: Any = QuaternionAlgebra(2 if p == 2 else 11)
    for O in (A.maximal_order(), A.order(["i", f"{p}*j"])):
        for k in (1, 2):
            rings = set()
            for exponents in product(range(k + 1), repeat=4):
                if sum(exponents) != k:
                    continue
                diagonal = [p**e for e in exponents]
                free = [(m, n) for n in range(4) for m in range(n)]
                for entries in product(*(range(diagonal[n]) for _, n in free)):
                    rows = [[diagonal[m] * int(m == n) for n in range(4)] for m in range(4)]
                    for (m, n), c in zip(free, entries, strict=True):
                        rows[m][n] = c
                    L = A.lattice(
                        [
                            sum((c * b for c, b in zip(row, O.basis, strict=True)), A(0))
                            for row in rows
                        ]
                    )
                    if 1 in L and L * L == L:
                        rings.add(L)
            assert set(O.suborders(p, k)) == rings


def test_hermite_orders_over_the_rationals() -> None:
    """The forty of D. Smertnig and J. Voight, 2019; one of them without cancellation."""
    lines = search.of_field("QQ")
    assert not any(line.wrong for line in lines)
    assert (len(lines), sum(line.cancellation for line in lines)) == search.PUBLISHED[1]
    assert [line[1:6] for line in lines if not line.cancellation] == [(3, 27, 4, 2, 2)]


@pytest.mark.slow
def test_hermite_orders_over_a_quadratic_field() -> None:
    """All eight of discriminant 33, four with cancellation, as published."""
    lines = search.of_field("QQ(sqrt(33))")
    assert not any(line.wrong for line in lines)
    assert (len(lines), sum(line.cancellation for line in lines)) == (8, 4)


@pytest.mark.slow
def test_hermite_orders_over_a_field_of_degree_five() -> None:
    """Both that ramify at the prime above 5 of the field of discriminant 24217, one maximal."""
    lines = search.of_field("QQ[s]/(s^5-5*s^3-s^2+3*s+1)")
    assert not any(line.wrong for line in lines)
    assert [line[:6] for line in lines] == [(24217, 5, 5, 1, 1, 1), (24217, 5, 25, 2, 2, 1)]


def test_hermite_orders_that_are_not_in_the_list() -> None:
    """Of index 7 in the maximal order with four units modulo those of ℚ(√2): mass 2, two stable classes."""
    K: Any = ring("QQ(sqrt(2))")
    O, S = search.hermite_orders("QQ(sqrt(2))", [K.primes_above(2)[0], K.primes_above(7)[0]])
    assert (O.mass(), O.unit_index(), O.index(S).norm()) == (Fraction(1, 4), 4, 7)
    assert (S.mass(), S.stable_class_number(), S.unit_index(), S.class_set().units) == (
        2,
        2,
        1,
        [1, 1],
    )
    # no unit but those of the field lies in S: of u ≠ 1 in a cyclic group of four none does
    assert sum(u in S for u in O.units()) == 1
