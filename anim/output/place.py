"""Where a file goes: a hidden neighbour until it is whole, then the name asked for."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from anim.errors import AnimationError
from hfield.errors import shorten

PART = "part"
STEM = 40  # letters of the name that a neighbour's name begins with


def refuse_early(path: Path, force: bool) -> None:
    """Raise :class:`AnimationError` if ``path`` exists and is not to be replaced, or cannot be written."""
    with _in_one_line(path):
        target = _target(path)
        parent = target.parent
        if not parent.is_dir():
            raise AnimationError(f"the folder {shorten(parent)!r} does not exist; make it first")
        if not os.access(parent, os.W_OK | os.X_OK):
            raise AnimationError(
                f"the folder {shorten(parent)!r} cannot be written; choose another"
            )
        with suppress(FileNotFoundError):
            target.lstat()  # a name that is too long says so here
        if target.is_dir():
            _refuse_folder(target, force)
        elif target.exists():
            if not target.is_file():
                raise AnimationError(f"{shorten(path)!r} is no ordinary file; choose another name")
            if not force:
                raise AnimationError(f"{shorten(path)!r} exists; --force replaces it")


def _refuse_folder(folder: Path, force: bool) -> None:
    strange = next((p.name for p in folder.iterdir() if not _is_frame(p)), None)
    if strange is not None:
        raise AnimationError(
            f"the folder {shorten(folder)!r} holds {shorten(strange)!r}, which is no frame; "
            "choose a new folder"
        )
    if any(folder.iterdir()) and not force:
        raise AnimationError(f"the folder {shorten(folder)!r} has frames; --force replaces them")


def _is_frame(path: Path) -> bool:
    return path.name.startswith("frame_") and path.suffix == ".png"


@contextmanager
def file_place(path: Path) -> Iterator[Path]:
    """Yield a hidden name beside ``path``; what is written there takes its place in the end.

    A link stays a link: what it points to is replaced. Raises :class:`AnimationError`.
    """
    with _in_one_line(path):
        target = _target(path)
        _sweep(target)
    part = _neighbour(target)
    try:
        yield part
        with _in_one_line(path):
            part.replace(target)
    finally:
        with suppress(OSError):
            part.unlink(missing_ok=True)


@contextmanager
def folder_place(path: Path) -> Iterator[Path]:
    """Yield a hidden new folder beside ``path``; it takes its place in the end."""
    with _in_one_line(path):
        target = _target(path)
        _sweep(target)
        part = _neighbour(target)
        part.mkdir()
    try:
        yield part
        with _in_one_line(path):
            if target.exists():
                shutil.rmtree(target)  # empty, or old frames that are to be replaced
            part.rename(target)
    finally:
        shutil.rmtree(part, ignore_errors=True)


def write_text(path: Path, text: str) -> None:
    """Write a text, whole or not at all. Raises :class:`AnimationError` when the disk does not take it."""
    with file_place(path) as part, _in_one_line(path):
        part.write_text(text, encoding="utf-8")


@contextmanager
def _in_one_line(path: Path) -> Iterator[None]:
    """Turn what the system says of a file into an :class:`AnimationError`."""
    try:
        yield
    except OSError as error:
        reason = error.strerror or str(error)
        raise AnimationError(f"{shorten(path)!r} could not be written: {reason}") from None


def _target(path: Path) -> Path:
    """Return where a name leads, links followed."""
    try:
        return path.resolve()
    except RuntimeError:  # what Python says of links in a circle
        raise AnimationError(f"{shorten(path)!r} is a link to itself; choose another") from None


def _prefix(target: Path) -> str:
    return f".{target.stem[:STEM]}."


def _neighbour(target: Path) -> Path:
    return target.with_name(f"{_prefix(target)}{os.getpid()}.{PART}{target.suffix}")


def _sweep(target: Path) -> None:
    """Remove what runs left behind that were killed while they wrote ``target``."""
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


def _alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:
        return True
    return True
