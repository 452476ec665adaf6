"""The completions of number fields, quadratic ones among them: extensions of ℚ_p, ℝ and ℂ."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.fields.local.field import LocalField
from hfield.fields.number_fields.infinite_completions import infinite_completion
from hfield.fields.number_fields.places import RealPlace, place_of_number_field
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.quadratic.places import place_of_quadratic
from hfield.fields.number_fields.quadratic.residues import prime_at
from hfield.fields.number_fields.residues import local_place
from hfield.rings.closed_fields.algebraic import CC, RR
from hfield.rings.printing import SUBSCRIPTS, blackboard

if TYPE_CHECKING:
    from hfield.fields.number_fields.quadratic.places import QuadraticPlace
    from hfield.fields.number_fields.quadratic.ring import QuadraticField
    from hfield.fields.number_fields.ring import NumberField
    from hfield.rings.base import Ring
    from hfield.structure.finite_places import FinitePlace


def completion_of_quadratic(field: QuadraticField, place: object) -> Ring:
    """Return the completion of ℚ(√d): an extension of ℚ_p, RR or CC; ℝ with a negative √d at ``inf-``."""
    v = place_of_quadratic(field, place)
    if v.root == -1 and not v.prime:  # RR reads √d as the positive root
        return infinite_completion(field, v, is_real=True)
    if not v.prime:
        return CC if v.root is None else RR
    return _at_prime_ideal(field, v, prime_at(v))


def completion_of_number_field(field: NumberField, place: object) -> Ring:
    """Return the completion of a number field: an extension of ℚ_p, ℝ or ℂ."""
    v = place_of_number_field(field, place)
    if isinstance(v, PrimeIdeal):
        return _at_prime_ideal(field, v, local_place(v))
    return infinite_completion(field, v, isinstance(v, RealPlace))


def _at_prime_ideal(
    field: Ring, v: PrimeIdeal | QuadraticPlace, residues: FinitePlace
) -> LocalField:
    """Return the completion at a prime ideal with ``p``, ``e`` and ``f``."""
    below = f"ℚ{str(v.p).translate(SUBSCRIPTS)}"
    size = f"of degree {v.e * v.f} over {below}" if v.e * v.f > 1 else f"which is {below}"
    words = f"the completion of {blackboard(field.name)} at {v}, {size}"
    text = str(v) if str(v).startswith("(") else f"({v})"
    return LocalField(f"{field}_{text}", words, field, v, residues)
