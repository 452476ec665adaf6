"""What the answers should be, with fifty digits."""

from collections.abc import Sequence
from typing import Any

import mpmath

mp = mpmath.mp.clone()  # not the global one, which others use
mp.dps = 50
Number = Any


def exact(values: Sequence[float]) -> list[Number]:
    """The floats themselves, as numbers of fifty digits."""
    return [mp.mpf(float(v)) for v in values]


def length(v: Sequence[Number]) -> Number:
    return mp.sqrt(sum(c * c for c in v))


def quaternion_of(rotvec: Sequence[float]) -> list[Number]:
    v = exact(rotvec)
    n = length(v)
    if n == 0:
        return [mp.mpf(1), mp.mpf(0), mp.mpf(0), mp.mpf(0)]
    return [mp.cos(n / 2), *(mp.sin(n / 2) / n * c for c in v)]


def matrix_of(q: Sequence[Number]) -> Any:
    """The matrix of v ↦ q·v·q⁻¹ for a quaternion of any length (thesis, 2.2.5)."""
    w, x, y, z = q
    n = w * w + x * x + y * y + z * z
    rows = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    return mp.matrix([[entry / n for entry in row] for row in rows])


def about(letter: str, angle: Number) -> Any:
    """R_x, R_y and R_z of the thesis, 2.2.2."""
    c, s = mp.cos(angle), mp.sin(angle)
    return mp.matrix(
        {
            "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
            "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
            "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
        }[letter.lower()]
    )


def euler(seq: str, angles: Sequence[float]) -> Any:
    """Uppercase: the first letter's matrix is leftmost; lowercase: rightmost."""
    matrices = [about(letter, a) for letter, a in zip(seq, exact(angles), strict=True)]
    product = mp.eye(3)
    for m in matrices if seq.isupper() else matrices[::-1]:
        product = product * m
    return product


def distance(found: Any, wanted: Any) -> float:
    """The largest difference of two matrices, entry by entry."""
    return float(
        max(abs(mp.mpf(float(found[r][c])) - wanted[r, c]) for r in range(3) for c in range(3))
    )
