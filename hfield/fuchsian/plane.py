"""The hyperbolic plane inside an algebra over ℚ that is indefinite, without a single irrational number.

The elements of trace 0 with positive norm form, up to positive factors, one sheet of a
hyperboloid: an element
c of it stands for the point of the plane that c fixes, and a unit g of norm 1 carries it to ``g·c·g⁻¹``. So a
rational c, its images, the lines halfway between them and the points where these lines meet all have rational
coordinates, and every question about them is decided by the sign of a rational number; a point with norm 0 is
a cusp. See Voight, *Quaternion Algebras*, sections 33.8 and 37.5 for the domains, section 36.2 for
the hyperboloid.
"""

from __future__ import annotations

from math import ceil, sqrt
from typing import Any

from flint import fmpq

from hfield.algebra.quaternion import Quaternion

Vector = tuple[fmpq, fmpq, fmpq]
Motion = tuple[Vector, Vector, Vector]


class Plane:
    """The hyperbolic plane seen from the fixed point of a trace-0 element c of positive norm.

    Coordinates are over (c, u, c·u), where u anticommutes with c: the norm there is ``n·x² − m·y² − n·m·z²``,
    and the centre is (1, 0, 0). The sheet is that of c: its points have x > 0.
    """

    def __init__(self, center: Quaternion) -> None:
        self.center = center
        algebra: Any = center.algebra
        u = next(u for v in algebra.basis[1:] if (u := center * v - v * center).norm() != 0)
        self.axes = (center, u, center * u)
        self.norms = tuple(rational(v.norm()) for v in self.axes)
        # the coordinate on an axis v is tr(x·conj(v)) / 2·N(v), linear in the four coordinates of x
        self._forms = [
            [rational((e * v.conjugate()).trace()) / (2 * norm) for e in algebra.basis]
            for v, norm in zip(self.axes, self.norms, strict=True)
        ]
        n, m = float_of(self.norms[0]), -float_of(self.norms[1])
        self.stretch = (sqrt(m / n), sqrt(m))

    def vector(self, x: Quaternion) -> Vector:
        """Return the coordinates of an element of trace 0."""
        q = [rational(c) for c in x.coordinates]
        return _triple(
            [sum((a * b for a, b in zip(f, q, strict=True)), fmpq(0)) for f in self._forms]
        )

    def norm(self, x: Vector) -> fmpq:
        """Return the norm: positive in the plane, 0 on its circle at infinity."""
        n, m, k = self.norms
        return n * x[0] * x[0] + m * x[1] * x[1] + k * x[2] * x[2]

    def motion(self, g: Quaternion) -> Motion:
        """Return the matrix of ``x ↦ g·x·g⁻¹`` for g of norm 1, acting on columns."""
        bar = g.conjugate()
        columns = [self.vector(g * v * bar) for v in self.axes]
        x, y, z = zip(*columns, strict=True)
        return (_triple(x), _triple(y), _triple(z))

    def halfway(self, image: Vector) -> Vector:
        """Return the form that is ≥ 0 where the centre is at least as near as its image."""
        n, m, k = self.norms
        return (n * (image[0] - 1), m * image[1], k * image[2])

    def disc(self, x: Vector) -> complex:
        """Return about where a point lies in Poincaré's disc around the centre."""
        a, b = self.stretch
        x0 = float_of(x[0])
        p = complex(float_of(x[1]) * a / x0, float_of(x[2]) * b / x0)
        return p / (1 + sqrt(max(0.0, 1 - abs(p) ** 2)))

    def nearby(self, p: complex) -> Quaternion:
        """Return an element of trace 0 whose point lies about at p in Poincaré's disc."""
        q = 2 * p / (1 + abs(p) ** 2)
        a, b = self.stretch
        c, u, w = self.axes
        scale = 2**16 * ceil(max(a, b, 1.0))
        y, z = round(scale * q.real / a), round(scale * q.imag / b)
        found: Quaternion = c * scale + u * y + w * z
        return found


def apply(motion: Motion, x: Vector) -> Vector:
    """Return the image of a point."""
    a, b, c = motion
    return (dot(a, x), dot(b, x), dot(c, x))


def dot(f: Vector, x: Vector) -> fmpq:
    """Return the value of a form."""
    return f[0] * x[0] + f[1] * x[1] + f[2] * x[2]


def meeting(f: Vector, g: Vector) -> Vector:
    """Return the point where two lines meet, which may lie beyond the circle."""
    return (f[1] * g[2] - f[2] * g[1], f[2] * g[0] - f[0] * g[2], f[0] * g[1] - f[1] * g[0])


def rational(x: Any) -> fmpq:
    """Return a number of the base field as a flint fraction."""
    return x if isinstance(x, fmpq) else fmpq(int(x.numerator), int(x.denominator))


def float_of(x: fmpq) -> float:
    """Return about a rational number."""
    return int(x.p) / int(x.q)


def _triple(x: Any) -> Vector:
    a, b, c = x
    return (a, b, c)
