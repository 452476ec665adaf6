"""Rotate points in plain numpy: the fallback without LLVM, and the reference in tests of compiled kernels.

Arrays have their components last and broadcast. Nothing is blocked, threaded or tuned.
"""

import numpy as np

from hfield.core.product import Constants, multiply
from rotation.angles import waves
from rotation.array_types import NUMPY, Array

Name = tuple[str, *tuple[bool | tuple[int, ...], ...]]  # of a kernel, then its parameters

HAMILTON = Constants(-1.0, 0.0, -1.0)


def one(points: Array, matrix: Array) -> Array:
    """Return ``M·v`` for every point."""
    rotated: Array = points @ matrix.astype(points.dtype).T
    return rotated


def axis_angle(points: Array, axis: Array, angle: Array, degrees: bool = False) -> Array:
    """Return Rodrigues' formula v cos θ + (u × v) sin θ + u (u·v)(1 − cos θ), where u is the unit axis."""
    scaled = axis / np.max(np.abs(axis), axis=-1, keepdims=True)
    unit = scaled / np.linalg.norm(scaled, axis=-1, keepdims=True)
    sine, cosine = (wave[..., None] for wave in waves(NUMPY, angle, degrees))
    along = np.sum(unit * points, axis=-1, keepdims=True)
    turned = np.cross(unit, points) * sine + (unit * along - points) * (1 - cosine)
    rotated: Array = points + turned
    return rotated


def quaternions(points: Array, q: Array) -> Array:
    """Return v + 2(w (u × v) + u × (u × v))/|q|² for q = (w, u) of any length."""
    scaled = q / np.max(np.abs(q), axis=-1, keepdims=True)
    w, u = scaled[..., :1], scaled[..., 1:]
    cross = np.cross(u, points)
    factor = 2 / np.sum(scaled * scaled, axis=-1, keepdims=True)
    rotated: Array = points + factor * (w * cross + np.cross(u, cross))
    return rotated


def euler(
    points: Array, angles: Array, axes: tuple[int, ...], backward: bool, degrees: bool = False
) -> Array:
    """Return the points rotated about the axes one after another, beginning with the last angle if
    ``backward``.
    """
    turns = np.moveaxis(angles, -1, 0)[:: -1 if backward else 1]
    for axis, angle in zip(axes, turns, strict=True):
        points = axis_angle(points, np.eye(3)[axis], angle, degrees)
    return points


def cumulative(q: Array) -> Array:
    """Return the running products, each new factor on the left, each normalised."""
    products = np.empty_like(q)
    running = np.array([1.0, 0.0, 0.0, 0.0])
    for n, factor in enumerate(q / np.max(np.abs(q), axis=-1, keepdims=True, initial=0.0)):
        running = np.stack(multiply(HAMILTON, tuple(factor), tuple(running)))
        running = running / np.linalg.norm(running)
        products[n] = running
    return products


def run(name: Name, read: tuple[Array, ...], out: Array | None) -> bool:
    """Apply the numpy version of the kernel ``name`` to operands; return the same flag as the compiled
    kernel.
    """
    if out is None:
        return _contains_zero(read[0])
    v, *parameters = (a.astype(np.float64) for a in read)
    with np.errstate(all="ignore"):
        match name:
            case ("one",):
                turned = one(v, parameters[0].reshape(3, 3))
            case ("axis_angle", bool(degrees), _):
                turned = axis_angle(v, parameters[0], parameters[1][..., 0], degrees)
            case ("euler", tuple(axes), bool(backward), bool(degrees)):
                turned = euler(v, parameters[0], axes, backward, degrees)
            case _:
                turned = quaternions(v, parameters[0])
        out[...] = turned + 0.0 * np.sum(v, axis=-1, keepdims=True)  # inf gives NaN, as in kernels
    return name[0] in ("axis_angle", "quaternions") and _contains_zero(read[1])


def _contains_zero(array: Array) -> bool:
    return not bool(array.any(axis=-1).all())
