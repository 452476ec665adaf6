"""The geodesic median of rotations: the one with the least weighted sum of angles to them.

The sum f may have several local minima if the rotations are spread out. The rotations that differ by a half
turn from a given one form the plane ``q·qᵢ = 0`` in the sphere of quaternions. These planes divide the sphere
into cells, and f is convex in each, because an angle below π has nonnegative second derivatives. So a
rotation at which the gradient vanishes is the minimum of its cell. Branch and bound over SO(3) finds the best
cell with two lower bounds:

- each angle changes by at most the distance moved, so in a ball of radius ρ, ``f ≥ Σ wᵢ·max(0, angleᵢ − ρ)``;
- the angles to those rotations whose plane does not meet the ball lie above their tangent planes.

If all rotations lie within a quarter turn of one local minimum, it is the only one (B. Afsari, "Riemannian
Lᵖ center of mass", Proc. AMS 139, 2011).
"""

import itertools
import math
from typing import NamedTuple

import numpy as np

from rotation.array_types import Array
from rotation.errors import RotationError
from rotation.quaternions import canonical, inverse, normalised, product
from rotation.vectors import from_rotvec, to_rotvec

SAME_ANGLE = 1e-13  # radians within which two rotations are one
TIE = 1e-13  # relative difference of two sums that are equal
MAX_STEPS = 1000  # of a descent
MAX_DEPTH = 22  # halvings of a box: to BOUND_ERROR
MAX_BOXES = 1 << 20  # at one depth
MAX_DESCENTS = 4  # begun at each depth
BLOCK = 1 << 16  # angles computed at once
BOUND_ERROR = 1e-7  # radians: of the angles in bounds, which come from cosines
SAME_PLACE = 1e-6  # radians between the ends of two descents to one flat minimum
_EPS = float(np.finfo(np.float64).eps)
_CORNERS = np.array(list(itertools.product((-1.0, 1.0), repeat=3)))


class _Sum(NamedTuple):
    """The sum of angles at a rotation, and the terms of its gradient."""

    at: Array  # the quaternion (4,)
    value: float
    away: Array  # (n, 3): rotation vectors to the given rotations
    angles: Array  # (n,)
    pull: Array  # (3,): minus the slope by the rotations elsewhere
    here: float  # the weight of the rotations at this place

    @property
    def slope(self) -> float:
        """The steepest descent per radian; 0 at a local minimum."""
        return max(0.0, math.sqrt(self.pull @ self.pull) - self.here)


def geodesic_median(q: Array, w: Array, start: Array) -> Array:
    """Return the median (4,) of unit quaternions (n, 4), canonical in sign.

    Parameters
    ----------
    w : ndarray, shape (n,)
        Positive weights of at most 1.
    start : ndarray, shape (4,)
        A first guess.

    Raises
    ------
    RotationError
        Two different rotations have the same least sum.
    """
    first = _descend(q, w, start)
    if first.angles.max() < 0.5 * math.pi:
        return canonical(first.at)
    best, *others = _search(q, w, first)
    for other in others:
        if other.value <= best.value * (1.0 + TIE) and not _same_place(best, other):
            raise RotationError(
                "the median is not determined: two rotations have the same least sum of angles, "
                f"{best.at} and {other.at}"
            )
    return canonical(best.at)


def _sum_at(q: Array, w: Array, at: Array) -> _Sum:
    away = to_rotvec(product(q, inverse(at)))
    angles = np.sqrt((away * away).sum(axis=-1))
    apart = angles > SAME_ANGLE
    share = np.where(apart, w, 0.0) / np.where(apart, angles, 1.0)
    return _Sum(at, float(w @ angles), away, angles, share @ away, float(w[~apart].sum()))


def _descend(q: Array, w: Array, start: Array) -> _Sum:
    """Return a local minimum reached by descent.

    It takes Newton steps if they decrease the sum, else Weiszfeld steps, which always do: R. Hartley, K.
    Aftab and J. Trumpf, "L1 rotation averaging using the Weiszfeld algorithm", CVPR 2011. At the given
    rotations themselves it takes the step of Y. Vardi and C.-H. Zhang, PNAS 97 (2000).
    """
    current = _sum_at(q, w, start)
    rounding = 4.0 * _EPS * float(w.sum())
    seen = set[int]()
    for _ in range(MAX_STEPS):
        if current.slope <= rounding:
            break
        nearest = int(np.argmin(current.angles))
        if nearest not in seen:  # near one of the rotations all steps are short
            seen.add(nearest)
            there = _sum_at(q, w, q[nearest])
            # If it lies on the plane of another rotation, the sum may be level on one side.
            inside = there.angles.max() < math.pi - SAME_ANGLE
            if inside and there.slope <= rounding and there.value <= current.value:
                return there
        candidate = _newton(q, w, current)
        if candidate is None or not _improves(candidate, current):
            candidate = _weiszfeld(q, w, current)
        if not _improves(candidate, current):
            break
        current = candidate
    nearest = int(np.argmin(current.angles))
    return _sum_at(q, w, q[nearest]) if current.angles[nearest] <= SAME_ANGLE else current


