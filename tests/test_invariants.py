"""What algebras and elements are, asked as a user asks: through the classes, against other systems."""

import itertools
import json
from pathlib import Path
from random import Random
from typing import Any

import pytest

from hfield import GF, QQ, H, QuaternionAlgebra, hilbert_symbol, places, ring
from hfield.algebra.maps import Isomorphism
from hfield.errors import (
    CoercionError,
    MixedParentsError,
    RingError,
    UndecidedError,
)
from tests.subcases import subcases

VECTORS = Path(__file__).parent / "vectors"


def cases(name: str) -> list[dict[str, Any]]:
    return json.loads((VECTORS / f"{name}.json").read_text())["cases"]


def algebra(text: str) -> QuaternionAlgebra:
    return QuaternionAlgebra.from_text(text)


def product(m: Any, n: Any) -> Any:
    return tuple(
        tuple(sum((m[r][x] * n[x][s] for x in (1,)), m[r][0] * n[0][s]) for s in (0, 1))
        for r in (0, 1)
    )


# --- against PARI and GAP ---------------------------------------------------------------------


def test_ramification_agrees_with_pari() -> None:
    for case in cases("ramification"):
        A = QuaternionAlgebra(QQ, case["a"], case["b"])
        assert list(A.ramified_places()) == case["ramified"], case
        assert A.discriminant() == case["discriminant"]
        assert A.is_division_algebra() == case["division"]
        assert type(A.discriminant()) is int


def test_every_tenth_split_is_multiplied_out() -> None:
    for case in cases("ramification")[::10]:
        A = QuaternionAlgebra(QQ, case["a"], case["b"])
        answer = A.division_or_splitting()
        assert bool(answer) != case["division"]
        if answer:
            check_splitting(A)
        else:
            assert answer.reason
            assert A.split() is None


def test_symbols_agree_with_pari() -> None:
    for case in cases("hilbert")[::3]:
        a, b = QQ(str(case["a"])), QQ(str(case["b"]))
        assert hilbert_symbol(a, b, case["place"]) == case["value"], case


def test_division_over_quadratic_fields_agrees_with_pari() -> None:
    for case in cases("quadratic_division")[::2]:
        A = QuaternionAlgebra(case["ring"], case["a"], case["b"])
        assert A.is_division_algebra() == case["division"], case
        assert bool(A.ramified_places()) == case["division"]


def test_counts_agree_with_gap() -> None:
    for case in cases("finite_counts"):
        A = QuaternionAlgebra(case["ring"], case["a"], case["b"], case["t"])
        assert A.count() == case["elements"]
        assert A.count(norm=0) == case["norm_zero"], case
        assert A.count("nilpotent") == case["nilpotent"]
        assert A.count("idempotents") == case["idempotent"]
        assert A.count(square=1) == case["sqrt_one"]
        assert A.count(square=-1) == case["sqrt_minus_one"]
        assert A.count("units") == case["unit"]
        assert len(A.center()) == case["centre_dim"]
        assert A.is_commutative() == case["commutative"]


# --- what other systems get wrong ---------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "places"), [("(2,3|QQ)", (2, 3)), ("(3,5|QQ)", (3, 5)), ("(-1,3|QQ)", (2, 3))]
)
def test_division_algebras_that_gap_denies(text: str, places: tuple[int, int]) -> None:
    A = algebra(text)
    assert A.is_division_algebra()
    assert A.ramified_places() == places
    assert A.zero_norm_element() is None


def test_hamilton_over_gf7_is_no_field() -> None:
    A = H(GF(7))
    assert not A.is_commutative()
    assert not A.is_division_algebra()
    q = A.zero_norm_element()
    assert q is not None
    assert not q.is_unit()
    assert q.is_zero_divisor()


def test_characteristic_2_and_square_constants_are_welcome() -> None:
    assert H("GF(4)").is_commutative()
    assert not H("GF(4)").is_central_simple()
    proper = algebra("[1,t|GF(2)(t))")
    assert proper.is_division_algebra()
    assert [str(v) for v in proper.ramified_places()] == ["t", "inf"]
    assert not algebra("(4,7|QQ)").is_division_algebra()


