"""Dirichlet domains in floats: the bounding units, and whether more units are needed.

Units are reduced by one another until those that bound a polygon pair its sides (Voight, *J. Théor. Nombres
Bordeaux* 21, 2009). Nothing here is a proof; the proof is in ``dirichlet``.
"""

from __future__ import annotations

import numpy as np

from hfield.fuchsian.search import Floats, Points, Rows, Sight, distinct

EQUAL_WITHIN = 1e-9
BESIDE = 24
"""So many sides on either side of a direction are looked at to find the one that a point lies beyond."""
ROUNDED = 1e-14
"""Where a point lies is wrong by so much for each unit that a side is far away."""
STEPS = 200
"""So often a unit is multiplied by those of sides."""
SQUARE = np.array([0.9, 0.9j, -0.9, -0.9j])
"""Dual points of lines beyond the disc, so that there is always a polygon."""


class Shape:
    """The polygon of the points nearer to the centre than to its images by some units.

    The line halfway to z = g·0 is ``Re(conj(w)·p) = 1`` in Klein's model, for the dual point w = 1/conj(z).
    The corners of the convex hull of the dual points correspond to the sides. ``rows`` are the units of the
    sides, counterclockwise.
    """

    def __init__(self, sight: Sight, rows: Rows) -> None:
        self.sight = sight
        a, b = sight.motions(rows)
        dual = np.concatenate([a / b.conj(), SQUARE])
        every = hull(dual)
        # without lines that only touch the polygon, at a vertex or cusp
        starts = corners(dual[every])
        every = [
            n
            for n, x in zip(every, abs(starts - np.roll(starts, -1)), strict=True)
            if x > EQUAL_WITHIN
        ]
        sides = [n for n in every if n < len(rows)]
        self.bounds = np.zeros(len(rows), dtype=bool)
        self.bounds[sides] = True
        self.rows, self.a, self.b, self.dual = rows[sides], a[sides], b[sides], dual[sides]
        self.corners = corners(self.dual)
        """Where each side begins, in Klein's model."""
        self.closed = len(sides) == len(every) and bool(
            (abs(self.corners) < 1 + EQUAL_WITHIN).all()
        )
        self._back = sight.left(self.rows @ sight.bar)
        self._weight = 2 * abs(self.b) ** 2  # cosh d − 1

    def beyond(self, points: Points) -> Rows:
        """Return for each point the number of a side that separates it from the polygon, −1 for a point
        inside.

        It is approximately the side whose inverse unit moves the point nearest to the centre. A point outside
        the polygon lies beyond the side in its direction from 0; neighbouring sides may be better.
        """
        found = np.full(len(points), -1)
        count = len(self.rows)
        if not count:
            return found
        every = np.arange(count) if count <= 2 * BESIDE else np.arange(-BESIDE, BESIDE)
        for n in range(0, len(points), 4096):
            some = points[n : n + 4096]
            which = every[None, :]
            if count > len(every):
                which = (which + self._towards(some)[:, None]) % count
            value = self._weight[which] * ((some[:, None] * self.dual[which].conj()).real - 1)
            best = value.argmax(axis=1)
            rows = np.arange(len(some))
            side = np.broadcast_to(which, value.shape)[rows, best]
            over = value[rows, best] > 1e-7 + ROUNDED * self._weight[side]
            found[n : n + 4096] = np.where(over, side, -1)
        return found

    def _towards(self, points: Points) -> Rows:
        """Return the number of the side in the direction of each point, or of an adjacent one."""
        turns = np.angle(self.corners)
        first = int(turns.argmin())
        return np.searchsorted(np.roll(turns, -first), np.angle(points)) - 1 + first

    def gaps(self) -> tuple[Floats, Floats]:
        """Return the arcs of the circle that belong to the polygon, as starting angles and widths."""
        if not len(self.dual):
            return np.zeros(1), np.full(1, 2 * np.pi)
        angle, half = np.angle(self.dual), np.arccos(1 / abs(self.dual))
        start, end = angle + half, np.roll(angle - half, -1)
        width = (end - start + 1) % (2 * np.pi) - 1
        wide = width > 100 * EQUAL_WITHIN  # else it is a cusp, rounded
        return start[wide], width[wide]

    def inside(self, points: Points) -> Points:
        """Return images of points of Klein's model that lie in the polygon."""
        points = points.copy()
        for _ in range(STEPS):
            far = np.flatnonzero((side := self.beyond(points)) >= 0)
            if not far.size:
                break
            n = side[far]
            points[far] = moved(self.a[n].conj(), -self.b[n], points[far])
        return points

    def reduced(self, rows: Rows) -> Rows:
        """Multiply units by those of sides until they move the centre into the polygon; drop ±1.

        Units that are so far away that rounding would make the loop endless are left out.
        """
        done = []
        for _ in range(STEPS):
            if not len(rows):
                break
            a, b = self.sight.motions(rows)
            side = self.beyond(2 * a * b / (abs(a) ** 2 + abs(b) ** 2))
            done.append(rows[(side < 0) & (abs(b) > 1e-6)])
            rows, side = rows[side >= 0], side[side >= 0]
            rows = self.sight.times(self._back[side], rows)
        return np.concatenate(done) if done else rows

    def cutting(self) -> Rows:
        """Return units that cut off the ends of sides that the side's inverse unit maps outside the
        polygon.
        """
        new = []
        angle, half = np.angle(self.dual), np.arccos(np.minimum(1, 1 / abs(self.dual)))
        for corners, turn in ((self.corners, -half), (np.roll(self.corners, -1), half)):
            # if the next side is not met, the end is on the circle
            ends = np.where(abs(corners) < 1 + EQUAL_WITHIN, corners, np.exp(1j * (angle + turn)))
            side = self.beyond(moved(self.a.conj(), -self.b, ends))
            cut = side >= 0
            new.append(self.sight.times(self.sight.left(self.rows[cut]), self.rows[side[cut]]))
        return np.concatenate(new)

    def area(self) -> float:
        """Return the area in units of 2π."""
        z = self.corners / (1 + np.sqrt(np.maximum(0, 1 - abs(self.corners) ** 2)))
        after, before = np.roll(z, -1), np.roll(z, 1)
        seen = (after - z) / (1 - z.conj() * after), (before - z) / (1 - z.conj() * before)
        angles = np.angle(seen[1] / seen[0]) % (2 * np.pi)
        angles[abs(self.corners) > 1 - 1e-10] = 0  # cusps
        return float((len(z) - 2) / 2 - angles.sum() / (2 * np.pi))


