"""Fields y² + y = m inside a division algebra [a, b) over k(t), k finite of characteristic 2.

An element w + i + y·j + z·k of trace 1 has the norm w² + w + a + s, s = b·N(y + z·i). So s is sought for
which the conic w² + wx + (a + m)·x² = s·z² has a point: for which [a + m, s) is nowhere ramified.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import TYPE_CHECKING, Any

from hfield.errors import UndecidedError, shorten
from hfield.fields.function_fields.conics import artin_schreier, solve_conic_functions
from hfield.fields.function_fields.symbols import ramified_places_functions
from hfield.product import Constants, Coordinates, norm
from hfield.structure.forms import NormalForm, normal_form

if TYPE_CHECKING:
    from hfield.fields.function_fields.quotients import Quotient
    from hfield.fields.function_fields.residues import ResidueField
    from hfield.fields.function_fields.ring import FunctionField

TRIALS = 3_000


def has_solution_at(at: ResidueField, m: Quotient) -> bool:
    """Tell whether y² + y = m has a solution in the completion: poles go, one by one, by squares there."""
    while m.num != 0 and (order := at.valuation(m)) <= 0:
        lead = at.reduce(m * at.uniformiser**-order)
        if order == 0:
            return at.artin_schreier(lead) is not None
        root = at.sqrt(lead)
        if order % 2:
            return False
        assert root is not None, "the residue field is perfect"
        y = at.lift(root) * at.inverse_uniformiser ** (-order // 2)
        m = m + y * y + y
    return True


def of_trace_one(field: FunctionField, form: NormalForm, m: Quotient) -> Coordinates:
    """Return x in the basis of the division algebra [a, b) with x² + x = m, where no place forbids it."""
    a, b = form.constants
    algebra, rest = Constants(a, field.one, b), a + m
    y = artin_schreier(field, rest)
    if y is not None:
        return y, field.one, field.zero, field.zero
    for y, z in _pairs(field):
        s = b * norm(algebra, (y, z, field.zero, field.zero))
        conic = Constants(rest, field.one, s)
        if ramified_places_functions(field, normal_form(field, conic)):
            continue
        w, x, r = solve_conic_functions(field, conic)
        if x.num != 0:
            scale = field.inverse(x)
            return scale * w, field.one, scale * r * y, scale * r * z
    raise UndecidedError(
        f"x² + x = {shorten(field.text(m))} has a solution in an algebra over {field}, but none was found"
    )


def _pairs(field: FunctionField) -> Iterator[tuple[Any, Any]]:
    """Run through pairs of polynomials, not both 0, at random and of growing degree."""
    rng, t = Random(1), field.gen

    def polynomial(size: int) -> Any:
        total = field.zero
        for _ in range(size):
            total = total * t + field.constant(field.base.random(rng))
        return total

    yield field.one, field.zero
    for n in range(TRIALS):
        pair = polynomial(1 + n // 100), polynomial(1 + n // 100)
        if any(p.num != 0 for p in pair):
            yield pair
