"""The rotation, or the rigid motion, that takes one set of vectors or points closest to another."""

from typing import Any

from rotation.averaging import mean_of_vectors
from rotation.errors import RotationError
from rotation.matrices import largest
from rotation.namespaces import Array, certainly, namespace, quiet, refuse_rows
from rotation.rotation import Rotation
from rotation.wahba import checked, fitted


def align(source: Any, target: Any, weights: Any = None) -> tuple[Rotation, Array]:
    """Return the rotation R with the least ``Σ w‖target − R·source‖²``, and the root of that sum.

    Where all pairs lie along one line, as a single pair does, many rotations are best, and the
    shortest of them is returned.

    Parameters
    ----------
    source, target : array_like, shape (…, N, 3), or (3,) for a single pair
        Vectors; their lengths weigh as well.
    weights : array_like, shape (…, N), optional
        Not negative. One may be infinite: its pair is aligned exactly, and not counted in rssd.

    Returns
    -------
    rotation : Rotation, shape (…)
    rssd : array, shape (…)

    Raises
    ------
    RotationError
        Shapes that do not fit, no vectors or nothing but zeros, negative weights; or vectors that
        a reflection would align, so that several rotations are best.

    Examples
    --------
    >>> r, rssd = align([[1, 0, 0], [0, 1, 0]], [[0, 1, 0], [-1, 0, 0]])
    >>> r.as_rotvec(degrees=True).round(9) + 0.0, float(rssd.round(9))
    (array([ 0.,  0., 90.]), 0.0)
    """
    q, rssd = fitted(*checked(target, source, weights))
    return Rotation._of(q), rssd


@quiet
def align_points(source: Any, target: Any, weights: Any = None) -> tuple[Rotation, Array, Array]:
    """Return the rigid motion that takes points ``source`` closest to ``target``.

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
        raise RotationError("an infinite weight would fix a point of the motion; give a finite one")
    refuse_rows(xp.all(w == 0.0, axis=-1), "the weights", "are all zero")
    # Differences of the largest floats are none: taken are those of quarters.
    size = xp.maximum(largest(xp, a), largest(xp, b))
    one = xp.ones_like(size)
    f = xp.where(size > float(xp.finfo(a.dtype).max) / 8.0, 0.25 * one, one)
    a, b = f * a, f * b
    to, fro = (mean_of_vectors(v, w, (-2,)) for v in (a, b))
    q, rssd = fitted(a - to[..., None, :], b - fro[..., None, :], w)
    rotation = Rotation._of(q)
    return rotation, (to - rotation.apply(fro)) / f[..., 0], rssd / f[..., 0, 0]
