"""Into rings and algebras from sympy, galois and numpy, and out to sympy, over every kind of ring."""

import pickle
import subprocess
import sys
from decimal import Decimal
from random import Random

import galois
import numpy as np
import pytest
import sympy

from hfield import (
    CoercionError,
    H,
    QuaternionAlgebra,
    Ring,
    RingError,
    explain,
    info,
    prove,
    ring,
    to_sympy,
    verify,
)
from tests.conformance import RINGS
from tests.galois_classes import galois_class
from tests.subcases import slow
from tests.thorough import quick_part

LOCAL = ("Qp", "_(", "((", "_inf")  # sympy has no local fields
EXPRESSED = [name for name in RINGS if not any(part in name for part in LOCAL)]
SLOW = {
    *("QQ(zeta5)(x,y)", "QQ(zeta5)", "QQ(zeta7)+", "QQ(root(2,3),zeta3)"),
    *("QQ(sqrt(2),I)[x,y]", "QQ(sqrt(2),sqrt(3))"),
}
a, b, c, d, t, x, y = sympy.symbols("a b c d t x y")


@pytest.mark.parametrize("name", [slow(name) if name in SLOW else name for name in EXPRESSED])
def test_elements_come_back(name: str) -> None:
    R, rng = ring(name), Random(7)
    for A in (H(R), QuaternionAlgebra(R, 1, -1, 1)):
        for _ in quick_part(range(3), 3):
            q = A(*(R.random(rng) for _ in range(4)))
            assert A(to_sympy(q)) == q
            assert A.matrix(to_sympy(A.matrix([[q, 1]]))) == A.matrix([[q, 1]])
            assert A(tuple(map(to_sympy, map(R, q.coordinates)))) == q or not R.is_exact
    assert R.is_exact or to_sympy(0.5) == sympy.Float(0.5)


@pytest.mark.parametrize("name", ["Qp(5)", "GF(9)((t))", "QQ(I)_(5, I-2)"])
def test_local_fields_are_refused(name: str) -> None:
    with pytest.raises(CoercionError, match="sympy has no"):
        to_sympy(H(name)(1))


DOMAINS: list[tuple[object, str]] = [
    (sympy.ZZ, "ZZ"),
    (sympy.QQ, "QQ"),
    (sympy.GF(7), "GF(7)"),
    (sympy.ZZ[x, y], "ZZ[x,y]"),
    (sympy.QQ[x, y], "QQ[x,y]"),
    (sympy.GF(5)[x], "GF(5)[x]"),
    (sympy.QQ.frac_field(x), "QQ(x)"),
    (sympy.ZZ.frac_field(x, y), "QQ(x,y)"),
    (sympy.GF(5).frac_field(x), "GF(5)(x)"),
    (sympy.QQ.frac_field(sympy.Symbol("pi")), "Frac(QQ[pi])"),
    (sympy.QQ.algebraic_field(sympy.sqrt(2)), "QQ(sqrt(2))"),
    (sympy.QQ.algebraic_field(sympy.sqrt(2), sympy.sqrt(3)), "QQ(sqrt(2),sqrt(3))"),
    (sympy.QQ.algebraic_field(sympy.cbrt(2)), "QQ(root(2,3))"),
    (sympy.QQ.algebraic_field(sympy.CRootOf(x**3 - x - 1, 0)), "QQ[s]/(s^3-s-1)"),
    (sympy.QQ.cyclotomic_field(5), "QQ(zeta5)"),
    (sympy.QQ_I, "QQ(I)"),
]


@pytest.mark.parametrize(("domain", "name"), DOMAINS, ids=lambda x: str(x)[:30])
def test_domains_are_names_of_rings(domain: object, name: str) -> None:
    is_name_of(domain, name)


