"""Write results to the terminal or, completely or not at all, to a file."""

from __future__ import annotations

import json
import os
import re
import stat
import sys
import unicodedata
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from shutil import get_terminal_size
from typing import TYPE_CHECKING, TextIO

from hfield.cli.status import STATUS
from hfield.core.files import whole_file
from hfield.errors import HFieldError, shorten

if TYPE_CHECKING:
    from hfield.ledger.claims_table import TerminalStyle

_PLAIN = {"√": "sqrt", "−": "-", "·": "*", "×": "x", "…": "...", "ℚ": "QQ", "ℝ": "RR", "ℂ": "CC"}
_PLAIN |= {"ℤ": "ZZ", "⇒": "=>", "⇔": "<=>", "≠": "!=", "∀": "all", "∃": "exists", "∈": "in"}
_PLAIN |= {"∅": "o", "✓": "+", "✗": "x", "‖": "||", "∘": ".", "∧": "and", "∨": "or", "¬": "not "}
_PLAIN |= {"“": '"', "”": '"', "–": "-", "—": "-", "ł": "l", "Ł": "L", "α": "alpha", "Σ": "Sum"}
_PLAIN |= {"θ": "theta", "†": "+", "│": "|", "─": "-", "┼": "+", "→": "->", "≥": ">=", "∞": "oo"}
_PLAIN |= {"⟨": "<", "⟩": ">", "↦": "->", "≅": "="}
_PLAIN |= {"\u0304": "'"}  # q̄ becomes q'
MAX_WIDTH = 100  # letters of a line, however wide the terminal is
_POWERS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


class OutputError(HFieldError, OSError):
    """A file that cannot be written."""


class Sink:
    """An open output: stdout or a file."""

    def __init__(self, stream: TextIO) -> None:
        self.stream = stream
        self._ending = ""

    def write(self, text: str) -> None:
        """Write a text that ends with a newline."""
        STATUS.erase()
        print(encodable(text.rstrip("\n"), self.stream), file=self.stream)

    def write_lines(self, lines: Iterable[str], below: str) -> None:
        """Write lines; they are wrapped, with indented continuation lines, only where the width is
        limited.
        """
        if _has_width(self.stream):
            lines = [gone_on(line, terminal_width(), below) for line in lines]
        self.write("\n".join(lines))

    def write_json(self, data: Mapping[str, object]) -> None:
        """Write JSON with one entry per line, and with non-ASCII letters if the encoding has them."""
        STATUS.erase()
        text = _lay_out(data)
        if not _encodes(text, self.stream):
            text = _lay_out(data, ensure_ascii=True)
        print(text, file=self.stream)

    def write_latex(self, text: str, standalone: bool) -> None:
        """Write a LaTeX fragment; standalone fragments are joined into one document."""
        if standalone and not self._ending:
            from hfield.latex import document

            head, _, self._ending = document("\0").partition("\0")
            self.write(head)
        self.write(text)

    def finish(self) -> None:
        """Write the end of the document."""
        if self._ending:
            self.write(self._ending.lstrip("\n"))

    def style(self) -> TerminalStyle:
        """Return what the output can display: width, unicode, colours."""
        from hfield.ledger.claims_table import TerminalStyle

        terminal = self.stream.isatty()
        colour = terminal and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"
        width = terminal_width() if _has_width(self.stream) else MAX_WIDTH
        return TerminalStyle(max(width, 40), not _encodes("∀✓√₉─", self.stream), bool(colour))


def terminal_width() -> int:
    """Return the line width: that of the terminal, up to a maximum."""
    return min(MAX_WIDTH, get_terminal_size((MAX_WIDTH, 24)).columns)


def _has_width(stream: TextIO) -> bool:
    """Return whether lines are wrapped: on a terminal, or if COLUMNS is set."""
    return stream.isatty() or bool(os.environ.get("COLUMNS"))


def gone_on(text: str, width: int, below: str = "  ") -> str:
    """Return a text wrapped to a width, with indented continuation lines; long words, such as paths, are not
    split.

    >>> print(gone_on("cannot read no/such/file: there is none", 22))
    cannot read
      no/such/file: there
      is none
    """
    from textwrap import fill

    return fill(
        text, width, subsequent_indent=below, break_on_hyphens=False, break_long_words=False
    )


