"""Rotate a few points, for every representation of rotations.

Results are within 5·2⁻⁵²·‖v‖ of the exact image, like those of the kernels. A point with NaN or inf becomes
NaN.
"""

from collections.abc import Callable, Iterable
from functools import cache, reduce
from operator import and_

import numpy as np

from rotation.angles import waves
from rotation.array_types import Array
from rotation.coordinates import (
    Coordinates,
    factor,
    join,
    split,
    unchanging,
)
from rotation.matrices import matrix_entries
from rotation.namespaces import namespace
from rotation.native.pairs import plus_product
from rotation.rowwise import RowFormula, flag_if, rarely
from rotation.vectors import about_axis

# Up to these numbers of points the formulas are faster than the kernels, which take longer to
# start: for one rotation; for one quaternion per point; and for one axis and angle per point, with
# the system's sines.
FEW, FEW_OWN, FEW_SINES = 25_000, 8_000, 600


def _steadily(turned: Callable[[Coordinates], Coordinates], v: Coordinates) -> Coordinates:
    """Rotate v; values close to the limits of floats are scaled by a power of two first."""
    xp = namespace(v[0])
    f = factor(xp, v)
    spoilt = unchanging(xp, v)

    def brought_near() -> Coordinates:
        return tuple(c / f for c in turned(tuple(f * c for c in v)))

    image = rarely(xp, f != 1.0, brought_near, turned(v))
    return tuple(c + spoilt for c in image)


def by_rows(
    m: Iterable[Iterable[Array]], v: Coordinates, unchanging: Array | None = None
) -> Coordinates:
    """Return m·v, each row summed from left to right, after an optional initial zero."""
    xp = namespace(v[0])

    def row(a: Array, b: Array, c: Array) -> Array:
        first = a * v[0] if unchanging is None else plus_product(xp, unchanging, a, v[0])
        return plus_product(xp, plus_product(xp, first, b, v[1]), c, v[2])

    return tuple(row(*entries) for entries in m)


def _by_entries(m: Iterable[Iterable[Array]], v: Coordinates) -> Coordinates:
    rows = [tuple(row) for row in m]
    return _steadily(lambda v: by_rows(rows, v), v)


def _by_matrix(matrix: Array, points: Array) -> Array:
    rows = [[matrix[..., r, c] for c in range(3)] for r in range(3)]
    return join(namespace(points), _by_entries(rows, split(points)))


def turned_by(q: Coordinates, v: Coordinates, inverse: bool) -> Coordinates:
    """Return vectors rotated by unit quaternions, or by their inverses."""
    m = matrix_entries(q)
    return _by_entries(zip(*m, strict=True) if inverse else m, v)


def _by_quaternion(q: Array, points: Array, inverse: bool) -> Array:
    return join(namespace(points), turned_by(split(q), split(points), inverse))


def _about_axis(axis: Array, angle: Array, points: Array, degrees: bool) -> Array:
    xp = namespace(points)
    a = split(axis)
    flag_if(xp, reduce(and_, (c == 0.0 for c in a)))
    return join(xp, turned_by(about_axis(a, angle[...], degrees), split(points), False))


def turned_about(axes: Iterable[int], waves: Iterable[Coordinates], v: Coordinates) -> Coordinates:
    """Return vectors rotated about coordinate axes, one after another; ``waves`` are pairs (sine, cosine)."""
    image = list(v)
    for (s, c), axis in zip(waves, axes, strict=True):
        j, k = (axis + 1) % 3, (axis + 2) % 3
        image[j], image[k] = c * image[j] - s * image[k], s * image[j] + c * image[k]
    return tuple(image)


def by_angles(
    angles: Array, points: Array, axes: tuple[int, ...], backward: bool, degrees: bool
) -> Array:
    """Return points rotated by Euler angles of any size, beginning with the last one if ``backward``."""
    xp = namespace(points)
    turns = list(split(angles))[:: -1 if backward else 1]
    spoilt = unchanging(xp, split(angles))
    both = [waves(xp, t, degrees) for t in turns]
    image = _steadily(lambda v: turned_about(axes, both, v), split(points))
    return join(xp, tuple(x + spoilt for x in image))


BY_MATRIX = RowFormula(_by_matrix, (3, 3), (3,), single=(0,))
BY_QUATERNION = RowFormula(_by_quaternion, (4,), (3,), parameters=(False,))
BY_INVERSE = RowFormula(_by_quaternion, (4,), (3,), parameters=(True,))
ABOUT_AXIS = [RowFormula(_about_axis, (3,), (), (3,), parameters=(d,)) for d in (False, True)]


@cache
def by_euler(axes: tuple[int, ...], backward: bool, degrees: bool) -> RowFormula:
    """Return the formula for Euler angles about three axes, beginning with the last one if ``backward``."""
    return RowFormula(by_angles, (len(axes),), (3,), parameters=(axes, backward, degrees))


def write(formula: RowFormula, target: Array, *arrays: Array) -> bool:
    """Write the values of a formula to ``target`` and return its flag; the points are its last array.

    The arrays may have either precision; all computations are in double precision. The target may be the
    points.
    """
    arrays = tuple(a.astype(np.float64, copy=False) for a in arrays)
    flag = formula.function(target, *arrays)  # the machine code writes to it if possible
    if flag is None:
        image, flag = formula.with_flag(*arrays)
        target[...] = image
    return bool(flag)
