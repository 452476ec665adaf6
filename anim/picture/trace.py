"""Split the path of the apex into a part behind the top and a part in front of it.

The apex moves on a sphere about the tip. A top inside that sphere cannot hide a point on the near side, and a
point on the far side cannot hide the top. So the near side of the path is drawn after the top, the far side
before it. If the tip moves, the sphere is centred at its current position, and the older points are close to
it. A top that is wider than it is tall is not inside the sphere; then the ray from each point to the eye is
intersected with the top.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from anim.picture.projection import View

Floats = NDArray[np.float64]
Booleans = NDArray[np.bool_]

MIN_STRENGTH = 0.22
"""The opacity of the oldest part of the path."""
FADING_SECONDS = 2.0
"""The seconds of the film in which the opacity above that falls to 1/e of it."""
MIN_DEPTH = 0.02
"""The least depth of points drawn, relative to the camera's distance: others are beside or behind it."""
MIN_RAY_LENGTH = 1e-6
"""Intersections of a ray with the top nearer than this belong to its start on the surface."""


def strengths(ages: Floats) -> Floats:
    """Return the opacity (k,) of a path at points through which the apex passed ``ages`` (k,) seconds ago."""
    return np.asarray(MIN_STRENGTH + (1 - MIN_STRENGTH) * np.exp(-ages / FADING_SECONDS))


def on_near_side(trail: Floats, eye: Floats, tip: Floats) -> Booleans:
    """Return which points (k,) of a path (k, 3) are on the near side of the sphere about the tip."""
    around = trail - tip
    return np.asarray(around @ (eye[:3] - eye[3] * tip) > eye[3] * np.sum(around * around, axis=1))


def in_sight(points: Floats, eye: Floats, profile: Sequence[tuple[float, float]]) -> Booleans:
    """Return which ``points`` (k, 3), in the top's coordinates, are not hidden by the solid of
    ``profile``.
    """
    way = eye[:3] - eye[3] * points
    far = 1.0 if eye[3] else np.inf
    (ox, oy, oz), (dx, dy, dz) = points.T, way.T
    seen = np.ones(len(points), dtype=bool)
    for (r0, z0), (r1, z1) in pairwise(profile):
        with np.errstate(invalid="ignore", divide="ignore"):
            if z0 == z1:  # a flat ring
                t = (z0 - oz) / dz
                radius = np.hypot(ox + t * dx, oy + t * dy)
                met = (radius > min(r0, r1)) & (radius < max(r0, r1))
                seen &= ~(met & (t > MIN_RAY_LENGTH) & (t < far))
                continue
            slope = (r1 - r0) / (z1 - z0)
            radius, change = r0 + slope * (oz - z0), slope * dz
            a = dx * dx + dy * dy - change * change
            b = ox * dx + oy * dy - radius * change
            root = np.sqrt(b * b - a * (ox * ox + oy * oy - radius * radius))
            for t in ((-b - root) / a, (-b + root) / a):
                z = oz + t * dz
                seen &= ~((z > z0) & (z < z1) & (t > MIN_RAY_LENGTH) & (t < far))
    return seen


def near_and_far(
    trail: Floats, view: View, near: Booleans, ink: Floats
) -> tuple[list[Floats], list[Floats]]:
    """Return the polylines through the ``near`` points, to draw after the top, and the others, to draw
    before.

    Each polyline (k, 3) has two pixel coordinates per point, and the opacity ``ink``.
    """
    if len(trail) < 2:
        return [], []
    depth = trail @ view.matrix[3, :3] + view.matrix[3, 3]
    seen = depth > MIN_DEPTH
    lines = np.column_stack([view.project(trail), ink])
    # For each segment: 1 after the top, 0 before it, −1 not drawn.
    kinds = np.where(seen[1:] & seen[:-1], (near[1:] & near[:-1]).astype(int), -1)
    cuts = np.flatnonzero(kinds[1:] != kinds[:-1]) + 1
    starts, stops = [0, *cuts.tolist()], [*cuts.tolist(), len(kinds)]
    found = [(kinds[a], lines[a : b + 1]) for a, b in zip(starts, stops, strict=True)]
    return [line for kind, line in found if kind == 1], [line for kind, line in found if kind == 0]


def thinned(path: Floats, tolerance: float) -> NDArray[np.int64]:
    """Return which points of a path (n, 3) to keep for a line that deviates by at most ``tolerance``.

    A curve of length L that turns by φ in total is within L·φ/4 of its chord (φ ≤ π); points are omitted as
    long as this is at most ``tolerance``. The points kept do not depend on later points, so a line can grow
    from frame to frame without flicker.
    """
    steps = np.diff(path, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    ways = steps / np.maximum(lengths, np.finfo(float).tiny)[:, None]
    chords = np.linalg.norm(np.diff(ways, axis=0), axis=1)
    turns = 2 * np.arcsin(np.minimum(chords / 2, 1.0))
    kept, length, turned = [0], 0.0, 0.0
    for n, (long, turn) in enumerate(zip(lengths.tolist(), [0.0, *turns.tolist()], strict=False)):
        length, turned = length + long, turned + turn
        if length * turned > 4 * tolerance or turned > np.pi:
            if kept[-1] != n:
                kept.append(n)
            length, turned = long, 0.0
    return np.array(kept)
