"""The page that simulates, in a browser: every control, by mouse and by keys."""

from html import escape
from math import degrees
from pathlib import Path
from urllib.parse import parse_qs

import numpy as np
import pytest

from anim.model import Model
from anim.physics import Body, Contact, FreeTop, HeavyTop, Launch
from anim.viewer import Show, page
from tests.anim.chromium import Browser
from tests.anim.test_viewer import SPIN, needs_chromium, settle, yellow

pytestmark = [pytest.mark.slow, needs_chromium]
TOP = HeavyTop(Body.turned(Model().profile), Launch(), 10.0)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory):
    found = Browser(tmp_path_factory.mktemp("profile"), size=(1000, 700))
    yield found
    found.close()


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("page") / "top.html"
    path.write_text(page(Model(ring=200), [Show(n, SPIN) for n in "abcd"], 50, simulation=TOP))
    return path


@pytest.fixture
def live(browser: Browser, file: Path) -> Browser:
    """The page, paused where its top starts."""
    browser.complaints.clear()
    browser.send("Page.navigate", url="about:blank")
    browser.open(file)
    if browser.evaluate("player.playing"):
        browser.key(" ")
    browser.key("Home")
    settle(browser)
    return browser


def slide(browser: Browser, name: str, value: float) -> None:
    browser.evaluate(
        f"(() => {{ const s = document.querySelector('[name={name}]'); s.value = {value};"
        " s.dispatchEvent(new Event('input')); })()"
    )


def click(browser: Browser, name: str) -> None:
    browser.evaluate(f"document.getElementById('{name}').click()")


def state(browser: Browser) -> list[float]:
    return browser.evaluate("[...player.simulator.state.q, ...player.simulator.state.w]")


def test_the_file_is_small_and_asks_for_nothing(live: Browser, file: Path) -> None:
    assert file.stat().st_size < 200_000
    assert [url for url in live.requests if not url.startswith(("file:", "data:", "about:"))] == []
    picture = live.picture()
    assert yellow(picture).sum() > 2000
    assert live.complaints == []


def test_it_goes_as_python_says_however_the_screen_is_drawn(live: Browser) -> None:
    for seconds in (0.013, 0.5, 0.2, 0.7, 0.4, 0.3):
        live.evaluate(f"player.simulator.advance({seconds})")
    time = live.evaluate("player.simulator.time")
    assert time > 2
    np.testing.assert_allclose(state(live), TOP.states(np.array([time]))[0], atol=1e-6)


def test_it_falls_when_python_says_and_starts_again(live: Browser) -> None:
    for _ in range(30):
        live.evaluate("player.simulator.advance(0.4)")
    assert live.evaluate("player.simulator.landed") == pytest.approx(TOP.landed, abs=1e-6)
    settle(live)
    live.evaluate("player.draw()")
    assert "fallen" in live.evaluate("document.getElementById('readings').textContent")
    live.key("l")
    assert live.evaluate("[player.simulator.landed, player.playing]") == [None, True]


def test_every_slider_does_what_it_says(live: Browser) -> None:
    slide(live, "spin", 45)
    assert state(live)[6] == 45
    slide(live, "tilt", 20)
    assert degrees(2 * np.arcsin(np.hypot(*state(live)[1:3]))) == pytest.approx(20)
    slide(live, "friction", 0)
    before = live.evaluate(
        "quantities(player.simulator.state, player.simulator.body, 9.80665).energy"
    )
    slide(live, "gravity", 9.80665)
    live.evaluate("player.simulator.advance(0.5)")
    after = live.evaluate(
        "quantities(player.simulator.state, player.simulator.body, player.simulator.set.gravity).energy"
    )
    assert after == pytest.approx(before, rel=1e-3)
    slide(live, "friction", 5)
    live.evaluate("player.simulator.advance(0.5)")
    assert state(live)[6] < 45 * 0.95
    settle(live)
    narrow = yellow(live.picture()).sum()
    slide(live, "width", 1.4)
    settle(live)
    assert yellow(live.picture()).sum() > 1.2 * narrow
    slide(live, "tilt", 40)  # the rim of so wide a top is on the ground before that
    assert live.evaluate("player.simulator.landed") is None
    assert live.evaluate("player.simulator.set.tilt") < degrees(
        live.evaluate("player.simulator.body.reach")
    )


