"""Blocks of README and docs that are neither sessions of Python nor of a shell: what they say holds too."""

import re
import shlex
from collections.abc import Iterator

import pytest

from hfield import prove
from hfield.cli.catalogue import command
from tests.cli.running import run
from tests.docs.console import PAGES, ROOT
from tests.subcases import subcases

BLOCK = re.compile(r"^```([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# Sessions are run by doctest and test_console_blocks; json by tests/certificates; lean by tests/export.
KINDS = {
    "python",
    "pycon",
    "console",
    "toml",
    "json",
    "lean",
    "",
    "{toctree}",
    "{raw} html",
    "{eval-rst}",
}
SCOPES = {
    "every commutative ring": "commutative rings",
    "every field": "fields",
    "in characteristic 2": "characteristics [2]",
}
GALLERY = (ROOT / "docs" / "gallery.md").read_text(encoding="utf-8")
LANGUAGE = (ROOT / "docs" / "reference" / "language.md").read_text(encoding="utf-8")


def blocks() -> Iterator[tuple[str, str, str]]:
    for page in PAGES:
        for kind, text in BLOCK.findall(page.read_text(encoding="utf-8")):
            yield page.name, kind.strip(), text


def test_every_block_is_of_a_kind_that_a_test_runs():
    found = list(blocks())
    assert {kind for _, kind, _ in found} <= KINDS
    without = [
        (page, text[:60])
        for page, kind, text in found
        if kind in ("python", "pycon") and ">>>" not in text
    ]
    assert without == []


def sayings() -> list[tuple[str, str]]:
    """The statements under "Examples" in the page on the language, with what is said of them."""
    block = LANGUAGE.partition("## Examples")[2].split("```")[1]
    return [tuple(re.split(r"  +", line, maxsplit=1)) for line in block.strip().splitlines()]


@pytest.mark.parametrize(("statement", "said"), sayings(), ids=[s for s, _ in sayings()])
def test_what_the_page_on_the_language_says_of_examples(statement, said):
    places = re.findall(r"(proved|refuted) over ((?:QQ|GF)\S*)(?<!,)(?=,| |$)", said)
    for verdict, field in places:
        assert prove(statement, field).verdict == verdict
    if "only" in said:
        assert prove(statement, "GF(3)").verdict == prove(statement, "GF(4)").verdict == "refuted"
    if places:
        return
    answer = prove(statement, algebra="[a,b,t|F)" if "[a,b,t|F)" in said else None)
    assert answer.verdict == re.split(r"[ ,:;]", said)[0]
    for words, scope in SCOPES.items():
        if words in said:
            assert answer.to_json()["scope"] == scope


@pytest.mark.slow
def test_the_exercise_sheet_is_decided_as_its_page_says(capsys, tmp_path, monkeypatch):
    (sheet,) = (
        text for page, kind, text in blocks() if (page, kind) == ("class-of-students.md", "toml")
    )
    file = tmp_path / "sheet.toml"
    file.write_text(sheet, encoding="utf-8")
    status, out, err = run(capsys, "verify", str(file))
    assert (status, err) == (0, "")
    refuted = out.partition("S2 ")[2]
    assert "refuted" in refuted
    assert "GF(3)" in refuted


def test_the_exercises_of_the_afternoon_are_decided(capsys, tmp_path):
    (sheet,) = (
        text for page, kind, text in blocks() if (page, kind) == ("finite-fields.md", "toml")
    )
    file = tmp_path / "afternoon.toml"
    file.write_text(sheet, encoding="utf-8")
    status, out, err = run(capsys, "verify", str(file))
    assert (status, err) == (0, "")
    assert "4 proved, 2 refuted" in out


def pictures() -> list[tuple[str, str]]:
    """The pictures of the gallery, each with the line of code that follows it."""
    found, waiting = [], []
    for line in GALLERY.splitlines():
        if shown := re.fullmatch(r"!\[.*\]\(images/(.*)\)", line):
            waiting.append(shown[1])
        elif typed := re.fullmatch(r"`(hfield .*)`", line):
            found += [(name, typed[1]) for name in waiting]
            waiting = []
    assert waiting == []
    return found


@subcases(("name", "typed"), pictures())
def test_a_picture_of_the_gallery_has_the_command_that_makes_it(name, typed):
    assert (ROOT / "docs" / "images" / name).stat().st_size > 1000
    words = shlex.split(typed)
    _, parser = command(words[1])
    args = parser.parse_args(words[2:])
    written = getattr(args, "plot", None) or args.output
    assert written == name or (
        written == "." and words[1] == "figures" and name.startswith("figure-2.")
    )


def test_the_gallery_is_not_empty():
    assert len(pictures()) > 12
