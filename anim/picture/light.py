"""The top's shadow on the ground with a sharp edge, as an outline."""

import numpy as np
from numpy.typing import NDArray

from anim.model import Model
from anim.picture.canvas import Canvas
from anim.picture.environment import direction, environment
from anim.picture.mesh import Mesh
from anim.picture.outlines import HIDDEN, Rim, outlines
from anim.picture.projection import View, reached
from anim.picture.settings import RGB, RenderSettings
from anim.picture.solid import pieces

Floats = NDArray[np.float64]

SHADE: RGB = (0, 0, 0)
SHADE_OPACITY = 0.2
CONTACT_REACHES = 3.0
"""After so many times its reach, the darkness of a contact is less than a level of 8 bits."""
SUNK = 0.1
"""The depth below the ground, in the model's unit, up to which faces still cast a shadow."""


def places(model: Model, settings: RenderSettings) -> Floats:
    """Return points (k, 3) that cover all positions of the top, and of its shadow if it is drawn."""
    top = reached(model, settings)
    if not settings.shadow:
        return top
    above, light = top[top[:, 2] >= -SUNK], direction(settings.camera)
    thrown = above @ _fall(light)[:3, :3].T
    # The edge of a shadow is wider the farther the shadow is from the point that casts it.
    shadow = environment()["shadow"]
    edge = shadow["sharp"] + shadow["soft"] * above[:, 2] / light[2]
    # What nearly touches the ground darkens it besides, up to here.
    edge = np.maximum(edge, CONTACT_REACHES * shadow["reach"] - above[:, 2])
    around = np.linspace(0, 2 * np.pi, 8, endpoint=False)
    ways = np.column_stack([np.cos(around), np.sin(around), np.zeros(len(around))]) / light[2]
    return np.concatenate([top, *(thrown + edge[:, None] * way for way in ways)])


def _fall(light: Floats) -> Floats:
    """Return the projection (4, 4) of homogeneous points along the light onto the ground."""
    fall = np.diag([1.0, 1.0, 0.0, 1.0])
    fall[:2, 2] = -light[:2] / light[2]
    return fall


class SharpShadow:
    """Draws the shadow of a mesh under a distant light, as seen in ``view``."""

    def __init__(self, mesh: Mesh, light: Floats, view: View) -> None:
        self._mesh, self._parts, self._light = mesh, pieces(mesh), light
        self._on_ground = View(view.matrix @ _fall(light))

    def draw(self, canvas: Canvas, rotation: Floats, tip: Floats) -> None:
        """Draw the shadow of the top with attitude ``rotation`` and its tip at ``tip``.

        Each convex piece casts the shadow of its faces that are turned to the light. This is one loop or two
        of the same orientation, filled together by the nonzero winding rule. Parts below the ground cast no
        shadow.
        """
        here = self._mesh.points @ rotation.T + tip
        source = np.append(self._light @ rotation, 0.0)
        loops: list[Floats] = []
        for part in self._parts:
            keys = np.where(part.facing(source), 0, HIDDEN)
            for _, rims in outlines(Rim(here[part.low]), Rim(here[part.high]), keys):
                above = [_above_ground(rim) for rim in rims]
                loops += [self._on_ground.project(rim) for rim in above if len(rim) > 2]
        if loops:
            canvas.fill(loops, SHADE, SHADE_OPACITY)


def _above_ground(loop: Floats) -> Floats:
    """Return the part of a closed polygon (k, 3) with z ≥ 0 (Sutherland and Hodgman 1974)."""
    z = loop[:, 2]
    if z.min() >= 0:
        return loop
    successor, z_next = np.roll(loop, -1, axis=0), np.roll(z, -1)
    crosses = (z >= 0) != (z_next >= 0)
    drop = np.where(crosses, z - z_next, 1.0)
    crossing = loop + (z / drop)[:, None] * (successor - loop)
    both = np.stack([loop, crossing], axis=1).reshape(-1, 3)
    return np.asarray(both[np.column_stack([z >= 0, crosses]).ravel()])