# --- division or splitting ----------------------------------------------------------------------

SPLIT = [
    "(-1,-1|GF(7))", "(x,1|GF(9))", "[1,1|GF(2))", "[x,x|GF(8))", "(2,-1|RR)", "(-3,-2|CC)",
    "(2,5|QQ(sqrt(2)))", "(-1,-1|QQ(I))", "(t,t+1|GF(5)(t))", "[1,t|GF(4)(t))", "(x,-x|QQ(x))",
    "(1000003,9-16*1000003|QQ)", "[3,5,2|QQ(sqrt(-11)))",
]  # fmt: skip


def check_splitting(A: QuaternionAlgebra) -> None:
    F = A.ring
    _, i, j, _ = (A.to_matrix(q) for q in A.basis)
    assert tuple(A.split()) == (i, j)  # type: ignore[arg-type]
    rng = Random(1)
    p, q = (A(*(F.random(rng) for _ in range(4))) for _ in range(2))
    m, n = A.to_matrix(p), A.to_matrix(q)
    for r, s in itertools.product((0, 1), repeat=2):
        assert F.equal(A.to_matrix(p * q)[r][s], product(m, n)[r][s])
    assert F.equal(m[0][0] * m[1][1] - m[0][1] * m[1][0], p.norm())
    assert A.from_matrix(m) == p
    assert A.from_matrix([[0, 1], [0, 0]]).is_nilpotent()


@subcases("text", SPLIT)
def test_splittings(text: str) -> None:
    A = algebra(text)
    assert not A.is_division_algebra()
    check_splitting(A)
    zero = A.zero_norm_element()
    assert zero is not None
    assert A.ring.is_zero(zero.norm())
    assert not zero.is_zero()


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("(-1,-3|QQ)", "ordering"),
        ("(3,5|QQ)", "ramified"),
        ("(-1,-1|QQ(sqrt(-7)))", "two squares"),
        ("(-1,-1|RR)", "ordering"),
        ("(x,x+1|QQ(x))", "ramified"),
        ("(2,t|GF(5)(t))", "ramified"),
        ("(3,7|QQ(x))", "ramified at"),
    ],
)
def test_division_algebras_say_why(text: str, reason: str) -> None:
    A = algebra(text)
    answer = A.division_or_splitting()
    assert not answer
    assert reason in answer.reason
    assert reason in repr(answer)
    assert A.split() is None
    assert A.is_division_algebra()
    with pytest.raises(CoercionError, match="division algebra"):
        A.to_matrix(A.one)


def test_degenerate_algebras_are_neither() -> None:
    A = algebra("(0,1|GF(3))")
    assert len(A.radical()) == 2
    assert not A.is_central_simple()
    with pytest.raises(CoercionError, match="degenerate"):
        A.split()
    with pytest.raises(RingError, match="degenerate"):
        A.ramified_places()


def test_floats_decide_nothing() -> None:
    for question in ("is_division_algebra", "zero_norm_element"):
        with pytest.raises(UndecidedError, match="inexact"):
            getattr(algebra("(1,2|RDF)"), question)()


# --- places and ramification ---------------------------------------------------------------------


@pytest.mark.parametrize("name", ["QQ", "QQ(sqrt(2))", "QQ(sqrt(-7))", "GF(9)(t)", "GF(3)(t)"])
def test_places_read_back(name: str) -> None:
    F = ring(name)
    a, b = F.gen if F.gen_name else F(3), F(-1)
    for v in itertools.islice(F.places(), 8):
        assert hilbert_symbol(F(a), F(b), v) == hilbert_symbol(F(a), F(b), str(v))
    assert [*itertools.islice(places(F), 4)] == [*itertools.islice(F.places(), 4)]


@pytest.mark.parametrize("place", ["banana", 4, 0, "6", None, 1.5])
def test_what_is_no_place(place: object) -> None:
    with pytest.raises(RingError, match="place"):
        hilbert_symbol(-1, 3, place)


