"""Smooth lit cones, on a ground with a soft shadow.

Edges are antialiased by the exact area that they cover in a pixel, averaged in linear light.
"""

import numpy as np
from numpy.typing import NDArray

from anim.model import Model
from anim.picture.environment import darkness, environment, of_darkness
from anim.picture.light import places
from anim.picture.lit_surface import LitSurface
from anim.picture.mesh import Mesh
from anim.picture.projection import View, view
from anim.picture.settings import RGB, RenderSettings, colour
from anim.picture.soft_shadow import SoftShadow
from anim.picture.solid import drawing_order
from anim.picture.style import Style
from anim.picture.surface import Surface

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Pixels = NDArray[np.uint8]

_levels = np.arange(256) / 255
LINEAR: Floats = np.where(_levels <= 0.04045, _levels / 12.92, ((_levels + 0.055) / 1.055) ** 2.4)
"""sRGB (IEC 61966-2-1) decoded."""
EDGE_LIGHT = np.array([214.0, 222.0, 235.0])
"""The colour of the light on the top's edge on dark paper, in sRGB."""
PIXELS_PER_EDGE_PIXEL = 320
"""The edge is one pixel wide for each of so many pixels of the picture's shorter side."""
MIN_SMOOTH_COSINE = np.cos(np.radians(25))
"""The cosine of the largest angle between two pieces of one smooth curve."""


class ShadedBody:
    """The top under a distant light in the direction ``light`` (3,), a unit vector."""

    def __init__(
        self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, smooth: bool, dark: float
    ) -> None:
        self._points, self._smooth, self.light = mesh.points, smooth, light
        aside, low = np.arctan2(light[1], light[0]), np.radians(environment()["light"]["window"])
        across = np.cos(low) * np.array([np.cos(aside), np.sin(aside)])
        self._window = np.append(across, np.sin(low))
        self._rim = of_darkness("light", "rim", dark)
        self._outline = of_darkness("light", "outline", dark)
        self._covered = np.zeros((0, 0), np.float32)
        self._triangles = np.ascontiguousarray(mesh.triangles)
        self._lit, self._normals = _normals(mesh)
        self._mesh = mesh
        self._palette = np.maximum(LINEAR[np.array(colours)], of_darkness("light", "darkest", dark))
        self._groups = sum(mesh.groups)
        self._starts = mesh.ring * np.cumsum([0, *mesh.groups])
        self.paints = self._palette[np.tile(mesh.keys, self._groups)]
        self._encoded = _encoding()

    def draw(self, canvas: Surface, view: View, rotation: Floats) -> None:
        """Draw the top with attitude ``rotation``; ``view`` is the view in the axes of the top."""
        self._paint(canvas, [view], [rotation], self.paints)

    def expose(
        self, canvas: Surface, views: list[View], rotations: list[Floats], spin: float
    ) -> None:
        """Draw the mean of several moments during which the top rotates by ``spin`` radians in total.

        The rotation of the bands between moments is blended in their colours, so no steps are visible.
        """
        paints = self._spread(spin / max(1, len(views) - 1))
        self._paint(canvas, views, rotations, paints)

    def _spread(self, window: float) -> Floats:
        """Return the paints of the faces, each averaged over its own width plus ``window`` radians."""
        angles, keys = self._mesh.angles, self._mesh.keys
        dark = np.append(0.0, np.cumsum(np.diff(angles) * keys))
        half = (np.diff(angles) + abs(window)) / 2
        middles = (angles[:-1] + angles[1:]) / 2
        ends = np.stack([middles - half, middles + half])
        turns = np.floor(ends / (2 * np.pi))
        before = turns * dark[-1] + np.interp(ends - turns * 2 * np.pi, angles, dark)
        share = ((before[1] - before[0]) / (2 * half))[:, None]
        mixed = self._palette[0] * (1 - share) + self._palette[1] * share
        return np.tile(mixed, (self._groups, 1))

    def _paint(
        self, canvas: Surface, views: list[View], rotations: list[Floats], paints: Floats
    ) -> None:
        from anim.picture.rasterising import outline, paint, workspace

        seen = np.stack([view.project(self._points) for view in views])
        box = canvas.touch(seen.reshape(-1, 2), 0)
        width = box[2] - box[0]
        if width <= 0:
            return
        seen[..., 1] = canvas.height - seen[..., 1]
        size = (canvas.height, canvas.width)
        if self._outline > 0 and self._covered.shape != size:
            self._covered = np.zeros(size, np.float32)
        paint(
            canvas.pixels,
            box,
            self._smooth,
            seen,
            np.array([drawing_order(view.eye, self._mesh.heights) for view in views]),
            self._starts,
            self._triangles,
            self._lit,
            np.stack([self.lighting(*moment) for moment in zip(views, rotations, strict=True)]),
            paints,
            LINEAR,
            self._encoded,
            self._covered,
            *workspace(width, len(views), len(self._triangles), len(self._starts) - 1),
        )
        if self._outline > 0:
            reach = max(1, round(min(size) / PIXELS_PER_EDGE_PIXEL))
            outline(canvas.pixels, self._covered, box, reach, self._outline, EDGE_LIGHT)

    def lighting(self, view: View, rotation: Floats) -> Floats:
        """Return, for each normal, the share of the own colour and of white reflected to the eye."""
        light, numbers = self.light @ rotation, environment()["light"]
        up, towards = self._normals @ rotation[2], view.eye[:3] / np.linalg.norm(view.eye[:3])
        half = self._window @ rotation + towards
        half /= np.linalg.norm(half)
        own = numbers["sky"] + numbers["rise"] * up - numbers["bounce"] * np.minimum(up, 0)
        own += numbers["sun"] * np.maximum(self._normals @ light, 0)
        white = numbers["gloss"] * np.maximum(self._normals @ half, 0) ** numbers["sharpness"]
        white += self._rim * (1 - np.clip(self._normals @ towards, 0, 1)) ** 3
        return np.column_stack([own, white])


