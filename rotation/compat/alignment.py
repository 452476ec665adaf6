"""Wahba's problem as scipy asks it: one set of vectors, its words for what does not fit."""

from typing import Any

import numpy as np

from rotation.errors import RotationError
from rotation.wahba import checked, fitted, sensitivity

Array = Any


def aligned(
    a: Any, b: Any, weights: Any, with_sensitivity: bool
) -> tuple[Array, Array, Array | None]:
    """Return the quaternion, the root of the sum that remains, and the sensitivity if asked for."""
    u, v = (np.asarray(x, dtype=np.float64) for x in (a, b))
    for name, x in (("a", u), ("b", v)):
        if not x.ndim or x.shape[-1] != 3:
            raise RotationError(
                f"Expected input `{name}` to have shape (3,) or (N, 3), got {x.shape}"
            )
    if u.shape != v.shape:
        raise RotationError(
            f"Expected inputs `a` and `b` to have same shapes, got {u.shape} and {v.shape}"
        )
    if u.ndim > 2:
        raise RotationError(
            f"Expected inputs `a` and `b` to have shape (3,) or (N, 3), got {u.shape} and {v.shape}"
        )
    u, v = np.atleast_2d(u), np.atleast_2d(v)
    number = len(u)
    w = np.ones(number) if weights is None else np.asarray(weights, dtype=np.float64)
    if w.ndim != 1:
        raise RotationError(f"Expected `weights` to be 1 dimensional, got shape {w.shape}.")
    if number > 1 and len(w) != number:
        raise RotationError(
            "Expected `weights` to have number of values equal to number of input vectors, "
            f"got {len(w)} values and {number} vectors."
        )
    if np.any(w < 0.0):
        raise RotationError("`weights` may not contain negative values")
    certain = np.isinf(w) if number > 1 else np.array([True])
    if certain.sum() > 1:
        raise RotationError("Only one infinite weight is allowed")
    if certain.any() and with_sensitivity:
        raise RotationError(
            "Cannot return sensitivity matrix with an infinite weight or one vector pair"
        )
    if certain.any() and not (u[certain].any() and v[certain].any()):
        raise RotationError("Cannot align zero length primary vectors")
    if number == 1:
        w = np.array([np.inf])
    q, rssd = fitted(*checked(u, v, w))
    return q, rssd, sensitivity(q, u, v, w) if with_sensitivity else None
