"""What a release says of itself: one version everywhere, and every dependency with its licence."""

import re
import tomllib
from pathlib import Path

import hfield

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def test_the_version_is_the_newest_of_the_changelog_and_of_the_citation():
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    versions = re.findall(r"^## \[(\S+)\]", changelog, re.M)
    assert versions[:2] == ["Unreleased", hfield.__version__]
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"\nversion: {hfield.__version__}\n" in citation


def test_each_dependency_has_a_row_with_its_licence():
    page = (ROOT / "docs" / "installed.md").read_text(encoding="utf-8")
    rows = {
        cells[1].strip(): cells for line in page.splitlines() if len(cells := line.split("|")) == 7
    }
    names = [re.match(r"[\w-]+", text)[0] for text in PROJECT["project"]["dependencies"]]
    assert len(names) > 5
    for name in names:
        assert "hfield" in rows[name][5]
        assert rows[name][4].strip()


def test_what_the_source_distribution_carries_is_there():
    include = PROJECT["tool"]["hatch"]["build"]["targets"]["sdist"]["include"]
    assert {"/tasks.py", "/CONTRIBUTING.md", "/.ci", "/CITATION.cff", "/docs", "/tests"} <= set(
        include
    )
    assert all((ROOT / name.lstrip("/")).exists() for name in include)


def test_the_face_shows_public_names_only():
    assert set(dir(hfield)) == set(hfield.__all__)
