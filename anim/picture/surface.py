"""The pixels that pictures are drawn on; a fixed background is restored before each picture.

Lit pictures are drawn by our own kernels, which compute the covered share of each pixel; `canvas` adds the
outlines of matplotlib's renderer.
"""

from collections.abc import Sequence
from math import ceil, floor

import numpy as np
from numpy.typing import NDArray

from anim.picture.settings import RGB

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]
Box = tuple[int, int, int, int]

MARK = 2
"""Pixels beyond the points given that a smoothed edge can touch."""


class Surface:
    """An RGB picture over a fixed background (height, width, 3); coordinates are pixels, y upwards."""

    def __init__(self, background: Pixels) -> None:
        self.height, self.width = background.shape[:2]
        self._background = background
        self._mask = np.zeros((self.height, self.width), np.float32)
        self.clear()

    def clear(self) -> None:
        """Start a new picture with the background."""
        self.pixels: Pixels = self._background.copy()

    def touch(self, points: Floats, width: float) -> Box:
        """Return the box that a line through ``points`` (k, 2) touches: left, top, right, bottom."""
        edge = width / 2 + MARK
        (west, south), (east, north) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        return (
            min(self.width, max(0, floor(west - edge))),
            min(self.height, max(0, floor(self.height - north - edge))),
            max(0, min(self.width, ceil(east + edge))),
            max(0, min(self.height, ceil(self.height - south + edge))),
        )

    def stroke(self, lines: Sequence[Floats], colour: RGB, width: float) -> None:
        """Draw open lines ``width`` pixels wide, with round ends.

        A line passes through points (k, 2), or (k, 3) with the opacity, from 0 to 1, as third coordinate.
        """
        from anim.picture.lines import draw_line

        ink = np.array(colour, dtype=np.float64)
        for line in lines:
            self.touch(line[:, :2], width)
            points = np.ones((len(line), 3))
            points[:, : line.shape[1]] = line
            draw_line(self.pixels, self._mask, points, width / 2, ink)

    def move(self, centre: Floats) -> None:
        """Show the background for a camera moved to ``centre`` (2,); plain paper does not change."""

    def rgb(self) -> Pixels:
        """Return the picture, (height, width, 3)."""
        return self.pixels
