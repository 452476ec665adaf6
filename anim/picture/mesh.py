"""The model as finely as a picture can show it: of a ring's points those that make a difference.

A thousand points a ring are more than pixels can tell apart. Neighbouring faces of one colour become one as
long as the straight edge stays within ``INVISIBLE`` pixels of the points left out; what it costs to draw a
top then depends on the picture, not on how finely its model was made.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import acos, pi

import numpy as np
from numpy.typing import NDArray

from anim.model import Model

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]

INVISIBLE = 0.05
"""Pixels: an edge that is off by this much changes a smoothed pixel by 13 of 255 levels at most."""


@dataclass(frozen=True, eq=False)
class Mesh:
    """A model's tip, apex, and of each ring the points numbered ``places`` (n,), rising from 0."""

    model: Model
    places: Indices

    @classmethod
    def of(cls, model: Model, magnification: float) -> "Mesh":
        """Return the mesh for a picture that shows a unit of length as so many pixels, or fewer."""
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
    def profile(self) -> Sequence[tuple[float, float]]:
        """The outline as pairs ``(radius, z)`` from the tip to the apex."""
        return self.model.profile

    @cached_property
    def points(self) -> Floats:
        """The vertices, (2·ring + 2, 3): tip, P₁, P₂, apex."""
        lower = 1 + self.places
        ends = np.array([0]), np.array([2 * self.model.ring + 1])
        chosen = np.concatenate([ends[0], lower, lower + self.model.ring, ends[1]])
        return np.asarray(self.model.points[chosen])

    @cached_property
    def keys(self) -> Indices:
        """Which of the two colours each face has, (ring,): 0 or 1."""
        return self.model.sectors[self.places] % 2

    @cached_property
    def angles(self) -> Floats:
        """The angles (ring + 1,) of the rings' points from the x axis, and of the first once more."""
        return np.append(self.places, self.model.ring) * (2 * pi / self.model.ring)

    @property
    def triangles(self) -> Indices:
        """The surface as triangles (4·ring, 3): four times round, each piece's from its lower end up."""
        return Model(self.ring).triangles()[0]
