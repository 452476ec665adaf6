"""Finite groups of rotations, and the nearest of many equivalent rotations.

The finite groups are the cyclic, the dihedral, and the rotations of the tetrahedron, the octahedron and the
icosahedron (F. Klein, "Vorlesungen über das Ikosaeder", 1884); the last three are made of their generators.
"""

import numpy as np

from rotation.coordinates import Coordinates
from rotation.errors import RotationError
from rotation.namespaces import Array
from rotation.quaternions import multiplied, normalised, product

_AXES = "XYZ"
_ORDER = {"T": 12, "O": 24, "I": 60}
_GOLDEN = (1.0 + 5.0**0.5) / 2.0
_GENERATORS = {
    "T": ((0.5, 0.5, 0.5, 0.5), (0.0, 1.0, 0.0, 0.0)),
    "O": ((0.5, 0.5, 0.5, 0.5), (0.5**0.5, 0.5**0.5, 0.0, 0.0)),
    "I": ((0.5, 0.5, 0.5, 0.5), (0.5 * _GOLDEN, 0.5 / _GOLDEN, 0.5, 0.0)),
}
_BLOCK = 2**21  # products of quaternions that are held at once


def elements(group: str, axis: str = "Z") -> Array:
    """Return the unit quaternions (order, 4) of a finite group; the identity comes first.

    Parameters and errors are those of `Rotation.create_group`.
    """
    if not isinstance(group, str):
        raise RotationError(f"group {group!r}: a text is expected, one of I, O, T, Cn and Dn")
    if not isinstance(axis, str) or axis.upper() not in ("X", "Y", "Z"):
        raise RotationError(f"axis {axis!r}: X, Y or Z is expected")
    if group in _ORDER:
        return normalised(_generated(_GENERATORS[group], _ORDER[group]))
    kind, number = group[:1], group[1:]
    if kind not in ("C", "D") or not (number.isascii() and number.isdigit()) or int(number) < 1:
        raise RotationError(
            f"group {group!r}: one of I, O, T, Cn and Dn is expected, with n at least 1"
        )
    n, k = int(number), _AXES.index(axis.upper())
    half = np.pi * np.arange(n) / n
    q = np.zeros((n if kind == "C" else 2 * n, 4))
    q[:n, 0], q[:n, 1 + k] = np.cos(half), np.sin(half)
    if kind == "D":  # half turns about axes across
        q[n:, 1 + (k + 1) % 3], q[n:, 1 + (k + 2) % 3] = np.cos(half), np.sin(half)
    return normalised(q)


def _generated(generators: tuple[tuple[float, ...], ...], order: int) -> Array:
    """Multiply by generators until nothing new comes, to within 1e-9."""
    found: dict[tuple[int, ...], Coordinates] = {}
    waiting: list[Coordinates] = [(1.0, 0.0, 0.0, 0.0)]
    while waiting:
        q = waiting.pop()
        sign = next((1.0 if c > 0.0 else -1.0 for c in q if abs(c) > 1e-9), 1.0)
        q = tuple(sign * c + 0.0 for c in q)
        key = tuple(round(c * 1e9) for c in q)
        if key not in found:
            found[key] = q
            waiting += [tuple(multiplied(g, q)) for g in generators]
    if len(found) != order:
        raise AssertionError(f"a group of order {order} was made with {len(found)} elements")
    return np.array(list(found.values()))


def nearest(p: Array, left: Array, right: Array) -> tuple[Array, Array]:
    """Return for quaternions (…, 4) which of (m, 4) and (n, 4) make ``l·p·r`` turn least: two index arrays.

    The scalar part of ``l·p·r`` is that of ``(r·l)·p``, which is linear in p: one product of matrices.
    """
    products = product(right[:, None, :], left[None, :, :]).reshape(-1, 4)
    rows = products * np.array([1.0, -1.0, -1.0, -1.0])
    flat = p.reshape(-1, 4)
    best = np.empty(len(flat), np.int64)
    step = max(1, _BLOCK // len(rows))
    for start in range(0, len(flat), step):
        piece = slice(start, start + step)
        best[piece] = np.argmax(np.abs(flat[piece] @ rows.T), axis=1)
    r, n = np.divmod(best, len(left))
    return n.reshape(p.shape[:-1]), r.reshape(p.shape[:-1])
