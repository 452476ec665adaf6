"""Class sets against Eichler's formula, the mass, Sage's Brandt modules and theta series."""

import json
import math
from fractions import Fraction
from pathlib import Path

import pytest

from hfield import H, QuaternionAlgebra
from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime
from hfield.errors import IndefiniteError, LatticeError, TooLargeError
from hfield.orders import mass_formula
from hfield.orders.classes import Classes, types_by_isomorphism
from hfield.orders.lattice import ClassSet
from tests.orders.brandt_by_theta import by_theta_series
from tests.thorough import quick_part

VECTORS = Path(__file__).parent.parent / "vectors"


def algebra(discriminant: int) -> QuaternionAlgebra:
    return QuaternionAlgebra.from_ramification("QQ", sorted(factorise(discriminant)))


def pairs(bound: int) -> list[tuple[int, int]]:
    found = []
    for d in range(2, bound + 1):
        primes = factorise(d)
        if len(primes) % 2 and max(primes.values()) == 1:
            found += [(d, n) for n in range(1, bound // d + 1) if math.gcd(d, n) == 1]
    return found


def number_of_ideals(C: ClassSet, n: int) -> int:
    """How many integral right ideals of norm n, prime to the level, an Eichler order has."""
    found = 1
    for p, e in factorise(n).items():
        found *= sum(p**k for k in range(e + 1)) if C.order.algebra.discriminant() % p else 1
    return found


def test_formula_enumeration_and_mass_agree() -> None:
    for d, n in [
        *quick_part(pairs(100), 4),
        (30, 49),
        (42, 25),
        (2, 243),
        (3, 256),
        (1001, 1),
        (5, 64),
        (2 * 3 * 5 * 7 * 11, 1),
    ]:
        C = algebra(d).eichler_order(n).class_set()
        assert len(C) == algebra(d).class_number(n), (d, n)
        assert C.mass == mass_formula.eichler_mass(d, n)
        # the mass once more, from the units of the left orders of the representatives
        assert sum(Fraction(2, O.unit_count()) for O in C.left_orders()) == C.mass
        assert C.unit_counts == [O.unit_count() for O in C.left_orders()]


def test_brandt_matrices_agree_with_sage() -> None:
    for case in quick_part(json.loads((VECTORS / "brandt.json").read_text())["cases"], 3):
        C = algebra(case["p"]).eichler_order(case["level"]).class_set()
        assert len(C) == case["classes"]
        for n, polynomial in case["hecke"].items():
            assert C.hecke_polynomial(int(n)) == polynomial, (case["p"], case["level"], n)


def test_class_numbers_that_are_known() -> None:
    """Class number one: 2, 3, 5, 7, 13; type number one besides: 30, 42, 70, 78 (Voight, 25.4 and 26)."""
    ones = [d for d, n in pairs(400) if n == 1 and mass_formula.class_number(d, 1) == 1]
    assert ones == [2, 3, 5, 7, 13]
    types = [algebra(d).maximal_order().class_set().type_number for d in (30, 42, 70, 78, 66, 102)]
    assert types[:4] == [1, 1, 1, 1]
    assert min(types[4:]) > 1
    A = algebra(10**6 + 3)
    assert A.class_number() == 83334
    assert QuaternionAlgebra("QQ", 2, 3).class_number(5) == 1


def test_representatives_are_inequivalent_right_ideals() -> None:
    for d, n in ((11, 1), (53, 1), (30, 7), (2, 45)):
        O = algebra(d).eichler_order(n)
        C = O.class_set()
        ideals = list(C)
        assert ideals[0] == O
        for i, I in enumerate(ideals):
            assert I.side == "right"
            assert I.right_order() == O
            assert I.is_integral()
            assert C.index(I) == i
            for j, J in enumerate(ideals):
                assert bool(I.equivalence(J)) == (i == j)
        # an ideal somewhere is found in its class
        for seed in range(5):
            J = O.random_ideal(10007, "right", seed=seed)
            assert ideals[C.index(J)].equivalence(J)
        for I, J in zip(C.left_ideals(), ideals, strict=True):
            assert I.left_order() == O
            assert I == J.conjugate()


@pytest.mark.parametrize(("d", "n"), [(11, 1), (37, 1), (30, 1), (11, 3), (3, 8), (2, 25), (42, 5)])
def test_brandt_matrices_by_theta_series(d, n) -> None:
    C = algebra(d).eichler_order(n).class_set()
    for m in range(1, 13):
        B = C.brandt_matrix(m)
        assert B == by_theta_series(C, m), m
        if math.gcd(m, n) == 1:
            assert {sum(row) for row in B} == {number_of_ideals(C, m)}
        for i, u in enumerate(C.unit_counts):
            for j, v in enumerate(C.unit_counts):
                assert B[i][j] * v == B[j][i] * u


def test_hecke_operators_are_brandt_matrices_and_commute() -> None:
    C = algebra(37).eichler_order(3).class_set()
    f = [n**2 - 3 * n + 1 for n in range(len(C))]
    for n in (1, 2, 3, 4, 6, 37):
        B = C.brandt_matrix(n)
        assert C.hecke_operator(n, f) == [
            sum(x * y for x, y in zip(row, f, strict=True)) for row in B
        ]
    assert C.hecke_operator(2, C.hecke_operator(5, f)) == C.hecke_operator(
        5, C.hecke_operator(2, f)
    )
    with pytest.raises(LatticeError, match="1 values were given for"):
        C.hecke_operator(2, [1])
    with pytest.raises(LatticeError, match="numbered from 0"):
        C.theta_series(0, 99, 3)


@pytest.mark.slow
def test_brandt_matrices_by_ideals_at_the_level() -> None:
    """Where classes are many the ideals of norm pᵉ are listed; here they are in any case."""
    for d, n, p, e in ((101, 4, 2, 3), (11, 9, 3, 2), (30, 49, 7, 1), (37, 6, 3, 1)):
        C = algebra(d).eichler_order(n).class_set()
        rows = C.power_neighbours(p, e)
        assert [[row[j] for j in range(len(C))] for row in rows] == by_theta_series(C, p**e)


def test_types_by_orbits_and_by_isomorphism() -> None:
    for d, n in ((11, 1), (37, 1), (67, 1), (30, 7), (42, 5), (11, 6), (5, 9), (2, 35)):
        C = algebra(d).eichler_order(n).class_set()
        slow = types_by_isomorphism(Classes(C.order.value))
        assert len(set(slow)) == C.type_number
        assert len(set(zip(slow, C.types, strict=True))) == C.type_number
    # type numbers of prime discriminants up to 100, Pizer's table
    primes = [p for p in range(100) if is_prime(p)]
    known = dict(zip(primes, map(int, "1111212233324354644746775"), strict=True))
    for p, t in known.items():
        assert algebra(p).maximal_order().class_set().type_number == t, p


def test_orders_that_are_no_eichler_orders() -> None:
    """Their classes too are found until the mass is used up."""
    A = H("QQ")
    for generators in (
        ["i", "j"],
        ["3*i", "j"],
        ["i + j", "2*k + i"],
        ["5*i", "5*j"],
        ["2*i", "3*j"],
    ):
        O = A.order(generators)
        C = O.class_set()
        assert sum(Fraction(2, u) for u in C.unit_counts) == C.mass
        assert all(I.right_order() == O for I in C)
        assert len({C.index(I) for I in C}) == len(C)
        assert C.type_number <= len(C)
    O = A.order_from_basis(A.lattice([1, *(3 * q for q in A.hurwitz_order().basis)]).basis)
    assert len(O.class_set()) > 1


def test_neighbours_at_what_is_no_prime() -> None:
    C = algebra(37).maximal_order().class_set()
    for p in (4, 1, 0, -2, "x", 2.0):
        with pytest.raises(LatticeError, match="not a prime"):
            C.neighbours(p)
        with pytest.raises(LatticeError, match="not a prime"):
            list(C.edges(p))


def test_edges_of_the_isogeny_graph() -> None:
    C = algebra(37).maximal_order().class_set()
    edges = list(C.edges(2))
    assert len(C) == 3
    assert sum(data["weight"] for _, _, data in edges) == 9
    assert {(i, j): d["weight"] for i, j, d in edges} == {
        (i, j): m for i, row in enumerate(C.brandt_matrix(2)) for j, m in enumerate(row) if m
    }


def test_networkx_reads_the_graph() -> None:
    networkx = pytest.importorskip("networkx", reason="networkx is not installed")
    C = algebra(11).eichler_order(3).class_set()
    graph = networkx.DiGraph(C.graph(2))
    matrix = networkx.to_numpy_array(graph, nodelist=range(len(C)), dtype=int)
    assert matrix.tolist() == C.brandt_matrix(2)
    mass = {(i, j): data["mass"] for i, j, data in graph.edges(data=True)}
    assert all(mass[i, j] == mass[j, i] for i, j in mass)
    assert sum(mass.values()) == 3 * C.mass


def test_evidence() -> None:
    C = algebra(30).eichler_order(7).class_set()
    evidence = json.loads(json.dumps(C.evidence))
    assert evidence["mass"] == str(C.mass)
    assert len(evidence["classes"]) == len(C)
    A = QuaternionAlgebra.from_text(evidence["algebra"])
    first = evidence["classes"][1]
    assert A.lattice([[Fraction(x, first["den"]) for x in row] for row in first["rows"]]) == C[1]


def test_bad_input() -> None:
    with pytest.raises(IndefiniteError, match="class_set"):
        QuaternionAlgebra("QQ", 2, 3).maximal_order().class_set()
    with pytest.raises(TooLargeError, match="Eichler's formula"):
        QuaternionAlgebra("QQ", -1, -(2**61 - 1)).maximal_order().class_set()
    A = algebra(11)
    with pytest.raises(LatticeError, match="in common"):
        A.class_number(22)
    with pytest.raises(LatticeError, match="positive"):
        A.class_number(0)
    with pytest.raises(LatticeError, match="prime to"):
        QuaternionAlgebra("QQ", 2, 3).class_number(2)
    with pytest.raises(LatticeError, match="odd number"):
        mass_formula.class_number(6, 1)
    C = A.maximal_order().class_set()
    with pytest.raises(LatticeError, match="not a right ideal"):
        C.index(A.maximal_order().ideals_of_norm(3)[0])
    with pytest.raises(LatticeError, match="positive"):
        C.brandt_matrix(0)
