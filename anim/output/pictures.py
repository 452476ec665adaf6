"""A folder of pictures: frame_00000.png and so on."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from anim.errors import AnimationError

if TYPE_CHECKING:
    from anim.output.format import Film, Pixels, Write

COMPRESSION = 3  # of 9: more takes three times as long for a tenth of the size


@contextmanager
def open_folder(folder: Path, film: Film) -> Iterator[Write]:
    """Yield a function that writes each frame as the next picture of ``folder``."""
    digits = max(5, len(str(film.frames - 1)))
    written = 0

    def write(frame: Pixels) -> None:
        nonlocal written
        save_png(frame, folder / f"frame_{written:0{digits}}.png")
        written += 1

    yield write
    if written != film.frames:
        raise AnimationError(f"{written} of {film.frames} frames were drawn")


def save_png(frame: Pixels, path: Path) -> None:
    """Write one picture. Raises :class:`AnimationError` if the disk is full or fails."""
    from PIL import Image

    try:
        Image.fromarray(frame).save(path, format="PNG", compress_level=COMPRESSION)
    except OSError as error:
        raise AnimationError(
            f"the picture could not be written: {error.strerror or error}"
        ) from None
