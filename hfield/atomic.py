"""Files and folders that are there whole or not at all: made beside their name, moved there in the end."""

from __future__ import annotations

import os
import shutil
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

PART = "part"
STEM = 40  # letters of the name that the name beside it begins with


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Yield a hidden name beside ``path``; the file written there takes its place in the end.

    A link stays a link: what it points to is replaced, and keeps its permissions. Nothing is left after
    an error, and nothing replaced where nothing was written. Raises OSError.
    """
    target = path.resolve()
    part = _beside(target)
    try:
        yield part
        if part.exists():
            with suppress(FileNotFoundError):
                part.chmod(stat.S_IMODE(target.stat().st_mode))
            part.replace(target)
    finally:
        with suppress(OSError):
            part.unlink(missing_ok=True)


@contextmanager
def whole_folder(path: Path) -> Iterator[Path]:
    """Yield a hidden new folder beside ``path``; it takes its place in the end. Raises OSError."""
    target = path.resolve()
    part = _beside(target)
    part.mkdir()
    try:
        yield part
        if target.exists():
            shutil.rmtree(target)
        part.rename(target)
    finally:
        shutil.rmtree(part, ignore_errors=True)


def sweep(path: Path) -> None:
    """Remove what processes that were killed left beside ``path``. Raises OSError."""
    target = path.resolve()
    start = _prefix(target)
    for old in target.parent.iterdir():
        number, _, rest = old.name.removeprefix(start).partition(".")
        if not (old.name.startswith(start) and rest.split(".")[0] == PART):
            continue
        # In containers the same numbers come again: our own is that of a dead run.
        if number.isdecimal() and (int(number) == os.getpid() or not _alive(int(number))):
            if old.is_dir():
                shutil.rmtree(old, ignore_errors=True)
            else:
                old.unlink(missing_ok=True)


def _prefix(target: Path) -> str:
    return f".{target.stem[:STEM]}."


def _beside(target: Path) -> Path:
    return target.with_name(f"{_prefix(target)}{os.getpid()}.{PART}{target.suffix[:STEM]}")


def _alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:
        return True
    return True
