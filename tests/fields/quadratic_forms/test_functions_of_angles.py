"""Modulus, polar form, logarithm and powers over functions of angles, and circles over RR."""

import pickle
from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import Any

import pytest
import sympy

from hfield import CoercionError, H, NoSolutionError, NotationError, check, prove, ring, to_sympy
from hfield.errors import TooLargeError, UndecidedError
from tests.subcases import slow

t, u = sympy.symbols("t u")
F, G = ring("QQ(cos(t),sin(t))"), ring("QQ(cos(t),sin(t),cos(u),sin(u))")
HALF, R = ring("QQ(cos(t/2),sin(t/2))"), ring("RR(cos(t),sin(t))")
K = ring("QQ(sqrt(3))(cos(t),sin(t))")


@pytest.mark.parametrize("field", [F, K, R, HALF])
@pytest.mark.parametrize("multiple", [1, 2, -3])
def test_polar_forms_come_back(field: Any, multiple: int) -> None:
    """The angle is that in [0, π] for small positive t; the axis has the sign of the given one."""
    A = H(field)
    n, r = A("(3*i + 4*j)/5"), field(2)
    angle = field.angle("t") * multiple
    q = A.from_polar(r, n, angle)
    found = q.polar()
    assert found.modulus == r
    assert found.angle == field.angle("t") * abs(multiple)
    assert found.axis == (n if multiple > 0 else -n)
    assert A.from_polar(*found) == q
    assert q.unit().log() == n * angle
    assert (n * angle).exp() * r == q


def test_shifted_and_several_angles() -> None:
    for field in (K, R):
        q = H(field)("cos(2*t + pi/3) + sin(2*t + pi/3)*j")
        assert q.polar().angle == "2*t + pi/3"
    assert H(G)("cos(t - 2*u) + sin(t - 2*u)*k").polar().angle == "t - 2*u"
    assert H(F)(-2).polar()[::2] == (F(2), F.angle("pi"))
    assert H(F)("k").polar().angle == "pi/2"
    assert H(HALF)("1 + cos(t) + sin(t)*k").polar()[::2] == (HALF("2*cos(t/2)"), HALF.angle("t/2"))


@pytest.mark.parametrize(
    ("text", "angle"),
    [
        ("-cos(t) - sin(t)*k", "pi - t"),
        ("-cos(t) + sin(t)*k", "pi - t"),
        ("cos(t) - sin(t)*(3*i + 4*j)/5", "t"),
    ],
)
def test_powers_and_roots_are_principal_for_small_angles(text: str, angle: str) -> None:
    q = H(HALF)(text)
    assert q.polar().angle == angle
    assert q ** Fraction(1, 2) == q.sqrt() == (q.log() / 2).exp()


def test_the_modulus_is_positive_for_small_angles() -> None:
    """So is cos(t); the norm of the other factors decides nothing."""
    for text in ("cos(t)", "sin(t)", "1 - cos(t)", "2*sin(t) - cos(t)^2"):
        q = H(F)(text)
        small = float(sympy.sympify(text.replace("^", "**")).subs({t: 1e-3}))
        assert abs(q) == (q.scalar_part if small > 0 else -q.scalar_part)
    assert abs(H(K)("1 - sqrt(3)*cos(t)")) == K("sqrt(3)*cos(t) - 1")
    assert abs(H(R)("sqrt(2) - sqrt(3) + sin(t)")) == R("sqrt(3) - sqrt(2) - sin(t)")
    assert abs(H(G)("sin(t) - sin(u)")) == G("sin(t) - sin(u)")  # u is the smaller


def test_powers_are_de_moivres() -> None:
    A = H(HALF)
    q = A("cos(t) + sin(t)*k")
    assert q ** Fraction(1, 2) == q**0.5 == q.sqrt() == A("cos(t/2) + sin(t/2)*k")
    assert q ** Fraction(-3, 2) == A("cos(3*t/2) - sin(3*t/2)*k")
    assert (4 * q) ** 0.5 == 2 * q.sqrt()
    for n in range(-3, 4):
        assert H(F)("cos(t) + sin(t)*k") ** n == H(F)(f"cos({n}*t) + sin({n}*t)*k")
    assert H("QQ(cos(t/3),sin(t/3))")("cos(t) + sin(t)*i") ** Fraction(1, 3) == H(
        "QQ(cos(t/3),sin(t/3))"
    )("cos(t/3) + sin(t/3)*i")


