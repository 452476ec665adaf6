"""The pages before axe-core, which looks for what keeps people out: in light and dark, wide and narrow.

It is found where node finds it: `npm install --no-save axe-core`, or a folder in NODE_PATH.
"""

import shutil
import subprocess
from pathlib import Path

import pytest

from anim.model import Model
from anim.physics import Body, FreeTop
from anim.physics.simulate import STORY
from anim.viewer import Curve, Show, page, seeing
from tests.anim.chromium import Browser
from tests.anim.test_viewer import SPIN, needs_chromium, settle

pytestmark = needs_chromium
TOP = FreeTop(Body.turned(Model().profile), STORY[0], 10.0, STORY[1])
FIND = "process.stdout.write(require.resolve('axe-core/axe.min.js', { paths: [process.cwd()] }))"


@pytest.fixture(scope="module")
def axe() -> str:
    node = shutil.which("node")
    found = node and subprocess.run([node, "-e", FIND], capture_output=True, text=True, timeout=60)
    if not found or found.returncode:
        pytest.skip("needs axe-core (npm install --no-save axe-core)")
    return Path(found.stdout).read_text(encoding="utf-8")


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
