"""Alignment: the rotation or rigid motion that maps one set of vectors or points closest to another."""

from __future__ import annotations

from typing import NamedTuple

from rotation.array_types import Array, ArrayLike
from rotation.averaging import mean_of_vectors
from rotation.errors import RotationError
from rotation.matrices import largest
from rotation.namespaces import certainly, floats, namespace, quiet, refuse_rows
from rotation.rotation import Rotation
from rotation.wahba import checked, checked_vectors, fitted


def align(
    source: ArrayLike, target: ArrayLike, weights: ArrayLike | None = None
) -> tuple[Rotation, Array]:
    """Return the rotation R with the least ``Σ w‖target − R·source‖²``, and the square root of that sum.

    If all pairs lie along one line (or there is a single pair), many rotations are optimal, and the one with
    the least angle is returned.

    Parameters
    ----------
    source, target : array_like, shape (…, N, 3), or (3,) for a single pair
        Vectors; their lengths act as additional weights.
    weights : array_like, shape (…, N), optional
        Not negative; a pair of weight 0 has no influence. One may be infinite: its pair is aligned
        exactly, and not counted in rssd.

    Returns
    -------
    rotation : Rotation, shape (…)
    rssd : array, shape (…)

    Raises
    ------
    RotationError
        Incompatible shapes, no vectors or only zero vectors, negative weights; or vectors that only a
        reflection aligns, so that several rotations are optimal.

    Examples
    --------
    >>> r, rssd = align([[1, 0, 0], [0, 1, 0]], [[0, 1, 0], [-1, 0, 0]])
    >>> r.as_rotvec(degrees=True).round(9) + 0.0, float(rssd.round(9))
    (array([ 0.,  0., 90.]), 0.0)
    """
    if weights is None:
        q, rssd = fitted(*checked_vectors(target, source, weights), None)
    else:
        q, rssd = fitted(*checked(target, source, weights))
    return Rotation._of(q), rssd


@quiet
def align_points(
    source: ArrayLike, target: ArrayLike, weights: ArrayLike | None = None
) -> tuple[Rotation, Array, Array]:
    """Return the rigid motion that brings points ``source`` closest to ``target``.

    Parameters and errors are those of `align`; here the points may lie anywhere.

    Returns
    -------
    rotation : Rotation, shape (…)
    translation : array, shape (…, 3)
        ``rotation.apply(source) + translation`` is the best fit.
    rssd : array, shape (…)
        The root of the weighted sum of the squared distances that remain.

    Examples
    --------
    >>> r, t, rssd = align_points([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 1, 1], [2, 1, 1], [1, 2, 1]])
    >>> t.round(9), float(rssd.round(9))
    (array([1., 1., 1.]), 0.0)
    """
    a, b, w = checked(target, source, weights)
    xp = namespace(a)
    if certainly(xp.any(xp.isinf(w))):
        raise RotationError("an infinite weight is not supported here; give a finite one")
    refuse_rows(xp.all(w == 0.0, axis=-1), "the weights", "are all zero")
    # The differences of the largest floats overflow, so quarters of the numbers are subtracted.
    size = xp.maximum(largest(xp, a), largest(xp, b))
    one = xp.ones_like(size)
    f = xp.where(size > float(xp.finfo(a.dtype).max) / 8.0, 0.25 * one, one)
    a, b = f * a, f * b
    to, fro = (mean_of_vectors(v, w, (-2,)) for v in (a, b))
    q, rssd = fitted(a - to[..., None, :], b - fro[..., None, :], w)
    rotation = Rotation._of(q)
    return rotation, (to - rotation.apply(fro)) / f[..., 0], rssd / f[..., 0, 0]


class Similarity(NamedTuple):
    """The map ``v ↦ scale·R·v + translation`` with arrays of shapes (…), (…), (…, 3), and the residual (…).

    Examples
    --------
    >>> twice = align_similarity([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 0, 0], [2, 0, 0], [0, 2, 0]])
    >>> twice.scale.round(9), twice.apply([1, 1, 0]).round(9)
    (np.float64(2.0), array([2., 2., 0.]))
    """

    rotation: Rotation
    scale: Array
    translation: Array
    rssd: Array

    def apply(self, points: ArrayLike) -> Array:
        """Return the images of points (…, 3); the batch shapes broadcast."""
        v = self.rotation.apply(floats(points, "points", namespace(self.scale, points)))
        return self.scale[..., None] * v + self.translation


@quiet
def align_similarity(
    source: ArrayLike, target: ArrayLike, weights: ArrayLike | None = None
) -> Similarity:
    """Return the similarity with positive scale that brings points ``source`` closest to ``target``.

    S. Umeyama, "Least-squares estimation of transformation parameters between two point patterns", IEEE
    Trans. PAMI 13 (1991). Parameters and errors are those of `align_points`. A `RotationError` is also raised
    if all source points coincide, or if the best scale would be 0.

    Returns
    -------
    Similarity
        ``rotation``, ``scale``, ``translation``, and ``rssd``, the root of the weighted sum of the squared
        distances that remain.

    Examples
    --------
    >>> found = align_similarity([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 1, 1], [4, 1, 1], [1, 4, 1]])
    >>> found.scale.round(9), found.translation.round(9)
    (np.float64(3.0), array([1., 1., 1.]))
    """
    a, b, w = checked(target, source, weights)
    xp = namespace(a)
    rotation = align_points(b, a, w)[0]
    to, fro = (mean_of_vectors(v, w, (-2,)) for v in (a, b))
    turned = rotation[..., None].apply(b - fro[..., None, :])
    there = a - to[..., None, :]
    sizes = [largest(xp, v) for v in (turned, there, w[..., None])]
    one = xp.ones_like(sizes[0])
    u, v, share = (
        x / xp.where(n > 0.0, n, one)
        for x, n in zip((turned, there, w[..., None]), sizes, strict=True)
    )
    spread_out = xp.sum(share * u * u, axis=(-2, -1))
    common = xp.sum(share * u * v, axis=(-2, -1))
    refuse_rows(spread_out == 0.0, "the source", "has all its points in one place")
    refuse_rows(common <= 0.0, "the similarity", "would have no positive scale")
    scale = common / spread_out * (sizes[1] / sizes[0])[..., 0, 0]
    rests = there - scale[..., None, None] * turned
    rssd = xp.sqrt(xp.sum(w[..., None] * rests * rests, axis=(-2, -1)))
    return Similarity(rotation, scale, to - scale[..., None] * rotation.apply(fro), rssd)