def test_a_pull_moves_the_top_and_beside_it_the_view(live: Browser) -> None:
    looked = live.evaluate("player.camera.azimuth")
    x, y = live.evaluate(
        "(([x, y], {clientWidth: w, clientHeight: h}) => [(x + 1) / 2 * w, (1 - y) / 2 * h])"
        "(projected(player.simulator.matrix, [0, 0, 1.2]), document.getElementById('view'))"
    )
    live.mouse("Pressed", x, y, button="left", buttons=1, clickCount=1)
    live.mouse("Moved", x + 90, y, button="left", buttons=1)
    assert live.evaluate("player.simulator.pulled !== null")
    before = state(live)
    live.evaluate("player.simulator.advance(0.1)")
    pulled = live.evaluate("player.simulator.pulled")
    live.mouse("Released", x + 90, y, button="left", clickCount=1)
    free = TOP.states(np.array([live.evaluate("player.simulator.time")]))[0]
    assert pulled is not None
    assert np.abs(np.array(state(live)) - free).max() > 0.02
    assert state(live) != before
    assert live.evaluate("player.simulator.pulled") is None
    assert live.evaluate("player.camera.azimuth") == looked
    live.drag((60, 500), (160, 500))
    assert live.evaluate("player.camera.azimuth") != looked


def test_with_a_tip_of_some_radius_it_slips_and_goes_on_after_its_fall(live: Browser) -> None:
    assert live.evaluate("document.querySelector('[name=grip]').disabled") is True
    slide(live, "spin", 30)
    slide(live, "tip", 5)
    slide(live, "grip", 0.2)
    live.evaluate("player.simulator.advance(0.6)")
    contact = Contact(0.05, 0.2, live.evaluate("player.simulator.ground.rolling"))
    top = FreeTop(TOP.body, Launch(spin=30.0), 1.0, contact)
    found = live.evaluate("[...player.simulator.state.y]")
    time = live.evaluate("player.simulator.time")
    np.testing.assert_allclose(found, top.states(np.array([time]))[0], atol=1e-9)
    click(live, "push")
    assert state(live)[4] > found[4] + 0.5
    click(live, "share")
    link, place = live.evaluate("location.href"), live.evaluate("[...player.simulator.state.y]")
    live.send("Page.navigate", url="about:blank")
    live.send("Page.navigate", url=link)
    live.wait("document.readyState === 'complete' && location.protocol === 'file:'")
    settle(live)
    assert live.evaluate("[...player.simulator.state.y]") == pytest.approx(place)
    slide(live, "spin", 8)
    for _ in range(8):
        live.evaluate("player.simulator.advance(0.4)")
    fell = live.evaluate("player.simulator.landed")
    assert 0.2 < fell < live.evaluate("player.simulator.time") - 0.5
    settle(live)
    live.evaluate("player.draw()")
    assert "lost" in live.evaluate("document.getElementById('readings').textContent")
    assert yellow(live.picture()).sum() > 2000
    assert live.complaints == []


def test_a_push_turns_the_momentum(live: Browser) -> None:
    before = state(live)
    click(live, "push")
    assert state(live)[:4] == before[:4]
    assert state(live)[4] > before[4] + 0.5


def test_the_link_shows_what_was_seen(live: Browser, file: Path) -> None:
    slide(live, "spin", 40)
    slide(live, "width", 0.8)
    live.evaluate("player.simulator.advance(0.7)")
    live.evaluate("player.orbit(0.3, 0.1)")
    click(live, "share")
    seen, link = state(live), live.evaluate("location.href")
    words = parse_qs(link.partition("#")[2])
    assert words["spin"] == ["40"]
    assert words["width"] == ["0.8"]
    live.send("Page.navigate", url="about:blank")
    live.send("Page.navigate", url=link)
    live.wait("document.readyState === 'complete' && location.protocol === 'file:'")
    settle(live)
    assert live.evaluate("player.playing") is False
    np.testing.assert_allclose(state(live), seen, atol=1e-15)
    assert live.evaluate("player.simulator.set.width") == 0.8
    turned = live.evaluate("player.camera.azimuth - data.camera.azimuth")
    assert turned == pytest.approx(-0.3, abs=1e-3)


