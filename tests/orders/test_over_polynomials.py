"""Orders over 𝔽_q[t]: class sets against Gekeler's class numbers, Brandt matrices, and brute force."""

import pickle
from fractions import Fraction
from itertools import islice, product
from typing import Any

import pytest
from flint import fmpz_mat, fmpz_poly

from hfield import QuaternionAlgebra, ring
from hfield.errors import HFieldError, LatticeError, TooLargeError
from hfield.orders.lattice import ClassSet, Ideal, Lattice, Order
from tests.orders.drinfeld import SupersingularModules
from tests.subcases import first_quick


def gekeler(q: int, d: int) -> int:
    """The class number of a maximal order of discriminant P of degree d (Gekeler, 1983)."""
    return (q**d - q) // (q * q - 1) + 1 if d % 2 else (q**d - 1) // (q * q - 1)


PRIMES = [
    ("GF(2)", "t^2+t+1"),
    ("GF(2)", "t^5+t^2+1"),
    ("GF(3)", "t^3+2*t+1"),
    ("GF(3)", "t^4+t+2"),
    ("GF(4)", "t^3+x"),
    ("GF(5)", "t^3+t+1"),
    ("GF(9)", "t^2+x"),
]


@pytest.mark.parametrize(("k", "P"), PRIMES)
def test_class_numbers_are_those_of_gekeler(k: str, P: str) -> None:
    O = QuaternionAlgebra.from_ramification(f"{k}(t)", [P, "inf"]).maximal_order()
    F = O.algebra.ring
    q, d = F.base.order, F(P).num.degree()
    C = O.class_set()
    assert O.discriminant().generator == F(P)
    assert len(C) == gekeler(q, d)
    assert C.mass == Fraction(q**d - 1, q * q - 1) == sum(Fraction(1, n) for n in C.units)
    assert [I.left_order().unit_index() for I in C] == C.units
    assert [C.index(I) for I in C] == list(range(len(C)))


def test_classes_are_those_over_every_base() -> None:
    O = QuaternionAlgebra.from_ramification("GF(3)(t)", ["t", "inf"]).maximal_order()
    P = QuaternionAlgebra("QQ", -1, -1).maximal_order()
    I, J = O.left_ideal(["t+1"]), P.left_ideal([3])
    assert type(O) is type(P) is Order
    assert type(O.class_set()) is type(P.class_set()) is ClassSet
    assert type(I) is type(J) is Ideal
    assert type(I * 2 + O) is type(J * 2 + P) is Lattice
    for L in (O, I, O.class_set()[0], O.algebra.lattice(["1/t", "i", "j", "k"])):
        again = pickle.loads(pickle.dumps(L))
        assert (again, hash(again), again.hnf) == (L, hash(L), L.hnf)
    assert len({O, O * O, I * I.inverse(), O + I}) == 1


COMPOSITE = [
    ("GF(2)(t)", ["t", "t+1", "t^2+t+1", "inf"], "t^3+t+1", "t^3+t^2+1"),
    ("GF(3)(t)", ["t", "t+1", "t+2", "inf"], "t^2+1", "t^2+t+2"),
    ("GF(4)(t)", ["t^2+t+x", "inf"], "t+1", "t"),
    ("GF(5)(t)", ["t", "inf"], "t^2+2", "t+1"),
]


@pytest.mark.parametrize(("field", "places", "level", "prime"), first_quick(COMPOSITE, 2))
def test_masses_and_brandt_matrices_of_composite_discriminant(
    field: str, places: list[str], level: str, prime: str
) -> None:
    A = QuaternionAlgebra.from_ramification(field, places)
    O, F = A.eichler_order(level), A.ring
    q = F.base.order
    degrees = [F(p).num.degree() for p in places if p != "inf"]
    mass = Fraction(q ** F(level).num.degree() + 1, q * q - 1)
    for d in degrees:
        mass *= q**d - 1
    C = O.class_set()
    assert C.mass == mass == sum(Fraction(1, n) for n in C.units)
    T, S = C.brandt_matrix(prime), C.brandt_matrix(level)
    W = C.brandt_matrix(places[0])
    size, weights = range(len(C)), C.units
    assert {sum(row) for row in T} == {q ** F(prime).num.degree() + 1}
    assert {sum(row) for row in W} == {1}
    for B in (T, W):
        assert all(B[i][j] * weights[j] == B[j][i] * weights[i] for i in size for j in size)
    for X, Y in ((T, S), (T, W), (S, W)):
        assert times(X, Y) == times(Y, X)


