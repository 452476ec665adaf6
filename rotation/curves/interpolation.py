"""Interpolate between rotations: slerp and squad, pointwise and through keyframes.

K. Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985, and "Quaternion calculus and fast
animation", 1987. Slerp takes the shorter path, so the signs of quaternions do not matter.
"""

from __future__ import annotations

import math
from sys import modules

from rotation import pytrees, quaternions, vectors
from rotation.array_types import Array, ArrayLike
from rotation.batch import expect_rotations
from rotation.errors import RotationError
from rotation.namespaces import certainly, copied, floats, is_numpy, namespace, number, quiet
from rotation.quaternions import SLERP
from rotation.rotation import Rotation


def slerp(p: Rotation, q: Rotation, t: ArrayLike) -> Rotation:
    """Return the rotation at ``t`` on the path from ``p`` (t = 0) to ``q`` (t = 1) with constant velocity.

    Parameters
    ----------
    p, q : Rotation
        If p and q are the same rotation, the result is p, whatever the signs of the quaternions. If they
        differ by a half turn, two paths are equally short. The one used rotates from ``p`` about the body
        axis whose first nonzero coordinate is positive.
    t : float or array
        Values outside [0, 1] extrapolate. The shapes of p, q and t broadcast.

    Examples
    --------
    >>> p = Rotation.from_euler("Z", 0.0)
    >>> q = Rotation.from_euler("Z", 90, degrees=True)
    >>> slerp(p, q, [0.0, 0.5, 1.0]).as_euler("ZYX", degrees=True)[:, 0].round(12)
    array([ 0., 45., 90.])
    """
    if type(p) is type(q) is Rotation:
        made: Rotation | None = SLERP.function(Rotation, p._q, q._q, t)
        if made is not None:
            # a call of `known` would be a tenth of all the time
            return made if len(modules) == pytrees.number_of_modules else pytrees.known(made)
    expect_rotations(p=p, q=q)
    return Rotation._of(quaternions.slerp(p._q, q._q, _parameter(t, p, q)))


@quiet
def squad(p: Rotation, q: Rotation, a: Rotation, b: Rotation, t: ArrayLike) -> Rotation:
    """Return the point at ``t`` of the spherical cubic from ``p`` to ``q`` with inner points a and b.

    The formula is ``slerp(slerp(p, q, t), slerp(a, b, t), 2t(1 − t))``. The curve leaves p towards a and
    arrives at q from b. `Squad` finds the inner points of a smooth curve through keyframes. Shapes broadcast.

    Examples
    --------
    >>> p = Rotation.identity()
    >>> q = Rotation.from_euler("Z", 90, degrees=True)
    >>> squad(p, q, p, q, 0.5).as_rotvec(degrees=True).round(9) + 0.0
    array([ 0.,  0., 45.])
    """
    expect_rotations(p=p, q=q, a=a, b=b)
    q = _nearer(q, p)
    return _cubic(p, q, _nearer(a, p), _nearer(b, q), _parameter(t, p, q, a, b))


def _parameter(t: ArrayLike, *rotations: Rotation) -> Array | float:
    if isinstance(t, int | float):
        return number(t, "t")
    return floats(t, "t", namespace(t, *(r._q for r in rotations)))


def _cubic(p: Rotation, q: Rotation, a: Rotation, b: Rotation, t: Array | float) -> Rotation:
    """Return the spherical cubic of the given quaternions, without sign changes."""
    return _direct(_direct(p, q, t), _direct(a, b, t), 2.0 * t * (1.0 - t))


def _direct(p: Rotation, q: Rotation, t: Array | float) -> Rotation:
    """Return the slerp of the quaternions themselves, which turns by more than π if their dot product is
    negative.
    """
    return p * Rotation._of(quaternions.direct_power((p.inv() * q)._q, t))


def _nearer(q: Rotation, p: Rotation) -> Rotation:
    """Return the rotations q, with the sign of each quaternion chosen to be nearer to p."""
    xp = namespace(p._q, q._q)
    far = xp.sum(p._q * q._q, axis=-1, keepdims=True) < 0.0
    return Rotation._of(xp.where(far, -q._q, q._q))


