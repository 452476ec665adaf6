"""Wahba's problem on arrays: the quaternion that brings one set of vectors closest to another.

G. Wahba, "A least squares estimate of satellite attitude", SIAM Review 7 (1965); solved by the
singular value decomposition: W. Kabsch, Acta Cryst. A 32 (1976), F. L. Markley (1988).
"""

from __future__ import annotations

import math

import numpy as np

from rotation.action import turned_by
from rotation.array_types import NUMPY, Array, ArrayLike, Namespace
from rotation.coordinates import join, length, split
from rotation.errors import RotationError
from rotation.matrices import NEAREST_TO_SVD, PROPER, from_matrix, largest, scaled, to_matrix
from rotation.namespaces import (
    certainly,
    expect_last,
    floats,
    is_numpy,
    namespace,
    quiet,
    refuse_rows,
    spread,
)
from rotation.optimum import davenport, is_differentiable, with_derivatives, without_derivatives
from rotation.quaternions import product
from rotation.rowwise import RowFormula
from rotation.vectors import between, from_axis_angle


def checked(a: ArrayLike, b: ArrayLike, weights: ArrayLike | None) -> tuple[Array, Array, Array]:
    """Return two sets of vectors (…, N, 3) and their weights (…, N) as arrays of compatible shapes.

    Vectors of weight 0 are set to 0, whatever they were, except for libraries that differentiate by weights.
    """
    v, w = checked_vectors(a, b, weights)
    xp = namespace(v)
    share = _weights(xp, weights, v)
    if weights is not None and not is_differentiable(v) and bool(xp.any(share == 0.0)):
        counts = (share != 0.0)[..., None]
        v, w = (xp.where(counts, x, xp.zeros_like(x)) for x in (v, w))
    return v, w, share


def checked_vectors(a: ArrayLike, b: ArrayLike, weights: ArrayLike | None) -> tuple[Array, Array]:
    """Return two sets of vectors (…, N, 3) as compatible arrays, in the common library of all three
    arguments.
    """
    xp = namespace(a, b, weights)
    v: Array = floats(a, "vectors", xp)
    w: Array = floats(b, "vectors", xp)
    if is_numpy(xp):  # the order of sums must not depend on the memory layout
        v, w = np.ascontiguousarray(v), np.ascontiguousarray(w)
    for vectors in (v, w):
        expect_last(vectors, (3,), "vectors")
    if v.ndim == w.ndim == 1:
        v, w = v[None, :], w[None, :]
    if v.shape != w.shape or not v.shape[-2]:
        raise RotationError(
            f"vectors of shapes {tuple(v.shape)} and {tuple(w.shape)}: expected equally many of both, and at "
            "least one pair"
        )
    return v, w


def certain(a: Array, b: Array, w: Array) -> tuple[Array, Array] | None:
    """Return the solution if one pair has infinite weight: it is aligned exactly, the others as well as
    possible.

    Return None if all weights are finite. A first rotation aligns this pair. A second rotation about its
    direction u has the angle ``atan2(Σ w·a·(u × b'), Σ w·a·b' − (a·u)(b'·u))``, where b' are the vectors b
    after the first rotation.

    Raises
    ------
    RotationError
        Arrays that are not numpy's or more than one set of vectors; two infinite weights, or one at a
        vector that is zero.
    """
    if not is_numpy(namespace(w)) or not np.isinf(w).any():
        if not is_numpy(namespace(w)) and certainly(namespace(w).any(namespace(w).isinf(w))):
            raise RotationError("infinite weights are supported for numpy arrays only")
        return None
    if w.ndim > 1 or np.isinf(w).sum() > 1:
        raise RotationError(
            "only one infinite weight is allowed: a second pair cannot be exact as well"
        )
    if np.isnan(w).any() or not (np.isfinite(a).all() and np.isfinite(b).all()):
        return np.full(4, np.nan), np.full((), np.nan)[()]
    n = int(np.argmax(np.isinf(w)))
    if not (a[n].any() and b[n].any()):
        raise RotationError(f"vector {n} has infinite weight and is zero: it has no direction")
    first = between(b[n], a[n])
    rest = np.arange(len(w)) != n
    weights = w[rest]
    heaviest = weights.max(initial=0.0)
    q = first
    if heaviest > 0.0:
        others, turned = scaled(NUMPY, a[rest]), scaled(NUMPY, b[rest]) @ to_matrix(first).T
        axis = a[n] / float(length(NUMPY, split(a[n])))
        share = weights / heaviest
        sine = np.sum(share * (others * np.cross(axis, turned)).sum(axis=-1))
        cosine = np.sum(
            share * ((others * turned).sum(axis=-1) - (others @ axis) * (turned @ axis))
        )
        q = product(from_axis_angle(axis, np.arctan2(sine, cosine)), first)
    return q, remaining(q, a, b, np.where(rest, w, 0.0))


