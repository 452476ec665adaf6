"""A curve through keyframes with continuous angular velocity and acceleration.

Between two keyframes the rotation vector from the first of them is a cubic in time. The rates at keyframes
are determined by a continuous acceleration; at the ends they are the mean rates of the end intervals. The
curve is that of scipy's `RotationSpline`.

All computations use rates times the length of an interval, so the unit of time does not matter. The jumps are
linear in the rates, except for one quadratic term at each keyframe. Newton's method makes them 0, starting
from the solution without this term. If it does not converge, the term is introduced in small steps.
"""

from __future__ import annotations

import math
from functools import reduce
from math import factorial
from operator import add
from typing import Literal, overload

from rotation import pytrees
from rotation.angles import waves
from rotation.array_types import Array, ArrayLike, Namespace
from rotation.batch import expect_rotations
from rotation.coordinates import Coordinates, join, polynomial, split, sum_of_squares
from rotation.curves.interpolation import Slerp, interval, picked, ratios, taken
from rotation.errors import RotationError
from rotation.jacobians import inverse_left_jacobian, left_jacobian
from rotation.namespaces import floats, namespace, quiet
from rotation.rigid_motions import INVERSE_JACOBIAN_TIMES, JACOBIAN_TIMES, cross, jacobian_times
from rotation.rotation import Rotation
from rotation.rowwise import RowFormula

_STEPS = 80  # of Newton's method; five are enough unless times are very uneven
_SOLVED_AS_ONE = 24  # equations that are solved as one
_LEAST = 2.0**-7  # of the quadratic term that is let in at once


@pytrees.register_pytree("times", "rotations", "_keys", "_pieces")
class RotationSpline:
    """The smooth curve through keyframes, twice continuously differentiable.

    Parameters
    ----------
    times : array_like, shape (n,)
        Strictly increasing.
    rotations : Rotation, shape (n,)
        At least two keyframes; the curve takes the shorter path between consecutive ones.

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

    def __init__(self, times: ArrayLike, rotations: Rotation) -> None:
        expect_rotations(rotations=rotations)
        if rotations.ndim != 1:
            raise RotationError("a spline goes through a list of rotations, of shape (n,)")
        self._keys = Slerp(times, rotations)
        self.times, self.rotations = self._keys.times, self._keys.rotations
        # In body axes: R(t) = R[k]·exp(θ(t)), whose angular velocity is ω = J(−θ)·θ̇.
        steps = (self.rotations[:-1].inv() * self.rotations[1:]).as_rotvec()
        # For each interval: its rotation, θ' at both ends with respect to the fraction of the
        # interval, its start and its length.
        t = self.times[:, None]
        parts = (steps, *self._solved(steps), t[:-1, ...], t[1:, ...] - t[:-1, ...])
        self._pieces = namespace(steps).concat(parts, axis=-1)

    @overload
    def __call__(self, times: ArrayLike, order: Literal[0] = 0) -> Rotation: ...
    @overload
    def __call__(self, times: ArrayLike, order: Literal[1, 2]) -> Array: ...
    @overload
    def __call__(self, times: ArrayLike, order: int) -> Rotation | Array: ...
    def __call__(self, times: ArrayLike, order: int = 0) -> Rotation | Array:
        """Return rotations (order 0), rates (1) or accelerations (2), (…, 3), in body axes.

        Raises
        ------
        RotationError
            A time outside, or another order.
        """
        return self.extended(self._keys._within(times), order)

    @quiet
    def extended(self, times: ArrayLike, order: int = 0) -> Rotation | Array:
        """Return the same; before the first and after the last keyframe the cubics are extended."""
        if order not in (0, 1, 2):
            raise RotationError(f"order {order!r}: 0, 1 or 2 is expected")
        x = floats(times, "times", namespace(times, self.times))
        n = interval(x, self.times)
        found = _CUBIC[order](taken(self._pieces, n), x)
        return found if order else picked(self.rotations, n) * Rotation.from_rotvec(found)

    @quiet
    def _solved(self, d: Array) -> tuple[Array, Array]:
        """Return θ' (n − 1, 3) at the starts of all intervals and at their ends, per fraction of the
        interval.
        """
        xp = namespace(d)
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
    """The jumps of the acceleration, and the turns at the inner keyframes for which there are no jumps.

    The turns (n − 2, 3) are rates times ``h₀·h₁/(h₀ + h₁)``, for the intervals before and after; multiplying
    by ``late`` and ``early`` gives rates times h₀ and h₁.
    """

    def __init__(self, steps: Array, r: Array) -> None:
        self._steps, self._late, self._early = steps, 1.0 + r, 1.0 + 1.0 / r
        # At the end of an interval: from θ̇ to the rate, and back.
        self._onto, self._into = left_jacobian(-steps), inverse_left_jacobian(-steps)

    def ends(self, turns: Array) -> tuple[Array, Array]:
        """Return θ' at the starts of all intervals and at their ends, per fraction of the interval."""
        d, concat = self._steps, namespace(turns).concat
        back = INVERSE_JACOBIAN_TIMES(-d[:-1, ...], self._late * turns)
        return concat([d[:1, ...], self._early * turns]), concat([back, d[-1:, ...]])

    def removed(self, turns: Array, share: float) -> Array | None:
        """Return turns without jumps, with the quadratic term multiplied by ``share``; None if
        Newton fails.
        """
        xp = namespace(turns)
        eps, before = float(xp.finfo(turns.dtype).eps), math.inf
        for _ in range(_STEPS):
            change = self._newton(turns, share)
            turns = turns + change
            now, size = (float(xp.max(xp.abs(x))) if x.shape[0] else 0.0 for x in (change, turns))
            # The steps decrease quadratically: from the second on, this is the size of the next
            # one.
            later = now * (now / before) ** 2 if now < 2.0**-6 * before < math.inf else now
            if not share or later <= 45.0 * eps * size:
                return turns
            if now <= math.sqrt(eps) / 16.0 * size and now >= 0.5 * before:
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
        rate = INVERSE_JACOBIAN_TIMES(-d, turns)
        before = (2.0 * JACOBIAN_TIMES(-d, starts[:-1, ...]) - 6.0 * d) / late / late
        after = (2.0 * ends[1:, ...] - 6.0 * d_next) / early / early
        jumps = before + after + 4.0 * turns + share * _CHANGE(d, rate)
        # For a quadratic term this difference is the derivative; by columns of the matrix.
        columns = xp.matrix_transpose(into)
        d, rate = d[:, None, :], rate[:, None, :]
        bend = 0.5 * (_CHANGE(d, rate + columns) - _CHANGE(d, rate - columns))
        own = 4.0 * xp.eye(3, dtype=turns.dtype) + share * xp.matrix_transpose(bend)
        scale = (2.0 * early[:-1, ...] / late[1:, ...] / late[1:, ...])[..., None]
        other = (2.0 * late[1:, ...] / early[:-1, ...] / early[:-1, ...])[..., None]
        return _tridiagonal(scale * self._onto[1:-1, ...], own, other * into[1:, ...], -jumps)


