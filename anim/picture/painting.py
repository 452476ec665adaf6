"""The painter for all styles: background, shadow, the path behind the top, the top, the path in
front of it.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from anim.errors import AnimationError
from anim.model import Model
from anim.outline import simplified
from anim.picture.environment import direction, trace_of
from anim.picture.mesh import Mesh
from anim.picture.projection import reached
from anim.picture.settings import RGB, RenderSettings, colour
from anim.picture.style import Exposing
from anim.picture.styles import STYLES
from anim.picture.trace import in_sight, near_and_far, on_near_side, strengths

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]
Path = tuple[Floats, Floats]
"""Places of the apex (k, 3), and the opacity of the path there (k,)."""

HIDING_TOLERANCE = 0.003
"""The largest distance of the outline that hides the path from the true one, relative to the extent."""


class Painter:
    """A painter of one model with given settings; each call draws one attitude.

    The result of :meth:`draw` depends only on its arguments. A painter reuses one canvas, so each thread
    needs its own; it is pickled as its model and settings, so that other processes can build their own.
    """

    def __init__(self, model: Model, settings: RenderSettings) -> None:
        self.model, self.settings = model, settings
        style = STYLES[settings.style]
        self._magnified = 1.0 if style.fixed_axes else model.magnified
        model = model.scaled(self._magnified)
        if settings.reach:
            settings = replace(
                settings, reach=tuple(map(tuple, self._magnified * np.array(settings.reach)))
            )
        self.view, self.canvas = style.scene(model, settings)
        self.trace = trace_of(style.paper_of(settings))
        self.mesh = Mesh.of(model, self.view.magnification(reached(model, settings)))
        self.light = direction(settings.camera)
        self.body = style.body(self.mesh, _colours(model, settings), self.light, settings)
        self.shadow = style.shadow(self.mesh, self.light, self.view, settings)
        self._pen = max(1.0, min(settings.size) / 320)
        # A wide top extends beyond the apex's sphere; then the outline decides what is hidden.
        self._wide = (
            ()
            if model.extent <= model.height
            else simplified(model.profile, HIDING_TOLERANCE * model.extent)
        )

    def __reduce__(self) -> tuple[type["Painter"], tuple[Model, RenderSettings]]:
        return Painter, (self.model, self.settings)

    def draw(
        self,
        matrix: ArrayLike,
        trail: ArrayLike | None = None,
        place: ArrayLike = (0, 0, 0),
        ages: ArrayLike | None = None,
        centre: ArrayLike = (0, 0),
    ) -> Pixels:
        """Return the picture, uint8 (height, width, 3), sRGB, top row first.

        ``matrix`` (3, 3) is the attitude of the model. ``trail`` (k, 3) are the positions of the apex so far;
        they are drawn if the settings have a trace, and fade with their ``ages`` (k,) in seconds, if given.
        The tip is at ``place`` (3,), and the camera is centred at ``centre`` (2,) on the ground; lengths are
        in the model's unit. Raises :class:`~anim.errors.AnimationError` for anything but a rotation and
        finite points.
        """
        return self._draw(
            [_rotation(matrix)], [self._place(place)], self._path(trail, ages), centre, 0.0
        )

    def expose(
        self,
        matrices: ArrayLike,
        trail: ArrayLike | None,
        places: ArrayLike,
        spin: float,
        ages: ArrayLike | None = None,
        centre: ArrayLike = (0, 0),
    ) -> Pixels:
        """Return the picture for an open shutter: attitudes (k, 3, 3) at positions (k, 3).

        They are equally spaced in time; ``spin`` is the rotation in radians about the top's own axis from the
        first to the last. Shadow, trace and camera are those of the middle moment. A style that cannot expose
        draws every moment, and the result is the mean.
        """
        rotations = [_rotation(matrix) for matrix in np.asarray(matrices, dtype=np.float64)]
        tips = [self._place(place) for place in np.asarray(places, dtype=np.float64)]
        path = self._path(trail, ages)
        if isinstance(self.body, Exposing):
            return self._draw(rotations, tips, path, centre, spin)
        total = np.zeros((*self.settings.size[::-1], 3), dtype=np.uint32)
        for rotation, tip in zip(rotations, tips, strict=True):
            total += self._draw([rotation], [tip], path, centre, 0.0)
        count = len(rotations)
        return ((2 * total + count) // (2 * count)).astype(np.uint8)

    def _place(self, place: ArrayLike) -> Floats:
        """Return a place of the tip in the picture's unit."""
        values = np.asarray(place, dtype=np.float64)
        if values.shape != (3,) or not np.isfinite(values).all():
            raise AnimationError(f"the tip's place is {place!r}; expected three finite numbers")
        return self._magnified * values

    def _path(self, trail: ArrayLike | None, ages: ArrayLike | None) -> Path | None:
        """Return the apex's path in the picture's unit, if it is drawn."""
        if trail is None or not self.settings.trace:
            return None
        points = _points(trail)
        if ages is None:
            return self._magnified * points, np.ones(len(points))
        times = np.asarray(ages, dtype=np.float64)
        if times.shape != points.shape[:1]:
            raise AnimationError(
                f"the ages have the shape {times.shape}; expected one for each point"
            )
        return self._magnified * points, strengths(times)

    def _near(self, trail: Floats, rotation: Floats, tip: Floats) -> NDArray[np.bool_]:
        """Return which points of the apex's path (k, 3) are in front of the top."""
        if not self._wide:
            return on_near_side(trail, self.view.eye, tip)
        eye = self.view.moved(rotation, tip).eye
        return in_sight((trail - tip) @ rotation, eye, self._wide)

    def _draw(
        self,
        rotations: list[Floats],
        tips: list[Floats],
        path: Path | None,
        centre: ArrayLike,
        spin: float,
    ) -> Pixels:
        canvas = self.canvas
        if self.settings.follow:
            gone = self._magnified * np.append(centre, 0.0)
            canvas.move(gone[:2])
            tips = [tip - gone for tip in tips]
            path = path and (path[0] - gone, path[1])
        rotation, tip = rotations[len(rotations) // 2], tips[len(tips) // 2]
        canvas.clear()
        near: list[Floats] = []
        from_above = self.view.eye[2] >= 0
        if self.settings.shadow and from_above:
            self.shadow.draw(canvas, rotation, tip)
        if path is not None:
            trail, ink = path
            near, far = near_and_far(trail, self.view, self._near(trail, rotation, tip), ink)
            canvas.stroke(far, self.trace, self._pen)
        views = [self.view.moved(*moment) for moment in zip(rotations, tips, strict=True)]
        if len(views) > 1 and isinstance(self.body, Exposing):
            self.body.expose(canvas, views, rotations, spin)
        else:
            self.body.draw(canvas, views[0], rotation)
        canvas.stroke(near, self.trace, self._pen)
        if self.settings.shadow and not from_above:
            self.shadow.draw(canvas, rotation, tip)
        picture: Pixels = canvas.rgb()
        return picture


def painter(model: Model, settings: RenderSettings | None = None) -> Painter:
    """Return the painter of a model with settings (by default ``RenderSettings()``)."""
    return Painter(model, RenderSettings() if settings is None else settings)


def _colours(model: Model, settings: RenderSettings) -> tuple[RGB, RGB]:
    """Return the two colours of the top."""
    if settings.colours is None:
        return model.palette
    first, second = (colour("a colour of the top", c) for c in settings.colours)
    return first, second


def _rotation(matrix: ArrayLike) -> Floats:
    values = np.asarray(matrix, dtype=np.float64)
    if values.shape != (3, 3):
        raise AnimationError(f"the attitude has the shape {values.shape}; expected (3, 3)")
    if not (np.abs(values @ values.T - np.eye(3)).max() < 1e-6 and np.linalg.det(values) > 0):
        raise AnimationError("the attitude is not a rotation matrix: its rows are not orthonormal")
    return values


def _points(trail: ArrayLike) -> Floats:
    values = np.asarray(trail, dtype=np.float64)
    if values.ndim != 2 or values.shape[1] != 3 or not np.isfinite(values).all():
        raise AnimationError(
            f"the trail has the shape {values.shape}; expected (k, 3), finite numbers"
        )
    return values