def times(X: list[list[int]], Y: list[list[int]]) -> list[list[int]]:
    return [
        [sum(x * y for x, y in zip(row, column, strict=True)) for column in zip(*Y, strict=True)]
        for row in X
    ]


@pytest.mark.parametrize(
    ("field", "places"),
    [("GF(2)(t)", ["t^3+t+1", "inf"]), ("GF(3)(t)", ["t^2+1", "inf"]), ("GF(4)(t)", ["t", "t+1"])],
)
def test_ideals_satisfy_the_laws_of_multiplication(field: str, places: list[str]) -> None:
    O = QuaternionAlgebra.from_ramification(field, places).maximal_order()
    i = O.algebra.i
    I, J = O.left_ideal(["t^2+1", 1 + i]), O.right_ideal(["t+1", i])
    K = O.random_ideal("(t^2+t+1)*t", seed=2) if field == "GF(3)(t)" else I
    for L in (I, J, K, I.conjugate(), O.two_sided_prime("t+1")):
        assert L * L.inverse() == L.left_order()
        assert L.inverse() * L == L.right_order()
        assert L.colon(L) == L.left_order()
        assert L.index(L.left_order() & L) is not None
        assert L.left_order().index(L) == L.norm() ** 2
        assert L.conjugate() * L == L.right_order() * L.norm()
    assert (J * I).norm() == J.norm() * I.norm()
    assert (I & K) + I == I
    assert (I + K) & I == I
    assert I.dual().dual() == I
    assert I.index(I & K) == (I + K).index(K)


@pytest.mark.parametrize("constants", [("t", "t^2+1"), (2, "t^2+t")])
def test_two_generators_in_algebras_that_split_at_infinity(constants: tuple[Any, Any]) -> None:
    """No form reduces bases there."""
    A = QuaternionAlgebra(ring("GF(3)(t)"), *constants)
    O = A.maximal_order()
    assert not O.is_definite()
    for I in (*O.ideals_of_norm("t+2", side="left"), O.left_ideal(["t"])):
        n, x = I.generators
        assert O.left_ideal([n.generator, x]) == I


def test_elements_of_given_norm_against_brute_force() -> None:
    # the norm on 1, i, j, k is w² − ε·x² − P·(y² − ε·z²), anisotropic at infinity, for ε = −1
    O = QuaternionAlgebra.from_ramification("GF(3)(t)", ["t^3+2*t+1", "inf"]).maximal_order()
    A = O.algebra
    F, b = A.ring, A.constants.b
    assert [A.constants.a, b, O.volume()] == [F(-1), F("t^3+2*t+1"), 1]
    linear = [F(m) + F(n) * F.gen for m, n in product(range(3), repeat=2)]
    constants = linear[::3]
    norms: dict[object, int] = {}
    for w, x in product(linear, repeat=2):
        for y, z in product(constants, repeat=2):
            norm = w * w + x * x - b * (y * y + z * z)
            norms[norm] = norms.get(norm, 0) + 1
    for norm in ("1", "2", "t", "t^2+1", "t^2+t", "2*t^3+t+1", "t^3+t"):
        found = O.elements_of_norm(F(norm))
        assert len(found) == len(set(found)) == norms.get(F(norm), 0)
        assert {q.norm() for q in found} <= {F(norm)}
    assert O.theta_series(3) == norms


@pytest.mark.parametrize(
    ("q", "field", "P"),
    [(2, (2, 1), [1, 1, 0, 0, 1]), (3, (3, 1), [1, 2, 0, 1]), (5, (5, 1), [2, 0, 1])],
)
def test_brandt_matrices_count_isogenies_of_drinfeld_modules(
    q: int, field: tuple[int, int], P: list[int]
) -> None:
    modules = SupersingularModules(q, len(P) - 1, P, field)
    F = ring(f"GF({q})(t)")
    prime = sum((F(c) * F.gen**n for n, c in enumerate(P)), F.zero)
    C = QuaternionAlgebra.from_ramification(F, [prime, "inf"]).maximal_order().class_set()
    isogenies = modules.isogenies()
    assert len(modules.j) == len(C)
    assert sorted(map(sorted, isogenies)) == sorted(map(sorted, C.brandt_matrix("t")))
    assert fmpz_mat(isogenies).charpoly() == fmpz_mat(C.brandt_matrix("t")).charpoly()