@quiet
def sensitivity(q: Array, a: Array, b: Array, w: Array) -> Array:
    """Return the sensitivity of a fit, shape (…, 3, 3).

    It is ``mean(w)·(tr(P)·1 − P)⁻¹`` with ``P = Σ w·a·(R·b)ᵀ``. Multiplied by the variance of the vectors'
    errors (relative to their weights), it is the covariance of the error of R, a rotation vector in the axes
    of a.

    Raises
    ------
    RotationError
        A weight is infinite, or the vectors of a set are of one line, such as a single pair.
    """
    xp = namespace(a)
    if a.shape[-2] < 2 or bool(xp.any(xp.isinf(w))):
        raise RotationError(
            "sensitivity is defined for a fit of several vectors with finite weights, and this fit is not one"
        )
    w = w[..., None]
    sizes = [largest(xp, x) for x in (a, b, w)]
    a, b, w = (x / size for x, size in zip((a, b, w), sizes, strict=True))
    turned = xp.matmul(b, xp.matrix_transpose(to_matrix(q)))
    p = xp.matmul(xp.matrix_transpose(a * w), turned)
    trace = p[..., 0, 0] + p[..., 1, 1] + p[..., 2, 2]
    information = trace[..., None, None] * xp.eye(3, dtype=p.dtype) - p
    values = xp.linalg.svdvals(information)
    refuse_rows(
        values[..., 2] <= 16.0 * float(xp.finfo(p.dtype).eps) * values[..., 0],
        "the set of vectors",
        "leaves the angle about one line free, so its sensitivity is infinite",
    )
    return xp.mean(w, axis=-2)[..., None] * xp.linalg.inv(information) / sizes[0] / sizes[1]


@quiet
def fitted(a: Array, b: Array, w: Array | None) -> tuple[Array, Array]:
    """Return the quaternions (…, 4) that bring b closest to a, and the square roots of the remaining sums.

    Without ``w`` all weights are 1.
    """
    found = _fitted_to_one(a, b, w)
    if found is None and w is not None:
        found = certain(a, b, w)
    if found is not None:
        return found
    q = _best(namespace(a), a, b, w)
    return q, remaining(q, a, b, w)


def _fitted_to_one(a: Array, b: Array, w: Array | None) -> tuple[Array, Array] | None:
    """Return the fit of one set in a few calls; None for several sets and for unusual numbers."""
    if a.ndim != 2 or type(a) is not np.ndarray or type(b) is not np.ndarray:
        return None
    m = (a.T if w is None else a.T * w) @ b
    if not math.isfinite(sum(m.ravel().tolist())):
        return None
    q, is_unusual = NEAREST_TO_SVD.with_flag(*np.linalg.svd(m))
    if is_unusual:
        return None
    rests = _RESTS(a, b, q)
    return q, _root_of_squares(NUMPY, rests if w is None else np.sqrt(w) * rests)


