"""Lattices in K³ on which a form over a number field K is good at every prime ideal, by a basis over ℤ."""

from __future__ import annotations

import math
from collections.abc import Iterable

import flint

from hfield.rings.number_elements import FieldElement
from hfield.rings.number_field import NumberField
from hfield.rings.number_primes import primes_above
from hfield.rings.residues.number_ideals import LocalPlace, local_place
from hfield.structure.good_lattices import good_generators
from hfield.structure.minimal_conics import Vector
from hfield.structure.number_fields.integral_basis import coefficients


def good_module(field: NumberField, form: Vector, primes: Iterable[int]) -> list[Vector]:
    """Return a basis over ℤ of a module in K³ on which a diagonal form is minimal at each prime ideal.

    The form and the primes are as :func:`~hfield.structure.good_lattices.good_generators` takes them.
    """

    def above(p: int) -> list[LocalPlace]:
        return [local_place(prime) for prime in primes_above(field, p)]

    rows = good_generators(field, form, primes, above, _unit)
    return module_basis(field, rows)


def _unit(place: LocalPlace, n: int) -> FieldElement:
    """Return an integer that is 1 at the place, and divisible by pⁿ at the others above p."""
    prime, p = place.prime, place.below
    power = n * max(Q.e for Q in primes_above(prime.field, p))
    return prime.order.truncated(prime.field.power(prime.idempotent, power), p ** (n + 1))


def module_basis(field: NumberField, generators: list[Vector]) -> list[Vector]:
    """Return a basis over ℤ of what vectors of Kᵐ generate over the integers, scaled to be integral."""
    n = field.degree
    width = n * len(generators[0])
    wide = [[w * x for x in v] for w in field.integral_basis() for v in generators]
    rows = [[c for x in v for c in coefficients(x)] for v in wide]
    scale = math.lcm(*(int(c.q) for row in rows for c in row))
    entries = [(c * scale).p for row in rows for c in row]
    matrix = flint.fmpz_mat(len(rows), width, entries).hnf()
    return [
        [FieldElement(field, flint.fmpq_poly(row[k : k + n])) for k in range(0, width, n)]
        for row in matrix.tolist()[:width]
    ]
