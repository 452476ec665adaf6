"""The images of a domain in pictures: every one that can be seen, once, in every format."""

import cmath
import random
import re
from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from hfield import QuaternionAlgebra
from hfield.cli.order_arguments import algebra_of
from hfield.fuchsian.group import Domain
from hfield.fuchsian.picture import drawing_of, sides_of, svg
from hfield.fuchsian.search import Sight
from hfield.fuchsian.tessellation import SMALLEST, move, tessellation
from tests.anim.chromium import CHROMIUM, Browser
from tests.subcases import first_quick
from tests.thorough import part

# Reported as false: 57 to 330. A cusp, a level, and a field of degree 2.
ALGEBRAS = ["6", "57", "77", "111", "143", "210", "330", "cusp", "level", "field"]


@cache
def domain(name: str) -> Domain:
    if name == "cusp":
        order = QuaternionAlgebra("QQ", 1, 1).maximal_order()
    elif name == "level":
        order = QuaternionAlgebra("QQ", 3, -1).eichler_order(5)
    elif name == "field":
        A = QuaternionAlgebra.from_text("(-1,sqrt(2)|QQ(sqrt(2)))")
        order = A.maximal_order()
    else:
        order = algebra_of(name).maximal_order()
    return order.norm_one_group().domain()


def located(D: Domain, z: complex):
    """Return the unit whose image of the domain has the point z, found by moving z to the centre."""
    sight, units = Sight(D.polygon.plane), D.polygon.units
    a, b = sight.motions(np.array(D.group.order.rows(units), float))
    back_a, back_b = a.conj(), -b  # of the inverses
    g = D.group.order.algebra(1)
    while True:
        images = move(back_a, back_b, z)
        n = int(np.argmin(abs(images)))
        if abs(images[n]) >= abs(z) - 1e-12:
            return g
        z, g = complex(images[n]), g * units[n]


@pytest.mark.parametrize(
    "name", first_quick(["cusp", "6", "level", "field", *part(ALGEBRAS[2:7], 2)], 3)
)
def test_every_image_that_can_be_seen_is_drawn_once(name: str) -> None:
    D = domain(name)
    order, tiles = D.group.order, tessellation(D)
    rows = {tile.row for tile in tiles}
    assert len(rows) == len(tiles) > 100
    for tile in tiles[::17]:
        assert order.element(list(tile.row)).norm() == 1
    # Their motions are those of their units, up to sign.
    a, b = Sight(D.polygon.plane).motions(np.array([tile.row for tile in tiles], float))
    centers = np.array([move(tile.a, tile.b, 0j) for tile in tiles])
    assert centers == pytest.approx(b / a.conj(), abs=1e-7)
    # No two images of the centre are nearer to one another than the centre is to its nearest image.
    x = np.array([2 * tile.a * tile.b for tile in tiles])
    t = np.sqrt(1 + abs(x) ** 2)
    cosh = np.outer(t, t) - (x[:, None] * x.conj()).real
    least = min(np.sqrt(1 + abs(2 * tile.a * tile.b) ** 2) for tile in tiles)
    np.fill_diagonal(cosh, np.inf)
    assert cosh.min() > least - 1e-3
    # A point of the disc lies in one of them, or in one that is too small.
    rng, corners, found = random.Random(name), np.array(D.vertices), 0
    for _ in range(150):
        z = cmath.rect(rng.uniform(0.3, 0.99), rng.uniform(-cmath.pi, cmath.pi))
        row = order.rows([located(D, z)])[0]
        row = tuple(row) if next(c for c in row if c) > 0 else tuple(-c for c in row)
        one = order.rows([order.algebra(1)])[0]
        if row in (tuple(one), tuple(-c for c in one)):
            continue
        (a,), (b,) = Sight(D.polygon.plane).motions(np.array([row], float))
        points = move(a, b, corners)
        if max(np.ptp(points.real), np.ptp(points.imag)) > 2 * SMALLEST:
            assert row in rows
            found += 1
    assert found


@pytest.mark.parametrize("name", ["6", "cusp", "330"])
def test_sides_are_arcs_that_meet_the_circle_at_right_angles(name: str) -> None:
    D = domain(name)
    tiles = tessellation(D)
    for tile in tiles[:: max(1, len(tiles) // 9)]:
        for side in sides_of(move(tile.a, tile.b, np.array(D.vertices))):
            if side.center is None:
                assert abs((side.start.conjugate() * side.end).imag) < 1e-8
                continue
            radius = side.radius
            assert abs(side.end - side.center) == pytest.approx(radius, abs=1e-5)
            assert abs(side.center) ** 2 == pytest.approx(1 + radius**2, abs=1e-6)


@pytest.mark.parametrize(
    "name", first_quick(["cusp", "6", "level", *part(ALGEBRAS[1:7], 2), "field"], 3)
)
def test_an_svg_has_all_images_in_true_arcs_and_is_small(name: str) -> None:
    D = domain(name)
    text = svg(D)
    assert len(text) < 250_000
    areas = re.findall(r'<path fill="#\w+" d="([^"]+)"', text)
    assert sum(area.count("M") for area in areas) == len(tessellation(D)) + 1
    assert "a" in areas[0]
    assert text == svg(D)
    # The last path is the domain: its arcs end at its corners.
    here, corners = None, []
    for word, numbers in re.findall(r"([Mla])([^Mlaz]+)", areas[-1]):
        *_, x, y = map(float, numbers.split())
        here = complex(x, -y) + (0 if word == "M" else here)
        corners.append(here)
    assert corners[:-1] == pytest.approx([320 * z for z in D.vertices], abs=0.08)
    assert abs(corners[-1] - corners[0]) < 0.01


def test_every_format_has_the_same_images(tmp_path, monkeypatch) -> None:
    D, drawn = domain("6"), []
    monkeypatch.setattr(
        "hfield.fuchsian.picture.drawing_of",
        lambda *words: drawn.append(drawing_of(*words)) or drawn[-1],
    )
    for suffix in ("svg", "png", "pdf"):
        D.draw(tmp_path / f"d.{suffix}", depth=3)
        assert (tmp_path / f"d.{suffix}").stat().st_size > 5000
    assert all(one == other for one, other in pairwise(drawn))


@pytest.mark.slow
@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
def test_the_page_has_the_same_images_in_the_same_colours(tmp_path) -> None:
    browser = Browser(tmp_path / "profile", size=(800, 900))
    try:
        for name in ("6", "57", "210", "cusp"):
            D = domain(name)
            D.draw(tmp_path / "d.html")
            browser.open(tmp_path / "d.html")
            seen = browser.evaluate(
                "tiles().map(([g, first, length]) => [...act(g, [0, 0]), first, length])"
            )
            tiles = tessellation(D)
            assert len(seen) == len(tiles)
            for (x, y, first, length), tile in zip(seen, tiles, strict=True):
                assert complex(x, y) == pytest.approx(move(tile.a, tile.b, 0j), abs=1e-6)
                assert (first, length) == (tile.first, tile.length)
            numbers = set(browser.evaluate("shape.numbers"))
            assert len(numbers) == len({min(n, p) for n, p in enumerate(D.partners)})
    finally:
        browser.close()
