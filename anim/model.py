"""The top's shape (thesis, section 3.3): two cones joined by a band, their tip on the ground at the origin.

The outline, turned about the z axis, is ``(radius, z)`` = (0, 0), (1, 1), (ρ, 11/10), (0, 3). Of the
circles P₁ (radius 1) and P₂ (radius ρ) ``ring`` equally spaced points are taken each.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from anim.checks import one_of, real, whole

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
T = TypeVar("T", bound=np.generic)
Colour = tuple[int, int, int]

YELLOW: Colour = (255, 221, 0)
BLACK: Colour = (0, 0, 0)

# The thesis prints P₂ as x² + y² = (1/3)³. As it stands its radius is 3^(−3/2) ≈ 0.19; with the exponent
# taken for a misprint of 2 it is 1/3.
READINGS: Mapping[str, float] = MappingProxyType({"printed": 27**-0.5, "third": 1 / 3})

SHOULDER = (1.0, 1.0)
"""Radius and height of P₁."""
COLLAR_HEIGHT = 1.1
APEX_HEIGHT = 3.0
MOST_POINTS = 1_000_000
MOST_BANDS = 10_000


@dataclass(frozen=True, init=False)
class Model:
    """The top as points and polygons; immutable, equal when made from the same values.

    ``ring`` is the number of points on each circle (3 to 1 000 000), ``bands`` the number of sectors (up to
    10 000), coloured yellow and black by turns (by default 10, or fewer where the ring is small, always
    even), ``p2`` the radius of P₂: "printed" (3^(−3/2), the text as it stands), "third" (1/3), or a positive
    number. Lengths are in the thesis's unit. Raises :class:`~anim.errors.AnimationError` for anything else.

    >>> top = Model(ring=10)
    >>> top.points.shape, len(top.polygons)
    ((22, 3), 30)
    """

    ring: int
    bands: int
    radius: float
    """The radius of P₂."""

    def __init__(
        self, ring: int = 1000, bands: int | None = None, p2: str | float = "printed"
    ) -> None:
        ring = whole("ring", ring, 3, MOST_POINTS)
        wanted = min(10, ring - ring % 2) if bands is None else bands
        object.__setattr__(self, "ring", ring)
        object.__setattr__(self, "bands", whole("bands", wanted, 1, min(ring, MOST_BANDS)))
        object.__setattr__(self, "radius", _radius(p2))

    def __reduce__(self) -> tuple[type["Model"], tuple[int, int, float]]:
        """Travel to another process as three numbers, without the arrays made of them."""
        return Model, (self.ring, self.bands, self.radius)

    @property
    def profile(self) -> tuple[tuple[float, float], ...]:
        """The outline as pairs ``(radius, z)`` from the tip to the apex."""
        return ((0.0, 0.0), SHOULDER, (self.radius, COLLAR_HEIGHT), (0.0, APEX_HEIGHT))

    @cached_property
    def points(self) -> Floats:
        """The vertices, (2·ring + 2, 3): tip, P₁, P₂, apex. Read-only."""
        angle = np.arange(self.ring) * (2 * np.pi / self.ring)
        points = np.zeros((2 * self.ring + 2, 3))
        circle = np.column_stack([np.cos(angle), np.sin(angle)])
        lower, upper = points[1 : self.ring + 1], points[self.ring + 1 : -1]
        lower[:, :2], lower[:, 2] = SHOULDER[0] * circle, SHOULDER[1]
        upper[:, :2], upper[:, 2] = self.radius * circle, COLLAR_HEIGHT
        points[-1, 2] = APEX_HEIGHT
        return _frozen(points)

    @cached_property
    def lower(self) -> Indices:
        """The triangles of the lower cone, (ring, 3) indices of points, counter-clockwise from outside."""
        here, there = self._neighbours()
        return _frozen(np.column_stack([np.zeros_like(here), 1 + there, 1 + here]))

    @cached_property
    def sides(self) -> Indices:
        """The quadrilaterals between P₁ and P₂, (ring, 4), counter-clockwise from outside."""
        here, there = self._neighbours()
        n = self.ring
        return _frozen(np.column_stack([1 + here, 1 + there, 1 + n + there, 1 + n + here]))

    @cached_property
    def upper(self) -> Indices:
        """The triangles of the upper cone, (ring, 3), counter-clockwise from outside."""
        here, there = self._neighbours()
        n = self.ring
        return _frozen(
            np.column_stack([1 + n + here, 1 + n + there, np.full_like(here, 2 * n + 1)])
        )

    @cached_property
    def polygons(self) -> tuple[tuple[int, ...], ...]:
        """All polygons as vertex indices: lower triangles, quadrilaterals, upper triangles."""
        return tuple(
            tuple(p) for part in (self.lower, self.sides, self.upper) for p in part.tolist()
        )

    @cached_property
    def sectors(self) -> Indices:
        """The colour band, 0 … bands − 1, of the slice between neighbouring points of the rings, (ring,)."""
        return _frozen(np.arange(self.ring) * self.bands // self.ring)

    @cached_property
    def polygon_bands(self) -> Indices:
        """The colour band of each of :attr:`polygons`; the colour is :attr:`palette` [band mod 2]."""
        return _frozen(np.tile(self.sectors, 3))

    @property
    def palette(self) -> tuple[Colour, Colour]:
        """The two colours of the bands as 8-bit sRGB: yellow and black (section 3.4)."""
        return (YELLOW, BLACK)

    def triangles(self) -> tuple[Indices, Indices]:
        """Return the surface as triangles (4·ring, 3), outward, and the colour band of each (4·ring,)."""
        first, second = self.sides[:, [0, 1, 2]], self.sides[:, [0, 2, 3]]
        return np.concatenate([self.lower, first, second, self.upper]), np.tile(self.sectors, 4)

    def counts(self) -> dict[str, int]:
        """Return the numbers of points, triangles, quadrilaterals and polygons, counted.

        >>> Model().counts()
        {'points': 2002, 'triangles': 2000, 'quadrilaterals': 1000, 'polygons': 3000}
        """
        corners = [len(p) for p in self.polygons]
        return {
            "points": len(self.points),
            "triangles": corners.count(3),
            "quadrilaterals": corners.count(4),
            "polygons": len(corners),
        }

    def _neighbours(self) -> tuple[Indices, Indices]:
        here = np.arange(self.ring)
        return here, (here + 1) % self.ring


def _radius(p2: str | float) -> float:
    if isinstance(p2, str):
        return READINGS[one_of("p2", p2, READINGS)]
    return real("p2", p2, above=0)


def _frozen(values: NDArray[T]) -> NDArray[T]:
    values.flags.writeable = False
    return values
