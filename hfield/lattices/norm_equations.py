"""Elements of a given norm, also where the norm has hundreds of digits, in an order of a definite algebra.

Inside O lies ``ℤ[α] + ℤ[α]·β``, of norm form ``f(x, y) + N(β)·f(z, w)``. For random z, w the rest is a
prime about once in as many times as it has digits, and Cornacchia's algorithm represents it by f (Kohel,
Lauter, Petit and Tignol, "On the quaternion ℓ-isogeny path problem", 2014, section 3.2). Small norms are
decided by enumeration.
"""

from __future__ import annotations

import math
import random
from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Quaternion
from hfield.errors import UndecidedError, shorten
from hfield.lattices import enumeration
from hfield.lattices.quadratic_orders import Frame, frame, represent

if TYPE_CHECKING:
    from hfield.lattices.order import Order

ENUMERATED = 2 * 10**5
TRIALS = 50_000


def represent_integer(order: Order, n: int, seed: int | None = None) -> Quaternion | None:
    """Return an element of O of norm n, or None where an enumeration shows that there is none.

    Raises :class:`IndefiniteError`, and :class:`UndecidedError` where n is too large to enumerate and nothing
    was found.
    """
    order._definite("represent_integer()")
    rows, gram = order._reduced
    if enumeration.volume(gram, 2 * n, 3) < ENUMERATED:
        for x in enumeration.vectors_of_length(gram, 2 * n):
            row = [sum(c * int(rows[m, k]) for m, c in enumerate(x)) for k in range(4)]
            return order._element(row)
        return None
    found = in_frame(frame(order), n, random.Random(0 if seed is None else seed))
    if found is None:
        raise UndecidedError(
            f"no element of norm {shorten(n)} was found in {TRIALS} trials; the order contains quadratic "
            f"orders of discriminant {shorten(frame(order).discriminant)} and beyond only"
        )
    return found


def in_frame(f: Frame, n: int, rng: random.Random, trials: int = TRIALS) -> Quaternion | None:
    """Return an element of norm n of ``ℤ[α] + ℤ[α]·β``, or None after so many trials."""
    bound = n // f.norm
    # f(z, w) ≥ |d|/(4·n)·z² and ≥ |d|/4·w²
    widest = math.isqrt(4 * bound // -f.discriminant)
    for _ in range(trials):
        w = rng.randint(-widest, widest)
        rest = bound + f.discriminant * w * w // 4
        half = math.isqrt(max(rest, 0))
        z = rng.randint(-half, half) - f.t * w // 2
        m = n - f.norm * f.binary(z, w)
        if m <= 0:
            continue
        found = represent(f.discriminant, m)
        if found is not None:
            return f.element(*found, z, w)
    return None