@pytrees.register_pytree("times", "rotations")
class Slerp:
    """The curve through keyframes with constant angular velocity between consecutive keyframes.

    Parameters
    ----------
    times : array_like, shape (n,)
        Strictly increasing; numpy arrays, or arrays of the rotations' library.
    rotations : Rotation, shape (n, …)
        At least two keyframes along the first axis.

    Raises
    ------
    RotationError
        Times that do not increase or do not fit the rotations.

    Examples
    --------
    >>> keys = Rotation.from_euler("Z", [[0], [90]], degrees=True)
    >>> Slerp([0, 1], keys)(0.5).as_rotvec(degrees=True).round(9) + 0.0
    array([ 0.,  0., 45.])
    """

    def __init__(self, times: ArrayLike, rotations: Rotation) -> None:
        expect_rotations(rotations=rotations)
        self.times = _times(times, rotations)
        self.rotations = rotations

    def __call__(self, times: ArrayLike) -> Rotation:
        """Return the rotations at ``times`` (…), which must lie in the range of the keyframes; NaN gives NaN.

        Raises
        ------
        RotationError
            A time is outside the range of the curve.
        """
        x = self._within(times)
        n, t = place(x, self.times)
        return self._between(
            n, namespace(t).reshape(t, (*t.shape, *(1,) * (self.rotations.ndim - 1)))
        )

    def _within(self, times: ArrayLike) -> Array:
        """Return times (…) as an array; raise `RotationError` if one is outside the range of the
        keyframes.
        """
        xp = namespace(times, self.times)
        x = floats(times, "times", xp)
        first, last = self.times[0], self.times[-1]
        if certainly(xp.any((x < first) | (x > last))):
            raise RotationError(
                f"times from {float(first):g} to {float(last):g} are expected, as the keyframes have"
            )
        return x

    def _between(self, n: Array, t: Array) -> Rotation:
        return slerp(picked(self.rotations, n), picked(self.rotations, n + 1), t)


def place(x: Array, times: Array) -> tuple[Array, Array]:
    """Return the index of the interval of ``times`` (n,) that contains x (…), and the position in it, from 0
    to 1.
    """
    n = interval(x, times)
    start = taken(times, n)
    return n, (x - start) / (taken(times, n + 1) - start)


def interval(x: Array, times: Array) -> Array:
    """Return the index of the interval of ``times`` (n,) that contains x (…), or of the nearest one."""
    xp = namespace(x, times)
    after = xp.searchsorted(times, xp.reshape(x, (-1,)), side="right")
    return xp.reshape(xp.clip(after - 1, 0, times.shape[0] - 2), x.shape)


@quiet
def ratios(times: Array) -> Array:
    """Return the ratio of each interval's length to that of the next, limited to the range of floats."""
    xp, h = namespace(times), times[1:] - times[:-1]
    least = float(xp.finfo(h.dtype).smallest_normal)
    return xp.clip(h[:-1] / h[1:], least, 1.0 / least)


def taken(array: Array, n: Array) -> Array:
    """Return ``array[n]``: rows along the first axis, for integers n of any shape."""
    xp = namespace(array)
    rows = xp.take(array, xp.reshape(n, (-1,)), axis=0)
    return xp.reshape(rows, (*n.shape, *rows.shape[1:]))


def picked(rotations: Rotation, n: Array) -> Rotation:
    """Return ``rotations[n]`` for integers n of any shape, in any array library."""
    return Rotation._of(taken(rotations._q, n))


