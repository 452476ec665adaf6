"""What a notebook shows: mathematics where there is a formula, else the text, and never nothing."""

import re

import pytest

from hfield import GF, QQ, RR, H, QuaternionAlgebra, explain, prove, ring, verify
from hfield.rings.latex_names import latex_name

A = QuaternionAlgebra("QQ", 1, 3)
B = QuaternionAlgebra("QQ", -1, -1)
SHOWN = [
    *(QQ, RR, GF(9), ring("QQ(sqrt(-7))"), ring("GF(2)(t)"), A, H(GF(9)), A.split(), A(1, 2, 0, 1)),
    *(B.isomorphism(QuaternionAlgebra("QQ", -4, -1)), verify("centre", field="QQ")),
    *(explain("centre"), prove("p*q == q*p"), QuaternionAlgebra.from_text("[1,t|GF(4)(t))")),
]


@pytest.mark.parametrize("thing", SHOWN, ids=lambda x: type(x).__name__)
def test_what_is_public_has_a_formula(thing):
    text = thing._repr_latex_()
    assert re.fullmatch(r"\$.+\$", text, re.DOTALL)
    assert text.count("{") == text.count("}")
    left, right = (len(re.findall(rf"\\{word}\b", text)) for word in ("left", "right"))
    assert left == right
    assert not re.search(r"QQ|GF\(|√|·|²", re.sub(r"\\text\{[^}]*\}", "", text))


def test_algebras_over_different_fields_look_different():
    assert len({H(F)._repr_latex_() for F in ("QQ", "RR", "GF(9)")}) == 3
    assert r"\frac{-1,-3}{\mathbb{Q}}" in QuaternionAlgebra("QQ", -1, -3)._repr_latex_()


def test_an_array_shows_its_text():
    q = H(GF(9))([1, 2, 0], 0, [0, 1, 2], 1)
    assert q._repr_latex_() is None  # a notebook then takes the repr
    assert "shape (3,)" in repr(q)


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
