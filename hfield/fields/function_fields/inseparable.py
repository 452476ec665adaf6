"""Characteristic 2 over k(t), k finite: square roots, and y² + y = x.

Since k is perfect, every s in k(t) is ``w² + b·r²``, for any b that is not a square. So every algebra [a, b)
with such a b contains a square root ``w + r·j`` of trace 0 of s.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.fields.function_fields.conics import solve_conic_functions
from hfield.fields.function_fields.residues import ResidueField
from hfield.fields.function_fields.ring import FunctionField
from hfield.product import Constants, Coordinates, norm

if TYPE_CHECKING:
    from hfield.fields.function_fields.quotients import Quotient


def embed_even(
    field: FunctionField, outer: Constants, inner: Constants
) -> tuple[Coordinates, Coordinates]:
    """Return I and J in the division algebra ``inner`` with ``I² = a + I, J² = b, JI = (1 + I)J``.

    J is a square root of b; i is corrected by a multiple of k until it is right with J, and by u + v·J,
    which commutes with J, until its norm is right: that is a conic.
    """
    w, s = as_norm(field, outer.b, inner.b)
    big_j = w, field.zero, s, field.zero
    start = field.zero, field.one, field.zero, field.divide(w, s * inner.b)
    m, n, r = solve_conic_functions(
        field, Constants(outer.a + norm(inner, start), field.one, outer.b)
    )
    scale = field.inverse(n)
    p, q, x, y = (u + scale * r * v for u, v in zip(start, big_j, strict=True))
    return (p + scale * m, q, x, y), big_j


def square_parts(ring: FunctionField, x: Quotient) -> tuple[Quotient, Quotient]:
    """Return ``(u, v)`` with ``x = u² + g·v²``, g the variable, over a finite field of characteristic 2."""
    whole = x.num * x.den
    parts = []
    for start in (0, 1):
        root = ring.zero
        for n in range(start, int(whole.degree()) + 1, 2):
            c = ring.constant(ring.base.sqrt(ring.base(whole[n])))
            root = root + c * ring.power(ring.gen, n // 2)
        parts.append(ring.divide(root, ring.quotient(x.den, ring.one.num)))
    return parts[0], parts[1]


def as_norm(field: FunctionField, x: Quotient, s: Quotient) -> tuple[Quotient, Quotient]:
    """Return ``(w, r)`` with ``x = w² + s·r²``, for an s that is no square."""
    (x0, x1), (s0, s1) = square_parts(field, x), square_parts(field, s)
    r = field.divide(x1, s1)
    return x0 + r * s0, r


def artin_schreier(field: FunctionField, x: Quotient) -> Quotient | None:
    """Return y with ``y² + y = x``, or None.

    The denominator has to be a square d², and y = m/d with ``m² + m·d = n``; the terms of m follow from the
    leading terms of n, from the top down.
    """
    root = field.sqrt(field.quotient(x.den, field.one.num))
    if root is None:
        return None
    d, n, m = root.num, x.num, field.zero.num
    kappa, k = ResidueField(field, field.gen.num), int(d.degree())
    while n != 0:
        size = int(n.degree())
        c = field.constant(field.base(n.leading_coefficient())).num
        power = size // 2
        if size > 2 * k:
            c = None if size % 2 else kappa.sqrt(c)
        elif size == 2 * k:
            c = kappa.artin_schreier(c)
        else:
            c, power = (c, size - k) if size >= k else (None, 0)
        if c is None:
            return None
        term = c * field.gen.num**power
        m, n = m + term, n + term * term + term * d
    return field.quotient(m, d)
