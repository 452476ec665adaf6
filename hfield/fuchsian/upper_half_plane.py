"""Fixed points of elements in the upper half plane, as complex numbers."""

from __future__ import annotations

from math import sqrt

from flint import arb

from hfield.algebra.quaternion import Quaternion
from hfield.errors import UndecidedError
from hfield.fields.base.balls import MAX_BITS, precision
from hfield.fuchsian.split_order import SplitOrder


def _squares(order: SplitOrder) -> tuple[float, float, float]:
    """Return the squares of i − t/2 and of j, and t, as floats."""
    a, t, b = (order.real(order.scalar(x)) for x in order.algebra.constants)
    return a + t * t / 4, b, t


def fixed_point(order: SplitOrder, c: Quaternion) -> complex:
    """Return the fixed point of an element of trace 0 in the upper half plane, in floats.

    Each part is right to within rounding, whatever the size of the element. Raises :class:`UndecidedError`.
    """
    bits = 128
    while bits <= MAX_BITS:
        with precision(bits):
            real, imag = _fixed_ball(order, c)
            if imag.rel_accuracy_bits() > 53 and (real.rad() < imag * 2.0**-53):
                return complex(float(real.mid()) + 0.0, float(imag.mid()))
        bits *= 2
    raise UndecidedError(f"{MAX_BITS} bits do not determine a point of the upper half plane")


def _fixed_ball(order: SplitOrder, c: Quaternion) -> tuple[arb, arb]:
    """Return balls around the real and the imaginary part, with flint's present precision."""
    a, t, b = (order.ball(order.scalar(x)) for x in order.algebra.constants)
    _, x, y, z = (order.ball(order.scalar(q)) for q in c.coordinates)
    alpha = a + t * t / 4
    y += t * z / 2
    # with u = i − t/2 and c = x·u + y·j + z·u·j
    if alpha > 0:  # u is diagonal, j = [0 b; 1 0]
        s = alpha.sqrt()
        p, r = s * x, y - s * z
    else:  # j is diagonal, u = [0 α; 1 0]
        s = b.sqrt()
        p, r = s * y, x + s * z
    return p / r, order.ball(order.scalar(c.norm())).sqrt() / abs(r)


def fixing(order: SplitOrder, z: complex, scale: int) -> Quaternion | None:
    """Return an element of trace 0 of about size ``scale`` that fixes approximately z; None if ``scale`` is
    too small.
    """
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
