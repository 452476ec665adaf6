"""ℚ(√d) as ℚ[s]/(s² − d), by what serves all number fields: an oracle for formulas for ℚ(√d) alone."""

import flint

from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.places import Place
from hfield.fields.number_fields.quadratic.places import QuadraticPlace
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.ring import NumberField


def general(field: QuadraticField) -> NumberField:
    """Return ℚ[s]/(s² − d)."""
    return NumberField(flint.fmpq_poly([-field.d, 0, 1]))


def moved(field: NumberField, x: FieldElement) -> FieldElement:
    """Return the element with the same coordinates in a field with the same polynomial."""
    assert field.polynomial == x.field.polynomial
    return FieldElement(field, x.poly)


def place_of(field: NumberField, place: QuadraticPlace) -> Place:
    """Return the place of ℚ[s]/(s² − d) where s goes to what √d goes to."""
    if not place.is_finite:
        return field.infinite_places()[place.index]
    generator = moved(field, place.generators[1])
    return next(P for P in field.primes_above(place.p) if generator in P)
