"""A curve through keyframes whose angular velocity and acceleration are continuous.

Between two keyframes the rotation vector from the first of them is a cubic of time. The rates at keyframes
are those for which the acceleration has no jump; at the ends they are the mean rates of the intervals there.
The curve is the one of scipy's `RotationSpline`.

All is computed in turns, which are rates times a time, so that the unit of time does not matter. The jumps
are linear in the rates but for one quadratic term at each keyframe. Newton's method finds where they are 0,
from the solution without that term; where it does not, more and more of the term is let in.
"""

import math
from math import factorial
from typing import Any

from rotation import pytrees
from rotation.batch import expect_rotations
from rotation.coordinates import join, polynomial, split, sum_of_squares
from rotation.curves.interpolation import Slerp, picked, place, ratios, taken
from rotation.errors import RotationError
from rotation.jacobians import inverse_left_jacobian, left_jacobian
from rotation.namespaces import Array, floats, namespace, quiet
from rotation.rigid_motions import SWEPT, UNSWEPT, cross
from rotation.rotation import Rotation
from rotation.rowwise import Formula

_STEPS = 80  # of Newton's method; five are enough unless times are very uneven
_LEAST = 2.0**-7  # of the quadratic term that is let in at once


@pytrees.holding("times", "rotations", "_keys", "_steps", "_starts", "_ends")
class RotationSpline:
    """The smooth curve through keyframes: two continuous derivatives.

    Parameters
    ----------
    times : array_like, shape (n,)
        Strictly increasing.
    rotations : Rotation, shape (n,)
        At least two keyframes; from each to the next it goes the shorter way.

    Raises
    ------
    RotationError
        Times that do not increase or do not fit the rotations, or keyframes for which no curve was found.

    Examples
    --------
    >>> keys = Rotation.from_euler("Z", [[0], [90], [180]], degrees=True)
    >>> RotationSpline([0, 1, 2], keys)(1).as_rotvec(degrees=True).round(9) + 0.0
    array([ 0.,  0., 90.])
    """

    def __init__(self, times: Any, rotations: Rotation) -> None:
        expect_rotations(rotations=rotations)
        if rotations.ndim != 1:
            raise RotationError("a spline goes through a list of rotations, of shape (n,)")
        self._keys = Slerp(times, rotations)
        self.times, self.rotations = self._keys.times, self._keys.rotations
        # In the axes of the body: R(t) = R[k]·exp(θ(t)), the rate of which is ω = J(−θ)·θ̇.
        self._steps = (self.rotations[:-1].inv() * self.rotations[1:]).as_rotvec()
        self._starts, self._ends = self._solved()

    def __call__(self, times: Any, order: int = 0) -> Any:
        """Return rotations (order 0), rates (1) or accelerations (2), (…, 3), in the axes of the body.

        Raises
        ------
        RotationError
            A time outside, or another order.
        """
        self._keys._place(times)
        return self.extended(times, order)

    @quiet
    def extended(self, times: Any, order: int = 0) -> Any:
        """Return the same; before the first and after the last keyframe their cubics go on."""
        if order not in (0, 1, 2):
            raise RotationError(f"order {order!r}: 0, 1 or 2 is expected")
        n, s = place(floats(times, "times", namespace(times, self.times)), self.times)
        s = s[..., None]
        d, start, end = (taken(x, n) for x in (self._steps, self._starts, self._ends))
        rest = 1.0 - s
        theta = s * s * (3.0 - 2.0 * s) * d + s * rest * (rest * start - s * end)
        if order == 0:
            return picked(self.rotations, n) * Rotation.from_rotvec(theta)
        h = taken(self.times, n + 1)[..., None] - taken(self.times, n)[..., None]
        turn = 6.0 * s * rest * d + rest * (1.0 - 3.0 * s) * start + s * (3.0 * s - 2.0) * end
        if order == 1:
            return SWEPT(-theta, turn) / h
        bend = 6.0 * (1.0 - 2.0 * s) * d + (6.0 * s - 4.0) * start + (6.0 * s - 2.0) * end
        return (SWEPT(-theta, bend) + _CHANGE(theta, turn)) / h / h

    @quiet
    def _solved(self) -> tuple[Array, Array]:
        """Return θ' (n − 1, 3) at the starts of all intervals and at their ends, by the fraction of each."""
        d, xp = self._steps, namespace(self._steps)
        if not bool(xp.all(xp.isfinite(d))):
            return d * xp.nan, d * xp.nan
        jumps = _Jumps(d, ratios(self.times)[:, None])
        turns = 0.0 * d[1:, ...]
        done, step = 0.0, 0.0  # first all that is linear, then at once as much as converges
        while done < 1.0:
            found = jumps.removed(turns, min(done + step, 1.0))
            if found is not None:
                turns, done, step = found, done + step, 2.0 * step or 1.0
            else:
                step = 0.25 * step
                if step < _LEAST:
                    raise RotationError(self._advice())
        return jumps.ends(turns)

    def _advice(self) -> str:
        xp, r = namespace(self.times), ratios(self.times)
        k = 1 + int(xp.argmax(xp.maximum(r, 1.0 / r)))  # where neighbours are least even
        angles = (self.rotations[:-1].inv() * self.rotations[1:]).magnitude(degrees=True)
        first, second = (
            f"{float(angles[n]):.0f}° in {float(self.times[n + 1] - self.times[n]):g}"
            for n in (k - 1, k)
        )
        return (
            f"no smooth curve was found: at keyframe {k} a turn of {first} meets one of {second}; "
            "give keyframes at more even times, or take Squad, which has a curve for any"
        )


