"""Find two generators of an invertible ideal: an element and a number (over ℤ_K, an ideal of the field).

Let m be the largest scalar factor of I, so that I = m·J with J primitive of norm 𝔫. Then m·𝔫 lies in I, and
``I = O·m·𝔫 + O·x`` for every x in I with N(x)/N(I) prime to 𝔫. At the primes of 𝔫 both sides are O·x; at all
others both are m·O (Voight, *Quaternion Algebras*, section 16.3).
"""

from __future__ import annotations

import random
from collections.abc import Iterator

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, UndecidedError
from hfield.orders import hermite
from hfield.orders.base_values import ShownIdeal
from hfield.orders.lattice_values import (
    LatticeValue,
    add,
    generated_ideal,
    is_locally_principal,
    scalars_into,
    times_ideal,
)

MAX_TRIALS = 20_000


def two_generators(
    ideal: LatticeValue, order: LatticeValue, side: str
) -> tuple[ShownIdeal, Quaternion]:
    """Return (n, x) with ``I = O·n + O·x`` for a left ideal, n·O + x·O for a right one.

    The lattice that they generate is computed and compared with I. Raises :class:`LatticeError` unless I is
    locally principal.
    """
    if not is_locally_principal(ideal, order):
        raise LatticeError(
            "an ideal that is not invertible need not have two generators; generators is for invertible ones"
        )
    base = ideal.ambient.base
    into = scalars_into(ideal, order)
    n = ideal.norm * into
    rest, below = n * into, base.inverse(ideal.norm)
    scalars = times_ideal(order, n)
    for row in _rows(ideal):
        x = ideal.element(row)
        norm = base.inside(x.norm())
        if not norm or not base.are_coprime(base.principal(norm) * below, rest):
            continue
        if add(scalars, generated_ideal(order, [x], side)) == ideal:
            return base.shown_index(n), x
    raise UndecidedError("no two generators were found among random elements of the ideal")


def _rows(ideal: LatticeValue) -> Iterator[tuple[int, ...]]:
    """Yield the elements of a basis, reduced if possible, and then random ones of increasing size."""
    ambient, rng = ideal.ambient, random.Random(0)
    yield from hermite.tuples(ideal.short_rows)
    for trial in range(MAX_TRIALS):
        size = 1 + trial // 50
        row = [rng.randint(-size, size) for _ in range(ambient.size)]
        yield hermite.combination(row, ideal.short_rows)
