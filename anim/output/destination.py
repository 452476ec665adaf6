"""Write a file under a hidden name, and rename it when it is complete."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from anim.errors import AnimationError
from hfield.core.files import sweep, whole_file, whole_folder
from hfield.errors import shorten


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
                raise AnimationError(
                    f"{shorten(path)!r} is not an ordinary file; choose another name"
                )
            if not force:
                raise AnimationError(f"{shorten(path)!r} exists; --force replaces it")


def _refuse_folder(folder: Path, force: bool) -> None:
    strange = next((p.name for p in folder.iterdir() if not _is_frame(p)), None)
    if strange is not None:
        raise AnimationError(
            f"the folder {shorten(folder)!r} holds {shorten(strange)!r}, which is not a frame; choose a new "
            "folder"
        )
    if any(folder.iterdir()) and not force:
        raise AnimationError(f"the folder {shorten(folder)!r} has frames; --force replaces them")


def _is_frame(path: Path) -> bool:
    return path.name.startswith("frame_") and path.suffix == ".png"


@contextmanager
def file_place(path: Path, force: bool) -> Iterator[Path]:
    """Yield a hidden name beside ``path``; the file written there is renamed to ``path`` at the end.

    A file that has appeared there meanwhile is replaced with ``force`` only. What a run that was killed left
    there is removed first. Raises :class:`AnimationError`.
    """
    with _in_one_line(path):
        sweep(_target(path))
        with whole_file(path, force) as part:
            yield part


@contextmanager
def folder_place(path: Path, force: bool) -> Iterator[Path]:
    """Yield a hidden new folder beside ``path``; it takes the place of an empty one.

    With ``force`` it takes the place of old frames too. Raises :class:`AnimationError`.
    """
    with _in_one_line(path):
        sweep(_target(path))
        with whole_folder(path, force) as part:
            yield part
            refuse_early(path, force)  # what has appeared there meanwhile


def write_text(path: Path, text: str, force: bool) -> None:
    """Write a text to a file, completely or not at all. Raises :class:`AnimationError` if that fails."""
    with file_place(path, force) as part:
        part.write_text(text, encoding="utf-8")


@contextmanager
def _in_one_line(path: Path) -> Iterator[None]:
    """Turn an error of the operating system into an :class:`AnimationError`."""
    try:
        yield
    except OSError as error:
        reason = error.strerror or str(error)
        if isinstance(error, FileExistsError):
            reason += "; --force replaces it"
        raise AnimationError(f"{shorten(path)!r} could not be written: {reason}") from None


def _target(path: Path) -> Path:
    """Return where a name leads, links followed."""
    try:
        return path.resolve()
    except RuntimeError:  # what Python says of links in a circle
        raise AnimationError(f"{shorten(path)!r} is a link to itself; choose another") from None
