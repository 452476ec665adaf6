"""Simplify the model: omit circles and points that do not change the picture.

A thousand points per ring are more than pixels can resolve. Neighbouring faces of one colour are merged as
long as the straight edge stays within ``INVISIBLE`` pixels of the omitted points. So the cost of drawing
depends on the picture, not on the resolution of the model.
"""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import acos, pi

import numpy as np
from numpy.typing import NDArray

from anim.model import Model
from anim.outline import Profile, simplified

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]

INVISIBLE = 0.05
"""Pixels: an edge that is off by this much changes a smoothed pixel by 13 of 255 levels at most."""


@dataclass(frozen=True, eq=False)
class Mesh:
    """A model's tip, its apex, and the points of each circle with indices ``places`` (n,),
    increasing from 0.
    """

    model: Model
    places: Indices

    @classmethod
    def of(cls, model: Model, magnification: float) -> "Mesh":
        """Return the mesh for a picture with at most ``magnification`` pixels per unit of length."""
        model = model.with_profile(simplified(model.profile, INVISIBLE / magnification))
        radius = magnification * max(r for r, _ in model.profile)
        step = int(model.ring * acos(max(0.0, 1 - INVISIBLE / radius)) / pi)
        step = min(step, model.ring // 3)
        if step <= 1:
            return cls(model, np.arange(model.ring))
        starts = np.flatnonzero(np.diff(model.sectors, prepend=-1))
        kept = [
            np.linspace(start, stop, -(-(stop - start) // step) + 1)[:-1].astype(np.int64)
            for start, stop in pairwise([*starts.tolist(), model.ring])
        ]
        return cls(model, np.concatenate(kept))

    @property
    def ring(self) -> int:
        """The number of points on each ring."""
        return len(self.places)

    @property
    def profile(self) -> Profile:
        """The outline as pairs ``(radius, z)`` from the tip to the apex."""
        return self.model.profile

    @cached_property
    def points(self) -> Floats:
        """The vertices, (circles·ring + 2, 3): tip, the circles from below, apex."""
        starts = 1 + self.model.ring * np.arange(len(self.profile) - 2)
        rims = (starts[:, None] + self.places).ravel()
        chosen = np.concatenate([[0], rims, [len(self.model.points) - 1]])
        return np.asarray(self.model.points[chosen])

    @cached_property
    def keys(self) -> Indices:
        """The colour, 0 or 1, of each face, (ring,)."""
        return self.model.sectors[self.places] % 2

    @cached_property
    def angles(self) -> Floats:
        """The angles (ring + 1,) of the rings' points from the x axis; the last one repeats the first."""
        return np.append(self.places, self.model.ring) * (2 * pi / self.model.ring)

    @property
    def triangles(self) -> Indices:
        """The surface as triangles (2·circles·ring, 3), in the order of
        :meth:`~anim.model.Model.triangles`.
        """
        return self.model.with_ring(self.ring).triangles()[0]

    @cached_property
    def groups(self) -> tuple[int, ...]:
        """The number of triangles of each piece between neighbouring circles, divided by ``ring``: 1 or 2."""
        return tuple(int(low > 0) + int(high > 0) for (low, _), (high, _) in pairwise(self.profile))

    @property
    def heights(self) -> Floats:
        """The ascending heights of the planes between neighbouring pieces, (pieces − 1,)."""
        return np.array([z for _, z in self.profile[1:-1]])
