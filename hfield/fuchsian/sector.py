"""Sectors of Dirichlet polygons around a point that units fix.

The points nearer to such a point p than to its other images form a polygon that is invariant under the
stabiliser of p. A sector of this polygon is a domain of the group. It lies between the lines from p to two
corners; a generator of the stabiliser, a rotation by 2π/m, maps the first corner to the second. Units map
sides of the polygon to sides. They are determined up to the stabiliser, and one choice maps a side of the
sector to another.
"""

from __future__ import annotations

import cmath
import math

from hfield.algebra.quaternion import Quaternion
from hfield.fuchsian.plane import Plane, apply
from hfield.fuchsian.polygon import Polygon


class Sector(Polygon):
    """A sector of a polygon around the centre, given counterclockwise.

    Side 0 goes from the centre to a corner, and the last side goes back; ``rotation`` maps the first to the
    last. The sides between them are sides of the polygon, with ``units``.
    """

    def __init__(self, whole: Polygon, rotation: Quaternion, units: list[Quaternion]) -> None:
        count = len(units)
        self.plane, self.units = whole.plane, [rotation.conjugate(), *units, rotation]
        self.images = [self.plane.image(g) for g in self.units]
        center, first, last = self.images[0], whole.starts[0], whole.ends[count - 1]
        # lines through the centre: the forms are positive to the left of the way out, and of the way back
        out, back = (center[1], -first[2], first[1]), (center[1], last[2], -last[1])
        self.forms = [out, *whole.forms[:count], back]
        self.starts = [center, *whole.starts[:count], last]
        self.ends = [*self.starts[1:], center]
        self._motions = {}

    def partner(self, n: int) -> int | None:
        """Return the side that belongs to the image of the centre under the inverse of unit n; None without
        one.

        The first and the last side are partners.
        """
        last = len(self.units) - 1
        return last - n if n in (0, last) else super().partner(n)


def sector(whole: Polygon, rotation: Quaternion, order: int) -> Sector | None:
    """Return a sector of a closed polygon, for a rotation by 2π/order around the centre.

    Return None if the rotation does not map each side to the side a fixed number of places later, or if some
    unit does not map its side to a side.
    """
    count, rest = divmod(len(whole.units), order)
    turn = whole.plane.motion(rotation)
    turned = [apply(turn, image) for image in whole.images]
    if rest or turned != [*whole.images[count:], *whole.images[:count]]:
        return None
    units = []
    for n, unit in enumerate(whole.units[:count]):
        partner = whole.partner(n)
        if partner is None:
            return None
        units.append(unit * rotation ** (partner // count))
    return Sector(whole, rotation, units)


def least_rotation(plane: Plane, stabiliser: Quaternion, order: int) -> Quaternion:
    """Return the power of a generator of the centre's stabiliser that turns by 2π/order."""
    powers = [stabiliser**n for n in range(1, order)]
    a = [_diagonal(plane, g) for g in powers]
    return min(zip(powers, a, strict=True), key=lambda pair: cmath.phase(pair[1] ** 2) % math.tau)[
        0
    ]


def _diagonal(plane: Plane, g: Quaternion) -> complex:
    """Return a for a unit that fixes the centre, which maps z in the disc to (a/conj(a))·z."""
    real, scalar = plane.order.real, plane.order.scalar
    # the part of trace 0 is a multiple of the centre
    return complex(
        real(scalar(g.trace())) / 2,
        math.sqrt(real(plane.norms[0])) * real(plane.vector(g - g.trace() / 2)[0]),
    )
