"""Functions on circles: identities against trigsimp, values and derivatives against sympy, the prover."""

from random import Random
from typing import Any

import pytest
import sympy

from hfield import CoercionError, H, NotInvertibleError, RingError, check, prove, ring, to_sympy
from rotation import Rotation, RotationError, from_exact
from tests.subcases import first_quick

t, u, x = sympy.symbols("t u x")
F, G = ring("QQ(cos(t),sin(t))"), ring("QQ(cos(t),sin(t),cos(u),sin(u))")


@pytest.mark.parametrize(
    ("name", "canonical"),
    [
        ("QQ(cos(t),sin(t))", "QQ(cos(t),sin(t))"),
        ("QQ( sin(t), cos(t) )", "QQ(cos(t),sin(t))"),
        ("QQ(cos(t/2),sin(t/2))", "QQ(cos(t/2),sin(t/2))"),
        ("QQ(cos(t),sin(t),x)", "QQ(x,cos(t),sin(t))"),
        ("QQ(sqrt(3))(cos(t),sin(t))", "QQ(sqrt(3))(cos(t),sin(t))"),
        ("GF(7)(cos(t),sin(t))", "GF(7)(cos(t),sin(t))"),
    ],
)
def test_names(name: str, canonical: str) -> None:
    assert ring(name).name == canonical
    assert ring(canonical) is ring(name)


@pytest.mark.parametrize(
    "name",
    ["QQ(cos(t))", "QQ(cos(2*t),sin(2*t))", "QQ(cos(pi),sin(pi))", "GF(2)(cos(t),sin(t))",
     "QQ(cos(t),sin(t),t)", "QQ(cos(t+u),sin(t+u))", "QQ(cos(i),sin(i))", "CC(cos(t),sin(t))"],
)  # fmt: skip
def test_what_is_no_circle(name: str) -> None:
    with pytest.raises(RingError):
        ring(name)


IDENTITIES = (
    "sin(2*t) == 2*sin(t)*cos(t)",
    "cos(3*t) == 4*cos(t)^3 - 3*cos(t)",
    "tan(t/2) == sin(t)/(1 + cos(t))",
    "tan(2*t) == 2*tan(t)/(1 - tan(t)^2)",
    "cos(t + u) == cos(t)*cos(u) - sin(t)*sin(u)",
    "sin(t)^4 == 3/8 - cos(2*t)/2 + cos(4*t)/8",
    "cos(t)*cos(u) == (cos(t+u) + cos(t-u))/2",
    "sin(t + pi/2) == cos(t)",
    "tan(t + pi/2) == -1/tan(t)",
    "tan(t - u) == (tan(t) - tan(u))/(1 + tan(t)*tan(u))",
    "(1 + sin(t))/cos(t) == cos(t)/(1 - sin(t))",
    "cos(5*t) == 16*cos(t)^5 - 20*cos(t)^3 + 5*cos(t)",
)


@pytest.mark.parametrize("identity", IDENTITIES)
def test_identities_and_their_negations(identity: str) -> None:
    left, right = identity.split(" == ")
    assert G(left) == G(right)
    assert G(left) != G(f"{right} + cos(u)")
    expression = sympy.sympify(left.replace("^", "**")) - sympy.sympify(right.replace("^", "**"))
    assert G(expression) == 0
    assert abs(complex(expression.subs({t: 0.37, u: -1.1}).evalf())) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("seed", first_quick([5, 6, 7], 1))
def test_random_expressions_against_trigsimp_and_numbers(seed: int) -> None:
    rng, terms = (
        Random(seed),
        [sympy.cos(t), sympy.sin(t), sympy.cos(2 * t), sympy.sin(t - u), sympy.cos(u), 2],
    )
    for _ in range(7):
        f = sum(rng.choice(terms) * rng.choice(terms) ** rng.randint(1, 2) for _ in range(3))
        element = G(f)
        back = to_sympy(element)
        assert abs(complex((f - back).subs({t: 0.3, u: 1.7}).evalf())) < 1e-12
        assert (element == 0) == (sympy.trigsimp(sympy.expand_trig(f)) == 0)
        assert G(back) == element
        assert H(G)(element).diff("t") == H(G)(sympy.diff(f, t))


@pytest.mark.parametrize(
    "name", ["QQ(cos(t),sin(t))", "QQ(cos(t/2),sin(t/2))", "QQ(sqrt(3))(cos(t),sin(t))"]
)
def test_derivatives(name: str) -> None:
    R, rng = ring(name), Random(8)
    for _ in range(5):
        f = R.random(rng)
        expected = sympy.diff(to_sympy(f), t)
        assert R.derivative(f, "t") == R(expected)


def test_values() -> None:
    q = H(F)("cos(t) + sin(t)*k")
    assert q.subs(t="pi/3") == q.subs({t: sympy.pi / 3}) == H("RR")("1/2 + sqrt(3)/2*k")
    assert q.subs(t="pi/2") == H("QQ")("k")
    assert q.subs(t=0) == H("QQ")(1)
    assert q.subs(t="2*t") == q**2
    assert q.subs(t="pi - t") == H(F)("-cos(t) + sin(t)*k")
    K = H("QQ(sqrt(3))(cos(t),sin(t))")
    assert K("cos(t)").subs(t="pi/6").algebra == H("QQ(sqrt(3))")
    assert K("cos(t+pi/3)") == K("cos(t)/2 - sqrt(3)/2*sin(t)")
    with pytest.raises(NotInvertibleError, match="pole"):
        H(F)("1/sin(t)").subs(t="pi")
    for value in (1, "x", "t*t", "pi/t"):
        with pytest.raises((CoercionError, RingError)):
            q.subs(t=value)
    p = H("QQ(x,cos(t),sin(t))")("x*cos(t)*i")
    assert p.subs(x=2, t="pi") == H("QQ")("-2*i")
    assert p.free_symbols == {x, t}
    assert p.diff("x") == H("QQ(x,cos(t),sin(t))")("cos(t)*i")