def _improves(new: _Sum, old: _Sum) -> bool:
    """Return whether a step decreases the sum, or the gradient if the sums differ only by rounding."""
    noise = 8.0 * _EPS * old.value
    return new.value < old.value - noise or (
        new.value <= old.value + noise and new.slope < old.slope
    )


def _newton(q: Array, w: Array, s: _Sum) -> _Sum | None:
    """Take a Newton step, if the sum has second derivatives: ``½·cot(angle/2)`` perpendicular to each
    geodesic.
    """
    if s.here:
        return None
    bend = w * 0.5 / np.tan(0.5 * s.angles)
    ways = s.away / s.angles[:, None]
    hessian = bend.sum() * np.eye(3) - (ways.T * bend) @ ways
    size = float(np.trace(hessian))
    if not 0.0 < size < math.inf:
        return None
    step = np.linalg.solve(hessian + 8.0 * _EPS * size * np.eye(3), s.pull)
    if not step @ step < 1.0:
        return None
    return _sum_at(q, w, product(from_rotvec(step), s.at))


def _weiszfeld(q: Array, w: Array, s: _Sum) -> _Sum:
    apart = s.angles > SAME_ANGLE
    share = float((w[apart] / s.angles[apart]).sum())
    step = (1.0 - s.here / math.sqrt(s.pull @ s.pull)) * s.pull / share
    return _sum_at(q, w, product(from_rotvec(step), s.at))


class _Boxes(NamedTuple):
    """Cubes on the faces ``q[face] = 1`` of the cube around the sphere of quaternions."""

    face: Array  # (m,)
    middle: Array  # (m, 3)
    half: float

    def quaternions(self, offset: Array) -> Array:
        """Return the unit quaternions at an offset from the centres, in half edges."""
        points = self.middle + self.half * offset
        places = np.arange(4) - (np.arange(4) > self.face[:, None])
        raised = np.take_along_axis(points, np.minimum(places, 2), axis=1)
        return normalised(np.where(np.arange(4) == self.face[:, None], 1.0, raised))

    def radii(self, centers: Array) -> Array:
        """Return, for each cube, the largest angle between its centre and a rotation in it."""
        chords = [np.sqrt(((self.quaternions(c) - centers) ** 2).sum(axis=1)) for c in _CORNERS]
        found: Array = 4.0 * np.arcsin(0.5 * np.max(chords, axis=0))
        return found

    def selected(self, kept: Array) -> "_Boxes":
        """Return the cubes selected by ``kept``."""
        return _Boxes(self.face[kept], self.middle[kept], self.half)

    def divided(self) -> "_Boxes":
        """Return the eight subcubes of each cube."""
        half = 0.5 * self.half
        middle = (self.middle[:, None, :] + half * _CORNERS).reshape(-1, 3)
        return _Boxes(np.repeat(self.face, 8), middle, half)


class _Bounds(NamedTuple):
    """Bounds of the sum on boxes."""

    value: Array  # (m,): the sum in the middle
    least: Array  # (m,): no sum in the box is less
    cell: (
        Array  # (m,): bytes that identify the cell of each box; None if the box meets several cells
    )


