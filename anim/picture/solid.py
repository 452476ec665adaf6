"""The top as convex pieces, and the order in which to draw them.

The top is not convex: below its collar P₂ the band between the cones faces up. But the planes of its circles
divide it into two pyramids and frusta, all of them convex; a flat ring or disc is a frustum of height 0. Of
two pieces on opposite sides of a plane, only the one on the eye's side can hide the other (Fuchs, Kedem and
Naylor 1980), and the visible faces of one convex piece do not hide each other. So the order is exact for
every attitude and camera, without depth comparisons.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from anim.picture.mesh import Mesh

Floats = NDArray[np.float64]
Booleans = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Piece:
    """A convex piece: a ring of faces between a lower and an upper rim.

    ``low`` and ``high`` index the mesh's points, (ring,) each; at the tip and the apex all indices are equal.
    Face i lies between the points i and i + 1 of both rims; ``planes`` (ring, 4) are the outward planes
    (normal, −offset), positive outside.
    """

    low: NDArray[np.int64]
    high: NDArray[np.int64]
    planes: Floats

    def facing(self, eye: Floats) -> Booleans:
        """Return which faces (ring,) are turned towards the eye, a homogeneous point (4,) in the
        top's axes.
        """
        return np.asarray(self.planes @ eye > 0)


def pieces(mesh: Mesh) -> tuple[Piece, ...]:
    """Return the pieces from the bottom up: the lower pyramid, those between circles, the upper pyramid."""
    n = mesh.ring
    tip, first = np.zeros(n, dtype=np.int64), np.arange(1, n + 1)
    circles = len(mesh.profile) - 2
    rims = (tip, *(first + n * k for k in range(circles)), tip + circles * n + 1)
    return tuple(_piece(mesh.points, low, high) for low, high in pairwise(rims))


def drawing_order(eye: Floats, heights: Floats) -> tuple[int, ...]:
    """Return the pieces in drawing order, beginning with the one that cannot hide others.

    ``heights`` (pieces − 1,) are the ascending heights of the planes between the pieces. Pieces below the eye
    hide those further down, pieces above it those further up, and the piece at its height may hide all.
    """
    here, last = int(np.count_nonzero(eye[2] > heights * eye[3])), len(heights)
    return (*range(here), *range(last, here, -1), here)


def _piece(points: Floats, low: NDArray[np.int64], high: NDArray[np.int64]) -> Piece:
    # The diagonals of a face span its plane, even if one rim is a single point.
    a, b = points[low], points[high]
    normal = np.cross(np.roll(b, -1, axis=0) - a, b - np.roll(a, -1, axis=0))
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    offset = np.sum(normal * a, axis=1)
    return Piece(low, high, np.column_stack([normal, -offset]))
