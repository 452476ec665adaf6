"""Uniform colours, without lighting.

The merged outlines of the visible faces are filled in drawing order.
"""

from itertools import pairwise
from math import hypot

import numpy as np
from numpy.typing import NDArray

from anim.picture.canvas import Canvas
from anim.picture.mesh import Mesh
from anim.picture.outlines import HIDDEN, Rim, outlines, reach_under
from anim.picture.projection import View
from anim.picture.settings import RGB, RenderSettings
from anim.picture.solid import drawing_order, pieces
from anim.picture.style import Style

Floats = NDArray[np.float64]

# Pieces that face up are lighter than the given colours, pieces that face down darker, so that the shape is
# visible also where two pieces of one colour meet.
DOWN, UP, ASIDE = -0.14, 0.30, 0.0


def tone_of(low: tuple[float, float], high: tuple[float, float]) -> float:
    """Return the tone of the piece between two points (radius, z) of an outline."""
    (r0, z0), (r1, z1) = low, high
    upwards = (r0 - r1) / hypot(r1 - r0, z1 - z0)
    return UP if upwards > 0.7 else DOWN if upwards < -0.3 else ASIDE


def tinted(colours: tuple[RGB, RGB], mesh: Mesh) -> list[tuple[RGB, RGB]]:
    """Return the two colours of each piece; neighbouring pieces differ in lightness."""

    def tone(channel: int, share: float) -> int:
        # Black cannot get darker, so every piece receives a quarter of the light.
        base = channel + 0.14 * (255 - channel) * (channel < 60)
        return round(base + share * (255 - base) * 0.7 if share > 0 else base * (1 + share))

    def shade(colour: RGB, share: float) -> RGB:
        red, green, blue = (tone(channel, share) for channel in colour)
        return red, green, blue

    tones = [tone_of(low, high) for low, high in pairwise(mesh.profile)]
    return [(shade(colours[0], s), shade(colours[1], s)) for s in tones]


class FlatBody:
    """The top in uniform colours; ``colours`` has two for each piece."""

    def __init__(self, mesh: Mesh, colours: list[tuple[RGB, RGB]]) -> None:
        self._points = mesh.points
        self._parts = pieces(mesh)
        heights = [z for _, z in mesh.profile]
        self._middles = np.array([(0, 0, (a + b) / 2) for a, b in pairwise(heights)])
        self._heights = mesh.heights
        self._keys = mesh.keys
        self._colours = colours

    def draw(self, canvas: Canvas, view: View, rotation: Floats) -> None:
        """Draw the top without lighting; ``view`` is the view in the axes of the top."""
        seen, middles = view.project(self._points), view.project(self._middles)
        order = drawing_order(view.eye, self._heights)
        canvas.touch(seen, 0)
        for place, k in enumerate(order):
            later = order[place + 1 :]
            part = self._parts[k]
            low, high = Rim(seen[part.low]), Rim(seen[part.high])
            if k - 1 in later:
                low = reach_under(low.points, middles[k - 1])
            if k + 1 in later:
                high = reach_under(high.points, middles[k + 1])
            keys = np.where(part.facing(view.eye), self._keys, HIDDEN)
            for key, loops in outlines(low, high, keys):
                canvas.fill(loops, self._colours[k][key], touched=True)


class Flat(Style):
    """Uniform colours; pieces differ in lightness."""

    def body(
        self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, settings: RenderSettings
    ) -> FlatBody:
        """Return the body in tinted colours."""
        return FlatBody(mesh, tinted(colours, mesh))


STYLE = Flat()
