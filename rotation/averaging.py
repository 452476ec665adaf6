"""The mean of rotations: the eigenvector of the sum of ``w·q·qᵀ``, which does not depend on signs of the q.

F. L. Markley, Y. Cheng, J. L. Crassidis and Y. Oshman, "Averaging quaternions", J. Guidance, Control
and Dynamics 30 (2007).
"""

from __future__ import annotations

import math
import operator

import numpy as np

from rotation.array_types import Array, ArrayLike, Axes
from rotation.coordinates import factor, join, unit
from rotation.errors import RotationError
from rotation.geodesic_median import geodesic_median
from rotation.namespaces import (
    expect_numpy,
    floats,
    is_numpy,
    namespace,
    quiet,
    refuse_rows,
    spread,
)
from rotation.optimum import with_derivatives, without_derivatives
from rotation.quaternions import canonical, normalised, upright
from rotation.rowwise import RowFormula

_TIE = 16.0  # two eigenvalues within so many units of rounding are one
_EPS = float(np.finfo(np.float64).eps)


def mean(q: Array, weights: ArrayLike | None = None, axis: Axes | None = None) -> Array:
    """Return the mean of unit quaternions (…, 4) over batch axes, canonical in sign.

    Raises
    ------
    RotationError
        No rotations, an axis that does not exist, negative weights or weights that are all zero; or
        the largest eigenvalue is double, so that no mean is better than another.
    """
    if axis is None and type(q) is np.ndarray and q.size:
        best = None
        if weights is None:
            best = _of_all(q.reshape(-1, 4), None)
        elif is_numpy(xp := namespace(q, weights)):
            w = floats(weights, "weights", xp)
            if w.shape == q.shape[:-1]:
                best = _of_all(q.reshape(-1, 4), w.reshape(-1))
        if best is not None:
            return best
    return _weighted(q, weights, axis)


@quiet
def _of_all(q: Array, w: Array | None) -> Array | None:
    """Return the mean of quaternions (n, 4), or None if there is none or the input needs the
    general method.
    """
    total = float(len(q))
    if w is None:
        moment = q.T @ q
    else:
        total = float(w.sum())
        if not (w.min() >= 0.0 and 1e-100 < total < 1e100):
            return None
        moment = (q.T * w) @ q
    if not math.isfinite(sum(moment.ravel().tolist())):
        return None
    values, vectors = np.linalg.eigh(moment)
    *_, second, first = values.tolist()
    if first - second <= _TIE * _EPS * total:
        return None
    return _LAST_COLUMN(vectors)


def _last_column(vectors: Array) -> Array:
    """Return the last column as a unit quaternion whose first nonzero coordinate is positive."""
    xp = namespace(vectors)
    return join(xp, upright(xp, unit(xp, tuple(vectors[..., n, 3] for n in range(4)))))


_LAST_COLUMN = RowFormula(_last_column, (4, 4))


@quiet
def _weighted(q: Array, weights: ArrayLike | None, axis: Axes | None) -> Array:
    q, w = _grouped(q, weights, axis)
    xp = namespace(q)
    moment = _moment(q, w)
    finite = xp.all(xp.isfinite(moment), axis=(-2, -1))
    identity = xp.eye(4, dtype=moment.dtype)
    values, vectors = xp.linalg.eigh(
        xp.where(finite[..., None, None], without_derivatives(moment), identity)
    )
    gap = values[..., 3] - values[..., 2]
    refuse_rows(
        finite & (gap <= _TIE * float(xp.finfo(q.dtype).eps)),
        "the mean",
        "is not determined: the rotations spread evenly about several",
    )
    best = xp.where(finite[..., None], vectors[..., 3], xp.nan * vectors[..., 3])
    rows = tuple(tuple(moment[..., r, c] for c in range(4)) for r in range(4))
    return with_derivatives(canonical(normalised(best)), rows)