def test_the_link_carries_losses_the_fall_and_the_path(live: Browser) -> None:
    slide(live, "tip", 5)
    slide(live, "spin", 8)
    for _ in range(8):
        live.evaluate("player.simulator.advance(0.4)")
    numbers = "[player.simulator.landed, player.simulator.state.y[13], player.simulator.time]"
    path = "[...player.simulator.trace.slice(3 * player.simulator.traced - 3, 3 * player.simulator.traced)]"
    before, end = live.evaluate(numbers), live.evaluate(path)
    assert before[0] is not None
    assert before[1] > 0
    click(live, "share")
    link = live.evaluate("location.href")
    assert len(link) < 8000
    live.send("Page.navigate", url="about:blank")
    live.send("Page.navigate", url=link)
    live.wait("document.readyState === 'complete' && location.protocol === 'file:'")
    settle(live)
    assert live.evaluate(numbers) == pytest.approx(before)
    assert live.evaluate(path) == pytest.approx(end, abs=1e-3)
    assert 20 < live.evaluate("player.simulator.traced") <= 120
    assert "fallen" in live.evaluate("document.getElementById('readings').textContent")
    assert "J" in live.evaluate("document.getElementById('readings').innerText.split('lost')[1]")


def test_a_frame_without_an_address_has_no_link(live: Browser, file: Path, tmp_path: Path) -> None:
    outer = tmp_path / "notebook.html"
    inner = escape(file.read_text(encoding="utf-8"))
    outer.write_text(
        f'<meta charset="utf-8"><iframe srcdoc="{inner}" width="900" height="480"></iframe>'
    )
    live.open(outer)
    inside = "document.querySelector('iframe').contentDocument"
    live.wait(f"{inside}?.querySelectorAll('#sliders label').length > 0")
    assert live.evaluate(f"{inside}.getElementById('share').hidden")
    live.open(file)
    assert not live.evaluate("document.getElementById('share').hidden")


