"""Algebras over rational functions in several variables, by residues and by leading terms."""

from contextlib import suppress
from random import Random

import pytest

from hfield import QuaternionAlgebra, prove, ring
from hfield.core.product import Constants, norm
from hfield.errors import RingError, UndecidedError
from hfield.fields.quadratic_forms import zero_norm
from hfield.fields.quadratic_forms.global_field import known_field
from hfield.fields.quadratic_forms.norm_forms.leading_terms import by_leading_terms
from hfield.fields.quadratic_forms.normal_forms import normal_form


@pytest.mark.parametrize(
    ("text", "places", "word"),
    [
        (
            "(x,y|QQ(x,y))",
            "x, y, 1/x, 1/y",
            "the residue at x is y, which is not a square in QQ(y)",
        ),
        (
            "(a,b|QQ(a,b))",
            "a, b, 1/a, 1/b",
            "the residue at a is b, which is not a square in QQ(b)",
        ),
        ("(s,t|GF(3)(s,t))", "s, t, 1/s, 1/t", "not a square in GF(3)(t)"),
        ("(x,y*z|QQ(x,y,z))", "x, y, z, 1/x, 1/y, 1/z", "not a square in QQ(y,z)"),
        ("(x,x+y^2-1|QQ(x,y))", "x, y^2+x-1, 1/x", "y^2-1, which is not a square"),
        ("(x^2-y^3,2|QQ(x,y))", "y^3-x^2, 1/y", "the norm"),
    ],
)
def test_a_residue_proves_a_division_algebra(text, places, word):
    A = QuaternionAlgebra.from_text(text)
    answer = A.division_or_splitting()
    assert not answer
    assert A.is_division_algebra()
    assert ", ".join(map(str, A.ramified_places())) == places
    assert word in answer.reason


@pytest.mark.parametrize("text", ["[s,t|GF(2)(s,t))", "[1/s,t|GF(2)(s,t))"])
def test_some_residues_prove_it_where_others_are_open(text):
    """At the pole of the first constant the residue is wild: the places that are known are not called all."""
    A = QuaternionAlgebra.from_text(text)
    assert A.is_division_algebra()
    reason = A.division_or_splitting().reason
    assert "y² + y does not take that value" in reason
    assert reason.endswith("ramified at t, 1/t, maybe elsewhere, too")
    with pytest.raises(UndecidedError, match="are squares is not decided"):
        A.ramified_places()


def test_algebras_are_distinguished_by_residues_that_are_known():
    A, B, C = (
        QuaternionAlgebra("GF(2)(s,t)", *constants, 1)
        for constants in (("s", "t"), ("s+s^2+s^4", "t"), ("s", "t+1"))
    )
    with pytest.raises(UndecidedError, match="same places may ramify"):
        A.is_isomorphic(B)  # which it is: s² + s⁴ is y² + y
    assert not A.is_isomorphic(C)


@pytest.mark.parametrize(
    "text", ["(s,t|GF(4)(s,t))", "[s,t|GF(4)(s,t))", "(s+x*t,t|GF(9)(s,t))", "(s,t|GF(2)(s,t))"]
)
def test_leading_terms_prove_a_division_algebra(text):
    A = QuaternionAlgebra.from_text(text)
    assert A.zero_norm_element() is None
    assert zero_norm(A.ring, A.constants).method == "leading terms"


@pytest.mark.parametrize("name", ["QQ(x,y)", "GF(5)(s,t)"])
def test_residues_agree_with_those_of_a_line(name):
    """Algebras in one of the variables alone ramify where they do over k in that variable."""
    F, rng = ring(name), Random(2)
    x = F.gen_name
    line = ring(f"{F.base}({x})")
    for _ in range(15):
        texts = [line.text(line.random(rng)) for _ in range(2)]
        if "0" in texts:
            continue
        below = QuaternionAlgebra(line, *texts).ramified_places()
        try:
            above = QuaternionAlgebra(F, *texts).ramified_places()
        except UndecidedError:
            continue
        assert {str(v).replace("inf", f"1/{x}") for v in below} >= set(map(str, above))
        linear = [v for v in below if v.poly is None or v.poly.degree() == 1]
        assert {str(v).replace("inf", f"1/{x}") for v in linear} <= set(map(str, above))


