"""The parent and the element: the API, its errors, and arrays of quaternions."""

import pickle
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from hfield import GF, QQ, RDF, ZZ, H, QuaternionAlgebra, Zmod, ring
from hfield.errors import CoercionError, MixedParentsError, NotationError, NotInvertibleError
from tests.subcases import subcases

TABLE = [
    ["e", "i", "j", "k"],
    ["i", "-e", "k", "-j"],
    ["j", "-k", "-e", "i"],
    ["k", "j", "-i", "-e"],
]


def test_table_1_1_falls_out_of_the_formula() -> None:
    A = H(QQ)
    named = dict(zip("eijk", A.basis, strict=True))
    table = A.multiplication_table()
    for row, texts in zip(table, TABLE, strict=True):
        for product, text in zip(row, texts, strict=True):
            assert product == (-named[text[1]] if text[0] == "-" else named[text])


def test_the_constants_of_the_general_algebra() -> None:
    A = QuaternionAlgebra(QQ, 5, 7, 3)
    _, i, j, k = A.basis
    assert i * i == 5 + 3 * i
    assert j * j == 7
    assert i * j == k
    assert j * i == 3 * j - k
    assert k * k == -35


def test_arithmetic_with_scalars() -> None:
    A = H(QQ)
    _, i, j, _ = A.basis
    q = A(1, 2, 0, 1)
    assert q + 1 == A(2, 2, 0, 1) == 1 + q
    assert 1 - q == A(0, -2, 0, -1)
    assert q * Fraction(1, 2) == Fraction(1, 2) * q == q / 2 == A("1/2 + i + 1/2*k")
    assert 6 / q == q.conjugate()
    assert q**0 == 1
    assert q**3 == q * q * q
    assert q**-2 == (q * q).inverse()
    assert q * QQ("1/3") == A("1/3", "2/3", 0, "1/3")
    assert (i * j).coordinates == (0, 0, 0, 1)
    assert q != 1
    assert q != "q"


def test_parts_and_polynomials() -> None:
    q = H(QQ)(1, 2, 0, 1)
    assert q.scalar_part == 1
    assert q.vector_part == q.algebra(0, 2, 0, 1)
    assert q.minimal_polynomial() == (6, -2, 1)
    assert q.algebra(5).minimal_polynomial() == (-5, 1)
    assert q * q - q.trace() * q + q.norm() == 0


def test_immutable_hashable_picklable() -> None:
    q = H(GF(9))(1, "x", 0, 2)
    with pytest.raises(AttributeError, match="immutable"):
        q.coordinates = (0, 0, 0, 0)  # type: ignore[misc]
    assert len({q, q.algebra(1, "x", 0, 2), q + 1}) == 2
    assert pickle.loads(pickle.dumps(q)) == q
    assert pickle.loads(pickle.dumps(q.algebra)) == q.algebra


def test_what_older_pickles_name_is_there() -> None:
    """Pickles of version 0.2, spelt out: the text names a function or a class, then come its arguments."""
    A = H("GF(7)")
    q = A([1, 2], 0, 0, [3, 4])
    for path, name, arguments in (
        ("hfield.quaternion", "Quaternion", (A, q.coordinates)),
        ("hfield.element_text", "_from_array", (A, q.to_array())),
        (
            "hfield.element_text",
            "_from_states",
            (type(q), A, (2,), ([1, 2], [0, 0], [0, 0], [3, 4])),
        ),
    ):
        make = pickle.loads(f"c{path}\n{name}\n.".encode())
        assert (make(*arguments) == q).all()


def test_text_reads_back() -> None:
    for name in ("QQ", "GF(9)", "QQ(sqrt(2))", "GF(2)(t)", "ZZ[a,b,c]", "RR"):
        A = QuaternionAlgebra(ring(name), -1, -1)
        for seed in range(20):
            q = A.random_element(seed)
            assert A.parse(str(q)) == q
        assert QuaternionAlgebra.from_text(str(A)) == A


@pytest.mark.parametrize(
    "text", ["(-1,-3|QQ)", "[1,x|GF(4))", "(0,1|GF(3))", "[1,2,3|QQ)", "H(RR)"]
)
def test_algebra_text(text: str) -> None:
    A = QuaternionAlgebra.from_text(text)
    assert QuaternionAlgebra.from_text(str(A)) == A


@pytest.mark.parametrize(
    "text", ["", "(1|QQ)", "(1,2,3|QQ)", "(1,2|", "[1,2|QQ]", "(1,2|FOO)", "(x,1|QQ)"]
)
def test_bad_algebra_text(text: str) -> None:
    with pytest.raises(ValueError, match=r"."):
        QuaternionAlgebra.from_text(text)


def test_parents_never_mix() -> None:
    p, q = H(GF(3)).one, H(GF(5)).one
    with pytest.raises(MixedParentsError, match=r"\(-1,-1\|GF\(3\)\).*\(-1,-1\|GF\(5\)\)"):
        p + q
    with pytest.raises(MixedParentsError, match="change_ring"):
        H(QQ)(p)
    assert p != q
    assert H(ZZ)(1, 2, 3, 4).change_ring(GF(3)) == H(GF(3))(1, 2, 0, 1)


@pytest.mark.parametrize("bad", [None, object(), 1.5, [1, 2], {}])
def test_what_is_no_coordinate(bad: Any) -> None:
    with pytest.raises(CoercionError):
        H(QQ)(bad, 0, 0, None)
    with pytest.raises(CoercionError):
        H(QQ)(1, 2)


