"""Newforms by Brandt matrices: against PARI over ℚ, known dimensions and forms over number fields."""

import importlib.util

import pytest
from flint import fmpz_poly

from hfield import LatticeError, QuaternionAlgebra, ring
from tests.orders.hilbert_traces import Field, published
from tests.subcases import first_quick

PRIMES = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37]


# the minimal polynomials of the coefficients of each Galois orbit
ORBITS = """
(N, k, primes) -> my(minimal(c) = Vecrev(if(type(c) == "t_POLMOD", minpoly(c), x - c)));
apply(f -> apply(p -> minimal(mfcoef(f, p)), primes), mfeigenbasis(mfinit([N, k], 0)))
"""


def orbits(level: int, weight: int, primes: list[int]) -> list[list[list[int]]]:
    """The minimal polynomials of the coefficients of each Galois orbit of newforms, by PARI."""
    from cypari import pari

    found = pari(f"({ORBITS.replace(chr(10), ' ')})({level}, {weight}, {primes})")
    return sorted([[int(c) for c in f] for f in form] for form in found)


@pytest.mark.skipif(importlib.util.find_spec("cypari") is None, reason="needs PARI")
@pytest.mark.parametrize(
    ("discriminant", "level"),
    first_quick(
        [(37, 1), (11, 9), (3, 22), (5, 8), (17, 6), (30, 7), (42, 5), (3, 49), (2, 81)], 5
    ),
)
def test_against_pari(discriminant: int, level: int) -> None:
    """Eigenvalues at all primes, those of the level too, and so the signs of Atkin and Lehner."""
    C = QuaternionAlgebra(discriminant).eichler_order(level).class_set()
    expected = orbits(discriminant * level, 2, PRIMES)
    forms = C.newforms()
    assert C.new_dimension() == sum(f.degree for f in forms)
    assert sorted([f.minimal_polynomial(p) for p in PRIMES] for f in forms) == expected


def test_orbits_of_level_389() -> None:
    """The first elliptic curve of rank 2, and the eigenvalues of a whole orbit in its field."""
    forms = QuaternionAlgebra(389).maximal_order().class_set().newforms()
    assert [f.degree for f in forms] == [1, 2, 3, 6, 20]
    assert [f.signs[389] for f in forms] == [-1, 1, 1, 1, -1]
    assert forms[0].eigenvalues(6) == {2: -2, 3: -2, 5: -3, 7: -5, 11: -4, 13: -3}
    f = forms[2]
    assert f.field.polynomial.coeffs() == [1, -3, -1, 1]
    for p in (2, 3, 5, 101):
        a = f.eigenvalue(p)
        assert a.trace() == f.trace(p)
        assert [int(c) for c in a.minimal_polynomial()] == f.minimal_polynomial(p)


@pytest.mark.skipif(importlib.util.find_spec("cypari") is None, reason="needs PARI")
def test_fields_are_given_by_the_polynomials_of_the_lmfdb() -> None:
    """Those that PARI's polredabs chooses."""
    from cypari import pari

    for p in (23, 71, 113, 173):
        for f in QuaternionAlgebra(p).maximal_order().class_set().newforms():
            coefficients = [int(c) for c in f.field.polynomial.coeffs()] if f.degree > 1 else [0, 1]
            if f.degree < 8:
                assert coefficients == [
                    int(c) for c in pari.Polrev(coefficients).polredabs().Vecrev()
                ]


def test_labels_and_coefficients() -> None:
    """LMFDB orders the curves of conductor 57 by a₂, a₃, …; a₄ and a₉ follow Hecke's relations."""
    forms = QuaternionAlgebra(3).eichler_order(19).class_set().newforms()
    assert [(f.label, f[2], f[3], f[5]) for f in forms] == [
        ("57.2.a.a", -2, -1, -3),
        ("57.2.a.b", -2, 1, 1),
        ("57.2.a.c", 1, 1, -2),
    ]
    f = forms[0]
    assert (f.coefficient(4), f.coefficient(9), f.coefficient(12)) == (f[2] ** 2 - 2, 1, -2)
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    (f,) = A.eichler_order([(A.ring.primes_above(31)[0], 1)]).class_set().newforms()
    assert f.label is None
    with pytest.raises(LatticeError, match="q-expansions are for forms over QQ"):
        f.coefficient(2)


def test_larger_spaces_split_by_a_sign() -> None:
    """Two orbits of one sign each, and traces of Brandt matrices that took no part in it."""
    C = QuaternionAlgebra(1009).maximal_order().class_set()
    forms = C.newforms()
    assert [(f.degree, f.signs) for f in forms] == [(37, {1009: 1}), (46, {1009: -1})]
    swap = C.exchanged(1009)
    assert sum(swap[n] == n for n in range(len(C))) == 1 - 37 + 46
    for p in (5, 7):
        B = C.brandt_matrix(p)
        assert sum(B[n][n] for n in range(len(C))) == p + 1 + sum(f.trace(p) for f in forms)
        odd = sum(B[n][n] - B[n][m] for n, m in enumerate(swap) if n < m)
        assert odd == forms[0].trace(p)


