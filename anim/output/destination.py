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
    """Raise :class:`AnimationError` if ``path`` exists and must not be replaced, or cannot be written."""
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
            target.lstat()  # raises an error for a name that is too long
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

    A file that has appeared at ``path`` in the meantime is replaced only with ``force``. Leftovers of a
    killed run are removed first. Raises :class:`AnimationError`.
    """
    with _in_one_line(path):
        sweep(_target(path))
        with whole_file(path, force) as part:
            yield part


@contextmanager
def folder_place(path: Path, force: bool) -> Iterator[Path]:
    """Yield a hidden new folder beside ``path``, which replaces an empty folder there at the end.

    With ``force`` it also replaces old frames. Raises :class:`AnimationError`.
    """
    with _in_one_line(path):
        sweep(_target(path))
        with whole_folder(path, force) as part:
            yield part
            refuse_early(path, force)  # a file that appeared in the meantime


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
    """Return the target of a name, following links."""
    try:
        return path.resolve()
    except RuntimeError:  # Python's error for circular links
        raise AnimationError(f"{shorten(path)!r} is a link to itself; choose another") from None