@pytest.mark.parametrize(
    ("q", "modulus", "name"),
    [(7, None, "GF(7)"), (9, None, "GF(9)"), slow(9, "x^2+1", "GF(9, x^2+1)")],
)
def test_fields_of_galois_are_names_of_rings(q: int, modulus: str | None, name: str) -> None:
    is_name_of(galois_class(q, irreducible_poly=modulus), name)


def is_name_of(domain: object, name: str) -> None:
    assert ring(domain) == H(domain).ring == ring(name)
    assert QuaternionAlgebra(domain, -1, -3) == QuaternionAlgebra(name, -1, -3)
    q = H("ZZ")(1, 2, 3, 4)
    assert q.change_ring(domain) == H(name)(1, 2, 3, 4)


def test_domains_that_mean_something_else() -> None:
    with pytest.raises(RingError, match=r"'ZZ/9' .*'GF\(9\)'"):
        ring(sympy.GF(9))
    for domain in (sympy.RR, sympy.CC):
        with pytest.raises(RingError, match="RDF"):
            ring(domain)
    with pytest.raises(RingError, match="no counterpart"):
        ring(sympy.EX)
    with pytest.raises(RingError, match="not the name of a ring"):
        ring(sympy.Symbol("x"))


def test_the_prover_takes_domains() -> None:
    assert prove("norm(p*q) == norm(p)*norm(q)", field=sympy.GF(7)).verdict == "proved"
    assert prove("p*q == q*p", field=galois.GF(9)).verdict == "refuted"
    assert explain("centre", galois.GF(9)).row.field == "GF(9)"
    assert [row.field for row in verify("centre", field=[sympy.GF(7), "QQ"]).rows] == [
        "GF(7)",
        "QQ",
    ]
    assert info(sympy.QQ).division


def test_elements_of_domains() -> None:
    R = sympy.QQ[x, y]
    f = R.from_sympy(x**2 * y - sympy.Rational(1, 2))
    assert ring("QQ[x,y]")(f) == ring("QQ[x,y]")("x^2*y-1/2")
    K = sympy.QQ.frac_field(x)
    assert ring("QQ(x)")(K.from_sympy(1 / (x - 1))) == ring("QQ(x)")("1/(x-1)")
    assert ring("QQ(x)")(sympy.Poly(x**3 + 2, x)) == ring("QQ(x)")("x^3+2")
    L = sympy.QQ.algebraic_field(sympy.sqrt(2))
    assert ring("QQ(sqrt(2))")(L.from_sympy(3 - sympy.sqrt(2))) == ring("QQ(sqrt(2))")("3-sqrt(2)")
    L = sympy.QQ.algebraic_field(sympy.cbrt(2))
    assert ring(L)(L.from_sympy(sympy.cbrt(2) + 1)) == ring(L)("1+root(2,3)")
    with pytest.raises(CoercionError, match="which number"):
        ring("QQ(sqrt(2))")(L.unit)
    assert ring("QQ(I)")(sympy.QQ_I(1, 2)) == ring("QQ(I)")("1+2*I")
    with pytest.raises(CoercionError, match="modulo 5"):
        ring("QQ(x)")(sympy.Poly(x + 1, x, modulus=5))


