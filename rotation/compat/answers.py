"""Answers that scipy gives where ours is an error: to matrices that are no rotations, to means of no one."""

from typing import Any

import numpy as np

from rotation.averaging import mean
from rotation.errors import RotationError
from rotation.namespaces import quiet
from rotation.optimum import davenport
from rotation.quaternions import canonical

Array = Any


@quiet
def unchecked(m: Array) -> Array:
    """Return the quaternions of matrices that are taken for rotations: ``4·q·qᵀ``, whose largest row is q."""
    rows = davenport([[m[..., r, c] for c in range(3)] for r in range(3)])
    products = np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)
    products[..., range(4), range(4)] += 1.0
    largest = np.argmax(np.einsum("...kk->...k", products), axis=-1)[..., None, None]
    q = np.take_along_axis(products, largest, axis=-2)[..., 0, :]
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def averaged(q: Array, weights: Array | None, axes: tuple[int, ...]) -> Array:
    """Return the mean of quaternions, or where several are equally good scipy's."""
    try:
        return mean(q, weights, axes)
    except RotationError:
        w = np.ones(q.shape[:-1]) if weights is None else np.broadcast_to(weights, q.shape[:-1])
        p = np.roll(q, -1, axis=-1)
        moments = np.sum(w[..., None, None] * p[..., :, None] * p[..., None, :], axis=axes)
        return canonical(np.roll(np.linalg.eigh(moments)[1][..., -1], 1, axis=-1))
