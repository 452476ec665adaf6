"""The completion of a global field at a place: a :class:`LocalField`, RR or CC."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.errors import RingError, shorten
from hfield.factorisation import factorise
from hfield.rings.algebraic import CC, RR
from hfield.rings.base import Ring
from hfield.rings.function_places import place_of_functions
from hfield.rings.functions import FunctionField
from hfield.rings.integers import QQ
from hfield.rings.local.field import LocalField
from hfield.rings.local.infinite import infinite_completion
from hfield.rings.number_field import NumberField
from hfield.rings.number_field_places import RealPlace, place_of_number_field
from hfield.rings.number_primes import PrimeIdeal
from hfield.rings.printing import SUBSCRIPTS, blackboard
from hfield.rings.quadratic import QuadraticField
from hfield.rings.quadratic_places import place_of_quadratic
from hfield.rings.rational_places import INFINITE, place_of_q
from hfield.rings.residues.number_ideals import local_place
from hfield.rings.residues.prime_ideals import prime_at
from hfield.rings.residues.prime_numbers import PrimePlace
from hfield.rings.residues.prime_polynomials import AtInfinity, ResidueField

if TYPE_CHECKING:
    from hfield.rings.quadratic_places import QuadraticPlace
    from hfield.rings.residues.finite_places import FinitePlace


def p_adic_numbers(p: str) -> LocalField:
    """Return ℚ_p for the text of a prime p. Raises :class:`RingError`."""
    if not p.isdecimal() or not p.isascii():
        raise RingError(f"Qp({shorten(p)}): expected a prime number, as in Qp(5)")
    number = int(p)
    try:
        place = place_of_q(number)
    except RingError:
        shown = " * ".join(f"{q}^{n}" if n > 1 else f"{q}" for q, n in factorise(number).items())
        why = f"{number} = {shown} is not a prime" if number > 1 else f"{number} is not a prime"
        raise RingError(f"Qp({number}): {why}; expected one, as in Qp(5)") from None
    words = f"the {place}-adic numbers ℚ{str(place).translate(SUBSCRIPTS)}"
    return LocalField(f"Qp({place})", words, QQ, place, PrimePlace(number))


def completion_of_rationals(place: object) -> Ring:
    """Return ℚ_p, or RR: the real algebraic numbers satisfy what all real numbers satisfy."""
    v = place_of_q(place)
    return RR if v == INFINITE else p_adic_numbers(str(v))


def completion_of_functions(field: FunctionField, place: object) -> Ring:
    """Return the completion of GF(q)(t): Laurent series over the residue field."""
    v = place_of_functions(field, place)
    if field.base.order is None:
        raise RingError(
            f"the completion of {field} at {v} is no local field: its residue field is infinite"
        )
    k = blackboard(field.base.name)
    if v.poly is None:
        words = f"Laurent series in 1/{field.gen_name} over {k}"
        return LocalField(f"{field}_inf", words, field, v, AtInfinity(field))
    residues = ResidueField(field, v.poly)
    if v.poly == field.gen.num:
        name, words = f"{field.base}(({v}))", f"Laurent series in {v} over {k}"
    else:
        name = f"{field}_({v})"
        words = f"Laurent series in {v} over a field of {residues.order} elements"
    return LocalField(name, words, field, v, residues)


def completion_of_quadratic(field: QuadraticField, place: object) -> Ring:
    """Return the completion of ℚ(√d): an extension of ℚ_p, RR or CC; ℝ with a negative √d at ``inf-``."""
    v = place_of_quadratic(field.d, place)
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
