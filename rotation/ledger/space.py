"""Sections 2.2.1 to 2.2.3: the three axes, their rotations, and that the order matters."""

from rotation.ledger.entries import (
    Matrix,
    negative,
)


def about_x(c: str, s: str) -> Matrix:
    """Return R_x for the angle whose point is (c, s), as printed."""
    return (("1", "0", "0"), ("0", c, negative(s)), ("0", s, c))


def about_y(c: str, s: str) -> Matrix:
    """Return R_y for the angle whose point is (c, s), as printed."""
    return ((c, "0", s), ("0", "1", "0"), (negative(s), "0", c))


def about_z(c: str, s: str) -> Matrix:
    """Return R_z for the angle whose point is (c, s), as printed."""
    return ((c, negative(s), "0"), (s, c, "0"), ("0", "0", "1"))
