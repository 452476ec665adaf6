"""The description of a film for the formats, and the base class of formats."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from anim.checks import whole

Pixels = NDArray[np.uint8]
Write = Callable[[Pixels], None]
Samples = Callable[[], Sequence[Pixels]]


@dataclass(frozen=True)
class Film:
    """The size (width, height) in pixels, the number of frames, and the encoding options.

    ``crf`` (0, the best, to 51) is x264's option and also determines the quality of WebP; ``preset`` is
    x264's option. Raises :class:`AnimationError` for an invalid ``crf``.

    >>> Film((640, 480), frames=100, fps=50.0).crf
    18
    """

    size: tuple[int, int]
    frames: int
    fps: float
    crf: int = 18
    preset: str = "medium"

    def __post_init__(self) -> None:
        whole("crf", self.crf, 0, 51)


class Format(ABC):
    """A file format: a module of :mod:`anim.output.formats`, named after the suffix."""

    @property
    def name(self) -> str:
        """The suffix, without its dot."""
        return type(self).__module__.rpartition(".")[2]

    @abstractmethod
    def check(self, film: Film) -> None:
        """Raise :class:`AnimationError` for a film that this format does not support."""

    @abstractmethod
    def open(
        self, path: Path, film: Film, samples: Samples | None
    ) -> AbstractContextManager[Write]:
        """Yield a function that takes the frames in order; at the end the file is complete.

        ``samples`` returns some frames from the whole film. Raises :class:`AnimationError`.
        """
