"""A journal of JSON lines from which an interrupted computation resumes."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

Row = dict[str, Any]


class Journal:
    """A file of JSON lines that survives a kill; rows are appended, and read back completely."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def read(self) -> list[Row]:
        """Remove an incomplete last line and return the rows. Raises ValueError for a line that is
        not JSON.
        """
        if not self.path.exists():
            return []
        data = self.path.read_bytes()
        whole = data.rfind(b"\n") + 1
        if whole < len(data):
            with self.path.open("r+b") as file:
                file.truncate(whole)
        try:
            return [json.loads(line) for line in data[:whole].splitlines()]
        except RecursionError:
            raise ValueError("a line is nested too deeply") from None

    def append(self, found: list[Row]) -> None:
        """Append rows in one write, and flush them to the disk."""
        text = "".join(json.dumps(item) + "\n" for item in found)
        with self.path.open("ab") as file:
            file.write(text.encode())
            file.flush()
            os.fsync(file.fileno())
