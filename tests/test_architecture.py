"""The map in docs/architecture.md: every room is on it, and every room on it is there. Their sizes."""

import re
from collections import defaultdict
from pathlib import Path

import pytest

from tests.test_layers import imports, sources

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
PACKAGES = ("hfield", "rotation", "anim")
# Rooms whose modules are alike and found by their names: as many as there are commands, chapters, kinds.
LISTS = {"commands", "evidence", "formats", "ledger", "styles", "vocabulary", "ways"}
MOST_MODULES = 25
LARGE = {"rotation": 42}  # its public modules; it may not grow
SMALL = 80  # lines
MOST_LONELY = 19


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
    told = [name for row in rows(package) for name in names(row[0])]
    assert sorted(told) == sorted(modules(ROOT / package))  # each once


@pytest.mark.parametrize("package", PACKAGES)
def test_the_rooms_inside_rooms(package: str) -> None:
    for row in rows(package):
        for name in names(row[0]):
            missing = rooms(ROOT / package / name) - names(row[1])
            assert not missing, f"the row of {package}/{name} does not speak of {sorted(missing)}"


def test_no_room_is_too_large() -> None:
    found: dict[str, int] = defaultdict(int)
    for package in PACKAGES:
        for path in (ROOT / package).rglob("*.py"):
            if not path.stem.startswith("__") and path.parent.name not in LISTS:
                found[path.parent.relative_to(ROOT).as_posix()] += 1
    assert found["hfield/algebra"]
    assert not {room: n for room, n in found.items() if n > LARGE.get(room, MOST_MODULES)}


def lonely() -> set[str]:
    """Return the small modules that one other alone imports, unless that is the face of their room."""
    readers: dict[str, set[str]] = defaultdict(set)
    for module, source in sources():
        for target in imports(source, module):
            readers[target].add(module)
    found = set()
    for module, source in sources():
        *rooms_around, _ = module.split(".")
        is_face = (ROOT / module.replace(".", "/")).is_dir()
        by_face = readers[module] == {".".join(rooms_around)}
        if len(readers[module]) == 1 and not (is_face or by_face or LISTS & {*rooms_around}):
            found |= {module} if source.count("\n") < SMALL else set()
    return found


def test_few_small_modules_are_read_in_one_place_alone() -> None:
    assert len(lonely()) <= MOST_LONELY, sorted(lonely())
