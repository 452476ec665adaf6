"""The plane (thesis 2.1): rotations, reflections, complex numbers, polar form, polygons.

Points are arrays of shape (…, 2), and angles arrays of any shape, in radians unless ``degrees=True``. All
functions broadcast; angles of shape (m, 1) and n points give all m·n pairs. The dtype of the points
determines that of the result: float32 and float64 are kept, integers become float64, anything else raises an
error. NaN and inf give NaN in that row only.

Multiples of 90 degrees are exact with ``degrees=True``: ``R2(90, degrees=True)`` contains no 6e-17.
"""

from __future__ import annotations

from functools import reduce
from operator import add

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rotation.angles import waves
from rotation.array_types import NUMPY
from rotation.arrays import common_batch, components, expect_unmasked, real
from rotation.errors import RotationError

Floats = NDArray[np.floating]
Complexes = NDArray[np.complexfloating]

LETTER_T: tuple[tuple[int, int], ...] = (
    *((10, 1), (11, 1), (11, 6), (13, 6)),
    *((13, 7), (8, 7), (8, 6), (10, 6)),
)
"""The letter T of examples 2 and 3: its corners x₁ … x₈, anticlockwise, the last joined to the first."""


def R2(psi: ArrayLike, *, degrees: bool = False) -> Floats:
    """Return the rotation matrices [[cos ψ, −sin ψ], [sin ψ, cos ψ]], shape (…, 2, 2) (2.1.1).

    Examples
    --------
    >>> R2(90, degrees=True).round(15) + 0.0
    array([[ 0., -1.],
           [ 1.,  0.]])
    """
    c, s = _cos_sin(psi, degrees)
    return _matrix(c, -s, s, c)


def reflection(theta: ArrayLike, *, degrees: bool = False) -> Floats:
    """Return the reflections [[cos θ, sin θ], [sin θ, −cos θ]], shape (…, 2, 2) (2.1.2, corrected).

    Each is the reflection in the line through the origin at the angle θ/2: θ = 0 gives the x axis, θ = π the
    y axis. These are all orthogonal matrices of determinant −1. The thesis prints :func:`printed_orthogonal`
    and :func:`printed_reflection` instead.

    Examples
    --------
    >>> reflection(0)
    array([[ 1.,  0.],
           [ 0., -1.]])
    """
    c, s = _cos_sin(theta, degrees)
    return _matrix(c, s, s, -c)


def printed_orthogonal(theta: ArrayLike, *, degrees: bool = False) -> Floats:
    """Return [[cos θ, sin θ], [sin θ, cos θ]], which 2.1.2 prints as the form of every orthogonal matrix.

    It is also the O(θ) of example 3. Its determinant is cos 2θ, and it is orthogonal only if sin 2θ = 0.
    """
    c, s = _cos_sin(theta, degrees)
    return _matrix(c, s, s, c)


def printed_reflection(theta: ArrayLike, *, degrees: bool = False) -> Floats:
    """Return [[cos θ, −sin θ], [sin θ, −cos θ]], which 2.1.2 prints for determinant −1.

    Its determinant is −cos 2θ; θ = 0 and π give the two reflections that preserve areas according to example
    3.
    """
    c, s = _cos_sin(theta, degrees)
    return _matrix(c, -s, s, -c)


def transform(matrices: ArrayLike, points: ArrayLike) -> Floats:
    """Return the 2 × 2 matrices (…, 2, 2) times the points (…, 2), broadcast.

    Raises :class:`~rotation.errors.RotationError` for other shapes, and for shapes that do not broadcast.
    """
    m, p = real(matrices, "matrices"), _points(points)
    if m.ndim < 2 or m.shape[-2:] != (2, 2):
        raise RotationError(
            f"expected matrices of shape (…, 2, 2), found {m.shape}; R2 and reflection make them"
        )
    common_batch(matrices=m.shape[:-2], points=p.shape[:-1])
    m = m.astype(p.dtype, copy=False)
    x, y = p[..., 0], p[..., 1]
    with np.errstate(invalid="ignore", over="ignore"):
        rest = _poison(x, y)
        rows = [m[..., n, 0] * x + m[..., n, 1] * y + rest for n in (0, 1)]
    return np.stack(rows, axis=-1)


def rotate2(points: ArrayLike, psi: ArrayLike, *, degrees: bool = False) -> Floats:
    """Return the points (…, 2) rotated counterclockwise about the origin by ψ, broadcast (2.1).

    >>> rotate2(LETTER_T, 90, degrees=True)[0]
    array([-1., 10.])
    """
    return transform(R2(_precise(psi), degrees=degrees), points)


def reflect2(points: ArrayLike, theta: ArrayLike, *, degrees: bool = False) -> Floats:
    """Return the points (…, 2) reflected in the line through the origin at the angle θ/2, broadcast.

    Examples
    --------
    >>> reflect2([1, 2], 180, degrees=True).round(15) + 0.0
    array([-1.,  2.])
    """
    return transform(reflection(_precise(theta), degrees=degrees), points)


