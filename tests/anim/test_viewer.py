"""What a browser makes of the page."""

from pathlib import Path

import numpy as np
import pytest

from anim.model import Model
from anim.viewer import Curve, Show, page
from tests.anim.chromium import CHROMIUM, Browser

pytestmark = pytest.mark.slow

FRAMES = 50
MODEL = Model(ring=60)


def about(axis: tuple[float, float, float], angles: np.ndarray) -> np.ndarray:
    half = np.asarray(angles) / 2
    return np.column_stack([np.cos(half), np.sin(half)[:, None] * np.asarray(axis)])


SPIN = about((0, 0, 1), np.linspace(0, 6, FRAMES))
FALL = about((1, 0, 0), np.linspace(0, np.pi / 2, FRAMES))


needs_chromium = pytest.mark.skipif(
    CHROMIUM is None, reason="needs the browser Chromium (Debian: chromium)"
)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory):
    found = Browser(tmp_path_factory.mktemp("profile"), size=(800, 600))
    yield found
    found.close()


@pytest.fixture
def four(browser: Browser, tmp_path: Path) -> Browser:
    """The page with four tops and two curves, paused at its first frame."""
    path = tmp_path / "top.html"
    shows = [
        Show(name, q) for name, q in (("one", SPIN), ("two", SPIN), ("three", FALL), ("four", FALL))
    ]
    curves = [
        Curve("tilt", np.linspace(0, 90, FRAMES), "°"),
        Curve("energy", np.full(FRAMES, 2.5), "J"),
    ]
    path.write_text(page(MODEL, shows, 50, curves=curves, background="#ffffff"), encoding="utf-8")
    return opened(browser, path)


def opened(browser: Browser, path: Path) -> Browser:
    browser.complaints.clear()
    browser.requests.clear()
    browser.open(path)
    if browser.evaluate("document.getElementById('play').ariaLabel") == "pause":
        browser.key(" ")
    browser.key("Home")
    settle(browser)
    return browser


