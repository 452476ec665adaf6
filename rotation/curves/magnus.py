"""Integrate an angular velocity over an interval by the Magnus series, to order 4.

There are two quadrature rules, Gauss–Legendre and Simpson, whose difference estimates the error. A. Iserles,
H. Z. Munthe-Kaas, S. P. Nørsett and A. Zanna, "Lie-group methods", Acta Numerica 9 (2000).
"""

import math
from collections.abc import Callable

import numpy as np

from rotation.array_types import Array
from rotation.coordinates import join, length, split
from rotation.errors import RotationError
from rotation.namespaces import namespace, quiet
from rotation.vectors import cross

GAUSS = (0.5 - math.sqrt(3.0) / 6.0, 0.5 + math.sqrt(3.0) / 6.0)
# Simpson's end points are moved into the interval by this fraction of it, because a jump at an end
# belongs to no interval.
_NEAR = 2.0**-30
_SIMPSON = (_NEAR, 0.5, 1.0 - _NEAR)
_AT_LEAST, _AT_MOST = 16, 16_384  # pieces of all intervals; of each, taken together
# If the velocity jumps, the error of the first rule is at most 1.27 times its difference from the
# second, wherever the jump is; if it is smooth, at most 0.4 times.
_SAFELY = 1.5

Values = Callable[[Array], Array]  # from times (n,) to angular velocities (n, …, 3)


@quiet
def by_gauss(first: Array, second: Array, steps: Array, frame: str) -> Array:
    """Return rotation vectors (n, …, 3) of intervals (n,), given the angular velocities at the
    Gauss points.
    """
    h = _column(steps, first)
    first, second = h * first, h * second  # turns, which may be squared
    bend = (math.sqrt(3.0) / 12.0) * _crossed(first, second - first)
    return 0.5 * (first + second) + _sign(frame) * bend


def _by_simpson(start: Array, middle: Array, end: Array, steps: Array, frame: str) -> Array:
    h = _column(steps, start)
    start, middle, end = h * start, h * middle, h * end
    total = start + 4.0 * middle + end
    bend = (1.0 / 72.0) * _crossed(total, end - start)
    return total / 6.0 + _sign(frame) * bend


def _sign(frame: str) -> float:
    """Return the sign of the commutator: in body axes the order of all products is reversed."""
    return 1.0 if frame == "body" else -1.0


def _column(steps: Array, like: Array) -> Array:
    return namespace(steps).reshape(steps, (-1, *(1,) * (like.ndim - 1)))


def _crossed(a: Array, b: Array) -> Array:
    return join(namespace(a, b), cross(split(a), split(b)))


def refined(values: Values, times: Array, frame: str, tolerance: float) -> tuple[Array, list[int]]:
    """Return refined times such that the error is small, and the indices of the given times.

    A piece of an interval is halved if the two rules disagree, until the sum of all differences, which bounds
    the error, is below the tolerance.

    Raises
    ------
    RotationError
        Too many pieces are needed, or pieces shorter than floats can represent.
    """
    xp = namespace(times)
    number = times.shape[0] - 1
    if not number:
        return times, [0]
    each = -(-_AT_LEAST // number)
    row, start = np.divmod(np.arange(number * each), each)
    start, share = start / each, np.full(number * each, 1.0 / each)
    errors = _differences(values, times, frame, row, start, share)
    shortest = 64.0 * float(xp.finfo(times.dtype).eps) * float(xp.max(xp.abs(times)))
    while _SAFELY * errors.sum() > tolerance:
        bad = errors > 0.5 * tolerance / len(errors)
        half = 0.5 * share[bad]
        lengths = half * np.array([abs(float(times[k + 1] - times[k])) for k in row[bad]])
        if len(errors) + len(half) > _AT_MOST * number or lengths.min() < shortest:
            raise RotationError(
                f"the tolerance {tolerance:g} is not reached with {_AT_MOST} steps for each interval"
            )
        pieces = np.tile(row[bad], 2), np.append(start[bad], start[bad] + half), np.tile(half, 2)
        more = _differences(values, times, frame, *pieces)
        kept = (row[~bad], start[~bad], share[~bad])
        row, start, share = (np.append(a, b) for a, b in zip(kept, pieces, strict=True))
        errors = np.append(errors[~bad], more)
    order = np.lexsort((start, row))
    row, start = row[order], start[order]
    places = [*np.flatnonzero(start == 0.0).tolist(), len(row)]
    return xp.concat([_at(times, row, start), times[-1:]]), places


def _differences(
    values: Values, times: Array, frame: str, row: Array, start: Array, share: Array
) -> Array:
    """Return the maximal difference of the two rules on pieces of intervals, as numpy floats."""
    xp = namespace(times)
    points = [_at(times, row, start + share * node) for node in (*GAUSS, *_SIMPSON)]
    found = values(xp.concat(points))
    first, second, early, middle, late = (
        found[k * len(row) : (k + 1) * len(row), ...] for k in range(len(points))
    )
    steps = _at(times, row, start + share) - _at(times, row, start)
    if 0 in first.shape:
        return np.zeros(len(row))
    with np.errstate(all="ignore"):
        by_other = _by_simpson(early, middle, late, steps, frame)
        difference = by_gauss(first, second, steps, frame) - by_other
        sizes = xp.reshape(length(xp, split(difference)), (len(row), -1))
    return np.array([float(x) for x in xp.max(sizes, axis=-1)])


def _at(times: Array, row: Array, share: Array) -> Array:
    """Return the times at a fraction of the intervals; 0 is their start."""
    xp = namespace(times)
    begin, end = (xp.take(times, xp.asarray(n.tolist())) for n in (row, row + 1))
    found: Array = begin + (end - begin) * xp.asarray(share.tolist(), dtype=times.dtype)
    return found
