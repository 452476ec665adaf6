"""Every console block of README and docs prints what it shows."""

import pytest

from tests.docs.console import PAGES, ROOT, agrees, blocks, run
from tests.subcases import slow


def shown(page):
    return [line for block in blocks(page.read_text("utf-8")) for line in block if line.words]


SLOW = ("cluster",)  # of pages, since it starts a cluster


@pytest.mark.parametrize(
    "page",
    [slow(page) if page.stem in SLOW else page for page in PAGES if shown(page)],
    ids=lambda page: page.stem,
)
def test_the_page_shows_what_is_printed(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("COLUMNS", raising=False)
    wrong = []
    for line in shown(page):
        printed = run(line.words)
        if line.printed and not agrees(line.printed, printed):
            wrong.append(f"$ {line.typed}\n{printed}")
    assert not wrong, "python scripts/refresh_pages.py writes what is printed now:\n" + "\n".join(
        wrong
    )


def test_what_is_elided_may_be_anything_and_nothing_else():
    assert agrees("a\n…\nd\n", "a\nb\nc\nd\n")
    assert agrees("a\n…\n", "a\nb\n")
    assert not agrees("a\n…\nd\n", "a\nb\nc\n")
    assert not agrees("a\nb\n", "a\nb\nc\n")


def test_the_pages_are_all_looked_at():
    assert ROOT / "docs" / "reference" / "language.md" in PAGES
    assert sum(len(shown(page)) for page in PAGES) > 25
