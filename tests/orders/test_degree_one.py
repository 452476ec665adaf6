"""Orders over the number field of degree 1, against those over ℚ and their tables."""

import json
import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import product
from pathlib import Path

import pytest

from hfield import Lattice, Order, QuaternionAlgebra, ring
from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime
from hfield.errors import IndefiniteError, LatticeError, NotFiniteError, TooLargeError
from hfield.fuchsian import area
from hfield.orders import elliptic_points, mass_formula
from hfield.orders.basis import base_of
from tests.thorough import quick_part

VECTORS = Path(__file__).parent.parent / "vectors"
K = ring("QQ[s]/(s-1)")


def algebra(discriminant: int) -> QuaternionAlgebra:
    A = QuaternionAlgebra(discriminant)
    return QuaternionAlgebra(K, A.constants.a, A.constants.b, A.constants.t)


def plain(A: QuaternionAlgebra) -> QuaternionAlgebra:
    """The same algebra over ℚ."""
    return QuaternionAlgebra(
        "QQ", *(c.poly[0] for c in (A.constants.a, A.constants.b, A.constants.t))
    )


def rows(values):
    return tuple(tuple(K(x) for x in row) for row in values)


PAIRS = [
    (d, n) for d in (2, 3, 5, 11, 30, 42, 53) for n in (1, 2, 3, 4, 5, 9) if math.gcd(d, n) == 1
]


def test_class_numbers_masses_and_units() -> None:
    for d, n in quick_part(PAIRS, 3):
        C, D = (
            algebra(d).eichler_order(n).class_set(),
            QuaternionAlgebra(d).eichler_order(n).class_set(),
        )
        assert len(C) == len(D) == plain(C.order.algebra).class_number(n)
        assert C.mass == D.mass == mass_formula.eichler_mass(d, n)
        assert sorted(C.units) == sorted(D.units)
        assert C.unit_counts == [2 * u for u in C.units]
        assert C.type_number == D.type_number
        assert C.order.stable_class_number() == D.order.stable_class_number() == 1


def test_type_numbers_of_prime_discriminants() -> None:
    """Pizer's table."""
    primes = [p for p in range(100) if is_prime(p)]
    for p, t in zip(primes, map(int, "1111212233324354644746775"), strict=True):
        assert algebra(p).maximal_order().class_set().type_number == t, p


def test_hecke_polynomials_of_sage() -> None:
    for case in quick_part(json.loads((VECTORS / "brandt.json").read_text())["cases"][::2], 3):
        C = algebra(case["p"]).eichler_order(case["level"]).class_set()
        for n, polynomial in case["hecke"].items():
            if math.gcd(int(n), case["level"]) == 1:
                assert C.hecke_polynomial(int(n)) == polynomial, (case["p"], case["level"], n)


def test_newforms() -> None:
    for d, n in ((11, 6), (67, 1), (26 * 3, 1)):
        found, known = [
            A.eichler_order(n).class_set().newforms() for A in (algebra(d), QuaternionAlgebra(d))
        ]
        assert [str(f) for f in found] == [str(f) for f in known]


def test_ideals_of_sage() -> None:
    for case in quick_part(json.loads((VECTORS / "orders.json").read_text())["cases"][::3], 3):
        A = QuaternionAlgebra(K, case["a"], case["b"])
        O = A.order_from_basis(rows(case["order"]))
        assert O.is_maximal()
        assert O.discriminant() == case["discriminant"]
        I, J = (O.left_ideal(A.lattice(rows(case[name])).basis) for name in "IJ")
        assert I == A.lattice(rows(case["I"]))
        assert all(I.norm() == K(n) for I, n in zip((I, J), case["norms"], strict=True))
        assert I.right_order() == A.lattice(rows(case["right_order_I"]))
        assert I.conjugate() * J == A.lattice(rows(case["conj_I_J"]))
        assert I & J == A.lattice(rows(case["meet"]))
        if "equivalent" in case:
            found = I.equivalence(J)
            assert bool(found) == case["equivalent"], case
            assert not found or found.element is None or I * found.element == J
        if "theta" in case:
            found = I.theta_series(int(11 * Fraction(case["norms"][0])))
            assert [found.get(m * K(case["norms"][0]), 0) for m in range(12)] == case["theta"]
            assert 2 * O.unit_index() == case["units"]