@contextmanager
def open_output(path: str | None) -> Iterator[Sink]:
    """Open stdout or a file; a file is created at once and takes its final name only on success.

    Raises :class:`OutputError` when the file cannot be written.
    """
    if path is None or path == "-":
        sink = Sink(sys.stdout)
        yield sink
        sink.finish()
        return
    if not path:
        raise OutputError("the name of the output file is empty; expected -o FILE")
    with writing(repr(shorten(path))), _open_file(Path(path)) as stream:
        sink = Sink(stream)
        yield sink
        sink.finish()


@contextmanager
def writing(what: str, instead: str = "file") -> Iterator[None]:
    """Convert OS errors inside the ``with`` block to :class:`OutputError`."""
    try:
        yield
    except OSError as error:
        if isinstance(error, HFieldError | BrokenPipeError):  # of a terminal whose reader has left
            raise
        reason = error.strerror or str(error)
        raise OutputError(f"cannot write {what}: {reason}; choose another {instead}") from error


@contextmanager
def _open_file(path: Path) -> Iterator[TextIO]:
    """Open a temporary file that is renamed to ``path`` at the end; devices are opened directly.

    If nothing was written, an existing file is kept.
    """
    target = path.resolve()
    mode = target.stat().st_mode if target.exists() else None
    if mode is not None and not stat.S_ISREG(mode):
        with target.open("w", encoding="utf-8") as stream:
            yield stream
        return
    if mode is not None and not os.access(target, os.W_OK):
        raise OutputError(f"cannot write {shorten(path)!r}: the file is read-only")
    with whole_file(target) as part:
        with part.open("x", encoding="utf-8") as stream:
            yield stream
            written = stream.tell() > 0
        if not written:
            part.unlink()


def encodable(text: str, stream: TextIO) -> str:
    """Return the text with characters that the stream cannot encode written in ASCII."""
    if _encodes(text, stream):
        return text
    plain = re.sub("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda m: "^" + m[0].translate(_POWERS), text)
    plain = "".join(_PLAIN.get(char, char) for char in plain)
    plain = unicodedata.normalize("NFKD", plain)
    plain = "".join(char for char in plain if not unicodedata.combining(char))
    encoding = stream.encoding or "ascii"
    return plain.encode(encoding, errors="replace").decode(encoding)


def _encodes(text: str, stream: TextIO) -> bool:
    try:
        text.encode(getattr(stream, "encoding", None) or "utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _lay_out(data: Mapping[str, object], ensure_ascii: bool = False) -> str:
    """Format a JSON object with one line per entry, and one line per object in a list of objects."""

    def dump(value: object) -> str:
        if isinstance(value, list) and value and isinstance(value[0], dict):
            return "[\n" + ",\n".join(f"  {dump(item)}" for item in value) + "\n ]"
        return json.dumps(value, ensure_ascii=ensure_ascii)

    return "{\n" + ",\n".join(f" {dump(key)}: {dump(value)}" for key, value in data.items()) + "\n}"


def try_picture(path: str, *more: str) -> bool:
    """Raise :class:`OutputError` before a long computation if its picture could not be written.

    ``more`` are suffixes that are allowed besides those of pictures. Return whether a file of this name
    already exists; a file that appears later must not be replaced.
    """
    suffixes = (".svg", ".png", ".pdf", *more)
    if Path(path).suffix.lower() not in suffixes:
        raise OutputError(
            f"cannot draw to {shorten(path)!r}: expected a name that ends in {', '.join(suffixes)}"
        )
    if not (folder := Path(path).absolute().parent).is_dir():
        raise OutputError(f"cannot draw to {shorten(path)!r}: there is no folder {shorten(folder)}")
    return Path(path).exists()


def note(text: str) -> None:
    """Print a note on stderr."""
    say("note", text)


def say(what: str, text: str) -> None:
    """Write ``hfield: what: text`` to stderr, wrapped if the width is limited."""
    STATUS.erase()
    line = f"hfield: {what}: {' '.join(text.split())}"
    if _has_width(sys.stderr):
        line = gone_on(line, terminal_width())
    print(encodable(line, sys.stderr), file=sys.stderr)
