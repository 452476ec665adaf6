"""Orders: maximal, Eichler, generated; discriminants, units, Gorenstein closures, isomorphisms."""

import json
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield import H, QuaternionAlgebra
from hfield.errors import CoercionError, LatticeError, NotFiniteError, RingError, UndecidedError
from tests.orders.random_lattices import algebra, element

VECTORS = Path(__file__).parent.parent / "vectors"


def test_lipschitz_and_hurwitz() -> None:
    A = H("QQ")
    lipschitz, hurwitz = A.lipschitz_order(), A.hurwitz_order()
    assert (lipschitz.discriminant(), hurwitz.discriminant()) == (4, 2)
    assert (lipschitz.unit_count(), hurwitz.unit_count()) == (8, 24)
    assert (lipschitz.unit_group(), hurwitz.unit_group()) == ("Q8", "SL(2,3)")
    half = A(1, 1, 1, 1) / 2
    assert half in hurwitz
    assert half not in lipschitz
    assert A(Fraction(1, 2), 0, 0, Fraction(1, 2)) not in hurwitz
    units = set(hurwitz.units())
    assert {u * v for u in units for v in units} == units
    assert A.maximal_order() == hurwitz == lipschitz.maximal_overorder()
    assert lipschitz.index(lipschitz) == 1
    assert hurwitz.index(lipschitz) == 2


def test_maximal_orders_have_the_discriminant_of_the_algebra() -> None:
    cases = json.loads((VECTORS / "ramification.json").read_text())["cases"]
    for case in cases[::6]:
        order = QuaternionAlgebra("QQ", case["a"], case["b"]).maximal_order()
        assert order.discriminant() == case["discriminant"], case
        assert order * order == order
        assert order.is_maximal()


nonzero = st.builds(Fraction, st.integers(-60, 60).filter(bool), st.integers(1, 12))


@given(nonzero, st.integers(-3, 3), nonzero)
@settings(deadline=None)
def test_maximal_orders_of_any_constants(a, t, b) -> None:
    if t * t + 4 * a == 0:
        return
    A = QuaternionAlgebra("QQ", a, b, t)
    order = A.maximal_order()
    assert order.discriminant() == A.discriminant()
    assert order * order == order
    assert 1 in order


@pytest.mark.parametrize(
    ("a", "b", "units"), [(-1, -1, 24), (-1, -3, 12), (-2, -5, 6), (-1, -7, 4), (-1, -11, 4)]
)
def test_units_of_definite_maximal_orders(a, b, units) -> None:
    order = QuaternionAlgebra("QQ", a, b).maximal_order()
    found = order.units()
    assert len(found) in {units, 6, 4, 2}  # an order of another class may have fewer
    assert all(u.norm() == 1 and u in order for u in found)
    assert (a, b) not in {(-1, -1), (-1, -3)} or len(found) == units  # class number one
    assert len(found) == order.unit_count()


def test_the_unit_groups_have_the_structure_of_their_names() -> None:
    seen = set()
    cases = "-1,-1,hurwitz -1,-1,lipschitz -1,-3,maximal -3,-5,maximal -1,-7,maximal"
    for case in f"{cases} -5,-13,maximal -2,-5,maximal -1,-5,lipschitz".split():
        a, b, generators = case.split(",")
        order = getattr(QuaternionAlgebra("QQ", a, b), f"{generators}_order")()
        orders = sorted(u.order() for u in order.units())
        name = order.unit_group()
        seen.add(name)
        expected = {
            "C2": [1, 2],
            "C4": [1, 2, 4, 4],
            "C6": [1, 2, 3, 3, 6, 6],
            "Q8": [1, 2, *[4] * 6],
            "Dic3": [1, 2, 3, 3, *[4] * 6, 6, 6],
            "SL(2,3)": [1, 2, *[3] * 8, *[4] * 6, *[6] * 8],
        }
        assert orders == expected[name], (a, b)
    assert len(seen) >= 4
    assert QuaternionAlgebra("QQ", 2, 3).maximal_order().unit_group() == "infinite"


def test_units_where_the_coefficients_are_large() -> None:
    order = QuaternionAlgebra("QQ", -(2**521 - 1), -3).maximal_order()
    assert len(order.units()) == 12


