"""The page on trust names the modules of the checker and all theorems that certificates may cite."""

import re
from pathlib import Path

from hfield.checker.glossary import THEOREMS
from tests.docs.test_tables import tables

ROOT = Path(__file__).parents[2]
CHECKER = ROOT / "hfield" / "checker"
PAGE = (ROOT / "docs" / "explanation" / "trust.md").read_text(encoding="utf-8")


def rows(head: str) -> list[str]:
    """The rows of the tables whose first cell is this one."""
    return [
        row for first, _, *more in tables(PAGE) if first.startswith(f"| {head} |") for row in more
    ]


def missing_modules(cell: str) -> list[str]:
    """The modules in a cell that do not exist; a name without a folder is in that of the name before."""
    folder, missing = "", []
    for name in re.findall(r"`([a-z_/]+)`", cell):
        folder = name.rpartition("/")[0] or folder
        path = CHECKER / folder / name.rpartition("/")[2]
        if not (path.is_dir() or path.with_suffix(".py").is_file()):
            missing.append(f"{folder}/{name}")
    return missing


def test_the_modules_of_the_tables_exist() -> None:
    cells = [row.split("|")[1] for row in rows("module")]
    assert len(cells) > 15
    assert [name for cell in cells for name in missing_modules(cell)] == []
    assert missing_modules("`orders/lattice`, `finding`") == ["orders/finding"]


def test_every_theorem_that_may_be_cited_has_a_row() -> None:
    assert len(rows("theorem")) == len(THEOREMS)
