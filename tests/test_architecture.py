"""The map in docs/architecture.md: every room is on it, and every room on it is there."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
PACKAGES = ("hfield", "rotation", "anim")


def rows(package: str) -> list[list[str]]:
    """The cells of the table of a package's rooms."""
    part = PAGE.split(f"## The rooms of {package}")[1].split("\n## ")[0]
    return [line.split("|")[1:-1] for line in part.splitlines() if line.startswith("| `")]


def names(text: str) -> set[str]:
    return {name.rstrip("/") for name in re.findall(r"`(\w+/?)`", text)}


def modules(folder: Path) -> set[str]:
    """The rooms in a folder, and its modules: what a stranger sees there."""
    found = {path.stem for path in folder.glob("*.py") if not path.stem.startswith("__")}
    return found | rooms(folder)


def rooms(folder: Path) -> set[str]:
    return {path.parent.name for path in folder.glob("*/__init__.py")}


@pytest.mark.parametrize("package", PACKAGES)
def test_the_rooms_of_a_package(package: str) -> None:
    told: set[str] = set().union(*(names(row[0]) for row in rows(package)))
    assert told == modules(ROOT / package)


@pytest.mark.parametrize("package", PACKAGES)
def test_the_rooms_inside_rooms(package: str) -> None:
    for row in rows(package):
        for name in names(row[0]):
            missing = rooms(ROOT / package / name) - names(row[1])
            assert not missing, f"the row of {package}/{name} does not speak of {sorted(missing)}"