@pytest.mark.parametrize("name", ["QQ(x,y)", "GF(3)(s,t)", "GF(5)(s,t)"])
def test_a_norm_is_never_ramified(name):
    """(a, u² − a·v²) splits, so no residue may say that it does not."""
    F, rng = ring(name), Random(7)
    for _ in range(12):
        a, u, v = (F(F.polynomials.random(rng)) for _ in range(3))
        b = u * u - a * v * v
        if F.is_zero(a) or F.is_zero(b):
            continue
        with suppress(UndecidedError):
            assert known_field(F).ramified(_form(F, a, b)) == (), (a, b)


@pytest.mark.parametrize("name", ["QQ(x,y)", "GF(9)(s,t)", "GF(2)(s,t)", "GF(4)(s,t)"])
def test_leading_terms_never_speak_against_a_zero(name):
    """(a, u² − a·v²), or [a, u² + uv + a·v²) in characteristic 2, has one."""
    F, rng, t = ring(name), Random(9), int(ring(name).characteristic == 2)
    for _ in range(30):
        a, u, v = (F.random(rng) for _ in range(3))
        b = u * u + t * u * v - a * v * v
        if not (F.is_zero(a) or F.is_zero(b)):
            c = Constants(a, F(t), b)
            assert by_leading_terms(F, c, normal_form(F, c)) is None
    x, y = (F.names()[n] for n in ("x", "y")) if name[0] == "Q" else (F("s"), F("t"))
    c = Constants(x, F(t), y)
    assert by_leading_terms(F, c, normal_form(F, c)) is not None


def _form(F, a, b):
    return normal_form(F, Constants(a, F.zero, b))


def test_without_residues_a_value_decides_over_the_rationals():
    assert QuaternionAlgebra("QQ(x,y)", 2, 5).is_division_algebra()
    assert (
        "purity of the Brauer group"
        in QuaternionAlgebra("QQ(x,y)", 3, 5).division_or_splitting().assumes
    )
    F = ring("QQ(x,y)")
    A = QuaternionAlgebra(F, "x", "1-x")
    assert norm(A.constants, A.zero_norm_element().coordinates) == 0
    with pytest.raises(UndecidedError, match="residues at x\\^2\\+y\\^2"):
        QuaternionAlgebra(F, "x^2+y^2", -1).is_division_algebra()


def test_places_are_read():
    field = known_field(ring("QQ(x,y)"))
    assert str(field.read_place("x^2+y")) == "x^2+y"
    assert field.read_place("1/y").infinite == 1
    for text in ("x^2-y^2", "2", "x/y"):
        with pytest.raises(RingError, match="is not a place"):
            field.read_place(text)


@pytest.mark.parametrize(
    "field", ["QQ(x,y)", "GF(4)(s,t)", "GF(3)(t)[u]/(u^2-t^3+t)", "QQ(x,y)[u]/(u^3-x*y)"]
)
def test_identities(field):
    assert prove("norm(p*q) == norm(p)*norm(q)", field=field).verdict == "proved"
    assert prove("(p*q)*r == p*(q*r)", field=field).verdict == "proved"
    commutes = "proved" if ring(field).characteristic == 2 else "refuted"
    assert prove("p*q == q*p", field=field).verdict == commutes


def test_in_the_generic_algebra_every_element_but_0_has_an_inverse():
    for text in ("(x,y|QQ(x,y))", "(s,t|GF(5)(s,t))"):
        assert prove("norm(q) == 0 => q == 0", algebra=text).verdict == "proved"
        assert prove("p*q == 0 => p == 0 or q == 0", algebra=text).verdict == "proved"


def test_beyond_arithmetic_extensions_are_left_open():
    A = QuaternionAlgebra("GF(3)(t)[u]/(u^2-t^3+t)", "t", "u")
    assert A.basis[1] * A.basis[2] == A.basis[3]
    with pytest.raises(UndecidedError):
        A.is_division_algebra()
