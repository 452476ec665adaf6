"""Smooth cones in the light, on a ground with a soft shadow.

Every edge by the area that it leaves of a pixel, averaged in linear light.
"""

import numpy as np
from numpy.typing import NDArray

from anim.model import Model
from anim.picture.light import places
from anim.picture.look import RGB, Look, colour
from anim.picture.mesh import Mesh
from anim.picture.projection import View, view
from anim.picture.room import darkness, ground, of_darkness, room
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


class ShadedBody:
    """The top under a light that is far away in the direction ``light`` (3,), a unit vector of the room."""

    def __init__(
        self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, smooth: bool, dark: float
    ) -> None:
        self._points, self._smooth, self.light = mesh.points, smooth, light
        self._rim = of_darkness("light", "rim", dark)
        self._triangles = np.ascontiguousarray(mesh.triangles)
        self._lit, self._normals = _normals(mesh)
        self._mesh = mesh
        self._palette = np.maximum(LINEAR[np.array(colours)], of_darkness("light", "darkest", dark))
        self.paints = self._palette[np.tile(mesh.keys, 4)]
        self._encoded = _encoding()

    def draw(self, canvas: Surface, view: View, rotation: Floats) -> None:
        """Draw the top as ``view`` sees it, a view of the top's own room, which ``rotation`` has turned."""
        self._paint(canvas, [view], [rotation], self.paints)

    def expose(
        self, canvas: Surface, views: list[View], rotations: list[Floats], spin: float
    ) -> None:
        """Draw the mean of moments between which the top turns by ``spin`` radians in all.

        What the bands turn from one moment to the next is spread over their colours: no steps are seen.
        """
        paints = self._spread(spin / max(1, len(views) - 1))
        self._paint(canvas, views, rotations, paints)

    def _spread(self, window: float) -> Floats:
        """Return the paints of the faces, each the mean over its own width and ``window`` radians more."""
        angles, keys = self._mesh.angles, self._mesh.keys
        dark = np.append(0.0, np.cumsum(np.diff(angles) * keys))
        half = (np.diff(angles) + abs(window)) / 2
        middles = (angles[:-1] + angles[1:]) / 2
        ends = np.stack([middles - half, middles + half])
        turns = np.floor(ends / (2 * np.pi))
        before = turns * dark[-1] + np.interp(ends - turns * 2 * np.pi, angles, dark)
        share = ((before[1] - before[0]) / (2 * half))[:, None]
        mixed = self._palette[0] * (1 - share) + self._palette[1] * share
        return np.tile(mixed, (4, 1))

    def _paint(
        self, canvas: Surface, views: list[View], rotations: list[Floats], paints: Floats
    ) -> None:
        from anim.picture.rasterising import paint, workspace

        seen = np.stack([view.project(self._points) for view in views])
        box = canvas.touch(seen.reshape(-1, 2), 0)
        width = box[2] - box[0]
        if width <= 0:
            return
        seen[..., 1] = canvas.height - seen[..., 1]
        paint(
            canvas.pixels,
            box,
            self._smooth,
            seen,
            np.array([drawing_order(view.eye) for view in views]),
            self._triangles,
            self._lit,
            np.stack([self.lighting(*moment) for moment in zip(views, rotations, strict=True)]),
            paints,
            LINEAR,
            self._encoded,
            *workspace(width, len(views), len(self._triangles)),
        )

    def lighting(self, view: View, rotation: Floats) -> Floats:
        """Return, for each normal, the share of its own colour and the white that it sends to the eye."""
        light, numbers = self.light @ rotation, room()["light"]
        up, towards = self._normals @ rotation[2], view.eye[:3] / np.linalg.norm(view.eye[:3])
        half = light + towards
        half /= np.linalg.norm(half)
        own = numbers["sky"] + numbers["rise"] * up - numbers["bounce"] * np.minimum(up, 0)
        own += numbers["sun"] * np.maximum(self._normals @ light, 0)
        white = numbers["gloss"] * np.maximum(self._normals @ half, 0) ** numbers["sharpness"]
        white += self._rim * (1 - np.clip(self._normals @ towards, 0, 1)) ** 3
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
    """Lit cones on a lit ground; on dark paper a pool of light, and a rim that shows where they end."""

    def paper_of(self, look: Look) -> RGB:
        """Return the look's background, or the room's own paper."""
        return colour("background", look.background or room()["paper"]["light"])

    def scene(self, model: Model, look: Look) -> tuple[View, Pixels]:
        """Return the projection and the ground."""
        from anim.picture.ground import grained

        seen = view(look.camera, look.size, places(model, look))
        floor = ground(seen, look, self.paper_of(look))
        pixels = np.empty(floor.shape, np.uint8)
        grained(floor, pixels)
        return seen, pixels

    def sheet(self, background: Pixels, look: Look) -> Surface:
        """Return plain pixels."""
        return Surface(background)

    def shadow(self, mesh: Mesh, light: Floats, view: View, look: Look) -> SoftShadow:
        """Return a shadow that is soft away from what throws it."""
        return SoftShadow(mesh.model.profile, light, view, ground(view, look, self.paper_of(look)))

    def body(self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, look: Look) -> ShadedBody:
        """Return the body under the light."""
        return ShadedBody(mesh, colours, light, look.quality > 1, darkness(self.paper_of(look)))


STYLE = Shaded()