def settle(browser: Browser) -> None:
    browser.evaluate(
        "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )


def frame(browser: Browser) -> int:
    return int(browser.evaluate("document.getElementById('frame').value"))


def yellow(picture: np.ndarray) -> np.ndarray:
    r, g, b = np.moveaxis(picture, -1, 0)
    return (r > 90) & (g > 70) & (b < r / 2) & (abs(r - g) < 80)


@needs_chromium
def test_it_draws_four_tops_with_labels(four: Browser) -> None:
    picture = four.picture()
    height = int(four.evaluate("document.getElementById('view').clientHeight"))
    for rows in (slice(0, height // 2), slice(height // 2, height)):
        for columns in (slice(0, 400), slice(400, 800)):
            part = picture[rows, columns]
            assert yellow(part).sum() > 500
            assert (part.max(axis=-1) < 60).sum() > 500  # the black sectors
            assert (part.min(axis=-1) > 245).sum() > part[
                ..., 0
            ].size / 3  # the background asked for
    labels = four.evaluate(
        "[...document.querySelectorAll('#labels span')].map((x) => x.textContent)"
    )
    assert labels == ["one", "two", "three", "four"]


@needs_chromium
def test_the_picture_has_the_depth_of_the_solid(browser: Browser, tmp_path: Path) -> None:
    """From straight above, the upright top is a disc of radius 1 with sectors of both colours."""
    path = tmp_path / "above.html"
    path.write_text(page(MODEL, [Show("", SPIN)], 50, camera=(-90, 88.8), background="#ffffff"))
    opened(browser, path)
    browser.key("Home")
    settle(browser)
    picture = browser.picture()[
        : int(browser.evaluate("document.getElementById('view').clientHeight"))
    ]
    solid = yellow(picture) | (picture.max(axis=-1) < 120)  # black shines from above
    ys, xs = np.nonzero(solid)
    across, along = np.ptp(xs) + 1, np.ptp(ys) + 1
    assert abs(across - along) < 0.1 * across
    assert solid.sum() == pytest.approx(np.pi / 4 * across * along, rel=0.1)
    assert 0.35 < yellow(picture).sum() / solid.sum() < 0.65  # half of the ten sectors each


@needs_chromium
def test_it_plays_pauses_and_scrubs(four: Browser) -> None:
    first = four.picture()
    four.key(" ")
    four.wait("Number(document.getElementById('frame').value) > 5")
    four.key(" ")
    settle(four)
    stopped = frame(four)
    settle(four)
    assert frame(four) == stopped > 0
    assert (four.picture() != first).any()
    four.evaluate(
        "(() => { const f = document.getElementById('frame'); f.value = 20;"
        " f.dispatchEvent(new Event('input')); })()"
    )
    settle(four)
    assert frame(four) == 20
    four.key("ArrowRight")
    four.key("ArrowLeft", shift=True)
    settle(four)
    assert frame(four) == 11
    four.key("End")
    settle(four)
    assert frame(four) == FRAMES - 1
    four.key("Home")
    settle(four)
    np.testing.assert_array_equal(four.picture(), first)


@needs_chromium
def test_it_orbits_zooms_and_comes_back(four: Browser) -> None:
    first = four.picture()
    four.drag((200, 100), (260, 130))
    settle(four)
    turned = four.picture()
    assert (turned != first).any(axis=-1).mean() > 0.02
    four.mouse("Wheel", 200, 100, deltaX=0, deltaY=-300)
    settle(four)
    assert yellow(four.picture()).sum() > 1.3 * yellow(turned).sum()
    four.key("r")
    settle(four)
    inner = slice(4, 400), slice(4, 796)  # without the ring around what has the focus
    np.testing.assert_array_equal(four.picture()[inner], first[inner])


@needs_chromium
def test_one_top_alone_and_the_curves(four: Browser) -> None:
    assert four.evaluate("document.querySelectorAll('#curves canvas').length") == 2
    box = four.evaluate(
        "(({left, top, width}) => [left, top, width])"
        "(document.querySelector('#curves canvas').getBoundingClientRect())"
    )
    four.drag((box[0] + 20, box[1] + 40), (box[0] + box[2] / 2, box[1] + 40))
    settle(four)
    assert abs(frame(four) - FRAMES // 2) <= 1
    four.key("3")
    settle(four)
    assert four.evaluate("[...document.querySelectorAll('#labels span')].map((x) => x.hidden)") == [
        True,
        True,
        False,
        True,
    ]
    four.key("0")
    four.key("?")
    settle(four)
    assert four.evaluate("document.getElementById('help').hidden") is False
    four.key("?")


@needs_chromium
def test_long_labels_and_small_windows(browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "long.html"
    shows, curves = (
        [Show("a long name " * 9, SPIN)] * 4,
        [Curve("tilt", np.arange(FRAMES), "°")] * 2,
    )
    path.write_text(page(MODEL, shows, 50, curves=curves), encoding="utf-8")
    opened(browser, path)
    boxes = browser.evaluate(
        "[...document.querySelectorAll('#labels span')].map((x) => x.getBoundingClientRect())"
        ".map(({left, right, height}) => [left, right, height])"
    )
    assert [box[1] <= box[0] + 400 and box[2] < 40 for box in boxes] == [True] * 4
    small = {"width": 200, "height": 160, "deviceScaleFactor": 1, "mobile": False}
    browser.send("Emulation.setDeviceMetricsOverride", **small)
    settle(browser)
    needed = browser.evaluate("[document.documentElement.scrollWidth, innerHeight]")
    seen = browser.evaluate("document.getElementById('view').clientHeight")
    browser.send("Emulation.setDeviceMetricsOverride", **{**small, "width": 800, "height": 600})
    settle(browser)
    assert needed == [200, 160]
    assert seen > 40


@needs_chromium
def test_many_values_make_a_short_line_through_all_their_extremes(four: Browser) -> None:
    line = four.evaluate(
        "thinned(Array.from({length: 100000}, (_, n) => n === 77777 ? 9 : Math.sin(n / 9e3)))"
    )
    assert len(line) <= 2002
    assert [77777, 9] in line
    assert [pair[0] for pair in line] == sorted(pair[0] for pair in line)
    assert four.evaluate("thinned([3, 1, 2])") == [[0, 3], [1, 1], [2, 2]]


@needs_chromium
def test_it_resizes(four: Browser) -> None:
    sizes = {"width": 420, "height": 700}
    four.send("Emulation.setDeviceMetricsOverride", **sizes, deviceScaleFactor=2, mobile=False)
    settle(four)
    settle(four)
    view = four.evaluate(
        "[document.getElementById('view').width, document.documentElement.scrollWidth]"
    )
    four.send(
        "Emulation.setDeviceMetricsOverride",
        width=800,
        height=600,
        deviceScaleFactor=1,
        mobile=False,
    )
    assert view == [840, 420]


@needs_chromium
def test_the_page_makes_no_requests_and_logs_no_errors(four: Browser) -> None:
    four.key(" ")
    four.wait("Number(document.getElementById('frame').value) > 2")
    four.key(" ")
    assert [url for url in four.requests if not url.startswith(("file:", "data:"))] == []
    assert len([url for url in four.requests if url.startswith("file:")]) == 1
    assert four.complaints == []


@needs_chromium
def test_without_webgl_it_says_so_politely(tmp_path: Path) -> None:
    path = tmp_path / "top.html"
    path.write_text(page(MODEL, [Show("spin", SPIN)], 50), encoding="utf-8")
    poor = Browser(tmp_path / "profile", "--disable-3d-apis")
    try:
        poor.open(path)
        assert "This page draws with WebGL" in poor.evaluate(
            "document.getElementById('message').textContent"
        )
        poor.key("End")
        settle(poor)
        assert frame(poor) == FRAMES - 1  # the times still work
        assert not [c for c in poor.complaints if "exception" in c.lower()]
    finally:
        poor.close()


@needs_chromium
@pytest.mark.parametrize(
    ("axis", "angle", "camera"),
    [
        ((1, 0, 0), np.pi / 3, (0, 10)),  # seen from +x with y to the right, it leans to −y
        ((0, 0, 1), np.pi / 2, (-90, 88.8)),  # seen from above, its yellow half y > 0 comes to −x
    ],
)
def test_it_turns_the_way_the_quaternions_do(
    browser: Browser, tmp_path: Path, axis, angle, camera
) -> None:
    path = tmp_path / "turned.html"
    turned = [Show("", about(axis, np.full(3, angle)))]
    text = page(Model(ring=60, bands=2), turned, 50, camera=camera, background="#ffffff")
    path.write_text(text, encoding="utf-8")
    opened(browser, path)
    columns = np.nonzero(yellow(browser.picture()))[1]
    assert len(columns) > 500
    assert columns.mean() < 380  # the middle is at 400
