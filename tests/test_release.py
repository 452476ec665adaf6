"""What a release says of itself: one version everywhere, and every dependency with its licence."""

import re
import tomllib
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

import hfield

ROOT = Path(__file__).parent.parent
LINK = re.compile(r"\]\(([^)\s]*)\)")
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


@pytest.fixture
def for_an_index():
    """The function that the build asks for the README of an index."""
    spec = spec_from_file_location("hatch_build", ROOT / "hatch_build.py")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.for_an_index


def test_on_an_index_the_readme_has_no_link_that_leads_nowhere(for_an_index):
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    shown = for_an_index(readme)
    assert all(address.startswith("https://") for address in LINK.findall(shown))
    assert "](" not in shown.replace("](https://", "")
    assert "hfield docs" in shown.partition("## ")[0]
    for text, address in re.findall(r"(?<!!)\[([^][]*)\]\(([^)\s]*)\)", readme):
        assert text in shown, address
    assert "algebras [a,b|F) of characteristic 2" in shown  # brackets that are no link stay
    blocks = re.compile(r"```.*?```", re.S)
    assert blocks.findall(shown) == blocks.findall(readme)


def test_what_the_readme_shows_travels_in_the_source_distribution():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    include = PROJECT["tool"]["hatch"]["build"]["targets"]["sdist"]["include"]
    addresses = [one for one in LINK.findall(readme) if not one.startswith("https://")]
    assert any(one.endswith(".webp") for one in addresses)
    for address in addresses:
        assert (ROOT / address).is_file()
        assert "/" + address.split("/")[0] in [*include, "/LICENSE"], address