def enlarge_polygon(sight: Sight, rows: Rows, new: Rows) -> Shape:
    """Return the polygon bounded by the found units of a group; it is the group's domain if no unit is
    missing.

    ``rows`` are units of sides and their inverses; ``new`` are others.
    """
    tried: set[tuple[int, ...]] = set()  # rounding may ask for the same unit for ever
    while True:
        rows = sight.turned(np.concatenate([rows, new, new @ sight.bar]))
        shape = Shape(sight, rows)
        new = distinct(sight.units(shape.reduced(rows[~shape.bounds])))
        rows = shape.rows
        if not len(new):
            cuts = distinct(sight.units(shape.cutting()))
            new = cuts[[row not in tried for row in map(tuple, cuts.tolist())]]
            tried.update(map(tuple, new.tolist()))
        if not len(new):
            return shape


def corners(dual: Points) -> Points:
    """Return the intersection of each line, given by its dual point, with the previous one, in
    Klein's model.
    """
    before = np.roll(dual, 1)
    area = (before.conj() * dual).imag
    area[abs(area) < 1e-12] = 1e-12
    return 1j * (before - dual) / area


def moved(a: Points, b: Points, z: Points) -> Points:
    """Return the images of points of Klein's model under ``[[a, b], [conj(b), conj(a)]]``."""
    height = abs(a) ** 2 + abs(b) ** 2 + 2 * (a * b.conj() * z).real
    return (2 * a * b + a * a * z + b * b * z.conj()) / height


def hull(points: Points) -> list[int]:
    """Return the indices of the corners of the convex hull of points, counterclockwise."""
    turned = points * np.exp(0.7371j)  # symmetric points have no real part in common
    x, y = turned.real.tolist(), turned.imag.tolist()
    order = np.argsort(turned.real).tolist()
    found: list[int] = []
    for sweep in (order, order[::-1]):
        start = len(found)
        for n in sweep:
            while len(found) >= start + 2:
                p, q = found[-2], found[-1]
                dx, dy = x[n] - x[p], y[n] - y[p]
                if (x[q] - x[p]) * dy > (y[q] - y[p]) * dx + 1e-15 * (abs(dx) + abs(dy)):
                    break
                found.pop()
            found.append(n)
        found.pop()
    return found