@pytrees.register_pytree("times", "rotations", "_after", "_before")
class Squad(Slerp):
    """The curve through keyframes with continuous angular velocity, made of spherical cubics.

    The velocity at a keyframe is the mean of the velocities of the two neighbouring slerps, each weighted by
    the length of the other interval, as for the parabola through three keyframes. If the intervals are so
    uneven that no spherical cubic has this velocity, the nearest possible weights are used; see
    docs/reference/rotation.md. At the ends it is the velocity of the only neighbouring slerp. With two
    keyframes the curve is a slerp. Parameters and errors are those of `Slerp`.

    Examples
    --------
    >>> keys = Rotation.from_euler("Z", [[0], [90], [180]], degrees=True)
    >>> Squad([0, 1, 2], keys)(0.5).as_rotvec(degrees=True).round(9) + 0.0
    array([ 0.,  0., 45.])
    """

    def __init__(self, times: ArrayLike, rotations: Rotation) -> None:
        super().__init__(times, rotations)
        steps = (rotations[:-1].inv() * rotations[1:])._q
        keys = self.rotations = _continuous(rotations, steps)
        turns = vectors.to_rotvec(steps)
        late, early = _ends(self.times, turns, quaternions.angle(steps))
        # At t = 0 a squad rotates by log(p⁻¹q) + 2·log(p⁻¹a) per unit of t, at t = 1 by log(p⁻¹q) −
        # 2·log(q⁻¹b); solved for the inner points a and b.
        self._after = keys[:-1] * _turn((early - turns) / 2.0)
        self._before = keys[1:] * _turn((turns - late) / 2.0)

    def _between(self, n: Array, t: Array) -> Rotation:
        p, q = picked(self.rotations, n), picked(self.rotations, n + 1)
        return _cubic(p, q, picked(self._after, n), picked(self._before, n), t)


def _continuous(rotations: Rotation, steps: Array) -> Rotation:
    """Return the same rotations, with signs chosen such that each step (…, 4) is the shorter one."""
    q, xp = rotations._q, namespace(rotations._q)
    flips = xp.any(quaternions.canonical(steps) != steps, axis=-1)
    odd = xp.cumulative_sum(xp.astype(flips, xp.int64), axis=0) % 2 == 1
    rest = xp.where(odd[..., None], -q[1:, ...], q[1:, ...])
    return Rotation._of(xp.concat([q[:1, ...], rest], axis=0))


@quiet
def _ends(times: Array, turns: Array, sizes: Array) -> tuple[Array, Array]:
    """Return the velocities at the ends and starts of intervals (n − 1, …, 3), as rotation vectors.

    Where intervals h₀ and h₁ with turns p and s meet, the velocity is ``x·p/h₀ + y·s/h₁`` with x + y = 1. A
    parabola has x : y = h₁ : h₀. No logarithm wraps around as long as ``x·(|s| + |p|·h₁/h₀) ≤ 2π − |s|`` and
    ``y·(|p| + |s|·h₀/h₁) ≤ 2π − |p|``. The ratio x : y = h₀ : h₁ satisfies this; the ratio used is the
    admissible one nearest to that of the parabola.
    """
    xp = namespace(times, turns)
    r = xp.reshape(ratios(times), (-1, *(1,) * (turns.ndim - 1)))
    (p, s), (before, after) = ((a[:-1, ...], a[1:, ...]) for a in (turns, sizes[..., None]))
    x = xp.minimum(1.0 / (1.0 + r), (2.0 * math.pi - after) / (after + before / r))
    y = xp.minimum(
        xp.maximum(r / (1.0 + r), 1.0 - x), (2.0 * math.pi - before) / (before + r * after)
    )
    x = xp.maximum(x, 1.0 - y)
    late = xp.concat([x * p + (y * r) * s, turns[-1:, ...]], axis=0)
    early = xp.concat([turns[:1, ...], (x / r) * p + y * s], axis=0)
    return late, early


def _turn(rotvec: Array) -> Rotation:
    return Rotation._of(vectors.from_rotvec(rotvec))


@quiet
def _times(times: ArrayLike, rotations: Rotation) -> Array:
    xp = namespace(times, rotations._q)
    x = copied(floats(times, "times", xp))
    if rotations.single or len(rotations) < 2 or tuple(x.shape) != rotations.shape[:1]:
        raise RotationError(
            f"times of shape {tuple(x.shape)} for rotations of shape {rotations.shape}: "
            "one time for each of at least two keyframes is expected"
        )
    steps = x[1:] - x[:-1]
    if certainly(~xp.all(xp.isfinite(steps) & (steps > 0.0))):
        raise RotationError(
            "the times of the keyframes must be finite, as their differences, and strictly increasing"
        )
    if is_numpy(xp):
        x.flags.writeable = False
        x = x.view()  # whose flag cannot be set back
    return x