def test_known_spaces_over_the_golden_field() -> None:
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    K = A.ring
    known = [(31, 1, 1), (124, 3, 1), (341, 7, 5), (1364, 31, 15)]
    P31 = K.primes_above(31)[0]
    for P11 in K.primes_above(11):
        found = []
        for norm, *_ in known:
            pairs = [
                (P, 1)
                for P, q in ((K.primes_above(2)[0], 4), (P11, 11), (P31, 31))
                if norm % q == 0
            ]
            C = A.eichler_order(pairs).class_set()
            found.append((norm, C.cusp_dimension(), C.new_dimension()))
        assert found == known
        assert len(C) == 32


# Eigenvalues of 2.2.5.1-31.1-a in the LMFDB, by the norms of primes.
LMFDB_31 = {
    4: [-3], 5: [-2], 9: [2], 11: [4, -4], 19: [-4, 4], 29: [-2, -2], 31: [-1, 8], 41: [-6, -6],
    49: [2], 59: [12, -4], 61: [6, -2], 71: [0, -8], 79: [0, 16], 89: [-6, 10],
}  # fmt: skip


def trace_of_frobenius(p: int, r: int, n: int) -> int:
    """N(P) + 1 less the points of y² + xy + φy = x³ + (φ + 1)x² + φx, φ being r in GF(p), or in GF(p²)."""
    field = [(a, b) for a in range(p) for b in (range(p) if n == 2 else (0,))]
    phi = (0, 1) if n == 2 else (r, 0)

    def times(x: tuple[int, int], y: tuple[int, int]) -> tuple[int, int]:
        (a, b), (c, d) = x, y
        return (a * c + b * d) % p, (a * d + b * c + b * d) % p

    def plus(*terms: tuple[int, int]) -> tuple[int, int]:
        return sum(a for a, _ in terms) % p, sum(b for _, b in terms) % p

    # y·(y + x + φ) = x·(x·(x + φ + 1) + φ)
    affine = sum(
        times(y, plus(y, x, phi)) == times(x, plus(times(x, plus(x, phi, (1, 0))), phi))
        for x in field
        for y in field
    )
    return len(field) - affine


def test_the_curve_of_conductor_31() -> None:
    """At primes of both degrees: points counted, and the table of the LMFDB."""
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    golden = (1 + A.ring.gen) / 2
    level = next(P for P in A.ring.primes_above(31) if 5 * golden - 2 in P)
    (f,) = A.eichler_order([(level, 1)]).class_set().newforms()
    found: dict[int, list[int]] = {}
    for P, a in f.eigenvalues_up_to(89).items():
        found.setdefault(P.norm(), []).append(a)
        if P.norm() <= 29:
            r = next((r for r in range(P.p) if golden - r in P), 0)
            assert a == trace_of_frobenius(P.p, r, 2 if P.is_inert else 1)
    assert {q: sorted(some) for q, some in found.items()} == {
        q: sorted(some) for q, some in LMFDB_31.items()
    }


def test_signs_at_the_level_agree_with_ideals_of_that_norm() -> None:
    """All invertible ideals of norm P | N are those of U_P, those of its conjugate, and the two-sided one."""
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    P = A.ring.primes_above(31)[0]
    C = A.eichler_order([(P, 1)]).class_set()
    (f,) = C.newforms()
    B = C.brandt_matrix(P)
    assert sum(B[0]) == 63
    assert B[0][0] + B[1][1] == 63 + 2 * f[P] + f.signs[P]


@pytest.mark.slow
@pytest.mark.parametrize("weight", [2, 4])
def test_class_number_two(weight: int) -> None:
    """Over ℚ(√10), class number 2: newforms do not depend on the algebra (Jacquet and Langlands)."""
    K = ring("QQ(sqrt(10))")
    P, Q = K.primes_above(2)[0], K.primes_above(3)[0]
    split = QuaternionAlgebra.from_ramification(K, K.real_places())
    ramified = QuaternionAlgebra.from_ramification(K, [*K.real_places(), P, Q])
    over = split.eichler_order([(P, 1), (Q, 1)]).class_set()
    other = ramified.maximal_order().class_set()
    assert over.new_dimension(weight) == other.new_dimension(weight) == {2: 2, 4: 12}[weight]
    primes = [P, Q, *K.primes_above(5), *K.primes_above(3), *K.primes_above(7)]
    mine, its = (
        sorted([f.minimal_polynomial(P) for P in primes] for f in C.newforms(weight))
        for C in (over, other)
    )
    assert mine == its


# --- weights ---------------------------------------------------------------------------------------


@pytest.mark.skipif(importlib.util.find_spec("cypari") is None, reason="needs PARI")
@pytest.mark.parametrize(
    ("discriminant", "level", "weight"),
    first_quick([(3, 5, 4), (2, 9, 6), (30, 1, 4), (7, 1, 12), (2, 27, 4), (5, 12, 6)], 3),
)
def test_weights_against_pari(discriminant: int, level: int, weight: int) -> None:
    forms = QuaternionAlgebra(discriminant).eichler_order(level).class_set().newforms(weight)
    expected = orbits(discriminant * level, weight, PRIMES)
    assert sorted([f.minimal_polynomial(p) for p in PRIMES] for f in forms) == expected


