"""Arrays of attitudes: functions that motions need and :mod:`rotation` does not have.

Quaternions are scalar first, (…, 4), matrices (…, 3, 3).
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rotation.matrices import to_matrix
from rotation.quaternions import inverse, power, product

Floats = NDArray[np.float64]


def continuous(q: Floats) -> Floats:
    """Return the same rotations (n, 4), with signs such that neighbours have dot product ≥ 0."""
    flips = np.where(np.sum(q[1:] * q[:-1], axis=-1) < 0, -1.0, 1.0)
    signs: Floats = np.concatenate([[1.0], np.cumprod(flips)])
    return np.asarray(q * signs[: len(q), None])


def between(p: Floats, q: Floats, fractions: ArrayLike) -> Floats:
    """Return the attitudes at ``fractions`` of the shortest rotation from ``p`` to ``q`` (slerp)."""
    return np.asarray(product(p, power(product(inverse(p), q), np.asarray(fractions))))


def twist(q: Floats) -> Floats:
    """Return the twist about the own z axis of each rotation, as angles in [−π, π].

    A rotation is a rotation about z followed by one about an axis in the plane z = 0; this is the angle of
    the former.
    """
    sign = np.where(q[..., 0] < 0, -1.0, 1.0)
    return np.asarray(2 * np.arctan2(sign * q[..., 3], sign * q[..., 0]))


def angle_between(m: Floats, n: Floats) -> Floats:
    """Return the angles in radians between rotation matrices, accurate for small ones too.

    In the Frobenius norm ‖M − N‖ = 2√2·sin(angle/2).
    """
    chord = np.linalg.norm(m - n, axis=(-2, -1)) / (2 * np.sqrt(2))
    return np.asarray(2 * np.arcsin(np.minimum(chord, 1.0)))


def angle_between_directions(u: Floats, v: Floats) -> Floats:
    """Return the angles in radians between unit vectors (…, 3), accurate for small ones too."""
    return np.asarray(2 * np.arcsin(np.minimum(np.linalg.norm(u - v, axis=-1) / 2, 1.0)))


def axes(q: Floats) -> Floats:
    """Return the directions (n, 3) of the top's axis under attitudes (n, 4)."""
    return np.asarray(np.asarray(to_matrix(q))[:, :, 2])


def tilts(axes: Floats) -> Floats:
    """Return the angles in [0, π] between directions (…, 3) and the vertical."""
    return np.asarray(np.arctan2(np.hypot(axes[..., 0], axes[..., 1]), axes[..., 2]))