class _Ends:
    """The end points of descents, and the cells whose minimum they are."""

    def __init__(self, q: Array, w: Array) -> None:
        self._q, self._w = q, w
        self._found = list[_Sum]()
        self.decided = set[bytes]()

    def add(self, end: _Sum, start: Array) -> bool:
        """Record the end of a descent that started in a cell; return whether it is new."""
        (own,) = _cells((end.at @ self._q.T)[None])
        new = own not in self.decided and not any(_same_place(end, e) for e in self._found)
        for inside in (start, end.at):
            cosines = inside @ self._q.T
            if self._is_minimum(end, np.where(cosines > 0.0, 1.0, -1.0)):
                self.decided.update(_cells(cosines[None]))
        if new:
            self._found.append(end)
        return new

    def _is_minimum(self, end: _Sum, signs: Array) -> bool:
        """Return whether an end minimises the sum in its closed cell, ``signsᵢ·(q·qᵢ) ≥ 0`` or ``≤ 0``."""
        cosines = signs * (self._q @ end.at)
        if cosines.sum() < 0.0:
            signs, cosines = -signs, -cosines
        if cosines.min() < -SAME_ANGLE:
            return False
        apart = end.angles > SAME_ANGLE
        away = (signs[:, None] * self._q - cosines[:, None] * end.at)[apart]
        pull = (self._w[apart] / np.sqrt((away * away).sum(axis=1))) @ away
        return bool(math.sqrt(pull @ pull) <= end.here + BOUND_ERROR)

    def sorted(self) -> list[_Sum]:
        """Return the ends, in order of the sum."""
        return sorted(self._found, key=lambda end: end.value)


def _same_place(a: _Sum, b: _Sum) -> bool:
    return bool(abs(a.at @ b.at) > math.cos(0.5 * SAME_PLACE))


def _search(q: Array, w: Array, first: _Sum) -> list[_Sum]:
    """Return the ends of descents from all regions that may contain the least sum, in order of the sum."""
    ends = _Ends(q, w)
    ends.add(first, first.at)
    tried = set[bytes]()
    boxes = _Boxes(np.arange(4), np.zeros((4, 3)), 1.0).divided().divided()
    for _ in range(MAX_DEPTH):
        if not len(boxes.face):
            break
        if len(boxes.face) > MAX_BOXES:
            raise RotationError(
                "the median is not determined: sums of angles are nearly the least in a whole region"
            )
        centers = boxes.quaternions(np.zeros(3))
        bounds = _bounds(q, w, centers, boxes.radii(centers))
        kept = _open(bounds, ends)
        if not len(kept):
            break
        lowest = kept[np.argsort(bounds.value[kept])]
        begun = 0
        for n in lowest:
            cell = bounds.cell[n]
            if n != lowest[0] and (cell is None or cell in tried):
                continue
            tried.add(cell)
            begun += 1
            new = ends.add(_descend(q, w, centers[n]), centers[n])
            if (begun > 1 and not new) or begun == MAX_DESCENTS:
                break
        boxes = boxes.selected(_open(bounds, ends)).divided()
    return ends.sorted()


def _open(bounds: _Bounds, ends: _Ends) -> Array:
    """Return the boxes that may contain a smaller sum than the known minima, or an equal one in
    another cell.
    """
    decided = np.array([cell in ends.decided for cell in bounds.cell], bool)
    least = ends.sorted()[0].value + BOUND_ERROR
    return np.flatnonzero(~decided & (bounds.least <= least))


def _cells(cosines: Array) -> list[bytes]:
    """Return keys of the cells of quaternions, from signs at the planes; q and −q have the same key."""
    sides = (cosines > 0.0) == (cosines[:, :1] > 0.0)
    return [row.tobytes() for row in np.packbits(sides, axis=1)]


def _bounds(q: Array, w: Array, centers: Array, radii: Array) -> _Bounds:
    """Bound the sum in balls around the centers (m, 4), block by block."""
    values, least, cells = [], [], list[bytes | None]()
    step = max(1, BLOCK // len(q))
    for start in range(0, len(centers), step):
        c, radius = centers[start : start + step], radii[start : start + step]
        cosines = c @ q.T
        size = np.minimum(np.abs(cosines), 1.0)
        angles = 2.0 * np.arccos(size)
        cut = angles + radius[:, None] >= math.pi - BOUND_ERROR
        value = angles @ w
        sines = np.sqrt(np.maximum(1.0 - size * size, _EPS))
        pulls = np.where(cut, 0.0, w * np.sign(cosines) / sines)
        slope = pulls @ q - (pulls * cosines).sum(axis=1, keepdims=True) * c
        steepest = np.sqrt((slope * slope).sum(axis=1)) + cut @ w
        least.append(
            np.maximum(value - radius * steepest, np.maximum(angles - radius[:, None], 0.0) @ w)
        )
        values.append(value)
        cells += [
            None if several else cell
            for several, cell in zip(cut.any(axis=1), _cells(cosines), strict=True)
        ]
    whole = np.empty(len(cells), object)
    whole[:] = cells
    return _Bounds(np.concatenate(values), np.concatenate(least), whole)
