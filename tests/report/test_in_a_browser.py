"""The page in headless Chromium: filters, certificates, keyboard, phone, and what axe-core finds."""

import json

import pytest

from tests.anim.chromium import CHROMIUM, Browser, axe_core

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine"),
]
SERIOUS = """axe.run(document, {resultTypes: ["violations"]}).then((found) => found.violations
  .filter((one) => ["serious", "critical"].includes(one.impact))
  .map((one) => [one.id, one.nodes.map((node) => node.html.slice(0, 200))]))"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    browser = Browser(tmp_path_factory.mktemp("profile"))
    yield browser
    browser.close()


@pytest.fixture
def opened(browser, html, tmp_path):
    path = tmp_path / "report.html"
    path.write_text(html, encoding="utf-8")
    browser.requests.clear()
    browser.open(path)
    yield browser
    assert browser.complaints == []
    assert all(url.startswith(("file:", "data:", "blob:")) for url in browser.requests)


def choose(browser, name, value):
    browser.evaluate(
        f"place('{name}').value = {json.dumps(value)};"
        f"place('{name}').dispatchEvent(new Event('input', {{bubbles: true}}))"
    )
    script = "[...document.querySelectorAll('{}')].filter((x) => !x.closest('[hidden]')).map((x) => x.{})"
    claims = browser.evaluate(script.format("article", "id"))
    lines = browser.evaluate(script.format(".matrix tr[data-id]", "dataset.id"))
    assert claims == lines
    return [name.removeprefix("claim-") for name in claims]


def test_the_filter(opened):
    assert choose(opened, "section", "1") == ["L1", "L2"]
    assert choose(opened, "verdict", "refuted") == ["L2"]
    assert choose(opened, "field", "GF(2)") == []
    assert choose(opened, "verdict", "proved") == ["L1", "L2"]
    assert opened.evaluate("place('shown').textContent") == "2 of 4 claims shown"
    shown = "[...heads].filter((head) => !head.hidden).map((head) => head.dataset.f ?? '')"
    assert opened.evaluate(shown) == ["", "GF(2)"]
    opened.evaluate("form.reset(); new Promise((done) => setTimeout(done, 50))")
    assert choose(opened, "search", "HAMILTON") == ["L4"]


def test_a_link_to_a_hidden_claim_shows_it(opened):
    choose(opened, "verdict", "refuted")
    opened.evaluate("location.hash = 'claim-L1'; new Promise((done) => setTimeout(done, 100))")
    assert opened.evaluate(
        "!place('claim-L1').hidden && place('claim-L1').querySelector('details').open"
    )


def test_a_button_saves_its_certificate(opened):
    name, text = opened.evaluate("""new Promise((done) => {
      let kept;
      URL.createObjectURL = (blob) => { kept = blob; return "#claims"; };
      HTMLAnchorElement.prototype.click = function () {
        kept.text().then((text) => done([this.download, text]));
      };
      const button = document.querySelector("#claim-L2 button[data-f=F9]");
      button.dispatchEvent(new Event("click", { bubbles: true }));
    })""")
    assert name == "L2.F9.json"
    assert json.loads(text)["field"] == "GF(9)"
    assert json.loads(text)["verdict"] == "refuted"


def test_the_first_key_reaches_the_link_that_skips(opened):
    opened.key("Tab")
    assert opened.evaluate("document.activeElement.className") == "skip"
    opened.key("Tab")
    assert opened.evaluate("document.activeElement.closest('nav') !== null")
    outline = opened.evaluate("getComputedStyle(document.activeElement).outlineStyle")
    assert outline != "none"


def test_nothing_is_wider_than_a_phone(opened):
    sizes = {"width": 390, "height": 844, "deviceScaleFactor": 1}
    opened.send("Emulation.setDeviceMetricsOverride", **sizes, mobile=True)
    opened.evaluate("for (const one of document.querySelectorAll('details')) one.open = true")
    assert opened.evaluate("document.documentElement.scrollWidth") == 390
    sizes |= {"width": 800, "height": 600}
    opened.send("Emulation.setDeviceMetricsOverride", **sizes, mobile=False)


def test_the_matrix_shows_that_it_is_cut(opened):
    sizes = {"width": 250, "height": 600, "deviceScaleFactor": 1}
    opened.send("Emulation.setDeviceMetricsOverride", **sizes, mobile=False)
    opened.wait("document.querySelector('.tall').classList.contains('cut')")
    mask = opened.evaluate("getComputedStyle(document.querySelector('.tall')).maskImage")
    assert mask.startswith("linear-gradient")
    opened.evaluate("document.querySelector('.tall').scrollLeft = 10000")
    opened.wait("!document.querySelector('.tall').classList.contains('cut')")
    sizes |= {"width": 800}
    opened.send("Emulation.setDeviceMetricsOverride", **sizes, mobile=False)


@pytest.fixture(scope="module")
def axe():
    return axe_core()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious(opened, axe, scheme):
    feature = {"name": "prefers-color-scheme", "value": scheme}
    opened.send("Emulation.setEmulatedMedia", features=[feature])
    opened.evaluate("for (const one of document.querySelectorAll('details')) one.open = true")
    opened.evaluate(f"{axe};1")
    assert opened.evaluate(SERIOUS) == []
    opened.send("Emulation.setEmulatedMedia", features=[])
