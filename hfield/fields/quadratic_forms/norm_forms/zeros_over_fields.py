"""Elements of norm 0 over fields: explicit over finite fields, otherwise by places or by squares."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.core.product import Constants, Coordinates
from hfield.errors import UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.quadratic_forms.global_field import global_field
from hfield.fields.quadratic_forms.norm_forms.leading_terms import by_leading_terms
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm, found, none
from hfield.fields.quadratic_forms.normal_forms import NormalForm, normal_form

if TYPE_CHECKING:
    pass


def zero_norm_finite(ring: Ring, c: Constants) -> Coordinates:
    """Return a nonzero element of norm 0 of a nondegenerate algebra over GF(q), in O(log q) steps.

    In even characteristic every element is a square and ``N(i + s·j) = −a − b·s²``. In odd
    characteristic a product of two non-squares is a square, and a non-square is a sum of two squares.
    """
    a, t, b = c
    zero, one = ring.zero, ring.one
    if ring.characteristic == 2:
        return zero, one, _root(ring, ring.divide(a, b)), zero
    half = ring.inverse(ring(2))
    shift = t * half
    a = a + shift * shift  # the square of i − t/2
    root = ring.sqrt(a)
    if root is not None:
        return root - shift, one, zero, zero
    root = ring.sqrt(b)
    if root is not None:
        return root, zero, one, zero
    # a and b are non-squares: b = a·s², and 1/a = x² + y² gives a·(a·x)² + b·(a·y/s)² = a²
    s = _root(ring, ring.divide(b, a))
    target = ring.inverse(a)
    for x in ring.elements():
        y = ring.sqrt(target - x * x)
        if y is not None:
            u, v = a * x, ring.divide(a * y, s)
            return a - shift * u, u, v, zero
    raise UndecidedError(
        f"{ring.name} has a non-square that is not a sum of two squares: not a field?"
    )


def _root(ring: Ring, x: object) -> object:
    root = ring.sqrt(x)
    if root is None:
        raise UndecidedError(
            f"{ring.name} gave no square root of {ring.text(x)}, which must have one"
        )
    return root


def by_places(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Decide by the ramified places; if there are none, solve the conic."""
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