def to_polar(points: ArrayLike) -> tuple[Floats, Floats]:
    """Return r and θ of the points (…, 2), θ in [−π, π] (2.1).

    θ is ``atan2(y, x)``, which is correct in all four quadrants and on the y axis, unlike the thesis's
    arctg(y/x), :func:`printed_angle`. The origin has r = θ = 0.
    """
    p = _points(points)
    x, y = p[..., 0], p[..., 1]
    with np.errstate(invalid="ignore"):
        rest = _poison(x, y)
    return np.hypot(x, y) + rest, np.arctan2(y, x) + rest


def from_polar(r: ArrayLike, theta: ArrayLike) -> Floats:
    """Return the points (r cos θ, r sin θ), shape (…, 2) (2.1); θ in radians."""
    r, theta = real(r, "radii"), _precise(theta)
    common_batch(radii=r.shape, angles=theta.shape)
    c, s = _cos_sin(theta)
    with np.errstate(invalid="ignore"):
        rest = _poison(r)
        return np.stack([r * c + rest, r * s + rest], axis=-1).astype(r.dtype, copy=False)


def printed_angle(points: ArrayLike) -> Floats:
    """Return arctg(y/x), which 2.1 and 2.1.3 print for θ; it is off by π if x < 0.

    For x = 0 the quotient does not exist; floats then give ±π/2 by the signs of their zeros, and NaN at the
    origin.
    """
    p = _points(points)
    with np.errstate(divide="ignore", invalid="ignore"):
        angles: Floats = np.arctan(p[..., 1] / p[..., 0])
    return angles


def to_complex(points: ArrayLike) -> Complexes:
    """Return x + iy for the points (x, y), shape (…) (2.1.3); float32 gives complex64."""
    p = np.ascontiguousarray(_points(points))
    return p.view(np.result_type(p.dtype, np.complex64))[..., 0]


def from_complex(z: ArrayLike) -> Floats:
    """Return the points (…, 2) of complex numbers (…); complex64 gives float32."""
    expect_unmasked(z, "z")
    a = np.asarray(z)
    if a.dtype not in (np.complex64, np.complex128):
        a = real(z, "z")
    return np.stack([a.real, a.imag], axis=-1)


def unit_complex(psi: ArrayLike, *, degrees: bool = False) -> Complexes:
    """Return e^{iψ} = cos ψ + i sin ψ, shape (…); multiplication by it is rotation by ψ (2.1.3)."""
    c, s = _cos_sin(psi, degrees)
    return to_complex(np.stack([c, s], axis=-1))


def signed_area(polygon: ArrayLike) -> Floats:
    """Return the areas of polygons (…, n, 2), n ≥ 3, by the shoelace formula; negative if clockwise.

    Coordinates are taken relative to the first corner, so that a polygon far from the origin loses no digits.
    Raises :class:`~rotation.errors.RotationError` for fewer than 3 corners.
    """
    p = _points(polygon)
    if p.ndim < 2 or p.shape[-2] < 3:
        raise RotationError(
            f"expected polygons of shape (…, n, 2) with n at least 3 corners, found {p.shape}"
        )
    with np.errstate(invalid="ignore", over="ignore"):
        x, y = np.moveaxis(p[..., 1:, :] - p[..., :1, :], -1, 0)
        cross = x[..., :-1] * y[..., 1:] - x[..., 1:] * y[..., :-1]
        return np.asarray(cross.sum(axis=-1) / 2)


def area(polygon: ArrayLike) -> Floats:
    """Return the areas of simple polygons (…, n, 2), without signs."""
    return np.abs(signed_area(polygon))


def orientation(polygon: ArrayLike) -> Floats:
    """Return +1 for counterclockwise polygons (…, n, 2), −1 for clockwise ones, 0 for area 0."""
    return np.sign(signed_area(polygon))


def _cos_sin(angles: ArrayLike, degrees: bool = False) -> tuple[Floats, Floats]:
    """Return cosines and sines; in degrees they are exact at multiples of 90."""
    with np.errstate(invalid="ignore"):  # inf gives NaN
        s, c = waves(NUMPY, real(angles, "angles"), degrees)
    return c, s


def _precise(angles: ArrayLike) -> Floats:
    """Return angles as float64, since the dtype of the result depends only on the points."""
    return real(angles, "angles").astype(np.float64, copy=False)


def _poison(*coordinates: Floats) -> Floats:
    """Return NaN where a coordinate is NaN or inf, else −0, which does not change sums."""
    return reduce(add, (np.abs(c) * c.dtype.type(-0.0) for c in coordinates))


def _matrix(a: Floats, b: Floats, c: Floats, d: Floats) -> Floats:
    entries: Floats = np.stack([a, b, c, d], axis=-1)
    return entries.reshape(*entries.shape[:-1], 2, 2)


def _points(points: ArrayLike) -> Floats:
    return components(points, 2, "points", "aos")
