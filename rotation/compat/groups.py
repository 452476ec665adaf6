"""Finite groups in scipy's order, and of equivalent rotations the one that scipy takes."""

from typing import Any

import numpy as np

from rotation import groups

Array = Any
_TURNS = np.zeros((3, 3, 3))  # the sign of a permutation of the axes
for _k in range(3):
    _TURNS[_k, _k - 2, _k - 1], _TURNS[_k, _k - 1, _k - 2] = 1.0, -1.0
_BLOCK = 2**20  # products that are held at once


def elements(group: str, axis: str) -> Array:
    """Return the quaternions of a group; the identity comes behind three half turns, if there are such."""
    q = groups.elements(group, axis)
    return q[[1, 2, 3, 0, *range(4, len(q))]] if group in groups.POLYHEDRAL else q


def nearest(p: Array, left: Array, right: Array) -> tuple[Array, Array]:
    """Return which of (m, 4) and (n, 4) make ``l·p·r`` turn least: two index arrays, of the shape of p.

    With two groups many are equally small. Rounding decides then, so this computes every scalar part with the
    same sums in the same order as scipy.
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
    """The scalar parts of ``l·p·r``, by the scalar and vector parts of the three."""
    a, b, c = left[:, 0], p[:, 0], right[:, 0]
    u, v, w = left[:, 1:], p[:, 1:], right[:, 1:]
    return (
        np.einsum("i,j,k", a, b, c)
        - np.einsum("i,jx,kx", a, v, w)
        - np.einsum("ix,j,kx", u, b, w)
        - np.einsum("ix,jx,k", u, v, c)
        - np.einsum("xyz,ix,jy,kz", _TURNS, u, v, w)
    )
