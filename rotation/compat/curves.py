"""`Slerp` and `RotationSpline` with scipy's interface."""

from __future__ import annotations

from typing import Literal, overload

import numpy as np

from rotation.array_types import Array, ArrayLike
from rotation.compat import checks
from rotation.compat.rotations import Rotation
from rotation.curves import interpolation, spline
from rotation.errors import RotationError
from rotation.namespaces import quiet

FEW = "`rotations` must be a sequence of at least 2 rotations."


def _keyframes(rotations: Rotation, words: str) -> Rotation:
    """Return a sequence of at least two rotations; ``words`` is the error message for other values."""
    found = Rotation._of(checks.expected(checks.quaternions(rotations), rotations, words))
    if found.single or len(found) < 2:
        raise RotationError(FEW)
    if len(found.shape) > 1:
        raise RotationError("Rotations with more than 1 leading dimension are not supported.")
    return found


class Slerp:
    """The curve through keyframes with constant angular velocity between consecutive keyframes."""

    @quiet
    def __init__(self, times: ArrayLike, rotations: Rotation) -> None:
        rotations = _keyframes(rotations, "`rotations` must be a `Rotation` instance.")
        t = checks.doubles(times, "times")
        if t.ndim != 1:
            raise RotationError(
                f"Expected times to be specified in a 1 dimensional array, got {t.ndim} dimensions."
            )
        if len(t) != len(rotations):
            raise RotationError(
                "Expected number of rotations to be equal to number of timestamps given, "
                f"got {len(rotations)} rotations and {len(t)} timestamps."
            )
        if not np.all(np.diff(t) > 0.0):
            raise RotationError("Times must be in strictly increasing order.")
        self.times, self._curve = t, interpolation.Slerp(t, rotations._ours)

    def __call__(self, times: ArrayLike) -> Rotation:
        """Return the rotations at ``times``."""
        t = checks.doubles(times, "times")
        if t.ndim > 1:
            raise RotationError("`times` must be at most 1-dimensional.")
        if not np.all((t >= self.times[0]) & (t <= self.times[-1])):
            raise RotationError(
                f"Interpolation times must be within the range [{self.times[0]}, {self.times[-1]}], "
                "both inclusive."
            )
        return Rotation._of(self._curve(t)._q)


class RotationSpline:
    """The curve through keyframes with two continuous derivatives."""

    def __init__(self, times: ArrayLike, rotations: Rotation) -> None:
        rotations = _keyframes(rotations, FEW)
        self.times = checks.doubles(times, "times")
        self.rotations = rotations
        self._curve = spline.RotationSpline(self.times, rotations._ours)

    @overload
    def __call__(self, times: ArrayLike, order: Literal[0] = 0) -> Rotation: ...
    @overload
    def __call__(self, times: ArrayLike, order: Literal[1, 2]) -> Array: ...
    @overload
    def __call__(self, times: ArrayLike, order: int) -> Rotation | Array: ...
    @quiet
    def __call__(self, times: ArrayLike, order: int = 0) -> Rotation | Array:
        """Return rotations, angular velocities or accelerations at ``times``; outside, the end pieces are
        extended.
        """
        if order not in (0, 1, 2):
            raise RotationError("`order` must be 0, 1 or 2.")
        t = checks.doubles(times, "times")
        if t.ndim > 1:
            raise RotationError("`times` must be at most 1-dimensional.")
        found = self._curve.extended(t, order)
        return found if isinstance(found, np.ndarray) else Rotation._of(found._q)
