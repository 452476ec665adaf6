"""Wahba's problem on arrays: the quaternion that takes one set of vectors closest to another.

G. Wahba, "A least squares estimate of satellite attitude", SIAM Review 7 (1965); solved by the
singular value decomposition: W. Kabsch, Acta Cryst. A 32 (1976), F. L. Markley (1988).
"""

from typing import Any

from rotation.coordinates import length, split
from rotation.errors import RotationError
from rotation.matrices import from_matrix, to_matrix
from rotation.namespaces import Array, expect_last, floats, namespace, quiet, refuse_rows
from rotation.vectors import between


def checked(a: Any, b: Any, weights: Any) -> tuple[Array, Array, Array]:
    """Return two sets of vectors (…, N, 3) and their weights (…, N) as arrays that fit together."""
    xp = namespace(a, b, weights)
    a, b = (floats(v, "vectors", xp) for v in (a, b))
    for v in (a, b):
        expect_last(v, (3,), "vectors")
    if a.ndim == b.ndim == 1:
        a, b = a[None, :], b[None, :]
    if a.shape != b.shape or not a.shape[-2]:
        raise RotationError(
            f"vectors of shapes {tuple(a.shape)} and {tuple(b.shape)}: "
            "as many of one kind as of the other are expected, and at least one pair"
        )
    return a, b, _weights(xp, weights, a)


@quiet
def fitted(a: Array, b: Array, w: Array) -> tuple[Array, Array]:
    """Return the quaternions (…, 4) that take b closest to a, and the roots of the sums that remain."""
    xp = namespace(a)
    q = _best(xp, a, b, w)
    turned = xp.matmul(b, xp.matrix_transpose(to_matrix(q)))
    rests = xp.sqrt(w) * length(xp, split(a - turned))
    largest = xp.max(rests, axis=-1, keepdims=True)  # divided out, so that no square overflows
    largest = xp.where(largest > 0.0, largest, xp.ones_like(largest))
    return q, xp.sqrt(xp.sum((rests / largest) ** 2, axis=-1)) * largest[..., 0]


def _weights(xp: Any, weights: Any, vectors: Array) -> Array:
    if weights is None:
        return xp.ones_like(vectors[..., 0])
    w = floats(weights, "weights", xp)
    try:
        w = xp.broadcast_to(w, vectors.shape[:-1])
    except ValueError:
        raise RotationError(
            f"weights of shape {tuple(w.shape)} do not broadcast to {tuple(vectors.shape[:-1])}"
        ) from None
    refuse_rows(w < 0.0, "the weight", "is negative")
    return w


def _best(xp: Any, a: Array, b: Array, w: Array) -> Array:
    # Only directions matter, and lengths relative to each other: nothing overflows when squared.
    a, b = _scaled(xp, a), _scaled(xp, b)
    heaviest = xp.max(w, axis=-1, keepdims=True)
    refuse_rows(heaviest[..., 0] == 0.0, "the weights", "are all zero")
    w = w / heaviest
    m = xp.matmul(xp.matrix_transpose(a * w[..., None]), b)
    finite = xp.all(xp.isfinite(m), axis=(-2, -1))
    m = xp.where(finite[..., None, None], m, xp.eye(3, dtype=m.dtype))
    u, s, vt = xp.linalg.svd(m)
    refuse_rows(
        s[..., 0] == 0.0,
        "the vectors",
        "are zero wherever they have weight: no rotation is determined",
    )
    tiny = 16.0 * float(xp.finfo(m.dtype).eps) * s[..., 0]
    line = s[..., 1] <= tiny
    sign = xp.sign(xp.linalg.det(u) * xp.linalg.det(vt))
    refuse_rows(
        ~line & (s[..., 1] + sign * s[..., 2] <= tiny),
        "the vectors",
        "determine no rotation: a reflection would align them, and several rotations do it equally well",
    )
    signs = xp.stack([xp.ones_like(sign), xp.ones_like(sign), sign], axis=-1)
    best = from_matrix(xp.matmul(u * signs[..., None, :], vt))
    shortest = between(vt[..., 0, :], u[..., :, 0])
    q = xp.where(line[..., None], shortest, best)
    return xp.where(finite[..., None], q, xp.nan * q)


def _scaled(xp: Any, v: Array) -> Array:
    largest = xp.max(xp.abs(v), axis=(-2, -1), keepdims=True)
    return v / xp.where(largest > 0.0, largest, xp.ones_like(largest))
