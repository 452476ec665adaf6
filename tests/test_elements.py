"""Elements, counts, orders and changes of ring, asked as a user asks: through the classes."""

import pytest

from hfield import GF, QQ, H, QuaternionAlgebra, conjugator, ring
from hfield.errors import (
    CoercionError,
    HFieldError,
    MixedParentsError,
    NotFiniteError,
    RingError,
)
from tests.subcases import subcases

algebra = QuaternionAlgebra.from_text


@pytest.mark.parametrize(
    "text", ["(-1,-3|QQ)", "[x,t,x|GF(4)(t))", "[1,0|GF(5))", "(-1,-1|GF(2))", "(2,3|ZZ/6)"]
)
def test_the_opposite_algebra(text: str) -> None:
    A = algebra(text)
    B, phi = A.opposite()
    p, q = A.random_element(1), A.random_element(2)
    assert phi(p * q) == phi(q) * phi(p)
    assert phi.inverse()(phi(p)) == p
    assert phi(p) in B


def test_derivations_are_inner() -> None:
    A = algebra("[1,3|QQ)")
    found = A.derivations()
    assert len(found) == 3
    p, q = A.random_element(1), A.random_element(2)
    for d in found:
        assert d(p * q) == d(p) * q + p * d(q)


# --- change of ring -------------------------------------------------------------------------------


@subcases(
    ("small", "large"),
    [("GF(4)", "GF(16)"), ("GF(9)", "GF(9, x^2+1)"), ("GF(9, x^2+1)", "GF(81)"), ("GF(4)", "GF(4)(t)"),
     ("GF(4)(t)", "GF(16)(t)"), ("GF(3)", "GF(9)"), ("QQ", "QQ(sqrt(2))"), ("QQ(sqrt(2))", "RR"),
     ("QQ(I)", "CC"), ("QQ", "QQ(x)"), ("ZZ/6", "GF(3)")],
)  # fmt: skip
def test_changing_the_ring_is_a_homomorphism(small: str, large: str) -> None:
    F = ring(small)
    a = F.gen if F.gen_name else F(2)
    A = QuaternionAlgebra(F, a, -1)
    p, q = A.random_element(3), A.random_element(4)
    B = A.change_ring(large)
    assert (p * q).change_ring(large) == p.change_ring(large) * q.change_ring(large)
    assert (p + q).change_ring(large) in B


@pytest.mark.parametrize(
    ("source", "target"),
    [("GF(7)", "QQ"), ("GF(7)", "GF(5)"), ("GF(4)", "GF(8)"), ("QQ(x)", "GF(9)"), ("GF(3)(t)", "GF(9)"),
     ("QQ(sqrt(2))", "QQ(sqrt(3))"), ("RR", "QQ")],
)  # fmt: skip
def test_rings_that_do_not_contain_the_other(source: str, target: str) -> None:
    F = ring(source)
    a = F("sqrt(2)") if source == "RR" else F.gen if F.gen_name else F(2)
    with pytest.raises(CoercionError) as info:
        QuaternionAlgebra(F, a, -1).change_ring(target)
    assert source in str(info.value)
    assert target in str(info.value)


# --- elements -------------------------------------------------------------------------------------


def test_polynomials_and_kinds_of_elements() -> None:
    A = algebra("(1,1|QQ)")
    e, i, j, k = A.basis
    q = A(1, 2, 0, 1)
    n, minus_t, one = q.characteristic_polynomial()
    assert q * q + minus_t * q + n == 0
    assert one == 1
    assert A(3).characteristic_polynomial() == (9, -6, 1)
    assert A(3).minimal_polynomial() == (-3, 1)
    assert (j + k).is_nilpotent()
    assert ((e + i) / 2).is_idempotent()
    assert not i.is_idempotent()
    assert i.order() == 2
    assert H(QQ)("1/2").order() is None
    assert (H(QQ)(1, 1, 1, 1) / 2).order() == 6
    assert A.random_element(5) == A.random_element(5)


def test_square_roots() -> None:
    A = H(QQ)
    roots = A.parse("2*i").square_roots()
    assert set(roots) == {A(1, 1, 0, 0), A(-1, -1, 0, 0)}
    assert len(roots) == 2
    whole = A(-1).square_roots()
    assert A(0, 0, "3/5", "4/5") in whole
    assert not whole.is_finite
    assert all(x * x == -1 for x in whole)
    with pytest.raises(OverflowError):
        len(whole)
    assert not A(2).square_roots()
    for text in ("(-1,-1|GF(3))", "[1,1|GF(2))", "[x,1|GF(4))", "(2,3|GF(5))"):
        B = algebra(text)
        for s in (0, 1, -1):
            found = list(B(s).square_roots())
            assert len(found) == len(set(found)) == B.count(square=s), (text, s)
            assert all(x * x == s for x in found)


