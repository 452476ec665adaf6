"""Return scipy's results where this package raises errors or gives different results.

This concerns matrices that are not rotations, means and best fits that are not unique, and the order of the
elements of groups.
"""

from __future__ import annotations

import contextlib
import warnings

import numpy as np

from rotation import groups
from rotation.array_types import Array, ArrayLike
from rotation.averaging import mean
from rotation.compat import checks
from rotation.errors import RotationError
from rotation.matrices import from_matrix as to_quaternion
from rotation.namespaces import quiet
from rotation.optimum import davenport
from rotation.quaternions import canonical
from rotation.wahba import checked, fitted, remaining, sensitivity

_POORLY = "Optimal rotation is not uniquely or poorly defined for the given sets of vectors."
_TURNS = np.zeros((3, 3, 3))  # the sign of a permutation of the axes
for _k in range(3):
    _TURNS[_k, _k - 2, _k - 1], _TURNS[_k, _k - 1, _k - 2] = 1.0, -1.0
_BLOCK = 2**20  # products that are in memory at once


@quiet
def unchecked(m: Array) -> Array:
    """Return the quaternions of matrices without checking them, by the largest row of ``4·q·qᵀ``."""
    rows = davenport([[m[..., r, c] for c in range(3)] for r in range(3)])
    products = np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)
    products[..., range(4), range(4)] += 1.0
    largest = np.argmax(np.einsum("...kk->...k", products), axis=-1)[..., None, None]
    q = np.take_along_axis(products, largest, axis=-2)[..., 0, :]
    unit: Array = q / np.linalg.norm(q, axis=-1, keepdims=True)
    return unit


def averaged(q: Array, weights: Array | None, axes: tuple[int, ...]) -> Array:
    """Return the mean of quaternions; if several are equally good, the one that scipy returns."""
    try:
        return mean(q, weights, axes)
    except RotationError:
        w = np.ones(q.shape[:-1]) if weights is None else np.broadcast_to(weights, q.shape[:-1])
        p = np.roll(q, -1, axis=-1)
        moments = np.sum(w[..., None, None] * p[..., :, None] * p[..., None, :], axis=axes)
        return canonical(np.roll(np.linalg.eigh(moments)[1][..., -1], 1, axis=-1))


def group_elements(group: str, axis: str) -> Array:
    """Return the quaternions of a group in scipy's order, where three half turns come before the identity."""
    q = groups.elements(group, axis)
    return q[[1, 2, 3, 0, *range(4, len(q))]] if group in groups.POLYHEDRAL else q


def nearest(p: Array, left: Array, right: Array) -> tuple[Array, Array]:
    """Return the indices into (m, 4) and (n, 4) for which the angle of ``l·p·r`` is least, in the shape of p.

    With two groups, many angles are equally small, and rounding decides. So this function computes every
    scalar part with the same sums in the same order as scipy.
    """
    flat = p.reshape(-1, 4)
    step = max(1, _BLOCK // (len(left) * len(right)))
    best = np.empty(len(flat), np.int64)
    for start in range(0, len(flat), step):
        piece = slice(start, start + step)
        scalars = np.abs(_scalars(flat[piece], left, right)).swapaxes(0, 1)
        best[piece] = np.argmax(scalars.reshape(scalars.shape[0], -1), axis=1)
    m, n = np.divmod(best, len(right))
    return m.reshape(p.shape[:-1]), n.reshape(p.shape[:-1])


def _scalars(p: Array, left: Array, right: Array) -> Array:
    """Return the scalar parts of ``l·p·r`` from the scalar and vector parts of the three."""
    a, b, c = left[:, 0], p[:, 0], right[:, 0]
    u, v, w = left[:, 1:], p[:, 1:], right[:, 1:]
    found: Array = (
        np.einsum("i,j,k", a, b, c)
        - np.einsum("i,jx,kx", a, v, w)
        - np.einsum("ix,j,kx", u, b, w)
        - np.einsum("ix,jx,k", u, v, c)
        - np.einsum("xyz,ix,jy,kz", _TURNS, u, v, w)
    )
    return found


def aligned(
    a: ArrayLike, b: ArrayLike, weights: ArrayLike | None, with_sensitivity: bool
) -> tuple[Array, Array, Array | None]:
    """Solve Wahba's problem for one set of vectors, with scipy's error messages.

    Return the quaternion, the square root of the remaining sum, and the sensitivity if requested.
    """
    u, v = (checks.doubles(x, "vectors") for x in (a, b))
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
    w = np.ones(number) if weights is None else checks.doubles(weights, "weights")
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
    """Return the best rotation; if several are equally good, the one that scipy returns, with a warning."""
    if len(w) == 1 or not all(np.isfinite(x).all() for x in (u, v, w)):
        return fitted(*checked(u, v, w))
    # Scaling by powers of two to near 1 prevents overflow; scipy's threshold keeps its meaning.
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
