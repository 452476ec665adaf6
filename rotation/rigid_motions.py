"""Rigid motions as arrays of quaternions (…, 4) and translations (…, 3): ``v ↦ R·v + t``.

Other representations are dual quaternions ``q + ½·t·q·ε``, exponential coordinates (twists), homogeneous
matrices, and screws, because every rigid motion is a rotation about a line and a translation along it.

M. Chasles, Bull. Sci. Math. Férussac 14 (1830); R. S. Ball, "A treatise on the theory of screws" (1900);
R. M. Murray, Z. Li and S. S. Sastry, "A mathematical introduction to robotic manipulation" (1994), chapter 2.
"""

from __future__ import annotations

from typing import NamedTuple

from rotation.action import BY_QUATERNION, turned_by
from rotation.angles import to_degrees
from rotation.array_types import Array, ArrayLike, Namespace
from rotation.arrays import common_batch
from rotation.coordinates import Coordinates, factor, join, length, split, sum_of_squares, unit
from rotation.errors import RotationError
from rotation.jacobians import exponential_factors, logarithm_factor
from rotation.matrices import matrix_entries
from rotation.namespaces import expect_last, floats, namespace, quiet, refuse_rows, refuse_zeros
from rotation.quaternions import conjugated, multiplied, steadied
from rotation.rowwise import RowFormula, flag_if
from rotation.vectors import from_axis_angle, to_axis_angle


def _moved(q: Array, t: Array, points: Array) -> Array:
    image = turned_by(split(q), split(points), False)
    return join(namespace(points), tuple(a + b for a, b in zip(image, split(t), strict=True)))


def _moved_back(q: Array, t: Array, points: Array) -> Array:
    rest = tuple(a - b for a, b in zip(split(points), split(t), strict=True))
    return join(namespace(points), turned_by(split(q), rest, True))


def _composed(q: Array, t: Array, p: Array, s: Array) -> Array:
    """Return the motion (p, s) followed by (q, t), as seven numbers per row."""
    image = turned_by(split(q), split(s), False)
    turn = steadied(multiplied(split(q), split(p)))
    return join(namespace(q), (*turn, *(a + b for a, b in zip(image, split(t), strict=True))))


def _inverted(q: Array, t: Array) -> Array:
    back = turned_by(split(q), split(t), True)
    return join(namespace(q), (*conjugated(split(q)), *(-c for c in back)))


def _matrix(q: Array, t: Array) -> Array:
    xp = namespace(q)
    zero = xp.zeros_like(q[..., 0])
    rows = [(*row, c) for row, c in zip(matrix_entries(split(q)), split(t), strict=True)]
    rows.append((zero, zero, zero, zero + 1.0))
    return xp.stack([join(xp, row) for row in rows], axis=-2)


def _adjoint(q: Array, t: Array) -> Array:
    xp = namespace(q)
    turn, nothing = matrix_entries(split(q)), (xp.zeros_like(q[..., 0]),) * 3
    columns = [cross(split(t), column) for column in zip(*turn, strict=True)]
    rows = [(*row, *nothing) for row in turn]
    rows += [(*shift, *row) for shift, row in zip(zip(*columns, strict=True), turn, strict=True)]
    return xp.stack([join(xp, row) for row in rows], axis=-2)


def cross(a: Coordinates, b: Coordinates) -> Coordinates:
    """Return ``a × b``."""
    (x, y, z), (u, v, w) = a, b
    return y * w - z * v, z * u - x * w, x * v - y * u


def _jacobian_times(rotvec: Array, along: Array) -> Array:
    return join(namespace(rotvec), jacobian_times(namespace(rotvec), split(rotvec), split(along)))


def jacobian_times(xp: Namespace, v: Coordinates, u: Coordinates) -> Coordinates:
    """Return ``J(v)·u``: the translation of the motion whose twist is (v, u)."""
    axis, a, b = exponential_factors(xp, v)
    first = cross(axis, u)
    rows = zip(u, first, cross(axis, first), strict=True)
    return tuple(x + (a * y + b * z) for x, y, z in rows)


def _inverse_jacobian_times(rotvec: Array, translation: Array) -> Array:
    """Return ``J⁻¹(v)·t``."""
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


MOVED = RowFormula(_moved, (4,), (3,), (3,))
MOVED_BACK = RowFormula(_moved_back, (4,), (3,), (3,))
COMPOSED = RowFormula(_composed, (4,), (3,), (4,), (3,))
INVERTED = RowFormula(_inverted, (4,), (3,))
MATRIX = RowFormula(_matrix, (4,), (3,))
ADJOINT = RowFormula(_adjoint, (4,), (3,))
JACOBIAN_TIMES = RowFormula(_jacobian_times, (3,), (3,))
INVERSE_JACOBIAN_TIMES = RowFormula(_inverse_jacobian_times, (3,), (3,))
DUAL = RowFormula(_dual, (4,), (3,))


