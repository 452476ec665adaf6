"""One painter for all styles: background, shadow, the trace behind, the top, the trace before it."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from anim.errors import AnimationError
from anim.model import Model
from anim.picture.look import RGB, Look, colour
from anim.picture.mesh import Mesh
from anim.picture.projection import reached
from anim.picture.room import direction, trace_of
from anim.picture.style import Exposing
from anim.picture.styles import STYLES
from anim.picture.trace import near_and_far

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]


class Painter:
    """Draws a model in a look, one attitude a call.

    What :meth:`draw` returns depends on its arguments only. A painter reuses one canvas: use one a
    thread; it pickles as its model and look, so that other processes can have their own.
    """

    def __init__(self, model: Model, look: Look) -> None:
        self.model, self.look = model, look
        style = STYLES[look.style]
        self.view, background = style.scene(model, look)
        paper = style.paper_of(look)
        self.trace = trace_of(paper)
        self.mesh = Mesh.of(model, self.view.magnification(reached(model, look)))
        self.light = direction(look.camera)
        self.body = style.body(self.mesh, _colours(model, look), self.light, look)
        self.shadow = style.shadow(self.mesh, self.light, self.view, look)
        self.canvas = style.sheet(background, look)
        self._pen = max(1.0, min(look.size) / 320)

    def __reduce__(self) -> tuple[type["Painter"], tuple[Model, Look]]:
        return Painter, (self.model, self.look)

    def draw(
        self, matrix: ArrayLike, trail: ArrayLike | None = None, place: ArrayLike = (0, 0, 0)
    ) -> Pixels:
        """Return the picture, uint8 (height, width, 3), sRGB, top row first.

        ``matrix`` (3, 3) is the rotation that takes the model to its attitude, ``trail`` (k, 3) the
        places of the apex up to now; they are drawn when the look asks for the trace. The tip is at
        ``place`` (3,). Raises
        :class:`~anim.errors.AnimationError` for anything but a rotation and finite points.
        """
        return self._draw([_rotation(matrix)], [_place(place)], trail, 0.0)

    def expose(
        self, matrices: ArrayLike, trail: ArrayLike | None, places: ArrayLike, spin: float
    ) -> Pixels:
        """Return the picture of an open shutter: attitudes (k, 3, 3) at places (k, 3).

        They are evenly apart in time; ``spin`` is the turn in radians about the top's own axis from the first
        to the last. Shadow and trace are those of the middle. A style that cannot expose draws every moment,
        of which the mean is taken.
        """
        rotations = [_rotation(matrix) for matrix in np.asarray(matrices, dtype=np.float64)]
        tips = [_place(place) for place in np.asarray(places, dtype=np.float64)]
        if isinstance(self.body, Exposing):
            return self._draw(rotations, tips, trail, spin)
        total = np.zeros((*self.look.size[::-1], 3), dtype=np.uint32)
        for rotation, tip in zip(rotations, tips, strict=True):
            total += self._draw([rotation], [tip], trail, 0.0)
        count = len(rotations)
        return ((2 * total + count) // (2 * count)).astype(np.uint8)

    def _draw(
        self, rotations: list[Floats], tips: list[Floats], trail: ArrayLike | None, spin: float
    ) -> Pixels:
        rotation, tip = rotations[len(rotations) // 2], tips[len(tips) // 2]
        canvas = self.canvas
        canvas.clear()
        near: list[Floats] = []
        from_above = self.view.eye[2] >= 0
        if self.look.shadow and from_above:
            self.shadow.draw(canvas, rotation, tip)
        if self.look.trace and trail is not None:
            near, far = near_and_far(_points(trail), self.view, tip)
            canvas.stroke(far, self.trace, self._pen)
        views = [self.view.moved(*moment) for moment in zip(rotations, tips, strict=True)]
        if len(views) > 1 and isinstance(self.body, Exposing):
            self.body.expose(canvas, views, rotations, spin)
        else:
            self.body.draw(canvas, views[0], rotation)
        canvas.stroke(near, self.trace, self._pen)
        if self.look.shadow and not from_above:
            self.shadow.draw(canvas, rotation, tip)
        picture: Pixels = canvas.rgb()
        return picture


def painter(model: Model, look: Look | None = None) -> Painter:
    """Return the painter of a model in a look (by default ``Look()``)."""
    return Painter(model, Look() if look is None else look)


def _colours(model: Model, look: Look) -> tuple[RGB, RGB]:
    """Return the two colours of the top."""
    if look.colours is None:
        return model.palette
    first, second = (colour("a colour of the top", c) for c in look.colours)
    return first, second


def _rotation(matrix: ArrayLike) -> Floats:
    values = np.asarray(matrix, dtype=np.float64)
    if values.shape != (3, 3):
        raise AnimationError(f"the attitude has the shape {values.shape}; expected (3, 3)")
    if not (np.abs(values @ values.T - np.eye(3)).max() < 1e-6 and np.linalg.det(values) > 0):
        raise AnimationError("the attitude is not a rotation matrix: its rows are not orthonormal")
    return values


def _place(place: ArrayLike) -> Floats:
    values = np.asarray(place, dtype=np.float64)
    if values.shape != (3,) or not np.isfinite(values).all():
        raise AnimationError(f"the tip's place is {place!r}; expected three finite numbers")
    return values


def _points(trail: ArrayLike) -> Floats:
    values = np.asarray(trail, dtype=np.float64)
    if values.ndim != 2 or values.shape[1] != 3 or not np.isfinite(values).all():
        raise AnimationError(
            f"the trail has the shape {values.shape}; expected (k, 3), finite numbers"
        )
    return values
