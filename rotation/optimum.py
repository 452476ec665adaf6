"""Find the unit quaternion that maximises ``qᵀ·K·q``, with finite derivatives.

Nearest rotations, means and best fits are all problems of this kind (P. Davenport's q-method). Derivatives
through singular values or eigenvectors are NaN if two values are equal, although the quaternion depends
smoothly on K. So the decomposition is computed on numbers without derivatives, followed by two steps of
Newton's method. These steps do not change the value, and give the first and second derivatives of the
solution.
"""

from collections.abc import Sequence
from importlib import import_module

from rotation.array_types import Array, Namespace
from rotation.coordinates import Coordinates, join, split, unit
from rotation.namespaces import namespace

Matrix = tuple[tuple[Array, ...], ...]


def is_differentiable(array: Array) -> bool:
    """Return whether the array's library supports derivatives."""
    return type(array).__module__.partition(".")[0] in ("torch", "jax", "jaxlib")


def without_derivatives(array: Array) -> Array:
    """Return the same numbers without derivatives."""
    if not is_differentiable(array):
        return array
    if hasattr(array, "detach"):
        detached: Array = array.detach()
        return detached
    stopped: Array = import_module("jax.lax").stop_gradient(array)
    return stopped


def davenport(m: Sequence[Sequence[Array]]) -> Matrix:
    """Return the rows of K for entries of matrices M: ``qᵀ·K·q`` is the trace of ``Rᵀ·M``."""
    (a, b, c), (d, e, f), (g, h, i) = m
    wx, wy, wz = h - f, c - g, d - b
    xy, xz, yz = b + d, c + g, f + h
    return (
        (a + e + i, wx, wy, wz),
        (wx, a - e - i, xy, xz),
        (wy, xy, e - a - i, yz),
        (wz, xz, yz, i - a - e),
    )


def with_derivatives(q: Array, k: Matrix) -> Array:
    """Return q (…, 4), which maximises ``qᵀ·K·q``, with its derivatives with respect to K."""
    if not any(is_differentiable(entry) for row in k for entry in row):
        return q
    c = split(without_derivatives(q))
    for _ in range(2):
        c = _newton(namespace(q), c, k)
    return join(namespace(q), c)


def _newton(xp: Namespace, q: Coordinates, k: Matrix) -> Coordinates:
    """Take a step in the three directions ``q·i``, ``q·j``, ``q·k``."""
    w, x, y, z = q
    ways = ((-x, w, z, -y), (-y, -z, w, x), (-z, y, -x, w))
    images = [_image(k, way) for way in ways]
    image = _image(k, q)
    value, slopes = _dot(q, image), [_dot(way, image) for way in ways]
    bend = [[-_dot(way, other) for other in images] for way in ways]
    for n in range(3):
        bend[n][n] = bend[n][n] + value
    step = _solved(bend, slopes)
    moved = tuple(
        c + (step[0] * e + (step[1] * f + step[2] * g)) for c, e, f, g in zip(q, *ways, strict=True)
    )
    return unit(xp, moved)


def _dot(a: Coordinates, b: Coordinates) -> Array:
    first, *others = (x * y for x, y in zip(a, b, strict=True))
    return sum(others, first)


def _image(k: Matrix, q: Coordinates) -> Coordinates:
    return tuple(_dot(row, q) for row in k)


def _solved(m: list[list[Array]], v: list[Array]) -> list[Array]:
    """Solve ``M·x = v`` by cofactors; a library's own solver may raise an error for a row with NaN."""
    (a, b, c), (d, e, f), (g, h, i) = m
    cofactors = (
        (e * i - f * h, c * h - b * i, b * f - c * e),
        (f * g - d * i, a * i - c * g, c * d - a * f),
        (d * h - e * g, b * g - a * h, a * e - b * d),
    )
    determinant = a * cofactors[0][0] + (b * cofactors[1][0] + c * cofactors[2][0])
    return [_dot(row, tuple(v)) / determinant for row in cofactors]