def test_lattices_against_those_over_the_rationals() -> None:
    A = QuaternionAlgebra(K, -2, -5)
    B = plain(A)
    some = [[1, "1/2", 0, 3], [0, 2, "1/3", 1], [5, 0, 1, 0], [0, 1, 1, 7]]
    other = [[1, 0, 0, 0], [0, 3, 0, 1], ["1/2", "1/2", 1, 0], [0, 0, 0, 2]]
    L, M = (A.lattice(rows(x)) for x in (some, other))
    P, Q = (B.lattice([tuple(map(Fraction, row)) for row in x]) for x in (some, other))
    pairs = [(L, P), (M, Q), (L + M, P + Q), (L & M, P & Q), (L * M, P * Q), (L.dual(), P.dual())]
    pairs += [
        (L.conjugate(), P.conjugate()),
        (L.colon(M), P.colon(Q)),
        (L.right_order(), P.right_order()),
    ]
    for x, y in pairs:
        assert x.hnf == y.hnf
        assert x.norm() == K(y.norm())
        assert x.is_invertible() == y.is_invertible()
        assert x.gram_matrix() == rows(y.gram_matrix())
        assert x.volume() == K(y.volume())
        assert x.reduced_basis() == tuple(A(*q.coordinates) for q in y.reduced_basis())
        assert x.shortest() == tuple(A(*q.coordinates) for q in y.shortest())
        least = y.shortest()[0].norm()
        for name in ("elements_of_norm", "elements_of_norm_at_most"):
            found, known = (getattr(z, name)(least * 2) for z in (x, y))
            assert found == tuple(A(*q.coordinates) for q in known)
        assert [A(*q.coordinates) for _, q in y.pseudo_basis()] == [q for _, q in x.pseudo_basis()]
    assert type(L) is type(P)
    assert L.index(M) == K(P.index(Q))


def test_embeddings_and_represented_numbers() -> None:
    for d in (11, 37, 30):
        O, P = algebra(d).maximal_order(), QuaternionAlgebra(d).maximal_order()
        for D in (-3, -4, -7, -8, -11, -12, -20, -27):
            found, known = O.embeddings(D), P.embeddings(D)
            assert len(found.elements) == len(known.elements)
            assert found.orbits == known.orbits
        for n in range(1, 12):
            assert (O.represent_integer(n) is None) == (P.represent_integer(n) is None)


@pytest.mark.parametrize(("d", "n"), [(6, 1), (10, 1), (15, 1), (6, 5)])
def test_signatures_of_shimura_curves(d: int, n: int) -> None:
    G = algebra(d).eichler_order(n).norm_one_group()
    H = (
        QuaternionAlgebra.from_ramification("QQ", list(factorise(d)))
        .eichler_order(n)
        .norm_one_group()
    )
    assert (G.area, G.signature) == (H.area, H.signature)


def test_formulas_for_groups_over_both() -> None:
    """Areas, elliptic points, by embedding numbers in two ways, and cusps."""
    several = set()
    for a, b in ((1, 1), (-1, 3), (2, 5), (-1, 7)):
        A, B = QuaternionAlgebra("QQ", a, b), QuaternionAlgebra(K, a, b)
        for n in (1, 2, 3, 4, 5, 9, 25, 12, 36, 45):
            if math.gcd(A.discriminant(), n) == 1:
                P, O = A.eichler_order(n).value, B.eichler_order(n).value
                counts = area.elliptic_points(P)
                assert (counts, area.cusps(P)) == (area.elliptic_points(O), area.cusps(O))
                assert elliptic_points.elliptic_points(O) == {q: m for q, m in counts.items() if m}
                assert area.area(P) == area.area(O)
                several.add(sum(counts.values()))
        for gens in (("i", "4*j"), ("2*i", "3*j"), ("5*i", "j"), ("i + j", "9*i*j")):
            P, O = A.order(gens).value, B.order(gens).value
            assert area.area(P) == area.area(O)
            assert area.elliptic_points(P) is area.elliptic_points(O) is None
    assert len(several) > 3


def test_ternary_forms() -> None:
    for d in (11, 37, 30):
        f, g = (
            algebra(d).maximal_order().ternary_form(),
            QuaternionAlgebra(d).maximal_order().ternary_form(),
        )
        assert abs(K.norm(f.discriminant())) == abs(g.discriminant())
        assert f.order().is_maximal()


def test_the_field_itself() -> None:
    for name, root in (("QQ[s]/(s-1)", 1), ("QQ[s]/(2*s+3)", Fraction(-3, 2))):
        F = ring(name)
        assert F.gen == F(root) == F("s")
        assert (F.degree, F.signature, F.discriminant()) == (1, (1, 0), 1)
        assert (F.class_group().order, F.narrow_class_group().order) == (1, 1)
        assert (F.unit_group().rank, F.unit_group().torsion_order) == (0, 2)
        assert F.zeta_minus_one() == Fraction(-1, 12)
        (P,) = F.primes_above(7)
        assert (P.e, P.f, P.residue_field.name, P.valuation(F(98))) == (1, 1, "GF(7)", 2)
        assert F.ideal(6, 10) == F.ideal(2)
        assert F.ideal("12/5").is_principal().generator == F("12/5")
        assert QuaternionAlgebra(F, -1, -1).ramified_places() == (
            F.primes_above(2)[0],
            F.real_places()[0],
        )


