"""Zero norms over infinite fields, by their places; and where the norm is additive."""

from collections.abc import Callable

from hfield.errors import UndecidedError
from hfield.product import Constants
from hfield.rings.base import Ring
from hfield.structure.forms import NormalForm, normal_form
from hfield.structure.global_field import global_field
from hfield.structure.norm_forms.leading_terms import by_leading_terms
from hfield.structure.norm_forms.zero_norm_answer import ZeroNorm, found, none

Procedure = Callable[[Ring, Constants, NormalForm], ZeroNorm | None]


def by_places(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Decide by the ramified places; where there are none, solve the conic."""
    field = global_field(ring)
    if field is None:
        return by_leading_terms(ring, c, form)
    try:
        places = field.ramified(form)
    except UndecidedError:
        partial = field.ramified_at_small_places(form)
        if not partial:
            answer = by_leading_terms(ring, c, form)
            if answer is None:
                raise
            return answer
        return none(
            "ramified places",
            f"{field.why_ramified(form, partial)}, maybe elsewhere, too",
            partial,
            field.cited,
        )
    if places:
        return none("ramified places", field.why_ramified(form, places), places, field.cited)
    return field.unramified_zero(c, form)


def inseparable(ring: Ring, c: Constants) -> ZeroNorm:
    """Answer for characteristic 2 and t = 0, where the algebra is commutative and N is additive."""
    zero, one = ring.zero, ring.one
    a, _, b = c
    answer = by_leading_terms(ring, c, normal_form(ring, c))
    if answer is not None:
        return answer
    field = global_field(ring)
    if field is not None:
        # x = u² + g·v²: 1, a and b are dependent over the squares
        (u, v), (s, t) = field.square_parts(a), field.square_parts(b)
        q = (u, one, zero, zero) if ring.is_zero(v) else (u * t + s * v, t, v, zero)
        return found(ring, c, q, "squares", "1, a and b are linearly dependent over the squares")
    for square, unit in (
        (a, (one, zero, zero)),
        (b, (zero, one, zero)),
        (a * b, (zero, zero, one)),
    ):
        root = ring.sqrt(square)
        if root is not None:
            reason = f"{ring.text(square)} is a square in {ring.name}"
            return found(ring, c, (root, *unit), "square root", reason)
    raise UndecidedError(
        f"whether 1, a, b, ab are independent over the squares of {ring.name} is not decided"
    )


PROCEDURES: list[tuple[str, Procedure]] = [("ramified places", by_places)]