@pytest.mark.parametrize(
    ("name", "number", "text"),
    [
        ("QQ(zeta5)", sympy.exp(2 * sympy.pi * sympy.I * 3 / 5), "zeta5^3"),
        ("QQ(zeta5)", sympy.cos(sympy.pi / 5), "-1/2*zeta5^2-1/2*zeta5^3"),
        ("QQ(zeta7)+", sympy.cos(4 * sympy.pi / 7), "c7^2/2-1"),
        ("QQ(sqrt(2),I)", sympy.exp(sympy.I * sympy.pi / 4), "(1+I)*sqrt(2)/2"),
        ("QQ(sqrt(2),I)", sympy.exp(-sympy.I * sympy.pi / 4), "(1-I)*sqrt(2)/2"),
        ("QQ(sqrt(-3))", sympy.exp(sympy.I * sympy.pi / 3), "1/2+sqrt(-3)/2"),
        ("QQ(sqrt(5))", sympy.GoldenRatio, "(1+sqrt(5))/2"),
        ("QQ(root(2,3))", sympy.real_root(2, 3), "root(2,3)"),
        ("RR", sympy.sqrt(2 + sympy.sqrt(2)), "sqrt(2+sqrt(2))"),
        ("CC", sympy.exp(sympy.I * sympy.pi / 3), "1/2+sqrt(-3)/2"),
        ("RDF", sympy.pi, "3.141592653589793"),
        ("QQ", sympy.Rational(2, 4), "1/2"),
        ("GF(7)", sympy.Rational(1, 2), "4"),
    ],
)
def test_numbers(name: str, number: sympy.Expr, text: str) -> None:
    R = ring(name)
    try:
        expected = R(text)
    except Exception:  # c7 is no name in texts
        expected = R.gen * R.gen / 2 - 1
    assert R.equal(R(number), expected)


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("QQ", sympy.sqrt(2), "CC has"),
        ("QQ", sympy.Float(0.5), "a float is not exact"),
        ("QQ", sympy.oo, "not a number"),
        ("QQ", sympy.true, "not an element"),
        ("QQ", x, "no generators"),
        ("QQ(x)", x * y, "the generators are x"),
        ("QQ(x)", sympy.sqrt(x), "no such function"),
        ("RR", sympy.Symbol("pi"), "no generators"),
        ("QQ(I)", sympy.Symbol("I"), "no generators"),
        ("GF(7)", sympy.I, "only rational"),
        ("ZZ[x]", x / 2, "QQ"),
        ("QQ", sympy.Quaternion(1, 2, 3, 4), "not an element"),
        ("QQ(x)", x + sympy.Symbol("x", real=True), "two different symbols"),
    ],
)
def test_what_is_refused(name: str, value: object, says: str) -> None:
    with pytest.raises(CoercionError, match=says):
        ring(name)(value)


def test_symbols_are_read_by_their_names() -> None:
    A = H("QQ(a,b,c,d)")
    q = A(a, b, c, d)
    real = sympy.Symbol("a", real=True)
    assert A(real, b, c, d) == q == A("a + b*i + c*j + d*k")
    assert to_sympy(q, symbols=[real]).free_symbols == {real, b, c, d}
    assert A(to_sympy(q, symbols=[real])) == q
    with pytest.raises(CoercionError, match="two different symbols are called a"):
        A(real, a, 0, 0)
    with pytest.raises(CoercionError, match="two different symbols are called a"):
        A([real, 1], [1, a], 0, 0)


def test_sympy_and_elements_in_one_expression() -> None:
    A = H("QQ(a,b,c,d)")
    q = A(a, b, c, d)
    assert a * q == q * a == A(a) * q
    assert a + q == q + a == A(2 * a, b, c, d)
    assert a - q == -(q - a)
    assert q / a == q * (1 / a) == q * A(1 / a)
    assert sympy.Rational(1, 2) * q == q / 2


def test_arrays() -> None:
    A = H("QQ(a,b)")
    values = np.array([[a, b], [a * b, 1]], dtype=object)
    q = A(values, 0, 1, 0)
    assert q.shape == (2, 2)
    assert q[1, 0] == A(a * b, 0, 1, 0)
    assert (A([a, b], 0, 0, 0)[1], A(sympy.Matrix([a, b]), 0, 0, 0).shape) == (A(b), (2, 1))
    for name in ("QQ", "ZZ", "GF(7)", "GF(9)", "RR", "RDF", "ZZ/6"):
        assert H(name)([sympy.Integer(3), sympy.Rational(4, 2)], 1, 0, 0)[1] == H(name)(2, 1, 0, 0)


