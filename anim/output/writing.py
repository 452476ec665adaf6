"""Write a film or a picture in the format given by the suffix of the file name."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from enum import Enum
from pathlib import Path

from anim.errors import AnimationError
from anim.output.destination import file_place, folder_place, refuse_early
from anim.output.format import Film, Samples, Write
from anim.output.formats import FORMATS
from hfield.errors import shorten


class OutputKind(Enum):
    """The kind of output that the suffix of a file name selects."""

    FILM = "film"
    PAGE = "page"
    PICTURE = "picture"
    FOLDER = "folder of pictures"


def suffixes() -> dict[str, OutputKind]:
    """Return the kind of output for each suffix; a name without a suffix is a folder."""
    films = {f".{name}": OutputKind.FILM for name in FORMATS}
    return films | {".html": OutputKind.PAGE, ".png": OutputKind.PICTURE}


def kind_of(path: Path) -> OutputKind:
    """Return the kind of output of a file name. Raises :class:`AnimationError` for an unknown suffix."""
    if path.name in suffixes():
        raise AnimationError(f"{path.name!r} is a suffix without a name; try top{path.name}")
    kind = suffixes().get(path.suffix.lower())
    if kind is not None:
        if os.path.isdir(path):
            raise AnimationError(f"{shorten(path)!r} is a folder; choose another name")
        return kind
    if path.suffix and not os.path.isdir(path):
        raise AnimationError(
            f"{shorten(path.name)!r}: the format {path.suffix.lower()!r} is unknown; expected "
            f"{', '.join(suffixes())}, or a name without suffix for a folder of pictures"
        )
    return OutputKind.FOLDER


def check(path: Path, film: Film | None, force: bool = False) -> None:
    """Raise immediately for an output that would fail at the end; ``film`` is None for a page or one picture.

    Raises :class:`AnimationError` for an unknown suffix or one that is not a film format, a size or rate that
    the format does not support, an existing file (without ``force``), a folder that is missing or read-only,
    and if ffmpeg is missing.
    """
    kind, suffix = kind_of(path), path.suffix.lower()
    if film is not None:
        if kind in (OutputKind.PAGE, OutputKind.PICTURE):
            hint = "; --frame N makes a .png of one frame, --sheet of ten"
            raise AnimationError(
                f"{shorten(path.name)!r} is the name of a {kind.value}: a film cannot be written as "
                f"{suffix!r}{hint if kind is OutputKind.PICTURE else ''}"
            )
        if kind is OutputKind.FILM:
            FORMATS[suffix[1:]].check(film)
    refuse_early(path, force)


@contextmanager
def open_film(
    path: Path, film: Film, samples: Samples | None = None, force: bool = False
) -> Iterator[Write]:
    """Yield a function that takes the frames in order, uint8 (height, width, 3).

    The file appears when all frames are in it; after an error there is no file. ``samples`` returns some
    frames for the palette of a GIF. Raises :class:`AnimationError` as :func:`check` does, and if the encoder
    fails or has lost a frame.
    """
    check(path, film, force)
    if kind_of(path) is OutputKind.FOLDER:
        from anim.output.pictures import open_folder

        with folder_place(path, force) as part, open_folder(part, film) as write:
            yield write
        return
    form = FORMATS[path.suffix.lower()[1:]]
    with file_place(path, force) as part, form.open(part, film, samples) as write:
        yield write
