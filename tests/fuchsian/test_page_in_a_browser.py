"""The page of a domain in headless Chromium: its centre is dragged, and the domain is the proved one."""

from functools import cache
from pathlib import Path

import pytest

from hfield import QuaternionAlgebra
from hfield.fuchsian.group import Domain
from tests.anim.chromium import CHROMIUM, Browser

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine"),
]


@cache
def first() -> Domain:
    return QuaternionAlgebra("QQ", 3, -1).maximal_order().norm_one_group().domain()


def around(z: complex) -> Domain:
    """Return the domain around a point of the disc around the first centre."""
    domain = first()
    return domain.group._around(domain.polygon.plane.nearby(z, 30))


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory):
    found = Browser(tmp_path_factory.mktemp("profile"), size=(800, 900))
    yield found
    found.close()


@pytest.fixture
def page(browser: Browser, tmp_path: Path):
    first().draw(tmp_path / "domain.html")
    browser.requests.clear()
    browser.open(tmp_path / "domain.html")
    yield browser
    assert browser.complaints == []
    assert all(url.startswith("file:") for url in browser.requests)


def settle(page: Browser) -> None:
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")


def place(page: Browser, z: complex) -> tuple[float, float]:
    """Return where a point of the disc around the first centre is on the screen."""
    x, y = page.evaluate(
        f"""(() => {{ const b = canvas.getBoundingClientRect(), s = b.width / canvas.width,
        [x, y] = project([{z.real}, {z.imag}]); return [b.left + x * s, b.top + y * s]; }})()"""
    )
    return x, y


def drag(page: Browser, z: complex) -> complex:
    """Drag the centre to a point, and return where the page has it then."""
    page.drag(place(page, center(page)), place(page, z))
    settle(page)
    return center(page)


def center(page: Browser) -> complex:
    return complex(*page.evaluate("center"))


def reading(page: Browser) -> str:
    return str(page.evaluate("document.getElementById('reading').textContent"))


def need_same(page: Browser, proved: Domain) -> None:
    """The page's domain has the sides and corners of the one that is proved, up to a rotation."""
    assert reading(page) == f"{len(proved.sides)} sides · area 2π·0.333333"
    seen = [complex(*z) for z in page.evaluate("shape.corners.map(poincare)")]
    assert sorted(map(abs, seen)) == pytest.approx(sorted(map(abs, proved.vertices)), abs=1e-4)
    count = len(seen)
    paired = sorted((side.partner - n) % count for n, side in enumerate(proved.sides))
    assert sorted((p - n) % count for n, p in enumerate(page.evaluate("shape.partners"))) == paired


def test_the_centre_is_dragged_and_the_domain_follows(page: Browser) -> None:
    need_same(page, first())
    before, polygons = page.picture(), {reading(page)}
    for target in (0.35 + 0.2j, -0.1 - 0.45j, 0.55j):
        z = drag(page, target)
        assert abs(z - target) < 0.01
        after = page.picture()
        assert (after != before).any(axis=-1).mean() > 0.05
        before = after
        need_same(page, around(z))
        polygons.add(reading(page))
    assert len(polygons) > 1  # the number of sides changes


def test_in_the_half_plane_and_back_by_keys_and_buttons(page: Browser) -> None:
    page.evaluate("document.getElementById('model').click()")
    settle(page)
    z = drag(page, 0.2 + 0.3j)
    assert abs(z - (0.2 + 0.3j)) < 0.02
    need_same(page, around(z))
    page.evaluate("canvas.focus()")
    page.key("ArrowLeft")
    settle(page)
    assert 0 < abs(center(page) - z) < 0.04
    page.evaluate("document.getElementById('home').click()")
    settle(page)
    assert center(page) == 0
    need_same(page, first())


def test_a_point_that_a_rotation_fixes_has_a_sector(page: Browser) -> None:
    domain = first()
    for order in (2, 3):
        corner = next(domain.vertices[c.start] for c in domain.cycles if c.order == order)
        page.evaluate(f"move([{corner.real}, {corner.imag}])")
        settle(page)
        assert f"area 2π·0.333333 · the centre is fixed by a rotation of order {order}" in reading(
            page
        )


def test_a_page_begins_with_a_sector(browser: Browser, tmp_path: Path) -> None:
    group = first().group
    sector = group.domain(group.cm_points(-4)[0])
    sector.draw(tmp_path / "sector.html", points=group.cm_points(-24))
    browser.open(tmp_path / "sector.html")
    assert "rotation of order 2" in reading(browser)
    assert browser.evaluate("shape.partners") == list(sector.partners)
    seen = [complex(*z) for z in browser.evaluate("shape.corners.map(poincare)")]
    assert seen == pytest.approx(list(sector.vertices), abs=1e-6)
    z = drag(browser, 0.2 + 0.3j)
    need_same(browser, group._around(sector.polygon.plane.nearby(z, 30)))
    inside = "beyond(shape, klein(act(inverse(shape.there), moved(z)))) < 0"
    assert browser.evaluate(f"GROUP.points[0].places.map((z) => {inside})") == [True, True]
    browser.evaluate("document.getElementById('home').click()")
    settle(browser)
    assert "rotation of order 2" in reading(browser)
    assert browser.complaints == []
