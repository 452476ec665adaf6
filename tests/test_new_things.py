"""A new thing touches the files that docs/architecture.md names: put there in a copy, it is known."""

import doctest
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
TABLE = (
    (ROOT / "docs" / "architecture.md")
    .read_text(encoding="utf-8")
    .split("## What a new thing touches")[1]
)

CLAIM = """
[[claims]]
id = "C1-new"
name = "twofold"
section = "1"
kind = "formula"
statement = "A sum of two equal ones"
holds = "q + q == 2*q"
"""
POLISH = """
[claims."C1-new"]
name = "podwojenie"
statement = "Suma dwóch równych"
"""
COMMAND = '''"""A command of a test."""

HELP = "Say twice what is said."


def configure(parser):
    parser.add_argument("word")


def run(args):
    print(args.word, args.word)
    return 0
'''
STYLE = '''"""Even colours of a test."""

from anim.picture.styles.flat import Flat

STYLE = Flat()
'''
FORMAT = '''"""Matroska, for a test."""

from anim.output.formats.mp4 import Mp4


class Matroska(Mp4):
    def options(self, film):
        return [*super().options(film)[:-4], "-f", "matroska"]


FORMAT = Matroska()
'''


def ring_of_the_page() -> str:
    """Return the module of the ring that docs/rings.md builds."""
    page = (ROOT / "docs" / "rings.md").read_text(encoding="utf-8")
    sources = [example.source for example in doctest.DocTestParser().get_examples(page)]
    wanted = ("from ", "@dataclass", "class ")
    return "".join(source for source in sources if source.startswith(wanted))


# What is new: its row in the table; the files it touches, each with the line it is put before, or None; a
# command and what it has to say.
NEW = {
    "a claim": (
        {
            "hfield/ledger/chapter1/chapter1.toml": ('[[claims]]\nid = "C1-b"', CLAIM),
            "hfield/ledger/chapter1/chapter1.pl.toml": ('[claims."C1-b"]', POLISH),
        },
        (
            "report",
            "--section",
            "1",
            "--field",
            "GF9",
            "--lang",
            "pl",
            "--chapters",
            "none",
            "-o",
            "page.html",
        ),
        "Suma dwóch równych",
    ),
    "a ring to compute over": (
        {
            "hfield/rings/dual_numbers.py": (None, ring_of_the_page()),
            "hfield/fields/names.py": (
                '    if re.match(r"QQ?[(\\[]", s):\n',
                '    if s == "QQ[eps]/(eps^2)":\n'
                "        from hfield.rings.dual_numbers import DualNumbers\n\n"
                '        return DualNumbers(build("QQ"))\n',
            ),
        },
        ("eval", "(1 + eps*i)**2", "--field", "QQ[eps]/(eps^2)"),
        "1 + 2*eps*i",
    ),
    "a command": (
        {
            "hfield/commands/twice.py": (None, COMMAND),
            "hfield/commands/catalogue.py": ('    "eval": ', '    "twice": "say it twice",\n'),
        },
        ("twice", "so"),
        "so so",
    ),
    "a render style": (
        {"anim/picture/styles/even.py": (None, STYLE)},
        ("help", "render"),
        "even: Even colours of a test;",
    ),
    "a format of films": (
        {"anim/output/formats/mkv.py": (None, FORMAT)},
        ("help", "render"),
        ".mkv",
    ),
}


@pytest.fixture(scope="module")
def copied(tmp_path_factory):
    """A copy of the house."""
    copy = tmp_path_factory.mktemp("house")
    for package in ("hfield", "rotation", "anim"):
        shutil.copytree(
            ROOT / package, copy / package, ignore=shutil.ignore_patterns("__pycache__")
        )
    return copy


@pytest.mark.parametrize("thing", NEW)
def test_a_new_thing_is_there_once_it_is_put_where_the_page_says(copied, tmp_path, thing):
    files, command, said = NEW[thing]
    (row,) = (line for line in TABLE.splitlines() if line.startswith(f"| {thing}"))
    for path, (before, text) in files.items():
        file = copied / path
        assert "anywhere" in row or any(name in path for name in re.findall(r"`([\w/]+)`", row)), (
            path
        )
        known = file.read_text(encoding="utf-8") if before else ""
        assert not before or known.count(before) == 1
        file.write_text(known.replace(before, text + before) if before else text, encoding="utf-8")
    environment = os.environ | {"PYTHONPATH": str(copied), "PYTHONDONTWRITEBYTECODE": "1"}
    found = subprocess.run(
        [sys.executable, "-m", "hfield", *command],
        cwd=tmp_path, env=environment, capture_output=True, text=True, encoding="utf-8", timeout=300,
    )  # fmt: skip
    assert found.returncode == 0, found.stderr
    made = [file.read_text(encoding="utf-8", errors="ignore") for file in tmp_path.iterdir()]
    assert said in "".join([found.stdout, *made])
