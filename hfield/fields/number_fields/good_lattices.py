"""Lattices in F³, F a number field, on which a form is good at every prime ideal.

At a prime ideal ``minimal_conics`` gives a local basis whose entries are integral at all other primes. The
module over the integers of F that has these bases at the bad primes, and is the standard one elsewhere, is
their sum, each times a number that is divisible enough by the others.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, TypeVar

from hfield.product import Scalar
from hfield.structure.minimal_conics import Conic, Vector, minimise

if TYPE_CHECKING:
    from hfield.fields.number_fields.quadratic.residues import PrimeIdeal
    from hfield.fields.number_fields.residues import LocalPlace
    from hfield.rings.base import Ring

    P = TypeVar("P", bound=LocalPlace | PrimeIdeal)


def good_generators(
    field: Ring,
    form: Vector,
    primes: Iterable[int],
    above: Callable[[int], Iterable[P]],
    unit: Callable[[P, int], Scalar],
) -> list[Vector]:
    """Return what generates, over the integers of F, a module on which a diagonal form is minimal everywhere.

    The coefficients are integers of the field, and units outside ``primes``, which contain 2. The form
    must have a zero in each completion. ``above(p)`` are the prime ideals above p; ``unit(P, n)`` is an
    integer of the field, a unit at P, and divisible by pⁿ at the others above p.
    """
    o = field.zero
    conic = Conic((form[0], form[1], form[2], o, o, o), o, field.one)
    local: list[tuple[int, P, list[Vector]]] = []
    depths: dict[int, int] = {}  # the conductor, prime by prime
    for p in primes:
        depths[p] = 0
        for place in above(p):
            lattice = conic.start()
            if not minimise(conic, lattice, place):
                raise AssertionError("the form has a zero in every completion")
            depths[p] = max(depths[p], -(-_depth(field, place, lattice.basis) // place.index))
            local.append((p, place, lattice.basis))
    conductor = math.prod(p**n for p, n in depths.items())
    rows = [[x * conductor for x in v] for v in conic.start().basis]
    for p, place, basis in local:
        scale = unit(place, depths[p]) * (conductor // p ** depths[p])
        rows += [[scale * x for x in v] for v in basis]
    return rows


def _depth(field: Ring, place: LocalPlace | PrimeIdeal, basis: list[Vector]) -> int:
    """Return an n for which the span contains the n-th power of the prime times the standard lattice."""
    (a, b, c), (d, e, f), (g, h, i) = basis
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    worst = min(place.valuation(x) for v in basis for x in v if not field.is_zero(x))
    return max(0, place.valuation(determinant) - 2 * min(0, worst))
