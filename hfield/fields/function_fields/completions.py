"""The completions of fields of rational functions: Laurent series."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.checker.glossary import reads_like_a_constant
from hfield.errors import RingError
from hfield.fields.base.printing import blackboard
from hfield.fields.function_fields.places import place_of_functions
from hfield.fields.function_fields.residues import residues_at
from hfield.fields.local.field import LocalField

if TYPE_CHECKING:
    from hfield.fields.function_fields.ring import FunctionField


def completion_of_functions(field: FunctionField, place: object) -> LocalField:
    """Return the completion of GF(q)(t): Laurent series over the residue field."""
    v = place_of_functions(field, place)
    if field.base.order is None:
        raise RingError(
            f"the completion of {field} at {v} is not a local field: its residue field is infinite"
        )
    k, residues = blackboard(field.base.name), residues_at(v)
    if v.poly is None:
        name, words = f"{field}_inf", f"Laurent series in 1/{field.gen_name} over {k}"
    elif v.poly == field.gen.num and not reads_like_a_constant(str(v)):
        name, words = f"{field.base}(({v}))", f"Laurent series in {v} over {k}"
    else:
        name = f"{field}_({v})"
        words = f"Laurent series in {v} over a field of {residues.order} elements"
    return LocalField(name, words, field, v, residues)
