"""Sections 2.2.1 to 2.2.3: the three axes, rotations about them, and that their order matters."""

from hfield.syntax import Node
from rotation.ledger.entries import ONE, ZERO, Matrix, negative


def about_x(c: Node, s: Node) -> Matrix:
    """Return R_x for the angle given by the point (c, s), as printed."""
    return ((ONE, ZERO, ZERO), (ZERO, c, negative(s)), (ZERO, s, c))


def about_y(c: Node, s: Node) -> Matrix:
    """Return R_y for the angle given by the point (c, s), as printed."""
    return ((c, ZERO, s), (ZERO, ONE, ZERO), (negative(s), ZERO, c))


def about_z(c: Node, s: Node) -> Matrix:
    """Return R_z for the angle given by the point (c, s), as printed."""
    return ((c, negative(s), ZERO), (s, c, ZERO), (ZERO, ZERO, ONE))
