"""Rigid motions as arrays of quaternions (…, 4) and translations (…, 3): ``v ↦ R·v + t``.

Their forms: dual quaternions ``q + ½·t·q·ε``, exponential coordinates (twists), homogeneous matrices.
R. M. Murray, Z. Li and S. S. Sastry, "A mathematical introduction to robotic manipulation" (1994), chapter 2.
"""

from hfield import product as formula
from rotation.acting import turned_by
from rotation.coordinates import Coordinates, factor, join, split, sum_of_squares, unit
from rotation.errors import RotationError
from rotation.jacobians import exponential_factors, logarithm_factor
from rotation.matrices import matrix_entries
from rotation.namespaces import Array, namespace, refuse_rows, refuse_zeros
from rotation.quaternions import HAMILTON, multiplied, steadied
from rotation.rowwise import Formula, tell


def _moved(q: Array, t: Array, points: Array) -> Array:
    image = turned_by(q, split(points), False)
    return join(namespace(points), tuple(a + b for a, b in zip(image, split(t), strict=True)))


def _moved_back(q: Array, t: Array, points: Array) -> Array:
    rest = tuple(a - b for a, b in zip(split(points), split(t), strict=True))
    return join(namespace(points), turned_by(q, rest, True))


def _composed(q: Array, t: Array, p: Array, s: Array) -> Array:
    """The motion by (p, s) first, then by (q, t): seven numbers a row."""
    image = turned_by(q, split(s), False)
    turn = steadied(multiplied(split(q), split(p)))
    return join(namespace(q), (*turn, *(a + b for a, b in zip(image, split(t), strict=True))))


def _inverted(q: Array, t: Array) -> Array:
    back = turned_by(q, split(t), True)
    return join(namespace(q), (*formula.conjugate(HAMILTON, split(q)), *(-c for c in back)))


def _matrix(q: Array, t: Array) -> Array:
    xp = namespace(q)
    zero = xp.zeros_like(q[..., 0])
    rows = [(*row, c) for row, c in zip(matrix_entries(q), split(t), strict=True)]
    rows.append((zero, zero, zero, zero + 1.0))
    return xp.stack([join(xp, row) for row in rows], axis=-2)


def cross(a: Coordinates, b: Coordinates) -> Coordinates:
    """Return ``a × b``."""
    (x, y, z), (u, v, w) = a, b
    return y * w - z * v, z * u - x * w, x * v - y * u


def _swept(rotvec: Array, along: Array) -> Array:
    """``J(v)·u``: the translation of the motion whose twist is (v, u)."""
    xp = namespace(rotvec)
    v, u = split(rotvec), split(along)
    axis, a, b = exponential_factors(xp, v)
    first = cross(axis, u)
    rows = zip(u, first, cross(axis, first), strict=True)
    return join(xp, tuple(x + (a * y + b * z) for x, y, z in rows))


def _unswept(rotvec: Array, translation: Array) -> Array:
    """``J⁻¹(v)·t``."""
    xp = namespace(rotvec)
    v, t = split(rotvec), split(translation)
    axis, c = logarithm_factor(xp, v)
    second = cross(axis, cross(axis, t))
    rows = zip(t, cross(v, t), second, strict=True)
    return join(xp, tuple(x + (c * z - 0.5 * y) for x, y, z in rows))


def _dual(q: Array, t: Array) -> Array:
    zero = namespace(q).zeros_like(t[..., 0])
    half = (zero, *(0.5 * c for c in split(t)))
    return join(namespace(q), (*split(q), *multiplied(half, split(q))))


MOVED = Formula(_moved, (4,), (3,), (3,))
MOVED_BACK = Formula(_moved_back, (4,), (3,), (3,))
COMPOSED = Formula(_composed, (4,), (3,), (4,), (3,))
INVERTED = Formula(_inverted, (4,), (3,))
MATRIX = Formula(_matrix, (4,), (3,))
SWEPT = Formula(_swept, (3,), (3,))
UNSWEPT = Formula(_unswept, (3,), (3,))
DUAL = Formula(_dual, (4,), (3,))


def from_dual(dual: Array) -> Array:
    """Return the motions (…, 7) of dual quaternions (…, 8), made unit: their dual norm to 1.

    Raises
    ------
    RotationError
        The first four coordinates are zero.
    """
    motions, zeros = _FROM_DUAL.told(dual)
    if zeros:
        refuse_zeros(dual[..., :4], "real part of a dual quaternion")
    return motions


def _from_dual(dual: Array) -> Array:
    xp, d = namespace(dual), split(dual)
    real, f = d[:4], factor(xp, d[:4])
    norm = sum_of_squares([f * c for c in real])
    tell(xp, norm == 0.0)
    n = xp.sqrt(norm)
    q = unit(xp, real)
    rest = tuple(f * (c / n) for c in d[4:])  # n / f might be no float
    half = multiplied(rest, formula.conjugate(HAMILTON, q))[1:]
    return join(xp, (*q, *(2.0 * c for c in half)))


_FROM_DUAL = Formula(_from_dual, (8,))


def expect_affine(m: Array) -> None:
    """Raise `RotationError` unless the last rows of matrices (…, 4, 4) are 0, 0, 0, 1."""
    xp = namespace(m)
    if m.ndim < 2 or tuple(m.shape[-2:]) != (4, 4):
        raise RotationError(f"matrices has shape {tuple(m.shape)}; expected (…, 4, 4)")
    last = m[..., 3, :]
    refuse_rows(
        ~((last[..., 3] == 1.0) & xp.all(last[..., :3] == 0.0, axis=-1)),
        "the matrix",
        "has not the last row [0, 0, 0, 1], so it is no rigid transform",
    )