def _tridiagonal(before: Array, own: Array, after: Array, right: Array) -> Array:
    """Solve ``before[k−1]·x[k−1] + own[k]·x[k] + after[k]·x[k+1] = right[k]`` for (3, 3) matrices.

    A small system is solved at once. In a large one every other unknown is substituted in the neighbouring
    equations (block cyclic reduction; G. Golub and C. Van Loan, "Matrix computations", 4.5.4), in about log₂
    n steps.
    """
    xp, n = namespace(right), right.shape[0]
    if n == 0:
        return right
    if n <= _SOLVED_AS_ONE:
        blocks = [(0, own)] if n == 1 else [(0, own), (-1, before), (1, after)]
        whole = reduce(add, (_placed(xp, n, k, x) for k, x in blocks))
        flat = xp.linalg.solve(xp.reshape(whole, (3 * n, 3 * n)), xp.reshape(right, (3 * n, 1)))
        return xp.reshape(flat, (n, 3))
    nothing = 0.0 * own[:1, ...]
    before, after = xp.concat([nothing, before]), xp.concat([after, nothing])
    rows = xp.concat([before, after, right[..., None]], axis=-1)[::2, ...]
    solved = xp.linalg.solve(own[::2, ...], rows)  # the even ones by those beside them
    if n % 2 == 0:
        solved = xp.concat([solved, 0.0 * solved[:1, ...]])
    low, high = before[1::2, ...] @ solved[:-1, ...], after[1::2, ...] @ solved[1:, ...]
    odd = _tridiagonal(
        -low[1:, :, :3],
        own[1::2, ...] - low[..., 3:6] - high[..., :3],
        -high[:-1, :, 3:6],
        right[1::2, ...] - low[..., 6] - high[..., 6],
    )
    ends = xp.concat([0.0 * right[:1, ...], odd, 0.0 * right[:1, ...]])
    beside = xp.concat([ends[:-1, ...], ends[1:, ...]], axis=-1)
    even = solved[..., 6] - (solved[..., :6] @ beside[: solved.shape[0], :, None])[..., 0]
    pairs = xp.stack([even[: odd.shape[0], ...], odd], axis=1)
    last = even[odd.shape[0] : n - odd.shape[0], ...]
    return xp.concat([xp.reshape(pairs, (2 * odd.shape[0], 3)), last])


