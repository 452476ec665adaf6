"""A reusable canvas over matplotlib's Agg renderer.

There are no figures, axes or artists: outlines are passed directly to the renderer, and before each picture
only the pixels changed by the previous picture are restored from the background.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from anim.picture.settings import RGB
from anim.picture.surface import Box, Floats, Pixels, Surface
from hfield.plotting import import_matplotlib


class Canvas(Surface):
    """An RGB picture over a fixed background (height, width, 3); coordinates are pixels, y upwards."""

    def __init__(self, background: Pixels, smooth: bool = True) -> None:
        import_matplotlib()
        from matplotlib.backend_bases import GraphicsContextBase
        from matplotlib.backends.backend_agg import RendererAgg
        from matplotlib.transforms import IdentityTransform

        self.height, self.width = background.shape[:2]
        self._background = np.ascontiguousarray(background)
        self._renderer = RendererAgg(self.width, self.height, 72)
        self.pixels: Pixels = np.asarray(self._renderer.buffer_rgba())
        """The renderer's own memory, (height, width, 4), top row first; the fourth channel stays 255."""
        self.pixels[..., :3], self.pixels[..., 3] = background, 255
        # A pixel as one number: whole rows are put back at the speed of memory.
        self._words = self.pixels.view(np.uint32)[..., 0]
        self._blank = self._words.copy()
        self._context = GraphicsContextBase()
        self._context.set_snap(False)
        self._context.set_antialiased(smooth)
        self._context.set_linewidth(0)
        self._identity = IdentityTransform()
        self._mask = np.zeros((self.height, self.width), np.float32)
        self._touched = (self.width, self.height, 0, 0)

    def clear(self) -> None:
        """Restore the background."""
        left, top, right, bottom = self._touched
        self._words[top:bottom, left:right] = self._blank[top:bottom, left:right]
        self._touched = (self.width, self.height, 0, 0)

    def fill(
        self, loops: Sequence[Floats], colour: RGB, opacity: float = 1.0, touched: bool = False
    ) -> None:
        """Fill several closed polygons (k, 2) together, by the nonzero winding rule.

        ``touched`` means that :meth:`touch` has already been called for them.
        """
        path = _path(loops)
        if not touched:
            self.touch(path.vertices, 0)
        self._context.set_alpha(opacity)
        face = tuple(channel / 255 for channel in colour)
        self._renderer.draw_path(self._context, path, self._identity, face)

    def touch(self, points: Floats, width: float) -> Box:
        """Mark the bounding box of ``points`` (k, 2) as drawn; return it: left, top, right, bottom."""
        box = super().touch(points, width)
        t = self._touched
        self._touched = (min(t[0], box[0]), min(t[1], box[1]), max(t[2], box[2]), max(t[3], box[3]))
        return box

    def rgb(self) -> Pixels:
        """Return a new copy of the picture, (height, width, 3)."""
        from anim.picture.lines import opaque

        picture = self._background.copy()
        opaque(self.pixels, self._touched, picture)
        return picture


def _path(lines: Sequence[Floats]) -> Any:
    """Return one Agg path through all the lines, starting anew for each."""
    from matplotlib.path import Path

    points = np.concatenate(lines)
    codes = np.full(len(points), Path.LINETO, dtype=Path.code_type)
    codes[np.cumsum([0, *map(len, lines[:-1])])] = Path.MOVETO
    path = Path(points, codes)
    path.should_simplify = False  # whatever the user's settings are
    return path
