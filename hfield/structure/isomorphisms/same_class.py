"""When two algebras in normal form have the same class: the same ramification, or more over ℚ(x)."""

import itertools
from typing import Any

from hfield.rings.base import Ring
from hfield.rings.functions import FunctionField
from hfield.structure.forms import NormalForm
from hfield.structure.function_fields.hilbert_functions import same_residues
from hfield.structure.ramification import ramification
from hfield.structure.rationals.hilbert_rationals import ramified_places_q
from hfield.structure.rationals.whole_numbers import fraction


def same_class(ring: Ring, form: NormalForm, other: NormalForm) -> bool | None:
    """Tell whether two nondegenerate algebras are isomorphic; None where there is no theory of places."""
    if isinstance(ring, FunctionField) and ring.base.order is None:
        return same_residues(ring, form, other) and _same_at_a_point(ring, form, other)
    places = ramification(ring, form)
    return None if places is None else places == ramification(ring, other)


def _same_at_a_point(ring: FunctionField, form: NormalForm, other: NormalForm) -> bool:
    """Compare two algebras over ℚ(x) that have the same residues at a point where both are unramified.

    Their difference in the Brauer group comes from ℚ (Faddeev), so its value at one point decides.
    """
    values = [*form.constants, *other.constants]
    for n in itertools.count():
        point = ring.base((n + 1) // 2 * (-1) ** n)
        if all(x.den(point) != 0 and x.num(point) != 0 for x in values):
            a, b, p, q = (fraction(_at(x, point)) for x in values)
            return ramified_places_q(a, b) == ramified_places_q(p, q)
    raise AssertionError("all but finitely many points are good")


def _at(x: Any, point: Any) -> Any:
    return x.num(point) / x.den(point)
