"""The path of the apex, in two parts: what the top may hide, and what may hide the top.

The apex moves on a sphere about the tip, and the top lies inside that sphere. Nothing inside a ball hides
a point of the ball's near side, and such a point may hide everything inside; for the far side it is the
other way round. So a piece of the trace is drawn after the top when it lies on the near side, else before. A
tip that wanders takes the sphere along; what it left behind is nearly on it.
"""

import numpy as np
from numpy.typing import NDArray

from anim.picture.projection import View

Floats = NDArray[np.float64]


def near_and_far(trail: Floats, view: View, tip: Floats) -> tuple[list[Floats], list[Floats]]:
    """Return the polylines (k, 2) in pixels on the near side of the sphere about the tip, and the others."""
    if len(trail) < 2:
        return [], []
    seen = view.project(trail)
    around, eye = trail - tip, view.eye
    near = around @ (eye[:3] - eye[3] * tip) > eye[3] * np.sum(around * around, axis=1)
    in_front = near[1:] & near[:-1]
    cuts = np.flatnonzero(in_front[1:] != in_front[:-1]) + 1
    starts, stops = [0, *cuts.tolist()], [*cuts.tolist(), len(in_front)]
    lines = [(in_front[a], seen[a : b + 1]) for a, b in zip(starts, stops, strict=True)]
    return [line for front, line in lines if front], [line for front, line in lines if not front]


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
