"""The page that checks certificates in the reader's browser: what it says is what ``hfield check`` says.

Needs Chromium, and the site with Pyodide beside it (``npm install --prefix docs/_build pyodide``,
``python tasks.py docs``).
"""

import json
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import pytest

from hfield.checker.check import check
from tests.anim.chromium import CHROMIUM, Browser

SITE = Path(__file__).parents[2] / "hfield" / "site"
pytestmark = pytest.mark.skipif(
    CHROMIUM is None or not (SITE / "check" / "pyodide.mjs").is_file(),
    reason="needs Chromium and the site with Pyodide",
)


class Quiet(SimpleHTTPRequestHandler):
    def guess_type(self, path: object) -> str:
        return "text/javascript" if str(path).endswith(".mjs") else super().guess_type(str(path))

    def log_message(self, *words: object) -> None:
        pass


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=SITE))
    Thread(target=server.serve_forever, daemon=True).start()
    browser = Browser(tmp_path_factory.mktemp("profile"))
    browser.send("Page.navigate", url=f"http://127.0.0.1:{server.server_port}/check.html")
    browser.wait("document.querySelector('#checker [role=status]')?.textContent.includes('ready')")
    yield browser
    browser.close()
    server.shutdown()
    server.server_close()


def dropped(page: Browser, name: str, text: str) -> tuple[str, str]:
    """Drop a file; return the verdict and what is said of it."""
    page.evaluate(
        f"""(() => {{
          const files = new DataTransfer();
          files.items.add(new File([{json.dumps(text)}], {json.dumps(name)}));
          document.getElementById("checker").dispatchEvent(new DragEvent("drop", {{ dataTransfer: files }}));
        }})()"""
    )
    page.wait(
        f"document.querySelector('#checker li strong')?.textContent.startsWith({json.dumps(name)})"
    )
    verdict = page.evaluate("document.querySelector('#checker li').dataset.verdict")
    return verdict, page.evaluate("document.querySelector('#checker li pre').textContent")


@pytest.mark.parametrize("name", sorted(path.name for path in SITE.glob("check/*.json")
                                        if path.name != "pyodide-lock.json"))  # fmt: skip
def test_certificates_of_the_site_are_accepted(page: Browser, name: str) -> None:
    page.evaluate(f"document.querySelector('[data-certificate=\"{name[:-5]}\"]').click()")
    page.wait(f"document.querySelector('#checker li strong')?.textContent.startsWith({name!r})")
    assert page.evaluate("document.querySelector('#checker li').dataset.verdict") == "accepted"
    said = page.evaluate("document.querySelector('#checker li pre').textContent")
    assert said == str(check(json.loads((SITE / "check" / name).read_text())))


def test_a_broken_one_is_rejected_and_nothing_is_fetched_from_elsewhere(page: Browser) -> None:
    text = (SITE / "check" / "associative.json").read_text()
    verdict, said = dropped(page, "false.json", text.replace("(p*q)*r", "(q*p)*r"))
    assert verdict == "rejected", said
    verdict, said = dropped(page, "no.json", "{")
    assert verdict == "rejected", said
    outside = [url for url in page.requests if url.startswith("http") and "//127.0.0.1:" not in url]
    assert not outside
