"""A curve through keyframes whose angular velocity and acceleration are continuous.

Between two keyframes the rotation vector from the first of them is a cubic of time. The rates at keyframes
are those for which the acceleration has no jump; at the ends they are the mean rates of the intervals there.
These equations are nearly linear, and are solved by repeated solution of their linear part. The curve is the
one of scipy's `RotationSpline`.
"""

import math
from math import factorial
from typing import Any

from rotation.batch import expect_rotations
from rotation.coordinates import join, polynomial, split
from rotation.errors import RotationError
from rotation.interpolation import Slerp, picked, place, taken
from rotation.jacobians import inverse_left_jacobian, left_jacobian
from rotation.namespaces import Array, floats, namespace
from rotation.rotation import Rotation
from rotation.vectors import cross

_STEPS = 1000  # some tens are enough unless keyframes are almost half a turn from each other


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
        self._h = (self.times[1:] - self.times[:-1])[:, None]
        # In the axes of the body: R(t) = R[k]·exp(θ(t)), the rate of which is ω = J(−θ)·θ̇.
        self._steps = (self.rotations[:-1].inv() * self.rotations[1:]).as_rotvec()
        self._rates = self._solved()

    def __call__(self, times: Any, order: int = 0) -> Any:
        """Return rotations (order 0), rates (1) or accelerations (2), (…, 3), in the axes of the body.

        Raises
        ------
        RotationError
            A time outside, or another order.
        """
        self._keys._place(times)
        return self.extended(times, order)

    def extended(self, times: Any, order: int = 0) -> Any:
        """Return the same; before the first and after the last keyframe their cubics go on."""
        if order not in (0, 1, 2):
            raise RotationError(f"order {order!r}: 0, 1 or 2 is expected")
        n, s = place(floats(times, "times", namespace(times, self.times)), self.times)
        theta, rate, bend = self._cubic(n, s[..., None])
        if order == 0:
            return picked(self.rotations, n) * Rotation.from_rotvec(theta)
        if order == 1:
            return _turned(theta, rate)
        return _accelerated(theta, rate, bend)

    def _cubic(self, n: Any, s: Array, rates: Array | None = None) -> tuple[Array, Array, Array]:
        """The rotation vector in interval n at the fraction s of it, and its two derivatives by time."""
        w = self._rates if rates is None else rates
        d, h = taken(self._steps, n), taken(self._h, n)
        start = taken(w, n)
        end = _applied(inverse_left_jacobian(-d), taken(w, n + 1))
        a, b = 3.0 * d / h - 2.0 * start - end, start + end - 2.0 * d / h
        theta = h * s * (start + s * (a + s * b))
        return theta, start + s * (2.0 * a + 3.0 * s * b), (2.0 * a + 6.0 * s * b) / h

    def _jumps(self, rates: Array) -> Array:
        """The jumps of the acceleration at the keyframes between the ends."""
        n = namespace(rates).arange(rates.shape[0] - 1)
        one = namespace(rates).ones_like(self._h)
        first = self._cubic(n, 0.0 * one, rates)[2]
        last = _accelerated(*self._cubic(n, one, rates))
        return first[1:, ...] - last[:-1, ...]

    def _solved(self) -> Array:
        means = self._steps / self._h
        xp = namespace(means)
        first, inner, last = means[:1, ...], means[1:, ...] + means[:-1, ...], means[-1:, ...]
        rates = xp.concat([first, 0.5 * inner, last], axis=0)
        if rates.shape[0] == 2:
            return rates
        size = float(xp.max(xp.abs(means)))
        eps = float(xp.finfo(means.dtype).eps)
        before = math.inf
        for _ in range(_STEPS):
            change = _tridiagonal(1.0 / self._h[:, 0], self._jumps(rates))
            rates = xp.concat([first, rates[1:-1, ...] + change, last], axis=0)
            now = float(xp.max(xp.abs(change)))
            if now <= 45.0 * eps * size or (
                now <= math.sqrt(eps) / 16.0 * size and now >= 0.5 * before
            ):
                return rates
            before = now
        if not math.isfinite(size):
            return rates * math.nan
        raise RotationError(
            "no smooth curve was found: the keyframes are too far from each other; give some between them"
        )


def _tridiagonal(inverse: Array, right: Array) -> Array:
    """Solve the equations of an ordinary cubic spline for its slopes; ``inverse`` are those of the steps.

    ``2·i[k]·x[k−1] + 4·(i[k] + i[k+1])·x[k] + 2·i[k+1]·x[k+1] = right[k]``, by elimination.
    """
    n = right.shape[0]
    x = [right[k, ...] for k in range(n)]
    diagonal = [4.0 * (inverse[k] + inverse[k + 1]) for k in range(n)]
    beside = [2.0 * inverse[k] for k in range(1, n)]
    for k in range(1, n):
        factor = beside[k - 1] / diagonal[k - 1]
        diagonal[k] = diagonal[k] - factor * beside[k - 1]
        x[k] = x[k] - factor * x[k - 1]
    for k in range(n - 1, -1, -1):
        if k + 1 < n:
            x[k] = x[k] - beside[k] * x[k + 1]
        x[k] = x[k] / diagonal[k]
    return namespace(right).stack(x)


def _applied(matrices: Array, vectors: Array) -> Array:
    return namespace(vectors).sum(matrices * vectors[..., None, :], axis=-1)


def _turned(theta: Array, rate: Array) -> Array:
    return _applied(left_jacobian(-theta), rate)


def _accelerated(theta: Array, rate: Array, bend: Array) -> Array:
    """The derivative of ``J(−θ)·θ̇``: ``J(−θ)·θ̈`` and the part that the change of J makes."""
    return _turned(theta, bend) + _change(theta, rate)


def _change(theta: Array, rate: Array) -> Array:
    """The derivative of ``J(−θ)·θ̇`` along θ̇, θ̇ fixed, by its series or in closed form."""
    xp = namespace(theta, rate)
    t = xp.sum(theta * theta, axis=-1, keepdims=True)
    wide = t > 0.25
    far = xp.where(wide, t, xp.ones_like(t))
    size = xp.sqrt(far)
    small = xp.where(wide, xp.zeros_like(t), t)
    sine, cosine = xp.sin(size), xp.cos(size)
    # B, and the derivatives of A and B by θ² doubled.
    b = xp.where(wide, (size - sine) / (far * size), polynomial(_B, small))
    da = xp.where(wide, (size * sine - 2.0 * (1.0 - cosine)) / far**2, polynomial(_DA, small))
    db = xp.where(
        wide, (3.0 * sine - size * cosine - 2.0 * size) / (far**2 * size), polynomial(_DB, small)
    )
    along = xp.sum(theta * rate, axis=-1, keepdims=True)

    def times(p: Array, q: Array) -> Array:
        return join(xp, cross(split(p), split(q)))

    across = times(theta, rate)
    return -da * along * across + db * along * times(theta, across) + b * times(rate, across)


def _series(first: int, derived: bool) -> list[float]:
    """Coefficients of A (first = 2) or B (3) by θ², or of twice their derivatives."""
    values = [(-1.0) ** k / factorial(2 * k + first) for k in range(12)]
    return [2.0 * (k + 1) * v for k, v in enumerate(values[1:])] if derived else values


_B, _DA, _DB = _series(3, False), _series(2, True), _series(3, True)
