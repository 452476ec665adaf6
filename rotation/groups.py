"""Finite groups of rotations, and the nearest of many equivalent rotations.

The finite groups are the cyclic, the dihedral, and the rotations of the tetrahedron, the octahedron and the
icosahedron (F. Klein, "Vorlesungen über das Ikosaeder", 1884).
"""

import itertools
from collections.abc import Callable

import numpy as np

from rotation.array_types import Array
from rotation.errors import RotationError
from rotation.quaternions import canonical, normalised, product

_AXES = "XYZ"
POLYHEDRAL = ("T", "O", "I")
Row = tuple[float, ...]
Rows = list[Row]
_BLOCK = 2**21  # products of quaternions that are in memory at once


def elements(group: str, axis: str = "Z") -> Array:
    """Return the unit quaternions (order, 4) of a finite group; the identity comes first.

    Parameters and errors are those of `Rotation.create_group`.
    """
    if not isinstance(group, str):
        raise RotationError(f"group {group!r}: a text is expected, one of I, O, T, Cn and Dn")
    if not isinstance(axis, str) or axis.upper() not in ("X", "Y", "Z"):
        raise RotationError(f"axis {axis!r}: X, Y or Z is expected")
    if group in _BEYOND:
        return normalised(_tetrahedral() + _BEYOND[group]())
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
        q[:n] = canonical(q[:n])
    return normalised(q)


def _tetrahedral() -> Rows:
    """Return the identity, half turns about the axes, and third turns about the diagonals of a cube."""
    half = (-0.5, 0.5)
    return [
        *(tuple(row) for row in np.eye(4).tolist()),
        *((w, 0.5, y, z) for w, y, z in itertools.product(half[::-1], half, half)),
    ]


def _octahedral() -> Rows:
    """Return those elements not in the tetrahedral group: quarter turns, and half turns about face
    diagonals.
    """
    r = 0.5**0.5
    quarters = [(r, r, 0.0, 0.0), (r, 0.0, r, 0.0), (r, 0.0, 0.0, r)]
    halves = [(0.0, 0.0, r, r), (0.0, r, 0.0, r), (0.0, r, r, 0.0)]
    return [
        *quarters,
        *((w, -x, -y, -z) for w, x, y, z in quarters[::-1]),
        *(q for h in halves for q in (h, _with_first_turned(h))),
    ]


def _with_first_turned(q: Row) -> Row:
    """Return the same rotation with a negative first nonzero coordinate."""
    n = next(n for n, c in enumerate(q) if c)
    return (*q[:n], -q[n], *q[n + 1 :])


def _icosahedral() -> Rows:
    """Return the elements of the icosahedral group that are not in the tetrahedral group: even permutations
    of (0, 1, 1/φ, φ)/2, with signs.
    """
    golden = (1.0 + 5.0**0.5) / 2.0
    numbers = np.array([0.5, 0.5 / golden, golden / 2.0])
    letters = [*numbers, *-numbers, 0.0]
    places = []  # of the letters, by which the rows are sorted
    for order in itertools.permutations((0, 1, 2, 6)):
        if sum(a > b for a, b in itertools.combinations(order, 2)) % 2 == 0:
            for minus in itertools.product((0, 3), repeat=2):
                further = iter((0, *minus))
                places.append([n if n == 6 else n + next(further) for n in order])
    return [tuple(letters[n] for n in (w, x, y, z)) for x, y, z, w in sorted(places)]


# In scipy's order, except for the identity, which is fourth there.
_BEYOND: dict[str, Callable[[], Rows]] = {"T": list, "O": _octahedral, "I": _icosahedral}


def nearest(p: Array, left: Array, right: Array) -> tuple[Array, Array]:
    """Return, for quaternions (…, 4), the indices into (m, 4) and (n, 4) for which the angle of ``l·p·r`` is
    least.

    The scalar part of ``l·p·r`` is that of ``(r·l)·p``, which is linear in p, so it is a matrix product.
    """
    products = product(right[:, None, :], left[None, :, :]).reshape(-1, 4)
    rows = products * np.array([1.0, -1.0, -1.0, -1.0])
    flat = p.reshape(-1, 4)
    best = np.empty(len(flat), np.int64)
    step = max(1, _BLOCK // len(rows))
    for start in range(0, len(flat), step):
        piece = slice(start, start + step)
        best[piece] = np.argmax(np.abs(flat[piece] @ rows.T), axis=1)
    r, n = np.divmod(best.reshape(p.shape[:-1]), len(left))
    return n, r
