"""Films written by suffix: which format it is, what would fail in the end, and the file in its place."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from anim.errors import AnimationError
from anim.output.destination import file_place, folder_place, refuse_early
from anim.output.format import Film, Format, Samples, Write
from anim.output.formats import FORMATS
from hfield.errors import shorten

PAGE = ".html"  # no film: the page draws for itself


def format_of(path: Path) -> Format | None:
    """Return the format of a film by its suffix; None for a page or a folder of pictures."""
    return FORMATS.get(path.suffix.lower()[1:])


def _suffixes() -> tuple[str, ...]:
    return (*(f".{name}" for name in FORMATS), PAGE)


def is_folder(path: Path) -> bool:
    """Tell whether a name stands for a folder of pictures: it has no suffix, or exists as a folder."""
    if path.name in _suffixes():
        raise AnimationError(f"{path.name!r} is a suffix without a name; try top{path.name}")
    if path.suffix.lower() in _suffixes():
        return False
    return not path.suffix or os.path.isdir(path)


def check(path: Path, film: Film | None, force: bool = False) -> None:
    """Refuse at once what would fail in the end; ``film`` is None for a page of HTML.

    Raises :class:`AnimationError` for an unknown suffix, a size or pace that the format cannot have, a
    file that exists (without ``force``), a folder that is missing or cannot be written, and without ffmpeg.
    """
    suffix, suffixes = path.suffix.lower(), _suffixes()
    if suffix in suffixes and os.path.isdir(path):
        raise AnimationError(f"{shorten(path)!r} is a folder; choose another name")
    if not is_folder(path) and suffix not in suffixes:
        hint = "; --frame N makes a .png of one frame, --sheet of ten" if suffix == ".png" else ""
        raise AnimationError(
            f"{shorten(path.name)!r}: no film can be written as {suffix!r}; expected {', '.join(suffixes)}, "
            f"or a name without suffix for a folder of pictures{hint}"
        )
    form = format_of(path)
    if film is not None and form is not None:
        form.check(film)
    refuse_early(path, force)


@contextmanager
def open_film(
    path: Path, film: Film, samples: Samples | None = None, force: bool = False
) -> Iterator[Write]:
    """Yield a function that takes the frames in order, uint8 (height, width, 3).

    The file comes into place when all frames are in it; after an error there is none. ``samples``
    returns some frames for the palette of a gif. Raises :class:`AnimationError`, as :func:`check`
    does, and when the encoder fails or has lost a frame.
    """
    check(path, film, force)
    form = format_of(path)
    if form is None:
        from anim.output.pictures import open_folder

        with folder_place(path, force) as part, open_folder(part, film) as write:
            yield write
        return
    with file_place(path, force) as part, form.open(part, film, samples) as write:
        yield write
