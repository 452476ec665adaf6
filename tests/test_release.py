"""What a release says of itself: one version everywhere, and every dependency with its licence."""

import re
import tomllib
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

import hfield
from hfield.cli import catalogue

ROOT = Path(__file__).parent.parent
LINK = re.compile(r"\]\(([^)\s]*)\)")
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def read(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def test_version_and_date_are_those_of_changelog_citation_and_what_is_new():
    headings = re.findall(r"^## \[(\S+)\](?: - (\S+))?$", read("CHANGELOG.md"), re.M)
    assert headings[0] == ("Unreleased", "")
    version, date = headings[1]
    assert version == hfield.__version__
    assert f"\nversion: {version}\n" in read("CITATION.cff")
    assert f'\ndate-released: "{date}"\n' in read("CITATION.cff")
    minor = version.rpartition(".")[0]
    assert read("docs/new.md").startswith(f"# What is new in {minor}\n")
    assert f"[what is new in {minor}](new.md)" in read("docs/index.md")


def test_the_version_stands_in_one_place():
    assert "version" in PROJECT["project"]["dynamic"]
    assert PROJECT["tool"]["hatch"]["version"]["path"] == "hfield/__init__.py"
    for package in "hfield", "rotation", "anim":
        holders = [p for p in (ROOT / package).rglob("*.py*") if p.suffix in {".py", ".pyi"}]
        texts = [p.name for p in holders if f'"{hfield.__version__}"' in p.read_text("utf-8")]
        assert texts == (["__init__.py"] if package == "hfield" else [])


def test_what_is_new_is_read_in_a_minute():
    words = len(re.sub(r"```.*?```", "", read("docs/new.md"), flags=re.S).split())
    assert 100 < words < 300


def test_the_page_on_versions_has_every_schema():
    code = {
        schema
        for package in ("hfield", "rotation", "anim")
        for path in (ROOT / package).rglob("*.py")
        for schema in re.findall(r"\"(hfield-[a-z-]+/\d)\"", path.read_text(encoding="utf-8"))
    }
    page = set(re.findall(r"`(hfield-[a-z-]+/\d)`", read("docs/releases.md")))
    of_commands = {f"hfield-{name}/1" for name in catalogue.names()}
    assert page <= code
    assert {"hfield-cert/1", "hfield-cert/2", "hfield-ledger/1"} <= code - of_commands
    assert code - of_commands <= page


def test_each_dependency_has_a_row_with_its_licence():
    page = read("docs/developers/installed.md")
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
    readme = read("README.md")
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
    readme = read("README.md")
    include = PROJECT["tool"]["hatch"]["build"]["targets"]["sdist"]["include"]
    addresses = [one for one in LINK.findall(readme) if not one.startswith("https://")]
    assert any(one.endswith(".webp") for one in addresses)
    for address in addresses:
        assert (ROOT / address).is_file()
        assert "/" + address.split("/")[0] in [*include, "/LICENSE"], address
