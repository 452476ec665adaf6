"""The path of the apex, in two parts: what the top may hide, and what may hide the top.

The apex moves on a sphere about the tip. Where the top lies inside that sphere, nothing of it hides a point
of the near side, and such a point may hide everything inside; for the far side it is the other way round.
So a piece of the trace is drawn after the top when it lies on the near side, else before. A tip that wanders
takes the sphere along; what it left behind is nearly on it. A top that is wider than it is tall reaches out
of the sphere: there a ray from each point to the eye is met with the top.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from anim.picture.projection import View

Floats = NDArray[np.float64]
Booleans = NDArray[np.bool_]

OLD = 0.22
"""How much of its colour the oldest part of the path keeps."""
FADING = 2.0
"""The seconds of the film in which the rest of it falls to 1/e."""
AHEAD = 0.02
"""Points at less of the camera's distance than this are beside or behind it and not drawn."""
GRAZING = 1e-6
"""A ray that meets the top so near to its start begins on the surface."""


def strengths(ages: Floats) -> Floats:
    """Return how much of its colour a path has (k,) where the apex was ``ages`` (k,) seconds ago."""
    return np.asarray(OLD + (1 - OLD) * np.exp(-ages / FADING))


def on_near_side(trail: Floats, eye: Floats, tip: Floats) -> Booleans:
    """Return which points (k,) of a path (k, 3) are on the near side of the sphere about the tip."""
    around = trail - tip
    return np.asarray(around @ (eye[:3] - eye[3] * tip) > eye[3] * np.sum(around * around, axis=1))


def in_sight(points: Floats, eye: Floats, profile: Sequence[tuple[float, float]]) -> Booleans:
    """Return which ``points`` (k, 3) no part of the solid of ``profile`` hides; all in the top's own room."""
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
                seen &= ~(met & (t > GRAZING) & (t < far))
                continue
            slope = (r1 - r0) / (z1 - z0)
            radius, change = r0 + slope * (oz - z0), slope * dz
            a = dx * dx + dy * dy - change * change
            b = ox * dx + oy * dy - radius * change
            root = np.sqrt(b * b - a * (ox * ox + oy * oy - radius * radius))
            for t in ((-b - root) / a, (-b + root) / a):
                z = oz + t * dz
                seen &= ~((z > z0) & (z < z1) & (t > GRAZING) & (t < far))
    return seen


def near_and_far(
    trail: Floats, view: View, near: Booleans, ink: Floats
) -> tuple[list[Floats], list[Floats]]:
    """Return the polylines (k, 3) to be drawn after the top, where the points are ``near``, and before it.

    Of each point they have the place in pixels and its ``ink`` (k,).
    """
    if len(trail) < 2:
        return [], []
    depth = trail @ view.matrix[3, :3] + view.matrix[3, 3]
    seen = depth > AHEAD
    lines = np.column_stack([view.project(trail), ink])
    # Of each piece from point to point: 1 after the top, 0 before it, −1 not at all.
    kinds = np.where(seen[1:] & seen[:-1], (near[1:] & near[:-1]).astype(int), -1)
    cuts = np.flatnonzero(kinds[1:] != kinds[:-1]) + 1
    starts, stops = [0, *cuts.tolist()], [*cuts.tolist(), len(kinds)]
    found = [(kinds[a], lines[a : b + 1]) for a, b in zip(starts, stops, strict=True)]
    return [line for kind, line in found if kind == 1], [line for kind, line in found if kind == 0]


def thinned(path: Floats, tolerance: float) -> NDArray[np.int64]:
    """Return which points of a path (n, 3) are enough: the line through them strays no further than that.

    A curve of length L that turns by φ in all stays within L·φ/4 of its chord (φ ≤ π); points are left out as
    long as this is at most ``tolerance``. One pass, and what is kept up to a point does not depend on what
    comes after it, so that a line may grow from frame to frame without a flicker.
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
