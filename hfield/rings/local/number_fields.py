"""The completions of number fields, quadratic ones among them: extensions of ℚ_p, ℝ and ℂ."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.rings.algebraic import CC, RR
from hfield.rings.local.field import LocalField
from hfield.rings.local.infinite import infinite_completion
from hfield.rings.number_field_places import RealPlace, place_of_number_field
from hfield.rings.number_primes import PrimeIdeal
from hfield.rings.printing import SUBSCRIPTS, blackboard
from hfield.rings.quadratic_places import place_of_quadratic
from hfield.rings.residues.number_ideals import local_place
from hfield.rings.residues.prime_ideals import prime_at

if TYPE_CHECKING:
    from hfield.rings.base import Ring
    from hfield.rings.number_field import NumberField
    from hfield.rings.quadratic import QuadraticField
    from hfield.rings.quadratic_places import QuadraticPlace
    from hfield.rings.residues.finite_places import FinitePlace


def completion_of_quadratic(field: QuadraticField, place: object) -> Ring:
    """Return the completion of ℚ(√d): an extension of ℚ_p, RR or CC; ℝ with a negative √d at ``inf-``."""
    v = place_of_quadratic(field, place)
    if v.root == -1 and not v.prime:  # RR reads √d as the positive root
        return infinite_completion(field, v, is_real=True)
    if not v.prime:
        return CC if v.root is None else RR
    return _at_prime_ideal(field, v, prime_at(field, v))


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