@pytest.mark.parametrize(
    ("field", "P"), [("GF(2)(t)", "t+1"), ("GF(2)(t)", "t"), ("GF(3)(t)", "t+1")]
)
def test_classes_of_orders_that_are_not_eichler(field: str, P: str) -> None:
    O = QuaternionAlgebra.from_ramification(field, ["t", "inf"]).maximal_order()
    q = O.algebra.ring.base.order
    suborders = {X.eichler_symbol(P): X for X in O.suborders(P, 2)}
    assert set(suborders) == ({-1, 0} if P == "t" else {-1, 0, 1})
    for symbol, X in suborders.items():
        C = X.class_set()
        factor = 1 - Fraction(1, q * q) if symbol == 0 else 1 + Fraction(symbol, q)
        others = 1 if P == "t" else 1 - Fraction(1, q)  # the discriminant is P² times t, or t³
        assert C.mass == q**3 * factor * others / (q * q - 1)
        assert sum(Fraction(1, n) for n in C.units) == C.mass


@pytest.mark.parametrize(
    ("call", "reason"),
    [
        (lambda O: O.norm_one_group(), "hyperbolic plane"),
        (lambda O: O.ternary_form(), "ternary forms"),
        (lambda O: O.embeddings(-3), "quadratic orders"),
        (lambda O: O.algebra.lipschitz_order(), "over QQ"),
        (lambda O: O.algebra.eichler_order("t^3+2*t+1"), "in common"),
        (lambda O: O.ideals_of_norm("1/t"), "expected an ideal of GF"),
        (lambda O: O.class_set().neighbours("t^2"), "not a prime of GF"),
    ],
)
def test_what_is_not_possible_says_why(call: Any, reason: str) -> None:
    O = QuaternionAlgebra.from_ramification("GF(3)(t)", ["t^3+2*t+1", "inf"]).maximal_order()
    with pytest.raises(HFieldError, match=reason):
        call(O)


def test_large_fields_of_constants() -> None:
    p = 2**61 - 1
    O = QuaternionAlgebra.from_ramification(f"GF({p})(t)", ["t^2+1", "inf"]).maximal_order()
    I = O.random_ideal("t^3+2", seed=1)
    assert (O.discriminant().norm(), O.mass(), I * I.inverse() == O) == (p**2, 1, True)
    with pytest.raises(TooLargeError, match="smaller q"):
        I.is_principal()


def test_isomorphisms_of_orders_are_those_of_types() -> None:
    O = QuaternionAlgebra.from_ramification("GF(2)(t)", ["t^4+t+1", "inf"]).maximal_order()
    C = O.class_set()
    orders, kinds = C.left_orders(), C.types
    for m, X in enumerate(orders):
        for n, Y in enumerate(orders[: m + 1]):
            found = X.isomorphism(Y)
            assert bool(found) == (kinds[m] == kinds[n])
            if found.element is not None:
                assert found.element * X * found.element.inverse() == Y


@pytest.mark.parametrize("q", [2, 3, 4])
def test_newforms_are_the_functions_that_come_from_no_lower_level(q: int) -> None:
    """Their polynomials, those of lower levels twice, and the constant function make the Brandt matrix's."""
    F = ring(f"GF({q})(t)")
    places = [v for v in islice(F.places(), 30) if v.poly is not None]
    P = next(v for v in places if v.degree == 3)
    A = QuaternionAlgebra.from_ramification(F, [P, "inf"])
    C, below = A.eichler_order("t").class_set(), A.maximal_order().class_set()
    new, old = C.newforms(), below.newforms()
    assert sum(f.degree for f in new) == C.new_dimension() == len(C) - 1 - 2 * (len(below) - 1)
    for prime in ["t+1", next(v for v in places if v.degree == 2)]:
        norm = q if prime == "t+1" else q * q
        whole = fmpz_poly([-norm - 1, 1])
        for f in (*new, *old, *old):
            polynomial = fmpz_poly(f.minimal_polynomial(prime))
            whole *= polynomial ** (f.degree // polynomial.degree())
            assert abs(f.trace(prime)) <= 2 * f.degree * norm**0.5
        assert [int(c) for c in whole.coeffs()] == C.hecke_polynomial(prime)
    for f in new:
        assert f.label is None
        assert all(f.eigenvalue(prime) == f.field(-sign) for prime, sign in f.signs.items())
        assert len(f.eigenvalues_up_to(q)) == q
    for call in (lambda: C.newforms(weight=4), lambda: new[0].q_expansion(5)):
        with pytest.raises(LatticeError, match=r"over (GF\(q\)\[t\]|other fields)"):
            call()
