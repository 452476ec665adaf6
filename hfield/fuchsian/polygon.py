"""Convex polygons in the hyperbolic plane, as the points where some forms are ≥ 0, exactly.

In Klein's model lines are straight. Since every form is positive at the centre, the forms ``1 +
y·u + z·v`` are
points (y, z) of a dual plane, and those that bound the polygon are the corners of their convex hull.
"""

from __future__ import annotations

from collections.abc import Mapping

from flint import arb, ctx, fmpq

from hfield.errors import UndecidedError
from hfield.fuchsian.plane import Plane, Vector, meeting


def bounding(forms: Mapping[Vector, Vector]) -> list[Vector]:
    """Return the keys of the forms that bound the polygon, counterclockwise; three or more forms."""
    points = {key: (f[1] / f[0], f[2] / f[0]) for key, f in forms.items()}
    order = sorted(points, key=points.__getitem__)
    hull: list[Vector] = []
    for sweep in (order, order[::-1]):
        start = len(hull)
        for key in sweep:
            while len(hull) >= start + 2 and not _left(*(points[k] for k in (*hull[-2:], key))):
                hull.pop()
            hull.append(key)
        hull.pop()
    return hull


def _left(a: tuple[fmpq, fmpq], b: tuple[fmpq, fmpq], c: tuple[fmpq, fmpq]) -> bool:
    return bool((b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]))


def corners(sides: list[Vector]) -> list[Vector]:
    """Return where each side begins, counterclockwise; sides are forms."""
    return [meeting(sides[n - 1], side) for n, side in enumerate(sides)]


def turns(plane: Plane, angles: list[tuple[Vector, Vector]], order: int) -> int:
    """Return k where the angles between pairs of lines, multiples of 2π/order in sum, are 2πk/order.

    The sum is computed in balls, with as many digits as single out k.
    """
    before = ctx.prec
    try:
        for ctx.prec in (64, 128, 256, 512, 1024, 4096):
            total = sum((_angle(plane, f, g) for f, g in angles), arb(0))
            k = (order * total / (2 * arb.pi())).unique_fmpz()
            if k is not None:
                return int(k)
    finally:
        ctx.prec = before
    raise UndecidedError("4096 bits do not tell the angle at a vertex of the domain")


def _angle(plane: Plane, f: Vector, g: Vector) -> arb:
    """Return the angle inside the polygon between two sides that meet."""

    def product(x: Vector, y: Vector) -> fmpq:  # of forms: that of their normals, positive on lines
        return -sum((a * b / n for a, b, n in zip(x, y, plane.norms, strict=True)), fmpq(0))

    cosine = -product(f, g)
    # from the sine as well, since an arc cosine near 1 is uncertain
    square = product(f, f) * product(g, g)
    sine = arb(square - cosine * cosine).sqrt()
    return arb.atan2(sine, arb(cosine))
