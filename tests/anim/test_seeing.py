"""The page Seeing quaternions: its groups are those of H(GF(p)), and its turns are products."""

import math
from itertools import product

import pytest

from anim.viewer import seeing
from hfield import GF, H
from tests.anim.chromium import Browser
from tests.anim.test_viewer import needs_chromium

pytestmark = needs_chromium


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory):
    path = tmp_path_factory.mktemp("page") / "s3.html"
    path.write_text(seeing(), encoding="utf-8")
    found = Browser(tmp_path_factory.mktemp("profile"), size=(900, 640))
    found.open(path)
    yield found
    found.close()


def put(browser: Browser, name: str, value: object) -> None:
    browser.evaluate(
        f"(() => {{ const s = document.getElementById('{name}'); s.value = '{value}';"
        " s.dispatchEvent(new Event('input')); })()"
    )


def test_it_opens_with_a_title_a_sentence_and_motion_about_i(browser: Browser) -> None:
    header = "document.getElementById('about')"
    text = browser.evaluate(f"{header}.innerText")
    assert text.startswith("Seeing quaternions")
    assert text.count(".") == 1
    below = browser.evaluate("document.getElementById('view').getBoundingClientRect().top")
    assert below >= browser.evaluate(f"{header}.getBoundingClientRect().bottom")
    assert browser.evaluate("document.getElementById('axis').value") == "i"
    browser.wait("seeing.turn[1] > 0.05")
    assert browser.evaluate("seeing.playing")
    put(browser, "side", "left")  # whoever takes over stops it
    assert browser.evaluate("[seeing.playing, document.getElementById('play').textContent]") == [
        False,
        "play",
    ]


def test_nothing_moves_where_reduced_motion_is_preferred(browser: Browser) -> None:
    still = {"name": "prefers-reduced-motion", "value": "reduce"}
    browser.send("Emulation.setEmulatedMedia", features=[still])
    browser.evaluate("seeing.old = true")
    browser.send("Page.reload")
    browser.wait("document.readyState === 'complete' && !seeing.old")
    assert browser.evaluate("seeing.playing") is False
    browser.send("Emulation.setEmulatedMedia", features=[])


@pytest.mark.slow
@pytest.mark.parametrize("prime", [3, 5])
def test_the_corners_modulo_a_prime_are_the_units_product_for_product(browser, prime: int) -> None:
    put(browser, "space", prime)
    names = browser.evaluate("seeing.names")
    field = H(GF(prime))
    units = [q for q in product(range(prime), repeat=4) if field(*q).norm() == 1]
    assert sorted(map(tuple, names)) == sorted(units)
    table = browser.evaluate(
        "seeing.points.map((p) => seeing.points.map((q) => { const r = hamilton(p, q);"
        " return seeing.points.findIndex((x) => Math.hypot(...x.map((v, n) => v - r[n])) < 1e-9); }))"
    )
    elements = [field(*name) for name in names]
    chosen = range(0, len(names), 1 if prime == 3 else 7)
    for m, n in product(chosen, range(len(names))):
        assert elements[m] * elements[n] == elements[table[m][n]]
    assert len(browser.evaluate("seeing.edges")) == {3: 96, 5: 720}[prime]  # of the two polytopes


@pytest.mark.parametrize(("side", "back"), [("left", False), ("right", False), ("both", True)])
def test_a_full_turn_brings_space_back_and_not_the_quaternions(
    browser, side: str, back: bool
) -> None:
    put(browser, "space", 0)
    put(browser, "side", side)
    x = "[0.5, 0.5, -0.5, 0.5]"
    for degrees, sign in ((360, 1 if back else -1), (720, 1)):
        put(browser, "turn", degrees)
        assert browser.evaluate(f"seeing.moved({x}, seeing.turn)") == pytest.approx(
            [sign * part for part in (0.5, 0.5, -0.5, 0.5)]
        )
    put(browser, "turn", 360)
    assert browser.evaluate("document.getElementById('said').textContent").startswith("p = −1")


def test_keys_alone_turn_choose_and_go_back(browser: Browser) -> None:
    put(browser, "space", 0)
    put(browser, "hand", "p")
    browser.evaluate("document.getElementById('view').focus()")
    for _ in range(3):
        browser.key("ArrowRight")
    angle = browser.evaluate("2 * Math.acos(seeing.base[0]) * 180 / Math.PI")
    assert angle == pytest.approx(2 * 3 * 13 / 150 * 180 / math.pi)
    put(browser, "hand", "view")
    before, base = browser.evaluate("seeing.view"), browser.evaluate("seeing.base")
    browser.key("ArrowUp")
    assert browser.evaluate("seeing.view")[1] < before[1]
    assert browser.evaluate("seeing.base") == base
    put(browser, "hand", "p")
    assert browser.evaluate("document.getElementById('unit').parentElement.hidden")
    put(browser, "space", 5)
    assert browser.evaluate("document.getElementById('unit').options.length") == 121
    put(browser, "unit", 7)
    assert browser.evaluate("seeing.chosen") == 7
    said = browser.evaluate("document.getElementById('turn').getAttribute('aria-valuetext')")
    assert said.startswith("360°, p = ")
    browser.key("Escape")
    assert browser.evaluate("[seeing.chosen, document.getElementById('unit').value]") == [None, ""]
    assert browser.evaluate("document.querySelectorAll('[aria-live], [role=status]').length") == 0
    assert browser.complaints == []


def test_the_hand_turns_and_a_click_chooses(browser: Browser) -> None:
    put(browser, "space", 0)
    put(browser, "side", "left")
    first = browser.picture()
    browser.drag((300, 300), (360, 330))
    assert browser.evaluate("seeing.base")[0] < 0.99
    assert (browser.picture() != first).any()
    browser.key("Escape")
    assert browser.evaluate("seeing.base") == [1, 0, 0, 0]
    put(browser, "space", 3)
    x, y, _ = browser.evaluate("seeing.seen(seeing.points[2])")
    top = browser.evaluate("document.getElementById('view').getBoundingClientRect().top")
    browser.drag((x, y + top), (x, y + top))
    chosen = browser.evaluate("seeing.chosen")
    assert chosen is not None
    assert browser.evaluate("document.getElementById('unit').value") == str(chosen)
    moved = browser.evaluate("seeing.moved([1, 0, 0, 0], seeing.turn)")
    assert moved == pytest.approx(browser.evaluate("seeing.points[seeing.chosen]"))
    assert browser.complaints == []
    assert [url for url in browser.requests if not url.startswith(("file:", "data:"))] == []