def test_quaternions_of_sympy() -> None:
    A = H("QQ(a,b)")
    assert A(sympy.Quaternion(a, 1, b, 0)) == A(a, 1, b, 0)
    with pytest.raises(CoercionError, match="i² = j² = −1"):
        QuaternionAlgebra("QQ", -1, -3)(sympy.Quaternion(1, 2, 3, 4))
    assert not to_sympy(H("CC")(1)).real_field
    assert to_sympy(H("QQ")(1)).real_field


def test_the_product_is_that_of_sympy() -> None:
    A = H("QQ(a,b,c,d)")
    p, q = A(a, b, c, d), A(b, 1, a * d, c)
    ours, theirs = to_sympy(p * q), to_sympy(p) * to_sympy(q)
    assert all(sympy.expand(u - v) == 0 for u, v in zip(ours.args, theirs.args, strict=True))


def test_exact_numbers() -> None:
    A = H("QQ")
    assert A(Decimal("0.1"), np.int64(3), np.uint8(2), np.array(5)) == A("1/10", 3, 2, 5)
    for value in (Decimal("NaN"), Decimal("Infinity")):
        with pytest.raises(CoercionError):
            A(value)


def test_tuples_tables_and_matrices() -> None:
    A = H("QQ(a)")
    q = A("a + i")
    assert to_sympy(q.matrix())[1, 0] == 1
    assert to_sympy((q.norm(), q)) == (a**2 + 1, to_sympy(q))
    assert to_sympy(A.multiplication_table())[1, 2] == sympy.Quaternion(0, 0, 0, 1)
    X = sympy.Symbol("X")
    assert to_sympy(q.minimal_polynomial()) - (X**2 - 2 * a * X + a**2 + 1) == 0
    for B in (A, QuaternionAlgebra("QQ(a)", "a", 3)):
        P = B.polynomials("x")
        f = P("x^2 + a*i*x + j/a")
        assert P(to_sympy(f)) == f
        with pytest.raises(CoercionError, match="not a polynomial"):
            P(1 / x)


def test_printers() -> None:
    A = H("QQ(a,b)")
    q = A(a, 0, 1 / b, 0)
    assert sympy.latex(q) == q.text("latex")
    assert sympy.latex([q]) == rf"\left[ {q.text('latex')}\right]"
    assert sympy.sstr(q) == sympy.srepr(q) == str(q)
    assert sympy.pretty(q) == repr(q)
    assert sympy.sympify(q) == to_sympy(q)
    assert sympy.latex(A([a, b], 0, 0, 0)) == r"\left[ a, \ b\right]"
    assert sympy.latex(A.matrix([[q]])) == A.matrix([[q]]).text("latex")
    for thing in (
        H("QQ").maximal_order(),
        A,
        A.polynomials("x")([q]),
        q.norm(),
        ring("QQ(sqrt(2))").gen,
    ):
        assert sympy.latex(thing)
        assert sympy.sstr(thing) == str(thing)
        assert sympy.pretty(thing)


@pytest.mark.slow
def test_sympy_is_imported_when_its_objects_are_met() -> None:
    script = (
        "import sys; from hfield import H, ring; A = H('QQ(x,y)'); A('x+i').subs(x=1, y=2); A('x').diff('x');"
        "H('QQ').unknowns('p q'); A('x + i').rotation_matrix(); print('sympy' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "False"


def test_rings_without_expressions_of_their_own() -> None:
    class Own(Ring[int]):
        name, characteristic = "own", 0

        def __call__(self, x: object) -> int:
            if not isinstance(x, int):
                raise self.refuse(x)
            return x

    with pytest.raises(CoercionError, match="sympy has no"):
        to_sympy(QuaternionAlgebra(Own(), -1, -1)(1))


def test_unknowns_pickle() -> None:
    p = H("QQ").unknowns("p")
    assert pickle.loads(pickle.dumps(p)) * H("QQ")("i") == p * H("QQ")("i")