def from_dual(dual: Array) -> Array:
    """Return the motions (…, 7) of dual quaternions (…, 8), which are normalised to dual norm 1.

    Raises
    ------
    RotationError
        The first four coordinates are zero.
    """
    motions, zeros = _FROM_DUAL.with_flag(dual)
    if zeros:
        refuse_zeros(dual[..., :4], "real part of a dual quaternion")
    return motions


def _from_dual(dual: Array) -> Array:
    xp, d = namespace(dual), split(dual)
    real, f = d[:4], factor(xp, d[:4])
    norm = sum_of_squares([f * c for c in real])
    flag_if(xp, norm == 0.0)
    n = xp.sqrt(norm)
    q = unit(xp, real)
    rest = tuple(f * (c / n) for c in d[4:])  # n / f might be no float
    half = multiplied(rest, conjugated(q))[1:]
    return join(xp, (*q, *(2.0 * c for c in half)))


_FROM_DUAL = RowFormula(_from_dual, (8,))


def expect_affine(m: Array) -> None:
    """Raise `RotationError` unless the last rows of matrices (…, 4, 4) are 0, 0, 0, 1."""
    xp = namespace(m)
    if m.ndim < 2 or tuple(m.shape[-2:]) != (4, 4):
        raise RotationError(f"matrices has shape {tuple(m.shape)}; expected (…, 4, 4)")
    last = m[..., 3, :]
    refuse_rows(
        ~((last[..., 3] == 1.0) & xp.all(last[..., :3] == 0.0, axis=-1)),
        "the matrix",
        "has not the last row [0, 0, 0, 1], so it is not a rigid transform",
    )


class Screw(NamedTuple):
    """A motion along a screw: directions (…, 3), points of the lines (…, 3), angles and displacements (…).

    Examples
    --------
    >>> from rotation import RigidTransform
    >>> RigidTransform.from_translation([0, 0, 2]).as_screw().displacement
    np.float64(2.0)
    """

    axis: Array
    point: Array
    angle: Array
    displacement: Array


@quiet
def from_screw(
    axis: ArrayLike,
    point: ArrayLike,
    angle: ArrayLike,
    displacement: ArrayLike,
    degrees: bool = False,
) -> tuple[Array, Array]:
    """Return quaternions and translations of screws; see `RigidTransform.from_screw`."""
    xp = namespace(axis, point, angle, displacement)
    a, p = floats(axis, "axes", xp), floats(point, "points", xp)
    expect_last(a, (3,), "axes")
    expect_last(p, (3,), "points")
    d = floats(displacement, "displacements", xp)
    refuse_zeros(a, "axis")
    t = floats(angle, "angles", xp)
    common_batch(
        axis=tuple(a.shape[:-1]),
        point=tuple(p.shape[:-1]),
        angle=tuple(t.shape),
        displacement=tuple(d.shape),
    )
    q = from_axis_angle(a, t, degrees)
    along = join(xp, unit(xp, split(a)))
    return q, p - BY_QUATERNION(q, p) + d[..., None] * along


@quiet
def to_screw(q: Array, t: Array, degrees: bool = False) -> Screw:
    """Return the screws of motions (q, t), with angles in [0, π].

    The point is the one on the line nearest to the origin. If the rotation is the identity, the axis is the
    direction of the translation and the line passes through the origin; the identity motion has the axis z.
    """
    xp = namespace(q)
    axis, angle = to_axis_angle(q)
    u, s = split(axis), split(t)
    shift = length(xp, s)
    still = angle == 0.0
    pure = still & (shift > 0.0)
    way = unit(xp, tuple(xp.where(pure, b, xp.ones_like(b)) for b in s))
    u = tuple(xp.where(pure, b, a) for a, b in zip(u, way, strict=True))
    along = sum((a * b for a, b in zip(u, s, strict=True)), 0.0 * shift)
    half = 0.5 * xp.where(still, xp.ones_like(angle), angle)
    sine, cosine = xp.sin(half), xp.cos(half)
    across = tuple(b - along * a for a, b in zip(u, s, strict=True))
    point = tuple(
        xp.where(still, 0.0 * a, 0.5 * (a + cosine * b / sine))
        for a, b in zip(across, cross(u, across), strict=True)
    )
    return Screw(join(xp, u), join(xp, point), to_degrees(xp, angle) if degrees else angle, along)
