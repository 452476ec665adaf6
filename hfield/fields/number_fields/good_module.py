"""Lattices in K³ on which a form over a number field K is good at every prime ideal, by a basis over ℤ."""

from __future__ import annotations

import math
from collections.abc import Iterable

import flint

from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.good_lattices import good_generators
from hfield.fields.number_fields.integral_basis import coefficients
from hfield.fields.number_fields.prime_ideals import primes_above
from hfield.fields.number_fields.residues import LocalPlace, local_place
from hfield.fields.number_fields.ring import NumberField
from hfield.structure.minimal_conics import Vector


def good_module(field: NumberField, form: Vector, primes: Iterable[int]) -> list[Vector]:
    """Return a basis over ℤ of a module in K³ on which a diagonal form is minimal at each prime ideal.

    The form and the primes are as :func:`.good_lattices.good_generators` takes them.
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