def test_no_two_buttons_share_a_name(browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "one.html"
    path.write_text(page(Model(ring=60), [Show("a", SPIN)], 50, simulation=TOP))
    browser.open(path)
    for _ in range(2):  # live, and the film
        names = browser.evaluate(
            "[...document.querySelectorAll('button')].map((b) => b.ariaLabel || b.textContent)"
        )
        assert len(set(names)) == len(names) > 5
        click(browser, "mode")


def test_arrows_are_hidden_behind_the_top(live: Browser) -> None:
    slide(live, "tilt", 0)
    settle(live)
    green = """(() => { player.draw();
        const g = player.gl, v = document.getElementById('view'), p = new Uint8Array(4 * v.width * v.height);
        g.readPixels(0, 0, v.width, v.height, g.RGBA, g.UNSIGNED_BYTE, p);
        let n = 0;
        for (let k = 0; k < p.length; k += 4) n += p[k] < p[k + 1] / 2 && p[k + 2] < p[k + 1];
        return n; })()"""
    seen = live.evaluate(green)
    live.evaluate("player.scene.top.count = 0")  # without the top the whole arrow is seen
    assert live.evaluate(green) > 2 * max(seen, 1)


@pytest.mark.parametrize(
    "words",
    [
        "spin=1e999&width=x",
        "path=1,2,3&fell=x&q=1,0,0,0&w=0,0,9",
        "q=0,0,0,0&w=1,1,1",
        "q=1,2&w=&t=zz",
        "view=1,2,1e9&tilt=-7",
    ],
)
def test_a_broken_link_still_makes_a_top(live: Browser, file: Path, words: str) -> None:
    live.evaluate(f"location.hash = '{words}'")
    settle(live)
    live.evaluate("player.simulator.advance(0.1)")
    settle(live)
    assert np.isfinite(state(live)).all()
    assert 4 <= live.evaluate("player.camera.distance") <= 40
    assert live.complaints == []


def test_the_films_are_beside_it(live: Browser) -> None:
    live.key("m")
    settle(live)
    labels = "[...document.querySelectorAll('#labels span')].map((x) => !x.hidden && x.textContent)"
    assert live.evaluate(labels) == list("abcd")
    assert live.evaluate("document.getElementById('controls').hidden") is True
    click(live, "mode")
    settle(live)
    assert live.evaluate(labels) == [False] * 4


def test_keys_alone_and_names_for_a_reader_of_screens(live: Browser) -> None:
    live.key("?")
    assert live.evaluate("document.getElementById('help').hidden") is False
    live.key("Escape")
    assert live.evaluate("document.getElementById('help').hidden") is True
    before = state(live)
    live.key("ArrowRight")
    assert state(live) != before
    assert (
        live.evaluate("document.querySelectorAll('output, [aria-live], [role=status]').length") == 0
    )
    nodes = live.send("Accessibility.getFullAXTree")["nodes"]
    found = [
        (node["role"]["value"], node["name"]["value"])
        for node in nodes
        if not node.get("ignored")
        and node["role"]["value"] in ("button", "slider", "checkbox", "combobox")
    ]
    assert len(found) >= 13
    assert all(name.strip() for _, name in found)
    assert {"spin", "tilt", "tip", "friction", "damping", "gravity", "width"} <= {
        name.split(" ")[0].rstrip("0123456789.-") for role, name in found if role == "slider"
    }


@pytest.mark.parametrize("size", [(390, 800), (1000, 700), (320, 568)])
def test_it_fits_and_a_finger_finds_its_buttons(live: Browser, size: tuple[int, int]) -> None:
    view = {"deviceScaleFactor": 1, "mobile": True}
    live.send("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], **view)
    settle(live)
    wide = live.evaluate("document.documentElement.scrollWidth")
    seen = live.evaluate("document.getElementById('view').clientHeight")
    boxes = live.evaluate(
        "[...document.querySelectorAll('button:not([hidden]), select')].map((x) => x.getBoundingClientRect())"
        ".map(({width, height}) => [width, height])"
    )
    live.send(
        "Emulation.setDeviceMetricsOverride", width=1000, height=700, **{**view, "mobile": False}
    )
    settle(live)
    assert wide == size[0]
    assert seen > 0.3 * size[1]
    assert min(map(min, boxes)) >= 44


def test_a_film_is_recorded(live: Browser) -> None:
    live.evaluate(
        "HTMLAnchorElement.prototype.click = function () { window.saved = this.download; }"
    )
    click(live, "record")
    live.evaluate("new Promise((done) => setTimeout(done, 300))")
    click(live, "record")
    live.wait("window.saved === 'top.webm'")
    assert live.evaluate("document.getElementById('record').textContent") == "record"


def test_dark_paper_shows_the_black_of_the_top(live: Browser) -> None:
    live.send(
        "Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}]
    )
    settle(live)
    dark = live.picture()[20:-20, 220:640]
    live.send(
        "Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "light"}]
    )
    settle(live)
    light = live.picture()[20:-20, 220:640]
    black = light.max(axis=-1) < 40  # the black sectors
    assert black.sum() > 2000
    assert dark[black].max(axis=-1).mean() > 35


def test_a_gradient_has_no_bands(live: Browser) -> None:
    """Along a row of the ground neighbours differ where the shade changes slowly: no flat runs."""
    row = live.picture()[
        int(live.evaluate("document.getElementById('view').clientHeight")) - 60, 20:200, 1
    ]
    runs = np.diff(np.flatnonzero(np.diff(row)))
    assert len(runs) > 30
    assert runs.max() < 30
