"""Outlines of tops: check them, read them from a file, and simplify them."""

from collections.abc import Callable, Iterable
from itertools import pairwise
from math import inf
from pathlib import Path

import numpy as np

from anim.checks import real
from anim.errors import AnimationError
from hfield.tables import read_table

Profile = tuple[tuple[float, float], ...]
"""Pairs (radius, z) from the tip (0, 0) up to the axis again."""

MAX_OUTLINE_POINTS = 2000


def checked_outline(
    outline: Iterable[Iterable[float]], place: Callable[[int], str] | None = None
) -> Profile:
    """Return pairs ``(z, radius)`` as a profile that begins and ends on the axis, with the lowest point at 0.

    ``place`` returns the description of the point with an index, counted from 0. Raises
    :class:`~anim.errors.AnimationError` for fewer than two or more than 2000 points, anything but pairs of
    finite numbers, a negative radius, a decreasing height, an outline that touches the axis between its ends,
    and an outline without volume.
    """
    where = place or (lambda n: f"point {n + 1} of the outline")
    if isinstance(outline, str) or not isinstance(outline, Iterable):
        raise AnimationError(f"the outline is {outline!r}; expected pairs (z, radius)")
    pairs = [_pair(point, where(n)) for n, point in enumerate(outline)]
    if not 2 <= len(pairs) <= MAX_OUTLINE_POINTS:
        raise AnimationError(
            f"the outline has {len(pairs)} point{'s' * (len(pairs) != 1)}; expected 2 to "
            f"{MAX_OUTLINE_POINTS} pairs (z, radius)"
        )
    before = -inf
    for n, (z, radius) in enumerate(pairs):
        if radius < 0:
            raise AnimationError(f"{where(n)}: the radius is {radius:g}; expected 0 or more")
        if z < before:
            raise AnimationError(
                f"{where(n)}: z is {z:g}, below the {before:g} of the point before; heights rise from "
                "the tip up"
            )
        before = z
        if radius == 0 and 0 < n < len(pairs) - 1:
            raise AnimationError(
                f"{where(n)}: the radius is 0 between the ends, which would split the top; expected a "
                "positive radius"
            )
    start, end = pairs[0][0], pairs[-1][0]
    if not any(z1 > z0 and r0 + r1 > 0 for (z0, r0), (z1, r1) in pairwise(pairs)):
        raise AnimationError(
            "the outline encloses no volume: expected a positive radius and heights that rise"
        )
    profile = [(radius, z - start) for z, radius in pairs]
    if profile[0][0] > 0:
        profile.insert(0, (0.0, 0.0))
    if profile[-1][0] > 0:
        profile.append((0.0, end - start))
    # A repeated point would give a face without area.
    return tuple(p for n, p in enumerate(profile) if n == 0 or p != profile[n - 1])


def read_outline(path: str | Path) -> Profile:
    """Return the profile in a text file, with z and radius on each line in the same unit.

    Raises :class:`~hfield.errors.TableError` for a file that is not a table, and
    :class:`~anim.errors.AnimationError` for an invalid outline; both name the file and the line.
    """
    table = read_table(path, {2: "z and the radius"})
    return checked_outline(table.rows.tolist(), table.place)


def simplified(profile: Profile, tolerance: float) -> Profile:
    """Return the outline with as few points as stay within ``tolerance`` of it.

    D. Douglas and T. Peucker, "Algorithms for the reduction of the number of points", Cartographica 10, 1973.

    >>> simplified(((0, 0), (1, 1), (1.5, 1.501), (2, 2), (0, 3)), 0.01)
    ((0, 0), (2, 2), (0, 3))
    """
    points = np.array(profile)
    kept, parts = {0, len(points) - 1}, [(0, len(points) - 1)]
    while parts:
        first, last = parts.pop()
        if last - first < 2:
            continue
        chord = points[last] - points[first]
        inner = points[first + 1 : last] - points[first]
        square = float(chord @ chord)
        share = np.clip(inner @ chord / square, 0, 1) if square else np.zeros(len(inner))
        away = np.linalg.norm(inner - share[:, None] * chord, axis=1)
        worst = int(np.argmax(away))
        if away[worst] > tolerance:
            middle = first + 1 + worst
            kept.add(middle)
            parts += [(first, middle), (middle, last)]
    return tuple(profile[n] for n in sorted(kept))


def _pair(point: Iterable[float], where: str) -> tuple[float, float]:
    values = tuple(point) if isinstance(point, Iterable) and not isinstance(point, str) else ()
    if len(values) != 2:
        raise AnimationError(f"{where} is {point!r}; expected a pair (z, radius)")
    return real(f"{where}: z", values[0]), real(f"{where}: the radius", values[1])
