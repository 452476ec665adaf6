"""Polygons around the centre of a plane, in exact arithmetic: sides, corners, angles."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from flint import arb

from hfield.algebra.quaternion import Quaternion
from hfield.errors import UndecidedError
from hfield.fields.base.balls import precision
from hfield.fuchsian.plane import CENTER, Motion, Plane, Vector, apply, dot, meeting
from hfield.orders.base_values import BaseNumber


class Polygon:
    """The points nearer to the centre c than to images ``g·c``, for several g listed counterclockwise.

    ``images[n]`` is ``g·c`` for ``units[n]``. Side n is the line halfway to ``images[n]``, on which
    ``forms[n]`` is 0; it goes from ``starts[n]`` to ``ends[n]``.
    """

    def __init__(self, plane: Plane, units: Sequence[Quaternion]) -> None:
        self.plane, self.units = plane, list(units)
        self.images = [plane.image(g) for g in units]
        self.forms = [plane.halfway(x) for x in self.images]
        self.starts = [meeting(self.forms[n - 1], form) for n, form in enumerate(self.forms)]
        self.ends = [*self.starts[1:], *self.starts[:1]]
        self._motions: dict[int, Motion] = {}

    def __eq__(self, other: object) -> bool:
        """Return whether two polygons have one centre and the same units."""
        return (
            isinstance(other, Polygon)
            and self.plane.center == other.plane.center
            and self.units == other.units
        )

    def __hash__(self) -> int:
        return hash((self.plane.center, *self.units))

    @cached_property
    def _places(self) -> dict[Vector, int]:
        return {x: n for n, x in enumerate(self.images)}

    def partner(self, n: int) -> int | None:
        """Return the side that belongs to the image of the centre under the inverse of unit n; None without
        one.
        """
        return self._places.get(self.plane.image(self.units[n].conjugate()))

    def without_points(self) -> Polygon:
        """Return the polygon without the sides that meet it only in a corner."""
        count = len(self.forms)
        ends = [self.units[n] for n in range(count) if dot(self.forms[n - 1], self.ends[n]) != 0]
        return self if len(ends) == count else Polygon(self.plane, ends)

    def is_closed(self) -> bool:
        """Return whether the sides, in order, bound the polygon once around, with points or cusps as corners.

        The forms f, positive at the centre, are the points (f₁/f₀, f₂/f₀) of a dual plane. These are the
        corners of a convex polygon around 0 if and only if the path turns left at each corner, also as seen
        from 0, and winds around 0 once.
        """
        sign, count = self.plane.order.sign, len(self.forms)
        lower = [sign(form[2]) < 0 for form in self.forms]
        return (
            count > 2
            and sum(lower[n - 1] and not lower[n] for n in range(count)) == 1
            and all(sign(x[0]) > 0 and sign(self.plane.norm(x)) >= 0 for x in self.starts)
            and all(sign(dot(self.forms[n - 2], x)) > 0 for n, x in enumerate(self.starts))
        )

    def back(self, n: int) -> Motion:
        """Return the motion of the inverse of unit n."""
        if n not in self._motions:
            self._motions[n] = self.plane.motion(self.units[n].conjugate())
        return self._motions[n]

    @cached_property
    def _floats(self) -> list[tuple[float, float, float]]:
        real = self.plane.order.real
        return [(real(a), real(b), real(c)) for a, b, c in self.forms]

    def beyond(self, x: Vector) -> int | None:
        """Return a side that separates a point from the polygon, about the best one; None for a
        point inside.
        """
        sign, real = self.plane.order.sign, self.plane.order.real
        a, b, c = map(real, x)
        likely = [f[0] * a + f[1] * b + f[2] * c for f in self._floats]
        # floats determine the order of the search; the sign is exact
        for n in sorted(range(len(likely)), key=likely.__getitem__):
            if sign(dot(self.forms[n], x)) < 0:
                return n
        return None

    def reduced(self, x: Vector) -> tuple[Vector, list[int]]:
        """Move a point into the polygon by inverses of units; return it and the indices of these units."""
        path: list[int] = []
        while x != CENTER and (n := self.beyond(x)) is not None:
            path.append(n)
            x = apply(self.back(n), x)
        return x, path

    def turns(self, corners: Sequence[int], order: int) -> int:
        """Return k if the angles at these corners sum to 2πk/order; the sum is a multiple of 2π/order.

        The sum is computed in balls, with enough digits to determine k.
        """
        for bits in (64, 128, 256, 512, 1024, 4096):
            with precision(bits):
                total = sum((self._angle(n) for n in corners), arb(0))
                k = (order * total / (2 * arb.pi())).unique_fmpz()
            if k is not None:
                return int(k)
        raise UndecidedError("4096 bits do not determine the angle at a vertex of the domain")

    def _angle(self, n: int) -> arb:
        """Return the angle inside the polygon at the start of side n."""
        f, g, norms, ball = (
            self.forms[n - 1],
            self.forms[n],
            self.plane.norms,
            self.plane.order.ball,
        )

        def product(x: Vector, y: Vector) -> BaseNumber:
            """Return the product of the normals of forms, which is positive on lines."""
            return -(x[0] * y[0] / norms[0] + x[1] * y[1] / norms[1] + x[2] * y[2] / norms[2])

        cosine = product(f, g)
        # from the sine as well, since an arc cosine near 1 is uncertain
        sine = ball(product(f, f) * product(g, g) - cosine * cosine).sqrt()
        return arb.atan2(sine, -ball(cosine))
