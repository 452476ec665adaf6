"""Lattices on which a form over a quadratic field is good at every prime ideal, by a basis over ℤ."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import flint

from hfield.factorisation import factorise
from hfield.fields.number_fields.good_lattices import good_generators
from hfield.fields.number_fields.quadratic.residues import (
    PrimeIdeal,
    coordinates,
    norm,
    omega,
    primes_above,
)
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.structure.minimal_conics import Vector

if TYPE_CHECKING:
    from hfield.rings.closed_fields.surds import Surd


def bad_primes(
    field: QuadraticField, numbers: Iterable[Surd], known: Iterable[int] = ()
) -> list[int]:
    """Return 2 and the primes of the norms of some integers; ``known`` may name primes of these."""
    return sorted({2}.union(*(factorise(int(norm(field, x)), known) for x in numbers)))


def good_lattice(field: QuadraticField, form: Vector, primes: Iterable[int]) -> list[Vector]:
    """Return a basis over ℤ of a lattice in F³ on which a diagonal form is minimal at each prime.

    The form and the primes are as :func:`.good_lattices.good_generators` takes them.
    """

    def above(p: int) -> tuple[PrimeIdeal, ...]:
        return primes_above(field, p)

    def unit(place: PrimeIdeal, n: int) -> Surd:
        power: Surd = field.power(place.other, n)
        return power

    w, rows = omega(field), good_generators(field, form, primes, above, unit)
    return _basis(field, rows + [[w * x for x in v] for v in rows])


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
