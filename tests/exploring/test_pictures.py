"""Graphs and pictures: edges by brute force, files that are pictures, and what a notebook shows."""

from collections import Counter
from xml.etree import ElementTree

import numpy as np
import pytest

from hfield import GF, QQ, H, QuaternionAlgebra
from hfield.errors import CoercionError, NotFiniteError, TooLargeError
from hfield.exploring.pictures import PICTURES, PictureError, figure
from tests.exploring.brute_force import BruteForce, Case
from tests.subcases import share_quick, slow


@pytest.mark.parametrize(
    "case", [Case("GF(2)", 1, 0, 1), Case("GF(3)", 2, 0, 2), Case("GF(3)", 0, 0, 1)], ids=str
)
def test_graphs_by_brute_force(case: Case) -> None:
    A, table = case.algebra, BruteForce(case).table
    number = {q: n for n, q in enumerate(A.elements())}
    commuting, killing = table == table.T, (table == 0) | (table.T == 0)
    for kind, matrix in (("commuting", commuting), ("zero-divisors", killing)):
        expected = {(x, y) for x, y in np.argwhere(matrix).tolist() if 0 < x < y}
        edges = A.graph(kind)
        assert {(number[x], number[y]) for x, y in edges} == expected
        assert len(edges) == len(expected)


@pytest.mark.parametrize("what", share_quick(PICTURES, 2))
@pytest.mark.parametrize("dark", [False, slow(True)])
def test_pictures_are_written(tmp_path, what: str, dark: bool) -> None:
    A = H(GF(2)) if dark else H(GF(3))
    svg, png = tmp_path / "a.svg", tmp_path / "a.png"
    A.draw(svg, what=what, dark=dark)
    A.draw(str(png), what=what, dark=dark)
    assert ElementTree.parse(svg).getroot().tag.endswith("svg")
    assert png.read_bytes().startswith(b"\x89PNG")
    words = [text.get_text() for text in figure(A, what, dark).texts]
    assert any(A.name in line for line in words)


def test_ideals_over_residues_stand_by_their_numbers_of_elements() -> None:
    drawn = figure(H("ZZ/4"), "ideals", False)
    counts = Counter(ideal.cardinality() for ideal in H("ZZ/4").left_ideals())
    words = ", ".join(f"{m} of {n}" for n, m in counts.items())
    assert drawn.texts[1].get_text() == f"by numbers of elements: {words}"
    names = [text.get_text() for text in drawn.axes[0].texts]
    assert names[0] == "0"
    assert names[-1] == "A"


def test_the_table_of_products_is_that_of_the_algebra() -> None:
    A = H(GF(2))
    order = sorted(A.elements(), key=lambda q: int(q.norm()))
    image = figure(A, "product", False).axes[0].images[0].get_array()
    assert image.shape[:2] == (16, 16)
    color = {q: tuple(image[n, order.index(A.one)]) for n, q in enumerate(order)}
    assert len(set(color.values())) == 16
    for n, p in enumerate(order):
        for m, q in enumerate(order):
            assert tuple(image[n, m]) == color[p * q]


def test_what_is_refused(tmp_path) -> None:
    A = H(GF(3))
    with pytest.raises(CoercionError, match="'product', 'norm'"):
        A.draw(tmp_path / "a.svg", what="nonsense")
    with pytest.raises(CoercionError, match="'commuting'"):
        A.graph("nonsense")
    with pytest.raises(PictureError, match=r"\.svg"):
        A.draw(tmp_path / "a.nonsense")
    with pytest.raises(PictureError):
        A.draw(tmp_path / "no" / "folder.svg")
    with pytest.raises(NotFiniteError):
        H(QQ).draw(tmp_path / "a.svg")
    for big, what in (
        (H(GF(7)), "product"),
        (H(GF(211)), "ideals"),
        (H(GF(5)), "commuting"),
        (H("ZZ/8"), "commuting"),
    ):
        with pytest.raises(TooLargeError):
            big.draw(tmp_path / "a.svg", what=what)


def test_notebooks_show_pages_and_tables() -> None:
    html = H(GF(3)).zero_divisors()._repr_html_()
    assert "33 = q^3+q^2-q" in html
    assert html.count("<tr>") == 11
    assert "23 more" in html
    assert "at random" in H(QQ).units()._repr_html_()
    assert "<td>" not in H(GF(2)).elements_of_trace(1)._repr_html_()
    page = H(GF(3))._repr_html_()
    assert page is not None
    assert "idempotent" in page or "centre" in page
    assert QuaternionAlgebra("QQ", 1, 3)._repr_html_().startswith("<pre>")
