"""Arrays as tuples of coordinates, and lengths that neither overflow nor underflow."""

from collections.abc import Iterable, Sequence
from functools import reduce
from operator import add

import numpy as np

from rotation.array_types import NUMPY, Array, Namespace
from rotation.namespaces import finfo

Coordinates = tuple[Array, ...]


def split(array: Array) -> Coordinates:
    """Return the coordinates along the last axis, as views: ``(x[…, 0], x[…, 1], …)``."""
    return tuple(array[..., n] for n in range(array.shape[-1]))


def join(xp: Namespace, coordinates: Coordinates) -> Array:
    """Return the array whose last axis contains ``coordinates``, after broadcasting them."""
    if xp is NUMPY and isinstance(coordinates[0], np.ndarray):
        joined = np.empty(
            (*np.broadcast_shapes(*map(np.shape, coordinates)), len(coordinates)),
            coordinates[0].dtype,
        )
        for n, c in enumerate(coordinates):
            joined[..., n] = c
        return joined
    return xp.stack(xp.broadcast_arrays(*coordinates), axis=-1)


# By the bits of a float: a power of two that moves numbers that are too small or too large for
# squaring into the middle of the range, without rounding.
STEP = {64: 2.0**600, 32: 2.0**98}


def factor(xp: Namespace, coordinates: Coordinates) -> Array:
    """Return the power of two by which to multiply before squaring: 1 if squares are safe."""
    largest = xp.abs(coordinates[0])
    for c in coordinates[1:]:
        largest = xp.maximum(largest, xp.abs(c))
    info = finfo(xp, largest)
    low = float(info.smallest_normal) ** 0.5 / float(info.eps)
    high = float(info.max) ** 0.5 / 4.0
    one, step = xp.ones_like(largest), STEP[info.bits]
    return xp.where(largest < low, step * one, xp.where(largest > high, (1.0 / step) * one, one))


def backwards(xp: Namespace, f: Array) -> Array:
    """Return ``1/f`` for a result f of `factor`, without a slow division."""
    one, step = xp.ones_like(f), STEP[finfo(xp, f).bits]
    return xp.where(f > 1.0, (1.0 / step) * one, xp.where(f < 1.0, step * one, one))


def polynomial(coefficients: Sequence[float], t: Array) -> Array:
    """Return ``Σ coefficients[k]·tᵏ``, with at least two terms, by Horner's scheme."""
    total = coefficients[-2] + coefficients[-1] * t
    for c in reversed(coefficients[:-2]):
        total = total * t + c
    return total


def middling(xp: Namespace, coordinates: Coordinates) -> Coordinates:
    """Return the coordinates times a power of two such that products are safe: the largest is 2⁻²⁰⁰
    to 2²¹⁰.
    """
    f = factor(xp, coordinates)
    scaled = tuple(f * c for c in coordinates)
    largest = reduce(xp.maximum, (xp.abs(c) for c in scaled))
    one = xp.ones_like(largest)
    g = xp.where(
        largest > 2.0**200, 2.0**-300 * one, xp.where(largest < 2.0**-200, 2.0**300 * one, one)
    )
    return tuple(g * c for c in scaled)


def length(xp: Namespace, coordinates: Coordinates) -> Array:
    """Return the Euclidean length, accurate from the smallest float up to half the largest."""
    f = factor(xp, coordinates)
    return root(xp, sum_of_squares([f * c for c in coordinates])) / f


def root(xp: Namespace, square: Array) -> Array:
    """Return the square root, with derivative 0 at 0."""
    zero = square == 0.0
    return xp.where(zero, square, xp.sqrt(xp.where(zero, xp.ones_like(square), square)))


def unit(xp: Namespace, coordinates: Coordinates) -> Coordinates:
    """Return the coordinates divided by their length; NaN if the length is 0 or a coordinate is not
    finite.
    """
    f = factor(xp, coordinates)
    scaled = tuple(f * c for c in coordinates)
    n = xp.sqrt(sum_of_squares(scaled)) + poison(coordinates)
    return tuple(c / n for c in scaled)


def poison(coordinates: Coordinates) -> Array:
    """Return 0 for rows of finite coordinates and NaN for other rows, for adding to results."""
    return reduce(add, (0.0 * c for c in coordinates))


def unchanging(xp: Namespace, coordinates: Coordinates) -> Array:
    """Return −0, which does not change sums, for rows of finite coordinates, and NaN for all other rows."""
    return reduce(add, (-0.0 * xp.abs(c) for c in coordinates))


def sum_of_squares(coordinates: Iterable[Array]) -> Array:
    """Return ``Σ c²``."""
    return reduce(add, (c * c for c in coordinates))
