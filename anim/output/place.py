"""Where a file goes: a hidden neighbour until it is whole, then the name asked for."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from anim.errors import AnimationError

PART = "part"


def refuse_early(path: Path, force: bool) -> None:
    """Raise :class:`AnimationError` if ``path`` exists and is not to be replaced, or cannot be written."""
    parent = path.absolute().parent
    if not parent.is_dir():
        raise AnimationError(f"the folder {str(parent)!r} does not exist; make it first")
    if not os.access(parent, os.W_OK | os.X_OK):
        raise AnimationError(f"the folder {str(parent)!r} cannot be written; choose another")
    if path.is_dir():
        strange = next((p.name for p in path.iterdir() if not _is_frame(p)), None)
        if strange is not None:
            raise AnimationError(
                f"the folder {path.name!r} holds {strange!r}, which is no frame; choose a new folder"
            )
        if any(path.iterdir()) and not force:
            raise AnimationError(f"the folder {path.name!r} has frames; --force replaces them")
    elif path.exists():
        if not path.is_file():
            raise AnimationError(f"{path.name!r} is no ordinary file; choose another name")
        if not force:
            raise AnimationError(f"{path.name!r} exists; --force replaces it")


def _is_frame(path: Path) -> bool:
    return path.name.startswith("frame_") and path.suffix == ".png"


@contextmanager
def file_place(path: Path) -> Iterator[Path]:
    """Yield a hidden name beside ``path``; what is written there takes its place in the end."""
    _sweep(path)
    part = _neighbour(path)
    try:
        yield part
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


@contextmanager
def folder_place(path: Path) -> Iterator[Path]:
    """Yield a hidden new folder beside ``path``; it takes its place in the end."""
    _sweep(path)
    part = _neighbour(path)
    try:
        part.mkdir()
        yield part
        if path.exists():
            shutil.rmtree(path)  # empty, or old frames that are to be replaced
        part.rename(path)
    finally:
        shutil.rmtree(part, ignore_errors=True)


def _neighbour(path: Path) -> Path:
    return path.with_name(f".{path.stem}.{os.getpid()}.{PART}{path.suffix}")


def _sweep(path: Path) -> None:
    """Remove what runs left behind that were killed while they wrote ``path``."""
    for old in path.absolute().parent.glob(f".{path.stem}.*.{PART}{path.suffix}"):
        number = old.name.removeprefix(f".{path.stem}.").partition(".")[0]
        if number.isdecimal() and not _alive(int(number)):
            if old.is_dir():
                shutil.rmtree(old, ignore_errors=True)
            else:
                old.unlink(missing_ok=True)


def _alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True
    return True
