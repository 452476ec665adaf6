"""The shadow of the top on lit ground: soft, but sharp and dark near the contact."""

import numpy as np
from numpy.typing import NDArray

from anim.outline import Profile, simplified
from anim.picture.environment import environment, to_ground
from anim.picture.lit_surface import LitSurface
from anim.picture.projection import View

Floats = NDArray[np.float64]

STEP = 0.035
"""The distance on the ground of the points at which the light is computed."""
OUTLINE_TOLERANCE = 0.01
"""The largest distance of the outline that casts the shadow from the true one: below its softness."""
BEHIND = 0.02
"""Ground at less of the camera's distance than this is beside or behind it."""


class SoftShadow:
    """Draws the shadow of the top on lit ground."""

    def __init__(self, profile: Profile, light: Floats, view: View) -> None:
        self._light, self._view = light, view
        self._rings: Floats = np.array(simplified(profile, OUTLINE_TOLERANCE))
        wider, taller = np.diff(self._rings, axis=0).T
        solid = taller > 0  # a flat ring is the end of a cone
        growth = (wider[solid] / taller[solid])[:, None]
        self._cones = np.hstack([self._rings[:-1][solid], self._rings[1:][solid], growth])
        self._numbers = np.array(
            [environment()["shadow"][n] for n in ("depth", "sharp", "soft", "contact", "reach")]
        )

    def draw(self, canvas: LitSurface, rotation: Floats, tip: Floats) -> None:
        """Draw the shadow of the top with attitude ``rotation`` and its tip at ``tip``."""
        from anim.picture.ground_kernels import lay, shade

        if self._view.eye[2] <= 0:
            return
        axis = np.ascontiguousarray(rotation[:, 2])
        radius, height = self._rings.T
        centres = tip + height[:, None] * axis
        falls = centres[:, :2] - centres[:, 2:] / self._light[2] * self._light[:2]
        _, sharp, soft, _, reach = self._numbers
        wide = radius + sharp + soft * (np.abs(centres[:, 2]) + radius) / self._light[2]
        near = centres[:, 2] < radius + 3 * reach
        near[1:] |= near[:-1]  # and where such a cone ends
        near[:-1] |= near[1:]
        middles = np.concatenate([falls, centres[near, :2]])
        far = np.concatenate([wide / self._light[2], radius[near] + 3 * reach])[:, None]
        low, high = (middles - far).min(axis=0), (middles + far).max(axis=0)
        columns, rows = np.ceil((high - low) / STEP).astype(int) + 1
        grid = np.empty((rows, columns), np.float32)
        shade(grid, low, STEP, self._cones, tip, axis, self._light, self._numbers)
        corners = np.array([(x, y, 0.0) for x in (low[0], high[0]) for y in (low[1], high[1])])
        if (corners @ self._view.matrix[3, :3] + self._view.matrix[3, 3]).min() > BEHIND:
            seen = self._view.project(corners)
        else:
            seen = np.array([[0.0, 0.0], [canvas.width, canvas.height]])
        box = canvas.touch(seen, 0)
        lay(
            canvas.pixels,
            box,
            canvas.floor,
            to_ground(self._view, canvas.height),
            grid,
            low,
            STEP,
        )
