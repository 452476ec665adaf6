"""Cumulative cubic B-splines of rotations or motions, with velocity and acceleration.

C. Sommer, V. Usenko, D. Schubert, N. Demmel and D. Cremers, "Efficient derivative computation for cumulative
B-splines on Lie groups", CVPR 2020; after M.-J. Kim, M.-S. Kim and S. Y. Shin, SIGGRAPH 1995.
"""

from __future__ import annotations

from typing import Generic, Literal, TypeVar, overload

from rotation import hints, pytrees
from rotation.array_types import Array, ArrayLike
from rotation.curves.interpolation import picked, taken
from rotation.errors import DTypeError, RotationError
from rotation.jacobians import ad
from rotation.namespaces import certainly, floats, namespace, quiet
from rotation.rigid import RigidTransform
from rotation.rotation import Rotation

M = TypeVar("M", Rotation, RigidTransform)

# Weights of the three steps, by the fraction u of an interval: 1, u, u², u³, times 6.
_WEIGHTS = ((5.0, 3.0, -3.0, 1.0), (1.0, 3.0, 3.0, -2.0), (0.0, 0.0, 0.0, 1.0))


@pytrees.register_pytree("control", "start", "step", "_steps")
class BSpline(Generic[M]):
    """The cubic curve near control rotations or rigid motions at equidistant times, twice differentiable.

    The curve follows its control points without passing through them, and lies near any four consecutive
    ones. It is independent of the world's axes: moving all control points moves the curve. A control point
    affects only four intervals.

    Parameters
    ----------
    control : Rotation or RigidTransform, shape (n,)
        At least four, each less than half a turn from the next.
    start, step : float
        The curve is defined from ``start`` to ``start + (n − 3)·step``; control point k has its largest
        weight at the time ``start + (k − 1)·step``.

    Raises
    ------
    RotationError
        Fewer than four control points, or a step that is not positive and finite.
    DTypeError
        The control points are neither a Rotation nor a RigidTransform.

    Examples
    --------
    >>> from rotation import RigidTransform
    >>> steady = BSpline(RigidTransform.from_translation([[n, 0, 0] for n in range(6)]), step=0.5)
    >>> steady(1.25).translation, steady(1.25, order=1)[3:], steady.end
    (array([3.5, 0. , 0. ]), array([2., 0., 0.]), 1.5)
    """

    def __init__(self, control: M, start: float = 0.0, step: float = 1.0) -> None:
        if not isinstance(control, Rotation | RigidTransform):
            raise DTypeError(hints.refusal(control, "control", "Rotation"))
        if control.ndim != 1 or len(control) < 4:
            raise RotationError(
                f"control points of shape {control.shape}: a list of at least four is expected"
            )
        if not 0.0 < step < float("inf"):
            raise RotationError(f"step {step!r}: a positive, finite time is expected")
        self.control: M = control
        self.start, self.step = start, step
        self._steps = control[1:].minus(control[:-1])

    @property
    def end(self) -> float:
        """The last time at which the curve is defined."""
        return self.start + (len(self.control) - 3) * self.step

    @overload
    def __call__(self, times: ArrayLike, order: Literal[0] = 0) -> M: ...
    @overload
    def __call__(self, times: ArrayLike, order: Literal[1, 2]) -> Array: ...
    @overload
    def __call__(self, times: ArrayLike, order: int) -> M | Array: ...
    @quiet
    def __call__(self, times: ArrayLike, order: int = 0) -> M | Array:
        """Return the motions at times (…), or with order 1 or 2 velocities or accelerations in body axes.

        For rotations, velocities (…, 3) are angular velocities. For rigid motions, velocities (…, 6) are
        twists in body axes: the angular velocity, then the velocity of the body's origin. Accelerations are
        their derivatives.

        Raises
        ------
        RotationError
            A time outside, or another order.
        """
        if order not in (0, 1, 2):
            raise RotationError(f"order {order!r}: 0, 1 or 2 is expected")
        xp = namespace(self._steps, times)
        x = floats(times, "times", xp)
        if certainly(xp.any((x < self.start) | (x > self.end))):
            raise RotationError(f"times outside the curve, from {self.start:g} to {self.end:g}")
        place = (x - self.start) / self.step
        last = len(self.control) - 4
        whole = xp.clip(
            xp.floor(xp.where(xp.isnan(place), xp.zeros_like(place), place)), 0.0, float(last)
        )
        n, u = xp.astype(whole, xp.int64), (place - whole)[..., None]
        motion = _picked(self.control, n)
        velocity = bend = 0.0 * taken(self._steps, n)
        for k, (a, b, c, d) in enumerate(_WEIGHTS):
            way = taken(self._steps, n + k)
            turn = self.control.exp((a + u * (b + u * (c + u * d))) / 6.0 * way)
            motion = motion * turn
            if order:
                onto = turn.inverse().adjoint()
                rate = (b + u * (2.0 * c + u * (3.0 * d))) / 6.0 / self.step * way
                velocity = _times(onto, velocity) + rate
                bend = _times(onto, bend) + _times(ad(velocity), rate)
                bend = bend + (2.0 * c + u * (6.0 * d)) / 6.0 / self.step / self.step * way
        return (motion, velocity, bend)[order]


def _picked(control: M, n: Array) -> M:
    if isinstance(control, Rotation):
        return picked(control, n)
    return RigidTransform._of(taken(control._q, n), taken(control._t, n))


def _times(matrix: Array, v: Array) -> Array:
    return namespace(v).matmul(matrix, v[..., None])[..., 0]
