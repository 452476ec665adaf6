"""The pages by keyboard alone, and before axe-core, which looks for what keeps people out.

They are light and dark, wide and narrow. `scripts/install_judges.sh` brings axe-core.
"""

from pathlib import Path

import pytest

from anim.model import Model
from anim.physics import Body, FreeTop
from anim.physics.films import STORY
from anim.viewer import Curve, Show, page, seeing
from tests.anim.chromium import Browser, axe_core
from tests.anim.test_viewer import SPIN, needs_chromium, settle

pytestmark = [pytest.mark.slow, needs_chromium]
TOP = FreeTop(Body.turned(Model().profile), STORY[0], 10.0, STORY[1])


@pytest.fixture(scope="module")
def axe() -> str:
    return axe_core()


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory):
    found = Browser(tmp_path_factory.mktemp("profile"), size=(1000, 700))
    yield found
    found.close()


def pages() -> dict[str, str]:
    four = [Show(name, SPIN) for name in "abcd"]
    model = Model(ring=60)
    return {
        "live": page(model, four, 50, simulation=TOP),
        "films": page(model, four, 50, curves=[Curve("tilt", range(len(SPIN)), "°")]),
        "seeing": seeing(),
    }


@pytest.mark.parametrize("name", ["live", "films", "seeing"])
def test_nothing_is_complained_of(browser: Browser, axe: str, tmp_path: Path, name: str) -> None:
    path = tmp_path / f"{name}.html"
    path.write_text(pages()[name], encoding="utf-8")
    for scheme in ("light", "dark"):
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        browser.send("Emulation.setEmulatedMedia", features=features)
        for width, height in ((1000, 700), (390, 800)):
            size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500}
            browser.send("Emulation.setDeviceMetricsOverride", **size)
            browser.open(path)
            settle(browser)
            browser.evaluate(f"{axe}; 0")
            found = browser.evaluate(
                "axe.run().then(({ violations, passes }) => [passes.length, violations.map("
                "({ id, impact, nodes }) => `${impact}: ${id}: ${nodes.map((n) => n.html).join(' ')}`)])"
            )
            assert found[0] > 10
            assert found[1] == []


FOCUSED = """(() => { const e = document.activeElement;
  const box = e.getBoundingClientRect(), s = getComputedStyle(e);
  const at = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
  return [window.controls.indexOf(e), s.outlineStyle !== 'none' && parseFloat(s.outlineWidth) >= 2,
    box.bottom <= innerHeight + 1 && box.top >= -1
      && (e === at || e.contains(at) || e.id === 'view')]; })()"""


def tab(browser: Browser, shift: bool = False) -> None:
    for kind in ("rawKeyDown", "keyUp"):
        code = {"key": "Tab", "code": "Tab", "windowsVirtualKeyCode": 9}
        browser.send("Input.dispatchKeyEvent", type=kind, modifiers=8 if shift else 0, **code)


@pytest.mark.parametrize("name", ["live", "films", "seeing"])
@pytest.mark.parametrize("size", [(1000, 700), (360, 640)])
def test_tab_walks_over_all_that_can_be_used(
    browser: Browser, tmp_path: Path, name: str, size: tuple[int, int]
) -> None:
    """Each control once, in the order of the page, seen on the screen and marked; backwards too."""
    path = tmp_path / f"{name}.html"
    path.write_text(pages()[name], encoding="utf-8")
    view = {"deviceScaleFactor": 1, "mobile": False}
    browser.send("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], **view)
    browser.send("Page.navigate", url="about:blank")
    browser.open(path)
    count = browser.evaluate(
        "(window.controls = [...document.querySelectorAll('button, select, input, [tabindex]')]"
        ".filter((e) => !e.disabled && e.getClientRects().length)).length"
    )
    assert count >= 6
    walk = []
    for _ in range(count):
        tab(browser)
        walk.append(browser.evaluate(FOCUSED))
    assert walk == [[n, True, True] for n in range(count)]
    tab(browser, shift=True)
    assert browser.evaluate(FOCUSED)[0] == count - 2
    if name != "seeing":
        tab(browser)
        assert browser.evaluate("document.activeElement.id") == "keys"
        browser.evaluate("document.activeElement.click()")
        assert browser.evaluate("document.getElementById('help').hidden") is False
        browser.key("Escape")
        assert browser.evaluate("document.getElementById('help').hidden") is True
        assert browser.evaluate("document.activeElement.id") == "keys"


def test_the_readings_do_not_cover_the_top_of_a_phone(browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "live.html"
    path.write_text(pages()["live"], encoding="utf-8")
    size = {"width": 360, "height": 640, "deviceScaleFactor": 1, "mobile": True}
    browser.send("Emulation.setDeviceMetricsOverride", **size)
    browser.open(path)
    bottom, top, shown = browser.evaluate(
        "['view', 'readings'].map((id) => document.getElementById(id).getBoundingClientRect())"
        ".reduce((view, said) => [view.bottom, said.top, said.height])"
    )
    assert shown > 40
    assert top >= bottom - 1
