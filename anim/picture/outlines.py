"""Merge the visible faces of one convex piece into outlines, one for each colour.

If faces were drawn one by one, the far side would shine through: where two antialiased edges meet, each
covers half of a pixel, and a quarter of what lies beneath remains visible. So neighbouring faces of one
colour are merged into one outline, and where two outlines meet, the one drawn first extends ``OVERLAP``
pixels under the other. It never extends beyond the edge of the body, whose outline stays sharp.
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
    """The faces ``start`` … ``stop`` − 1 of one colour; indices may continue past the end of the ring."""

    start: int
    stop: int
    key: int


def runs(keys: KeyArray) -> list[Run]:
    """Return the maximal runs of equal ``keys`` around the ring, without those of key ``HIDDEN``.

    They are in the order of the ring. If all keys are equal, the single run has ``stop - start ==
    len(keys)``.

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
    """A projected rim (ring, 2) of a piece, and ``reaching``, the same extended under a neighbour, if any."""

    points: Floats
    reaching: Floats | None = None

    @property
    def outermost(self) -> Floats:
        """The rim to which the outline extends."""
        return self.points if self.reaching is None else self.reaching

    def arc(self, start: float, stop: float) -> Floats:
        """Return the polyline between two positions, measured in faces and possibly fractional."""
        if self.reaching is None:
            return _arc(self.points, start, stop)
        # From the rim itself, so that the edges that end there stay straight.
        ends = [_between(self.points, place) for place in (start, stop)]
        return np.concatenate([ends[0], _arc(self.reaching, start, stop), ends[1]])


def reach_under(rim: Floats, inside: Floats) -> Rim:
    """Return the rim (ring, 2), with a second line shifted under the neighbouring piece, which is drawn
    later.

    ``inside`` (2,) is a projected point inside the neighbouring piece. That piece is convex, so the segment
    from the rim to this point lies inside it. Everything visible there is drawn after the rim's own piece.
    """
    away = inside - rim
    share = np.minimum(1.0, DEPTH / np.maximum(np.hypot(away[:, 0], away[:, 1]), 1e-9))
    return Rim(rim, rim + share[:, None] * away)


def outlines(low: Rim, high: Rim, keys: KeyArray) -> Iterator[tuple[int, list[Floats]]]:
    """Yield ``(key, loops)`` for each run: closed polygons (k, 2) to be filled together, in drawing order.

    ``keys`` (ring,) are the faces' colours or ``HIDDEN``. If all are equal the rims may be in space, (ring,
    3).
    """
    n = len(keys)
    found = runs(keys)
    for order, run in enumerate(found):
        if run.stop - run.start == n:
            yield run.key, [low.outermost, high.outermost[::-1]]
            continue
        # The next piece is drawn later, except after the last; the previous piece is drawn later
        # only before the first.
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
    """The ends of an outline on both rims, measured in faces, with a corner (1, 2) in between, if any."""

    low: float
    high: float
    corner: tuple[Floats, ...] = ()


def _strip(low: Floats, high: Floats, edge: int, faces: int) -> Strip:
    """Return the end of an outline that extends ``OVERLAP`` pixels beyond an edge between two faces.

    The strip has constant width, but ends where the neighbour of ``faces`` faces (negative: on the other
    side) ends, as is necessary near a point where all edges meet.
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
    """Return how many faces, at most ``faces``, correspond to ``OVERLAP`` pixels along the rim."""
    n, step = len(rim), 1 if faces > 0 else -1
    width = _distance(rim[edge % n], rim[(edge + step) % n])
    return step * min(OVERLAP / max(width, 1e-9), abs(faces))


def _distance(a: Floats, b: Floats) -> float:
    return float(np.hypot(*(b - a)))


def _arc(rim: Floats, start: float, stop: float) -> Floats:
    """Return the polyline along the rim between two positions, measured in faces and possibly fractional."""
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
