"""The answers to open issues of other systems are computed again and compared with the page."""

from pathlib import Path

import pytest

from scripts.answer_open_issues import rows

PAGE = Path(__file__).parents[2] / "docs" / "explanation" / "open-issues.md"


@pytest.mark.slow
def test_the_page_has_the_answers_of_the_script() -> None:
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    assert [line for line in lines if line.startswith("|")] == list(rows())
