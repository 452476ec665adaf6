"""Draw the top in matplotlib axes: as a picture in plain axes, or as a surface in three-dimensional axes."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PolyCollection
from mpl_toolkits.mplot3d import Axes3D
from numpy.typing import NDArray

from anim.errors import AnimationError
from anim.picture.mesh import Mesh
from anim.picture.projection import View, rim_points
from anim.picture.settings import FILM_SETTINGS, RenderSettings
from anim.picture.solid import drawing_order, pieces
from anim.picture.styles.flat import tinted
from anim.rendering import Scene, draw, framed

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from anim.model import Model
    from anim.motion import Motion

Floats = NDArray[np.float64]

PIXELS_PER_EXTENT = 300.0
"""The assumed size of the top in pixels, from which the number of points on each circle follows."""


def draw_in_axes(
    model: Model, motion: Motion, ax: Axes, t: float, settings: RenderSettings | None
) -> Artist:
    """Draw a top at ``t`` seconds of its motion into ``ax``, as described in ``Top.draw``; return
    the artist.
    """
    if not hasattr(ax, "add_collection"):
        raise AnimationError(f"ax is a {type(ax).__name__}; expected axes of matplotlib")
    if isinstance(ax, Axes3D):
        if settings is not None:
            raise AnimationError(
                "three-dimensional axes have a view of their own; expected no settings"
            )
        task = Scene(model, motion, replace(FILM_SETTINGS, trace=False)).task_at(t)
        return _surface(ax, model, task.matrices[0], task.places[0])
    if settings is None:
        window = ax.get_window_extent()
        size = max(1, round(window.width)), max(1, round(window.height))
        settings = framed(replace(FILM_SETTINGS, size=size), model, motion)
    frame = draw(Scene(model, motion, settings).task_at(t))
    picture = ax.imshow(frame, interpolation="antialiased")
    ax.set_axis_off()
    return picture


def _surface(ax: Axes3D, model: Model, rotation: Floats, tip: Floats) -> Surface3D:
    surface = Surface3D(model, rotation, tip)
    ax.add_collection(surface, autolim=False)
    ax.auto_scale_xyz(*rim_points(model, rotation[None], tip[None]).T)
    return surface


class Surface3D(PolyCollection):
    """The faces of the top that are visible in three-dimensional axes, in exact drawing order."""

    def __init__(self, model: Model, rotation: Floats, tip: Floats) -> None:
        super().__init__([], closed=True)
        mesh = Mesh.of(model, PIXELS_PER_EXTENT / model.extent)
        self._motion = np.eye(4)
        self._motion[:3, :3], self._motion[:3, 3] = rotation, tip
        self._points, self._parts, self._heights = mesh.points, pieces(mesh), mesh.heights
        colours = np.array(tinted(model.palette, mesh)) / 255
        self._colours = [pair[mesh.keys] for pair in colours]

    def do_3d_projection(self) -> float:
        """Project the faces with the current view of the axes; return the depth by which artists are
        sorted.
        """
        view = View(_towards_eye() @ self.axes.M @ self._motion)  # type: ignore[union-attr]
        seen = view.project(self._points)
        faces, colours = [], []
        for k in drawing_order(view.eye, self._heights):
            part = self._parts[k]
            shown = np.flatnonzero(part.facing(view.eye))
            low, high = part.low, part.high
            ring = np.stack([low, np.roll(low, -1), np.roll(high, -1), high], axis=1)
            faces.append(seen[ring[shown]])
            colours.append(self._colours[k][shown])
        self.set_verts(list(np.concatenate(faces)))
        tones = np.concatenate(colours)
        self.set_facecolor(tones)
        self.set_edgecolor(tones)  # closes the gaps between antialiased faces
        self.set_linewidth(0.4)
        rows = view.matrix
        depths = (self._points @ rows[2, :3] + rows[2, 3]) / (
            self._points @ rows[3, :3] + rows[3, 3]
        )
        return float(-depths.max())


def _towards_eye() -> Floats:
    """Return the matrix that reverses matplotlib's depth, which increases away from the eye."""
    return np.diag([1.0, 1.0, -1.0, 1.0])
