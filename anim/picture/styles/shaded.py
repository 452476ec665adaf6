"""Smooth cones in the light, before a wall.

A z-buffer, and averaging in linear light.
"""

import numpy as np
from numpy.typing import NDArray

from anim.picture.canvas import Canvas
from anim.picture.look import RGB, Look
from anim.picture.mesh import Mesh
from anim.picture.projection import View
from anim.picture.style import Style

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Pixels = NDArray[np.uint8]

SKY, SUN = 0.30, 0.60
"""Light from all around and from the light, as shares of a face's own colour."""
WALL_TOP: RGB = (244, 243, 240)
WALL_FOOT: RGB = (206, 205, 202)
GLOSS, SHARPNESS = 0.30, 36
DARKEST = 0.012
"""The least linear light a face sends back: nothing real is blacker."""

_levels = np.arange(256) / 255
LINEAR: Floats = np.where(_levels <= 0.04045, _levels / 12.92, ((_levels + 0.055) / 1.055) ** 2.4)
"""sRGB (IEC 61966-2-1) decoded."""


class ShadedBody:
    """The top under a light that is far away in the direction ``light`` (3,), a unit vector of the room."""

    def __init__(self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, quality: int) -> None:
        self._points, self._samples, self.light = mesh.points, quality, light
        self._triangles = np.ascontiguousarray(mesh.triangles)
        self._lit, self._normals = _normals(mesh)
        palette = np.maximum(LINEAR[np.array(colours)], DARKEST)
        self.paints = palette[np.tile(mesh.keys, 4)]
        self._encoded = _encoding()

    def draw(self, canvas: Canvas, view: View, rotation: Floats) -> None:
        """Draw the top as ``view`` sees it, a view of the top's own room, which ``rotation`` has turned."""
        from anim.picture.rasterising import paint

        seen = view.project_with_depth(self._points)
        box = canvas.touch(seen[:, :2], 0)
        seen[:, 1] = canvas.height - seen[:, 1]
        paint(
            canvas.pixels,
            box,
            self._samples,
            seen,
            self._triangles,
            self._lit,
            self.lighting(view, rotation),
            self.paints,
            LINEAR,
            self._encoded,
        )

    def lighting(self, view: View, rotation: Floats) -> Floats:
        """Return, for each normal, the share of its own colour and the white that it sends to the eye."""
        light, up = self.light @ rotation, rotation[2]
        half = light + view.eye[:3] / np.linalg.norm(view.eye[:3])
        half /= np.linalg.norm(half)
        own = SKY * (1 + self._normals @ up / 3) + SUN * np.maximum(self._normals @ light, 0)
        white = GLOSS * np.maximum(self._normals @ half, 0) ** SHARPNESS
        return np.column_stack([own, white])


def _normals(mesh: Mesh) -> tuple[Indices, Floats]:
    """Return for each corner of the mesh's triangles (4·ring, 3) which normal (5·ring, 3) it has.

    A cone has one normal along each of its straight lines: the first 3·ring normals are those at the rings'
    points, on the three pieces; at tip and apex each triangle has that of its own middle.
    """
    n = mesh.ring
    here = np.arange(n)
    there = (here + 1) % n
    starts, middles = mesh.angles[:-1], (mesh.angles[:-1] + mesh.angles[1:]) / 2
    low, band, high = (_of_cone(mesh, k, starts) for k in range(3))
    normals = [low, band, high, _of_cone(mesh, 0, middles), _of_cone(mesh, 2, middles)]
    lit = [
        [here + 3 * n, there, here],
        [n + here, n + there, n + there],
        [n + here, n + there, n + here],
        [2 * n + here, 2 * n + there, here + 4 * n],
    ]
    return np.concatenate([np.column_stack(part) for part in lit]), np.concatenate(normals)


def _of_cone(mesh: Mesh, piece: int, angle: Floats) -> Floats:
    """Return the outward normals (k, 3) of a piece's cone at angles (k,) round it."""
    (r0, z0), (r1, z1) = mesh.profile[piece : piece + 2]
    rise, out = z1 - z0, r1 - r0
    normal = np.column_stack(
        [rise * np.cos(angle), rise * np.sin(angle), np.full(len(angle), -out)]
    )
    return np.asarray(normal / np.hypot(rise, out))


def _encoding() -> Pixels:
    """Return sRGB for equal steps of linear light from 0 to 1."""
    v = np.linspace(0, 1, 1 << 14)
    srgb = np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)
    return np.round(255 * srgb).astype(np.uint8)


class Shaded(Style):
    """Lit cones before a wall."""

    def background(self, look: Look) -> Pixels:
        """Return a wall a little brighter at its top; even paper where the look asks for it."""
        if look.background is not None:
            return super().background(look)
        width, height = look.size
        down = np.linspace(0, 1, height)[:, None, None]
        rows = np.array(WALL_TOP) + down * np.subtract(WALL_FOOT, WALL_TOP)
        return np.repeat(np.round(rows).astype(np.uint8), width, axis=1)

    def body(self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, quality: int) -> ShadedBody:
        """Return the body under the light; ``quality``² samples a pixel."""
        return ShadedBody(mesh, colours, light, quality)


STYLE = Shaded()
