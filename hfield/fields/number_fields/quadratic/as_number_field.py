"""ℚ(√d) as ℚ[s]/(s² − d): the same field, elements and places there and back."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import flint

from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ring import NumberField

if TYPE_CHECKING:
    from hfield.fields.number_fields.places import Place
    from hfield.fields.number_fields.quadratic.places import QuadraticPlace
    from hfield.fields.number_fields.quadratic.ring import QuadraticField
    from hfield.rings.closed_fields.surds import Surd


@lru_cache(maxsize=64)
def as_number_field(field: QuadraticField) -> NumberField:
    """Return ℚ[s]/(s² − d)."""
    return NumberField(flint.fmpq_poly([-field.d, 0, 1]))


def into_number_field(field: QuadraticField, x: Surd) -> FieldElement:
    """Return u + v·√d as u + v·s."""
    return FieldElement(as_number_field(field), flint.fmpq_poly(list(field.key(x))))


def from_number_field(field: QuadraticField, x: FieldElement) -> Surd:
    """Return u + v·s as u + v·√d."""
    return field(x.poly[0]) + field.gen * field(x.poly[1])


def place_in_number_field(place: QuadraticPlace) -> Place:
    """Return the place where s goes to what √d goes to."""
    same = as_number_field(place.field)
    if not place.prime:
        return same.infinite_places()[place.index]
    generator = into_number_field(place.field, place.generators[1])
    return next(P for P in same.primes_above(place.p) if generator in P)