def test_angles_that_the_ring_has_not() -> None:
    for text in ("cos(t/2)", "cos(u)", "cos(t + pi/3)", "cos(t*t)", "cos(1)"):
        with pytest.raises(CoercionError):
            F(text)
    assert ring("QQ(cos(t/2),sin(t/2))")("cos(t)") == ring("QQ(cos(t/2),sin(t/2))")(
        "2*cos(t/2)^2-1"
    )
    assert ring("QQ(I)(cos(t),sin(t))")(sympy.exp(2 * sympy.I * t)) == ring("QQ(I)(cos(t),sin(t))")(
        "cos(2*t) + I*sin(2*t)"
    )


@pytest.mark.parametrize(
    ("statement", "field", "verdict"),
    [
        ("(cos(t) + sin(t)*k)*(cos(t) - sin(t)*k) == 1", F.name, "proved"),
        ("(cos(t) + sin(t)*i)^5 == cos(5*t) + sin(5*t)*i", F.name, "proved"),
        ("(cos(t) + sin(t)*k)*(cos(u) + sin(u)*k) == cos(t+u) + sin(t+u)*k", G.name, "proved"),
        ("norm(cos(t)*p + sin(t)*p*k) == norm(p)", F.name, "proved"),
        ("(cos(t) + sin(t)*k)*i == i*(cos(t) + sin(t)*k)", F.name, "refuted"),
        ("cos(t + u) == cos(t) + cos(u)", G.name, "refuted"),
        ("(cos(t/2) + sin(t/2)*k)*i*(cos(t/2) - sin(t/2)*k) == cos(t)*i + sin(t)*j",
         "QQ(cos(t/2),sin(t/2))", "proved"),
        ("cos(t + pi/2) == -sin(t)", F.name, "proved"),
    ],
)  # fmt: skip
def test_the_prover_and_its_certificates(statement: str, field: str, verdict: str) -> None:
    answer = prove(statement, field=field)
    assert answer.verdict == verdict
    certificate = answer.certificate
    assert certificate is not None
    assert check(certificate).verdict == verdict
    forged = {**certificate, "verdict": "refuted" if verdict == "proved" else "proved"}
    with pytest.raises(Exception):  # noqa: B017, PT011 - whatever is wrong with it
        check(forged)


def test_euler_angles() -> None:
    names = ("psi", "theta", "phi")
    pairs = ",".join(f"{f}({name}/2)" for name in names for f in ("cos", "sin"))
    A, angles = H(f"QQ({pairs})"), sympy.symbols("psi theta phi")
    for sequence in ("ZYX", "zyx", "ZXZ", "xyz"):
        q = A.euler(sequence, angles)
        assert q.norm() == 1
        values = dict(zip(angles, (0.3, -0.8, 1.9), strict=True))
        ours = to_sympy(q.rotation_matrix()).subs(values).evalf()
        theirs = sympy.Quaternion.from_euler(
            [values[a] for a in angles], sequence
        ).to_rotation_matrix()
        assert (ours - theirs.evalf()).norm() < 1e-12
        exact = q.subs(psi="pi/3", theta="pi/2", phi="-pi/4")
        expected = Rotation.from_euler(sequence, [60, 90, -45], degrees=True)
        assert Rotation.from_exact(exact).approx_equal(expected, 1e-12)
    for sequence, given in (("Zy", angles[:2]), ("", ()), ("ZYX", angles[:2]), ("ABC", angles)):
        with pytest.raises(CoercionError):
            A.euler(sequence, given)
    with pytest.raises(CoercionError, match="multiple"):
        H(F).euler("Z", ["t"])
    with pytest.raises(RotationError, match="subs"):
        from_exact(A.euler("Z", ["psi"]))
    zeta = H("QQ(zeta7)+")(ring("QQ(zeta7)+").gen, 1, 0, 0)
    assert Rotation.from_exact(zeta).shape == ()


def test_embeddings_of_circles() -> None:
    q: Any = H(F)("cos(t) + sin(t)*k/(2+cos(t))")
    assert q.change_ring(G) == H(G)("cos(t) + sin(t)*k/(2+cos(t))")


def test_numbers_in_angles_are_computed() -> None:
    assert F("cos((1+2)*t)") == F("cos(3*t)") != F("cos(t)")
    assert F("cos((3-1)*t)") == F("cos(2*t)")
    assert F("sin((1/2+1/2)*t - 0)") == F("sin(t)")


@pytest.mark.parametrize(
    ("statement", "field"),
    [
        ("norm(vector(p)) == 1 => norm(cos(t) + sin(t)*vector(p)) == 1", "QQ(cos(t),sin(t))"),
        ("s*s == 1 => (cos(t)*s)**2 + sin(t)**2 == 1", "QQ(sqrt(2))(cos(t),sin(t))"),
        ("s*s == 1 => cos(t)**2 + s*s*sin(t)**2 == cos(u)**2 + sin(u)**2", "QQ(cos(t),sin(t),cos(u),sin(u))"),
    ],
)  # fmt: skip
def test_conclusions_use_the_unit_circle(statement: str, field: str) -> None:
    answer = prove(statement, field=field)
    assert answer.verdict == "proved"
    assert check(answer.certificate)
    wrong = prove(statement.replace("== 1 =>", "== 2 =>"), field=field)
    assert wrong.verdict != "proved"