class _Jumps:
    """The jumps of the acceleration, and the turns at the inner keyframes for which there are none.

    The turns (n − 2, 3) are rates times ``h₀·h₁/(h₀ + h₁)``, of the intervals before and after; ``late`` and
    ``early`` times as much are rates times h₀ and h₁.
    """

    def __init__(self, steps: Array, r: Array) -> None:
        self._steps, self._late, self._early = steps, 1.0 + r, 1.0 + 1.0 / r
        # At the end of an interval: from θ̇ to the rate, and back.
        self._onto, self._into = left_jacobian(-steps), inverse_left_jacobian(-steps)

    def ends(self, turns: Array) -> tuple[Array, Array]:
        """Return θ' at the starts of all intervals and at their ends, by the fraction of each."""
        d, concat = self._steps, namespace(turns).concat
        back = UNSWEPT(-d[:-1, ...], self._late * turns)
        return concat([d[:1, ...], self._early * turns]), concat([back, d[-1:, ...]])

    def removed(self, turns: Array, share: float) -> Array | None:
        """Return turns that make no jumps if a share of the quadratic term counts; None if none are found."""
        xp = namespace(turns)
        eps, before = float(xp.finfo(turns.dtype).eps), math.inf
        for _ in range(_STEPS):
            change = self._newton(turns, share)
            turns = turns + change
            now, size = (float(xp.max(xp.abs(x))) if x.shape[0] else 0.0 for x in (change, turns))
            if now <= 45.0 * eps * size or (
                now <= math.sqrt(eps) / 16.0 * size and now >= 0.5 * before
            ):
                return turns
            if not math.isfinite(now):
                return None
            before = now
        return None

    def _newton(self, turns: Array, share: float) -> Array:
        d, d_next = self._steps[:-1, ...], self._steps[1:, ...]
        into = self._into[:-1, ...]
        late, early, xp = self._late, self._early, namespace(turns)
        starts, ends = self.ends(turns)
        rate = UNSWEPT(-d, turns)
        before = (2.0 * SWEPT(-d, starts[:-1, ...]) - 6.0 * d) / late / late
        after = (2.0 * ends[1:, ...] - 6.0 * d_next) / early / early
        jumps = before + after + 4.0 * turns + share * _CHANGE(d, rate)
        # Of a quadratic term this difference is the derivative; by the columns of the matrix.
        columns = xp.matrix_transpose(into)
        d, rate = d[:, None, :], rate[:, None, :]
        bend = 0.5 * (_CHANGE(d, rate + columns) - _CHANGE(d, rate - columns))
        own = 4.0 * xp.eye(3, dtype=turns.dtype) + share * xp.matrix_transpose(bend)
        scale = (2.0 * early[:-1, ...] / late[1:, ...] / late[1:, ...])[..., None]
        other = (2.0 * late[1:, ...] / early[:-1, ...] / early[:-1, ...])[..., None]
        return _tridiagonal(scale * self._onto[1:-1, ...], own, other * into[1:, ...], -jumps)


def _tridiagonal(before: Array, own: Array, after: Array, right: Array) -> Array:
    """Solve ``before[k−1]·x[k−1] + own[k]·x[k] + after[k]·x[k+1] = right[k]``, of matrices (3, 3)."""
    xp, n = namespace(right), right.shape[0]
    rows = xp.concat([own, right[..., None]], axis=-1)
    solved: list[Array] = []
    for k in range(n):
        row = rows[k, ...]
        if k:
            row = row - before[k - 1, ...] @ solved[-1]
        beside = after[k, ...] if k + 1 < n else 0.0 * own[k, ...]
        solved.append(xp.linalg.solve(row[:, :3], xp.concat([beside, row[:, 3:]], axis=-1)))
    x = [0.0 * right[0, ...]] if n else []
    for row in reversed(solved):
        x.append(row[:, 3] - row[:, :3] @ x[-1])
    return xp.stack(x[:0:-1]) if n else right


def _change(theta: Array, rate: Array) -> Array:
    """The derivative of ``J(−θ)·θ̇`` along θ̇, θ̇ fixed, by its series or in closed form."""
    xp = namespace(theta, rate)
    u, v = split(theta), split(rate)
    t = sum_of_squares(u)
    wide = t > 0.25
    far = xp.where(wide, t, xp.ones_like(t))
    size = xp.sqrt(far)
    small = xp.where(wide, xp.zeros_like(t), t)
    sine, cosine = xp.sin(size), xp.cos(size)
    # B, and the derivatives of A and B by θ² doubled.
    b = xp.where(wide, (size - sine) / (far * size), polynomial(_B, small))
    da = xp.where(wide, (size * sine - 2.0 * (1.0 - cosine)) / (far * far), polynomial(_DA, small))
    db = (3.0 * sine - size * cosine - 2.0 * size) / (far * far * size)
    db = xp.where(wide, db, polynomial(_DB, small))
    along = u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
    across = cross(u, v)
    terms = zip(across, cross(u, across), cross(v, across), strict=True)
    return join(xp, tuple(along * (db * y - da * x) + b * z for x, y, z in terms))


def _series(first: int, derived: bool) -> list[float]:
    """Coefficients of A (first = 2) or B (3) by θ², or of twice their derivatives."""
    values = [(-1.0) ** k / factorial(2 * k + first) for k in range(12)]
    return [2.0 * (k + 1) * v for k, v in enumerate(values[1:])] if derived else values


_B, _DA, _DB = _series(3, False), _series(2, True), _series(3, True)
_CHANGE = Formula(_change, (3,), (3,))
