"""The documentation as a site: nothing from outside, and nothing that keeps a reader out.

Needs the site (``python tasks.py docs``); the second part needs Chromium and axe-core
(``scripts/install_judges.sh``).
"""

import os
from html.parser import HTMLParser
from itertools import product
from pathlib import Path
from urllib.parse import unquote

import pytest

from tests.anim.chromium import CHROMIUM, Browser, axe_core
from tests.thorough import part

SITE = Path(os.environ.get("HFIELD_SITE", Path(__file__).parents[1] / "hfield" / "site"))
PAGES = [
    *("index.html", "tutorials/first-steps.html", "gallery.html", "how-to/coming-from.html"),
    *("api/hfield.html", "api/rotation/Rotation.html", "api/commands/prove.html"),
]
WIDTHS = {"phone": 390, "desk": 1280}

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not SITE.is_dir(), reason="the site is not built"),
]


class Resources(HTMLParser):
    """Collects what a page loads: not the links that a reader may follow."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []

    def handle_starttag(self, tag, attrs):
        if tag in ("script", "img", "link", "iframe", "source", "video"):
            self.found += [value for name, value in attrs if name in ("src", "href") and value]


def loaded(page: Path) -> list[str]:
    parser = Resources()
    parser.feed(page.read_text(encoding="utf-8"))
    return parser.found


def test_no_page_loads_anything_from_outside():
    pages = list(SITE.rglob("*.html"))
    assert pages
    outside = {
        (page.relative_to(SITE).as_posix(), address)
        for page in pages
        for address in loaded(page)
        if address.startswith(("http:", "https:", "//"))
    }
    assert not outside


class Anchors(HTMLParser):
    """Collects where links lead, and where they may."""

    def __init__(self, page: Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.places: set[str] = set()
        self.feed(page.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        found = dict(attrs)
        self.places |= {found["id"]} if "id" in found else set()
        self.links += [found["href"]] if tag == "a" and found.get("href") else []


def test_every_link_within_the_site_has_its_page_and_its_place():
    pages = {page.resolve(): Anchors(page) for page in SITE.rglob("*.html")}
    lost, followed = [], 0
    for page, anchors in pages.items():
        for link in anchors.links:
            if link.startswith(("http:", "https:")):
                continue
            file, _, place = unquote(link).partition("#")
            target = (page.parent / file).resolve() if file else page
            known = target in pages and (not place or place in pages[target].places)
            followed += 1
            if not known and not (target.is_file() and target.suffix != ".html"):
                lost.append((page.name, link))
    assert followed > 500
    assert lost == []


@pytest.fixture(scope="module")
def axe():
    return axe_core()


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    if CHROMIUM is None:
        pytest.skip("needs Chromium")
    browser = Browser(tmp_path_factory.mktemp("profile"))
    yield browser
    browser.close()


def show(browser: Browser, page: str, width: int, scheme: str) -> None:
    features = [{"name": "prefers-color-scheme", "value": scheme}]
    browser.send("Emulation.setEmulatedMedia", features=features)
    browser.send(
        "Emulation.setDeviceMetricsOverride",
        width=width,
        height=900,
        deviceScaleFactor=1,
        mobile=False,
    )
    browser.requests.clear()
    browser.complaints.clear()
    browser.open(SITE / page)


VIEWS = [*product(PAGES, WIDTHS, ("light", "dark"))]


@pytest.mark.parametrize(("page", "width", "scheme"), part(VIEWS))  # both widths, both schemes
def test_a_page_keeps_nobody_out(browser, axe, page, width, scheme):
    show(browser, page, WIDTHS[width], scheme)
    assert browser.complaints == []
    assert all(address.startswith(("file:", "data:")) for address in browser.requests)
    assert browser.evaluate("document.documentElement.scrollWidth") <= WIDTHS[width]
    browser.evaluate(f"{axe};0")
    found = browser.evaluate(
        "axe.run({preload: false}).then(r => r.violations"
        ".filter(v => ['serious', 'critical'].includes(v.impact))"
        ".map(v => [v.id, v.nodes.length, v.nodes[0].html.slice(0, 200), v.nodes[0].failureSummary]))"
    )
    assert found == []


def test_a_phone_shows_wide_tables_as_cards_and_long_pictures_in_strips(browser):
    show(browser, "how-to/coming-from.html", WIDTHS["phone"], "light")
    boxes = "[...document.querySelectorAll('.table-wrapper')].every((x) => x.scrollWidth <= x.clientWidth)"
    assert browser.evaluate(boxes)
    label = (
        "getComputedStyle(document.querySelector('.stacks td:nth-child(3)'), '::before').content"
    )
    assert browser.evaluate(label) == '"Sage"'
    show(browser, "how-to/coming-from.html", WIDTHS["desk"], "light")
    assert (
        browser.evaluate("getComputedStyle(document.querySelector('.stacks')).display") == "table"
    )
    show(browser, "gallery.html", WIDTHS["phone"], "light")
    browser.wait("document.querySelectorAll('.strip.cut').length >= 4")
    assert browser.evaluate("document.querySelector('.strip a.zoom').href").endswith("top.png")
    browser.evaluate("document.querySelector('.strip').scrollLeft = 10000")
    browser.wait("!document.querySelector('.strip').classList.contains('cut')")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_code_that_is_cut_has_a_shade_at_its_edge(browser, scheme):
    """The pixels of the last column differ from the sheet, until one has scrolled to the end."""
    show(browser, "tutorials/first-steps.html", WIDTHS["phone"], scheme)
    wide = "(x) => x.clientHeight < 500 && x.scrollWidth > x.clientWidth + 40"
    find = f"[...document.querySelectorAll('pre')].find({wide})"
    browser.evaluate(f"box = {find}; box.scrollIntoView({{block: 'end', behavior: 'instant'}}); 0")
    place = browser.evaluate("r = box.getBoundingClientRect(); [r.right, r.top]")
    x, y = int(place[0]), int(place[1])
    for at, shaded in ((0, True), (10000, False)):
        browser.evaluate(f"box.scrollLeft = {at}; new Promise((done) => setTimeout(done, 100))")
        picture = browser.picture()
        dark = abs(picture[y + 4, x - 3] - picture[y + 4, x - 60]).max()
        assert (dark > 15) == shaded, dark
