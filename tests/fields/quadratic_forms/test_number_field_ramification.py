"""Number fields as global fields: symbols and ramification against PARI, conics, ramification to algebra."""

from itertools import islice
from random import Random

import pytest

from hfield import QuaternionAlgebra, hilbert_symbol, ring
from hfield.core.product import Constants
from hfield.errors import CoercionError, RingError, UndecidedError
from hfield.fields.number_fields import zeros_of_forms
from hfield.fields.number_fields.conics import solve_conic_number_field
from hfield.fields.number_fields.places import ComplexPlace, RealPlace
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.residues import local_place
from hfield.fields.number_fields.symbols import candidates
from hfield.fields.quadratic_forms.minimal_conics import Conic, minimise, norm_form
from tests.fields.quadratic_forms.number_field_cases import cases, field, prime
from tests.steps import steps
from tests.subcases import first_quick, subcases
from tests.thorough import part, quick_part

ALGEBRAS = cases("number_field_ramification")
POLYNOMIALS = list(dict.fromkeys(case["polynomial"] for case in ALGEBRAS))


@pytest.mark.slow
@subcases("polynomial", POLYNOMIALS)
def test_ramification_is_that_of_pari(polynomial: str) -> None:
    """Symbols at all primes of 2ab, dyadic ones too; PARI checked that they multiply to 1."""
    K = field(polynomial)
    wrong, count = [], 0
    for case in part(ALGEBRAS, 3):
        if case["polynomial"] == polynomial:
            places = QuaternionAlgebra(K, case["a"], case["b"]).ramified_places()
            expected = {prime(K, *data) for data in case["finite"]}
            expected |= {K.real_places()[n] for n in case["real"]}
            count += 1
            if set(places) != expected or len(places) != len(expected):
                wrong.append((case, places))
    assert count >= 16
    assert wrong == []


def test_the_vectors_are_many() -> None:
    assert len(ALGEBRAS) == 2000
    assert len(POLYNOMIALS) == 40
    assert {field(f).degree for f in POLYNOMIALS} == set(range(3, 11))
    assert sum(case["finite"] == case["real"] == [] for case in ALGEBRAS) > 300


@pytest.mark.slow
@subcases("polynomial", POLYNOMIALS[::3])
def test_symbols_are_those_of_minimised_forms(polynomial: str) -> None:
    """At every prime of 2ab: the form has a good lattice exactly where the symbol is 1."""
    K, rng = field(polynomial), Random(polynomial)
    for _ in quick_part(range(3)):
        a, b = (K.random(rng) for _ in "ab")
        if not (a and b):
            continue
        for p in sorted({2} | candidates(K, a) | candidates(K, b)):
            for P in K.primes_above(p):
                conic = Conic(norm_form(K, Constants(a, K.zero, b)), K.zero, K.one)
                good = minimise(conic, conic.start(), local_place(P))
                assert good == (hilbert_symbol(a, b, P) == 1)


@pytest.mark.parametrize(
    "polynomial", first_quick(["x^4+4*x+2", "x^6-2*x^3+2", "x^8+1", "x^10-2", "x^8-x^4+1"], 1)
)
def test_symbols_above_2_are_bilinear(polynomial: str) -> None:
    K, rng = field(polynomial), Random(7)
    for P in K.primes_above(2):
        drawn = [x for x in (K.random(rng) for _ in range(6)) if x]
        table = {(x, y): hilbert_symbol(x, y, P) for x in drawn for y in drawn}
        for x, y in table:
            assert table[x, y] == table[y, x]
            assert hilbert_symbol(x, -x, P) == 1
            assert x == 1 or hilbert_symbol(x, 1 - x, P) == 1
            assert hilbert_symbol(x * y * y, drawn[0], P) == table[x, drawn[0]]
            for z in drawn[:3]:
                assert hilbert_symbol(x * y, z, P) == table[x, z] * table[y, z]
        assert {*table.values()} == {1, -1}


def test_what_has_no_symbol_is_refused() -> None:
    K, L = ring("QQ[s]/(s^3-2)"), ring("QQ(zeta5)")
    with pytest.raises(RingError, match="0"):
        hilbert_symbol(K.zero, K.one, K.primes_above(3)[0])
    with pytest.raises(RingError, match=r"3 is a place of QQ\(zeta5\), not of"):
        hilbert_symbol(K.gen, K.one, L.primes_above(3)[0])
    with pytest.raises(CoercionError, match="different rings"):
        hilbert_symbol(K.gen, L.gen, K.primes_above(3)[0])
    with pytest.raises(RingError, match="not a single place"):
        hilbert_symbol(K.gen, K.one, "5")
    assert hilbert_symbol(K(-1), K(-1), "(2, s)") == -1
    assert hilbert_symbol("s", "-1", K.real_places()[0]) == 1
    assert hilbert_symbol("-s", "-1", K.real_places()[0]) == -1
    assert hilbert_symbol(-K.gen, -1, K.infinite_places()[1]) == 1


def test_headlines() -> None:
    A = QuaternionAlgebra("QQ[x]/(x^3-2)", -1, -1)
    assert [str(v) for v in A.ramified_places()] == ["(2, x)", "inf0"]
    assert [str(v) for v in A.discriminant()] == ["(2, x)"]
    assert A.is_division_algebra()
    B = QuaternionAlgebra("QQ(zeta5)", -1, -1)
    assert B.ramified_places() == ()
    assert not B.is_division_algebra()
    assert B.zero_norm_element().norm() == 0
    assert QuaternionAlgebra("QQ(zeta7)", -1, -1).is_division_algebra()