def _placed(xp: Namespace, n: int, k: int, blocks: Array) -> Array:
    """Return the matrix (n, 3, n, 3) with blocks on the k-th diagonal above the main one."""
    ones = xp.eye(blocks.shape[0], n, k=max(k, 0), dtype=blocks.dtype)
    rows = blocks[:, :, None, :] * ones[:, None, :, None]
    nothing = xp.zeros_like(rows[:1, ...])
    return rows if not k else xp.concat([rows, nothing] if k > 0 else [nothing, rows])


def _cubic(piece: Array, time: Array, order: int) -> Array:
    """Return θ at a time in an interval, or with its derivatives the rate or the acceleration."""
    xp, c = namespace(piece), split(piece)
    d, start, end, (begin, h) = c[:3], c[3:6], c[6:9], c[9:]
    s = (time[...] - begin) / h
    rest = 1.0 - s

    def mixed(a: Array, b: Array, e: Array) -> Coordinates:
        return tuple(a * x + (b * y + e * z) for x, y, z in zip(d, start, end, strict=True))

    theta = mixed(s * s * (3.0 - 2.0 * s), s * rest * rest, -s * s * rest)
    if order == 0:
        return join(xp, theta)
    back = tuple(-x for x in theta)
    turn = mixed(6.0 * s * rest, rest * (1.0 - 3.0 * s), s * (3.0 * s - 2.0))
    if order == 1:
        return join(xp, tuple(x / h for x in jacobian_times(xp, back, turn)))
    bend = mixed(6.0 * (1.0 - 2.0 * s), 6.0 * s - 4.0, 6.0 * s - 2.0)
    both = zip(jacobian_times(xp, back, bend), _changed(xp, theta, turn), strict=True)
    return join(xp, tuple((x + y) / h / h for x, y in both))


def _change(theta: Array, rate: Array) -> Array:
    return join(namespace(theta), _changed(namespace(theta), split(theta), split(rate)))


def _changed(xp: Namespace, u: Coordinates, v: Coordinates) -> Coordinates:
    """Return the derivative of ``J(−θ)·θ̇`` along θ̇, with θ̇ constant, by its series or in closed form."""
    t = sum_of_squares(u)
    wide = t > 0.25
    far = xp.where(wide, t, xp.ones_like(t))
    size = xp.sqrt(far)
    small = xp.where(wide, xp.zeros_like(t), t)
    sine, cosine = waves(xp, size, False)
    # B, and the derivatives of A and B by θ² doubled.
    b = xp.where(wide, (size - sine) / (far * size), polynomial(_B, small))
    da = xp.where(wide, (size * sine - 2.0 * (1.0 - cosine)) / (far * far), polynomial(_DA, small))
    db = (3.0 * sine - size * cosine - 2.0 * size) / (far * far * size)
    db = xp.where(wide, db, polynomial(_DB, small))
    along = u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
    across = cross(u, v)
    terms = zip(across, cross(u, across), cross(v, across), strict=True)
    return tuple(along * (db * y - da * x) + b * z for x, y, z in terms)


def _series(first: int, derivative: bool) -> list[float]:
    """Return the coefficients of A (first = 2) or B (3) in powers of θ², or of twice their derivatives."""
    values = [(-1.0) ** k / factorial(2 * k + first) for k in range(12)]
    return [2.0 * (k + 1) * v for k, v in enumerate(values[1:])] if derivative else values


_B, _DA, _DB = _series(3, False), _series(2, True), _series(3, True)
_CHANGE = RowFormula(_change, (3,), (3,))
_CUBIC = [RowFormula(_cubic, (11,), (), parameters=(order,)) for order in (0, 1, 2)]
