"""Nonzero elements of norm 0, which decide about division algebras, splitting and zero divisors.

Every answer is evidence: an element verified by multiplication, or a proof with its reason. The procedures
are tried in order of cost, and the first that applies decides.
"""

import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping

from hfield.checker.anisotropy import is_certified
from hfield.core.product import Constants, Coordinates, norm
from hfield.errors import UndecidedError
from hfield.fields.base.ring import INFINITY, Ring
from hfield.fields.quadratic_forms.global_field import global_field
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm, found, none
from hfield.fields.quadratic_forms.norm_forms.zeros_over_fields import (
    by_places,
    inseparable,
    zero_norm_finite,
)
from hfield.fields.quadratic_forms.norm_forms.zeros_over_rings import zero_norm_integral
from hfield.fields.quadratic_forms.normal_forms import (
    NormalForm,
    discriminant,
    normal_form,
    root_if_known,
)

Evidence = Mapping[str, object]
Procedure = Callable[[Ring, Constants, NormalForm], ZeroNorm | None]


def zero_norm(ring: Ring, c: Constants) -> ZeroNorm:
    """Return a nonzero element of norm 0, or the proof that there is none.

    Raises :class:`UndecidedError`, with the procedures tried, if none applies, and over inexact rings, over
    which nothing is ever proved.
    """
    if not ring.is_exact:
        raise UndecidedError(
            f"{ring.name} is inexact, so a norm is never known to be 0: use {ring.exact_ring} or over QQ"
        )
    element = _small(ring, c)
    if element is not None:
        return found(
            ring, c, element, "search", "found among the elements with coordinates 0, 1, −1"
        )
    if not ring.is_field:
        return zero_norm_integral(ring, c, zero_norm)
    degenerate = _is_degenerate(ring, c)
    if degenerate:
        return _degenerate(ring, c)
    if ring.order is not None:
        reason = "over a finite field the norm form of every quaternion algebra is isotropic"
        return found(ring, c, _scaled(ring, zero_norm_finite(ring, c)), "finite field", reason)
    form = normal_form(ring, c)
    if degenerate is None:
        answer = _squares(ring, c, form)
        if answer is not None:
            return answer
        ring.is_zero(discriminant(ring, c))  # raises the error that names the missing digits
    tried = ["elements with coordinates 0, 1, −1"]
    for name, procedure in _PROCEDURES:
        answer = procedure(ring, c, form)
        if answer is not None:
            return answer
        tried.append(name)
    raise UndecidedError(
        f"whether the norm form over {ring.name} has a nontrivial zero is not decided; tried: "
        + "; ".join(tried)
    )


def is_division(ring: Ring, c: Constants) -> bool:
    """Return whether the algebra is a division algebra, that is, whether every nonzero q has an inverse.

    Over a ring that is not a field no algebra is one: a scalar without inverse has no inverse in the algebra
    either. Raises :class:`UndecidedError` as :func:`zero_norm` does.
    """
    if not ring.is_exact:
        raise UndecidedError(
            f"{ring.name} is inexact, so division is not decided: use {ring.exact_ring}"
        )
    if ring.is_field is None:
        raise UndecidedError(f"{ring.no_field}: division algebras are defined over fields only")
    if not ring.is_field:
        return False
    if ring.order is None and _is_degenerate(ring, c) is False:
        field = global_field(ring)
        try:
            places = None if field is None else field.ramified(normal_form(ring, c))
        except UndecidedError:  # a factorisation out of reach: there may be a cheaper reason
            places = None
        if places or (places is not None and field is not None and field.splits_if_unramified):
            return bool(places)
    return not zero_norm(ring, c)


def _small(ring: Ring, c: Constants) -> Coordinates | None:
    """Return an element of norm 0 with few nonzero coordinates, each 0 or ±1, the first nonzero one 1; or
    None.
    """
    if ring.closure is not None:  # there zero tests are slow and square roots decide at once
        return None
    for q in _candidates(ring):
        try:
            if ring.is_zero(norm(c, q)):
                return q
        except UndecidedError:  # too few digits of the constants are known
            continue
    return None


def _candidates(ring: Ring) -> Iterator[Coordinates]:
    units = (ring.one,) if ring.characteristic == 2 else (ring.one, ring.zero - ring.one)
    for size in range(1, 5):
        for support in itertools.combinations(range(4), size):
            for signs in itertools.product(units, repeat=size - 1):
                q = [ring.zero] * 4
                for index, value in zip(support, (ring.one, *signs), strict=True):
                    q[index] = value
                w, x, y, z = q
                yield w, x, y, z