def test_groups_with_cusps() -> None:
    """Γ₀(N), of index, cusps and elliptic points that are known."""
    M = QuaternionAlgebra(K, 1, 1)
    for n, signature in ((1, (0, (2, 3), 1)), (4, (0, (), 3)), (11, (1, (), 2))):
        assert M.eichler_order(n).norm_one_group().signature == signature


def test_symbols_and_conductors_over_both() -> None:
    A = QuaternionAlgebra(K, -1, -11)
    B = plain(A)
    seen = set()
    for i, j in (("i", "j"), ("3*i", "j"), ("2*i", "3*j"), ("i + j", "2*k + i"), ("4*i", "4*j")):
        O, P = A.order([i, j]), B.order([i, j])
        assert O.conductor() == P.conductor()
        assert O.level == P.level
        assert O.is_eichler() == P.is_eichler()
        for p in (2, 3, 5, 11):
            assert O.eichler_symbol(p) == P.eichler_symbol(p)
            seen.add(P.eichler_symbol(p))
    assert seen == {None, 0, 1, -1}


def test_orders_are_one_class_over_both() -> None:
    O, P = algebra(11).maximal_order(), QuaternionAlgebra(11).maximal_order()
    assert type(O) is type(P)
    assert dir(O) == dir(P)


def test_ideals_are_one_class_over_both() -> None:
    *_, maximal = pairs_of_orders()
    (I, J), x = (O.left_ideal([3, "1 + j"]) for O in maximal), 2
    assert type(I) is type(J)
    assert dir(I) == dir(J)
    assert I.side == J.side
    for one, other in (
        (I.is_principal(), J.is_principal()),
        ((I * x).is_principal(), (J * x).is_principal()),
    ):
        assert type(one) is type(other)
        assert (one.holds, one.reason) == (other.holds, other.reason)
        assert one.claim.verdict == other.claim.verdict


def test_class_sets_are_one_class_over_both() -> None:
    C, D = (A.eichler_order(9).class_set() for A in (algebra(5), QuaternionAlgebra(5)))
    assert type(C) is type(D)
    assert dir(C) == dir(D)
    for n in (2, 3, 5, 9, 12, 25, 27):
        assert C.hecke_polynomial(n) == D.hecke_polynomial(n)
        assert sorted(map(sorted, C.brandt_matrix(n))) == sorted(map(sorted, D.brandt_matrix(n)))
    assert [sorted(row.values()) for row in D.power_neighbours(3, 2)] == [
        sorted(x for x in row if x) for row in D.brandt_matrix(9)
    ]
    assert len(set(C.exchanged(5))) == len(set(D.exchanged(5))) == len(D)
    assert sorted(C.stable_classes()) == sorted(D.stable_classes())
    assert C.evidence["mass"] == D.evidence["mass"]
    assert sum(1 for _ in C.edges(2)) == sum(1 for _ in D.edges(2))
    values = [n * n for n in range(len(D))]
    assert D.hecke_operator(3, values) == [
        sum(x * y for x, y in zip(row, values, strict=True)) for row in D.brandt_matrix(3)
    ]


def pairs_of_orders() -> Iterator[tuple[Order, Order]]:
    """Orders over the field of degree 1, and the same over the rational numbers."""
    A = QuaternionAlgebra(K, -1, -11)
    B = plain(A)
    for gens in (("i", "j"), ("3*i", "j"), ("2*i", "3*j"), ("i + j", "2*k + i"), ("4*i", "4*j")):
        yield A.order(gens), B.order(gens)
    yield (
        A.order_from_basis(rows(q.coordinates for q in B.maximal_order().basis)),
        B.maximal_order(),
    )


def forms(lattices: Iterable[Lattice]) -> list[object]:
    return sorted(L.hnf for L in lattices)


def test_what_orders_are_over_both() -> None:
    """The functions over ℤ and those over ℤ_K, which are chosen in one place."""
    seen = set()
    for O, P in pairs_of_orders():
        assert O.hnf == P.hnf
        for name in ("is_bass", "is_hereditary", "is_gorenstein", "is_maximal", "unit_index"):
            assert getattr(O, name)() == getattr(P, name)()
            seen.add((name, bool(getattr(P, name)())))
        assert O.unit_count() == P.unit_count() == len(P.units())
        assert O.norm_of_discriminant() == P.norm_of_discriminant() == P.discriminant()
        assert O.gorenstein_closure().hnf == P.gorenstein_closure().hnf
        assert O.maximal_overorder().discriminant() == P.maximal_overorder().discriminant() == 11
        known = P.ternary_theta_series(60)
        found = O.ternary_theta_series(60)
        assert [found.get(K(m), 0) for m in range(61)] == known
        for p in (2, 3, 11):
            assert O.local_index(p) == P.local_index(p)
            assert forms(O.overorders(p)) == forms(P.overorders(p))
            assert len(P.overorders(p, P.local_index(p))) > 0
            assert forms(O.suborders(p)) == forms(P.suborders(p))
        assert set(map(type, (O.evidence["discriminant"], P.evidence["discriminant"]))) == {
            str,
            int,
        }
    assert {("is_bass", True), ("is_bass", False), ("is_hereditary", True)} <= seen