@quiet
def remaining(q: Array, a: Array, b: Array, w: Array | None) -> Array:
    """Return ``√(Σ w‖a − R·b‖²)``, without overflow of squares."""
    xp = namespace(a)
    turned = xp.matmul(b, xp.matrix_transpose(to_matrix(q)))
    rests = _LENGTH(a - turned)
    if w is not None:
        rests = xp.sqrt(w) * rests
    return _root_of_squares(xp, rests)


def _root_of_squares(xp: Namespace, rests: Array) -> Array:
    """Return the square roots of sums of nonnegative numbers (…, N)."""
    if is_numpy(xp) and rests.ndim == 1 and 1e-200 < (square := rests @ rests) < 1e200:
        root: Array = np.sqrt(square)
        return root
    longest = xp.max(rests, axis=-1, keepdims=True)
    longest = xp.where(longest > 0.0, longest, xp.ones_like(longest))
    return xp.sqrt(xp.sum((rests / longest) ** 2, axis=-1)) * longest[..., 0]


_LENGTH = RowFormula(lambda v: length(namespace(v), split(v)), (3,))
_RESTS = RowFormula(
    lambda a, b, q: length(
        namespace(a),
        tuple(x - y for x, y in zip(split(a), turned_by(split(q), split(b), False), strict=True)),
    ),
    *((3,), (3,), (4,)),
    single=(2,),
)
_TIMES = RowFormula(lambda v, w: join(namespace(v), tuple(w[...] * c for c in split(v))), (3,), ())


def _weights(xp: Namespace, weights: ArrayLike | None, vectors: Array) -> Array:
    if weights is None:
        return xp.ones_like(vectors[..., 0])
    w = floats(weights, "weights", xp)
    w = spread(xp, w, tuple(vectors.shape[:-1]), "weights")
    refuse_rows(w < 0.0, "the weight", "is negative")
    return w


def _best(xp: Namespace, a: Array, b: Array, w: Array | None) -> Array:
    # Only directions and relative lengths matter; after scaling, no square overflows.
    a, b = a / largest(xp, a), b / largest(xp, b)
    if w is not None:
        heaviest = xp.max(w, axis=-1, keepdims=True)
        refuse_rows(heaviest[..., 0] == 0.0, "the weights", "are all zero")
        a = _TIMES(a, w / heaviest)
    m = xp.matmul(xp.matrix_transpose(a), b)
    finite = xp.all(xp.isfinite(m), axis=(-2, -1))
    m = xp.where(finite[..., None, None], m, xp.eye(3, dtype=m.dtype))
    u, s, vt = xp.linalg.svd(without_derivatives(m))
    refuse_rows(
        s[..., 0] == 0.0,
        "the vectors",
        "are zero wherever they have weight: no rotation is determined",
    )
    proper = PROPER(u, s, vt)
    u, s = proper[..., :3, :], proper[..., 3, :]
    tiny = 16.0 * float(xp.finfo(m.dtype).eps) * s[..., 0]
    line = s[..., 1] <= tiny
    refuse_rows(
        ~line & (s[..., 1] + s[..., 2] <= tiny),
        "the vectors",
        "determine no rotation: a reflection would align them, and several rotations do it equally well",
    )
    best = from_matrix(xp.matmul(u, vt))
    if is_differentiable(m):
        nothing = xp.eye(3, dtype=m.dtype)
        k = xp.where(line[..., None, None], nothing, m)
        first = xp.where(line[..., None], xp.eye(4, dtype=m.dtype)[0, :], best)
        best = with_derivatives(
            first, davenport([[k[..., r, c] for c in range(3)] for r in range(3)])
        )
    if is_numpy(xp) and not line.any():
        return xp.where(finite[..., None], best, xp.nan)
    shortest = between(
        xp.matmul(u[..., None, :, 0], m)[..., 0, :], xp.matmul(m, vt[..., 0, :, None])[..., 0]
    )
    q = xp.where(line[..., None], shortest, best)
    return xp.where(finite[..., None], q, xp.nan * xp.ones_like(q))
