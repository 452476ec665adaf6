"""What rotation and anim bring to the report."""

import re
from base64 import b64decode
from html import unescape
from io import BytesIO

import numpy as np
import pytest
from PIL import Image

from anim.report import PLAYER, top
from anim.top import Top
from rotation.report import benchmark_html, figures
from tests.report.test_page import Outline


def result(test, way, ms, copy, ours):
    ratios = {"ratio_to_copy": copy, "ratio_to_hfield": ours}
    return {"test": test, "way": way, "status": "ok", "best_frame_ms": ms, **ratios}


MEASURED = {
    "machine": {"processor": "A <processor>", "cores": 2},
    "settings": {"points": 550000},
    "tests": [
        {"test": "1", "title": "Test 1", "printed": "434.9 s"},
        {"test": "2", "title": "Test 2", "printed": ""},
    ],
    "results": [
        result("1", "slow", 1234.5, 400.0, None),
        result("1", "fast", 1.5, 1.25, 1.0),
        {"test": "2", "way": "absent", "status": "missing"},
    ],
}


@pytest.mark.slow
@pytest.mark.parametrize("language", ["en", "pl"])
def test_the_figures_are_pictures_inside_the_page(language):
    chapter = figures(language)
    outline = Outline(chapter.body)
    assert len(outline.sources) == 5
    assert all(source.startswith("data:image/svg+xml;base64,") for source in outline.sources)
    assert chapter.body.count("alt=") == 5


def test_the_benchmark_lists_the_quickest_first():
    html = benchmark_html(MEASURED, "en")
    Outline(html)
    assert html.index("fast") < html.index("slow")
    assert "A &lt;processor&gt;" in html
    assert "absent" not in html
    assert "434.9 s" in html
    assert "<td>1.25</td>" in html
    assert "<td>1,25</td>" in benchmark_html(MEASURED, "pl")


@pytest.mark.slow
@pytest.mark.parametrize("language", ["en", "pl"])
def test_the_top_stands_in_a_frame_of_its_own(language):
    chapter = top(language)
    Outline(chapter.body)
    assert chapter.body.count("<iframe srcdoc=") == 1
    assert "<canvas" not in chapter.body  # it is escaped, in the frame
    (still,) = re.findall('class="printed" src="data:image/png;base64,([^"]*)"', chapter.body)
    picture = np.asarray(Image.open(BytesIO(b64decode(still))).convert("RGB"))
    assert picture.shape == (480, 480, 3)
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 100  # a top, not an empty sheet


def test_the_player_speaks_polish():
    """Each text that is replaced is there, and none that a reader meets is left."""
    page = Top().page()
    assert [text for text in PLAYER["pl"] if page.count(text) != 1] == []
    body = unescape(re.search('srcdoc="([^"]*)"', top("pl").body)[1])
    groups = re.findall(
        r'(?:aria-label|title)="([^"]*)"|<(?:dd|dt|title|label)>([^<]*)<|say\("([^"]*)"', body
    )
    met = {text.strip() for found in groups for text in found if len(text.strip()) > 2}
    ours = " ".join(PLAYER["pl"].values())
    assert len(met) > 15
    worded = {text for text in met if re.search("[a-z]{3}", text)}
    assert {text for text in worded if text not in ours} == {"home, end"}  # names of keys


def test_what_the_benchmark_says_is_said_in_polish():
    """Each title and each printed time has a translation, so none of the bench's words is left over."""
    from rotation.bench.tasks import TESTS

    tests = [{"test": t.name, "title": t.title, "printed": t.printed} for t in TESTS]
    html = benchmark_html(MEASURED | {"tests": tests, "results": []}, "pl")
    for test in TESTS:
        assert test.title not in html
        assert not test.printed or test.printed not in html
    assert "jedna oś" in html
    assert "434,9 s na przebieg z kwaternionami" in html