def test_overorders_over_the_integers_by_brute_force() -> None:
    """Those between an order and its dual lattice, one for each line of the quotient that is a ring."""
    for _, P in pairs_of_orders():
        for p in (2, 3):
            around = (P / p & P.dual()).basis
            found = set()
            for digits in product(range(p), repeat=4):
                x = sum((c * q for c, q in zip(digits, around, strict=True)), P.algebra(0))
                L = P + P.algebra.lattice([x, *P.basis])
                if L != P and L.index(P) == p and L * L == L:
                    found.add(L.hnf)
            assert sorted(found) == forms(P.overorders(p))


def test_ideals_over_both() -> None:
    for O, P in pairs_of_orders():
        for n in (3, 5):
            if P.discriminant() % n:
                assert forms(O.ideals_of_norm(n)) == forms(P.ideals_of_norm(n))
                I, J = O.random_ideal(n**3, seed=1), P.random_ideal(n**3, seed=1)
                assert I.norm() == J.norm() == n**3
                assert I.primitive_part()[1] == J.primitive_part()[1] == 1
                assert I.is_invertible()
                assert J.is_invertible()
        J = P.random_ideal(5, "right", seed=2)
        I = O.right_ideal(rows(q.coordinates for q in J.basis))
        for p in (2, 3, 11):
            assert forms(O.subideals(I, p)) == forms(P.subideals(J, p))
            assert all(X.norm() == 5 * p and X.order == P for X in P.subideals(J, p))
    O, P = algebra(11).eichler_order(3), QuaternionAlgebra(11).eichler_order(3)
    for p in (2, 3, 11):
        assert O.two_sided_prime(p).norm() == P.two_sided_prime(p).norm()
    other = P.random_ideal(25, seed=2).right_order()
    assert P.connecting_ideal(other).right_order() == other


def test_classes_by_norm_over_both() -> None:
    O, P = (
        QuaternionAlgebra(K, -1, 3).eichler_order(5),
        QuaternionAlgebra("QQ", -1, 3).eichler_order(5),
    )
    for order in (O, P):
        C = order.classes_by_norm()
        assert (len(C), C.type_number, C.index(order.right_ideal([7]))) == (1, 1, 0)
        assert C[0] == order.right_ideal([1])
    with pytest.raises(IndefiniteError, match="totally definite"):
        QuaternionAlgebra(11).maximal_order().classes_by_norm()
    with pytest.raises(IndefiniteError, match="symbol 0"):
        QuaternionAlgebra("QQ", -1, 3).order(["i", "4*j"]).classes_by_norm()


def test_large_primes_are_refused_at_once() -> None:
    p = 2**89 - 1
    O = QuaternionAlgebra(p).maximal_order()
    assert O.overorders(p) == O.overorders(2**61 - 1) == []
    assert O.is_bass()
    assert O.local_index(p) == 0
    for ask in (O.subideals, lambda O, p: O.suborders(p)):
        with pytest.raises(TooLargeError):
            ask(O, p)


def test_what_orders_over_fields_refuse() -> None:
    O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()
    with pytest.raises(NotFiniteError, match="unit_index"):
        O.unit_count()
    with pytest.raises(LatticeError, match="not an invertible right ideal"):
        O.subideals(O.left_ideal([3, "1 + i + j"]), 2)
    with pytest.raises(LatticeError, match="divides both"):
        O.suborders(2)[0].random_ideal(2)


@pytest.mark.parametrize("field", ["QQ", "QQ[s]/(s-1)", "QQ(sqrt(5))", "QQ[s]/(s^3-s^2-2*s+1)"])
def test_embeddings_modulo_large_primes_respect_products(field: str) -> None:
    base = base_of(ring(field))
    found = set()
    for p in (10007, 10009, 10037, 10039, 10061, 10067):
        embeddings = base.embeddings_modulo(p)
        found.add(base.splits_completely(p))
        assert base.splits_completely(p) == (len(embeddings) == base.degree)
        for images in embeddings:
            for (x, v), (y, w) in product(zip(base.integral_basis, images, strict=True), repeat=2):
                (row,) = base.coordinate_rows([x * y]).tolist()
                total = sum(int(c.p) * u for c, u in zip(row, images, strict=True))
                assert (total - v * w) % p == 0
    assert found == ({True} if base.degree == 1 else {True, False})