def test_conjugators() -> None:
    A = H(QQ)
    p, q = A(0, 3, 0, 0), A(0, 1, 2, 2)
    x = p.conjugator(q)
    assert x * p * x.inverse() == q
    assert conjugator(p, q) == x
    assert p.conjugator(A(0, 1, 1, 0)) is None
    why = p.conjugacy(A(0, 1, 1, 0))
    assert not why
    assert "norms differ: 9 and 2" in why.reason
    with pytest.raises(MixedParentsError, match="one algebra"):
        p.conjugator(H("GF(5)").one)


def test_an_array_is_not_a_single_quaternion() -> None:
    q = H(GF(7))([1, 2], [0, 1], [0, 0], [0, 0])
    for question in ("is_unit", "order", "is_nilpotent", "square_roots", "minimal_polynomial"):
        with pytest.raises(CoercionError, match="single quaternion"):
            getattr(q, question)()


# --- counts and orders ----------------------------------------------------------------------------


def test_counts_are_asked_clearly() -> None:
    A = H("ZZ/4")
    assert A.count(norm=0) + A.count(norm=1) + A.count(norm=2) + A.count(norm=3) == A.count() == 256
    assert A.count("units") == sum(q.is_unit() for q in A.elements())
    B = H(GF(9))
    assert sum(B.count(norm=n) for n in GF(9).elements()) == 9**4
    with pytest.raises(CoercionError, match="no count"):
        B.count("zeros")
    with pytest.raises(CoercionError, match="one thing"):
        B.count("units", norm=0)
    with pytest.raises(CoercionError, match="say which norm"):
        B.count("norm")
    with pytest.raises(NotFiniteError):
        H(QQ).count(norm=0)


def test_orders() -> None:
    A = H(QQ)
    hurwitz, lipschitz = A.hurwitz_order(), A.lipschitz_order()
    assert (hurwitz.discriminant(), lipschitz.discriminant()) == (2, 4)
    assert hurwitz.is_maximal()
    assert not lipschitz.is_maximal()
    assert len(hurwitz.units()) == 24
    half = A(1, 1, 1, 1) / 2
    assert half in hurwitz
    assert half not in lipschitz
    assert hurwitz.coordinates(half) == (0, 0, 0, 1)
    a, b = A(3, 5, -1, 2), A(1, 2, 0, 1)
    q, r = hurwitz.quo_rem(a, b)
    assert q * b + r == a
    assert 2 * r.norm() <= b.norm()
    q, r = hurwitz.quo_rem(a, b, side="left")
    assert b * q + r == a
    g = hurwitz.gcd(a * b, A(2, 0, 1, 0) * b)
    assert hurwitz.quo_rem(a * b, g)[1] == 0
    with pytest.raises(CoercionError, match="side"):
        hurwitz.gcd(a, b, side="top")
    order = algebra("(-1,-11|QQ)").maximal_order()
    assert order.discriminant() == 11
    assert order != algebra("(-1,-11|QQ)").lipschitz_order()
    with pytest.raises(CoercionError, match=r"not to \(-1,-3"):
        algebra("(-1,-3|QQ)").hurwitz_order()
    with pytest.raises(RingError, match="over QQ"):
        H("GF(5)").maximal_order()


@subcases(
    "call",
    [
        lambda A, order: order.ternary_theta_series(10**30),
        lambda A, order: order.ternary_theta_series(10**12),
        lambda A, order: A.matrix(A(1)),
        lambda A, order: A.polynomials("x")(A(1)),
        lambda A, order: A.polynomials(None),
        lambda A, order: A.matrix([[1]]).solve(None),
        lambda A, order: A.tensor(None),
        lambda A, order: ring("QQ(sqrt(2))").ideal(A(1)),
        lambda A, order: QuaternionAlgebra.from_ramification("QQ", None),
        lambda A, order: len(A(1)),
        lambda A, order: A(1)[0],
    ],
)
def test_wrong_arguments_get_errors_of_ours(call) -> None:
    A = QuaternionAlgebra("QQ", -1, -11)
    with pytest.raises(HFieldError):
        call(A, A.maximal_order())