def _grouped(q: Array, weights: ArrayLike | None, axis: Axes | None) -> tuple[Array, Array]:
    """Return quaternions (…, count, 4) and weights (…, count), with the axes to average over combined.

    The largest weight in each group is scaled to 1.
    """
    xp = namespace(q, weights)
    batch = tuple(q.shape[:-1])
    axes = _axes(axis, len(batch))
    w = xp.ones_like(q[..., 0]) if weights is None else floats(weights, "weights", xp)
    w = spread(xp, w, batch, "weights")
    refuse_rows(w < 0.0, "the weight", "is negative")
    kept = [n for n in range(len(batch)) if n not in axes]
    shape = tuple(batch[n] for n in kept)
    count = math.prod(batch[n] for n in axes)
    if not count:
        raise RotationError("no rotations to average")
    q = xp.reshape(xp.permute_dims(q, (*kept, *axes, len(batch))), (*shape, count, 4))
    w = xp.reshape(xp.permute_dims(w, (*kept, *axes)), (*shape, count))
    heaviest = xp.max(w, axis=-1, keepdims=True)
    refuse_rows(heaviest[..., 0] == 0.0, "the sum of the weights", "is zero")
    return q, w / heaviest  # their sum does not overflow


def _moment(q: Array, w: Array) -> Array:
    """Return the weighted means (…, 4, 4) of ``q·qᵀ`` over groups (…, count, 4)."""
    xp = namespace(q)
    weighted = q * (w / xp.sum(w, axis=-1)[..., None])[..., None]
    return xp.matmul(xp.matrix_transpose(weighted), q)


@quiet
def median(q: Array, weights: ArrayLike | None = None, axis: Axes | None = None) -> Array:
    """Return the geodesic median of unit quaternions (…, 4) over batch axes; see `Rotation.median`."""
    expect_numpy("median", q, weights)
    q, w = _grouped(q, weights, axis)
    shape = (*q.shape[:-2], 4)
    moments = _moment(q, w).reshape(-1, 4, 4)
    groups = zip(q.reshape(-1, *q.shape[-2:]), w.reshape(-1, w.shape[-1]), moments, strict=True)
    return np.reshape([_median(*group) for group in groups], shape)


def _median(q: Array, w: Array, moment: Array) -> Array:
    """Return the median of quaternions (n, 4); the descent begins at their mean, or at one of
    several means.
    """
    if not np.isfinite(moment).all():
        return np.full(4, np.nan)
    _, vectors = np.linalg.eigh(moment)
    counted = w > 0.0
    start = normalised(np.ascontiguousarray(vectors[:, 3]))
    return geodesic_median(q[counted], w[counted], start)


@quiet
def mean_of_vectors(v: Array, weights: Array, axes: tuple[int, ...]) -> Array:
    """Return the weighted mean of vectors (…, 3) over some of their axes, without intermediate overflow.

    The weights, of shape (…), must be nonnegative and not all zero.
    """
    xp = namespace(v, weights)
    w = weights[..., None]
    heaviest = xp.max(w, axis=axes, keepdims=True)
    usual = (heaviest > 2.0**-30) & (heaviest < 2.0**30)
    w = w / xp.where(usual, xp.ones_like(heaviest), heaviest)
    f = factor(xp, (xp.max(xp.abs(v), axis=axes, keepdims=True),))
    total, share = (xp.sum(x, axis=axes, keepdims=True) for x in (w * (f * v), w))
    return xp.squeeze(total / share / f, axis=axes)


def _axes(axis: Axes | None, ndim: int) -> tuple[int, ...]:
    """Return the distinct axes, nonnegative and ascending."""
    if axis is None:
        return tuple(range(ndim))
    given = axis if isinstance(axis, tuple | list) else (axis,)
    try:
        axes = tuple(a + ndim if a < 0 else a for a in map(operator.index, given))
    except TypeError:
        axes = (-1,)
    if len(set(axes)) < len(axes) or not all(0 <= a < ndim for a in axes):
        raise RotationError(
            f"axis {axis!r}: axes of a batch with {ndim} axes are expected, each once"
        )
    return tuple(sorted(axes))
