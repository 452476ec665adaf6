"""The top's shape: an outline rotated about the z axis, with its lowest point at the origin on the ground.

The thesis's top (section 3.3) consists of two cones joined by a band: ``(radius, z)`` = (0, 0), (1, 1), (ρ,
11/10), (0, 3). Each of its two circles, P₁ (radius 1) and P₂ (radius ρ), has ``ring`` equally spaced points.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import hypot
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from anim.checks import one_of, real, whole
from anim.errors import AnimationError
from anim.outline import Profile, checked_outline, read_outline

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
T = TypeVar("T", bound=np.generic)
Colour = tuple[int, int, int]

YELLOW: Colour = (255, 221, 0)
BLACK: Colour = (0, 0, 0)

# The thesis prints P₂ as x² + y² = (1/3)³. Read literally, its radius is 3^(−3/2) ≈ 0.19; if the
# exponent is a misprint for 2, it is 1/3.
READINGS: Mapping[str, float] = MappingProxyType({"printed": 27**-0.5, "third": 1 / 3})

SHOULDER = (1.0, 1.0)
"""Radius and height of P₁."""
COLLAR_HEIGHT = 1.1
APEX_HEIGHT = 3.0
MAX_POINTS = 1_000_000
MAX_BANDS = 10_000


@dataclass(frozen=True, init=False)
class Model:
    """The top as points and polygons; immutable; models with the same parameters are equal.

    ``ring`` is the number of points on each circle (3 to 1 000 000). ``bands`` is the number of sectors (up
    to 10 000), coloured alternately yellow and black; the default is 10, or a smaller even number if the ring
    is small. ``p2`` is the radius of P₂: "printed" (3^(−3/2), as in the text), "third" (1/3), or a positive
    number. Lengths are in the thesis's unit. :meth:`from_outline` makes a top of any other shape. Raises
    :class:`~anim.errors.AnimationError` for other values.

    >>> top = Model(ring=10)
    >>> top.points.shape, len(top.polygons)
    ((22, 3), 30)
    """

    ring: int
    bands: int
    profile: Profile = field(repr=False)
    """The outline as pairs ``(radius, z)`` from the tip (0, 0) to the axis again."""

    def __init__(
        self, ring: int = 1000, bands: int | None = None, p2: str | float = "printed"
    ) -> None:
        collar = (_radius(p2), COLLAR_HEIGHT)
        self._fill(ring, bands, ((0.0, 0.0), SHOULDER, collar, (0.0, APEX_HEIGHT)))

    @classmethod
    def from_outline(
        cls,
        outline: Iterable[Iterable[float]] | str | Path,
        ring: int = 1000,
        bands: int | None = None,
    ) -> "Model":
        """Return the solid of revolution of an outline, given as pairs ``(z, radius)`` from the lowest point
        up.

        ``outline`` is a sequence of at least two pairs, an array (n, 2), or the path of a file with two
        numbers per line. Heights must not decrease, and radii must be nonnegative, both in the same unit.
        Pictures adapt to any size, and ``Body.turned(model.profile, scale=…)`` takes the length of the unit
        in metres. The lowest point is placed on the ground. If the outline begins or ends off the axis, a
        flat disc closes it. Raises :class:`~anim.errors.AnimationError`, which names the point, or the file
        and its line, and :class:`~hfield.errors.TableError` for a file that is not a table of numbers.

        >>> egg = Model.from_outline([(0, 0), (1, 0.8), (2, 1), (3, 0.6), (3.5, 0)], ring=12)
        >>> egg.height, len(egg.polygons)
        (3.5, 48)
        >>> Model.from_outline([(0, 1), (2, 1)]).profile  # a cylinder
        ((0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0))
        """
        of_file = isinstance(outline, (str, Path))
        profile = read_outline(outline) if of_file else checked_outline(outline)  # type: ignore[arg-type]
        return cls._of(ring, bands, profile)

    @classmethod
    def _of(cls, ring: int, bands: int | None, profile: Profile) -> "Model":
        """Return the model of a valid profile, without checks."""
        model = cls.__new__(cls)
        model._fill(ring, bands, profile)
        return model

    def _fill(self, ring: int, bands: int | None, profile: Profile) -> None:
        ring = whole("ring", ring, 3, MAX_POINTS)
        wanted = min(10, ring - ring % 2) if bands is None else bands
        bands = whole("bands", wanted, 1, min(ring, MAX_BANDS))
        circles = len(profile) - 2
        if ring * circles > 2 * MAX_POINTS:
            raise AnimationError(
                f"{ring} points on each of {circles} circles are too many; expected a ring of at most "
                f"{2 * MAX_POINTS // circles}"
            )
        for name, value in (("ring", ring), ("bands", bands), ("profile", profile)):
            object.__setattr__(self, name, value)

    def __reduce__(
        self,
    ) -> tuple[Callable[[int, int, Profile], "Model"], tuple[int, int, Profile]]:
        """Pickle only the parameters, without the arrays computed from them."""
        return Model._of, (self.ring, self.bands, self.profile)

    @property
    def radius(self) -> float:
        """The radius at the outline's third point; for the thesis's top, the radius of P₂.

        >>> Model(p2=0.5).radius
        0.5
        """
        return self.profile[2][0]

    @property
    def height(self) -> float:
        """The height of the apex above the tip."""
        return self.profile[-1][1]

    @property
    def extent(self) -> float:
        """The distance from the tip to the farthest point of the top."""
        return max(hypot(r, z) for r, z in self.profile)

    @property
    def magnified(self) -> float:
        """The factor that enlarges the model in pictures such that its farthest point has distance 3 from the
        tip.

        So cameras, ground and shadows fit a top of any size.

        >>> small = Model.from_outline([(0, 0), (1, 0.8), (1.5, 0)])
        >>> small.extent, small.magnified, small.scaled(small.magnified).height
        (1.5, 2.0, 3.0)
        """
        return APEX_HEIGHT / self.extent

    def with_profile(self, profile: Profile) -> "Model":
        """Return a model with another profile but the same numbers of points per circle and of bands.

        >>> Model(ring=7).with_profile(((0, 0), (1, 1), (0, 2))).polygons[-1]
        (7, 1, 8)
        """
        return self if profile == self.profile else self._of(self.ring, self.bands, profile)

    def with_ring(self, ring: int) -> "Model":
        """Return the model of the same profile with ``ring`` points per circle.

        >>> Model().with_ring(10) == Model(10)
        True
        """
        return self._of(ring, None, self.profile)

    def scaled(self, factor: float) -> "Model":
        """Return the same shape enlarged by a factor."""
        return self.with_profile(tuple((r * factor, z * factor) for r, z in self.profile))

    @cached_property
    def points(self) -> Floats:
        """The vertices, (circles·ring + 2, 3): tip, the circles from the bottom up (P₁, P₂), apex.
        Read-only.
        """
        angle = np.arange(self.ring) * (2 * np.pi / self.ring)
        circle = np.column_stack([np.cos(angle), np.sin(angle)])
        circles = self.profile[1:-1]
        points = np.zeros((len(circles) * self.ring + 2, 3))
        for k, (radius, height) in enumerate(circles):
            rim = points[1 + k * self.ring : 1 + (k + 1) * self.ring]
            rim[:, :2], rim[:, 2] = radius * circle, height
        points[-1, 2] = self.height
        return _frozen(points)

    @cached_property
    def lower(self) -> Indices:
        """The triangles from the tip, (ring, 3) indices of points, counter-clockwise from outside."""
        here, there = self._neighbours()
        return _frozen(np.column_stack([np.zeros_like(here), 1 + there, 1 + here]))

    @cached_property
    def sides(self) -> Indices:
        """The quadrilaterals between neighbouring circles, (k·ring, 4), counter-clockwise from outside."""
        here, there = self._neighbours()
        n = self.ring
        first = np.column_stack([1 + here, 1 + there, 1 + n + there, 1 + n + here])
        starts = n * np.arange(len(self.profile) - 3)
        return _frozen((first + starts[:, None, None]).reshape(-1, 4))

    @cached_property
    def upper(self) -> Indices:
        """The triangles to the apex, (ring, 3), counter-clockwise from outside."""
        here, there = self._neighbours()
        last = len(self.points) - 1
        start = last - self.ring
        return _frozen(np.column_stack([start + here, start + there, np.full_like(here, last)]))

    @cached_property
    def polygons(self) -> tuple[tuple[int, ...], ...]:
        """All polygons as vertex indices: lower triangles, quadrilaterals, upper triangles."""
        return tuple(
            tuple(p) for part in (self.lower, self.sides, self.upper) for p in part.tolist()
        )

    @cached_property
    def sectors(self) -> Indices:
        """The colour band, 0 … bands − 1, of each slice between neighbouring points of the rings, (ring,)."""
        return _frozen(np.arange(self.ring) * self.bands // self.ring)

    @cached_property
    def polygon_bands(self) -> Indices:
        """The colour band of each of :attr:`polygons`; the colour is :attr:`palette` [band mod 2]."""
        return _frozen(np.tile(self.sectors, len(self.profile) - 1))

    @property
    def palette(self) -> tuple[Colour, Colour]:
        """The two colours of the bands as 8-bit sRGB: yellow and black (section 3.4)."""
        return (YELLOW, BLACK)

    def triangles(self) -> tuple[Indices, Indices]:
        """Return the surface as outward triangles (2·circles·ring, 3), and the colour band of each.

        They are listed piece by piece from the tip. A piece that ends on the axis has ``ring`` triangles; any
        other has twice as many: first one half of each quadrilateral, then the other.
        """
        between = self.sides.reshape(-1, self.ring, 4)
        halves = [faces[:, corners] for faces in between for corners in ([0, 1, 2], [0, 2, 3])]
        groups = [self.lower, *halves, self.upper]
        return np.concatenate(groups), np.tile(self.sectors, len(groups))

    def counts(self) -> dict[str, int]:
        """Return the actual numbers of points, triangles, quadrilaterals and polygons.

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