def test_division_by_a_zero_divisor_shows_why() -> None:
    A = H(GF(5))
    q = A(1, 2, 0, 0)
    with pytest.raises(NotInvertibleError, match=r"norm is 0, and q·y = 0 for y"):
        q.inverse()
    y = q.annihilator()
    assert y is not None
    assert q * y == 0
    assert y != 0
    with pytest.raises(ZeroDivisionError, match="cannot invert 0"):
        1 / A.zero


@pytest.mark.parametrize("name", ["ZZ/4", "ZZ/6", "GF(2)", "GF(3)"])
def test_zero_divisors_exhaustively(name: str) -> None:
    """q is a zero divisor exactly when q·y = 0 for some y ≠ 0, else it is a unit (finite rings)."""
    for a, b, t in [(-1, -1, 0), (0, 1, 0), (0, 0, 0), (1, 1, 1)]:
        A = QuaternionAlgebra(ring(name), a, b, t)
        for q in list(A.elements())[:: 7 if name == "ZZ/6" else 1]:
            y = q.annihilator()
            assert q.is_zero_divisor() == (y is not None)
            if y is None:
                assert q * q.inverse() == 1 == q.inverse() * q
            else:
                assert not y.is_zero()
                assert (q * y).is_zero()


def test_arrays() -> None:
    A = H(GF(9))
    p = A(np.arange(9), 1, [0] * 9, ["x"] * 9)
    assert p.shape == (9,) == (p * p).shape
    assert len(p) == 9
    assert p[3] == A(0, 1, 0, "x")  # an int enters as a multiple of 1, here 3 = 0
    assert (p + 1)[1] == p[1] + 1
    assert (p * A.basis[1])[2] == p[2] * A.basis[1]
    assert (A.basis[1] * p)[2] == A.basis[1] * p[2]
    assert ((p == p) == np.ones(9, dtype=bool)).all()
    assert (p**0 == 1).all()
    assert (p**3 == p * p * p).all()
    assert list(p)[4] == p[4]
    assert p[2:5].shape == (3,)
    with pytest.raises(TypeError, match="cannot be hashed"):
        hash(p)
    with pytest.raises(CoercionError, match="shapes"):
        A([1, 2], [1, 2, 3], 0, 0)


def test_arrays_invert_where_all_are_units() -> None:
    A = H(GF(7))
    p = A([1, 2, 3], [0, 1, 1], [0, 0, 1], 0)
    assert (p * p.inverse() == 1).all()
    with pytest.raises(NotInvertibleError, match=r"index \(1,\)"):
        A([1, 0], [0, 0], 0, 0).inverse()


def test_a_numpy_array_times_a_quaternion_is_elementwise() -> None:
    A = H(QQ)
    q = np.array([1, 2, 3]) * A.basis[1]
    assert q.shape == (3,)
    assert q[2] == 3 * A.basis[1]


def test_floats() -> None:
    A = H(RDF)
    q = A(0.5, 0.5, 0.5, 0.5)
    assert q.norm() == 1.0
    p = A(np.ones(4), np.zeros(4), np.arange(4.0), 0)
    assert (p * p.inverse() == 1).all() or np.allclose((p * p.inverse()).coordinates[0], 1)
    for bad in (float("nan"), float("inf")):
        with pytest.raises(CoercionError, match=r"finite|NaN|nan|inf"):
            A(bad, 0, 0, 0)
        with pytest.raises(CoercionError):
            A(np.array([1.0, bad]), 0, 0, 0)


@subcases(
    ("text", "value"),
    [
        ("(1+i)*(j-k)**-1", "1/2*j*2/1 - j + j"),
        ("norm(1+2*i)", "5"),
        ("trace(3+i)", "6"),
        ("conj(i+1)", "1-i"),
        ("comm(i,j)", "2*k"),
        ("inv(2*i)", "-1/2*i"),
        ("vector(1+i) + scalar(2+j)", "2+i"),
        ("(1+2*i+3*j+4*k)[2]", "3"),
        ("i^2", "-1"),
        ("2/3 - 0.5*j", "2/3 - 1/2*j"),
    ],
)
def test_expressions(text: str, value: str) -> None:
    A = H(QQ)
    if text.startswith("(1+i)*"):
        assert A.parse(text) == A(1, 1, 0, 0) * A(0, 0, 1, -1).inverse()
    else:
        assert A.parse(text) == A.parse(value)


@subcases(
    "text",
    [
        "",
        "1+",
        "(1",
        "1)",
        "q",
        "f(1)",
        "__import__('os')",
        "i**j",
        "i**(10**12)",
        "1 == 1",
        "exists",
    ],
)
def test_unreadable_expressions(text: str) -> None:
    with pytest.raises(NotationError):
        H(QQ).parse(text)


def test_too_large_expressions_are_refused_at_once() -> None:
    for text in ("(1+i)**1000000000000", "((1+i)**1000)**1000", "(" * 5000 + "1" + ")" * 5000):
        with pytest.raises(ValueError, match=r"too large|deeper"):
            H(QQ).parse(text)


def test_zmod_and_the_centre() -> None:
    assert H(Zmod(6)).is_commutative() is False
    assert H(GF(2)).is_commutative() is True
    assert [q.coordinates for q in H(QQ).center()] == [(1, 0, 0, 0)]
    assert len(H(GF(4)).center()) == 4