def _scaled(ring: Ring, q: Coordinates) -> Coordinates:
    """Scale an element over a field so that its first nonzero coordinate is 1."""
    scale = ring.inverse(next(u for u in q if not ring.is_zero(u)))
    w, x, y, z = (scale * u for u in q)
    return w, x, y, z


def _is_degenerate(ring: Ring, c: Constants) -> bool | None:
    """Return whether ``(t² + 4a)·b = 0`` in a field; None if too few digits of the constants are known."""
    try:
        return ring.is_zero(discriminant(ring, c))
    except UndecidedError:
        return None


def _degenerate(ring: Ring, c: Constants) -> ZeroNorm:
    """Decide for an algebra over a field whose norm form is degenerate: (t² + 4a)·b = 0."""
    _, t, b = c
    zero, one = ring.zero, ring.one
    if ring.is_zero(b):
        return found(ring, c, (zero, zero, one, zero), "degenerate", "b = 0, so N(j) = −b = 0")
    if ring.characteristic != 2:
        q = (zero - t, ring(2), zero, zero)
        return found(ring, c, q, "degenerate", "t² + 4a = 0, so N(2i − t) = 0")
    # N = w² + a·x² + b·y² + ab·z²: additive, and 0 somewhere iff 1, a, b, ab depend over F²
    return inseparable(ring, c)


def _squares(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Use a square root of i², j² or k² of the normal form: if r² = i², then r + i is a zero divisor."""
    if form.kind != "symbol":
        return None
    zero, one = ring.zero, ring.one
    a, b = form.constants
    for square, unit, name in (
        (a, (one, zero, zero), "a"),
        (b, (zero, one, zero), "b"),
        (zero - a * b, (zero, zero, one), "−ab"),
    ):
        root = root_if_known(ring, square)
        if root is not None:
            reason = f"{name} = {ring.text(square)} is a square in {ring.name}"
            return found(ring, c, form.back((root, *unit)), "square root", reason)
    return None


def _ordering(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Search for an ordering in which a and b are negative, so that N is positive definite."""
    if form.kind != "symbol" or ring.characteristic:
        return None
    count = ring.orderings.value
    if count == 0:
        return None
    indices = range(int(count)) if count not in (None, INFINITY) and count < 64 else range(1)
    for index in indices:
        try:
            if all(ring.sign(x, index) < 0 for x in form.constants):
                shown = " and ".join(ring.text(x) for x in form.constants)
                reason = (
                    f"{shown} are negative in an ordering of {ring.name}, in which the norm is therefore "
                    "positive for every element but 0"
                )
                return none("ordering", reason)
        except UndecidedError:
            return None
    return None


def _hamilton(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Decide H(F) by the level, that is, by whether −1 = u² + v²."""
    if form.kind != "symbol" or not all(ring.key(x) == ring.key(ring(-1)) for x in form.constants):
        return None
    level = ring.level
    if level.value is None:
        return None
    if level.value > 2:
        reason = f"−1 is not a sum of two squares: the level of {ring.name} is {level}"
        return none("level", reason)
    squares = (*ring.minus_one_as_squares(), ring.zero, ring.zero)
    if len(squares) < 3:
        return None
    u, v = squares[:2]
    reason = f"−1 = ({ring.text(u)})² + ({ring.text(v)})²"
    return found(ring, c, form.back((ring.one, u, v, ring.zero)), "squares", reason)


_PROCEDURES: list[tuple[str, Procedure]] = [
    ("square roots of a, b and −ab", _squares),
    ("orderings", _ordering),
    ("the level of the field", _hamilton),
    ("ramified places", by_places),
]


# --- why there is none, as evidence that the checker of certificates accepts -------------------------


def norm_evidence(algebra: str, ring: Ring, c: Constants, answer: ZeroNorm) -> Evidence | None:
    """Return the evidence for the answer that there is no element; None if no checkable evidence is
    available.
    """
    by = ({"by": answer.method},) if answer.method in ("ordering", "level") else ()
    candidates: Iterable[Evidence] = itertools.chain(by, evidence_at(ring, c, answer.places))
    return next((data for data in candidates if is_certified(algebra, ring.data, data)), None)


def evidence_at(ring: Ring, c: Constants, places: Iterable[object]) -> Iterator[Evidence]:
    """Yield the evidence at those places at which the algebra is ramified and the residue field is finite."""
    field = global_field(ring)
    return iter(()) if field is None else field.evidence(c, places)
