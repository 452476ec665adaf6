"""The images of a Dirichlet domain that tile the disc, chosen exactly and drawn with floats."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hfield.fuchsian.search import Sight

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from hfield.fuchsian.group import Domain

SMALLEST = 0.012
"""Images of a smaller diameter in the unit disc are left out."""
MAX_TILES = 5000
"""So many images are drawn at most; a few hundred are larger than the smallest."""


@dataclass(frozen=True)
class Tile:
    """The image of the domain under a unit g, and the value that determines its colour."""

    row: tuple[int, ...]
    """The coordinates of g with respect to the basis of the order; of g and −g those that begin positive."""
    a: complex
    b: complex
    """g moves z of the disc to (a·z + b)/(conj(b)·z + conj(a))."""
    first: int
    """The first side of a shortest word for g."""
    length: int
    """How many sides such a word has."""
    size: float
    """The greater of width and height in the unit disc."""


def move(a: complex, b: complex, points: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Return the images of complex numbers of the disc."""
    images: NDArray[np.complex128] = (a * points + b) / (np.conj(b) * points + np.conj(a))
    return images


def tessellation(domain: Domain, depth: int | None = None) -> list[Tile]:
    """Return the visible images of a domain, except the domain itself, in order of word length.

    Visible images are those larger than SMALLEST that are reached across sides of visible images, by words of
    up to ``depth`` sides. Two images are the same if their units are equal up to sign, which integer
    coordinates decide.
    """
    plane, units = domain.polygon.plane, domain.polygon.units
    sight, order = Sight(plane), plane.order
    rows = order.rows(units)
    # Whole numbers of Python: the coordinates of far images do not overflow.
    right = np.einsum("nj,ijk->nik", np.array(rows, object), sight.products.astype(object))
    steps = list(zip(*(x.tolist() for x in sight.motions(np.array(rows, float))), strict=True))
    corners = np.array(domain.vertices)
    (one,) = order.rows([order.algebra(1)])
    seen = {_up_to_sign(one)}
    found: list[Tile] = []
    queue = deque([Tile(_up_to_sign(one), 1, 0, -1, 0, 2.0)])
    while queue and len(found) < MAX_TILES:
        tile = queue.popleft()
        if depth is not None and tile.length >= depth:
            break
        images = np.array(tile.row, object) @ right
        for n, image in enumerate(images.tolist()):
            key = _up_to_sign(image)
            if key in seen:
                continue
            seen.add(key)
            a, b = _times((tile.a, tile.b), steps[n])
            points = move(a, b, corners)
            size = float(max(np.ptp(points.real), np.ptp(points.imag)))
            if size >= SMALLEST and len(found) < MAX_TILES:
                first = n if tile.length == 0 else tile.first
                found.append(Tile(key, a, b, first, tile.length + 1, size))
                queue.append(found[-1])
    return found


def _up_to_sign(row: list[int]) -> tuple[int, ...]:
    """Return a row or its negative, with a positive first nonzero entry."""
    lead = next(x for x in row if x)
    return tuple(row) if lead > 0 else tuple(-x for x in row)


def _times(g: tuple[complex, complex], h: tuple[complex, complex]) -> tuple[complex, complex]:
    """Return the motion h followed by g, scaled to determinant 1."""
    (a, b), (c, d) = g, h
    p, q = a * c + b * d.conjugate(), a * d + b * c.conjugate()
    size = abs(abs(p) ** 2 - abs(q) ** 2) ** 0.5
    return p / size, q / size
