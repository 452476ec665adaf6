"""Zero norms over the infinite fields that have a theory of places: ℚ, ℚ(√d), k(t)."""

from collections.abc import Callable
from typing import Any

from hfield.errors import UndecidedError
from hfield.product import Constants
from hfield.rings.base import Ring
from hfield.rings.functions import FunctionField
from hfield.rings.quadratic import QuadraticField
from hfield.structure.bundle import RamifiedError, solve_conic_functions
from hfield.structure.conic import solve_conic
from hfield.structure.evidence import ZeroNorm, found, none
from hfield.structure.forms import NormalForm
from hfield.structure.places import pair, ramification
from hfield.structure.quadratic_split import zero_divisor_quadratic

Procedure = Callable[[Ring, Constants, NormalForm], ZeroNorm | None]
_CONIC = "ramified nowhere, so the conic has a point (Hasse and Minkowski), and this is one"


def by_places(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Decide by the ramified places; where there are none, solve the conic."""
    places = ramification(ring, form)
    if places is None:
        return None
    if places:
        shown = ", ".join(map(str, places))
        reason = (
            f"the algebra is ramified at the places {shown}, so it has no zero divisor even locally"
        )
        return none(
            "ramified places",
            reason,
            places,
            "Hilbert symbols at the places (Voight, Quaternion Algebras, chapter 12)",
        )
    if isinstance(ring, FunctionField):
        return _functions(ring, c)
    if isinstance(ring, QuadraticField):
        a, b = (pair(ring, x) for x in form.constants)
        w, x, y, z = (ring(u) + ring(v) * ring.gen for u, v in zero_divisor_quadratic(ring.d, a, b))
        return found(ring, c, form.back((w, x, y, z)), "conic", _CONIC)
    x, y, z = (ring(u) for u in solve_conic(form.a, form.b))
    return found(ring, c, form.back((z, x, y, ring.zero)), "conic", _CONIC)


def _functions(ring: FunctionField, c: Constants) -> ZeroNorm:
    try:
        w, x, y = solve_conic_functions(ring, c)
    except RamifiedError as error:
        shown = ", ".join(map(str, error.place))
        reason = (
            "all residues are trivial, so the algebra comes from one over QQ, its value at a point of "
            f"the line, and that one is ramified at {shown}"
        )
        return none("specialisation", reason, error.place, "Faddeev's exact sequence")
    return found(
        ring, c, (w, x, y, ring.zero), "conic", "no place is ramified, and this is a zero divisor"
    )


def inseparable(ring: Ring, c: Constants) -> ZeroNorm:
    """Answer for characteristic 2 and t = 0, where the algebra is commutative and N is additive."""
    zero, one = ring.zero, ring.one
    a, _, b = c
    if isinstance(ring, FunctionField):
        # x = u² + g·v², g the variable: 1, a and b are dependent over the squares
        (u, v), (s, t) = _square_parts(ring, a), _square_parts(ring, b)
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


def _square_parts(ring: FunctionField, x: Any) -> tuple[Any, Any]:
    """Return ``(u, v)`` with ``x = u² + g·v²``, g the variable, over a finite field of characteristic 2."""
    whole = x.num * x.den
    parts = []
    for start in (0, 1):
        root = ring.zero
        for n in range(start, int(whole.degree()) + 1, 2):
            c = ring.constant(ring.base.sqrt(ring.base(whole[n])))
            root = root + c * ring.power(ring.gen, n // 2)
        parts.append(ring.divide(root, ring.quotient(x.den, ring.one.num)))
    return parts[0], parts[1]


PROCEDURES: list[tuple[str, Procedure]] = [("ramified places", by_places)]