@pytest.mark.parametrize(
    "polynomial",
    first_quick(["x^3-2", "x^4-x-1", "x^3-3*x-1", "x^4+x^3+x^2+x+1", "x^6+x^3+1", "x^5-x+1"], 1),
)
def test_conics_without_obstruction_are_solved(polynomial: str) -> None:
    K, solved = field(polynomial), 0
    for case in ALGEBRAS:
        if case["polynomial"] == polynomial and not (case["finite"] or case["real"]) and solved < 6:
            a, b = K(case["a"]), K(case["b"])
            x, y, z = solve_conic_number_field(K, a, b)
            assert a * x * x + b * y * y == z * z
            assert x or y or z
            solved += 1
    assert solved == 6


def test_splittings_and_isomorphisms() -> None:
    K = ring("QQ[s]/(s^3-2)")
    A, B = QuaternionAlgebra(K, "s", "1-s"), QuaternionAlgebra(K, "7", "s^2-s-6+1/3*s")
    assert A.split() is not None
    D = QuaternionAlgebra(K, -1, -1)
    C = QuaternionAlgebra.from_ramification(K, D.ramified_places())
    assert C != D
    assert D.is_isomorphic(C)
    f = D.isomorphism(C)
    i, j = f(D.basis[1]), f(D.basis[2])
    assert i * i == -1 == j * j
    assert i * j == -(j * i)
    assert not D.is_isomorphic(A)
    assert B.is_isomorphic(B)


@pytest.mark.slow
@subcases(
    "name",
    ["QQ[s]/(s^3-2)", "QQ(zeta7)+", "QQ(zeta5)", "QQ[s]/(s^4-s-1)", "QQ(sqrt(2),sqrt(3))", "QQ[s]/(s^6-2)",
     "QQ[s]/(s^5-s+1)", "QQ[s]/(s^8+15)", "QQ(zeta11)+", "QQ[s]/(s^10-2)", "QQ(sqrt(5))", "QQ(I)"],
)  # fmt: skip
def test_algebras_are_made_from_their_ramification(name: str) -> None:
    K, rng = ring(name), Random(name)
    places = [v for v in islice(K.places(), 12) if v.is_finite or _is_real(v)]
    for size in (0, 2, 2, 2, 4, 4, 2, 4, 6):
        wanted = rng.sample(places, min(size, len(places) // 2 * 2))
        A = QuaternionAlgebra.from_ramification(K, wanted)
        assert set(A.ramified_places()) == set(wanted)


def _is_real(v: object) -> bool:
    return isinstance(v, RealPlace) or getattr(v, "root", None) is not None


def test_ramification_that_does_not_exist_is_refused() -> None:
    K = ring("QQ[s]/(s^3-2)")
    for places, why in (
        (["(2, s)"], "even number"),
        (["(2, s)", "(2, s)"], "twice"),
        (["(2, s)", "inf1"], "complex"),
        (["(2, s)", "4"], "not a place"),
        ([ring("QQ(zeta5)").primes_above(2)[0], "(2, s)"], "is a place of"),
    ):
        with pytest.raises(RingError, match=why):
            QuaternionAlgebra.from_ramification(K, places)
    with pytest.raises(RingError, match="expected QQ, or a number field"):
        QuaternionAlgebra.from_ramification("GF(5)(t)", ["t", "t+1"], infinite=True)


def test_a_cold_algebra_over_a_field_of_degree_4_takes_few_steps() -> None:
    """Calls of functions, about a microsecond each: what 20 ms are enough for."""
    K = field("x^4-x-1")
    a, b = K("3*x^3-12*x^2+7*x-20"), K("17*x^3+4*x^2-9*x+11")
    QuaternionAlgebra(K, "x+1", "3").ramified_places()
    work = QuaternionAlgebra(K, a, b)
    assert steps(work.ramified_places) < 20_000


def test_places_of_every_kind_are_seen() -> None:
    K = ring("QQ[s]/(s^4-2)")
    kinds = [type(v) for v in islice(K.places(), 5)]
    assert kinds == [RealPlace, RealPlace, ComplexPlace, PrimeIdeal, PrimeIdeal]


@pytest.mark.slow
def test_square_roots_in_division_algebras() -> None:
    A = QuaternionAlgebra("QQ[s]/(s^3-2)", -1, -1)
    for s in ("-3", "-s", "s-3"):
        roots = A(s).square_roots()
        assert all(q * q == A(s) for q in roots)
        assert len(list(roots)) > 0
    assert not list(A("s").square_roots())
    assert A.basis[1].order() == 4
    assert QuaternionAlgebra("QQ(zeta5)", -1, -1)("-zeta5*e").order() == 10


def test_a_search_that_finds_nothing_ends_within_its_bounds(monkeypatch):
    """So many bases, and at most so many exact values on each, however large the coefficients are."""
    tried = []
    combine = zeros_of_forms.combination

    def counted(coefficients, basis):
        if not isinstance(
            basis[0][0], complex
        ):  # floats are combined for each basis, exact values seldom
            tried.append(coefficients)
        return combine(coefficients, basis)

    monkeypatch.setattr(zeros_of_forms, "MAX_BASES", 6)
    K = ring("QQ[s]/(s^6+1000003*s+7919)")
    a, x, y = K("s+2"), K("s^2+1"), K("3*s-1")
    monkeypatch.setattr(zeros_of_forms, "combination", counted)
    with pytest.raises(UndecidedError, match="of each of 6 reduced bases"):
        solve_conic_number_field(K, a, x * x - a * y * y)
    assert len(tried) <= 3 * K.degree + 6 * zeros_of_forms.MAX_ZEROS
