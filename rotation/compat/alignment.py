"""Wahba's problem as scipy asks it: one set of vectors, its words for what does not fit."""

import contextlib
import warnings
from typing import Any

import numpy as np

from rotation.errors import RotationError
from rotation.matrices import from_matrix as to_quaternion
from rotation.wahba import checked, fitted, remaining, sensitivity

Array = Any
_POORLY = "Optimal rotation is not uniquely or poorly defined for the given sets of vectors."


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
    certain = np.array([True]) if number == 1 else np.isinf(w)
    if certain.sum() > 1:
        raise RotationError("Only one infinite weight is allowed")
    if certain.any() and with_sensitivity:
        raise RotationError(
            "Cannot return sensitivity matrix with an infinite weight or one vector pair"
        )
    if certain.any() and not (u[certain].any() and v[certain].any()):
        raise RotationError("Cannot align zero length primary vectors")
    q, rssd = _best(u, v, np.ones(1) if number == 1 else w)
    return q, rssd, sensitivity(q, u, v, w) if with_sensitivity else None


def _best(u: Array, v: Array, w: Array) -> tuple[Array, Array]:
    """The best rotation, or with a warning one of many that are equally good: that of scipy."""
    if len(w) == 1 or not all(np.isfinite(x).all() for x in (u, v, w)):
        return fitted(*checked(u, v, w))
    # By powers of two near 1: nothing overflows, and scipy's threshold means the same.
    p, q, share = (np.ldexp(x, -np.frexp(np.abs(x).max())[1]) for x in (u, v, w[:, None]))
    left, values, right = np.linalg.svd(np.einsum("ji,jk->ik", share * p, q))
    if np.linalg.det(left @ right) < 0.0:
        values[2], left[:, 2] = -values[2], -left[:, 2]
    if values[1] + values[2] < 1e-16 * values[0]:
        warnings.warn(_POORLY, UserWarning, stacklevel=4)
    else:
        with contextlib.suppress(RotationError):
            return fitted(*checked(u, v, w))
    best = to_quaternion(left @ right)
    return best, remaining(best, u, v, w)