def _normals(mesh: Mesh) -> tuple[Indices, Floats]:
    """Return the index of the normal at each corner of the mesh's triangles (m, 3), and the normals (k, 3).

    A cone has one normal along each of its straight lines; at tip and apex each triangle has the normal at
    its own centre. If two pieces meet at a small angle, as in a curved outline, they share the mean of their
    normals, so no edge is visible.
    """
    n, pieces = mesh.ring, len(mesh.groups)
    here = np.arange(n)
    there = (here + 1) % n
    starts, middles = mesh.angles[:-1], (mesh.angles[:-1] + mesh.angles[1:]) / 2
    outline = np.array(mesh.profile)
    # Across the outline, (outwards, upwards), at each piece and at both its ends.
    out, rise = np.diff(outline, axis=0).T
    slopes = np.column_stack([rise, -out]) / np.hypot(rise, out)[:, None]
    low, high = slopes.copy(), slopes.copy()
    smooth = np.flatnonzero(np.sum(slopes[1:] * slopes[:-1], axis=1) > MIN_SMOOTH_COSINE)
    means = slopes[smooth] + slopes[smooth + 1]
    low[smooth + 1] = high[smooth] = means / np.hypot(*means.T)[:, None]
    blocks: dict[tuple[float, float, bool], int] = {}
    normals: list[Floats] = []

    def block(slope: Floats, angles: Floats) -> Indices:
        """Return the indices of the normals of a slope at the angles around it."""
        key = (float(slope[0]), float(slope[1]), angles is middles)
        if key not in blocks:
            blocks[key] = len(normals)
            flat = [slope[0] * np.cos(angles), slope[0] * np.sin(angles)]
            normals.append(np.column_stack([*flat, np.full(n, slope[1])]))
        return n * blocks[key] + here

    lit: list[Indices] = []
    for k in range(pieces):
        below, above = block(low[k], starts), block(high[k], starts)
        if k == 0:
            middle = block(slopes[k], middles)
            lit.append(np.column_stack([middle, above[there], above]))
        elif k < pieces - 1:
            lit.append(np.column_stack([below, below[there], above[there]]))
            lit.append(np.column_stack([below, above[there], above]))
        else:
            middle = block(slopes[k], middles)
            lit.append(np.column_stack([below, below[there], middle]))
    return np.concatenate(lit), np.concatenate(normals)


def _encoding() -> Pixels:
    """Return sRGB for equal steps of linear light from 0 to 1."""
    v = np.linspace(0, 1, 1 << 14)
    srgb = np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)
    return np.round(255 * srgb).astype(np.uint8)


class Shaded(Style):
    """Lit cones on lit ground; on dark paper, a pool of light and a bright rim."""

    def paper_of(self, settings: RenderSettings) -> RGB:
        """Return the background of the settings, or the paper of the environment."""
        return colour("background", settings.background or environment()["paper"]["light"])

    def scene(self, model: Model, settings: RenderSettings) -> tuple[View, LitSurface]:
        """Return the projection and the ground."""
        seen = view(settings.camera, settings.size, places(model, settings))
        return seen, LitSurface(seen, settings, self.paper_of(settings))

    def shadow(self, mesh: Mesh, light: Floats, view: View, settings: RenderSettings) -> SoftShadow:
        """Return a shadow that becomes softer away from the object that casts it."""
        return SoftShadow(mesh.profile, light, view)

    def body(
        self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, settings: RenderSettings
    ) -> ShadedBody:
        """Return the body under the light."""
        return ShadedBody(
            mesh, colours, light, settings.quality > 1, darkness(self.paper_of(settings))
        )


STYLE = Shaded()
