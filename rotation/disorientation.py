"""Find the rotation of least angle among those equivalent under two finite groups, with a rule for ties.

Let H be the intersection of the two groups. Every ``l·p·r`` is ``h·(l₀·p·r₀)·h⁻¹`` with h in H and one pair
(l₀, r₀) for each product r·l. The angle depends only on r·l, and h rotates only the axis. First h is chosen
to maximise x, then among the h that keep x. For two cubes there are 24, 6 and 4 candidates instead of 576.
For the few rows with ties all candidates are compared.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from rotation.array_types import Array, Namespace
from rotation.coordinates import Coordinates, join, split
from rotation.errors import DTypeError, RotationError
from rotation.namespaces import namespace
from rotation.quaternions import canonical, inverse, multiplied, normalised, product
from rotation.rowwise import RowFormula

TIE = 2.0**-40  # coordinates this near to each other count as equal
_SAME = 1e-9  # tolerance within which a product of group elements equals an element
_MAX_WRITTEN_MAPS = 160  # maps that are written out in one formula
_MAX_GROUP_ORDER = 240  # rotations of a group
_BLOCK = 2**21  # candidates that are in memory at once


class _Maps(NamedTuple):
    """Linear maps of quaternions, (k, 4, 4) by angle and (h, 4, 4) by axis, and the selection formula."""

    by_angle: Array
    by_axis: Array
    formula: RowFormula | None


def least(p: Array, left: Array, right: Array) -> Array:
    """Return, for unit quaternions (…, 4), the ``l·p·r`` of `Rotation.disorientation` with w ≥ 0.

    Raises
    ------
    RotationError
        ``left`` (m, 4) or ``right`` (n, 4) is not a group, or has more than 240 elements.
    """
    for group in (left, right):
        if not isinstance(group, np.ndarray):
            raise DTypeError(f"a group is a text or a Rotation, not a {type(group).__name__}")
        if group.ndim != 2:
            raise RotationError("a group is a list of rotations, of shape (n,)")
    maps = _maps(left.tobytes(), right.tobytes())
    flat = np.ascontiguousarray(p.reshape(-1, 4))
    if maps.formula is None:
        found, doubtful = flat.copy(), np.isfinite(flat[:, 0])
    else:
        both = maps.formula(flat)
        found, doubtful = np.ascontiguousarray(both[:, :4]), both[:, 4] != 0.0
    if doubtful.any():
        found[doubtful] = _among_all(flat[doubtful], maps)
    return found.reshape(p.shape)


@cache
def _maps(left: bytes, right: bytes) -> _Maps:
    first, second = (canonical(np.frombuffer(g).reshape(-1, 4)) for g in (left, right))
    for group in (first, second):
        _expect_group(group)
    common = first[(np.abs(first @ second.T) > 1.0 - _SAME).any(axis=1)]
    # r·l and (r·h)·(h⁻¹·l) are equal, so one l of each coset H·l suffices.
    classes = product(common[:, None, :], first[None, :, :])
    alike = (np.abs(classes @ first.T) > 1.0 - _SAME).any(axis=0)
    some = first[np.argmax(alike, axis=1) == np.arange(len(first))]
    by_angle = _map(some[:, None, :], second[None, :, :]).reshape(-1, 4, 4)
    by_axis = _map(common, inverse(common))
    if len(by_angle) + len(by_axis) > _MAX_WRITTEN_MAPS:
        return _Maps(by_angle, by_axis, None)
    x = by_axis[:, 1]
    keep = by_axis[np.abs(x - [0.0, 1.0, 0.0, 0.0]).max(axis=1) < _SAME]
    alike = np.abs(x[:, None] - x[None]).max(axis=2) < _SAME
    turn = by_axis[np.argmax(alike, axis=1) == np.arange(len(x))]
    formula = RowFormula(_chosen, (4,), parameters=((by_angle, turn, keep),))
    return _Maps(by_angle, by_axis, formula)


def _expect_group(q: Array) -> None:
    if len(q) > _MAX_GROUP_ORDER:
        raise RotationError(f"a group of {len(q)} rotations; at most {_MAX_GROUP_ORDER} are taken")
    products = product(q[:, None, :], q[None, :, :]).reshape(-1, 4)
    inside = np.abs(products @ q.T) > 1.0 - _SAME
    if not len(q) or not (inside.sum(axis=1) == 1).all():
        raise RotationError(
            f"the {len(q)} rotations are not a group: each product of two must be one of them, each of them "
            "once; Rotation.create_group makes some"
        )


def _map(left: Array, right: Array) -> Array:
    """Return the matrices (…, 4, 4) of ``p ↦ l·p·r``; entries near integers and half-integers are
    made exact.
    """
    columns = [
        np.stack(multiplied(multiplied(split(left), tuple(e)), split(right)), -1) for e in np.eye(4)
    ]
    found = np.stack(columns, axis=-1)
    neat = np.round(2.0 * found) / 2.0
    return np.where(np.abs(found - neat) < 4e-16, neat, found)


def _chosen(q: Array, stages: tuple[Array, ...]) -> Array:
    """Return five numbers of a row: the best quaternion, and a flag for near ties."""
    xp, best = namespace(q), split(q)
    doubtful = xp.zeros_like(best[0])
    for key, maps in enumerate(stages):
        best, doubt = _largest(xp, maps, best, key)
        doubtful = xp.where(doubt, xp.ones_like(doubtful), doubtful)
    return join(xp, (*best, doubtful))


def _largest(xp: Namespace, maps: Array, q: Coordinates, key: int) -> tuple[Coordinates, Array]:
    """Return the image of q with the largest coordinate ``key``, w ≥ 0, and a flag for near ties."""

    def image_by(m: Array) -> Coordinates:
        image = tuple(_sum(row, q) for row in m)
        if key == 0:
            back = image[0] < 0.0
            image = tuple(xp.where(back, -c, c) for c in image)
        return image

    first, *others = maps
    best = image_by(first)
    second: Array = xp.zeros_like(best[0]) - 2.0
    for m in others:
        image = image_by(m)
        better = image[key] > best[key]
        loser = xp.where(better, best[key], image[key])
        second = xp.where(loser > second, loser, second)
        best = tuple(xp.where(better, a, b) for a, b in zip(image, best, strict=True))
    doubt = second >= best[key] - TIE
    return best, doubt | (best[0] <= TIE) if key == 0 else doubt


def _sum(row: Array, q: Coordinates) -> Array:
    """Return the sum of the nonzero products."""
    pairs = [(float(a), c) for a, c in zip(row, q, strict=True) if a]
    terms = [a * c if abs(a) != 1.0 else (c if a > 0.0 else -c) for a, c in pairs]
    total = terms[0]
    for term in terms[1:]:
        total = total + term
    return total


def _among_all(p: Array, maps: _Maps) -> Array:
    """Return the best of all candidates (n, 4) with both signs, compared lexicographically."""
    every = (maps.by_axis[:, None] @ maps.by_angle[None]).reshape(-1, 4, 4)
    every = np.concatenate([every, -every])
    found = np.empty_like(p)
    step = max(1, _BLOCK // len(every))
    for start in range(0, len(p), step):
        images = np.moveaxis(every @ p[start : start + step].T, -1, 0)
        alive = np.ones(images.shape[:2], bool)
        for key in range(4):
            value = np.where(alive, images[..., key], -2.0)
            alive &= value >= value.max(axis=1, keepdims=True) - TIE
        rows = np.arange(len(images))
        found[start : start + step] = images[rows, np.argmax(alive, axis=1)]
    return normalised(found)
