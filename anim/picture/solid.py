"""The top as three convex pieces, and the order in which to draw them.

The top is not convex: below its collar P₂ the band between the cones faces up. But the planes of P₁ and of
P₂ cut it into two pyramids and a frustum, all convex. Of two pieces on either side of a plane, the one on
the eye's side can hide the other and never the reverse (Fuchs, Kedem and Naylor 1980); and the visible
faces of one convex piece do not hide each other. So the order is exact for every attitude and camera, with
no comparison of depths.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from anim.model import COLLAR_HEIGHT, SHOULDER
from anim.picture.mesh import Mesh

Floats = NDArray[np.float64]
Booleans = NDArray[np.bool_]

LOWER, BAND, UPPER = range(3)


@dataclass(frozen=True, eq=False)
class Piece:
    """One convex piece: a ring of faces between a lower and an upper rim.

    ``low`` and ``high`` index the mesh's points, (ring,) each; at the tip and the apex all are the same.
    Face i lies between the points i and i + 1 of both rims; ``planes`` (ring, 4) are its outward planes:
    (normal, −offset), positive outside.
    """

    low: NDArray[np.int64]
    high: NDArray[np.int64]
    planes: Floats

    def facing(self, eye: Floats) -> Booleans:
        """Tell which faces (ring,) are turned towards the eye, a homogeneous point (4,) of the top's room."""
        return np.asarray(self.planes @ eye > 0)


def pieces(mesh: Mesh) -> tuple[Piece, Piece, Piece]:
    """Return the lower pyramid, the band between the rings, and the upper pyramid."""
    n = mesh.ring
    tip, first = np.zeros(n, dtype=np.int64), np.arange(1, n + 1)
    rims = (tip, first, first + n, tip + 2 * n + 1)
    lower, band, upper = (_piece(mesh.points, low, high) for low, high in pairwise(rims))
    return lower, band, upper


def drawing_order(eye: Floats) -> tuple[int, int, int]:
    """Return the pieces from the one to be drawn first to the one that may hide all others."""
    above_ring, above_collar = eye[2] > SHOULDER[1] * eye[3], eye[2] > COLLAR_HEIGHT * eye[3]
    if above_collar:
        return (LOWER, BAND, UPPER)
    return (LOWER, UPPER, BAND) if above_ring else (UPPER, BAND, LOWER)


def _piece(points: Floats, low: NDArray[np.int64], high: NDArray[np.int64]) -> Piece:
    # The diagonals of a face span its plane, also where one rim is a single point.
    a, b = points[low], points[high]
    normal = np.cross(np.roll(b, -1, axis=0) - a, b - np.roll(a, -1, axis=0))
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    offset = np.sum(normal * a, axis=1)
    return Piece(low, high, np.column_stack([normal, -offset]))