def test_from_ramification() -> None:
    A = QuaternionAlgebra.from_ramification(QQ, [2, 3, 7], infinite=True)
    assert A.ramified_places() == (2, 3, 7, "inf")
    assert A.discriminant() == 42
    assert QuaternionAlgebra.from_ramification(QQ, [7], infinite=True).is_isomorphic(
        algebra("(-1,-7|QQ)")
    )
    for wrong in ([4], [2, 2], [2, 3, "inf"]):
        with pytest.raises(RingError):
            QuaternionAlgebra.from_ramification(QQ, wrong)
    with pytest.raises(RingError, match="even"):
        QuaternionAlgebra.from_ramification(QQ, [2, 3], infinite=True)
    with pytest.raises(RingError, match="expected QQ, or a number field"):
        QuaternionAlgebra.from_ramification("GF(7)", [])


def test_two_hundred_digits_with_known_primes() -> None:
    primes = [2**89 - 1, 2**127 - 1, 2**521 - 1]
    n = primes[0] * primes[1] * primes[2]
    found = QuaternionAlgebra(QQ, -n, -1).ramified_places(factors=primes)
    assert found == tuple(v for v in (2, *primes, "inf") if hilbert_symbol(-n, -1, v) < 0)
    assert len(found) == 4
    assert len(str(n)) > 200


# --- isomorphism ----------------------------------------------------------------------------------


@subcases(
    ("left", "right", "same"),
    [
        ("(-1,-1|QQ)", "(-2,-5|QQ)", False),
        ("(-1,-1|QQ)", "(-2,-1|QQ)", True),
        ("(-1,-7|QQ)", "(-7,-14|QQ)", None),
        ("[1,2|QQ)", "(5,2|QQ)", True),
        ("(2,3|GF(7))", "(1,1|GF(7))", True),
        ("[x,1|GF(4))", "[0,x|GF(4))", True),
        ("(-1,-1|RR)", "(-2,-sqrt(3)|RR)", True),
        ("(-1,-1|RR)", "(1,-1|RR)", False),
        ("(2,5|QQ(I))", "(1,1|QQ(I))", False),
        ("(-1,-1|QQ(sqrt(2)))", "(-3,-3|QQ(sqrt(2)))", None),
        ("(2,t|GF(5)(t))", "(3,t|GF(5)(t))", True),
        ("[1,t|GF(2)(t))", "[1,t^3|GF(2)(t))", True),
    ],
)
def test_isomorphisms(left: str, right: str, same: bool | None) -> None:
    A, B = algebra(left), algebra(right)
    found = A.is_isomorphic(B)
    assert same is None or found == same
    phi = A.isomorphism(B)
    assert (phi is not None) == found
    if phi is None:
        return
    rng = Random(2)
    p, q = (A(*(A.ring.random(rng) for _ in range(4))) for _ in range(2))
    assert phi(p * q) == phi(p) * phi(q)
    assert phi(p + q) == phi(p) + phi(q)
    assert A.ring.equal(phi(p).norm(), p.norm())
    assert not A.ring.is_zero(phi.determinant)
    psi = phi.inverse()
    assert psi(phi(p)) == p
    assert psi.inverse() == phi
    with pytest.raises(MixedParentsError, match="defined on"):
        phi(H("GF(11)").one)


def test_a_map_that_is_no_isomorphism_is_refused() -> None:
    A = algebra("(-1,-1|QQ)")
    e, i, j, k = A.basis
    with pytest.raises(CoercionError, match="not a homomorphism"):
        Isomorphism(A, A, [e, i, j, -k])


def test_algebras_over_different_fields_are_not_compared() -> None:
    with pytest.raises(MixedParentsError, match=r"over QQ and .* over RR"):
        H(QQ).is_isomorphic(H("RR"))
    with pytest.raises(CoercionError, match="not a quaternion algebra"):
        H(QQ).is_isomorphic("(-1,-1|QQ)")


def test_hard_questions_end_in_time() -> None:
    n = (10**60 + 7) * (10**61 + 9)
    with pytest.raises(UndecidedError, match="factors="):
        QuaternionAlgebra(QQ, n, 3).ramified_places()
