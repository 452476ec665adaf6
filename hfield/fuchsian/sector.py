"""Sectors of Dirichlet domains around a point that units fix.

The points nearer to such a point p than to its other images form a polygon that the stabiliser of p turns.
Modulo units, a sector of it is a domain: it lies between the lines from p to two corners, the first of which
a generator of the stabiliser, a rotation about 2π/m, maps to the other. Sides of the polygon are mapped to
sides by units that are known up to the stabiliser, and one of these maps a side of the sector to another.
"""

from __future__ import annotations

import cmath
import math

from hfield.algebra.quaternion import Quaternion
from hfield.fuchsian.plane import Plane, apply
from hfield.fuchsian.polygon import Polygon


class Sector(Polygon):
    """A sector of a polygon around the centre, given counterclockwise.

    Side 0 goes from the centre to a corner, and the last side goes back: ``rotation`` maps the first to the
    last. The sides between them are those of the polygon, with ``units``.
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
        """Return the side that has the image of the centre under the inverse of a unit; None without one.

        The first and the last side are partners.
        """
        last = len(self.units) - 1
        return last - n if n in (0, last) else super().partner(n)


def sector(whole: Polygon, rotation: Quaternion, order: int) -> Sector | None:
    """Return a sector of a closed polygon, for a rotation about 2π/order around the centre.

    Return None where it does not map each side to the one that comes so many sides later, or where a unit
    does not map its side to a side.
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
    """Return the power of a generator of the stabiliser of the centre that turns by 2π/order."""
    powers = [stabiliser**n for n in range(1, order)]
    a = [_diagonal(plane, g) for g in powers]
    return min(zip(powers, a, strict=True), key=lambda pair: cmath.phase(pair[1] ** 2) % math.tau)[
        0
    ]


def _diagonal(plane: Plane, g: Quaternion) -> complex:
    """Return a where a unit that fixes the centre moves z to (a/conj(a))·z in the disc."""
    real, scalar = plane.order.real, plane.order.scalar
    # the part of trace 0 is a multiple of the centre
    return complex(
        real(scalar(g.trace())) / 2,
        math.sqrt(real(plane.norms[0])) * real(plane.vector(g - g.trace() / 2)[0]),
    )
