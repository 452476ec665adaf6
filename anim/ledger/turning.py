"""Rotate vectors of terms by angles whose cosine and sine are terms."""

from hfield.syntax import Node, names
from rotation.ledger.entries import (
    ONE,
    ZERO,
    Matrix,
    Vector,
    cross,
    difference,
    dot,
    identity,
    negative,
    plus,
    product,
    scaled,
)

UP: Vector = (ZERO, ZERO, ONE)


def axis(cosine: Node, sine: Node) -> Vector:
    """Return the axis (r·cos x, r·sin x, √(1 − r²)) of section 3.4.1, with y for r and z for the root."""
    y, z = names("y z")
    return product(cosine, y), product(sine, y), z


def turned(about: Vector, v: Vector, cosine: Node, sine: Node) -> Vector:
    """Return ``v`` rotated about a vector of length 1, by Rodrigues' formula."""
    along = scaled(product(difference(ONE, cosine), dot(about, v)), about)
    return plus(plus(scaled(cosine, v), scaled(sine, cross(about, v))), along)


def rotation(letter: str, cosine: Node, sine: Node) -> Matrix:
    """Return the matrix of the rotation about an axis of space, x, y or z."""
    rows = [list(row) for row in identity(3)]
    a, b = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[letter]
    rows[a][a] = rows[b][b] = cosine
    rows[a][b], rows[b][a] = negative(sine), sine
    return tuple(map(tuple, rows))
