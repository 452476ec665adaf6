"""Units of norm 1 that carry a point near another one: short vectors of a definite form, exactly.

For g of norm 1, ``cosh d(g·c, w)`` is ``tr(g·c·conj(g)·conj(w))/2`` over the root of
``N(c)·N(w)``, and this form
in g is positive definite. Seen from the centre alone the units that are needed are long; seen from
one random point
w after the other they are short (Page, *Math. Comp.* 84, 2015, section 5; Rickards, *Math. Comp.* 91, 2022).
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from flint import fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.fuchsian.plane import float_of, rational
from hfield.lattices import hermite
from hfield.lattices.enumeration import short_vectors
from hfield.lattices.z_order import ZOrder


def carrying(
    order: ZOrder, center: Quaternion, target: Quaternion, cosh: float
) -> Iterator[Quaternion]:
    """Yield one of ±g for every g of norm 1 with ``cosh d(g·center, target)`` at most about ``cosh``."""
    basis, bar = order.basis, target.conjugate()
    moved = [[b * center * d.conjugate() * bar for d in basis] for b in basis]
    traces = [[rational(x.trace()) for x in row] for row in moved]
    gram = [[traces[m][n] + traces[n][m] for n in range(4)] for m in range(4)]  # 4·tr/2·g
    den = math.lcm(*(int(x.q) for row in gram for x in row))
    whole = fmpz_mat([[int(x * den) for x in row] for row in gram])
    reduced, steps = whole.lll(transform=True, rep="gram")
    size = math.sqrt(float_of(rational(center.norm())) * float_of(rational(target.norm())))
    bound = math.ceil(4 * den * size * cosh)
    for x, _ in short_vectors(hermite.tuples(reduced), bound):
        y = hermite.combination(x, steps)
        if order.trace_and_norm(y)[1] == 1:
            yield order.element(order.row(y))


def centers(order: ZOrder) -> Iterator[Quaternion]:
    """Yield elements of trace 0 and positive norm, small ones first: points far from all cusps."""
    den, rows, gram = order.ternary
    _, steps = (rows * order.regular.majorant * rows.transpose()).lll(transform=True, rep="gram")
    basis = hermite.tuples(steps * rows)
    gram = steps * gram * steps.transpose()
    values = [[int(x) for x in row] for row in gram.tolist()]
    for reach in (3, 8, 20):
        near = range(-reach, reach + 1)
        found = []
        for x in ((p, q, r) for p in range(reach + 1) for q in near for r in near):
            norm = sum(x[m] * x[n] * values[m][n] for m in range(3) for n in range(3))
            if norm > 0 and math.gcd(*x) == 1:
                found.append((norm, x))
        for _, x in sorted(found):
            row = [sum(c * b[n] for c, b in zip(x, basis, strict=True)) for n in range(4)]
            yield order.element(row, den)
