"""Two generators of an invertible ideal over ℤ, a number and an element.

A primitive integral ideal J of norm N contains N, and is ``O·N + O·x`` for every x in J with N(x)/N prime
to N: at the primes of N it is O·x, at the others O (Voight, *Quaternion Algebras*, exercise 16.6).
"""

from __future__ import annotations

import math
import random
from fractions import Fraction
from itertools import chain

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, UndecidedError
from hfield.orders import hermite
from hfield.orders.klpt import random_elements
from hfield.orders.lattice_values import (
    LatticeValue,
    generated_ideal,
    is_locally_principal,
    scalars_into,
    times_ideal,
)


def two_generators(
    ideal: LatticeValue, order: LatticeValue, side: str
) -> tuple[int | Fraction, Quaternion]:
    """Return (n, x) with ``I = O·n + O·x`` for a left ideal, n·O + x·O for a right one.

    The lattice of both is computed and compared. Raises :class:`LatticeError` unless I is locally principal.
    """
    if not is_locally_principal(ideal, order):
        raise LatticeError(
            "an ideal that is not invertible need not have two generators; generators is for invertible ones"
        )
    factor = 1 / Fraction(scalars_into(ideal, order))
    primitive = times_ideal(ideal, 1 / factor)
    norm = int(primitive.norm)
    n = norm * factor
    rows = hermite.tuples(primitive.reduced[0])
    shortest = sorted(((row, primitive.multiple(row)) for row in rows), key=lambda x: abs(x[1]))
    for row, multiple in chain(shortest, random_elements(primitive, random.Random(0))):
        if math.gcd(multiple, norm) > 1:
            continue
        x = primitive.element(row) * factor
        if generated_ideal(order, [n, x], side) == ideal:
            return n.numerator if n.denominator == 1 else n, x
    raise UndecidedError("no two generators were found among random elements of the ideal")
