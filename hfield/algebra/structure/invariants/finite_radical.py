"""The Jacobson radical of an algebra over a finite ring that is not a field.

An element q lies in the radical if and only if ``tr(q·conj(u))``, for u = e, i, j, k, and N(q) lie in the
radical of the ring, which consists of its nilpotent elements. At a residue field of characteristic 2 with t =
0 the first condition is empty and the second is additive in q; at all other residue fields the first implies
the second.
"""

from __future__ import annotations

import itertools
from collections.abc import Hashable
from math import prod
from typing import TYPE_CHECKING

from hfield.core.factorisation import factorise
from hfield.core.product import Constants, Coordinates, Scalar, norm
from hfield.errors import UndecidedError, shorten
from hfield.fields.base.modular import Modular
from hfield.fields.base.powers import power
from hfield.fields.base.ring import Ring
from hfield.fields.linear_algebra.syzygies import TRIALS, Row, generators, modulo
from hfield.fields.quadratic_forms.normal_forms import basis_of, pairing_matrix

if TYPE_CHECKING:
    pass


def finite_radical(ring: Ring, c: Constants) -> tuple[Coordinates, ...]:
    """Return generators of the radical. Raises :class:`UndecidedError` if the ring is too large."""
    found = _modular(ring, c) if isinstance(ring, Modular) else _searched(ring, c)
    return tuple((w, x, y, z) for w, x, y, z in found)


def _modular(ring: Modular, c: Constants) -> list[Row]:
    """Return generators over ℤ/n, as a direct sum; modulo each prime factor of n the conditions are
    linear.
    """
    n = ring.modulus
    radical = prod(factorise(n))
    rows = [[int(x) for x in row] for row in pairing_matrix(ring, c)]
    a, t, b = (int(x) for x in c)
    if n % 2 == 0 and t % 2 == 0:
        rows = [[2 * x for x in row] for row in rows]  # a condition modulo the odd primes
        rows.append([radical // 2 * x for x in (1, a, b, a * b)])
    scaled = [[n // radical * x for x in row] for row in rows]
    return [[ring(x) for x in v] for v in modulo(n, scaled, 4)]


def _searched(ring: Ring, c: Constants) -> list[Row]:
    """Return generators by trying all elements modulo the radical of the ring."""
    everything = list(ring.elements()) if ring.order is not None and ring.order <= 1000 else []
    null = [x for x in everything if is_nilpotent(ring, x)]
    # the key of each element, and one element of its class modulo these
    classes: dict[Hashable, Scalar] = {}
    for x in everything:
        if ring.key(x) not in classes:
            classes |= {ring.key(x + y): x for y in null}
    representatives = list({ring.key(x): x for x in classes.values()}.values())
    if not everything or len(representatives) ** 4 > TRIALS:
        raise UndecidedError(
            f"the radical over {shorten(ring.name)} is not decided: its {shorten(ring.order)} elements are "
            "too many to be tried"
        )
    rows = pairing_matrix(ring, c)
    found = [
        [w, x, y, z]
        for w, x, y, z in itertools.product(representatives, repeat=4)
        if is_nilpotent(ring, norm(c, (w, x, y, z)))
        and all(is_nilpotent(ring, r * w + s * x + t * y + u * z) for r, s, t, u in rows)
    ]
    scalars = [x for (x,) in generators(ring, ([x] for x in null))]
    whole = [
        *generators(ring, found, lambda x: ring.key(classes[ring.key(x)])),
        *([x * y for y in u] for u in basis_of(ring) for x in scalars),
    ]
    return generators(ring, whole) if len(everything) ** 4 <= TRIALS else whole


def is_nilpotent(ring: Ring, x: Scalar) -> bool:
    """Return whether a power of an element of a finite ring is 0."""
    assert ring.order is not None
    return ring.is_zero(power(ring.one, x, ring.order.bit_length()))
