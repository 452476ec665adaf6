"""What a notebook shows: mathematics where there is a formula, else the text, and never nothing."""

import re

import numpy as np
import pytest

from anim import compare
from hfield import GF, QQ, RR, H, QuaternionAlgebra, explain, info, prove, ring, verify
from hfield.fields.base.latex_names import latex_name
from rotation import RigidTransform, Rotation
from tests.subcases import subcases

A = QuaternionAlgebra("QQ", 1, 3)
B = QuaternionAlgebra("QQ", -1, -1)
SHOWN = [
    *(QQ, RR, GF(9), ring("QQ(sqrt(-7))"), ring("GF(2)(t)"), A, H(GF(9)), A.split(), A(1, 2, 0, 1)),
    *(B.isomorphism(QuaternionAlgebra("QQ", -4, -1)), verify("centre", field="QQ")),
    *(
        B.maximal_order(),
        B.maximal_order().right_ideal([2, "i + j"]),
        B.lattice([1, "i", "j", "k"]),
    ),
    *(B.maximal_order().class_set(), B(1, 2, 0, 1).minimal_polynomial()),
    *(explain("centre"), prove("p*q == q*p"), QuaternionAlgebra.from_text("[1,t|GF(4)(t))")),
]


@subcases("thing", SHOWN)
def test_what_is_public_has_a_formula(thing):
    text = thing._repr_latex_()
    assert re.fullmatch(r"\$.+\$", text, re.DOTALL)
    assert text.count("{") == text.count("}")
    left, right = (len(re.findall(rf"\\{word}\b", text)) for word in ("left", "right"))
    assert left == right
    assert not re.search(r"QQ|GF\(|√|·|²", re.sub(r"\\text\{[^}]*\}", "", text))


def test_algebras_over_different_fields_look_different():
    assert len({H(F)._repr_latex_() for F in ("QQ", "RR", "GF(9)")}) == 3
    assert r"\frac{-1,-1}{\mathbb{F}_{9}}" in H(GF(9)).latex()  # as in its name, not 2
    assert r"\frac{-1,-1}{\mathbb{F}_{4}}" in H(GF(4)).latex()
    assert r"\frac{-1,-3}{\mathbb{Q}}" in QuaternionAlgebra("QQ", -1, -3)._repr_latex_()


def test_an_array_shows_its_text():
    q = H(GF(9))([1, 2, 0], 0, [0, 1, 2], 1)
    assert q._repr_latex_() is None  # a notebook then takes the repr
    assert "shape (3,)" in repr(q)


def test_an_explanation_shows_its_steps():
    html = explain("theorem-3")._repr_html_()
    assert "proved" in html
    assert "2. all coefficients of the difference are 0" in html


def test_an_answer_shows_verdict_witness_and_reasons():
    html = prove("p*q == q*p")._repr_html_()
    for part in ("refuted", "p = i, q = j", "characteristic 2", "<pre>"):
        assert part in html
    assert "&lt;" not in prove("p == p")._repr_html_()


@pytest.mark.parametrize(
    ("name", "latex"),
    [
        ("GF(2^8)", r"\mathbb{F}_{2^{8}}"),
        ("QQ(root(2,3))", r"\mathbb{Q}(\sqrt[3]{2})"),
        ("QQ(zeta5)", r"\mathbb{Q}(\zeta_{5})"),
        ("Qp(5)", r"\mathbb{Q}_{5}"),
        ("GF(9)((t))", r"\mathbb{F}_{9}((t))"),
        ("ZZ/6", r"\mathbb{Z}/6"),
    ],
)
def test_names_of_rings(name, latex):
    assert latex_name(name) == latex


def test_info_shows_the_page_of_the_command(capsys, monkeypatch):
    monkeypatch.delenv("COLUMNS", raising=False)  # pytest's workers say how wide they are
    from hfield.cli import main

    about = info("(-1,-3|QQ)")
    assert main(("info", "(-1,-3|QQ)")) == 0
    assert capsys.readouterr().out.rstrip() == str(about) == repr(about)
    assert about.algebra == QuaternionAlgebra("QQ", -1, -3) == info(about.algebra).algebra
    assert "ramified at" in about._repr_html_()


@pytest.mark.parametrize("field", ["QQ", "GF(9)", "QQ(sqrt(2))", "GF(2)(t)"])
def test_a_polynomial_is_a_tuple_that_shows_as_one(field):
    A = H(field)
    q = A(1, 1, 0, 1)
    f = q.minimal_polynomial()
    assert isinstance(f, tuple)
    assert f == (q.norm(), -q.trace(), A.ring.one)
    assert repr(f).startswith("X²")
    assert sum((c * q**n for n, c in enumerate(f)), A.zero) == A.zero
    assert repr(A(-3).minimal_polynomial() if field == "QQ" else "X+3") in ("X+3", "'X+3'")


def test_rotations_show_angle_and_axis():
    turn = Rotation.from_euler("ZYX", [90, 0, 0], degrees=True)
    html = turn._repr_html_()
    assert "90°" in html
    assert "0, 0, 1" in html
    moved = RigidTransform.from_components([1, 2, 3], turn)._repr_html_()
    assert "1, 2, 3" in moved
    many = Rotation.identity(1000)._repr_html_()
    assert many.count("<tr>") == 7
    assert "994 more" in many
    assert "shape (0,)" in Rotation.from_quat(np.zeros((0, 4)))._repr_html_()


def test_a_comparison_is_a_table():
    shown = compare()
    assert shown._repr_markdown_() == repr(shown)
    assert repr(shown).startswith("| | quaternions |")


@pytest.mark.parametrize(
    ("name", "text", "latex"),
    [
        ("QQ[s]/(s^3-2)", "s^2/2 - 1", r"$-1+\frac{1}{2}s^{2}$"),
        ("QQ(sqrt(2))", "1+sqrt(2)", r"$1+\sqrt{2}$"),
        ("Qp(5)", "2/3", r"$\frac{2}{3}$"),
        ("QQ(x)", "1/(x+1)", r"$\frac{1}{x+1}$"),
    ],
)
def test_elements_of_fields_of_our_own_show_themselves(name, text, latex):
    assert ring(name).parse(text)._repr_latex_() == latex
