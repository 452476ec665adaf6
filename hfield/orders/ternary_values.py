"""Find vectors at which an indefinite ternary form has a given value and a definite form is small.

Two coordinates are enumerated, in arrays, and the third is a root of a quadratic equation.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isqrt

import numpy as np

from hfield.errors import TooLargeError

Matrix = list[list[int]]
MAX_PAIRS = 10**8
"""At most about so many pairs of coordinates are enumerated."""
MAX_AREA_SQUARED = 4 * MAX_PAIRS**2 // 10
"""The number of pairs and their negatives is about the area of an ellipse; its square, with 10 for π²."""
MAX_ARRAY = 2**18
"""So many pairs are in one array."""
MAX_INT64 = 2**61


def vectors_of_value(
    form: Matrix, value: int, definite: Matrix, bound: int
) -> Iterator[tuple[int, int, int]]:
    """Yield one of ±x for each x with ``x·form·x = value`` and ``x·definite·x ≤ bound``.

    ``form`` must have a nonzero diagonal entry, and ``value`` must not be 0. Raises :class:`TooLargeError`.
    """
    # the equation is solved for the coordinate with the widest range
    k = min((n for n in range(3) if form[n][n]), key=lambda n: definite[n][n])
    i, j = (n for n in range(3) if n != k)
    # with the least value over the coordinate k: head·definite is at least p·x² + 2q·xy + r·y²
    head = definite[k][k]
    p, q, r = (
        head * definite[m][n] - definite[k][m] * definite[k][n] for m, n in ((i, i), (i, j), (j, j))
    )
    limit, minor = head * bound, p * r - q * q
    if limit**2 > MAX_AREA_SQUARED * minor:
        raise TooLargeError(f"more than {MAX_PAIRS} elements would be enumerated")
    most = (isqrt(limit * r // minor) + 1, isqrt(limit * p // minor) + 1)
    kind = np.int64 if _fits(form, value, most, (i, j, k)) else object
    step = max(1, MAX_ARRAY // (2 * most[0] + 3))
    for first in range(0, most[1] + 1, step):
        heights = np.arange(first, min(first + step, most[1] + 1))
        # in floats, and so a little more than there is; the quotients are of numbers of any size
        half = np.sqrt(np.maximum(0.0, limit / p - minor / p**2 * heights.astype(float) ** 2))
        middle = -(q / p) * heights
        half = half + 1e-9 * (1 + abs(middle))
        low = np.where(heights == 0, 0, np.ceil(middle - half)).astype(np.int64)
        number = np.maximum(0, np.floor(middle + half).astype(np.int64) - low + 1)
        starts = np.cumsum(number) - number
        x = np.arange(int(number.sum())) + np.repeat(low - starts, number)
        y = np.repeat(heights, number)
        for found in _solved(form, value, x.astype(kind), y.astype(kind), (i, j, k)):
            size = sum(definite[m][n] * found[m] * found[n] for m in range(3) for n in range(3))
            if size <= bound and (found[j] or found[i] or found[k] > 0):
                yield found


def _solved(
    form: Matrix, value: int, x: np.ndarray, y: np.ndarray, places: tuple[int, int, int]
) -> Iterator[tuple[int, int, int]]:
    """Yield the vectors with coordinates x and y (arrays) at positions i and j, and a root at position k."""
    i, j, k = places
    a, b = form[k][k], form[k][i] * x + form[k][j] * y
    c = form[i][i] * x * x + 2 * form[i][j] * x * y + form[j][j] * y * y - value
    square = b * b - a * c
    if square.dtype == object:
        roots = np.array([isqrt(s) if s >= 0 else -1 for s in square], dtype=object)
    else:
        roots = np.rint(np.sqrt(np.maximum(square, 0).astype(float))).astype(np.int64)
    for n in np.flatnonzero(roots * roots == square).tolist():
        for root in {int(roots[n]), -int(roots[n])}:
            z, rest = divmod(root - int(b[n]), a)
            if not rest:
                found = [0, 0, 0]
                found[i], found[j], found[k] = int(x[n]), int(y[n]), z
                yield (found[0], found[1], found[2])


def _fits(form: Matrix, value: int, most: tuple[int, int], places: tuple[int, int, int]) -> bool:
    """Return whether all intermediate numbers fit into 64 bits."""
    i, j, k = places
    x, y = most
    b = abs(form[k][i]) * x + abs(form[k][j]) * y
    c = abs(form[i][i]) * x * x + 2 * abs(form[i][j]) * x * y + abs(form[j][j]) * y * y + abs(value)
    return b * b + abs(form[k][k]) * c < MAX_INT64
