"""Fixed points of elements in the upper half plane, as complex numbers."""

from __future__ import annotations

from math import sqrt

from hfield.algebra.quaternion import Quaternion
from hfield.fuchsian.split_order import SplitOrder


def _squares(order: SplitOrder) -> tuple[float, float, float]:
    """Return the squares of i − t/2 and of j, and t, as floats."""
    a, t, b = (order.real(order.scalar(x)) for x in order.algebra.constants)
    return a + t * t / 4, b, t


def fixed_point(order: SplitOrder, c: Quaternion) -> complex:
    """Return the fixed point of an element of trace 0 in the upper half plane, in floats."""
    alpha, b, t = _squares(order)
    _, x, y, z = (order.real(order.scalar(q)) for q in c.coordinates)
    y += t * z / 2
    # with u = i − t/2 and c = x·u + y·j + z·u·j
    if alpha > 0:  # u is diagonal, j = [0 b; 1 0]
        s = sqrt(alpha)
        p, q, r = s * x, b * (y + s * z), y - s * z
    else:  # j is diagonal, u = [0 α; 1 0]
        s = sqrt(b)
        p, q, r = s * y, alpha * (x - s * z), x + s * z
    return complex(p / r + 0.0, sqrt(max(0.0, -p * p - q * r)) / abs(r))


def fixing(order: SplitOrder, z: complex, scale: int) -> Quaternion | None:
    """Return an element of trace 0 that fixes about z, of about that size; None if too coarse."""
    alpha, b, _ = _squares(order)
    p, q, r = z.real, -(abs(z) ** 2), 1.0
    if alpha > 0:
        s = sqrt(alpha)
        x, y, w = p / s, (q / b + r) / 2, (q / b - r) / (2 * s)
    else:
        s = sqrt(b)
        x, y, w = (q / alpha + r) / 2, p / s, (r - q / alpha) / (2 * s)
    _, i, j, _ = order.algebra.basis
    u = i - i.trace() / 2
    size = scale / max(abs(x), abs(y), abs(w))
    c: Quaternion = u * round(size * x) + j * round(size * y) + u * j * round(size * w)
    return c if order.sign(order.scalar(c.norm())) > 0 else None
