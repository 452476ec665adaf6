"""The projection from space to the picture: a 4 × 4 projective matrix and the eye.

A :class:`View` maps homogeneous points (x, y, z, 1) of space to (u·w, v·w, d·w, w): u and v are pixels from
the picture's lower left corner, and d increases towards the eye and is linear on plane faces. The eye is a
homogeneous point too, so parallel rays (an eye at infinity) are not a special case (Hartley and Zisserman,
Multiple View Geometry, chapter 6).
"""

from dataclasses import dataclass
from functools import cached_property
from math import cos, radians, sin

import numpy as np
from numpy.typing import NDArray

from anim.errors import AnimationError
from anim.model import Model
from anim.picture.settings import Camera, RenderSettings

Floats = NDArray[np.float64]

MARGIN = 0.03
"""The share of the picture left free at each edge."""
DIRECTIONS = 400
"""The number of directions in which the farthest points are found, to fit the view."""
MIN_MARGIN = 2.0
"""How many pixels are left free in a small picture, where the lines are wide for it."""


@dataclass(frozen=True, eq=False)
class View:
    """A projection from space to a picture; the module describes ``matrix`` (4, 4)."""

    matrix: Floats

    @cached_property
    def eye(self) -> Floats:
        """The eye in homogeneous coordinates (4,): (position, 1), or (direction towards it, 0) for parallel
        rays.
        """
        rows = self.matrix[[0, 1, 3]]
        thirds = (np.delete(rows, n, axis=1) for n in range(4))
        minors = [a @ np.cross(b, c) for a, b, c in thirds]  # no division, whatever the rows are
        eye = np.array([-minors[0], minors[1], -minors[2], minors[3]])
        eye = -eye if eye[3] < 0 else eye
        length = float(np.linalg.norm(eye[:3]))
        # An eye more than a million units away is at infinity; the sign determines the side.
        if eye[3] * 1e6 > length:
            return np.asarray(eye / eye[3])
        towards = np.cross(rows[0, :3], rows[1, :3]) * np.sign(rows[2, 3])
        return np.append(towards / np.linalg.norm(towards), 0.0)

    def moved(self, rotation: Floats, place: Floats) -> "View":
        """Return the view in the coordinates of the moved top, in which the top is at rest."""
        motion = np.eye(4)
        motion[:3, :3], motion[:3, 3] = rotation, place
        view = View(self.matrix @ motion)
        # The eye need not be computed again: it moves in the opposite direction.
        x, w = self.eye[:3], self.eye[3]
        view.__dict__["eye"] = np.append((x - w * place) @ rotation, w)
        return view

    def project(self, points: Floats) -> Floats:
        """Return the pixels (k, 2), x to the right and y upwards, of ``points`` (k, 3)."""
        rows = self.matrix[[0, 1, 3]]
        u, v, w = rows[:, :3] @ points.T + rows[:, 3:]
        return np.column_stack([u / w, v / w])

    def magnification(self, points: Floats) -> float:
        """Return the maximal number of pixels per unit of length at the ``points`` (k, 3)."""
        rows = self.matrix[[0, 1, 3]]
        u, v, w = (rows[:, :3] @ points.T + rows[:, 3:])[..., None]
        across, up = ((rows[n, :3] - seen / w * rows[2, :3]) / w for n, seen in enumerate((u, v)))
        return float(np.sqrt(np.sum(across**2 + up**2, axis=1).max()))


def view(camera: Camera, size: tuple[int, int], places: Floats) -> View:
    """Return the camera's view, scaled so that all ``places`` (k, 3) are in the picture."""
    raw = View(_camera_matrix(camera))
    reach = float(np.linalg.norm(places, axis=1).max())
    if raw.eye[3] and np.linalg.norm(raw.eye[:3]) < 1.2 * reach:
        raise AnimationError(
            f"a camera at a distance of {camera.distance:g} is too near to a top that "
            f"reaches {reach:.3g} far; let it follow the top"
        )
    scale, shift = fitting(raw.project(places), size, MARGIN, camera.zoom)
    place = np.array(
        [[scale, 0, 0, shift[0]], [0, scale, 0, shift[1]], [0, 0, 1, 0], [0, 0, 0, 1]], dtype=float
    )
    return View(place @ raw.matrix)


