"""Embed i and j of one algebra in an isomorphic one from a common slot, by three conics.

For isomorphic algebras (a, b) and (p, q) there is an e with (a, b) = (a, e) = (p, e) = (p, q). Each field has
its own methods to find e and to solve conics; the rest is the same over every field.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable

from hfield.core.product import Constants, Coordinates, Scalar, multiply, norm
from hfield.fields.base.ring import Ring
from hfield.fields.quadratic_forms.norm_forms.zero_norms import zero_norm
from hfield.fields.quadratic_forms.normal_forms import basis_of

Point = Callable[[Constants], tuple[Scalar, Scalar, Scalar]]


def through_slot(
    ring: Ring, outer: Constants, inner: Constants, e: Scalar, point: Point
) -> tuple[Coordinates, Coordinates]:
    """Return I and J in the algebra ``inner`` that satisfy the relations of ``outer``."""
    big_i, slot = generator_by_slot(ring, outer.a, inner, e, point)
    split = Constants(outer.a, ring.zero, ring.divide(outer.b, e))
    return big_i, _times_norm(ring, inner, big_i, slot, split, point)


def generator_by_slot(
    ring: Ring, a: Scalar, inner: Constants, e: Scalar, point: Point
) -> tuple[Coordinates, Coordinates]:
    """Return I and J in ``inner`` with ``I² = a, J² = e, JI = −IJ``, for a common slot e."""
    zero, one = ring.zero, ring.one
    i, j = (zero, one, zero, zero), (zero, zero, one, zero)
    split = Constants(inner.a, zero, ring.divide(e, inner.b))
    slot = _times_norm(ring, inner, i, j, split, point)
    # ((x + y·slot)·i)² = (x² − e·y²)·inner.a
    split = Constants(e, zero, ring.divide(a, inner.a))
    return _times_norm(ring, inner, slot, i, split, point), slot


def _times_norm(
    ring: Ring, c: Constants, u: Coordinates, v: Coordinates, split: Constants, point: Point
) -> Coordinates:
    """Return ``(m + n·u)·v`` with m + n·u of norm ``split.b``, where ``u² = split.a + split.t·u``."""
    m, n, r = point(split)
    scale = ring.inverse(r)
    w, x, y, z = (scale * n * s for s in u)
    return multiply(c, (w + scale * m, x, y, z), v)


def conic_point(ring: Ring, c: Constants) -> tuple[Scalar, Scalar, Scalar]:
    """Return ``(w, x, y)`` ≠ 0 with ``w² + t·wx − a·x² − b·y² = 0`` for a split algebra.

    A zero divisor q determines the plane q·A of elements of norm 0, which intersects ⟨e, i, j⟩.
    """
    q = zero_norm(ring, c).element
    assert q is not None, "the algebra is split"
    products = [
        p for p in (multiply(c, q, u) for u in basis_of(ring)) if not all(map(ring.is_zero, p))
    ]
    for p, r in itertools.combinations([*products, products[0]], 2):
        w, x, y, z = (s * r[3] - t * p[3] for s, t in zip(p, r, strict=True))
        if not all(map(ring.is_zero, (w, x, y))):
            assert ring.is_zero(norm(c, (w, x, y, z)))
            return w, x, y
    w, x, y, _ = products[0]
    return w, x, y
