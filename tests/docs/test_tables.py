"""Tables of the pages keep their text: a bar inside a cell is written with a backslash."""

import re
from pathlib import Path

from scripts import list_methods
from tests.subcases import subcases

ROOT = Path(__file__).parents[2]
BAR = re.compile(r"(?<!\\)\|")


def tables(text: str) -> list[list[str]]:
    """The tables of a page: lines that follow each other and begin with a bar, outside blocks of code."""
    prose = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    found = re.findall(r"(?:^\|.*\n)+", prose + "\n", re.M)
    return [table.splitlines() for table in found]


def torn(text: str) -> list[str]:
    """The rows that have not as many cells as the head of their table."""
    return [
        row
        for head, *rows in tables(text)
        for row in rows
        if len(BAR.findall(row)) != len(BAR.findall(head))
    ]


@subcases("page", [ROOT / "README.md", *sorted((ROOT / "docs").glob("**/*.md"))])
def test_no_row_is_torn(page: Path) -> None:
    assert torn(page.read_text(encoding="utf-8")) == []


def test_the_table_of_methods_is_that_of_the_code() -> None:
    """``python tasks.py methods`` writes it."""
    page = list_methods.PAGE.read_text(encoding="utf-8")
    assert list_methods.written(page) == page
    assert page.count("`O.is_gorenstein()`") == 1


def test_torn_rows_are_found() -> None:
    assert torn("| a | b |\n|---|---|\n| `x|y` | z |\n") == ["| `x|y` | z |"]
    assert not torn("| a | b |\n|---|---|\n| `x\\|y` | z |\n")
