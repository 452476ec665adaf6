"""Lattices on which a form over a quadratic field is good at every prime ideal.

At a prime ideal ``minimal_conics`` gives a local basis, and it is one whose entries
are integral at all other primes. The lattice that has these bases at the bad primes, and is the standard
one elsewhere, is their sum, each times a number that is divisible enough by the others.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import flint

from hfield.factorisation import factorise
from hfield.rings.quadratic import QuadraticField
from hfield.rings.residues.prime_ideals import (
    PrimeIdeal,
    coordinates,
    norm,
    omega,
    primes_above,
)
from hfield.structure.minimal_conics import Conic, Vector, minimise

if TYPE_CHECKING:
    from hfield.rings.surds import Surd


def bad_primes(
    field: QuadraticField, numbers: Iterable[Surd], known: Iterable[int] = ()
) -> list[int]:
    """Return 2 and the primes of the norms of some integers; ``known`` may name primes of these."""
    return sorted({2}.union(*(factorise(int(norm(field, x)), known) for x in numbers)))


def good_lattice(field: QuadraticField, form: Vector, primes: Iterable[int]) -> list[Vector]:
    """Return a basis over ℤ of a lattice in F³ on which a diagonal form is minimal at each prime.

    The coefficients are integers of the field, and units outside ``primes``, which contain 2. The form
    must have a zero in each completion.
    """
    o = field.zero
    conic = Conic((form[0], form[1], form[2], o, o, o), o, field.one)
    local: list[tuple[int, PrimeIdeal, list[Vector]]] = []
    depths: dict[int, int] = {}  # the conductor, prime by prime
    for p in primes:
        depths[p] = 0
        for place in primes_above(field, p):
            lattice = conic.start()
            if not minimise(conic, lattice, place):
                raise AssertionError("the form has a zero in every completion")
            depths[p] = max(depths[p], _depth(place, lattice.basis))
            local.append((p, place, lattice.basis))
    conductor = math.prod(p**n for p, n in depths.items())
    rows = [[x * conductor for x in v] for v in conic.start().basis]
    for p, place, basis in local:
        scale = field.power(place.other, depths[p]) * (conductor // p ** depths[p])
        rows += [[scale * x for x in v] for v in basis]
    w = omega(field)
    return _basis(field, rows + [[w * x for x in v] for v in rows])


def _depth(place: PrimeIdeal, basis: list[Vector]) -> int:
    """Return an n for which the span contains the n-th power of the prime times the standard lattice."""
    (a, b, c), (d, e, f), (g, h, i) = basis
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    worst = min(place.valuation(x) for v in basis for x in v if x.terms)
    return max(0, place.valuation(determinant) - 2 * min(0, worst))


def _basis(field: QuadraticField, generators: list[Vector]) -> list[Vector]:
    """Return a basis over ℤ of what vectors of F³ generate, a lattice of rank 6; scaled to be integral."""
    rows = [[u for x in v for u in coordinates(field, x)] for v in generators]
    scale = math.lcm(*(u.denominator for row in rows for u in row))
    matrix = flint.fmpz_mat(len(rows), 6, [int(u * scale) for row in rows for u in row])
    w = omega(field)
    return [
        [field(int(row[k])) + w * int(row[k + 1]) for k in (0, 2, 4)]
        for row in matrix.hnf().tolist()[:6]
    ]