def test_what_has_no_orders_or_infinitely_many_units() -> None:
    with pytest.raises(NotFiniteError, match="indefinite"):
        QuaternionAlgebra("QQ", 2, 3).maximal_order().units()
    with pytest.raises(RingError, match="degenerate"):
        QuaternionAlgebra("QQ", 0, 3).maximal_order()
    with pytest.raises(CoercionError, match="integers"):
        QuaternionAlgebra("QQ", Fraction(1, 2), 3).lipschitz_order()
    with pytest.raises(CoercionError, match="Hurwitz"):
        QuaternionAlgebra("QQ", -1, -2).hurwitz_order()


def test_eichler_orders() -> None:
    rng = Random(1)
    for _ in range(30):
        A = algebra(rng)
        O = A.maximal_order()
        for n in (2, 3, 4, 5, 6, 9, 12, 49, 1000003, 2**40):
            if any(n % p == 0 for p in A.ramified_places() if p != "inf"):
                with pytest.raises(LatticeError, match="in common"):
                    A.eichler_order(n)
                continue
            E = A.eichler_order(n)
            assert E == A.eichler_order(n)
            assert E * E == E <= O
            assert E.discriminant() == n * O.discriminant()
            assert E.is_eichler()
            assert E.level == n
            larger = E.maximal_overorder()
            assert larger.is_maximal()
            assert E <= larger
    for wrong in (0, -3, 1.5, "two", None):
        with pytest.raises(LatticeError, match="positive integer"):
            H("QQ").eichler_order(wrong)


def test_a_level_of_five_hundred_bits() -> None:
    A = QuaternionAlgebra("QQ", -1, -(27 * 2**500 - 1))
    n = 2**521 - 1
    E = A.eichler_order(n)
    assert E.discriminant() == n * (27 * 2**500 - 1)
    assert E.left_order() == E


def test_generated_orders() -> None:
    rng = Random(2)
    for _ in range(40):
        A = algebra(rng)
        O = A.maximal_order()
        x, y = (sum((rng.randint(-3, 3) * b for b in O.basis), A(0)) for _ in range(2))
        if x * y == y * x:
            with pytest.raises(LatticeError, match="rank"):
                A.order([x, y])
            continue
        S = A.order([x, y])
        assert S * S == S <= O
        assert A.lattice([1, x, y, x * y]) <= S
        # the ring that x and y generate is spanned by 1, x, y, xy
        assert A.lattice([1, x, y, x * y]) == S
        assert A.order_from_basis(S.basis) == S
        M = S.maximal_overorder()
        assert M.is_maximal()
        assert S <= M
        assert S.is_maximal() == (M == S)
        f, G = S.conductor(), S.gorenstein_closure()
        assert G.conductor() == 1
        assert S == A.lattice([1, *(f * q for q in G.basis)])


def test_conductors_that_are_planted() -> None:
    rng = Random(3)
    for _ in range(20):
        A = algebra(rng)
        O = A.maximal_order()
        for f in (2, 3, 4, 6):
            S = A.order_from_basis(A.lattice([1, *(f * q for q in O.basis)]).basis)
            assert S.conductor() == f
            assert S.gorenstein_closure() == O
            assert S.discriminant() == f**3 * O.discriminant()


def test_orders_that_are_none() -> None:
    A = H("QQ")
    e, i, j, k = A.basis
    with pytest.raises(LatticeError, match="1 is not in it"):
        A.order_from_basis([2 * e, i, j, k])
    with pytest.raises(LatticeError, match="the product of"):
        A.order_from_basis([e, i, j / 2, k])
    with pytest.raises(LatticeError, match="four elements"):
        A.order_from_basis([e, i, j])
    with pytest.raises(LatticeError, match="rank 4"):
        A.order_from_basis([e, i, j, i + j])
    B = QuaternionAlgebra("QQ", 1, 1)
    upper = [(1 + B.basis[1]) / 2, (B.basis[2] + B.basis[3]) / 2]
    assert upper[0] * upper[1] != upper[1] * upper[0]  # triangular matrices do not commute either
    with pytest.raises(LatticeError, match="smaller algebra"):
        B.order(upper)
    with pytest.raises(LatticeError, match="trace 0 and norm 1/4"):
        A.order([i / 2, j])
    with pytest.raises(
        LatticeError, match="generate no order"
    ):  # each is integral, the ring is not
        A.order(
            [i, A(0, Fraction(3, 5), Fraction(4, 5), 0), A(0, 0, Fraction(5, 13), Fraction(12, 13))]
        )


