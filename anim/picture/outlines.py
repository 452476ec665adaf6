"""Merge the visible faces of one convex piece into outlines, one of each colour.

Faces drawn one by one would let the far side shine through: where two antialiased edges meet, each covers
half of a pixel, and a quarter of what lies beneath stays. So neighbouring faces of one colour become
one outline, and where two outlines meet, the one drawn first reaches ``OVERLAP`` pixels under the other.
It never reaches beyond the edge of the body, whose outline stays sharp.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
KeyArray = NDArray[np.int64]

OVERLAP = 1.5
"""How far, in pixels, an outline reaches under its neighbour."""
DEPTH = 8.0
"""The same under another piece, where it may slant and cannot show."""
HIDDEN = -1


@dataclass(frozen=True)
class Run:
    """Faces ``start`` … ``stop`` − 1 of one colour, counted on past the end of the ring."""

    start: int
    stop: int
    key: int


def runs(keys: KeyArray) -> list[Run]:
    """Return the longest runs of equal ``keys`` round the ring, without those of key ``HIDDEN``.

    They come in the order round the ring. A single run has ``stop - start == len(keys)``.

    >>> runs(np.array([1, 1, -1, 0, 1]))
    [Run(start=3, stop=4, key=0), Run(start=4, stop=7, key=1)]
    """
    n = len(keys)
    starts = np.flatnonzero(keys != np.roll(keys, 1))
    if not len(starts):
        return [] if keys[0] == HIDDEN else [Run(0, n, int(keys[0]))]
    stops = np.append(starts[1:], starts[0] + n)
    found = zip(starts.tolist(), stops.tolist(), keys[starts].tolist(), strict=True)
    return [Run(start, stop, key) for start, stop, key in found if key != HIDDEN]


@dataclass(frozen=True, eq=False)
class Rim:
    """A projected rim (ring, 2) of a piece, and the same ``reaching`` under a neighbour, if there is one."""

    points: Floats
    reaching: Floats | None = None

    @property
    def outermost(self) -> Floats:
        """The rim as far as the outline goes."""
        return self.points if self.reaching is None else self.reaching

    def arc(self, start: float, stop: float) -> Floats:
        """Return the polyline between two places, counted in faces and not always whole."""
        if self.reaching is None:
            return _arc(self.points, start, stop)
        # From the rim itself, so that the edges that end there stay straight.
        ends = [_between(self.points, place) for place in (start, stop)]
        return np.concatenate([ends[0], _arc(self.reaching, start, stop), ends[1]])


def reach_under(rim: Floats, inside: Floats) -> Rim:
    """Return the rim (ring, 2), with a second line shifted under the neighbouring piece, drawn later.

    ``inside`` (2,) is a projected point inside that piece. The piece is convex, so the segment
    from the rim to this point lies inside it. Everything visible there is drawn after the rim's own piece.
    """
    away = inside - rim
    share = np.minimum(1.0, DEPTH / np.maximum(np.hypot(away[:, 0], away[:, 1]), 1e-9))
    return Rim(rim, rim + share[:, None] * away)


def outlines(low: Rim, high: Rim, keys: KeyArray) -> Iterator[tuple[int, list[Floats]]]:
    """Yield ``(key, loops)`` for each run: closed polygons (k, 2) to be filled together, in drawing order.

    ``keys`` (ring,) is each face's colour or ``HIDDEN``. With one colour the rims may be those in space,
    (ring, 3).
    """
    n = len(keys)
    found = runs(keys)
    for order, run in enumerate(found):
        if run.stop - run.start == n:
            yield run.key, [low.outermost, high.outermost[::-1]]
            continue
        # What follows is drawn later, save after the last; what precedes, only before the first.
        after = found[(order + 1) % len(found)]
        before = found[order - 1]
        ends, begins = Strip(run.stop, run.stop), Strip(run.start, run.start)
        if order + 1 < len(found) and after.start == run.stop:
            ends = _strip(low.points, high.points, run.stop, after.stop - after.start)
        if order == 0 and len(found) > 1 and before.stop == run.start + n:
            begins = _strip(low.points, high.points, run.start, before.start - before.stop)
        along_low = low.arc(begins.low, ends.low)
        along_high = high.arc(begins.high, ends.high)[::-1]
        loop = [along_low, *ends.corner, along_high, *begins.corner]
        yield run.key, [np.concatenate(loop)]


@dataclass(frozen=True)
class Strip:
    """Where an outline ends on both rims, counted in faces, and a corner (1, 2) in between, if any."""

    low: float
    high: float
    corner: tuple[Floats, ...] = ()


def _strip(low: Floats, high: Floats, edge: int, faces: int) -> Strip:
    """Return the end of an outline that reaches ``OVERLAP`` pixels beyond an edge between two faces.

    The strip has the same width everywhere, but ends where the neighbour of ``faces`` faces (negative: to the
    other side) does, as it must near a point where all edges meet.
    """
    n, far = len(low), edge + faces
    widths = [_distance(rim[edge % n], rim[far % n]) for rim in (low, high)]
    if max(widths) <= OVERLAP:
        return Strip(far, far)
    places = [
        far if width <= OVERLAP else edge + _share(rim, edge, faces)
        for rim, width in zip((low, high), widths, strict=True)
    ]
    if min(widths) > OVERLAP:
        return Strip(places[0], places[1])
    share = (OVERLAP - widths[0]) / (widths[1] - widths[0])
    corner = low[far % n] + share * (high[far % n] - low[far % n])
    return Strip(places[0], places[1], (corner[None],))


def _share(rim: Floats, edge: int, faces: int) -> float:
    """Return how many faces, at most ``faces``, make ``OVERLAP`` pixels along the rim."""
    n, step = len(rim), 1 if faces > 0 else -1
    width = _distance(rim[edge % n], rim[(edge + step) % n])
    return step * min(OVERLAP / max(width, 1e-9), abs(faces))


def _distance(a: Floats, b: Floats) -> float:
    return float(np.hypot(*(b - a)))


def _arc(rim: Floats, start: float, stop: float) -> Floats:
    """Return the polyline along the rim between two places, counted in faces and not always whole."""
    n = len(rim)
    first, last = int(np.ceil(start)), int(np.floor(stop))
    points = rim[np.arange(first, last + 1) % n]
    if first > start:
        points = np.concatenate([_between(rim, start), points])
    return points if last >= stop else np.concatenate([points, _between(rim, stop)])


def _between(rim: Floats, place: float) -> Floats:
    face = int(np.floor(place))
    here, there = rim[face % len(rim)], rim[(face + 1) % len(rim)]
    return np.asarray(here + (place - face) * (there - here))[None]
