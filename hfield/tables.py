"""Read tables of numbers from text files, one row per line."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hfield.errors import TableError, shorten

MAX_ROWS = 1_000_000


@dataclass(frozen=True, eq=False)
class NumberTable:
    """Rows of numbers (n, columns), and the line number of each row in the file."""

    name: str
    rows: NDArray[np.float64]
    lines: tuple[int, ...]

    def place(self, row: int) -> str:
        """Return the file and the line of a row, counted from 0."""
        return f"{self.name}, line {self.lines[row]}"


def read_table(path: str | Path, columns: Mapping[int, str]) -> NumberTable:
    """Return the numbers of a text file, separated by semicolons, commas, or spaces and tabs.

    Empty lines and comments after ``#`` are skipped. A first line without numbers is a heading. ``columns``
    maps each allowed number of columns to a description; all rows must have the same length. Raises
    :class:`TableError`, which names the file and the line.
    """
    file = Path(path)
    name = shorten(file)
    try:
        text = file.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise TableError(f"{name!r} could not be read: {error.strerror or error}") from None
    except UnicodeDecodeError:
        raise TableError(f"{name!r} is not UTF-8 text; expected lines of numbers") from None
    expected = " or ".join(f"{count} numbers ({what})" for count, what in columns.items())
    rows: list[list[float]] = []
    lines: list[int] = []
    seen_any = False
    for number, line in enumerate(text.splitlines(), 1):
        fields = _fields(line)
        if not fields:
            continue
        heading, seen_any = not seen_any and not any(map(is_number, fields)), True
        if heading:
            continue
        where = f"{name}, line {number}"
        wrong = next((field for field in fields if not is_number(field)), None)
        if wrong is not None:
            what = f"{shorten(wrong)!r} is not a number" if wrong else "a value is missing"
            raise TableError(f"{where}: {what}; expected {expected}")
        values = [float(field) for field in fields]
        allowed = [len(rows[0])] if rows else list(columns)
        if len(values) not in allowed:
            rest = f"{expected}" if not rows else f"{len(rows[0])}, as on line {lines[0]}"
            count = "1 number" if len(values) == 1 else f"{len(values)} numbers"
            raise TableError(f"{where} has {count}; expected {rest}")
        bad = next((value for value in values if not isfinite(value)), None)
        if bad is not None:
            raise TableError(f"{where}: {bad} is not finite; expected {expected}")
        rows.append(values)
        lines.append(number)
        if len(rows) > MAX_ROWS:
            raise TableError(f"{name!r} has more than {MAX_ROWS} rows")
    if not rows:
        raise TableError(f"{name!r} has no numbers; expected {expected} on each line")
    return NumberTable(name, np.array(rows), tuple(lines))


def _fields(line: str) -> list[str]:
    """Return the fields of a line, separated by semicolons, else commas, else spaces; none for an
    empty line.
    """
    text = line.partition("#")[0].strip()
    separator = next((mark for mark in ";," if mark in text), None)
    return [field.strip() for field in text.split(separator)] if text else []


def is_number(text: str) -> bool:
    """Return whether a text is a number in decimal notation."""
    try:
        float(text)
    except ValueError:
        return False
    return True
