"""What rotation and anim bring to the report."""

import pytest

from anim.report import top
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


@pytest.mark.parametrize("language", ["en", "pl"])
def test_the_top_stands_in_a_frame_of_its_own(language):
    chapter = top(language)
    Outline(chapter.body)
    assert chapter.body.count("<iframe srcdoc=") == 1
    assert "<canvas" not in chapter.body  # it is escaped, in the frame