@pytest.mark.parametrize(
    ("call", "error", "text"),
    [
        (lambda: H(F)("cos(t) + sin(t)*k") ** Fraction(1, 3), CoercionError, "1/3"),
        (lambda: H(F)("1 + cos(t)*k").polar(), NoSolutionError, "cos"),
        (lambda: H(F)("(3 + 4*k)/5").polar(), CoercionError, "rational multiples"),
        (lambda: H(F)("cos(t) + i").exp(), CoercionError, "exponential"),
        (lambda: H(F)(2).log(), CoercionError, "log"),
        (lambda: H(F)(0).polar(), NoSolutionError, "norm 0"),
        (lambda: H(F)("i + j") * F.angle("t"), CoercionError, "square of the axis"),
        (lambda: (2 * H(F)("cos(t) + sin(t)*k")) ** Fraction(1, 2), NoSolutionError, "2"),
        (lambda: F.angle("t*t"), CoercionError, "angle"),
        (lambda: R("pi"), NotationError, "pi"),
        (lambda: R("exp(1)"), CoercionError, "algebraic"),
        (lambda: R("root(2,3) + root(3,3) + root(5,3)"), TooLargeError, "degree 27"),
    ],
)
def test_what_does_not_lie_there(call: Callable[[], object], error: Any, text: str) -> None:
    with pytest.raises(error, match=text):
        call()


def test_angles_are_values() -> None:
    a = F.angle("2*t + pi/3")
    assert a - a == 0
    assert a / 2 * 2 == a == sympy.sympify("2*t + pi/3")
    assert hash(F.angle("t") + F.angle("t")) == hash(F.angle("2*t"))
    assert str(a) == "2*t+1/3*pi"
    assert sympy.sympify(a) == 2 * t + sympy.pi / 3
    assert F.angle(a) == a != F.angle("t")
    n = H(F).k
    assert n * a == -n * -a
    assert n * a != H(F).j * a
    assert (2 * (n * F.angle("t"))).exp() == (n * F.angle("2*t")).exp()
    assert pickle.loads(pickle.dumps(a)) == a


# --- circles over RR ----------------------------------------------------------------------------------


def test_real_coefficients_against_numbers() -> None:
    """Sums, products and quotients have the values of sympy's at a point, and come back from sympy."""
    rng, point = Random(3), {t: 0.7}
    numbers = [
        ["sqrt(2)", "sqrt(3)*sin(t)", "sqrt(6)*sin(t) + 1"],
        ["root(2,3)*cos(t)", "1 + cos(t)"],
    ]
    for n in range(6):
        parts = numbers[n % 2]
        x, y, z = (R(rng.choice(parts)) + R(rng.choice(parts)) for _ in range(3))
        f, g, h = (complex(to_sympy(w).subs(point).evalf()) for w in (x, y, z))
        for found, value in ((x * y - z, f * g - h), (x / y, f / g), (x + y * z, f + g * h)):
            assert abs(complex(to_sympy(found).subs(point).evalf()) - value) < 1e-9
        back = R(to_sympy(x / y))
        assert back == x / y
        assert hash(back) == hash(x / y)
        assert R(R.text(x / y)) == x / y


def test_real_circles_decide_equality() -> None:
    assert R("sqrt(2)*sqrt(3)*cos(t)") == R("sqrt(6)*cos(t)")
    assert hash(R("sqrt(2)*sqrt(3)*cos(t)")) == hash(R("sqrt(6)*cos(t)"))
    assert R("cos(t + pi/12)") == R("cos(t)*(sqrt(6) + sqrt(2))/4 - sin(t)*(sqrt(6) - sqrt(2))/4")
    assert R("cos(t)*cos(pi/7) - sin(t)*sin(pi/7)") == R("cos(t + pi/7)")
    assert R("sqrt(2)*cos(t)") != R("sqrt(3)*cos(t)")
    assert R("(sqrt(2) - 1)*(sqrt(2) + 1)*sin(t)") == R("sin(t)")


