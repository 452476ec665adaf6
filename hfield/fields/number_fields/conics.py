"""Points on conics ``a·x² + b·y² = z²`` over number fields, searched within a bound.

The form ``z² − a·x² − b·y²`` is put on a module where it is good at every prime ideal, a lattice of rank 3n
in which :mod:`~hfield.fields.number_fields.walk` looks for zeros, as over quadratic fields
(:mod:`hfield.fields.number_fields.quadratic.conics`).
"""

from __future__ import annotations

from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.good_module import good_module
from hfield.fields.number_fields.integral_basis import integral_multiple
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import candidates
from hfield.fields.number_fields.walk import Walk, expect_small_degree, not_met


def solve_conic_number_field(
    field: NumberField, a: FieldElement, b: FieldElement
) -> tuple[FieldElement, FieldElement, FieldElement]:
    """Return ``(x, y, z)``, not all 0, with ``a·x² + b·y² = z²``, for nonzero a and b.

    The conic must have a point, that is, ``(a, b | K)`` must ramify nowhere. Raises
    :class:`UndecidedError` where none was met, and where a norm or the discriminant is too hard to factor.
    """
    none = f"a conic over {field.name} has points, but none"
    expect_small_degree(field, none)
    primes = sorted({2} | candidates(field, a) | candidates(field, b))
    r, s = (integral_multiple(x) for x in (a, b))
    form = [field.one, -a * (r * r), -b * (s * s)]
    walk = Walk(field, form, good_module(field, form, primes))
    for z, x, y in walk.zeros():
        return x * r, y * s, z
    raise not_met(none)