def fitting(
    seen: Floats, size: tuple[int, int], margin: float, zoom: float
) -> tuple[float, Floats]:
    """Return the scale and the shift (2,) such that the points ``seen`` (k, 2) fill a picture, centred.

    ``margin`` is the share of the picture left free at each edge; ``zoom`` enlarges about the centre.
    """
    low, high = seen.min(axis=0), seen.max(axis=0)
    whole = np.array(size)
    free = np.minimum(np.maximum(margin * whole, MIN_MARGIN), whole / 4)
    scale = float(np.min((whole - 2 * free) / (high - low))) * zoom
    return scale, whole / 2 - scale * (low + high) / 2


def reached(model: Model, settings: RenderSettings) -> Floats:
    """Return points (k, 3) that cover all positions of the top that must stay in the picture."""
    if settings.reach:
        return np.array(settings.reach)
    around = np.linspace(0, 2 * np.pi, 36, endpoint=False)
    turns = [_about_z(turn) for turn in around[::2]]
    leans = [_about_y(lean) for lean in np.radians(np.linspace(0, settings.tilt, 10))]
    attitudes = np.array([turn @ lean for lean in leans for turn in turns])
    return rim_points(model, attitudes, np.zeros((len(attitudes), 3)))


def rim_points(model: Model, attitudes: Floats, tips: Floats) -> Floats:
    """Return points (k, 3) on the rims of the top for attitudes (n, 3, 3) with the tip at ``tips`` (n, 3)."""
    around = np.linspace(0, 2 * np.pi, 36, endpoint=False)
    circle = np.column_stack([np.cos(around), np.sin(around)])
    rims = [
        np.column_stack([r * circle, np.full(len(circle), z)]) if r else np.array([[0, 0, z]])
        for r, z in model.profile
    ]
    body = np.concatenate(rims)
    return np.asarray((body @ attitudes.swapaxes(1, 2) + tips[:, None]).reshape(-1, 3))


def outermost(points: Floats) -> Floats:
    """Return those ``points`` (k, 3) that are the farthest in one of many directions.

    A picture that shows these shows all points, up to a four-hundredth of their extent.
    """
    # Fibonacci's directions are even on the sphere.
    height = (np.arange(DIRECTIONS) + 0.5) / DIRECTIONS * 2 - 1
    turn = np.arange(DIRECTIONS) * np.pi * (3 - np.sqrt(5))
    out = np.sqrt(1 - height**2)
    directions = np.column_stack([out * np.cos(turn), out * np.sin(turn), height])
    farthest = {int(np.argmax(points @ direction)) for direction in directions}
    return np.asarray(points[sorted(farthest)])


def frame(camera: Camera) -> Floats:
    """Return the camera's axes as rows (3, 3): right, up in the picture, towards the eye."""
    a, e = radians(camera.azimuth), radians(camera.elevation)
    right = np.array([-sin(a), cos(a), 0.0])
    towards = np.array([cos(e) * cos(a), cos(e) * sin(a), sin(e)])
    return np.array([right, np.cross(towards, right), towards])


def _camera_matrix(camera: Camera) -> Floats:
    target = np.array([0.0, 0.0, 1.2])
    axes = frame(camera)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = axes, -axes @ target
    if camera.perspective:
        matrix[3] = -matrix[2] / camera.distance
        matrix[3, 3] += 1
    return matrix


def _about_z(angle: float) -> Floats:
    return np.array([[cos(angle), -sin(angle), 0], [sin(angle), cos(angle), 0], [0, 0, 1]])


def _about_y(angle: float) -> Floats:
    return np.array([[cos(angle), 0, sin(angle)], [0, 1, 0], [-sin(angle), 0, cos(angle)]])