def test_ternary_theta_series() -> None:
    # trace 0 in ℤ + 2O for the Lipschitz order: 2xi + 2yj + 2zk; Hurwitz: x ≡ y ≡ z modulo 2
    A = H("QQ")
    assert A.lipschitz_order().ternary_theta_series(12) == [1, 0, 0, 0, 6, 0, 0, 0, 12, 0, 0, 0, 8]
    assert A.hurwitz_order().ternary_theta_series(12) == [1, 0, 0, 8, 6, 0, 0, 0, 12, 0, 0, 24, 8]
    rng = Random(4)
    for _ in range(20):
        A = algebra(rng, definite=True)
        O = A.eichler_order(next(n for n in (7, 11, 13) if A.discriminant() % n))
        small = A.lattice([1, *(2 * q for q in O.basis)])
        found = [q for q in small.elements_of_norm_at_most(40) if q.trace() == 0]
        assert O.ternary_theta_series(40) == [sum(q.norm() == n for q in found) for n in range(41)]


@pytest.mark.parametrize("definite", [True, False])
def test_isomorphisms_of_orders(definite) -> None:
    rng = Random(5)
    for _ in range(25):
        A = algebra(rng, definite)
        O = A.eichler_order(next(n for n in (1, 4, 3, 5) if A.discriminant() % n or n == 1))
        x = element(A, rng)
        other = x * O * x.inverse()
        found = O.isomorphism(other)
        assert found
        y = found.element
        assert y is not None
        assert y * O * y.inverse() == other
        smaller = A.order([O.basis[1] * 3, O.basis[2] + O.basis[3], *(5 * b for b in O.basis)])
        found = O.isomorphism(smaller)
        assert bool(found) == (smaller == O)
        if A.constants.a < 0 and definite:  # any order at all
            found = smaller.isomorphism(x * smaller * x.inverse())
            assert found.element * smaller * found.element.inverse() == x * smaller * x.inverse()


def test_orders_that_are_not_isomorphic() -> None:
    A = QuaternionAlgebra("QQ", -1, -11)
    O = A.maximal_order()
    others = [I.right_order() for p in (2, 3, 5) for I in O.ideals_of_norm(p)]
    different = [P for P in others if not O.isomorphism(P)]
    assert different  # 11 has two types
    assert all(P.unit_count() != O.unit_count() for P in different)
    assert "norm" in O.isomorphism(different[0]).reason
    # of 251 bits, where one order has an element of norm 1 and the other only long ones
    D = QuaternionAlgebra("QQ", -1, 1 - 5 * 2**248)
    E = D.extremal_order()
    P = E.random_ideal(2**127 - 1, seed=1).right_order()
    x = D(1, 2, 3, 4)
    for first, second, same in ((E, P, False), (P, E, False), (E, x * E * x.inverse(), True)):
        assert bool(first.isomorphism(second)) == same
    B = QuaternionAlgebra("QQ", 2, 3)
    S = B.order_from_basis(B.lattice([1, *(2 * q for q in B.maximal_order().basis)]).basis)
    x = B(1, 1, 0, 5)
    assert x * S * x.inverse() != S
    y = S.isomorphism(x * S * x.inverse()).element
    assert y * S * y.inverse() == x * S * x.inverse()
    S = B.lipschitz_order()
    assert (S.conductor(), S.is_eichler()) == (1, False)
    with pytest.raises(UndecidedError, match="Eichler"):
        S.isomorphism(x * S * x.inverse())


@pytest.mark.parametrize("field", ["QQ", "QQ(sqrt(5))", "QQ[s]/(s-1)"])
def test_the_intersection_of_orders_is_an_order(field: str) -> None:
    A = QuaternionAlgebra(field, -1, -11)
    O, P = A.order(["i", "j"]), A.eichler_order(3)
    both = O & P
    assert isinstance(both, type(O))
    assert both == A.order_from_basis(both.basis)
    assert all(q in O and q in P for q in both.basis)
    for larger in (O, P):
        assert both <= larger
        assert larger.index(both) == both.discriminant() / larger.discriminant()
    assert not isinstance(O & O.left_ideal([2, "1+i"]), type(O))