def test_values_and_derivatives_over_rr() -> None:
    A = H(R)
    q = A("sqrt(2)*cos(t) + sin(t)*k/(cos(t) - sqrt(3))")
    assert q.diff("t") == A(
        sympy.diff(to_sympy(q.coordinates[0]), t), 0, 0, sympy.diff(to_sympy(q.coordinates[3]), t)
    )
    assert q.subs(t="pi/6").algebra == H("RR")
    assert A("sqrt(2)*cos(t)").subs(t="pi/4") == H("RR")(1)
    assert A("sqrt(2)*cos(t)").subs(t="2*t") == A("sqrt(2)*cos(2*t)")
    assert pickle.loads(pickle.dumps(q)) == q
    assert H(F)("cos(t) + sin(t)*k").change_ring(R) == A("cos(t) + sin(t)*k")
    assert H(K)("sqrt(3)*cos(t)").change_ring(R) == A("sqrt(3)*cos(t)")
    p = A.unknowns("p")
    assert (A("sqrt(2)*k") * p).norm() == 2 * p.norm()


def test_square_roots_over_number_fields_and_rr() -> None:
    """Of squares in one variable; products of two different functions have none."""
    for field in (K, R):
        for text in ("sqrt(3)*cos(t) - 1", "1/(sin(t) + sqrt(3))", "cos(t + pi/3)"):
            x = field(text)
            root = field.sqrt(x * x)
            assert root in (x, -x)
            assert field.sqrt(x * x * field("1 + cos(t)^2")) is None
    assert R.sqrt(R("2")) == R("sqrt(2)")
    assert R.sqrt(R("-2")) is None
    assert K.sqrt(K("2*cos(t)^2")) is None
    several = ring("RR(cos(t),sin(t),cos(u),sin(u))")
    assert several.sqrt(several("2*cos(u)^2*sin(t)^2")) in (
        several("sqrt(2)*cos(u)*sin(t)"),
        several("-sqrt(2)*cos(u)*sin(t)"),
    )
    with pytest.raises(UndecidedError):
        several.sqrt(several("(cos(t) + sqrt(2)*sin(u))^2"))


# --- thesis 1.3.1 and 1.4.4 by the prover -------------------------------------------------------------

AXIS = "(cos(u)*i + sin(u)*j)"  # of length 1, in any direction of the plane of i and j


@pytest.mark.parametrize(
    ("statement", "field", "verdict"),
    [
        (f"{AXIS}^2 == -1", G, "proved"),
        (f"norm(cos(t) + sin(t)*{AXIS}) == 1", G, "proved"),
        (f"(cos(t) + sin(t)*{AXIS})^3 == cos(3*t) + sin(3*t)*{AXIS}", G, "proved"),
        slow(f"inv(cos(t) + sin(t)*{AXIS}) == cos(t) - sin(t)*{AXIS}", G, "proved"),
        (f"(cos(t) + sin(t)*{AXIS})^2 == cos(t) + sin(2*t)*{AXIS}", G, "refuted"),
        ("(cos(t) + sin(t)*k)*(cos(u) + sin(u)*k) == cos(t+u) + sin(t+u)*k", G, "proved"),
        ("norm((cos(t) + sin(t)*k)*p) == norm(p)", F, "proved"),
        ("abs(p*q) == abs(p)*abs(q)", "RR", "proved"),
    ],
)  # fmt: skip
def test_polar_identities(statement: str, field: Any, verdict: str) -> None:
    answer = prove(statement, field=field)
    assert answer.verdict == verdict
    assert answer.certificate is not None
    assert check(answer.certificate).verdict == verdict


def test_the_prover_takes_circles_over_rr() -> None:
    assert prove("(cos(t) + sin(t)*k)^4 == cos(4*t) + sin(4*t)*k", field=R).verdict == "proved"
    assert prove("cos(t + pi/3) == cos(t)/2 - sqrt(3)/2*sin(t)", field=R).verdict == "proved"
    assert prove("cos(t)*i == sqrt(2)*i", field=R).verdict == "refuted"
