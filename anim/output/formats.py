"""What a film is besides its pictures, and which writer a suffix stands for."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from anim.checks import whole
from anim.errors import AnimationError
from anim.output.encoder import ffmpeg, open_encoder
from anim.output.place import file_place, folder_place, refuse_early
from hfield.errors import shorten

Frame = NDArray[np.uint8]
Write = Callable[[Frame], None]
Samples = Callable[[], Sequence[Frame]]

SUFFIXES = (".mp4", ".gif", ".apng", ".webp", ".html")
GIF_FPS = 50.0  # browsers slow down pictures shown for less than two hundredths of a second
SLOWEST_FPS = 0.01  # a gif shows a picture for eleven minutes at most
WEBP_SIDE = 16_383


@dataclass(frozen=True)
class Film:
    """The size (width, height) in pixels, the number of frames, and how they are to be encoded.

    ``crf`` (0 best to 51) and ``preset`` are x264's; the other formats have no such choice. Raises
    :class:`AnimationError` for another ``crf``.
    """

    size: tuple[int, int]
    frames: int
    fps: float
    crf: int = 18
    preset: str = "medium"

    def __post_init__(self) -> None:
        whole("crf", self.crf, 0, 51)


def is_folder(path: Path) -> bool:
    """Tell whether a name stands for a folder of pictures: it has no suffix, or exists as a folder."""
    if path.name in SUFFIXES:
        raise AnimationError(f"{path.name!r} is a suffix without a name; try top{path.name}")
    if path.suffix.lower() in SUFFIXES:
        return False
    return not path.suffix or os.path.isdir(path)


def check(path: Path, film: Film | None, force: bool = False) -> None:
    """Refuse at once what would fail in the end; ``film`` is None for a page of HTML.

    Raises :class:`AnimationError` for an unknown suffix, a size or pace that the format cannot have, a
    file that exists (without ``force``), a folder that is missing or cannot be written, and without ffmpeg.
    """
    suffix = path.suffix.lower()
    if suffix in SUFFIXES and os.path.isdir(path):
        raise AnimationError(f"{shorten(path)!r} is a folder; choose another name")
    if not is_folder(path) and suffix not in SUFFIXES:
        hint = "; --sheet makes one .png of ten frames" if suffix == ".png" else ""
        raise AnimationError(
            f"{shorten(path.name)!r}: no film can be written as {suffix!r}; expected {', '.join(SUFFIXES)}, "
            f"or a name without suffix for a folder of pictures{hint}"
        )
    if film is not None:
        _check_film(suffix, film)
    refuse_early(path, force)
    if film is not None and suffix in SUFFIXES:
        ffmpeg()


def _check_film(suffix: str, film: Film) -> None:
    width, height = film.size
    if suffix == ".mp4" and (width % 2 or height % 2):
        raise AnimationError(
            f"mp4 needs an even width and height, not {width}x{height}; "
            f"try --size {width + width % 2}x{height + height % 2}"
        )
    if suffix in SUFFIXES and film.fps < SLOWEST_FPS:
        raise AnimationError(
            f"{film.fps:g} frames a second are too few for {suffix}; expected {SLOWEST_FPS:g} or more"
        )
    if suffix == ".gif" and film.fps > GIF_FPS:
        raise AnimationError(
            f"a gif shows at most {GIF_FPS:g} frames a second, not {film.fps:g}; "
            "lower --fps, or choose .webp, .apng or .mp4"
        )
    if suffix == ".webp" and max(film.size) > WEBP_SIDE:
        raise AnimationError(f"webp is at most {WEBP_SIDE} pixels wide and high")


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
    if is_folder(path):
        from anim.output.pictures import open_folder

        with folder_place(path) as part, open_folder(part, film) as write:
            yield write
        return
    with file_place(path) as part, open_encoder(part, film, samples) as write:
        yield write
