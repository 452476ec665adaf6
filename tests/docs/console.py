"""The console blocks of the pages: what is typed, what the page says is printed, and what is."""

from __future__ import annotations

import contextlib
import io
import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from hfield.cli import main

ROOT = Path(__file__).parents[2]
PAGES = [
    page
    for page in [
        ROOT / "README.md",
        ROOT / "CONTRIBUTING.md",
        *sorted((ROOT / "docs").rglob("*.md")),
    ]
    if "_build" not in page.parts
]
_BLOCK = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# What takes long, waits for a person, needs Coq or a built site, or prints times: not run.
NOT_RUN = {
    "bench",
    "repl",
    "render",
    "figures",
    "docs",
    "precompile",
    "survey",
    "export",
    "doctor",
    "report",
}
SHELL = set("();<>|&")  # what asks more of a shell than to run one command


@dataclass
class Line:
    """A line that is typed, with the text that the page shows below it, from ``start`` to ``end``."""

    typed: str
    printed: str
    start: int
    end: int

    @property
    def words(self) -> list[str] | None:
        """The words after ``hfield``, where it is run at all."""
        lexer = shlex.shlex(self.typed, posix=True, punctuation_chars=True)
        lexer.whitespace_split = True
        try:
            words = list(lexer)
        except ValueError:
            return None
        if any(set(word) <= SHELL for word in words if word):
            return None
        if words[:1] != ["hfield"] or not words[1:] or words[1] in NOT_RUN or "--coq" in words:
            return None
        return words[1:]


def blocks(text: str) -> Iterator[list[Line]]:
    """Yield the console blocks of a page, each as its lines that are typed."""
    for block in _BLOCK.finditer(text):
        lines: list[Line] = []
        position = block.start(1)
        for line in block[1].splitlines(keepends=True):
            end = position + len(line)
            if line.startswith("$ "):
                lines.append(Line(line[2:].rstrip("\n"), "", end, end))
            elif lines:
                lines[-1].printed += line
                lines[-1].end = end
            position = end
        yield lines


def run(words: list[str]) -> str:
    """Return what a command prints, errors included, as a terminal of 100 columns would show it."""
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        main(words)
    return said.getvalue()


def agrees(shown: str, printed: str) -> bool:
    """Tell whether a page shows what is printed; a line ``…`` stands for any lines."""
    pattern = "(.*\n)*?".join(
        re.escape(part.strip("\n") + "\n") if part.strip("\n") else ""
        for part in re.split(r"^ *…\n", shown, flags=re.MULTILINE)
    )
    return re.fullmatch(pattern, printed.rstrip("\n") + "\n") is not None
