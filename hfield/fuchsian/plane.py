"""The hyperbolic plane inside an algebra that splits at one real place, with exact coordinates.

The elements of trace 0 with positive norm at that place form, up to positive factors, one sheet of a
hyperboloid. An element c stands for the point of the plane that c fixes, and a unit g of norm 1 maps it to
``g·c·g⁻¹``. So c, its images, the lines halfway between them and the intersections of these lines all have
coordinates in the field, and every question about them is decided by the sign of a number of the field. A
point with norm 0 is a cusp. See Voight, *Quaternion Algebras*, sections 33.8 and 37.5 for the domains, and
section 36.2 for the hyperboloid.
"""

from __future__ import annotations

from math import ceil, sqrt

from hfield.algebra.quaternion import Quaternion
from hfield.fuchsian.split_order import SplitOrder
from hfield.orders.base_values import BaseNumber

Vector = tuple[BaseNumber, BaseNumber, BaseNumber]
"""Exact numbers of the field."""
Motion = tuple[Vector, Vector, Vector]
CENTER: tuple[object, object, object] = (1, 0, 0)
"""The centre, as a vector."""


class Plane:
    """The hyperbolic plane around the fixed point of c, an element of trace 0 and positive norm.

    Coordinates are with respect to (c, u, c·u), where u anticommutes with c. In them the norm is ``n·x² −
    m·y² − n·m·z²``, and the centre is (1, 0, 0). The points of the sheet have x > 0.
    """

    def __init__(self, order: SplitOrder, center: Quaternion) -> None:
        self.order, self.center = order, center
        basis = order.algebra.basis
        u = next(u for v in basis[1:] if (u := center * v - v * center).norm() != 0)
        self.axes = (center, u, center * u)
        n0, n1, n2 = (order.scalar(v.norm()) for v in self.axes)
        self.norms: Vector = (n0, n1, n2)
        # the coordinate on an axis v is tr(x·conj(v)) / 2·N(v), linear in the four coordinates of x
        self._forms = [
            [order.scalar((e * v.conjugate()).trace()) / (2 * norm) for e in basis]
            for v, norm in zip(self.axes, self.norms, strict=True)
        ]
        n, m = order.real(self.norms[0]), -order.real(self.norms[1])
        self.stretch = (sqrt(m / n), sqrt(m))

    def vector(self, x: Quaternion) -> Vector:
        """Return the coordinates of an element of trace 0."""
        q = [self.order.scalar(c) for c in x.coordinates]
        a, b, c = (f[0] * q[0] + f[1] * q[1] + f[2] * q[2] + f[3] * q[3] for f in self._forms)
        return (a, b, c)

    def image(self, g: Quaternion) -> Vector:
        """Return the image of the centre under g, an element of positive norm."""
        return self.vector(g * self.center * _inverse(g))

    def norm(self, x: Vector) -> BaseNumber:
        """Return the norm: positive in the plane, 0 on the circle at infinity."""
        n, m, k = self.norms
        return n * x[0] * x[0] + m * x[1] * x[1] + k * x[2] * x[2]

    def motion(self, g: Quaternion) -> Motion:
        """Return the matrix of ``x ↦ g·x·g⁻¹`` for g of positive norm, acting on columns."""
        inverse = _inverse(g)
        (a, b, c), (d, e, f), (p, q, r) = (self.vector(g * v * inverse) for v in self.axes)
        return ((a, d, p), (b, e, q), (c, f, r))

    def halfway(self, image: Vector) -> Vector:
        """Return the linear form that is ≥ 0 at the points at least as near to the centre as to ``image``."""
        n, m, k = self.norms
        return (n * (image[0] - 1), m * image[1], k * image[2])

    def floats(self, x: Vector) -> tuple[float, float, float]:
        """Return approximate coordinates of a point, scaled so that the circle at infinity is round."""
        real, (a, b) = self.order.real, self.stretch
        return real(x[0]), real(x[1]) * a, real(x[2]) * b

    def disc(self, x: Vector) -> complex:
        """Return the approximate position of a point in Poincaré's disc around the centre."""
        t, y, z = self.floats(x)
        p = complex(y / t, z / t)
        return p / (1 + sqrt(max(0.0, 1 - abs(p) ** 2)))

    def nearby(self, p: complex, bits: int) -> Quaternion:
        """Return an element of trace 0 whose point is near p in Poincaré's disc; ``bits`` is the
        precision.
        """
        q = 2 * p / (1 + abs(p) ** 2)
        a, b = self.stretch
        c, u, w = self.axes
        scale = 2**bits * ceil(max(a, b, 1.0))
        y, z = round(scale * q.real / a), round(scale * q.imag / b)
        found: Quaternion = c * scale + u * y + w * z
        return found


def _inverse(g: Quaternion) -> Quaternion:
    bar, norm = g.conjugate(), g.norm()
    return bar if norm == 1 else bar / norm


def apply(motion: Motion, x: Vector) -> Vector:
    """Return the image of a point."""
    a, b, c = motion
    return (dot(a, x), dot(b, x), dot(c, x))


def dot(f: Vector, x: Vector) -> BaseNumber:
    """Return the value of a form."""
    return f[0] * x[0] + f[1] * x[1] + f[2] * x[2]


def meeting(f: Vector, g: Vector) -> Vector:
    """Return the intersection of two lines, which may lie outside the disc."""
    return (f[1] * g[2] - f[2] * g[1], f[2] * g[0] - f[0] * g[2], f[0] * g[1] - f[1] * g[0])


def same_point(x: Vector, y: Vector) -> bool:
    """Return whether two coordinate vectors are proportional."""
    return bool(x[0] * y[1] == x[1] * y[0] and x[0] * y[2] == x[2] * y[0])