def test_level_one_over_the_golden_field() -> None:
    """The forms of even weight are polynomials in three of weights 2, 6 and 10 (Gundlach, 1963)."""
    C = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order().class_set()
    assert [C.cusp_dimension(k) for k in (2, 4, 6, 8)] == [0, 0, 1, 1]
    (f,) = C.newforms(weight=6)
    assert (f[2], f[3]) == (20, 90)


@pytest.mark.parametrize(
    ("discriminant", "level", "weight"),
    first_quick(
        [
            *((5, 1, 6), (5, 1, 8), (5, 2, 4), (5, 5, 4), (8, 2, 4), (12, 1, 4), (40, 1, 2)),
            *((5, 1, 10), (5, 1, 12), (5, 2, 8), (5, 4, 4), (8, 3, 4), (13, 2, 4), (60, 1, 2)),
        ],
        7,
    ),
)
def test_published_traces(discriminant: int, level: int, weight: int) -> None:
    """Of T₁, …, T₅ over real quadratic fields; those of 12, 40 and 60 have several narrow classes."""
    expected = published()[discriminant][level, weight]
    assert Field(discriminant).traces(level, weight) == expected


def test_base_change() -> None:
    """The form of level 3 and weight 6 over ℚ, and that over ℚ(√5) which comes from it."""
    (f,) = QuaternionAlgebra(3).maximal_order().class_set().newforms(weight=6)
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    lift = A.eichler_order(3).class_set().newforms(weight=6)[0]
    assert lift[2] == f[2] ** 2 - 2 * 2**5
    assert [lift[P] for P in A.ring.primes_above(11)] == [f[11]] * 2
    assert (lift[3], lift.signs[A.ring.primes_above(3)[0]]) == (f[3] ** 2, f.signs[3])


def test_base_change_to_a_cubic_field() -> None:
    K = ring("QQ[s]/(s^3-s^2-2*s+1)")
    A = QuaternionAlgebra.from_ramification(K, [*K.real_places(), K.primes_above(7)[0]])
    (f,) = QuaternionAlgebra(7).maximal_order().class_set().newforms(weight=4)
    (lift,) = A.maximal_order().class_set().newforms(weight=4)
    assert lift[2] == f[2] ** 3 - 3 * 2**3 * f[2]
    assert lift[K.primes_above(13)[0]] == f[13]


def test_polynomials_on_all_forms() -> None:
    """Old and new: Hecke's relations, and at the level the trace of two one-sided parts and the exchange."""
    C = QuaternionAlgebra(5).eichler_order(3).class_set()
    new = C.newforms(weight=4)
    (old,) = QuaternionAlgebra(5).maximal_order().class_set().newforms(weight=4)
    for norm, eigenvalue in {
        2: lambda f: f[2],
        4: lambda f: f[2] ** 2 - 2**3,
        14: lambda f: f[2] * f[7],
        25: lambda f: f[5] ** 2,
    }.items():
        expected = fmpz_poly([1])
        for f in [*new, old, old]:
            expected *= fmpz_poly([-int(eigenvalue(f)), 1])
        assert C.hecke_polynomial(norm, weight=4) == [int(c) for c in expected.coeffs()]
    at_level = sum(2 * f[3] + 3 * f.signs[3] for f in new) + 2 * old[3]
    assert -C.hecke_polynomial(3, weight=4)[-2] == at_level
    with pytest.raises(LatticeError, match="weight 4"):
        C.hecke_polynomial(9, weight=4)


@pytest.mark.parametrize("weight", [0, 3, -2, "4", 2.5])
def test_odd_weights_are_refused(weight: object) -> None:
    C = QuaternionAlgebra(5).maximal_order().class_set()
    with pytest.raises(LatticeError, match="2, 4, 6"):
        C.newforms(weight=weight)  # type: ignore[arg-type]


def test_other_orders_have_no_level() -> None:
    C = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).order(["i", "j"]).class_set()
    with pytest.raises(LatticeError, match="Eichler"):
        C.newforms()
    C = QuaternionAlgebra("QQ", -1, -1).order(["i", "j"]).class_set()
    with pytest.raises(LatticeError, match="Eichler"):
        C.cusp_dimension()


@pytest.mark.parametrize(("level", "weight"), [("7", 2), ("3 + sqrt(2)", 4)])
def test_eigenvalues_are_bounded(level: str, weight: int) -> None:
    """All conjugates of a_P are real, and 2·N(P)^((k − 1)/2) at most (Deligne, Blasius)."""
    A = QuaternionAlgebra("QQ(sqrt(2))", -1, -1)
    forms = A.eichler_order(level).class_set().newforms(weight=weight)
    assert forms
    for f in forms:
        for P in list(f.eigenvalues(8)):
            bound = 4 * P.norm() ** (weight - 1)
            for a, _ in fmpz_poly(f.minimal_polynomial(P)).complex_roots():
                assert a.imag == 0
                assert a.real**2 <= bound
