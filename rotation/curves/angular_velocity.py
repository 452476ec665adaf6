"""Rotations in time: attitudes from an angular velocity, and the angular velocity of attitudes.

The attitude satisfies ``q̇ = ½·ω·q`` with ω in world axes, or ``q̇ = ½·q·ω`` with ω in body axes (the
derivative of Theorem 6 of the thesis). Each interval is one exponential: the method has order 4, is exact for
constant ω, and preserves the norm by construction.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import reduce
from operator import add, mul

from rotation import vectors
from rotation.array_types import Array, ArrayLike
from rotation.arrays import common_batch
from rotation.batch import expect_rotations
from rotation.curves.interpolation import picked
from rotation.curves.magnus import GAUSS, by_gauss, refined
from rotation.errors import RotationError
from rotation.namespaces import certainly, expect_last, floats, is_numpy, namespace, quiet
from rotation.products import check_frame, running_products
from rotation.rotation import Rotation


def integrate(
    omega: ArrayLike | Callable[[float], ArrayLike],
    times: ArrayLike,
    initial: Rotation | None = None,
    frame: str = "body",
    tolerance: float | None = None,
) -> Rotation:
    """Return the attitudes at ``times`` of a body that rotates with angular velocity ``omega``.

    Parameters
    ----------
    omega : array_like or callable
        Radians per unit of time: a constant vector (3,); samples (n, …, 3) at ``times``, interpolated by
        cubics; or a function of one time that returns (…, 3), which is called at two inner points of each
        interval.
    times : array_like, shape (n,)
        Strictly monotonic, with finite steps; the first time belongs to ``initial``. All arguments must use
        the same array library.
    initial : Rotation, optional
        The attitude at ``times[0]``; by default the identity.
    frame : "body" or "world"
        The axes in which omega is given: those of the body, which rotate with it, or the fixed ones.

    tolerance : float, optional
        For a function omega: intervals are divided where two rules disagree, until the sum of their
        differences bounds the error by this angle, in radians, at all times. Jumps of omega are found. A
        pulse between two evaluation points is not found; include a time at which it occurs.

    Returns
    -------
    Rotation, shape (n, …)
        Rotations that map vectors in body axes to world axes. The error is of fourth order in the step; for a
        constant omega it is only rounding.

    Raises
    ------
    RotationError
        Times that are not monotonic, samples that do not fit them, or another frame; a tolerance that is not
        positive, given without a function, or not reached with 16384 steps for each interval.
    ForeignArrayError
        Arrays of two libraries.

    Examples
    --------
    >>> top = integrate([0, 0, 3.0], [0.0, 0.5, 1.0])
    >>> top.as_rotvec()[:, 2]
    array([0. , 1.5, 3. ])
    """
    check_frame(frame)
    if initial is not None:
        expect_rotations(initial=initial)
    known = None if callable(omega) else omega
    xp = namespace(known, times, None if initial is None else initial._q)
    t = floats(times, "times", xp)
    _expect_monotonic(t)
    steps = _steps(t)
    if tolerance is not None:
        if not callable(omega) or not tolerance > 0.0:
            raise RotationError(
                f"tolerance {tolerance!r}: a positive angle is expected, and omega as a function"
            )
        fine, places = refined(lambda at: _values(omega, t, at), t, frame, tolerance)
        path = integrate(omega, fine, initial, frame)._q
        return Rotation._of(xp.take(path, xp.asarray(places), axis=0))
    first, second = (_values(omega, t, t[:-1] + node * steps) for node in GAUSS)
    turns = vectors.from_rotvec(by_gauss(first, second, steps, frame))
    start = xp.asarray([1.0, 0.0, 0.0, 0.0], dtype=turns.dtype) if initial is None else initial._q
    batch = common_batch(initial=tuple(start.shape[:-1]), omega=tuple(turns.shape[1:-1]))
    missing = (1,) * (len(batch) + 2 - turns.ndim)
    turns = xp.reshape(turns, (turns.shape[0], *missing, *turns.shape[1:]))
    parts = (start[None, ...], (1, *batch, 4)), (turns, (turns.shape[0], *batch, 4))
    chain = xp.concat([xp.broadcast_to(*part) for part in parts], axis=0)
    return Rotation._of(running_products(chain, frame))


_WINDOW = 5  # samples, whose polynomial is of the fourth degree


@quiet
def angular_velocity(rotations: Rotation, times: ArrayLike, frame: str = "body") -> Array:
    """Return the angular velocities of a body with known attitudes at ``times``.

    At each time the result is the derivative of the polynomial through the rotation vectors to five
    neighbouring samples (fewer if there are fewer). It is exact for a constant velocity, and of fourth order
    in the steps otherwise.

    Parameters
    ----------
    rotations : Rotation, shape (n, …)
        At least two rotations that map body axes to world axes, as in `integrate`. The rotation from each
        sample to the four nearest must be less than π; larger turns cannot be detected.
    times : array_like, shape (n,)
        Strictly monotonic.
    frame : "body" or "world"
        The axes in which the answer is given.

    Returns
    -------
    array, shape (n, …, 3)
        Radians per unit of time.

    Raises
    ------
    RotationError
        Less than two rotations, times that are not monotonic or do not fit them, or another frame.

    Examples
    --------
    >>> top = integrate([0, 0, 3.0], [0.0, 0.1, 0.3, 0.4])
    >>> angular_velocity(top, [0.0, 0.1, 0.3, 0.4]).round(12)[:, 2]
    array([3., 3., 3., 3.])
    """
    check_frame(frame)
    expect_rotations(rotations=rotations)
    xp = namespace(times, rotations._q)
    t = floats(times, "times", xp)
    if rotations.single or len(rotations) < 2 or tuple(t.shape) != rotations.shape[:1]:
        raise RotationError(
            f"times of shape {tuple(t.shape)} for rotations of shape {rotations.shape}: "
            "one time for each of at least two rotations is expected"
        )
    _expect_monotonic(t)
    n = t.shape[0]
    here, number = xp.arange(n), min(_WINDOW, n)
    start = xp.clip(here - number // 2, 0, n - number)
    knots = [xp.take(t, start + k) for k in range(number)]
    back, one = rotations.inv(), xp.ones_like(t)
    terms = []
    for j in range(number):
        others = [k for k in range(number) if k != j]
        away = (xp.where(start + k == here, one, t - knots[k]) for k in others)
        weight = reduce(mul, (a / (knots[j] - knots[k]) for a, k in zip(away, others, strict=True)))
        turn = (back * picked(rotations, start + j)).as_rotvec()
        terms.append(xp.reshape(weight, (-1, *(1,) * (turn.ndim - 1))) * turn)
    total = reduce(add, terms)
    return total if frame == "body" else rotations.apply(total)


def _expect_monotonic(t: Array) -> None:
    """Raise `RotationError` unless the times strictly increase or strictly decrease."""
    xp = namespace(t)
    steps = _steps(t) if t.ndim == 1 and t.shape[0] else xp.asarray([math.nan])
    monotonic = xp.all(steps > 0.0) | xp.all(steps < 0.0)
    if certainly(~(monotonic & xp.all(xp.isfinite(steps)))):
        raise RotationError(
            f"times of shape {tuple(t.shape)}: a list that strictly increases or decreases, in finite steps, "
            "is expected"
        )


@quiet
def _steps(times: Array) -> Array:
    return times[1:] - times[:-1]


def _values(omega: ArrayLike | Callable[[float], ArrayLike], times: Array, at: Array) -> Array:
    """Return the angular velocities at one point of each interval, (n − 1, …, 3)."""
    xp = namespace(times)
    if callable(omega):
        found = [omega(float(x) if is_numpy(xp) else x) for x in at]
        namespace(at, *found)  # of two libraries it raises
        values = [floats(w, "omega(t)", xp) for w in found]
        if len({tuple(v.shape) for v in values}) > 1:
            raise RotationError("omega(t) has different shapes at different times")
        w = xp.stack(values) if values else xp.empty((0, 3))
        expect_last(w, (3,), "omega(t) at all times")
    else:
        samples = floats(omega, "omega", xp)
        expect_last(samples, (3,), "omega")
        number = samples.shape[0]
        if samples.ndim == 1:
            w = xp.broadcast_to(samples, (at.shape[0], 3))
        elif number == times.shape[0]:
            w = _interpolated(samples, times, at)
        else:
            raise RotationError(
                f"omega has {number} samples for {times.shape[0]} times; expected one sample for each time"
            )
    return w


@quiet
def _interpolated(samples: Array, times: Array, at: Array) -> Array:
    """Return values between samples, by the polynomial through the nearest four (fewer if there are
    fewer).
    """
    xp = namespace(samples, times)
    intervals, number = at.shape[0], min(4, times.shape[0])
    start = xp.clip(xp.arange(intervals) - 1, 0, times.shape[0] - number)
    knots = [xp.take(times, start + k) for k in range(number)]
    # Differences from the sample on the left: a constant velocity stays that, to the last bit.
    left = samples[:-1, ...]
    total = left
    for j in range(number):
        factors = ((at - knots[k]) / (knots[j] - knots[k]) for k in range(number) if k != j)
        weight = xp.reshape(
            reduce(mul, factors, xp.ones_like(at)), (-1, *(1,) * (samples.ndim - 1))
        )
        total = total + weight * (xp.take(samples, start + j, axis=0) - left)
    return total
