"""Redraw the pictures of docs/gallery.md by the commands on that page, and compare.

``python tasks.py gallery`` draws them, replaces those in docs/images that differ, and names them. It fails if
any picture differed.
"""

import os
import re
import shlex
import sys
from collections.abc import Iterator
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from PIL import Image, ImageSequence

from hfield.cli import main as hfield

ROOT = Path(__file__).parent.parent
IMAGES = ROOT / "docs" / "images"
OTHER_PAGES = ("hfield domain '(3,-1|QQ)' --dark -o domain-6-dark.svg",)
"""Commands for pictures on other pages."""
LEVEL_TOLERANCE, MAX_DIFFERING_SHARE = 24, 5e-4
"""Pictures are equal if at most this share of their pixels differs by more than the tolerance."""


def commands() -> list[str]:
    """Return the command lines of the page."""
    text = (ROOT / "docs" / "gallery.md").read_text(encoding="utf-8")
    lines: list[str] = re.findall(r"^`(hfield .*)`$", text, re.MULTILINE)
    return [line for line in (*lines, *OTHER_PAGES) if not line.endswith(".html")]


def same(one: Path, other: Path) -> bool:
    """Tell whether two files look the same: equal texts, or frames without a visible difference."""
    if not other.is_file():
        return False
    if one.suffix == ".svg":
        return one.read_bytes() == other.read_bytes()
    return one.read_bytes() == other.read_bytes() or _alike(
        list(_frames(one)), list(_frames(other))
    )


def _alike(some: list[np.ndarray], others: list[np.ndarray]) -> bool:
    return len(some) == len(others) and all(
        a.shape == b.shape
        and np.mean(np.abs(a - b).max(axis=-1) > LEVEL_TOLERANCE) <= MAX_DIFFERING_SHARE
        for a, b in zip(some, others, strict=True)
    )


def _frames(path: Path) -> Iterator[np.ndarray]:
    with Image.open(path) as picture:
        for frame in ImageSequence.Iterator(picture):
            yield np.asarray(frame.convert("RGB"), dtype=np.int16)


def main() -> int:
    """Draw, compare and replace; return 1 if any picture differed."""
    changed: list[str] = []
    with TemporaryDirectory() as folder:
        os.chdir(folder)
        for line in commands():
            print(line, flush=True)
            with redirect_stdout(StringIO()):
                status = hfield(shlex.split(line)[1:])
            if status:
                print(f"the command failed with status {status}", file=sys.stderr)
                return status
        for new in sorted(Path(folder).iterdir()):
            old = IMAGES / new.name
            if not same(new, old):
                changed.append(new.name)
                old.write_bytes(new.read_bytes())
    print(
        "replaced, since they differ from what their commands draw: "
        + (", ".join(changed) or "none")
    )
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main())
